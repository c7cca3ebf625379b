#include "src/exchange/project_io/plan_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <unordered_map>

#include "interpreter/parse/parse.hpp"
#include "interpreter/syntax/attribute_text.hpp"
#include "interpreter/syntax/token.hpp"
#include "src/exchange/project_io/carried.hpp"
#include "src/exchange/project_io/carried_project.hpp"
#include "src/exchange/project_io/dates.hpp"
#include "src/exchange/project_io/fixed_dates.hpp"
#include "src/exchange/project_io/identifiers.hpp"
#include "src/exchange/project_io/listing.hpp"
#include "src/exchange/project_io/plan_crews.hpp"
#include "src/exchange/project_io/plan_network.hpp"
#include "src/exchange/project_io/plan_terms.hpp"
#include "src/exchange/project_io/working_time.hpp"

namespace rubicon::project_io {

namespace {

/// Longest remark, in bytes; the whole name stands in the import block.
constexpr std::size_t kMaxRemark = 90;

/// A name for a remark: one line, not too long.
std::string remark(std::string_view name) {
  std::string text;
  for (const char c : name) text += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
  while (!text.empty() && text.back() == ' ') text.pop_back();
  if (text.size() <= kMaxRemark) return text;
  std::size_t end = kMaxRemark;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0u) == 0x80u) --end;
  return text.substr(0, end) + "...";
}

/// Seconds in the largest unit that says them exactly.
std::string time_text(std::int64_t seconds) {
  if (seconds % 3600 == 0 && seconds != 0) return fmt::format("{} h", seconds / 3600);
  if (seconds % 60 == 0 && seconds != 0) return fmt::format("{} min", seconds / 60);
  return fmt::format("{} s", seconds);
}

std::string link_text(const PlanLink& link) {
  std::string text = link.predecessor;
  if (link.type != LinkType::FS || link.lag != 0) {
    text += fmt::format(" {}", schedule::name_of(link.type));
  }
  if (link.lag != 0) {
    text += fmt::format(" {} {}", link.lag < 0 ? '-' : '+', time_text(std::abs(link.lag)));
  }
  return text;
}

std::string links_text(const std::vector<PlanLink>& links) {
  if (links.empty()) return {};
  std::string text = "after ";
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (i > 0) text += ", ";
    text += link_text(links[i]);
  }
  return text + ";\n";
}

/// Whether a name can be guessed from its identifier, so that it need not be said.
bool says(const std::string& identifier, std::string_view name) {
  return std::equal(identifier.begin(), identifier.end(), name.begin(), name.end(),
                    [](char a, char b) {
                      if (b >= 'A' && b <= 'Z') b = static_cast<char>(b - 'A' + 'a');
                      return a == b || (a == '_' && b == ' ');
                    });
}

template <typename Record>
CarriedWriter fields_of(const Record& record) {
  CarriedWriter writer;
  if constexpr (std::is_same_v<Record, Project>) visit_project(record, writer);
  if constexpr (std::is_same_v<Record, Task>) visit_task(record, writer);
  if constexpr (std::is_same_v<Record, Resource>) visit_resource(record, writer);
  if constexpr (std::is_same_v<Record, Assignment>) visit_assignment(record, writer);
  return writer;
}

class PlanWriter {
 public:
  PlanWriter(const Project& project, const std::string& file, const PlanInsert& insert,
             Levelling levelling, Baselines baselines, interpreter::Diagnostics& diagnostics)
      : project_(project),
        file_(file),
        insert_(insert),
        levelling_(levelling),
        baselines_(baselines),
        diagnostics_(diagnostics),
        start_(plan_start(project)) {}

  std::string write() {
    network_ = plan_network(project_, start_, listing_, part_names());
    for (const std::string& name : insert_.calendars) calendar_names_.reserve(name);
    for (const std::string& name : insert_.workers) crew_names_.reserve(name);
    for (std::size_t i = 0; i < project_.tasks.size(); ++i) {
      task_index_.emplace(project_.tasks[i].uid, i);
    }
    const std::string name = Identifiers().make(project_.name, "schedule");
    out_ = fmt::format("plan {} {{\n", name);
    if (!start_.text.empty()) out_ += fmt::format("start_at \"{}\";\n", start_.text);
    if (!project_.currency_symbol.empty()) {
      out_ += fmt::format("currency {};\n", quoted(project_.currency_symbol));
    }
    write_calendars();
    crews_ = plan_crews(project_, network_, levelling_, crew_names_);
    write_crews();
    out_ += insert_.items;
    write_tasks();
    write_carried(name);
    out_ += "}\n";
    listing_.report(diagnostics_);
    return interpreter::format_text(out_, interpreter::TextKind::plan);
  }

