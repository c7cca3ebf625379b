#include "src/exchange/project_io/plan_network.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "src/exchange/project_io/dates.hpp"
#include "src/exchange/project_io/fixed_dates.hpp"
#include "src/exchange/project_io/identifiers.hpp"
#include "src/exchange/project_io/plan_terms.hpp"
#include "src/exchange/project_io/plan_text.hpp"

namespace rubicon::project_io {

namespace {

constexpr std::size_t kNone32 = SIZE_MAX;

/// The event of a task without work: its start is its finish.
LinkType from_point(LinkType type) {
  return type == LinkType::FF || type == LinkType::SF ? LinkType::FF : LinkType::FS;
}

class NetworkBuilder {
 public:
  NetworkBuilder(const Project& project, const Moment& start, Listing& listing,
                 const TaskParts& parts)
      : project_(project), start_(start), listing_(listing), parts_(parts) {}

  PlanNetwork build() {
    const std::size_t count = project_.tasks.size();
    network_.tasks.resize(count);
    begins_.assign(count, false);
    ends_.assign(count, false);
    end_links_.resize(count);
    for (std::size_t i = 0; i < count; ++i) index_.emplace(project_.tasks[i].uid, i);
    for (const Task& each : project_.tasks) {
      for (const Link& link : each.after) predecessors_.insert(link.predecessor);
    }
    find_parents();
    make_names();
    find_fixed();
    for (std::size_t i = 0; i < count; ++i) note_headings(i);
    make_milestones();
    for (std::size_t i = 0; i < count; ++i) make_links(i);
    add_outline_links();
    finish_milestones();
    return std::move(network_);
  }

 private:
  const Task& task(std::size_t i) const { return project_.tasks[i]; }
  bool is_heading(std::size_t i) const { return project_.is_heading(i); }
  bool is_in_parts(std::size_t i) const { return network_.tasks[i].in_parts; }
  /// Whether its links go over milestones.
  bool has_milestones(std::size_t i) const { return is_heading(i) || is_in_parts(i); }

  void find_parents() {
    parent_.assign(project_.tasks.size(), kNone32);
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < project_.tasks.size(); ++i) {
      while (!open.empty() && task(open.back()).level >= task(i).level) open.pop_back();
      if (!open.empty()) parent_[i] = open.back();
      open.push_back(i);
    }
  }

  void make_names() {
    names_.make(kPlanBegins, kPlanBegins);
    for (const auto& [uid, parts] : parts_) {
      for (const TaskPart& part : parts) names_.reserve(part.name);
    }
    for (std::size_t i = 0; i < project_.tasks.size(); ++i) {
      PlanTask& planned = network_.tasks[i];
      const std::string prefix =
          parent_[i] == kNone32 ? std::string() : network_.tasks[parent_[i]].name;
      planned.name = names_.make(task(i).name, fmt::format("row_{}", task(i).uid), prefix);
      planned.planned = !is_heading(i) && task(i).active && !is_remark(i);
      planned.in_parts = planned.planned && parts_.contains(task(i).uid);
      if (planned.in_parts) planned.planned = false;
      planned.said.assign(task(i).after.size(), false);
      planned.held.assign(task(i).after.size(), false);
      if (!task(i).active) {
        listing_.add("I08", "inactive", {},
                     fmt::format("task '{}' is not active: it is carried along and not planned",
                                 task(i).name));
      }
    }
  }

  /// Which tasks stand at dates of their own.
  void find_fixed() {
    fixed_.resize(project_.tasks.size());
    begins_then_.resize(project_.tasks.size());
    for (std::size_t i = 0; i < fixed_.size(); ++i) {
      if (!network_.tasks[i].planned && !is_in_parts(i)) continue;
      const std::optional<FixedDates> dates = fixed_dates(task(i), start_);
      const bool has_finish = !task(i).actual_finish.text.empty();
      const bool has_fact = has_finish || !task(i).actual_start.text.empty();
      if ((has_fact && !dates) || (has_finish && !dates->finish)) {
        listing_.add("I08", "odd dates", {},
                     fmt::format("not all actual dates of '{}' can be kept: one is missing, before "
                                 "the other, or too far from the beginning of the plan",
                                 task(i).name));
      }
      if (!dates) continue;
      if (dates->cut) {
        listing_.add("I08", "before start", {},
                     fmt::format("'{}' begins before {}, at which the plan does: in the plan what "
                                 "was before that is left off",
                                 task(i).name, start_.text));
      }
      (is_in_parts(i) ? begins_then_ : fixed_)[i] = dates;
    }
  }

