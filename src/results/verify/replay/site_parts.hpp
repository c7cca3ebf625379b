#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "src/results/verify/replay/component_stays.hpp"
#include "src/results/verify/replay/leg_motion.hpp"

namespace rubicon::verify {

/// Something that stands for some time and must not be met.
struct Obstacle {
  std::string name;
  std::shared_ptr<const Solid> solid;
  Pose X_WS = Pose::Identity();
  Ticks from = 0;
  Ticks to = 0;
  int component = -1;      ///< -1: site or zone
  int exempt = -1;         ///< robot that may be in it
  bool for_loads = false;  ///< only loads must not meet it
};

/// A robot as it is tested: its bodies, and which of them against each other.
struct RobotParts {
  std::unique_ptr<Mechanism> mechanism;
  std::vector<std::shared_ptr<const Solid>> solids;  ///< by body; null: no shape
  std::vector<RobotPart> bodies;                     ///< those with a shape, and ropes
  std::vector<int> body_index;                       ///< of `bodies`, in the robot
  std::vector<std::shared_ptr<const Solid>> grown;   ///< of `buffers`
  std::vector<RobotPart> buffers;                    ///< not tested against buffers of others
  std::vector<std::pair<int, int>> own_pairs;        ///< in `bodies`
};

/// Everything that takes part in contact.
struct SiteParts {
  std::vector<std::shared_ptr<const Solid>> components;  ///< null: no shape
  std::shared_ptr<const Solid> carry;
  std::vector<RobotParts> robots;
  std::vector<Obstacle> obstacles;  ///< the site and the stays of components
  std::vector<Obstacle> zones;      ///< while their tasks last
};

/// What is round a body with a buffer.
std::string buffer_name(const std::string& body);

/// What a load meets above people that move by a timetable.
std::string air_above(const std::string& moving);

/// What a load meets above the zone of a task.
std::string overhead_name(const std::string& task);

/// `until` is the end of the plan.
SiteParts make_site_parts(const Trace& trace, const std::vector<TaskRun>& runs,
                          const std::vector<Stay>& stays, Ticks until);

}  // namespace rubicon::verify
