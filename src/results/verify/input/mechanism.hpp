#pragma once

#include <span>
#include <vector>

#include "src/results/verify/input/scene.hpp"

namespace rubicon::verify {

/// How far points may be from where they are at the middle of an interval: along a unit direction n
/// of the world at most |n| . spread + rest (m).
struct Reach {
  Vec3 spread = Vec3::Zero();  ///< of moves whose direction stands still, by world axis
  double rest = 0;             ///< in any direction

  double along(const Vec3& n) const { return n.cwiseAbs().dot(spread) + rest; }
  double most() const { return spread.norm() + rest; }
  Reach operator+(const Reach& other) const { return {spread + other.spread, rest + other.rest}; }
};

/// Where the frames of a robot are at the middle of an interval of its values, and what of them
/// moves within it. Frames are numbered as the bodies; after the last comes the tool frame {T}.
struct MechanismState {
  /// An elementary transform that changes, and the most it changes to either side.
  struct Change {
    int frame = 0;
    FrameElement::Kind kind = FrameElement::Kind::trans;
    Pose X_WE = Pose::Identity();  ///< the frame before it, at the middle
    Vec3 half = Vec3::Zero();      ///< m of a move; radians in the first place of a turn
  };
  std::vector<Pose> X_WB;
  std::vector<Change> changes;
};

/// Forward kinematics of a robot of the trace's header, from the texts of its frames.
class Mechanism {
 public:
  explicit Mechanism(const SceneRobot& robot);

  int tool() const { return static_cast<int>(parents_.size()) - 1; }

  /// At the values q.
  Pose pose(int frame, std::span<const double> q) const;

  /// While every value runs from `from` to `to` in any way.
  MechanismState state(std::span<const double> from, std::span<const double> to) const;

  /// The deepest frame that both stand on (or are), -1: only the mounting.
  int common_frame(int a, int b) const;

  /// How far points within `radius` of `centre_W` that are fixed to `frame` may be from where they
  /// are at the middle, seen from `base` (a frame that `frame` stands on, -1: the world).
  /// Changing the elements of a chain one after the other, each moves a point by at most its own
  /// change times the point's radius at the middle; these add up.
  Reach reach(const MechanismState& state, int frame, int base, const Vec3& centre_W,
              double radius) const;

 private:
  bool stands_on(int frame, int base) const;

  const SceneRobot* robot_;
  std::vector<int> parents_;
  std::vector<const std::vector<FrameElement>*> frames_;
};

}  // namespace rubicon::verify
