#pragma once

#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/motion/coverage/standing.hpp"

namespace rubicon::interpreter {

/// The layer over a floor that a tool works in.
struct FloorLayer {
  double surface = 0;  ///< m: what reaches over it by more than 1 mm is in the way
  double tool = 0;     ///< m, at or over the surface: what begins above it is not
};

/// What of a component with its frame at X_WO stands in a layer: the shadow of each of its shapes
/// that does. Upright cylinders are round. Empty where nothing does.
std::vector<coverage::Standing> standing_in(const ComponentSpec& component, const math::Pose& X_WO,
                                            const FloorLayer& layer);

/// Where the components of a plan are while a task is under way, as far as links tell.
class ComponentPlaces {
 public:
  /// `plan` must outlive this object.
  explicit ComponentPlaces(const PlanModel& plan);

  /// A place where a component may be.
  struct Place {
    bool is_there = true;  ///< false: it has been removed
    math::Pose X_WO = math::Pose::Identity();
  };
  struct Answer {
    std::vector<Place> places;  ///< one where it is certain
    int undecided = -1;         ///< a task that moves it before, after or meanwhile; -1: certain
  };
  /// For each component, while `task` is under way: what is done by tasks that finish before it
  /// starts counts, what tasks do that start after it has finished does not.
  std::vector<Answer> during(int task) const;

 private:
  std::vector<bool> reached(std::size_t event, const std::vector<std::vector<int>>& next) const;
  bool is_before(int first, int second) const;
  Place place_after(int task, int component) const;

  const PlanModel& plan_;
  /// Of each event those that do not come before it, or not after it: 2 t is the start of task t,
  /// 2 t + 1 its finish.
  std::vector<std::vector<int>> later_, earlier_;
  std::vector<std::vector<int>> users_;  ///< by component: tasks that move or remove it
};

}  // namespace rubicon::interpreter
