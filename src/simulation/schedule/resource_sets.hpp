#pragma once

#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "src/simulation/schedule/work_calendar.hpp"

namespace rubicon::schedule {

/// What a task needs of a resource: so many units of its size (of a crew: people).
struct Share {
  int resource = -1;
  int units = 1;
  int group = -1;  ///< it may also have what is reserved for this group; -1: for none
  auto operator<=>(const Share&) const = default;
};

/// The different sets of resources that the tasks of a plan ask for together, each with the hours
/// in which all work whom the task needs. Tasks of one set wait in one queue, so that only its
/// first needs to be looked at.
class ResourceSets {
 public:
  /// `calendar_of` each resource: index into `calendars`, -1: day and night.
  ResourceSets(std::vector<int> calendar_of, std::vector<WorkCalendar> calendars);

  /// The set of those who ask for all of `shares` (each resource once) and need the working hours
  /// of all of `hours_of` (resources too). A message for the user if these have no common hours.
  std::variant<int, std::string> set_of(std::vector<Share> shares, std::vector<int> hours_of);

  int size() const { return static_cast<int>(sets_.size()); }
  const std::vector<Share>& shares(int set) const { return sets_[at(set)].shares; }
  /// The resources of `shares`, in the same order.
  const std::vector<int>& resources(int set) const { return sets_[at(set)].resources; }
  /// The working hours of a set.
  const WorkCalendar& calendar(int set) const { return calendars_[at(sets_[at(set)].calendar)]; }
  /// The working hours of a resource.
  const WorkCalendar& hours(int resource) const;

 private:
  struct Set {
    std::vector<Share> shares;
    std::vector<int> resources;
    int calendar = 0;
  };

  static std::size_t at(int index) { return static_cast<std::size_t>(index); }
  std::variant<int, std::string> common_calendar(const std::vector<int>& hours_of);

  std::vector<int> calendar_of_;
  std::vector<WorkCalendar> calendars_;
  std::map<std::vector<int>, int> common_;  ///< of sets of calendars
  std::map<std::pair<std::vector<Share>, std::vector<int>>, int> set_of_;
  std::vector<Set> sets_;
};

}  // namespace rubicon::schedule
