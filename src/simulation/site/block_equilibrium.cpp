#include "src/simulation/site/block_equilibrium.hpp"

#include <coin/Clp_C_Interface.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "src/simulation/site/resting.hpp"

namespace rubicon::site {

namespace {

using math::Vec3;

/// m: so far inside of the sides of its patch a corner carries, as for single components.
constexpr double kInset = 1e-3;
/// How often the way to the middle of a narrower patch is halved: to a millionth of a millimetre.
constexpr int kHalvings = 20;
/// What comes down with more than this share of the heaviest weight is no rounding. The programme
/// keeps its rows to a hundredth of it.
constexpr double kPower = 1e-7;
/// The least weight, as a share of the heaviest: a light part must not tip within the rounding.
constexpr double kLightest = 1e-4;
constexpr double kTolerance = 1e-9;
constexpr double kNothing = 1e-9;
/// An answer is believed if its certificate holds to so much: forces balance, a motion is free.
constexpr double kUnbalanced = 1e-6;
constexpr double kHindered = 1e-8;
/// Of the largest part of a motion: less is none.
constexpr double kStill = 1e-5;
/// The slope up to which a contact is level.
constexpr double kLevel = 1e-3;
constexpr int kMostIterations = 1'000'000;
/// m: the least size of a block.
constexpr double kLeastSize = 0.05;

/// Rows of a programme, row by row.
struct Rows {
  std::vector<CoinBigIndex> starts = {0};
  std::vector<int> columns;
  std::vector<double> values;
  std::vector<double> lower, upper;

  void add(int column, double value) {
    // What rounding leaves of nothing misleads the library: it answered 0 for a beam that turns.
    if (std::abs(value) < kNothing) return;
    columns.push_back(column);
    values.push_back(value);
  }
  void end(double least, double most) {
    starts.push_back(static_cast<CoinBigIndex>(columns.size()));
    lower.push_back(least);
    upper.push_back(most);
  }
};

/// The motion with the least cost that the rows allow, and the forces in the rows that prove it.
struct Optimum {
  std::vector<double> motion;
  std::vector<double> forces;
};

enum class Goal { most_power, fewest_parts };

/// minimise x * cost, each x between -limit and limit, the rows at least 0 (or 0); or, with the
/// limits as prices, minimise |x| * limit, x * cost at most -1. Nothing: not solved.
///
/// Solved as the dual programme, whose unknowns are the forces: it has six rows for each block, the
/// programme of the motion has 32 for each contact, and the time goes with the square of the rows.
std::optional<Optimum> minimum(const Rows& contacts, const std::vector<double>& cost,
                               const std::vector<double>& limit, Goal goal, bool by_primal) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::size_t forces = contacts.lower.size();
  // A row of the motion is a column of the forces.
  Rows programme = contacts;
  std::vector<double> price(forces, 0), least, most(forces, kInfinity);
  for (const double upper : contacts.upper) least.push_back(upper > 0 ? 0 : -kInfinity);
  std::vector<double> lower, upper;
  const auto add_column = [&](double column_price) {
    programme.starts.push_back(static_cast<CoinBigIndex>(programme.columns.size()));
    price.push_back(column_price);
    least.push_back(0);
    most.push_back(kInfinity);
  };
  if (goal == Goal::most_power) {
    // The weights are carried; what is not is the power of the motion.
    lower = upper = cost;
    for (std::size_t i = 0; i < cost.size(); ++i) {
      for (const double sign : {1.0, -1.0}) {
        programme.add(static_cast<int>(i), sign);
        add_column(limit[i]);
      }
    }
  } else {
    for (const double each : limit) {
      lower.push_back(each > 0 ? -each : -kInfinity);
      upper.push_back(each > 0 ? each : kInfinity);
    }
    for (std::size_t i = 0; i < cost.size(); ++i) programme.add(static_cast<int>(i), -cost[i]);
    add_column(-1);
  }
  const std::unique_ptr<Clp_Simplex, decltype(&Clp_deleteModel)> model(Clp_newModel(),
                                                                       &Clp_deleteModel);
  Clp_setLogLevel(model.get(), 0);
  Clp_loadProblem(model.get(), static_cast<int>(price.size()), static_cast<int>(cost.size()),
                  programme.starts.data(), programme.columns.data(), programme.values.data(),
                  least.data(), most.data(), price.data(), lower.data(), upper.data());
  Clp_setPrimalTolerance(model.get(), kTolerance);
  Clp_setDualTolerance(model.get(), kTolerance);
  Clp_setMaximumIterations(model.get(), kMostIterations);
  Clp_scaling(model.get(), 0);  // lengths and weights are shares already
  by_primal ? Clp_primal(model.get(), 0) : Clp_dual(model.get(), 0);
  if (Clp_status(model.get()) != 0) return std::nullopt;
  const double* const force = Clp_getColSolution(model.get());
  Optimum found;
  found.forces.assign(force, force + forces);
  const double* const shadow = Clp_getRowPrice(model.get());
  for (std::size_t i = 0; i < cost.size(); ++i) {
    found.motion.push_back(limit[i] > 0 ? -shadow[i] : 0);
  }
  return found;
}

class Collapse {
 public:
  Collapse(const std::vector<RigidBlock>& blocks, const std::vector<BlockContact>& contacts,
           const std::vector<BlockJoint>& joints, double friction)
      : blocks_(blocks), sizes_(blocks.size(), kLeastSize) {
    for (const RigidBlock& block : blocks) heaviest_ = std::max(heaviest_, block.mass);
    for (const BlockContact& contact : contacts) {
      for (const Vec3& corner : contact.corners) {
        grow(contact.upper, corner);
        if (contact.lower >= 0) grow(contact.lower, corner);
      }
    }
    for (const BlockContact& contact : contacts) add_contact(contact, friction);
    for (const BlockJoint& joint : joints) add_joint(joint);
  }