  /// Whether a link to a task that stands at its dates holds by itself.
  bool is_kept(std::size_t from, std::size_t to, const Link& link, std::int64_t lag) const {
    if (!fixed_[from]) return false;
    const bool of_finish = link.type == LinkType::FS || link.type == LinkType::FF;
    const bool to_finish = link.type == LinkType::FF || link.type == LinkType::SF;
    const auto before = of_finish ? fixed_[from]->finish : fixed_[from]->start;
    const auto after = to_finish ? fixed_[to]->finish : fixed_[to]->start;
    return before && after && *before + lag <= *after;
  }

  /// A line that only parts or heads others: no work, no links, and no name or no bar.
  bool is_remark(std::size_t i) const {
    const Task& line = task(i);
    return line.duration.seconds == 0 && !line.milestone && line.after.empty() &&
           !predecessors_.contains(line.uid) && (line.name.empty() || line.hide_bar);
  }

  /// Whether both ends of a link are in the plan and it binds what a plan can bind.
  bool can_say(std::size_t from, std::size_t to, LinkType type) const {
    const auto is_there = [&](std::size_t i) {
      return has_milestones(i) || network_.tasks[i].planned;
    };
    const bool to_finish = type == LinkType::FF || type == LinkType::SF;
    return is_there(from) && is_there(to) && !(is_heading(to) && to_finish);
  }

  /// Which milestones the links and the constraint of a line need.
  void note_headings(std::size_t i) {
    if (is_in_parts(i)) begins_[i] = ends_[i] = true;
    for (const Link& link : task(i).after) {
      const std::size_t from = index_.at(link.predecessor);
      if (!can_say(from, i, link.type)) continue;
      if (is_heading(i)) begins_[i] = true;
      if (!is_heading(from)) continue;
      (link.type == LinkType::FS || link.type == LinkType::FF ? ends_ : begins_)[from] = true;
    }
    if (fixed_[i]) return;
    if (begins_then(i)) uses_begin_ = true;
    if (!constraint_link(task(i), start_)) return;
    if (!has_milestones(i) && !network_.tasks[i].planned) return;
    uses_begin_ = true;
    if (is_heading(i)) begins_[i] = true;
  }

  /// What keeps a task that is done in parts from beginning sooner than it did.
  std::optional<PlanLink> begins_then(std::size_t i) const {
    if (!is_in_parts(i) || !begins_then_[i] || begins_then_[i]->start == 0) return std::nullopt;
    const std::int64_t lag = begins_then_[i]->start;
    if (static_cast<double>(lag) > kMaxPlanSeconds) return std::nullopt;
    return PlanLink{kPlanBegins, LinkType::FS, lag};
  }

  void make_milestones() {
    const std::size_t count = project_.tasks.size();
    begin_name_.resize(count);
    end_name_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::string& name = network_.tasks[i].name;
      if (begins_[i]) begin_name_[i] = names_.make(name + "_begins", name);
      if (ends_[i]) end_name_[i] = names_.make(name + "_ends", name);
    }
    begin_links_.resize(count);
  }

  /// Where a link of this type to a line is written.
  std::vector<PlanLink>& links_to(std::size_t i, LinkType type) {
    if (!has_milestones(i)) return network_.tasks[i].after;
    const bool to_finish = type == LinkType::FF || type == LinkType::SF;
    return to_finish ? end_links_[i] : begin_links_[i];
  }

