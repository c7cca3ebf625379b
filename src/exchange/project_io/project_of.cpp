#include "src/exchange/project_io/project_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

#include "interpreter/syntax/attribute_text.hpp"
#include "src/exchange/project_io/carried_project.hpp"
#include "src/exchange/project_io/dates.hpp"
#include "src/exchange/project_io/left_out.hpp"
#include "src/exchange/project_io/plan_network.hpp"
#include "src/exchange/project_io/plan_terms.hpp"
#include "src/exchange/project_io/tidy_project.hpp"

namespace rubicon::project_io {

namespace {

using interpreter::PlanModel;
using interpreter::TaskSpec;

class ProjectBuilder {
 public:
  ProjectBuilder(const PlanModel& plan, const interpreter::SourceMap& sources,
                 interpreter::Diagnostics& diagnostics, const SimulatedRun* run)
      : plan_(plan),
        diagnostics_(diagnostics),
        run_(run),
        carried_(read_carried_project(carried_records(plan, sources), listing_)) {}

  Project build() {
    build_settings();
    build_calendars();
    build_resources();
    build_tasks();
    build_links();
    build_assignments();
    build_texts();
    list_left_out(plan_, specs_, run_ != nullptr, listing_);
    if (run_ != nullptr) take_run(*run_, planned_lines(), project_);
    tidy_project(project_, {}, listing_);
    listing_.report(diagnostics_);
    return std::move(project_);
  }

 private:
  // ---- settings, calendars, resources
  // ------------------------------------------------------------

  void build_settings() {
    project_ = carried_.project.value_or(Project{});
    if (!carried_.project) project_.name = plan_.name;
    start_ = plan_.start_at ? moment_at(0) : Moment{};
    const bool has_dates = std::any_of(plan_.tasks.begin(), plan_.tasks.end(),
                                       [](const TaskSpec& spec) { return spec.not_before > 0; });
    if (!plan_.start_at && has_dates) {
      start_ = moment_at(0);
      if (run_ == nullptr) {
        listing_.add("I09", "start", {},
                     "the plan has no start_at; its schedule begins at " + start_.text);
      }
    }
    Project with_tasks;
    with_tasks.start = project_.start;
    for (const auto& [name, carried] : carried_.tasks) with_tasks.tasks.push_back(carried.task);
    carried_start_ = plan_start(with_tasks);
    if (carried_start_ != start_) project_.start = start_;
    if (quoted(project_.currency_symbol) != "\"" + plan_.currency + "\"") {
      project_.currency_symbol = plan_.currency;
    }
  }

  void build_calendars() {
    std::map<std::string, const interpreter::CalendarSpec*> planned;
    for (const auto& spec : plan_.calendars) planned.emplace(spec.name, &spec);
    // All as the plan was written with them, so that base calendars can be looked up.
    Project carried_calendars;
    for (const auto& [name, carried] : carried_.calendars) {
      const auto found = planned.find(name);
      const Calendar& own = carried.calendar;
      carried_calendars.calendars.push_back(
          carried.whole || found == planned.end()
              ? own
              : calendar_of(plan_calendar(*found->second), own.uid, own.name));
    }
    // The days before the start were left out when the plan was written.
    const std::string from = carried_start_.text.substr(0, 10);
    for (const std::string& name : carried_.calendar_order) {
      const CarriedCalendar& carried = carried_.calendars.at(name);
      const auto found = planned.find(name);
      const auto said = plan_calendar(carried_calendars, carried.calendar, from);
      if (found == planned.end()) {
        // Not in the plan because it never works, or because somebody took it out.
        if (carried.whole && !said) push_calendar(name, carried.calendar);
        continue;
      }
      PlanCalendar now = plan_calendar(*found->second);
      planned.erase(found);
      if (said) now.special_days = said->special_days;
      if (said) now.cut = said->cut;
      if (carried.whole && said == now) {
        push_calendar(name, carried.calendar);
      } else {
        push_calendar(name, calendar_of(now, carried.calendar.uid, carried.calendar.name));
      }
    }
    for (const auto& spec : plan_.calendars) {
      if (!planned.contains(spec.name)) continue;
      push_calendar(spec.name,
                    calendar_of(plan_calendar(spec),
                                next_uid(project_.calendars, carried_.calendars), spec.name));
    }
  }

  void push_calendar(const std::string& name, const Calendar& calendar) {
    calendar_uid_[name] = calendar.uid;
    project_.calendars.push_back(calendar);
  }