 private:
  // ---- what the plan says
  // ------------------------------------------------------------------------

  TaskParts part_names() const {
    TaskParts names;
    for (const auto& [uid, parts] : insert_.parts) {
      for (const PlanInsert::Part& part : parts) names[uid].push_back({part.name, part.awaited});
    }
    return names;
  }

  void write_calendars() {
    for (const Calendar& calendar : project_.calendars) {
      const std::string name =
          calendar_names_.make(calendar.name, fmt::format("calendar_{}", calendar.uid));
      calendar_name_.emplace(calendar.uid, name);
      const auto plan = plan_calendar(project_, calendar, start_.text.substr(0, 10));
      if (!plan) {
        listing_.add("I08", "idle calendar", {},
                     fmt::format("calendar '{}' never works: it is carried along, and who has it "
                                 "works at any time in the plan",
                                 calendar.name));
        continue;
      }
      planned_calendars_.emplace(calendar.uid, *plan);
      list_doubts(calendar, *plan);
      out_ += fmt::format("\n{}calendar {} {{\n", remark_line(name, calendar.name), name);
      write_week(plan->week);
      write_off(plan->off);
      out_ += "}\n";
    }
  }

  void list_doubts(const Calendar& calendar, const PlanCalendar& plan) {
    if (plan.special_days > 0) {
      listing_.add("I08", "special days", {},
                   fmt::format("{} days of calendar '{}' have hours of their own: in the plan they "
                               "have those of the week",
                               plan.special_days, calendar.name));
    }
    if (plan.cut) {
      listing_.add("I08", "cut", {},
                   fmt::format("calendar '{}' has too many days off for a plan; the last ones are "
                               "carried along",
                               calendar.name));
    }
  }

  static std::string remark_line(const std::string& identifier, const std::string& name) {
    const std::string text = remark(name);
    return text.empty() || says(identifier, text) ? std::string() : "// " + text + "\n";
  }

  void write_week(const std::array<DayTimes, 7>& week) {
    for (std::size_t day = 0; day < 7;) {
      std::size_t last = day;
      while (last + 1 < 7 && week[last + 1] == week[day]) ++last;
      if (!week[day].empty()) {
        std::string times = text_of(week[day]);
        for (std::size_t at = 0; (at = times.find(',', at)) != std::string::npos; at += 2) {
          times.insert(at + 1, " ");
        }
        out_ += last == day ? fmt::format("{} {};\n", kDays[day], times)
                            : fmt::format("{}-{} {};\n", kDays[day], kDays[last], times);
      }
      day = last + 1;
    }
  }

  void write_off(const std::vector<std::string>& off) {
    if (!off.empty()) out_ += fmt::format("off {};\n", fmt::join(off, ", "));
  }

  void write_crews() {
    if (!project_.resources.empty()) out_ += '\n';
    for (std::size_t i = 0; i < project_.resources.size(); ++i) {
      const Resource& resource = project_.resources[i];
      const std::vector<std::string>& names = crews_.names[i];
      if (resource.type != ResourceType::work) {
        listing_.add("I08", "material", {},
                     fmt::format("resource '{}' is a material or a cost: it is carried along, the "
                                 "plan knows people and machines only",
                                 resource.name));
        continue;
      }
      out_ += remark_line(names.front(), resource.name);
      if (names.size() > 1) {
        out_ += fmt::format(
            "// {} crews: the links let so many of its tasks meet, and none waits\n", names.size());
      }
      const double size = crew_size(resource);
      std::string terms;
      if (size != 1) terms += fmt::format("size {};\n", size);
      if (size != resource.max_units) {
        listing_.add("I08", "max units", {},
                     fmt::format("there are {} of '{}': in the plan it is a crew of {}",
                                 resource.max_units, resource.name, size));
      }
      if (const auto cost = cost_per_hour(resource, size)) {
        terms += fmt::format("cost {} per h;\n", *cost);
      } else if (resource.standard_rate != 0) {
        listing_.add("I08", "rate", {},
                     fmt::format("the rate of '{}' is not a cost by time: it is carried along",
                                 resource.name));
      }
      const std::int64_t calendar = crew_calendar(project_, resource);
      for (const std::string& name : names) {
        out_ += fmt::format("crew {} {{\n{}", name, terms);
        const auto free = crews_.free.find(name);
        const std::int64_t hours = free == crews_.free.end() ? calendar : free->second;
        if (free != crews_.free.end() && hours == kNone && !terms.empty()) {
          listing_.add("I08", "nights", {},
                       fmt::format("the tasks of '{}' have different hours: in the plan it has no "
                                   "calendar, and its cost counts nights and weekends too",
                                   name));
        }
        if (planned_calendars_.contains(hours)) {
          out_ += fmt::format("calendar {};\n", calendar_name_.at(hours));
        }
        out_ += "}\n";
      }
    }
  }

