#include "src/results/replay/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "src/simulation/trace/json_builder.hpp"

namespace rubicon::replay {

namespace {

using trace::RecordKind;
using Numbers = std::map<std::string, int, std::less<>>;

constexpr Ticks kSecond = 1'000'000'000;

/// What a script does between its steps has no place on the clock.
const trace::RecordKinds kWanted = {RecordKind::task_start, RecordKind::attempt, RecordKind::wait,
                                    RecordKind::work,       RecordKind::pause,   RecordKind::attach,
                                    RecordKind::detach,     RecordKind::remove,  RecordKind::end,
                                    RecordKind::task_end,   RecordKind::stop,    RecordKind::turn,
                                    RecordKind::moving};

std::string quoted(std::string_view name) {
  std::string text;
  trace::append_string(text, name);
  return text;
}

template <typename Named>
Numbers numbers_of(const std::vector<Named>& list, const char* what) {
  Numbers numbers;
  for (const Named& each : list) {
    if (!numbers.emplace(each.name, static_cast<int>(numbers.size())).second) {
      throw std::invalid_argument(
          fmt::format("expected different names of {}, found {} twice", what, quoted(each.name)));
    }
  }
  return numbers;
}

int number_of(const Numbers& numbers, std::string_view name, const char* what) {
  const auto found = numbers.find(name);
  if (found == numbers.end()) {
    throw std::invalid_argument(
        fmt::format("expected {} of the header, found {}", what, quoted(name)));
  }
  return found->second;
}

int parameter_of(const Machine& machine, std::string_view name) {
  const auto& parameters = machine.model.parameters;
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const auto& each) { return each.display_name == name; });
  if (found == parameters.end()) {
    throw std::invalid_argument(
        fmt::format("expected a parameter of the robot, found {}", quoted(name)));
  }
  return static_cast<int>(found - parameters.begin());
}

void expect_robot(const TaskRun& run) {
  if (run.robot < 0) throw std::invalid_argument("expected a robot in the task of this record");
}

}  // namespace

ReplayReader::ReplayReader() : reader_(kWanted) {}

void ReplayReader::line(std::string_view text) {
  ++lines_;
  reader_.read(
      text, [&](trace::TraceHeader&& header) { begin(std::move(header)); },
      [&](const trace::Record& record) { add(record); });
}

void ReplayReader::begin(trace::TraceHeader&& header) {
  if (header.detail != "steps") {
    throw std::invalid_argument(
        "expected every step in the trace (rubicon run --trace-detail steps)");
  }
  if (header.short_form) {
    header.tasks.assign(1, {});
    header.tasks[0].name = header.plan;
  }
  tasks_ = numbers_of(header.tasks, "tasks");
  robots_ = numbers_of(header.robots, "robots");
  components_ = numbers_of(header.components, "components");
  movings_ = numbers_of(header.movings, "movings");
  replay_.moving_stops.resize(header.movings.size());
  for (const trace::HeaderRobot& robot : header.robots) {
    replay_.machines.push_back(make_machine(robot));
  }
  replay_.header = std::move(header);
}

/// A machine may be asked out of the way several times, each time in a task of the same name.
TaskRun& ReplayReader::run_of(const trace::Record& record) {
  const auto known = tasks_.find(record.task);
  const int task = known == tasks_.end() ? -1 : known->second;
  const auto latest = latest_.find(record.task);
  const bool again = latest != latest_.end() && task < 0 && replay_.runs[latest->second].ended &&
                     record.kind() == RecordKind::task_start;
  if (latest != latest_.end() && !again) return replay_.runs[latest->second];
  latest_.insert_or_assign(std::string(record.task), replay_.runs.size());
  TaskRun& run = replay_.runs.emplace_back();
  run.task = task;
  if (!record.robot.empty()) run.robot = number_of(robots_, record.robot, "a robot");
  return run;
}

void ReplayReader::add(const trace::Record& record) {
  if (const auto* moving = std::get_if<trace::Moving>(&record.what)) {
    const int number = number_of(movings_, moving->name, "a moving");
    replay_.moving_stops[static_cast<std::size_t>(number)].push_back(
        {moving->t, moving->by.empty()});
    return;
  }
  TaskRun& run = run_of(record);
  std::visit([&](const auto& what) { add(run, what); }, record.what);
}

