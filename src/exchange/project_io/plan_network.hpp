#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/exchange/project_io/listing.hpp"
#include "src/exchange/project_io/project.hpp"

namespace rubicon::project_io {

/// A link of a plan.
struct PlanLink {
  std::string predecessor;
  LinkType type = LinkType::FS;
  std::int64_t lag = 0;  ///< s
};

/// A task of the plan that a line of the schedule becomes; a heading or an inactive task becomes
/// none.
struct PlanTask {
  std::string name;  ///< of headings too: it is unique among all lines
  bool planned = false;
  bool in_parts = false;  ///< other tasks do it, between its milestones; it is not planned itself
  std::vector<PlanLink> after;
  std::vector<bool> said;  ///< which of the line's links the plan says just so
  std::vector<bool> held;  ///< which it leaves out because the task stands at dates of its own
};

/// A task without work that stands for the beginning or the end of a heading, or of the plan.
struct PlanMilestone {
  std::string name;
  std::size_t before = 0;  ///< the line before which it is written
  bool ends = false;       ///< it stands behind all parts of that line
  std::vector<PlanLink> after;
  bool at_end = false;  ///< of the line, else at its beginning
};

/// The lines of a schedule as tasks of a plan with names and links. Links to and from headings go
/// over milestones NAME_begins (before all that is below) and NAME_ends (after all of it), and so
/// do those of tasks that are done in parts; "not before this date" becomes a lag behind the
/// milestone plan_begins.
struct PlanNetwork {
  std::vector<PlanTask> tasks;            ///< one a line, in their order
  std::vector<PlanMilestone> milestones;  ///< by `before`
};

/// The name of the milestone at which the plan starts.
inline constexpr const char* kPlanBegins = "plan_begins";

/// A task of the plan that does a part of a task of the schedule.
struct TaskPart {
  std::string name;     ///< no line is called so
  bool awaited = true;  ///< the end of the task waits for it
};
/// By uid of the task.
using TaskParts = std::map<std::int64_t, std::vector<TaskPart>>;

/// `start` is the moment at which the plan starts, empty if it says none. What the plan cannot say
/// is listed (I08).
PlanNetwork plan_network(const Project& project, const Moment& start, Listing& listing,
                         const TaskParts& parts = {});

/// Whether a lag counts day and night: elapsed time, or that of tasks which both go on always.
bool counts_always(const Project& project, const Link& link, const Task& predecessor,
                   const Task& successor);

/// The lag of a link in a plan, in seconds that run day and night; percents count from the
/// predecessor's duration. Of working time each whole week of the project counts seven days and
/// each whole working day of the rest 24 hours: a lag of one day stays the next day.
std::int64_t whole_lag(const Project& project, const Link& link, const Task& predecessor,
                       const Task& successor);

/// The same as far as a plan can say it.
std::int64_t plan_lag(const Project& project, const Link& link, const Task& predecessor,
                      const Task& successor);

/// How a lag is written that comes from a plan.
TimeFormat plan_lag_format(std::int64_t lag);

/// The link behind plan_begins by which the plan keeps a constraint; nothing if it cannot, or need
/// not because the date is not after `start`.
std::optional<PlanLink> constraint_link(const Task& task, const Moment& start);

/// The date before which a task does not start, where it is too far from the beginning for such a
/// link, to the minute: the plan says it as `not_before`. Nothing where there is none.
std::optional<Moment> far_start(const Task& task, const Moment& start);

}  // namespace rubicon::project_io
