#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "src/motion/collision/swept_query.hpp"
#include "src/motion/robot/kinematics.hpp"
#include "src/motion/robot/robot_model.hpp"

namespace rubicon::site {

/// Two parts of one robot that may not meet, and the parameters that move one against the other.
struct OwnPair {
  int first = 0;   ///< a body, declared before `second`; of a load pair the body it must not meet
  int second = 0;  ///< a body; unused in a load pair
  std::vector<int> parameters;

  /// Whether a step from q0 to q1 moves the two against each other. If not, they stand to each
  /// other as they did before the step and need no test.
  bool moves(std::span<const double> q0, std::span<const double> q1) const;
};

class RopeBodies;

/// What may come no nearer to a body of a robot, as a part of the robot: the body, grown.
struct Buffer {
  int body = 0;
  collision::BodyPtr grown;
};

/// A machine made ready for the site: its bodies prepared, its own pairs listed. Immutable.
struct SiteRobot {
  std::string name;  ///< as the plan calls it
  std::shared_ptr<const robot::RobotModel> model;
  robot::Mounting mounting;
  std::vector<collision::BodyPtr> bodies;   ///< per body of the model; null without shapes, and for
                                            ///< ropes, whose shape depends on where they are
  std::vector<int> ropes;                   ///< bodies of the model that are ropes
  std::shared_ptr<RopeBodies> rope_bodies;  // shared: copies of a robot are the same machine
  std::vector<std::string> body_names;      ///< robot.body
  std::vector<std::string> buffer_names;    ///< the buffer of robot.body
  std::vector<OwnPair> own_pairs;   ///< bodies with shapes and ropes, neither parent and child nor
                                    ///< declared touching
  std::vector<OwnPair> load_pairs;  ///< bodies the load must not meet: all with shapes but the tool
                                    ///< body, its hook, and the ropes that hold it

  std::vector<bool> fixed_bodies;  ///< per body of the model: no parameter moves it

  /// Whether no step of the machine moves the part: a mast, a foundation.
  bool is_fixed(int part) const {
    return part != load_part() && fixed_bodies[static_cast<std::size_t>(body_of(part))];
  }
  /// The name of a part that is not the load.
  const std::string& name_of(int part) const {
    return is_buffer(part) ? buffer_names[static_cast<std::size_t>(part - load_part() - 1)]
                           : body_names[static_cast<std::size_t>(part)];
  }
  /// Parts of the robot: the bodies of the model, then the load, then the buffers. A buffer is
  /// tested against what is not of the robot and not its load, and not against another buffer.
  std::vector<Buffer> buffers;

  int load_part() const { return static_cast<int>(bodies.size()); }
  bool is_buffer(int part) const { return part > load_part(); }
  int buffer_part(std::size_t buffer) const { return load_part() + 1 + static_cast<int>(buffer); }
  /// The body of the model that moves as the part does; the tool body for the load.
  int body_of(int part) const {
    if (is_buffer(part)) return buffers[static_cast<std::size_t>(part - load_part() - 1)].body;
    return part == load_part() ? model->tool_body : part;
  }
  bool is_rope(int part) const {
    return static_cast<std::size_t>(part) < model->bodies.size() &&
           model->bodies[static_cast<std::size_t>(part)].rope.has_value();
  }
};

/// What robots of the same model share.
struct PreparedBodies {
  std::vector<collision::BodyPtr> bodies;
  std::vector<Buffer> buffers;
};

/// Prepares a robot; `prepared` may come from another robot of the same model (empty: prepared
/// here). Throws std::invalid_argument for shapes without extent.
SiteRobot make_site_robot(std::string name, std::shared_ptr<const robot::RobotModel> model,
                          robot::Mounting mounting, PreparedBodies prepared = {});

}  // namespace rubicon::site