  /// A number that neither an element nor the import block has.
  template <typename Element, typename Carried>
  std::int64_t next_uid(const std::vector<Element>& elements, const Carried& carried) {
    std::int64_t& last = last_uid_[&carried];
    if (last == 0) {
      for (const auto& [name, each] : carried) last = std::max(last, uid_of(each));
      for (const Element& each : elements) last = std::max(last, each.uid);
    }
    return ++last;
  }
  static std::int64_t uid_of(const CarriedCalendar& each) { return each.calendar.uid; }
  static std::int64_t uid_of(const CarriedTask& each) { return each.task.uid; }
  static std::int64_t uid_of(const Resource& each) { return each.uid; }

  std::int64_t uid_of_calendar(const std::string& name) const {
    const auto found = calendar_uid_.find(name);
    return found == calendar_uid_.end() ? kNone : found->second;
  }

  void build_resources() {
    std::map<std::string, std::size_t> crews, robots;
    for (std::size_t i = 0; i < plan_.crews.size(); ++i) crews.emplace(plan_.crews[i].name, i);
    for (std::size_t i = 0; i < plan_.robots.size(); ++i) robots.emplace(plan_.robots[i].name, i);
    // Of a resource that is several crews, any that is left stands for it.
    for (const auto& [crew, first] : carried_.crews_of) {
      const auto found = crews.find(crew);
      if (found != crews.end()) crews.emplace(first, found->second);
    }
    std::set<std::string> done;
    for (const std::string& name : carried_.resource_order) {
      Resource resource = carried_.resources.at(name);
      const auto crew = crews.find(name);
      const auto robot = robots.find(name);
      if (crew != crews.end()) {
        take_crew(plan_.crews[crew->second], resource);
      } else if (robot != robots.end()) {
        const auto& spec = plan_.robots[robot->second];
        take_terms(spec.cost_per_hour, spec.calendar, resource);
      } else if (resource.type == ResourceType::work) {
        continue;  // somebody took it out of the plan
      }
      if (!done.insert(name).second) continue;
      push_resource(name, resource);
    }
    const auto add_new = [&](const std::string& name) -> Resource {
      Resource resource;
      resource.uid = next_uid(project_.resources, carried_.resources);
      resource.name = name;
      return resource;
    };
    for (const auto& crew : plan_.crews) {
      if (done.contains(crew.name) || carried_.own_crews.contains(crew.name)) continue;
      const auto first = carried_.crews_of.find(crew.name);
      if (first != carried_.crews_of.end() && done.contains(first->second)) {
        resource_uid_[crew.name] = resource_uid_.at(first->second);
        continue;
      }
      Resource resource = add_new(crew.name);
      take_crew(crew, resource);
      push_resource(crew.name, resource);
    }
    for (const auto& robot : plan_.robots) {
      if (done.contains(robot.name) || plan_.short_form) continue;
      Resource resource = add_new(robot.name);
      take_terms(robot.cost_per_hour, robot.calendar, resource);
      push_resource(robot.name, resource);
    }
  }

  void take_crew(const interpreter::CrewSpec& crew, Resource& resource) {
    if (crew_size(resource) != crew.size) resource.max_units = crew.size;
    const auto freed = carried_.free_crews.find(crew.name);
    const bool free =
        freed != carried_.free_crews.end() && uid_of_calendar(crew.calendar) == freed->second;
    const std::int64_t calendar = resource.calendar;
    take_terms(crew.cost_per_hour, crew.calendar, resource, crew.size);
    if (free) resource.calendar = calendar;
  }

  /// A rate has been multiplied and written with digits: the last bit may differ.
  static bool same_cost(std::optional<double> usual, std::optional<double> now) {
    constexpr double kRounding = 1e-12;
    if (!usual || !now) return usual == now;
    return std::abs(*usual - *now) <= kRounding * *usual;
  }

  /// A schedule has the rate of one of a crew, a plan the cost of all.
  void take_terms(std::optional<double> cost, const std::string& calendar, Resource& resource,
                  double size = 1) {
    if (!same_cost(cost_per_hour(resource, size), cost)) {
      resource.standard_rate = cost.value_or(0) / std::max(size, 1.0);
      resource.rate_format = 2;
    }
    // The calendar that the plan would have written, if it is in the plan.
    std::int64_t usual = crew_calendar(project_, resource);
    const bool planned = std::any_of(
        plan_.calendars.begin(), plan_.calendars.end(),
        [&](const interpreter::CalendarSpec& spec) { return uid_of_calendar(spec.name) == usual; });
    if (!planned) usual = kNone;
    const std::int64_t now = uid_of_calendar(calendar);
    if (now != usual) resource.calendar = now;
  }

