#pragma once

#include <map>
#include <optional>
#include <vector>

#include "src/earth/soil/terrain.hpp"
#include "src/motion/math/pose.hpp"

namespace rubicon::soil {

/// A part of a bucket: a box between two corners (m), placed in the frame of the bucket {B}.
struct BucketBox {
  math::Vec3 lower = math::Vec3::Zero();
  math::Vec3 upper = math::Vec3::Zero();
  math::Pose X_BS = math::Pose::Identity();
};

/// The lowest point of the box above or below (x, y), where it stands at X_EB; nothing: it is not
/// there.
std::optional<double> lowest_over(const BucketBox& box, const math::Pose& X_EB, double x, double y);

/// A cell has four such points, a quarter of its side from its edges: what is over one of them is
/// over the cell. What stands beside it is narrower than a cell, and falls.
inline constexpr double kQuarters[] = {0.25, 0.75};

/// What a bucket takes on its way, up to what it holds, of soil that lies above a bottom.
class BucketFill {
 public:
  /// `room`: bank volume that it holds; what is left of a cell no higher than `tolerance` above the
  /// bottom comes away with it, and so does what lies no farther than `spread` (m) beside it. Both
  /// terrains, of the same cells, must outlive it.
  BucketFill(const Terrain& now, const Terrain& bottom, std::vector<BucketBox> boxes,
             CubicMillimetres room, Millimetres tolerance, double spread = 0)
      : now_(now),
        bottom_(bottom),
        boxes_(std::move(boxes)),
        room_(room),
        tolerance_(tolerance),
        spread_(spread) {}

  /// The bucket is at X_EB: cells that it is over come down to its lowest point there, in the order
  /// of their numbers, as long as it has room; the last by as many whole mm as it has room for.
  void pass(const math::Pose& X_EB);

  CubicMillimetres volume() const { return volume_; }
  /// Not a mm of a cell more goes in.
  bool is_full() const { return room_ - volume_ < now_.cell * now_.cell; }
  /// Cells and their new heights.
  const std::map<int, Millimetres>& changes() const { return changes_; }

 private:
  void take(int cell, Millimetres to);
  Millimetres height(int cell) const;

  const Terrain& now_;
  const Terrain& bottom_;
  std::vector<BucketBox> boxes_;
  CubicMillimetres room_, volume_ = 0;
  Millimetres tolerance_;
  double spread_;
  std::map<int, Millimetres> changes_;
};

}  // namespace rubicon::soil