  std::optional<std::vector<BlockMotion>> find() const {
    std::vector<BlockMotion> none;
    if (!(heaviest_ > 0)) return none;
    std::vector<double> cost(unknowns(), 0);
    for (std::size_t i = 0; i < blocks_.size(); ++i) cost[6 * i + 2] = weight(i);
    std::vector<double> most(unknowns(), 1);
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      if (!blocks_[i].braced) continue;
      for (const std::size_t axis : {0, 1, 3, 4, 5}) most[6 * i + axis] = 0;
    }
    for (const bool by_primal : {false, true}) {
      const auto down = minimum(rows_, cost, most, Goal::most_power, by_primal);
      if (!down) continue;
      double power = 0;
      for (std::size_t i = 0; i < cost.size(); ++i) power -= cost[i] * down->motion[i];
      if (power <= kPower) {
        if (forces_balance(down->forces, cost, most)) return none;
      } else if (is_free(down->motion)) {
        return moving(with_fewest_parts(cost, most, power).value_or(down->motion));
      }
    }
    return std::nullopt;
  }

 private:
  std::size_t unknowns() const { return 6 * blocks_.size(); }
  /// Of the heaviest. What is lighter than kLightest is judged as if it were so heavy.
  double weight(std::size_t block) const {
    const double mass = blocks_[block].mass;
    return mass > 0 ? std::max(mass / heaviest_, kLightest) : 0;
  }

  void grow(int block, const Vec3& corner) {
    const auto i = static_cast<std::size_t>(block);
    sizes_[i] = std::max(sizes_[i], (corner - blocks_[i].centre).norm());
  }

  /// The speed of a block's point along a direction, as part of a row: its moves are unknowns, its
  /// turns as well, times its size.
  void add_speed(int block, const Vec3& point, const Vec3& direction, double factor) {
    const auto i = static_cast<std::size_t>(block);
    const Vec3 turn = (point - blocks_[i].centre).cross(direction) / sizes_[i];
    for (int axis = 0; axis < 3; ++axis) {
      rows_.add(6 * block + axis, factor * direction[axis]);
      rows_.add(6 * block + 3 + axis, factor * turn[axis]);
    }
  }

  /// The first edge of the pyramid of forces: down the slope, or along the longest side of a
  /// contact that is level. How the plan is turned has no part in that.
  static Vec3 first_direction(const BlockContact& contact) {
    const Vec3& normal = contact.normal;
    if (normal.head<2>().norm() > kLevel) {
      return Vec3(normal.x(), normal.y(), 0).cross(normal).cross(normal).normalized();
    }
    Vec3 longest = Vec3::Zero();
    for (std::size_t i = 0; i < contact.corners.size(); ++i) {
      const Vec3 side =
          contact.corners[i] - contact.corners[i == 0 ? contact.corners.size() - 1 : i - 1];
      const Vec3 along = side - side.dot(normal) * normal;
      if (along.norm() > longest.norm() + kNothing) longest = along;
    }
    return longest.norm() > 0 ? Vec3(longest.normalized()) : normal.unitOrthogonal();
  }

  /// Where a contact carries: inside of its sides. One that is narrower than twice that does so in
  /// its middle.
  static std::vector<Vec3> carrying_points(const BlockContact& contact, const Vec3& first,
                                           const Vec3& second) {
    const Vec3& origin = contact.corners.front();
    std::vector<Eigen::Vector2d> outline;
    for (const Vec3& corner : contact.corners) {
      outline.emplace_back((corner - origin).dot(first), (corner - origin).dot(second));
    }
    outline = convex_hull(std::move(outline));
    std::vector<Eigen::Vector2d> inner = inset(outline, kInset);
    double by = 0;
    double step = kInset / 2;
    for (int i = 0; inner.empty() && i < kHalvings; ++i, step /= 2) {
      if (!inset(outline, by + step).empty()) by += step;
    }
    if (inner.empty()) inner = by > 0 ? inset(outline, by) : outline;
    std::vector<Vec3> points;
    for (const Eigen::Vector2d& p : inner) {
      points.emplace_back(origin + p.x() * first + p.y() * second);
    }
    return points;
  }