  void push_resource(const std::string& name, const Resource& resource) {
    resource_uid_[name] = resource.uid;
    project_.resources.push_back(resource);
  }

  // ---- tasks
  // -------------------------------------------------------------------------------------

  void build_tasks() {
    std::unordered_map<std::string, std::size_t> index;
    for (std::size_t i = 0; i < plan_.tasks.size(); ++i) index.emplace(plan_.tasks[i].name, i);
    // Lines in the order of the schedule; a task that is new in the plan behind the one before it.
    std::unordered_map<std::string, std::vector<std::size_t>> new_behind;
    std::string before;
    for (std::size_t i = 0; i < plan_.tasks.size(); ++i) {
      const std::string& name = plan_.tasks[i].name;
      if (carried_.milestones.contains(name)) continue;
      const auto carried = carried_.tasks.find(name);
      if (carried != carried_.tasks.end() && carried->second.planned) {
        before = name;
      } else {
        new_behind[before].push_back(i);
      }
    }
    int level = 1;
    for (const std::size_t i : new_behind[""]) push_new(i, level);
    for (const std::string& name : carried_.task_order) {
      CarriedTask& carried = carried_.tasks.at(name);
      const auto found = index.find(name);
      if (carried.planned && found == index.end()) continue;  // somebody took it out of the plan
      if (!task_uid_.emplace(name, carried.task.uid).second) continue;
      if (carried.planned) {
        take_name(plan_.tasks[found->second], carried.task);
        take_fixed(plan_.tasks[found->second], carried);
        if (!carried.fixed) take_duration(plan_.tasks[found->second], carried.task);
      }
      level = carried.task.level;
      push_task(carried.task, carried.planned ? &plan_.tasks[found->second] : nullptr, name);
      const auto more = new_behind.find(name);
      if (more == new_behind.end()) continue;
      for (const std::size_t i : more->second) push_new(i, std::max(level, 1));
    }
  }

  void push_task(const Task& task, const TaskSpec* spec, const std::string& name) {
    project_.tasks.push_back(task);
    specs_.push_back(spec);
    names_.push_back(name);
    if (spec == nullptr) return;
    take_dates(*spec, project_.tasks.back());
  }

  void push_new(std::size_t i, int level) {
    const TaskSpec& spec = plan_.tasks[i];
    Task task;
    task.uid = next_uid(project_.tasks, carried_.tasks);
    task.name = spec.name;
    take_name(spec, task);
    task.level = level;
    take_duration(spec, task);
    task.milestone = task.duration.seconds == 0 && !spec.move && !spec.go;
    task_uid_[spec.name] = task.uid;
    push_task(task, &spec, spec.name);
  }

  /// The client's own name, where the plan says another than it would say of `task`.
  static void take_name(const TaskSpec& spec, Task& task) {
    const std::string* name = interpreter::find_attribute(spec.attributes, "name");
    const std::string usual =
        interpreter::plain_attribute(interpreter::written_attribute(task.name));
    if (name != nullptr && *name != usual) task.name = *name;
  }

  /// So many ticks after the beginning; with seconds where it is not on the minute, rounded up.
  Moment moment_at(schedule::Ticks time) const {
    const schedule::Ticks seconds =
        time / schedule::kSecond + (time % schedule::kSecond > 0 ? 1 : 0);
    const schedule::CivilTime start = plan_.start_at.value_or(schedule::kUndatedStart);
    Moment moment{schedule::text_of(schedule::civil_time_at(start, seconds * schedule::kSecond))};
    if (seconds % 60 > 0) moment.text += fmt::format(":{:02}", seconds % 60);
    return moment;
  }

  void take_dates(const TaskSpec& spec, Task& task) const {
    if (spec.baseline) {
      task.baseline_start = moment_at(spec.baseline->start);
      task.baseline_finish = moment_at(spec.baseline->finish);
    }
    // A plan says a deadline to the minute: one that it does not change keeps its seconds.
    if (spec.due && !task.deadline.text.starts_with(moment_at(*spec.due).text)) {
      task.deadline = moment_at(*spec.due);
    }
  }

  static std::int64_t work_seconds(const TaskSpec& spec) {
    return std::llround(crew_seconds(spec));
  }