void ReplayReader::add_event(TaskRun& run, Ticks time, decltype(Event::what) what) {
  const auto still = [](const auto& each) { return std::holds_alternative<std::monostate>(each); };
  if (still(what) && !run.events.empty() && still(run.events.back().what)) {
    run.events.back().time = time;
  } else {
    run.events.push_back({time, lines_, std::move(what)});
  }
}

void ReplayReader::add(TaskRun& run, const trace::TaskStart& start) {
  run.started = true;
  run.start = start.t;
  add_event(run, start.t, {});
}

void ReplayReader::add(TaskRun& run, const trace::Attempt& attempt) {
  if (!attempt.ok) {
    add_event(run, attempt.t, {});
    // At its goal, or without a direction, nothing was refused: there was nothing to do.
    run.events.back().refused = attempt.reason == "hit" || attempt.reason.starts_with("limit");
    return;
  }
  Step step{{}, values(run, attempt.q)};
  const Machine& machine = replay_.machines[static_cast<std::size_t>(run.robot)];
  for (const std::string_view name : attempt.parameters) {
    step.moved.push_back(parameter_of(machine, name));
  }
  add_event(run, attempt.t, std::move(step));
}

void ReplayReader::add(TaskRun& run, const trace::Attach& attach) {
  expect_robot(run);
  add_event(run, attach.t,
            LoadChange{LoadChange::Kind::attach, component(attach.component), attach.X_TO});
}

void ReplayReader::add(TaskRun& run, const trace::Detach& detach) {
  expect_robot(run);
  add_event(run, detach.t,
            LoadChange{LoadChange::Kind::detach, component(detach.component), detach.X_WO});
}

void ReplayReader::add(TaskRun& run, const trace::Turn& turn) {
  expect_robot(run);
  add_event(run, turn.t, LoadTurn{turn.angle_deg, turn.X_TO, turn.from});
}

void ReplayReader::add(TaskRun& run, const trace::Removal& removal) {
  add_event(
      run, removal.t,
      LoadChange{LoadChange::Kind::remove, component(removal.component), math::Pose::Identity()});
}

void ReplayReader::add(TaskRun& run, const trace::Pause& pause) {
  if (pause.why == "machine") {
    run.waits.push_back({std::string(pause.whom), pause.from, pause.t});
  }
  add_event(run, pause.t, {});
}

void ReplayReader::add(TaskRun& run, const trace::TaskEnd& end) {
  run.ended = true;
  run.end = end.t;
  run.happened = run.started && (trace::has_happened(end.result) ||
                                 (replay_.header.short_form && end.result == "rejected"));
}

template <typename Other>
void ReplayReader::add(TaskRun& run, const Other& other) {
  if constexpr (requires { other.t; }) add_event(run, other.t, {});
}

int ReplayReader::component(std::string_view name) const {
  return number_of(components_, name, "a component");
}

/// By the order of the parameters.
std::vector<double> ReplayReader::values(const TaskRun& run, trace::Configuration q) const {
  expect_robot(run);
  const Machine& machine = replay_.machines[static_cast<std::size_t>(run.robot)];
  const auto& parameters = machine.model.parameters;
  std::vector<double> ordered;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::string& name = parameters[i].display_name;
    auto found = q.begin() + static_cast<std::ptrdiff_t>(std::min(i, q.size()));
    if (found == q.end() || found->name != name) {
      found = std::find_if(q.begin(), q.end(), [&](const auto& each) { return each.name == name; });
    }
    if (found == q.end()) {
      throw std::invalid_argument(fmt::format("expected {} in 'q' of a step", quoted(name)));
    }
    ordered.push_back(found->value);
  }
  return ordered;
}

Replay ReplayReader::finish() {
  if (!reader_.has_header()) throw std::invalid_argument("expected a trace, found nothing");
  for (const TaskRun& run : replay_.runs) {
    if (run.happened) replay_.last = std::max(replay_.last, run.end);
  }
  replay_.until = replay_.last + kSecond;  // what stands at last stays
  for (std::size_t robot = 0; robot < replay_.machines.size(); ++robot) {
    std::vector<const TaskRun*> runs;
    for (const TaskRun& run : replay_.runs) {
      if (run.happened && run.robot == static_cast<int>(robot)) runs.push_back(&run);
    }
    const bool carries = robot == 0 && !replay_.header.carry.empty();
    replay_.tracks.push_back(follow_robot(replay_.machines[robot], runs, carries, replay_.until));
  }
  replay_.stays = component_stays(replay_.header.components, replay_.runs, replay_.until);
  return std::move(replay_);
}

}  // namespace rubicon::replay