  void write_tasks() {
    for (const PlanCrews::Apart& each : crews_.apart) {
      listing_.add(
          "I08", "hours apart", {},
          fmt::format("'{}' has no hour in common with the others on task '{}': in the "
                      "plan it is there in their hours",
                      project_.resources[each.resource].name, project_.tasks[each.task].name));
    }
    std::size_t milestone = 0;
    const auto write_milestones = [&](std::size_t until) {
      for (;
           milestone < network_.milestones.size() && network_.milestones[milestone].before <= until;
           ++milestone) {
        const PlanMilestone& each = network_.milestones[milestone];
        if (each.ends) write_parts(each.before, network_.milestones[milestone - 1].name);
        out_ += fmt::format("task {} {{\ntakes 0 s;\n{}}}\n", each.name, links_text(each.after));
      }
    };
    out_ += '\n';
    for (std::size_t i = 0; i < project_.tasks.size(); ++i) {
      const PlanTask& planned = network_.tasks[i];
      if (!planned.planned) write_heading(project_.tasks[i], planned.in_parts);
      write_milestones(i);
      if (network_.tasks[i].planned) write_task(i);
    }
    write_milestones(SIZE_MAX);
  }

  /// What is done in place of a line's duration, behind the milestone at which that begins.
  void write_parts(std::size_t i, const std::string& begins) {
    for (const PlanInsert::Part& part : insert_.parts.at(project_.tasks[i].uid)) {
      out_ += fmt::format("task {} {{\n{}after {};\n}}\n", part.name, part.items, begins);
    }
  }

  /// A line that is no task: a heading, a remark, or a task that is done in parts.
  void write_heading(const Task& task, bool in_parts) {
    const std::string text = remark(task.name);
    out_ += '\n';
    if (in_parts) {
      const std::size_t count = insert_.parts.at(task.uid).size();
      out_ += fmt::format("// {} ({} part{}; {} in the schedule)\n", text, count,
                          count == 1 ? "" : "s", time_text(plan_seconds(task)));
      return;
    }
    if (text.empty()) return;
    const auto level = static_cast<std::size_t>(std::max(task.level, 1));
    out_ += fmt::format("// {} {}{}\n", std::string(level, '='), text,
                        task.active ? "" : " (not active)");
  }

