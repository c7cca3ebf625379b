#include "src/results/verify/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <tuple>

#include "src/motion/math/index.hpp"
#include "src/results/verify/input/check_files.hpp"
#include "src/results/verify/replay/check_beginning.hpp"
#include "src/results/verify/replay/check_forbidden.hpp"
#include "src/results/verify/replay/check_goals.hpp"
#include "src/results/verify/replay/check_guides.hpp"
#include "src/results/verify/replay/check_hits.hpp"
#include "src/results/verify/replay/check_lines.hpp"
#include "src/results/verify/replay/check_support.hpp"
#include "src/results/verify/replay/check_turns.hpp"
#include "src/results/verify/replay/check_workspaces.hpp"
#include "src/results/verify/replay/contact_check.hpp"
#include "src/results/verify/replay/dug_soil.hpp"
#include "src/results/verify/replay/hauled_soil.hpp"
#include "src/results/verify/schedule/check_accounts.hpp"
#include "src/results/verify/schedule/check_chance.hpp"
#include "src/results/verify/schedule/check_choices.hpp"
#include "src/results/verify/schedule/check_costs.hpp"
#include "src/results/verify/schedule/check_critical.hpp"
#include "src/results/verify/schedule/check_dates.hpp"
#include "src/results/verify/schedule/check_digs.hpp"
#include "src/results/verify/schedule/check_durations.hpp"
#include "src/results/verify/schedule/check_earth_rows.hpp"
#include "src/results/verify/schedule/check_joints.hpp"
#include "src/results/verify/schedule/check_lifts.hpp"
#include "src/results/verify/schedule/check_links.hpp"
#include "src/results/verify/schedule/check_plan_dates.hpp"
#include "src/results/verify/schedule/check_report.hpp"
#include "src/results/verify/schedule/check_resources.hpp"
#include "src/results/verify/schedule/check_schedule.hpp"
#include "src/results/verify/schedule/check_shifts.hpp"
#include "src/results/verify/schedule/check_texts.hpp"
#include "src/results/verify/schedule/check_waits.hpp"
#include "src/results/verify/schedule/task_clock.hpp"
#include "src/results/verify/schedule/task_phases.hpp"

