#pragma once

#include <optional>
#include <span>
#include <vector>

#include "src/motion/math/lanes.hpp"
#include "src/motion/robot/chain_bound.hpp"
#include "src/motion/robot/kinematics.hpp"

namespace rubicon::robot {

/// The frames of all bodies and of the tool of a robot on a leg, along which its parameters run
/// linearly: at four shares of the leg at once, with their velocities, and bounds of the
/// accelerations of what they carry. What does not depend on the leg is worked out once.
class LegFrames {
 public:
  LegFrames(const RobotModel& model, const Mounting& mounting);

  /// Frames are numbered as the bodies are; that of the tool comes last.
  int tool_frame() const { return static_cast<int>(frames_.size()) - 1; }
  int count() const { return static_cast<int>(frames_.size()); }

  /// The leg that all else is asked about. False: an angle or a length does not run linearly, and
  /// nothing may be asked.
  bool set_leg(std::span<const double> q_from, std::span<const double> q_to);

  /// As `body_poses` and `tool_pose`, but for rounding.
  void poses(const double (&shares)[math::kLanes], math::LaneFrame* frames) const;

  struct Motion {
    AccelerationBound acceleration;  ///< of points of the frame
    bool moves = false;
  };
  /// As seen from the frame of a body that carries this one (-1: the world).
  const Motion& motion(int base, int frame);

  /// An angle (degrees) or a length (m) by the parameters: of one at most, or as the formula says.
  struct Value {
    double constant = 0;
    int parameter = -1;
    double factor = 0;
    const Formula* formula = nullptr;
  };
  /// A step from one frame to the next; plain data.
  struct Step {
    enum class Kind { fixed, turn, slide };
    Kind kind = Kind::fixed;
    int axis = 0;                ///< of a turn
    bool turns = false;          ///< a fixed one turns, too
    double R[3][3] = {};         ///< of a fixed one
    double t[3] = {};            ///< m, of a fixed one
    double along = 0;            ///< m: what of t is along the axis of the last turn before it,
    double across = 0;           ///< m: and across it
    LinearValue values[3] = {};  ///< on the leg: of a turn the angle (degrees), of a slide x, y, z
    double sine = 0;             ///< of a turn that stands
    double cosine = 1;
  };

  struct Frame {
    int parent = -1;
    std::size_t first = 0;  ///< of its steps
    std::size_t last = 0;   ///< after them
    int axis = -1;          ///< of the last turn; -1: none, or it has been turned since
  };

 private:
  /// What is known of a frame as seen from a base.
  struct Chain {
    ChainBound bound;
    Motion motion;
    bool known = false;
  };

  void add_frame(int parent, const FrameFormula& elements);
  Value value_of(const Formula& formula) const;
  const Chain& chain(int base, int frame);
  void append(Chain& chain, const Step& step) const;

  const RobotModel& model_;
  std::vector<double> starts_;
  double X_WM_[3][4] = {};
  std::vector<Frame> frames_;
  std::vector<Step> steps_;
  std::vector<Value> values_;  ///< three to a step
  std::vector<Chain> chains_;  ///< by base and frame
};

/// X <- X * what follows, which stands still in it.
void append(math::LaneFrame& X, const Pose& next);

}  // namespace rubicon::robot