  void write_task(std::size_t i) {
    const Task& task = project_.tasks[i];
    const PlanTask& planned = network_.tasks[i];
    std::vector<std::string> by, needs;
    for (const PlanWorker& worker : crews_.of_task[i]) by.push_back(worker.crew);
    const std::optional<FixedDates> dates = fixed_dates(task, start_);
    std::int64_t seconds = plan_seconds(task);
    bool has_shifts = true;
    if (dates) take_fixed(i, *dates, seconds, has_shifts);
    if (!has_shifts) by.clear();
    if (runs_day_and_night(task) && !by.empty()) {
      listing_.add("I08", "elapsed", {},
                   fmt::format("task '{}' runs day and night, whatever the shifts of those on it: "
                               "in the plan nobody is; who it is is carried along",
                               task.name));
      by.clear();
    }
    const bool has_workers = !by.empty();
    const std::vector<std::string> own =
        has_shifts ? own_calendars(i, !by.empty()) : std::vector<std::string>();
    for (const std::string& calendar : own) {
      const std::string name = crew_names_.make("crew_" + planned.name, "crew_" + planned.name);
      out_ += fmt::format("crew {} {{ calendar {}; }}\n", name, calendar);
      own_crews_.push_back(name);
      by.push_back(name);
    }
    out_ += fmt::format("task {} {{\n", planned.name);
    const std::string client_name = interpreter::written_attribute(task.name);
    if (!client_name.empty() && !says(planned.name, client_name)) {
      out_ += fmt::format("name \"{}\";\n", client_name);
    }
    if (!by.empty()) out_ += fmt::format("by {};\n", fmt::join(by, ", "));
    if (has_workers) needs = needs_of(i);
    out_ += fmt::format("takes {};\n", time_text(seconds));
    if (!needs.empty()) out_ += fmt::format("needs {};\n", fmt::join(needs, ", "));
    if (!dates && plan_seconds(task) != task.duration.seconds) {
      listing_.add("I08", "long task", {},
                   fmt::format("task '{}' takes longer than a plan can say", task.name));
    }
    if (dates) {
      write_fixed_start(planned.name, *dates, seconds);
    } else if (const auto date = far_start(task, start_)) {
      out_ += fmt::format("not_before \"{}\";\n", date->text);
    }
    if (baselines_ == Baselines::written) write_dates(task);
    out_ += links_text(planned.after);
    if (!dates && constraint_link(task, start_)) {
      out_ += fmt::format(
          "// not {} {}\n",
          constraint_link(task, start_)->type == LinkType::FS ? "before" : "finished before",
          task.constraint_date.text);
    }
    out_ += "}\n";
  }

  /// How many of its crews a task needs, where not all of them.
  std::vector<std::string> needs_of(std::size_t i) {
    std::vector<std::string> needs;
    for (const PlanWorker& worker : crews_.of_task[i]) {
      const Resource& resource = project_.resources[worker.resource];
      const double size = crew_size(resource), people = crew_people(worker.units, size);
      if (people != worker.units) {
        listing_.add("I08", "units", {},
                     fmt::format("{} of '{}' {} on '{}': in the plan {}, of whom the cost is",
                                 worker.units, resource.name, worker.units == 1 ? "is" : "are",
                                 project_.tasks[i].name, people));
      }
      if (people < size) needs.push_back(fmt::format("{} {}", people, worker.crew));
    }
    return needs;
  }

  /// How long a task takes that stands at its dates, and whether in the shifts of those on it: if
  /// these do not begin and end with the dates, nobody is on it.
  void take_fixed(std::size_t i, const FixedDates& dates, std::int64_t& seconds, bool& has_shifts) {
    const Task& task = project_.tasks[i];
    if (!dates.finish) {
      const FixedDates first_second{dates.start, dates.start + 1};
      if (seconds == 0 || runs_day_and_night(task) ||
          work_between(first_second, calendars_on(i), start_)) {
        return;
      }
      listing_.add(
          "I08", "begins out of shift", {},
          fmt::format("task '{}' begins when those on it have no shift: in the plan it "
                      "begins with the next, because the schedule does not say when it ends",
                      task.name));
      return;
    }
    const std::int64_t whole = *dates.finish - dates.start;
    const auto work = runs_day_and_night(task) ? std::optional(whole)
                                               : work_between(dates, calendars_on(i), start_);
    has_shifts = work.has_value();
    seconds = std::min(work.value_or(whole), static_cast<std::int64_t>(kMaxPlanSeconds));
    if (work || whole == 0 || crews_.of_task[i].empty()) return;
    listing_.add("I08", "out of shift", {},
                 fmt::format("task '{}' begins or ends when those on it have no shift: in the plan "
                             "nobody is on it, and it lasts as long as there; who it is is carried "
                             "along",
                             task.name));
  }

  /// The calendars that hold together for a task, as the plan has them.
  std::vector<PlanCalendar> calendars_on(std::size_t i) const {
    std::set<std::int64_t> uids;
    for (const PlanWorker& worker : crews_.of_task[i]) {
      if (crews_.free.contains(worker.crew)) continue;
      uids.insert(crew_calendar(project_, project_.resources[worker.resource]));
    }
    for (const std::int64_t uid : own_calendar_uids(i, !crews_.of_task[i].empty())) {
      uids.insert(uid);
    }
    std::vector<PlanCalendar> calendars;
    for (const std::int64_t uid : uids) {
      const auto found = planned_calendars_.find(uid);
      if (found != planned_calendars_.end()) calendars.push_back(found->second);
    }
    return calendars;
  }

