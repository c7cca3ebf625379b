#include "src/results/verify/geometry/balance.hpp"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace rubicon::verify {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Shares of the heaviest weight: what is added to each row so that no two pivots are alike, and
/// what may be left over.
constexpr double kShift = 1e-8;
constexpr double kLeft = 1e-6;
constexpr double kPivot = 1e-9;
/// m: the least size of a body.
constexpr double kLeastSize = 0.05;

/// An unknown that is not negative: what it adds to the rows of equilibrium, six of each body.
using Column = std::vector<std::pair<Index, double>>;

class Programme {
 public:
  explicit Programme(Index rows) : b_(VectorXd::Zero(rows)) {}

  void add(Column column) { columns_.push_back(std::move(column)); }
  void set_weight(Index row, double weight) { b_[row] = weight; }

  Balance solve() {
    const Index rows = b_.size();
    for (Index i = 0; i < rows; ++i) {
      // Numbers without a pattern: the fractions of multiples of the golden section.
      const double fraction = std::fmod(0.6180339887498949 * static_cast<double>(i + 1), 1);
      b_[i] += kShift * (1 + fraction);
    }
    basis_.assign(static_cast<std::size_t>(rows), -1);
    inverse_ = Eigen::MatrixXd::Identity(rows, rows);
    value_ = b_;
    double best = value_.sum();
    Index idle = 0;
    for (Index turn = 0; turn < 60 * rows + 2000; ++turn) {
      if (turn % 150 == 149) refresh();
      VectorXd price = VectorXd::Zero(rows);
      double left = 0;
      for (Index i = 0; i < rows; ++i) {
        if (basis_[static_cast<std::size_t>(i)] >= 0) continue;
        price += inverse_.row(i).transpose();
        left += value_[i];
      }
      if (left <= kLeft + 2 * kShift * static_cast<double>(rows)) return Balance::holds;
      idle = left < best - 1e-12 ? 0 : idle + 1;
      best = std::min(best, left);
      const Index entering = entering_column(price, idle > 2 * rows);
      if (entering < 0) return Balance::fails;
      if (!exchange(entering)) return Balance::not_known;
    }
    return Balance::not_known;
  }

 private:
  /// The one that helps most, or the first that helps (Bland 1977); -1: none.
  Index entering_column(const VectorXd& price, bool first) const {
    Index found = -1;
    double most = kPivot;
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      double gain = 0;
      for (const auto& [row, value] : columns_[j]) gain += price[row] * value;
      if (gain <= most) continue;
      most = gain;
      found = static_cast<Index>(j);
      if (first) break;
    }
    return found;
  }

  bool exchange(Index entering) {
    VectorXd way = VectorXd::Zero(b_.size());
    for (const auto& [row, value] : columns_[static_cast<std::size_t>(entering)]) {
      way += value * inverse_.col(row);
    }
    Index leaving = -1;
    double least = 0;
    for (Index i = 0; i < way.size(); ++i) {
      if (way[i] <= kPivot) continue;
      const double ratio = std::max(value_[i], 0.0) / way[i];
      const bool better =
          leaving < 0 || ratio < least - 1e-14 || (ratio <= least && way[i] > way[leaving]);
      if (!better) continue;
      leaving = i;
      least = ratio;
    }
    if (leaving < 0) return false;
    const Eigen::RowVectorXd pivot = inverse_.row(leaving) / way[leaving];
    value_ -= least * way;
    value_[leaving] = least;
    way[leaving] = 0;
    inverse_.row(leaving) = pivot;
    inverse_.noalias() -= way * pivot;
    basis_[static_cast<std::size_t>(leaving)] = entering;
    return true;
  }

  /// Takes away the rounding of many exchanges.
  void refresh() {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(b_.size(), b_.size());
    for (Index i = 0; i < b_.size(); ++i) {
      const Index column = basis_[static_cast<std::size_t>(i)];
      if (column < 0) {
        matrix(i, i) = 1;
        continue;
      }
      for (const auto& [row, value] : columns_[static_cast<std::size_t>(column)]) {
        matrix(row, i) += value;
      }
    }
    inverse_ = matrix.partialPivLu().inverse();
    value_ = inverse_ * b_;
  }

  VectorXd b_;
  std::vector<Column> columns_;
  std::vector<Index> basis_;  ///< column of each row; -1: what is left over there
  Eigen::MatrixXd inverse_;
  VectorXd value_;
};

}  // namespace