  /// A task that stands at its dates keeps them unless the plan says others: then it goes by links.
  void take_fixed(const TaskSpec& spec, CarriedTask& carried) {
    if (!carried.fixed) return;
    const bool moved =
        moment_at(spec.not_before) != moment_at(carried.fixed->start * schedule::kSecond);
    const bool longer = work_seconds(spec) != carried.fixed->takes;
    if (!moved && !longer) return;
    Task& task = carried.task;
    listing_.add(
        "I09", "fixed", spec.span,
        fmt::format("the dates of task '{}' in fact or by hand are left out: the plan says "
                    "others",
                    spec.name));
    if (moved) {
      task.actual_start = {};
      task.manual = false;
    }
    task.actual_finish = task.finish = {};
    if (longer) task.duration.seconds = work_seconds(spec);
    if (moved) carried.fixed.reset();
  }

  static void take_duration(const TaskSpec& spec, Task& task) {
    if (plan_seconds(task) != work_seconds(spec)) task.duration.seconds = work_seconds(spec);
  }

  // ---- links, assignments
  // ------------------------------------------------------------------------

  void build_links() {
    for (std::size_t i = 0; i < project_.tasks.size(); ++i)
      uid_index_.emplace(project_.tasks[i].uid, i);
    for (std::size_t i = 0; i < project_.tasks.size(); ++i) {
      Task& task = project_.tasks[i];
      const auto carried = carried_.tasks.find(names_[i]);
      std::map<std::pair<std::int64_t, LinkType>, Link> known;
      if (carried != carried_.tasks.end()) {
        for (const Link& each : carried->second.links) take_carried(each, i, known);
      }
      if (specs_[i] == nullptr) continue;
      bool has_begin = false;
      for (const interpreter::LinkSpec& link : specs_[i]->after) {
        const std::string& name = plan_.tasks[static_cast<std::size_t>(link.task)].name;
        has_begin = has_begin || (name == kPlanBegins && carried_.milestones.contains(name));
        if (carried_.milestones.contains(name)) {
          if (name == kPlanBegins) take_constraint(link, task);
          continue;
        }
        const auto uid = task_uid_.find(name);
        if (uid == task_uid_.end()) continue;
        const double exact = schedule::seconds_from_ticks(link.lag);
        const std::int64_t lag = std::llround(exact);
        constexpr std::int64_t kTenthOfMinute = 6;  // s
        const std::int64_t rounded = std::llround(exact / kTenthOfMinute) * kTenthOfMinute;
        Link made{uid->second, link.type, rounded, plan_lag_format(rounded)};
        const auto before = known.find({made.predecessor, made.type});
        if (before != known.end() &&
            plan_lag(project_, before->second, project_.tasks[uid_index_.at(made.predecessor)],
                     task) == lag) {
          made = before->second;
        } else if (static_cast<double>(rounded) != exact && run_ == nullptr) {
          listing_.add(
              "I09", "lag", specs_[i]->span,
              fmt::format("the lag of {} s from '{}' to '{}' is written as {} s: a schedule "
                          "has tenths of minutes",
                          exact, name, specs_[i]->name, rounded));
        }
        task.after.push_back(made);
      }
      if (carried != carried_.tasks.end()) take_held(carried->second.held, task);
      if (carried != carried_.tasks.end() && carried->second.fixed) continue;
      // The link that kept the constraint is gone: so is the constraint.
      if (!has_begin && constraint_link(task, carried_start_)) {
        task.constraint = Constraint::as_soon_as_possible;
        task.constraint_date = {};
      }
      take_not_before(*specs_[i], task);
    }
    for (const TaskSpec& spec : plan_.tasks) {
      if (spec.not_before <= 0 || !carried_.milestones.contains(spec.name)) continue;
      listing_.add("I09", "not_before", spec.span,
                   fmt::format("the not_before of '{}' is left out: the schedule has no such task",
                               spec.name));
    }
  }

  /// Links to a task that stands at its dates, unless the plan says them now.
  void take_held(const std::vector<Link>& held, Task& task) const {
    for (const Link& link : held) {
      const bool said = std::any_of(task.after.begin(), task.after.end(), [&](const Link& each) {
        return each.predecessor == link.predecessor && each.type == link.type;
      });
      if (!said && uid_index_.contains(link.predecessor)) task.after.push_back(link);
    }
  }