  /// As a date; where that is not on the minute, as a time behind the beginning of the plan.
  void write_fixed_start(const std::string& name, const FixedDates& dates, std::int64_t seconds) {
    std::int64_t start = dates.start;
    const bool to_the_second = start % 60 != 0 && static_cast<double>(start) <= kMaxPlanSeconds;
    if (!to_the_second) start -= start % 60;
    if (to_the_second) {
      out_ += fmt::format("not_before {};\n", time_text(start));
    } else if (start > 0) {
      out_ += fmt::format("not_before \"{}\";\n",
                          moment_text(*minute_number(start_.text) + start / 60));
    }
    fixed_ += fmt::format("fixed {} start {} takes {};\n", name, start, seconds);
  }

  /// To the minute, as plans have it.
  void write_dates(const Task& task) {
    constexpr std::size_t kToTheMinute = 16;  // YYYY-MM-DD HH:MM
    const auto minute = [](const Moment& moment) { return moment.text.substr(0, kToTheMinute); };
    const bool has_baseline =
        !task.baseline_start.text.empty() && !task.baseline_finish.text.empty();
    const std::string start = minute(has_baseline ? task.baseline_start : task.start);
    const std::string finish = minute(has_baseline ? task.baseline_finish : task.finish);
    if (!task.deadline.text.empty()) out_ += fmt::format("due \"{}\";\n", minute(task.deadline));
    if (start.empty() || finish < start) return;
    out_ += fmt::format("baseline \"{}\" to \"{}\";\n", start, finish);
  }

  /// The calendars for crews that the task has to itself: its own, or the project's where nobody's
  /// would hold; and those of resources whose crews are free of theirs for the sake of other tasks.
  std::vector<std::string> own_calendars(std::size_t i, bool has_crew) const {
    std::vector<std::string> names;
    for (const std::int64_t each : own_calendar_uids(i, has_crew)) {
      if (planned_calendars_.contains(each)) names.push_back(calendar_name_.at(each));
    }
    return names;
  }
  std::vector<std::int64_t> own_calendar_uids(std::size_t i, bool has_crew) const {
    const Task& task = project_.tasks[i];
    if (plan_seconds(task) == 0 || runs_day_and_night(task)) return {};
    std::vector<std::int64_t> calendars;
    if (task.calendar != kNone) {
      calendars.push_back(task.calendar);
    } else if (!has_crew) {
      calendars.push_back(project_.calendar);
    }
    for (const std::int64_t each : crews_.calendars[i]) {
      if (std::find(calendars.begin(), calendars.end(), each) == calendars.end()) {
        calendars.push_back(each);
      }
    }
    return calendars;
  }

  // ---- what is carried along
  // ---------------------------------------------------------------------

  void write_carried(const std::string& plan_name) {
    out_ += fmt::format(
        "\n// For the way back to the schedule's own program: what a plan has no word for.\n"
        "import {} as schedule {{\n",
        quoted(file_.empty() ? "schedule" : file_));
    out_ += fmt::format("project {}{};\n", plan_name,
                        fields_of(project_).changed(fields_of(Project())));
    for (const Calendar& calendar : project_.calendars) carry_calendar(calendar);
    const CarriedWriter usual_resource = fields_of(Resource());
    for (std::size_t i = 0; i < project_.resources.size(); ++i) {
      const std::vector<std::string>& names = crews_.names[i];
      out_ += fmt::format("resource {}{};\n", names.front(),
                          fields_of(project_.resources[i]).changed(usual_resource));
      for (std::size_t k = 1; k < names.size(); ++k) {
        out_ += fmt::format("crew_of {} resource {};\n", names[k], quoted(names.front()));
      }
    }
    for (const PlanMilestone& each : network_.milestones) {
      out_ += fmt::format("milestone {}", each.name);
      // The one of the whole plan belongs to no line; there may be none.
      if (each.name != kPlanBegins) {
        const std::string& line = network_.tasks[each.before].name;
        if (each.name != usual_milestone(line, each.at_end)) {
          out_ += fmt::format(" {} {}", each.at_end ? "ends" : "begins", quoted(line));
        }
      }
      out_ += ";\n";
    }
    for (const auto& [uid, parts] : insert_.parts) {
      for (const PlanInsert::Part& part : parts) {
        out_ += fmt::format("milestone {};\n", part.name);
      }
    }
    for (const auto& [name, calendar] : crews_.free) {
      out_ += fmt::format("free_crew {}", name);
      if (planned_calendars_.contains(calendar)) out_ += fmt::format(" calendar {}", calendar);
      out_ += ";\n";
    }
    for (const std::string& name : own_crews_) out_ += fmt::format("own_crew {};\n", name);
    carry_tasks();
    out_ += fixed_;
    const CarriedWriter usual_assignment = fields_of(Assignment());
    for (const Assignment& each : project_.assignments) {
      out_ += fmt::format("assignment {}{};\n", network_.tasks[task_index_.at(each.task)].name,
                          fields_of(each).changed(usual_assignment));
    }
    out_ += "}\n";
  }

