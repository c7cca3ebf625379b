#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "src/exchange/project_io/plan_network.hpp"

namespace rubicon::project_io {

/// Which tasks of a resource can share one crew of a plan without ever waiting for it: those of
/// which each starts, by its links, only when the one before has finished. A crew does one task at
/// a time, while a resource of a schedule that is not levelled works on any number; so it becomes a
/// crew for each such row of tasks. Then links and calendars alone decide when a task starts, also
/// when durations change.
class CrewLanes {
 public:
  /// `network` must outlive it.
  explicit CrewLanes(const PlanNetwork& network);

  /// The lane, from 0, of each of these lines of the schedule; in their order.
  std::vector<std::size_t> lanes_of(const std::vector<std::size_t>& lines) const;

 private:
  struct Before {
    std::size_t node;
    LinkType type;
  };

  void add_links(std::size_t node, const std::vector<PlanLink>& links);
  std::size_t lane_behind(std::size_t line,
                          const std::unordered_map<std::size_t, std::size_t>& last) const;

  std::unordered_map<std::string, std::size_t> nodes_;  ///< lines, then milestones, by name
  std::vector<std::vector<Before>> before_;             ///< by node; without lags that look ahead
};

}  // namespace rubicon::project_io