namespace rubicon::verify {

namespace {

using math::at;

/// When all that happened is over. What was undone may have gone on for longer: nobody kept the
/// timetables of things up to then.
Ticks end_of(const Trace& trace, const std::vector<TaskRun>& runs) {
  Ticks last = 0;
  for (const TaskRun& run : runs) {
    for (const int index : run.records) {
      if (run.happened) last = std::max(last, trace.records[at(index)].time);
    }
  }
  for (const MovingRecord& record : trace.movings) last = std::max(last, record.time);
  return last;
}

void check_motions(const Trace& trace, const std::vector<TaskRun>& runs, const WorkingHours& hours,
                   Verdict& verdict) {
  const Ticks end = end_of(trace, runs);
  const Ticks until = end + kSecond;  // what happens last lasts
  std::vector<RobotTrack> tracks;
  std::vector<LoadEvent> events;
  for (std::size_t robot = 0; robot < trace.scene.robots.size(); ++robot) {
    tracks.push_back(
        follow_robot(trace, runs, static_cast<int>(robot), until, events, verdict.faults));
  }
  const std::vector<Stay> stays =
      component_stays(trace, runs, tracks, events, until, verdict.faults);
  const SiteParts site = make_site_parts(trace, runs, stays, until);
  std::vector<MovingPath> movings;
  for (std::size_t i = 0; i < trace.scene.movings.size(); ++i) {
    std::vector<MovingRecord> records;
    std::copy_if(trace.movings.begin(), trace.movings.end(), std::back_inserter(records),
                 [&](const MovingRecord& each) { return each.moving == static_cast<int>(i); });
    // How they go on after the end nobody has looked at.
    movings.emplace_back(trace.scene.movings[i], records, trace.scene.meshes, end, verdict.faults);
  }
  check_beginning(trace.scene, site, movings, verdict.faults);
  check_support(trace, site, stays, until, verdict.faults);
  check_dug_soil(
      trace, runs, tracks, site,
      [&](const std::vector<int>& calendars, Ticks from, Ticks to) {
        return hours.between(calendars, from, to);
      },
      verdict.faults);
  check_hauled_soil(trace, runs, tracks, site, verdict.faults);
  check_workspaces(trace, runs, tracks, site, verdict.faults);
  check_forbidden(trace, runs, tracks, site, verdict.faults);
  const ContactCounts counts = check_contacts(trace, runs, tracks, site, movings, verdict.faults);
  verdict.steps = counts.steps;
  verdict.pairs = counts.pairs;
}

template <typename Read>
auto read_file(const char* name, const Read& read) {
  try {
    return read();
  } catch (const UnreadableInput& error) {
    throw UnreadableInput(fmt::format("{}: {}", name, error.what()));
  }
}

void check_schedules(const Result& result, const Trace& trace, const std::vector<TaskRun>& runs,
                     const WorkingHours& hours, const WaitCheck& waits, Faults& faults) {
  const std::vector<TaskAccount> accounts = task_accounts(trace, runs, hours);
  std::optional<ScheduleJson> json;
  if (result.schedule_json) {
    const ScheduleJson& schedule = json.emplace(
        read_file("schedule.json", [&] { return read_schedule_json(*result.schedule_json); }));
    const Costs costs = costs_of(trace, runs, accounts, schedule.rows);
    check_rows(trace, runs, accounts, costs, waits, schedule.rows, ResultFile::schedule_json,
               faults);
    check_uses(trace, runs, accounts, hours, schedule, faults);
    check_costs(trace, costs, schedule, faults);
    check_fuel(trace, runs, costs, schedule, faults);
    check_process_time(runs, schedule.process_time, faults);
    check_dates(trace.scene, schedule.rows, ResultFile::schedule_json, faults);
    check_plan_dates(trace, runs, hours, schedule.rows, ResultFile::schedule_json,
                     schedule.process_time, faults);
    check_whole(trace.scene, schedule, faults);
    check_critical(trace, runs, hours, schedule, faults);
    check_joint_rows(trace, runs, schedule.rows, faults);
    check_chance(trace, schedule, faults);
    check_texts(trace.scene, schedule, faults);
    std::optional<std::vector<LoadRow>> loads;
    // In the folder of a result without loads a file of that name is somebody else's.
    const bool has_loads =
        std::any_of(trace.scene.tasks.begin(), trace.scene.tasks.end(),
                    [](const SceneTask& task) { return task.dig || task.motion_dig || task.haul; });
    if (result.loads_csv && has_loads) {
      loads = read_file("loads.csv", [&] { return read_loads_csv(*result.loads_csv); });
    }
    check_dig_rows(trace, runs, schedule.rows, loads, faults);
    check_earth_rows(trace, runs, hours, schedule, loads, faults);
  }
  if (result.schedule_csv) {
    const auto rows =
        read_file("schedule.csv", [&] { return read_schedule_csv(*result.schedule_csv); });
    const Costs costs = costs_of(trace, runs, accounts, rows);
    check_rows(trace, runs, accounts, costs, waits, rows, ResultFile::schedule_csv, faults);
    check_dates(trace.scene, rows, ResultFile::schedule_csv, faults);
    check_plan_dates(trace, runs, hours, rows, ResultFile::schedule_csv, 0, faults);
    check_texts(trace.scene, rows, faults);
    if (json) check_same_floats(json->rows, rows, faults);
  }
}

}  // namespace

Verdict verify(const Result& result) {
  Verdict verdict;
  const std::optional<Trace> chosen = with_choices(result.trace, verdict.faults);
  const Trace& trace = chosen ? *chosen : result.trace;
  const std::vector<TaskRun> runs = task_runs(trace, verdict.faults);
  const WorkingHours hours(trace.scene);
  const WaitCheck waits(trace, runs, hours);
  check_durations(trace, verdict.faults);
  check_digs(trace, runs, verdict.faults);
  check_turns(trace, verdict.faults);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const TaskRun& run = runs[i];
    check_clock(trace, run, verdict.faults);
    const std::size_t before = verdict.faults.size();
    check_phases(trace, run, verdict.faults);
    // Where the phases of a task are wrong, its motions belong to none.
    const bool digs = run.task >= 0 && (trace.scene.tasks[at(run.task)].motion_dig ||
                                        trace.scene.tasks[at(run.task)].haul);
    if (verdict.faults.size() == before && !digs) check_goals(trace, run, verdict.faults);
    if (verdict.faults.size() == before) check_guides(trace, run, verdict.faults);
    if (verdict.faults.size() == before) check_lines(trace, run, verdict.faults);
    check_joints(trace, run, verdict.faults);
    check_hits(trace, run, verdict.faults);
    check_shifts(trace, run, hours, verdict.faults);
    check_lifts(trace, run, hours, verdict.faults);
    waits.check_pauses(static_cast<int>(i), verdict.faults);
    if (run.task >= 0 && run.result == TaskResult::done) ++verdict.done;
  }
  verdict.tasks = static_cast<int>(trace.scene.tasks.size());
  check_files(trace, verdict.faults);
  check_resources(trace, runs, verdict.faults);
  check_same_as(trace, runs, verdict.faults);
  check_links(trace, runs, verdict.faults);
  check_breakdowns(trace, runs, hours, verdict.faults);
  check_lost_days(trace, runs, hours, verdict.faults);
  check_motions(trace, runs, hours, verdict);
  check_schedules(result, trace, runs, hours, waits, verdict.faults);
  if (result.report) {
    check_report(*result.report, result.trace_digest, result.schedule_json, verdict.faults);
  }
  std::stable_sort(verdict.faults.begin(), verdict.faults.end(),
                   [](const Fault& a, const Fault& b) {
                     return std::tie(a.file, a.line, a.text) < std::tie(b.file, b.line, b.text);
                   });
  return verdict;
}

}  // namespace rubicon::verify