  void make_links(std::size_t i) {
    for (std::size_t k = 0; k < task(i).after.size(); ++k) {
      const Link& link = task(i).after[k];
      const std::size_t from = index_.at(link.predecessor);
      if (!can_say(from, i, link.type)) {
        listing_.add("I08", "unsaid link", {},
                     fmt::format("the link from '{}' to '{}' is carried along: the plan cannot say "
                                 "it, because one is not active or a heading's end is bound",
                                 task(from).name, task(i).name));
        continue;
      }
      const std::int64_t whole = whole_lag(project_, link, task(from), task(i));
      const std::int64_t lag = plan_lag(project_, link, task(from), task(i));
      if (fixed_[i] && !is_kept(from, i, link, lag)) {
        network_.tasks[i].held[k] = true;
        listing_.add(
            "I08", "held link", {},
            fmt::format("the link from '{}' to '{}' is carried along: '{}' has begun or is "
                        "placed by hand, and its dates hold in the plan",
                        task(from).name, task(i).name, task(i).name));
        continue;
      }
      if (lag != whole) {
        listing_.add("I08", "long lag", {},
                     fmt::format("the lag from '{}' to '{}' is longer than a plan can say",
                                 task(from).name, task(i).name));
      }
      if (lag != 0 && !counts_always(project_, link, task(from), task(i))) {
        listing_.add(
            "I08", "working lag", {},
            fmt::format("the lag from '{}' to '{}' counts working time there; in the plan "
                        "it runs day and night, a working day as 24 h, a week as seven days",
                        task(from).name, task(i).name));
      }
      const bool heading_end =
          has_milestones(from) && (link.type == LinkType::FS || link.type == LinkType::FF);
      PlanLink said;
      said.predecessor = !has_milestones(from) ? network_.tasks[from].name
                         : heading_end         ? end_name_[from]
                                               : begin_name_[from];
      said.type = has_milestones(from) ? from_point(link.type) : link.type;
      said.lag = lag;
      links_to(i, link.type).push_back(said);
      if (is_heading(from) && !heading_end) {
        listing_.add("I08", "heading start", {},
                     fmt::format("'{}' is bound to the start of '{}': in the plan to the moment at "
                                 "which that may start",
                                 task(i).name, task(from).name));
      }
      network_.tasks[i].said[k] = !has_milestones(from) && !has_milestones(i) &&
                                  link.format == plan_lag_format(link.lag) && lag == link.lag;
    }
    if ((!has_milestones(i) && !network_.tasks[i].planned) || fixed_[i]) return;
    if (is_in_parts(i) && begins_then_[i]) {
      listing_.add(
          "I08", "fixed parts", {},
          fmt::format("'{}' has begun or is placed by hand, and is done in parts: it is not "
                      "earlier than there, but may be later and last longer",
                      task(i).name));
      if (const auto link = begins_then(i)) begin_links_[i].push_back(*link);
    }
    if (const auto link = constraint_link(task(i), start_)) {
      links_to(i, is_heading(i) ? LinkType::FS : link->type).push_back(*link);
      if (task(i).constraint == Constraint::must_start_on ||
          task(i).constraint == Constraint::must_finish_on) {
        listing_.add("I08", "must", {},
                     fmt::format("'{}' must be on {} there; in the plan it is not earlier, but may "
                                 "be later",
                                 task(i).name, task(i).constraint_date.text));
      }
    } else {
      list_constraint(i);
    }
  }

  void list_constraint(std::size_t i) {
    const Constraint constraint = task(i).constraint;
    if (constraint == Constraint::as_soon_as_possible) return;
    const bool bounds_below = constraint == Constraint::start_no_earlier_than ||
                              constraint == Constraint::must_start_on ||
                              constraint == Constraint::finish_no_earlier_than ||
                              constraint == Constraint::must_finish_on;
    // Dates before the beginning hold by themselves.
    const auto begin = second_number(start_.text),
               date = second_number(task(i).constraint_date.text);
    const bool is_task = bounds_below && begin && date && !is_heading(i);
    const bool must =
        constraint == Constraint::must_start_on || constraint == Constraint::must_finish_on;
    if (is_task && must && *date < *begin) {
      listing_.add(
          "I08", "must before", {},
          fmt::format("'{}' must be on {} there, before the plan begins: in the plan it is "
                      "not earlier than that",
                      task(i).name, task(i).constraint_date.text));
      return;
    }
    if (is_task && (*date <= *begin || far_start(task(i), start_))) return;
    if (is_task) {
      listing_.add("I08", "far constraint", {},
                   fmt::format("the date of '{}', {}, is carried along: it is farther from the "
                               "beginning than a plan can say",
                               task(i).name, task(i).constraint_date.text));
      return;
    }
    listing_.add(
        "I08", "constraint", {},
        fmt::format("the constraint of '{}' is carried along: a plan knows no latest dates "
                    "and no 'as late as possible'",
                    task(i).name));
  }

  /// What is below a heading waits for its beginning; its end waits for what is below.
  void add_outline_links() {
    for (std::size_t i = 0; i < project_.tasks.size(); ++i) {
      const std::size_t begin = nearest(i, begins_);
      if (begin != kNone32) {
        const PlanLink link{begin_name_[begin], LinkType::FS, 0};
        if (network_.tasks[i].planned && !fixed_[i]) network_.tasks[i].after.push_back(link);
        if (begins_[i]) begin_links_[i].push_back(link);
      }
      const std::size_t end = nearest(i, ends_);
      if (end == kNone32) continue;
      if (network_.tasks[i].planned) {
        end_links_[end].push_back({network_.tasks[i].name, LinkType::FS, 0});
      } else if (ends_[i]) {
        end_links_[end].push_back({end_name_[i], LinkType::FS, 0});
      }
    }
  }

  /// The nearest heading above a line that has such a milestone.
  std::size_t nearest(std::size_t i, const std::vector<bool>& has) const {
    std::size_t at = parent_[i];
    while (at != kNone32 && !has[at]) at = parent_[at];
    return at;
  }

