#pragma once

#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "src/earth/soil/bucket.hpp"

namespace rubicon::soil {

/// m, from the machine: a cut may begin however far away.
inline constexpr double kAnywhere = std::numeric_limits<double>::infinity();

/// How a machine digs a pit from one place: in layers from above, in each of them from far to near.
/// Its bucket goes down, is drawn towards the machine at the bottom of the layer, and goes up, held
/// the same way to the heading frame {H}: from the machine to the tool, level, is x, up is z.
struct BiteRules {
  math::Vec3 p_EM = math::Vec3::Zero();      ///< where the machine stands
  math::Mat3 R_HT = math::Mat3::Identity();  ///< how the tool is held
  std::vector<BucketBox> boxes;              ///< of the bucket, in the tool's frame {T}
  Millimetres layer = 500;
  Millimetres tolerance = 100;
  double clearance = 0.5;  ///< m
  CubicMillimetres room = 0;
  Millimetres top = 0;             ///< layers are counted from here
  Millimetres rim = -kMostHeight;  ///< the bucket goes up over this, the ground round the pit
  double before = kAnywhere;       ///< m, from the machine: cuts begin nearer than that
  double spread = 0;               ///< m: what lies so near beside the bucket comes away, too
};

/// m: the bucket keeps so far from ground that is not dug, below and beside it. Less than the
/// tolerance of any dig, and more than a tool on a straight way is ever beside it.
inline constexpr double kGroundGap = 0.02;

/// m: soil that no cut can reach, because ground that stays is in the way, comes away last in its
/// layer, with a bucket that passes so near. Corners, mostly, of pits that are not in line with the
/// machine.
inline constexpr double kTrimmed = 0.5;

/// One cut: where the tool goes down and up, by its distance from the machine along the heading.
struct Bite {
  int cell = 0;  ///< for whose sake
  double heading_deg = 0;
  double far = 0, near = 0;  ///< m
  double low = 0, high = 0;  ///< m: heights of the tool in {E} while it cuts, and clear of the soil
  CubicMillimetres expected = 0;

  /// Where the tool is.
  math::Pose X_ET(const BiteRules& rules, double distance, double height) const;
};

/// What is to be dug next: the cell that is farthest from the machine, of several the first, in the
/// highest layer that is not done.
struct DigTarget {
  int cell = 0;
  Millimetres floor = 0;  ///< down to which it is to be dug now
  bool is_last = false;   ///< only cells that were put off are left of the layer
};
/// `cells`: of the pit; `put_off`: of these, those that come last in their layer. Nothing: all is
/// dug.
std::optional<DigTarget> next_target(const Terrain& now, const Terrain& bottom,
                                     const std::vector<int>& cells, const std::set<int>& put_off,
                                     const BiteRules& rules);

/// The cuts that reach the target and meet no ground that stays, the one that takes most first, of
/// several the one most straight at the cell, then that to the left. Empty: the bucket does not fit
/// in there.
std::vector<Bite> bites_for(const Terrain& now, const Terrain& bottom, const DigTarget& target,
                            const BiteRules& rules);

/// The middle of a cell, at a height.
math::Vec3 place_of_cell(const Terrain& terrain, int cell, Millimetres height);

}  // namespace rubicon::soil