  /// No motion against any of the eight edges of the pyramid of forces, which lie on the cone.
  void add_contact(const BlockContact& contact, double friction) {
    const Vec3 first = first_direction(contact);
    const Vec3 second = contact.normal.cross(first);
    const double half = std::sqrt(0.5);
    const std::array<Vec3, 8> edges = {
        first,  half * (first + second),  second,  half * (second - first),
        -first, -half * (first + second), -second, half * (first - second)};
    for (const Vec3& point : carrying_points(contact, first, second)) {
      for (const Vec3& along : edges) {
        const Vec3 force = contact.normal + friction * along;
        add_speed(contact.upper, point, force, 1);
        if (contact.lower >= 0) add_speed(contact.lower, point, force, -1);
        rows_.end(0, std::numeric_limits<double>::infinity());
        if (friction == 0) break;
      }
    }
  }

  /// The centre of the first moves with the second, and both turn alike.
  void add_joint(const BlockJoint& joint) {
    const auto first = static_cast<std::size_t>(joint.first);
    const Vec3& centre = blocks_[first].centre;
    for (int axis = 0; axis < 3; ++axis) {
      add_speed(joint.first, centre, Vec3::Unit(axis), 1);
      if (joint.second >= 0) add_speed(joint.second, centre, Vec3::Unit(axis), -1);
      rows_.end(0, 0);
      rows_.add(6 * joint.first + 3 + axis, 1);
      if (joint.second >= 0) {
        rows_.add(6 * joint.second + 3 + axis,
                  -sizes_[first] / sizes_[static_cast<std::size_t>(joint.second)]);
      }
      rows_.end(0, 0);
    }
  }

  /// Whether the forces along the edges of the pyramids carry all weights.
  bool forces_balance(const std::vector<double>& forces, const std::vector<double>& cost,
                      const std::vector<double>& bound) const {
    std::vector<double> left = cost;
    for (std::size_t row = 0; row < forces.size(); ++row) {
      const bool pushes_only = rows_.upper[row] > 0;
      const double force = pushes_only ? std::max(forces[row], 0.0) : forces[row];
      for (auto i = rows_.starts[row]; i < rows_.starts[row + 1]; ++i) {
        const auto entry = static_cast<std::size_t>(i);
        left[static_cast<std::size_t>(rows_.columns[entry])] -= force * rows_.values[entry];
      }
    }
    for (std::size_t i = 0; i < left.size(); ++i) {
      if (bound[i] > 0 && std::abs(left[i]) > kUnbalanced) return false;
    }
    return true;
  }

  /// Whether no contact and no joint forbids the motion.
  bool is_free(const std::vector<double>& motion) const {
    for (std::size_t row = 0; row < rows_.lower.size(); ++row) {
      double speed = 0;
      for (auto i = rows_.starts[row]; i < rows_.starts[row + 1]; ++i) {
        const auto entry = static_cast<std::size_t>(i);
        speed += rows_.values[entry] * motion[static_cast<std::size_t>(rows_.columns[entry])];
      }
      if (speed < -kHindered || speed > rows_.upper[row] + kHindered) return false;
    }
    return true;
  }

  /// Of the motions that come down as fast the one with the least sum of all parts.
  std::optional<std::vector<double>> with_fewest_parts(const std::vector<double>& cost,
                                                       const std::vector<double>& bound,
                                                       double power) const {
    std::vector<double> share = cost, price;
    for (double& each : share) each /= power;
    for (const double each : bound) price.push_back(each > 0 ? 1 : 0);
    const auto fewest = minimum(rows_, share, price, Goal::fewest_parts, false);
    if (!fewest || !is_free(fewest->motion)) return std::nullopt;
    return fewest->motion;
  }

  std::vector<BlockMotion> moving(const std::vector<double>& motion) const {
    double largest = 0;
    for (const double each : motion) largest = std::max(largest, std::abs(each));
    std::vector<BlockMotion> found;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      BlockMotion one{static_cast<int>(i), {}, {}, sizes_[i]};
      double most = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        one.move[static_cast<Eigen::Index>(axis)] = motion[6 * i + axis] / largest;
        one.turn[static_cast<Eigen::Index>(axis)] = motion[6 * i + 3 + axis] / sizes_[i] / largest;
        most = std::max({most, std::abs(motion[6 * i + axis]), std::abs(motion[6 * i + 3 + axis])});
      }
      if (most > kStill * largest) found.push_back(one);
    }
    return found;
  }

  const std::vector<RigidBlock>& blocks_;
  std::vector<double> sizes_;  ///< m
  double heaviest_ = 0;        ///< kg
  Rows rows_;
};

}  // namespace

std::optional<std::vector<BlockMotion>> find_collapse(const std::vector<RigidBlock>& blocks,
                                                      const std::vector<BlockContact>& contacts,
                                                      const std::vector<BlockJoint>& joints,
                                                      double friction) {
  return Collapse(blocks, contacts, joints, friction).find();
}

}  // namespace rubicon::site