Balance balance_of(const std::vector<BalancedBody>& bodies, const std::vector<BalancePoint>& points,
                   const std::vector<BalanceJoint>& joints, double friction) {
  if (bodies.size() > kMostBodies) return Balance::not_known;
  double heaviest = 0;
  std::vector<double> sizes(bodies.size(), kLeastSize);
  for (const BalancedBody& body : bodies) heaviest = std::max(heaviest, body.mass);
  if (!(heaviest > 0)) return Balance::holds;
  for (const BalancePoint& each : points) {
    for (const int body : {each.upper, each.lower}) {
      if (body < 0) continue;
      const auto i = static_cast<std::size_t>(body);
      sizes[i] = std::max(sizes[i], (each.at.point - bodies[i].centre).norm());
    }
  }
  Programme programme(static_cast<Index>(6 * bodies.size()));
  const auto add_wrench = [&](Column& column, int body, const Vec3& force, const Vec3& moment) {
    const double size = sizes[static_cast<std::size_t>(body)];
    for (Index axis = 0; axis < 3; ++axis) {
      if (force[axis] != 0) column.emplace_back(Index{6} * body + axis, force[axis]);
      if (moment[axis] != 0) column.emplace_back(Index{6} * body + 3 + axis, moment[axis] / size);
    }
  };
  const auto add_force = [&](Column& column, int body, const Vec3& force, const Vec3& at) {
    const Vec3& centre = bodies[static_cast<std::size_t>(body)].centre;
    add_wrench(column, body, force, Vec3((at - centre).cross(force)));
  };
  for (const BalancePoint& each : points) {
    const Vec3 one = each.at.normal.unitOrthogonal();
    const Vec3 other = each.at.normal.cross(one);
    for (const double sign : {-1.0, 1.0}) {
      // Edges of the pyramid that has the cone inside: no result is called wrong for its direction.
      for (const Vec3& along : {Vec3(one + sign * other), Vec3(-one + sign * other)}) {
        const Vec3 force = each.at.normal + friction * along;
        Column column;
        add_force(column, each.upper, force, each.at.point);
        if (each.lower >= 0) add_force(column, each.lower, -force, each.at.point);
        programme.add(std::move(column));
      }
    }
  }
  for (const double sign : {-1.0, 1.0}) {
    for (Index axis = 0; axis < 3; ++axis) {
      const Vec3 along = sign * Vec3::Unit(axis);
      for (const BalanceJoint& joint : joints) {
        const Vec3& at = bodies[static_cast<std::size_t>(joint.first)].centre;
        Column force, moment;
        add_force(force, joint.first, along, at);
        add_wrench(moment, joint.first, Vec3::Zero(), along);
        if (joint.second >= 0) {
          add_force(force, joint.second, -along, at);
          add_wrench(moment, joint.second, Vec3::Zero(), -along);
        }
        programme.add(std::move(force));
        programme.add(std::move(moment));
      }
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (!bodies[i].braced) continue;
        Column force, moment;
        if (axis < 2) add_wrench(force, static_cast<int>(i), along, Vec3::Zero());
        add_wrench(moment, static_cast<int>(i), Vec3::Zero(), along);
        programme.add(std::move(force));
        programme.add(std::move(moment));
      }
    }
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    programme.set_weight(static_cast<Index>(6 * i + 2), bodies[i].mass / heaviest);
  }
  return programme.solve();
}

}  // namespace rubicon::verify
