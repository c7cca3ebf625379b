#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "src/exchange/project_io/identifiers.hpp"
#include "src/exchange/project_io/plan_network.hpp"
#include "src/exchange/project_io/project.hpp"

namespace rubicon::project_io {

/// Whether tasks wait for the resources they have.
enum class Levelling {
  none,      ///< no: links and calendars alone decide, as in Project and Primavera by default
  resources  ///< a resource is one crew, which does one task at a time
};

/// A crew at work on a task.
struct PlanWorker {
  std::string crew;
  std::size_t resource = 0;  ///< index in Project::resources
  double units = 1;          ///< how many of the resource the schedule has on the task
};

/// The crews that the resources of a schedule become.
struct PlanCrews {
  std::vector<std::vector<std::string>> names;   ///< by resource: at least one
  std::vector<std::vector<PlanWorker>> of_task;  ///< by line of the schedule: who works on it
  /// Crews that do not have the calendar of their resource, because a task of theirs does not go by
  /// it: the calendar that all their tasks have, kNone (day and night) where these differ.
  std::map<std::string, std::int64_t> free;
  /// Who has no hour in common with the others on a task, and does not count for its hours.
  struct Apart {
    std::size_t task = 0;
    std::size_t resource = 0;
  };
  std::vector<Apart> apart;
  /// By line of the schedule: calendars of the resources in such crews by which it does go.
  std::vector<std::vector<std::int64_t>> calendars;
};

/// A resource becomes one crew; where it is not levelled and its links let tasks of it meet, one
/// for each row of them that never do (CrewLanes). `taken` gives the names, and keeps them.
PlanCrews plan_crews(const Project& project, const PlanNetwork& network, Levelling levelling,
                     Identifiers& taken);

}  // namespace rubicon::project_io
