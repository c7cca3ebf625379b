#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/motion/travel/travel.hpp"

namespace rubicon::comparison {

/// One method on the way of a task.
struct TravelTrial {
  travel::Method method = travel::Method::kBug2;
  /// Nothing where the method is for standing obstacles only, and some move.
  std::optional<travel::TravelResult> result;
};

/// The ways of all methods from where a vehicle starts to where a task sends it.
struct TravelComparison {
  std::string plan;
  std::string task;
  double radius = 0;  ///< m: of the disc that stands for the vehicle; 0: it has no shape
  travel::Vec2 start{0, 0};
  travel::Vec2 destination{0, 0};
  std::size_t obstacles = 0;
  std::size_t movings = 0;  ///< of these
  std::vector<TravelTrial> trials;
  double shortest = -1;  ///< m: for whoever knows all obstacles; negative: there is no way
};

/// Runs a point through the plan view of the site as it is at the beginning: every site shape and
/// component at the heights of the vehicle, grown by the disc about its place that holds it however
/// it is turned. What moves by a timetable keeps it, whatever is in its way; before its first time
/// it stands at its first place, after its last one at its last. `task` must be one that
/// `moving_tasks` tells. Throws std::invalid_argument, with a message for the user, where the
/// machine has no parameters x and y, the task does not `go` to values of them or a frame, an
/// outline is no polygon, or something with a timetable leans or goes up or down.
TravelComparison compare_travel(const interpreter::PlanModel& plan, const std::string& task,
                                const travel::TravelSettings& settings = {});

/// A table, and the events of each way.
std::string travel_text(const TravelComparison& comparison);
/// A line for each event.
std::string travel_csv(const TravelComparison& comparison);
std::string travel_json(const TravelComparison& comparison);

}  // namespace rubicon::comparison
