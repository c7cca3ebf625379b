#include "src/earth/soil/bucket.hpp"

#include <algorithm>
#include <cmath>

namespace rubicon::soil {

namespace {

/// m: a height that is a whole number of mm may come out so much larger.
constexpr double kHeightRounding = 1e-9;

/// `lowest_over` of a box where {E} is so in its frame.
std::optional<double> lowest_in(const BucketBox& box, const math::Pose& X_SE, double x, double y) {
  const math::Vec3 p = X_SE * math::Vec3(x, y, 0);
  const math::Vec3 up = X_SE.linear().col(2);
  double least = -1e300;
  double most = 1e300;
  for (int i = 0; i < 3; ++i) {
    if (std::fabs(up[i]) < 1e-12) {
      if (p[i] < box.lower[i] || p[i] > box.upper[i]) return std::nullopt;
      continue;
    }
    const double a = (box.lower[i] - p[i]) / up[i];
    const double b = (box.upper[i] - p[i]) / up[i];
    least = std::max(least, std::min(a, b));
    most = std::min(most, std::max(a, b));
  }
  return least <= most ? std::optional(least) : std::nullopt;
}

/// The height of a cell below a bucket whose lowest point there is at `lowest` (m).
Millimetres down_to(double lowest) {
  return static_cast<Millimetres>(std::ceil((lowest - kHeightRounding) * 1e3));
}

}  // namespace

std::optional<double> lowest_over(const BucketBox& box, const math::Pose& X_EB, double x,
                                  double y) {
  return lowest_in(box, (X_EB * box.X_BS).inverse(Eigen::Isometry), x, y);
}

Millimetres BucketFill::height(int cell) const {
  const auto known = changes_.find(cell);
  return known == changes_.end() ? now_.heights[static_cast<std::size_t>(cell)] : known->second;
}

void BucketFill::take(int cell, Millimetres to) {
  const Millimetres height = this->height(cell);
  const Millimetres bottom = bottom_.heights[static_cast<std::size_t>(cell)];
  to = to <= bottom + tolerance_ ? bottom : to;
  const CubicMillimetres area = now_.cell * now_.cell;
  const Millimetres taken = std::min(height - to, (room_ - volume_) / area);
  if (taken <= 0) return;
  changes_[cell] = height - taken;
  volume_ += taken * area;
}

void BucketFill::pass(const math::Pose& X_EB) {
  if (is_full()) return;
  const double side = static_cast<double>(now_.cell) * 1e-3;
  Eigen::AlignedBox3d bounds;
  std::vector<math::Pose> X_SE;
  for (const BucketBox& box : boxes_) {
    X_SE.push_back((X_EB * box.X_BS).inverse(Eigen::Isometry));
    const Eigen::AlignedBox3d own(box.lower, box.upper);
    for (int corner = 0; corner < 8; ++corner) {
      bounds.extend(X_EB * box.X_BS *
                    own.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
    }
  }
  const auto first = [&](double from, int count) {
    return static_cast<int>(std::clamp(std::floor(from / side), 0.0, static_cast<double>(count)));
  };
  const auto end = [&](double to, int count) {
    return static_cast<int>(std::clamp(std::ceil(to / side), 0.0, static_cast<double>(count)));
  };
  Eigen::Vector2d middle = bounds.center().head<2>();
  // a point, or the one towards the bucket that is as far from it as soil comes away
  const auto beside = [&](double x, double y) -> Eigen::Vector2d {
    const Eigen::Vector2d p(x, y);
    const Eigen::Vector2d in = middle - p;
    const double distance = std::sqrt(in.x() * in.x() + in.y() * in.y());
    if (distance <= spread_) return middle;
    return p + in * (spread_ / distance);
  };
  // Nothing comes down lower than to here, but for what is left above the bottom.
  const Millimetres lowest_of_all = down_to(bounds.min().z());
  const int end_row = end(bounds.max().y() + spread_, now_.rows);
  const int end_column = end(bounds.max().x() + spread_, now_.columns);
  for (int row = first(bounds.min().y() - spread_, now_.rows); row < end_row; ++row) {
    for (int column = first(bounds.min().x() - spread_, now_.columns); column < end_column;
         ++column) {
      const auto cell = static_cast<int>(now_.index(column, row));
      const auto index = static_cast<std::size_t>(cell);
      if (now_.heights[index] <= bottom_.heights[index]) continue;
      if (lowest_of_all > bottom_.heights[index] + tolerance_ && height(cell) <= lowest_of_all) {
        continue;
      }
      std::optional<double> lowest;
      for (std::size_t i = 0; i < boxes_.size(); ++i) {
        for (const double u : kQuarters) {
          for (const double v : kQuarters) {
            const Eigen::Vector2d p = beside((column + u) * side, (row + v) * side);
            const auto low = lowest_in(boxes_[i], X_SE[i], p.x(), p.y());
            if (low && (!lowest || *low < *lowest)) lowest = low;
          }
        }
      }
      if (!lowest) continue;
      take(cell, down_to(*lowest));
    }
  }
}

}  // namespace rubicon::soil