  /// A task has one constraint: a `not_before` takes the place of one that does not imply it.
  void take_not_before(const TaskSpec& spec, Task& task) {
    if (spec.not_before <= 0) return;
    const Moment date = moment_at(spec.not_before);
    const bool starts = task.constraint == Constraint::start_no_earlier_than;
    const auto held = second_number(task.constraint_date.text), now = second_number(date.text);
    if ((starts || task.constraint == Constraint::must_start_on) && held >= now) return;
    if (!starts && task.constraint != Constraint::as_soon_as_possible) {
      listing_.add("I09", "constraint", spec.span,
                   fmt::format("the other constraint of task '{}' is left out: a schedule has one "
                               "for each task, and not_before takes its place",
                               spec.name));
    }
    task.constraint = Constraint::start_no_earlier_than;
    task.constraint_date = date;
  }

  /// A carried link holds by itself where the plan has no task for one of its ends; else it only
  /// says how the plan's link is written.
  void take_carried(const Link& link, std::size_t i,
                    std::map<std::pair<std::int64_t, LinkType>, Link>& known) {
    const auto from = uid_index_.find(link.predecessor);
    if (from == uid_index_.end()) return;  // somebody took the predecessor out of the plan
    if (specs_[i] == nullptr || specs_[from->second] == nullptr) {
      project_.tasks[i].after.push_back(link);
    } else {
      known[{link.predecessor, link.type}] = link;
    }
  }

  void take_constraint(const interpreter::LinkSpec& link, Task& task) {
    const auto usual = constraint_link(task, start_);
    const std::int64_t lag = std::llround(schedule::seconds_from_ticks(link.lag));
    if (usual && usual->type == link.type && usual->lag == lag) return;
    const auto begin = minute_number(start_.text);
    if (!begin || (link.type != LinkType::FS && link.type != LinkType::FF)) return;
    task.constraint = link.type == LinkType::FS ? Constraint::start_no_earlier_than
                                                : Constraint::finish_no_earlier_than;
    task.constraint_date = {moment_text(*begin + lag / 60)};
  }

  void build_assignments() {
    // Who the plan says works on what; taken out one by one.
    std::set<std::pair<std::int64_t, std::int64_t>> said;
    std::vector<std::pair<std::int64_t, std::int64_t>> order;
    struct People {
      double count = 1;
      double size = 1;  ///< of their crew
    };
    std::map<std::pair<std::int64_t, std::int64_t>, People> units;
    const auto say = [&](std::int64_t task, const std::string& name) {
      const auto resource = resource_uid_.find(name);
      if (resource == resource_uid_.end()) return;
      if (said.emplace(task, resource->second).second) order.emplace_back(task, resource->second);
    };
    const auto say_crew = [&](std::int64_t task, const TaskSpec& spec, int index) {
      const interpreter::CrewSpec& crew = plan_.crews[static_cast<std::size_t>(index)];
      say(task, crew.name);
      const auto resource = resource_uid_.find(crew.name);
      if (resource == resource_uid_.end()) return;
      People people{crew.size, crew.size};
      for (const auto& need : spec.needs) {
        if (need.crew == index) people.count = need.people;
      }
      units[{task, resource->second}] = people;
    };
    std::set<std::int64_t> planned, workers;
    for (std::size_t i = 0; i < project_.tasks.size(); ++i) {
      if (specs_[i] == nullptr) continue;
      const std::int64_t task = project_.tasks[i].uid;
      // What runs day and night has nobody in the plan, and keeps those it had.
      const bool nobody = specs_[i]->crews.empty() && specs_[i]->robot < 0;
      const auto carried = carried_.tasks.find(names_[i]);
      const bool keeps = runs_day_and_night(project_.tasks[i]) ||
                         (carried != carried_.tasks.end() && carried->second.fixed);
      if (!nobody || !keeps) planned.insert(task);
      for (const int crew : specs_[i]->crews) say_crew(task, *specs_[i], crew);
      if (specs_[i]->robot >= 0) {
        say(task, plan_.robots[static_cast<std::size_t>(specs_[i]->robot)].name);
      }
      for (const int robot : specs_[i]->also_robots) {
        say(task, plan_.robots[static_cast<std::size_t>(robot)].name);
      }
      for (const auto* work : {&specs_[i]->hook, &specs_[i]->adjust, &specs_[i]->release}) {
        if (*work && (*work)->crew >= 0) say_crew(task, *specs_[i], (*work)->crew);
      }
    }
    for (const Resource& resource : project_.resources) {
      if (resource.type == ResourceType::work) workers.insert(resource.uid);
    }
    std::int64_t last = 0;
    std::set<std::pair<std::int64_t, std::int64_t>> kept;
    std::set<std::int64_t> known;
    for (const Resource& resource : project_.resources) known.insert(resource.uid);
    std::map<std::pair<std::int64_t, std::int64_t>, double> carried_units;
    for (const Assignment& each : carried_.assignments) {
      carried_units[{each.task, each.resource}] += each.units;
    }
    for (const Assignment& each : carried_.assignments) {
      const std::pair pair(each.task, each.resource);
      last = std::max(last, each.uid);
      if (!uid_index_.contains(each.task)) continue;
      if (each.resource != kNone && !known.contains(each.resource)) continue;
      const bool in_plan = planned.contains(each.task) && workers.contains(each.resource);
      if (in_plan && !said.contains(pair)) continue;  // somebody took it out of the plan
      const bool is_first = kept.insert(pair).second;
      project_.assignments.push_back(each);
      const auto people = units.find(pair);
      // What the plan rounds comes back as it was.
      if (people == units.end() ||
          crew_people(carried_units.at(pair), people->second.size) == people->second.count) {
        continue;
      }
      project_.assignments.back().units = is_first ? people->second.count : 0;
    }
    for (const auto& pair : order) {
      if (kept.contains(pair)) continue;
      Assignment assignment;
      assignment.uid = ++last;
      assignment.task = pair.first;
      assignment.resource = pair.second;
      const auto people = units.find(pair);
      if (people != units.end()) assignment.units = people->second.count;
      project_.assignments.push_back(assignment);
    }
  }

