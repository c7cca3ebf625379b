#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "src/results/report/columns.hpp"
#include "src/results/report/earthwork.hpp"
#include "src/results/report/schedule_text.hpp"
#include "src/simulation/schedule/civil_time.hpp"
#include "src/simulation/trace/json_builder.hpp"

namespace rubicon::report {

namespace {

using interpreter::Ticks;
using taskplan::CostKind;
using taskplan::ResourceUse;
using taskplan::Schedule;
using taskplan::TaskOutcome;
using Row = TableRow;

/// Of a longer critical path the table shows only its end.
constexpr std::size_t kShownChain = 12;

Ticks waited(const TaskOutcome& task) {
  return task.waits.resource + task.waits.machine + task.waits.shift + task.waits.repair;
}

/// Of the tries of a robot to park that failed the table shows the last.
bool is_repeated(const Schedule& schedule, const TaskOutcome& task) {
  if (!task.parking || task.result == taskplan::TaskResult::done) return false;
  return std::any_of(schedule.tasks.begin(), schedule.tasks.end(), [&](const TaskOutcome& other) {
    return &other > &task && other.task == task.task && other.result == task.result;
  });
}

/// Characters of a client's name in the table; JSON and CSV have all of it.
constexpr std::size_t kNameWidth = 28;

std::string shortened_name(const std::string& text) {
  if (width(text) <= kNameWidth) return text;
  std::string kept;
  std::size_t characters = 0;
  for (const char byte : text) {
    const bool begins = (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
    if (begins && ++characters == kNameWidth) break;
    kept += byte;
  }
  return kept + "…";
}

/// What the client calls the tasks, in a column behind their own names. False, and none, if no task
/// is called anything.
bool add_client_names(const std::vector<const TaskOutcome*>& tasks, std::vector<Row>& rows) {
  const auto name = [](const TaskOutcome* task) { return taskplan::client_name(task->attributes); };
  if (std::all_of(tasks.begin(), tasks.end(),
                  [&](const TaskOutcome* task) { return name(task).empty(); })) {
    return false;
  }
  rows.front().insert(rows.front().begin() + 1, "name");
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    rows[i + 1].insert(rows[i + 1].begin() + 1, shortened_name(name(tasks[i])));
  }
  return true;
}

/// A moment: its date where the plan has dates.
std::string when_text(const Schedule& schedule, Ticks time) {
  return schedule.start_at ? date_text(*schedule.start_at, time) : clock_text(time);
}

std::string task_table(const Schedule& schedule) {
  std::vector<Row> rows = {{"task", "robot", "crew", "start", "duration", "motion", "work",
                            "waited", "tried", "accepted", "result"}};
  std::vector<const TaskOutcome*> shown;
  for (const TaskOutcome& task : schedule.tasks) {
    if (is_repeated(schedule, task)) continue;
    shown.push_back(&task);
    std::string result = name_of(task.result);
    if (!task.reason.empty()) result += ": " + task.reason;
    rows.push_back({task.task, task.robot, crew_text(task), when_text(schedule, task.start),
                    clock_text(task.duration), clock_text(task.motion_time),
                    clock_text(task.work_time), clock_text(waited(task)),
                    fmt::format("{}", task.tried), fmt::format("{}", task.accepted), result});
  }
  std::vector<std::size_t> right = {3, 4, 5, 6, 7, 8, 9};
  if (add_client_names(shown, rows)) {
    for (std::size_t& column : right) ++column;
  }
  return columns(rows, right);
}

/// What of the motion of tasks is execution and what is computation, where guides think.
std::string thinking_text(const Schedule& schedule) {
  std::string text;
  for (const TaskOutcome& task : schedule.tasks) {
    if (task.thinking == 0) continue;
    text +=
        fmt::format("{}: motion {} s is {} s of execution and {} s of computation by its guide\n",
                    task.task, seconds_text(task.motion_time),
                    seconds_text(task.motion_time - task.thinking), seconds_text(task.thinking));
  }
  return text;
}

std::string total_line(const Schedule& schedule) {
  std::string text = count_text(count_tasks(schedule));
  text += fmt::format(", process time {} ({} s)", clock_text(schedule.process_time),
                      seconds_text(schedule.process_time));
  if (schedule.start_at) {
    text += fmt::format(", from {} to {}", schedule::text_of(*schedule.start_at),
                        date_text(*schedule.start_at, schedule.process_time));
  }
  return text + "\n";
}

/// What the times stand on where durations are not certain.
std::string sample_text(const Schedule& schedule) {
  if (schedule.uncertain == 0) return {};
  const std::string durations = schedule.uncertain == 1
                                    ? "1 duration is"
                                    : fmt::format("{} durations are", schedule.uncertain);
  if (!schedule.sample) {
    return durations +
           (schedule.uncertain == 1 ? " not certain, and stands for its mean"
                                    : " not certain, and stand for their means") +
           "; --sample SEED draws them\n";
  }
  return fmt::format("{} not certain, and drawn with seed {}, run {}\n", durations,
                     schedule.sample->seed, schedule.sample->run);
}

/// Days and machines of which chance has a part, without a sample.
std::string chance_text(const Schedule& schedule) {
  std::string text;
  if (schedule.sample) {
    if (schedule.uncertain > 0 || (!schedule.loses_days && !schedule.breaks_down)) return text;
    const char* const drawn = !schedule.breaks_down ? "the weather is"
                              : schedule.loses_days ? "weather and breakdowns are"
                                                    : "breakdowns are";
    return fmt::format("{} drawn with seed {}, run {}\n", drawn, schedule.sample->seed,
                       schedule.sample->run);
  }
  if (schedule.loses_days) text += "no day is lost to the weather; --sample SEED draws them\n";
  if (schedule.breaks_down) text += "no machine breaks down; --sample SEED draws when they do\n";
  return text;
}

/// What the weather took.
std::string lost_days_table(const Schedule& schedule) {
  if (schedule.lost_days.empty()) return {};
  constexpr std::size_t kShownDates = 10;
  std::vector<Row> rows = {{"calendar", "days lost", "of", "dates"}};
  for (const taskplan::LostDaysOutcome& each : schedule.lost_days) {
    std::string dates;
    for (std::size_t i = 0; i < std::min(each.dates.size(), kShownDates); ++i) {
      dates += (i == 0 ? "" : ", ") + each.dates[i];
    }
    if (each.dates.size() > kShownDates) {
      dates += fmt::format(" and {} more", each.dates.size() - kShownDates);
    }
    rows.push_back({each.calendar, fmt::format("{}", each.dates.size()),
                    fmt::format("{}", each.working_days), dates});
  }
  return columns(rows, {1, 2});
}

/// Which machines broke down, and when.
std::string breakdown_table(const Schedule& schedule) {
  if (schedule.breakdowns.empty()) return {};
  constexpr std::size_t kShown = 20;
  std::vector<Row> rows = {{"broken", "during", "after work of", "from", "to", "repair"}};
  for (const taskplan::BreakdownOutcome& each : schedule.breakdowns) {
    if (rows.size() > kShown) break;
    rows.push_back({each.robot, each.during, clock_text(each.worked),
                    when_text(schedule, each.from), when_text(schedule, each.to),
                    clock_text(each.repair)});
  }
  std::string text = columns(rows, {2, 3, 4, 5});
  if (schedule.breakdowns.size() > kShown) {
    text += fmt::format("and {} more\n", schedule.breakdowns.size() - kShown);
  }
  return text;
}

std::string use_table(const Schedule& schedule) {
  const std::string cost = schedule.currency.empty() ? "cost" : "cost " + schedule.currency;
  std::vector<Row> rows = {{"used", "tasks", "held", "of it busy", "of its shifts"}};
  if (schedule.burns_fuel) rows.front().emplace_back("fuel l");
  if (schedule.costed) rows.front().push_back(cost);
  for (const ResourceUse& use : schedule.resources) {
    rows.push_back({use.name, fmt::format("{}", use.tasks), clock_text(use.held),
                    clock_text(use.busy), fmt::format("{:.1f} %", 100 * use.utilisation())});
    if (schedule.burns_fuel) {
      rows.back().push_back(use.fuel ? fmt::format("{:.1f}", *use.fuel) : "");
    }
    const bool costs = use.rate || use.cost != 0;
    if (schedule.costed) rows.back().push_back(costs ? fmt::format("{:.2f}", use.cost) : "");
  }
  double sum = schedule.cost;
  if (schedule.has_kinds) {
    sum = 0;
    for (const CostKind kind : {CostKind::use, CostKind::overtime, CostKind::rental,
                                CostKind::mobilisation, CostKind::fuel}) {
      sum += schedule.cost_by_kind[static_cast<std::size_t>(kind)];
    }
  }
  if (schedule.costed || schedule.burns_fuel) rows.push_back({"", "", "", "", ""});
  if (schedule.burns_fuel) rows.back().push_back(fmt::format("{:.1f}", schedule.fuel));
  if (schedule.costed) rows.back().push_back(fmt::format("{:.2f}", sum));
  return columns(rows, {1, 2, 3, 4, 5, 6});
}

/// Things with a timetable that stopped; nothing where none did.
std::string timetable_table(const Schedule& schedule) {
  std::vector<Row> rows = {{"timetable", "stops", "late by", "stands before"}};
  for (const taskplan::TimetableOutcome& each : schedule.timetables) {
    if (each.stops == 0) continue;
    rows.push_back({each.name, fmt::format("{}", each.stops), clock_text(each.late),
                    each.stands.empty() ? "-" : each.stands});
  }
  return rows.size() > 1 ? columns(rows, {1, 2}) : std::string();
}

/// Lifts that waited for a shift into which they fit, or went on after one.
std::string lift_table(const Schedule& schedule) {
  std::vector<Row> rows = {{"lift", "from", "to", "why"}};
  for (const TaskOutcome& task : schedule.tasks) {
    if (!task.lift) continue;
    rows.push_back({task.task, when_text(schedule, task.lift->from),
                    when_text(schedule, task.lift->to), task.lift->why});
  }
  return rows.size() == 1 ? std::string() : columns(rows, {1, 2});
}

/// Floors that were covered.
std::string cover_table(const Schedule& schedule) {
  std::vector<Row> rows = {
      {"covers", "area", "m2", "of what it can reach", "m3", "way m", "turns"}};
  for (const TaskOutcome& task : schedule.tasks) {
    if (!task.cover || task.result != taskplan::TaskResult::done) continue;
    if (task.cover->holes > 0) continue;
    rows.push_back(
        {task.task, task.area, fmt::format("{:.1f}", task.cover->covered_area),
         fmt::format("{:.1f} %", 100 * task.cover->covered),
         task.cover->thickness > 0
             ? fmt::format("{:.{}f}", task.cover->volume, task.cover->volume < 0.1 ? 4 : 2)
             : "-",
         fmt::format("{:.1f}", task.cover->length), fmt::format("{}", task.cover->turns)});
  }
  return rows.size() == 1 ? std::string() : columns(rows, {2, 3, 4, 5, 6});
}

/// Areas that were drilled.
std::string holes_table(const Schedule& schedule) {
  std::vector<Row> rows = {{"drills", "area", "holes", "left out", "deep mm", "way m"}};
  for (const TaskOutcome& task : schedule.tasks) {
    if (!task.cover || task.result != taskplan::TaskResult::done) continue;
    if (task.cover->holes == 0) continue;
    rows.push_back({task.task, task.area, fmt::format("{}", task.cover->holes),
                    fmt::format("{}", task.cover->holes_left_out),
                    fmt::format("{:.0f}", task.cover->depth * 1000),
                    fmt::format("{:.1f}", task.cover->length)});
  }
  return rows.size() == 1 ? std::string() : columns(rows, {2, 3, 4, 5});
}

/// Of more cold joints the table shows those that are latest.
constexpr std::size_t kShownJoints = 8;

/// Where the cold joints lie; nothing where there are none.
std::string joint_places(const Schedule& schedule) {
  struct JointOfTask {
    const TaskOutcome* task;
    const coverage::ColdJoint* joint;
    Ticks late;
  };
  std::vector<JointOfTask> all;
  for (const TaskOutcome& task : schedule.tasks) {
    if (!task.joints || task.result != taskplan::TaskResult::done) continue;
    for (const coverage::ColdJoint& joint : task.joints->cold) {
      all.push_back({&task, &joint, joint.age - task.cover->cold_after});
    }
  }
  if (all.empty()) return "";
  std::stable_sort(all.begin(), all.end(),
                   [](const JointOfTask& a, const JointOfTask& b) { return a.late > b.late; });
  const std::size_t count = all.size();
  all.resize(std::min(count, kShownJoints));
  std::vector<Row> rows = {{"cold joint of", "from", "to", "m", "age", "late by", "joined"}};
  const auto place = [](const coverage::Place& p) {
    return fmt::format("({:.2f}, {:.2f})", p.x, p.y);
  };
  for (const auto& [task, joint, late] : all) {
    const double x = joint->to.x - joint->from.x;
    const double y = joint->to.y - joint->from.y;
    rows.push_back({task->task, place(joint->from), place(joint->to),
                    fmt::format("{:.1f}", std::sqrt(x * x + y * y)), clock_text(joint->age),
                    clock_text(late), when_text(schedule, joint->joined)});
  }
  std::string text = "\n" + columns(rows, {3, 4, 5});
  if (count > all.size()) {
    text +=
        fmt::format("{} of {} are shown, the latest; schedule.json has all\n", all.size(), count);
  }
  return text;
}

/// Floors whose joints have a limit: how many are over it, how long, and the oldest joint.
std::string joint_table(const Schedule& schedule) {
  std::vector<Row> rows = {{"cold joints", "after", "places", "m", "oldest", "at", "late by"}};
  for (const TaskOutcome& task : schedule.tasks) {
    if (!task.joints || task.result != taskplan::TaskResult::done) continue;
    const coverage::JointFindings& joints = *task.joints;
    const Ticks late = joints.oldest - task.cover->cold_after;
    rows.push_back(
        {task.task, clock_text(task.cover->cold_after), fmt::format("{}", joints.cold.size()),
         fmt::format("{:.1f}", joints.cold_length), clock_text(joints.oldest),
         joints.oldest > 0 ? fmt::format("({:.2f}, {:.2f})", joints.oldest_at.x, joints.oldest_at.y)
                           : "-",
         late > 0 ? clock_text(late) : "-"});
  }
  if (rows.size() == 1) return "";
  return columns(rows, {1, 2, 3, 4, 6}) + joint_places(schedule);
}

/// Tasks that are due, and by how much each is late.
std::string due_table(const Schedule& schedule) {
  std::vector<Row> rows = {{"due", "by", "finish", "late"}};
  for (const TaskOutcome& task : schedule.tasks) {
    if (!task.due) continue;
    const auto late = task.late();
    rows.push_back({task.task, when_text(schedule, *task.due),
                    late ? when_text(schedule, task.start + task.duration) : name_of(task.result),
                    !late       ? ""
                    : *late > 0 ? clock_text(*late)
                                : "in time"});
  }
  return rows.size() == 1 ? std::string() : columns(rows, {1, 2, 3});
}

/// Of more tasks that come later than in their baseline the table shows those that come latest.
constexpr std::size_t kShownLater = 12;

/// Tasks that finish later than others planned it, by how much; and the last of all.
std::string baseline_table(const Schedule& schedule) {
  std::vector<const TaskOutcome*> later, not_done;
  std::size_t count = 0;
  Ticks planned = 0, simulated = 0;
  for (const TaskOutcome& task : schedule.tasks) {
    if (!task.baseline) continue;
    ++count;
    planned = std::max(planned, task.baseline->finish);
    if (task.result != taskplan::TaskResult::done) {
      not_done.push_back(&task);
      continue;
    }
    simulated = std::max(simulated, task.start + task.duration);
    if (task.start + task.duration > task.baseline->finish) later.push_back(&task);
  }
  if (count == 0) return "";
  const auto delay = [](const TaskOutcome* task) {
    return task->start + task->duration - task->baseline->finish;
  };
  std::stable_sort(later.begin(), later.end(),
                   [&](const TaskOutcome* a, const TaskOutcome* b) { return delay(a) > delay(b); });
  const std::size_t all_later = later.size();
  later.resize(std::min(later.size(), kShownLater));
  const auto change = [](Ticks time) {
    return time > 0   ? clock_text(time) + " later"
           : time < 0 ? clock_text(-time) + " earlier"
                      : "as planned";
  };
  std::vector<Row> rows = {{"baseline", "planned to", "simulated to", "change"}};
  for (const TaskOutcome* task : later) {
    rows.push_back({task->task, when_text(schedule, task->baseline->finish),
                    when_text(schedule, task->start + task->duration), change(delay(task))});
  }
  const std::size_t all_not_done = not_done.size();
  not_done.resize(std::min(not_done.size(), kShownLater));
  for (const TaskOutcome* task : not_done) {
    rows.push_back(
        {task->task, when_text(schedule, task->baseline->finish), name_of(task->result), ""});
  }
  if (simulated > 0) {
    rows.push_back({"last finish", when_text(schedule, planned), when_text(schedule, simulated),
                    change(simulated - planned)});
  }
  std::string text = columns(rows, {1, 2, 3});
  text += fmt::format("{} of {} tasks with a baseline finish later than planned", all_later, count);
  if (all_later > later.size()) text += fmt::format(", the latest {} are shown", later.size());
  if (all_not_done > 0) text += fmt::format(", {} are not done", all_not_done);
  if (all_not_done > not_done.size()) {
    text += fmt::format(", the first {} are shown", not_done.size());
  }
  return text + "\n";
}

/// What does not stand, in plans that only warn of it.
std::string support_text(const Schedule& schedule) {
  std::string text;
  for (const TaskOutcome& task : schedule.tasks) {
    for (const std::string& each : task.support) {
      text += fmt::format("  {}: {}\n", task.task, each);
    }
  }
  return text.empty() ? text : "support:\n" + text;
}

/// Waypoints that scripts left without reaching them.
std::string missed_text(const Schedule& schedule) {
  constexpr std::size_t kMostShown = 10;
  std::string text;
  std::size_t count = 0;
  for (const TaskOutcome& task : schedule.tasks) {
    for (const std::string& each : task.missed) {
      if (++count <= kMostShown) text += fmt::format("  {}: {}\n", task.task, each);
    }
  }
  if (count > kMostShown) text += fmt::format("  and {} more\n", count - kMostShown);
  return text.empty() ? text : "waypoints not reached:\n" + text;
}

/// What the money goes for.
std::string cost_table(const Schedule& schedule) {
  std::vector<Row> rows = {{schedule.currency.empty() ? "cost" : "cost " + schedule.currency, ""}};
  for (const CostKind kind : told_kinds(schedule)) {
    rows.push_back({name_of(kind),
                    fmt::format("{:.2f}", schedule.cost_by_kind[static_cast<std::size_t>(kind)])});
  }
  rows.push_back({"total", fmt::format("{:.2f}", schedule.cost)});
  return columns(rows, {1});
}

std::string chain_text(const Schedule& schedule) {
  const std::size_t count = schedule.critical.size();
  std::string text = fmt::format("critical path, {} task{}:\n", count, count == 1 ? "" : "s");
  std::size_t first = 0;
  if (count > kShownChain) {
    first = count - kShownChain;
    text += fmt::format("  ... {} before\n", first);
  }
  for (std::size_t i = first; i < count; ++i) text += "  " + schedule.critical[i].text + "\n";
  return text;
}

}  // namespace

TaskCounts count_tasks(const Schedule& schedule) {
  TaskCounts counts;
  for (const TaskOutcome& task : schedule.tasks) {
    if (task.parking) continue;
    ++counts.tasks;
    if (task.result == taskplan::TaskResult::done) ++counts.done;
    if (task.result == taskplan::TaskResult::ended_short) ++counts.ended_short;
    if (task.result == taskplan::TaskResult::rejected) ++counts.rejected;
    if (task.result == taskplan::TaskResult::not_reached) ++counts.not_reached;
  }
  return counts;
}

std::string count_text(const TaskCounts& counts) {
  std::string text = fmt::format("{} of {} tasks done", counts.done, counts.tasks);
  if (counts.ended_short > 0) text += fmt::format(", {} short", counts.ended_short);
  if (counts.rejected > 0) text += fmt::format(", {} rejected", counts.rejected);
  if (counts.not_reached > 0) text += fmt::format(", {} not reached", counts.not_reached);
  return text;
}

std::string crew_text(const TaskOutcome& task) {
  return fmt::format("{}", fmt::join(task.crews, ", "));
}

std::string seconds_text(Ticks ticks) {
  std::string text;
  trace::append_seconds(text, ticks);
  return text;
}

std::string date_text(const schedule::CivilTime& start_at, Ticks time) {
  return schedule::text_of(schedule::civil_time_at(start_at, time));
}

schedule::CivilTime start_from_text(std::string_view text) {
  const auto start = schedule::parse_civil_time(text);
  if (!start) {
    throw std::invalid_argument(
        fmt::format("expected YYYY-MM-DD HH:MM as 'start_at', found '{}'", text));
  }
  return *start;
}

std::string moment_text(const schedule::CivilTime& start_at, Ticks time) {
  const Ticks seconds = schedule::floor_division(time, schedule::kSecond);
  return fmt::format("{}:{:02}", date_text(start_at, time), seconds % 60);
}

std::string schedule_table(const Schedule& schedule) {
  std::string text = task_table(schedule) + thinking_text(schedule) + "\n" + total_line(schedule) +
                     sample_text(schedule) + chance_text(schedule);
  const auto add = [&text](const std::string& table) {
    if (!table.empty()) text += "\n" + table;
  };
  add(lift_table(schedule));
  add(due_table(schedule));
  add(baseline_table(schedule));
  add(lost_days_table(schedule));
  add(breakdown_table(schedule));
  add(support_text(schedule));
  add(missed_text(schedule));
  if (!schedule.resources.empty()) add(use_table(schedule));
  add(cover_table(schedule));
  add(holes_table(schedule));
  add(joint_table(schedule));
  add(earthwork_table(schedule));
  add(workspaces_table(schedule));
  add(timetable_table(schedule));
  if (schedule.has_kinds) add(cost_table(schedule));
  if (!schedule.critical.empty()) add(chain_text(schedule));
  return text;
}

}  // namespace rubicon::report
