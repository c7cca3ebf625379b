#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "src/exchange/project_io/carried.hpp"
#include "src/exchange/project_io/listing.hpp"

namespace rubicon::project_io {

/// A calendar that the import block carries.
struct CarriedCalendar {
  Calendar calendar;
  bool whole = false;  ///< with its week and exceptions; else the plan says them
};

/// A line of the schedule that the import block carries.
struct CarriedTask {
  Task task;
  bool planned = false;     ///< the plan has a task of that name
  std::vector<Link> links;  ///< those that the plan does not say, or says in other words
  /// Those that the plan leaves out because the task stands at dates of its own.
  std::vector<Link> held;
  /// Where it does: what the plan was written with, in seconds.
  struct Fixed {
    std::int64_t start = 0;
    std::int64_t takes = 0;
  };
  std::optional<Fixed> fixed;
};

/// What the import block of a plan carries, by the names that the plan uses.
struct CarriedProject {
  std::optional<Project> project;  ///< its plain fields
  std::map<std::string, CarriedCalendar> calendars;
  std::map<std::string, Resource> resources;
  std::map<std::string, CarriedTask> tasks;
  std::vector<std::string> calendar_order, resource_order, task_order;
  std::set<std::string> milestones;  ///< tasks of the plan that are no line of the schedule
  std::set<std::string> own_crews;   ///< crews of the plan that are no resource
  /// Crews that do not have the calendar of their resource: the one that they have, or kNone.
  std::map<std::string, std::int64_t> free_crews;
  /// Further crews of a resource that is not levelled, and its first.
  std::map<std::string, std::string> crews_of;
  std::vector<Assignment> assignments;
};

/// Reads the statements of an import block; what is not understood is listed (I10).
CarriedProject read_carried_project(const std::vector<CarriedRecord>& records, Listing& listing);

}  // namespace rubicon::project_io
