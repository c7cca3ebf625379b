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
  std::vector<OwnPair> own_pairs;   ///< bodies with shapes and ropes, neither parent and child nor
                                    ///< declared touching
  std::vector<OwnPair> load_pairs;  ///< bodies the load must not meet: all with shapes but the tool
                                    ///< body, its hook, and the ropes that hold it

  bool is_rope(int part) const {
    return static_cast<std::size_t>(part) < model->bodies.size() &&
           model->bodies[static_cast<std::size_t>(part)].rope.has_value();
  }
};

/// Prepares a robot; `bodies` may come from another robot of the same model (empty: prepared here).
/// Throws std::invalid_argument for shapes without extent.
SiteRobot make_site_robot(std::string name, std::shared_ptr<const robot::RobotModel> model,
                          robot::Mounting mounting, std::vector<collision::BodyPtr> bodies = {});

}  // namespace rubicon::site