  void carry_calendar(const Calendar& calendar) {
    const std::string& name = calendar_name_.at(calendar.uid);
    out_ += fmt::format("calendar {} uid {} name {}", name, calendar.uid, quoted(calendar.name));
    if (calendar.base != kNone) out_ += fmt::format(" base {}", calendar.base);
    const auto plan = plan_calendar(project_, calendar, start_.text.substr(0, 10));
    if (plan && calendar_of(*plan, calendar.uid, calendar.name) == calendar) {
      out_ += ";\n";
      return;
    }
    out_ += " whole 1;\n";
    out_ += "week " + name;
    for (std::size_t day = 0; day < 7; ++day) {
      if (calendar.week[day]) {
        out_ += fmt::format(" {} {}", kDays[day], quoted(text_of(*calendar.week[day])));
      }
    }
    out_ += ";\n";
    if (calendar.exceptions.empty()) return;
    out_ += "exceptions " + name;
    for (const CalendarException& each : calendar.exceptions) {
      std::string text = each.first;
      if (each.last != each.first) text += ".." + each.last;
      if (!each.times.empty()) text += "=" + text_of(each.times);
      if (!each.name.empty()) text += "|" + each.name;
      out_ += " " + quoted(text);
    }
    out_ += ";\n";
  }

  void carry_tasks() {
    const CarriedWriter usual = fields_of(Task());
    for (std::size_t i = 0; i < project_.tasks.size(); ++i) {
      const PlanTask& planned = network_.tasks[i];
      Task task = project_.tasks[i];
      // What the plan says need not be said twice.
      const bool is_said = planned.planned && !fixed_dates(task, start_) &&
                           plan_seconds(task) == task.duration.seconds;
      if (is_said) task.duration = {};
      out_ += fmt::format("{} {}{};\n", planned.planned ? "task" : "row", planned.name,
                          fields_of(task).changed(usual));
      for (std::size_t k = 0; k < task.after.size(); ++k) {
        if (planned.said[k]) continue;
        const Link& link = task.after[k];
        out_ += fmt::format("link {} predecessor {} type \"{}\" lag \"{}\" format \"{}\"{};\n",
                            planned.name, link.predecessor, schedule::name_of(link.type), link.lag,
                            text_of(link.format), planned.held[k] ? " held 1" : "");
      }
    }
  }

  const Project& project_;
  const std::string& file_;
  const PlanInsert& insert_;
  const Levelling levelling_;
  const Baselines baselines_;
  interpreter::Diagnostics& diagnostics_;
  const Moment start_;
  Listing listing_;
  PlanNetwork network_;
  std::string out_;
  Identifiers calendar_names_, crew_names_;
  std::unordered_map<std::int64_t, std::string> calendar_name_;
  std::unordered_map<std::int64_t, PlanCalendar> planned_calendars_;
  std::unordered_map<std::int64_t, std::size_t> task_index_;
  PlanCrews crews_;
  std::vector<std::string> own_crews_;
  std::string fixed_;  ///< what the import block says of tasks that stand at their dates
};

}  // namespace

std::string plan_text(const Project& project, const std::string& file,
                      interpreter::Diagnostics& diagnostics, const PlanInsert& insert,
                      Levelling levelling, Baselines baselines) {
  return PlanWriter(project, file, insert, levelling, baselines, diagnostics).write();
}

}  // namespace rubicon::project_io