  /// The attributes of each task and of what it moves, but for names, in columns of their own.
  void build_texts() {
    for (std::size_t i = 0; i < project_.tasks.size(); ++i) {
      if (specs_[i] == nullptr) continue;
      const TaskSpec& spec = *specs_[i];
      take_texts(spec.attributes, spec, project_.tasks[i]);
      if (!spec.move) continue;
      take_texts(plan_.components[static_cast<std::size_t>(*spec.move)].attributes, spec,
                 project_.tasks[i]);
    }
  }

  void take_texts(const interpreter::Attributes& attributes, const TaskSpec& spec, Task& task) {
    std::vector<std::string>& fields = project_.text_fields;
    for (const auto& [key, text] : attributes) {
      if (key == "name") continue;
      const auto known = std::find(fields.begin(), fields.end(), key);
      const int field = static_cast<int>(known - fields.begin());
      if (known == fields.end()) {
        if (fields.size() == kMostTextFields) {
          listing_.add("I09", "attribute", spec.span,
                       fmt::format("the attribute '{}' of task '{}' is left out: a schedule has {} "
                                   "columns for texts",
                                   key, spec.name, kMostTextFields));
          continue;
        }
        fields.push_back(key);
      }
      const bool said = std::any_of(task.texts.begin(), task.texts.end(),
                                    [&](const auto& each) { return each.first == field; });
      if (!said) task.texts.emplace_back(field, text);
    }
  }

  /// The lines as the plan has them. A line that is done in parts has a task that moves something
  /// for each, which waits for the line to begin.
  std::vector<PlannedLine> planned_lines() const {
    std::unordered_map<std::string, std::vector<std::string>> waiting;
    for (const TaskSpec& spec : plan_.tasks) {
      if (!spec.move) continue;
      for (const interpreter::LinkSpec& link : spec.after) {
        waiting[plan_.tasks[static_cast<std::size_t>(link.task)].name].push_back(spec.name);
      }
    }
    std::vector<PlannedLine> lines;
    for (const std::string& name : names_) lines.push_back({name, waiting[name + "_begins"]});
    return lines;
  }

  const PlanModel& plan_;
  interpreter::Diagnostics& diagnostics_;
  const SimulatedRun* run_;  ///< null: the schedule is that of the plan
  Listing listing_;
  CarriedProject carried_;
  Project project_;
  Moment start_;          ///< of the plan
  Moment carried_start_;  ///< of the plan as it was written

  std::map<std::string, std::int64_t> calendar_uid_, resource_uid_;
  std::unordered_map<std::string, std::int64_t> task_uid_;
  std::unordered_map<std::int64_t, std::size_t> uid_index_;
  std::map<const void*, std::int64_t> last_uid_;
  std::vector<const TaskSpec*>
      specs_;                       ///< of each line; null for those that the plan has no task for
  std::vector<std::string> names_;  ///< of each line
};

}  // namespace

Project project_of(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
                   interpreter::Diagnostics& diagnostics, const SimulatedRun* run) {
  return ProjectBuilder(plan, sources, diagnostics, run).build();
}

}  // namespace rubicon::project_io