  void finish_milestones() {
    const bool none_planned = std::none_of(network_.tasks.begin(), network_.tasks.end(),
                                           [](const PlanTask& each) { return each.planned; });
    if (uses_begin_ || none_planned) network_.milestones.push_back({kPlanBegins, 0, false, {}});
    for (std::size_t i = 0; i < project_.tasks.size(); ++i) {
      if (begins_[i]) {
        network_.milestones.push_back({begin_name_[i], i, false, std::move(begin_links_[i])});
      }
      if (!ends_[i]) continue;
      if (is_in_parts(i)) {
        // Also where none is awaited the end does not come before the beginning.
        end_links_[i].push_back({begin_name_[i], LinkType::FS, 0});
        for (const TaskPart& part : parts_.at(task(i).uid)) {
          if (part.awaited) end_links_[i].push_back({part.name, LinkType::FS, 0});
        }
      }
      network_.milestones.push_back(
          {end_name_[i], i, is_in_parts(i), std::move(end_links_[i]), true});
    }
  }

  const Project& project_;
  const Moment& start_;
  Listing& listing_;
  const TaskParts& parts_;
  PlanNetwork network_;
  Identifiers names_;
  std::unordered_map<std::int64_t, std::size_t> index_;
  std::unordered_set<std::int64_t> predecessors_;  ///< of any task
  std::vector<std::size_t> parent_;
  std::vector<bool> begins_, ends_;  ///< which headings need a milestone
  std::vector<std::string> begin_name_, end_name_;
  std::vector<std::vector<PlanLink>> begin_links_, end_links_;
  bool uses_begin_ = false;
  std::vector<std::optional<FixedDates>> fixed_;        ///< of tasks that stand at their dates
  std::vector<std::optional<FixedDates>> begins_then_;  ///< of those that are done in parts
};

}  // namespace

bool counts_always(const Project& project, const Link& link, const Task& predecessor,
                   const Task& successor) {
  return link.format.elapsed ||
         (works_always(project, predecessor.calendar) && works_always(project, successor.calendar));
}

std::int64_t whole_lag(const Project& project, const Link& link, const Task& predecessor,
                       const Task& successor) {
  std::int64_t lag = link.lag;
  if (link.format.unit == TimeUnit::percent) {
    // Percent of whole seconds, rounded once. Far beyond any duration the caller cuts.
    const double seconds =
        static_cast<double>(predecessor.duration.seconds) * static_cast<double>(link.lag) / 100;
    constexpr double kFar = 1e15;
    lag = std::llround(std::clamp(seconds, -kFar, kFar));
  }
  if (lag == 0 || counts_always(project, link, predecessor, successor)) return lag;
  const std::int64_t day = std::max(project.minutes_per_day, 1) * std::int64_t{60};
  const std::int64_t week = std::max(project.minutes_per_week, 1) * std::int64_t{60};
  constexpr std::int64_t kDay = 86'400;
  return lag / week * 7 * kDay + lag % week / day * kDay + lag % week % day;
}

std::int64_t plan_lag(const Project& project, const Link& link, const Task& predecessor,
                      const Task& successor) {
  const auto longest = static_cast<std::int64_t>(kMaxPlanSeconds);
  return std::clamp(whole_lag(project, link, predecessor, successor), -longest, longest);
}

TimeFormat plan_lag_format(std::int64_t lag) {
  return lag == 0 ? TimeFormat{} : TimeFormat{TimeUnit::hours, true, false};
}

std::optional<PlanLink> constraint_link(const Task& task, const Moment& start) {
  const auto begin = second_number(start.text), date = second_number(task.constraint_date.text);
  if (!begin || !date || *date <= *begin) return std::nullopt;
  PlanLink link{kPlanBegins, LinkType::FS, *date - *begin};
  if (static_cast<double>(link.lag) > kMaxPlanSeconds) return std::nullopt;
  switch (task.constraint) {
    case Constraint::start_no_earlier_than:
    case Constraint::must_start_on:
      return link;
    case Constraint::finish_no_earlier_than:
    case Constraint::must_finish_on:
      link.type = LinkType::FF;
      return link;
    default:
      return std::nullopt;
  }
}

std::optional<Moment> far_start(const Task& task, const Moment& start) {
  const auto begin = second_number(start.text), date = second_number(task.constraint_date.text);
  const bool starts = task.constraint == Constraint::start_no_earlier_than ||
                      task.constraint == Constraint::must_start_on;
  if (!starts || !begin || !date || *date <= *begin || constraint_link(task, start)) {
    return std::nullopt;
  }
  if (*date - *begin > kFarthestDate) return std::nullopt;
  return Moment{task.constraint_date.text.substr(0, 16)};
}

PlanNetwork plan_network(const Project& project, const Moment& start, Listing& listing,
                         const TaskParts& parts) {
  return NetworkBuilder(project, start, listing, parts).build();
}

}  // namespace rubicon::project_io
