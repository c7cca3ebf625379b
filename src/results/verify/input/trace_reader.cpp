#include "src/results/verify/input/trace_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>

#include "src/results/verify/input/json_fields.hpp"
#include "src/results/verify/input/read_scene.hpp"

namespace rubicon::verify {

namespace {

/// Records that tell how a script came to its steps; they have no place on the clock.
constexpr std::array<std::string_view, 4> kScriptRecords = {"set", "enter", "exit", "which"};

bool is_script_record(const std::string& type) {
  for (const std::string_view known : kScriptRecords) {
    if (type == known) return true;
  }
  return false;
}

/// Reads the members of one record that depend on its type.
class RecordReader {
 public:
  RecordReader(const JsonFields& fields, const Scene& scene, Record& record)
      : fields_(fields), scene_(scene), record_(record) {}

  void read(const std::string& type) {
    if (type == "goal") {
      record_.what = Goal{fields_.integer("k"), fields_.integer("n")};
      return;
    }
    if (type == "way_point") {
      record_.what = WayPoint{fields_.integer("k"), fields_.integer("n")};
      return;
    }
    record_.time = fields_.time("t");
    if (type == "task_start") {
      TaskStart start{fields_.text_or("chosen", "")};
      if (fields_.has("to")) {
        for (const Json& value : fields_.array("to")) {
          if (!value.is_number()) fields_.fail("numbers in 'to'");
          start.to.push_back(value.get<double>());
        }
      }
      record_.what = std::move(start);
    } else if (type == "try") {
      record_.what = read_try();
    } else if (type == "wait") {
      record_.what = Wait{fields_.integer("n")};
    } else if (type == "stop") {
      record_.what = Stop{};
    } else if (type == "think") {
      record_.what = Think{fields_.integer("checks")};
    } else if (type == "guide") {
      record_.what = read_guide();
    } else if (type == "work") {
      record_.what = read_work();
    } else if (type == "pause") {
      record_.what = Pause{fields_.text("why"), fields_.text_or("for", ""), fields_.time("from")};
    } else if (type == "attach" || type == "detach" || type == "remove") {
      record_.what = read_load_change(type);
    } else if (type == "turn") {
      record_.what = read_turn();
    } else if (type == "cold_joint") {
      record_.what = read_cold_joint();
    } else if (type == "foreseen") {
      record_.what = read_foreseen();
    } else if (type == "forbidden") {
      record_.what = read_forbidden();
    } else if (type == "soil") {
      record_.what = read_soil();
    } else if (type == "end") {
      record_.what = read_end();
    } else if (type == "task_end") {
      record_.what = read_task_end();
    } else {
      fields_.fail("a type of record that is known");
    }
  }

 private:
  const SceneRobot& robot() const {
    if (record_.robot < 0) fields_.fail("a robot");
    return scene_.robots[static_cast<std::size_t>(record_.robot)];
  }

  int parameter(const Json& name) const {
    const std::string& wanted = text_of(name, "a parameter");
    const auto& parameters = robot().parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (parameters[i].name == wanted) return static_cast<int>(i);
    }
    fields_.fail("parameters of the robot");
  }

  std::vector<double> configuration() const {
    const JsonFields values = fields_.object("q");
    std::vector<double> q;
    for (const SceneParameter& each : robot().parameters)
      q.push_back(values.number(each.name.c_str()));
    return q;
  }

  Try read_try() const {
    Try attempt;
    attempt.ok = fields_.truth("ok");
    attempt.n = fields_.integer("n");
    attempt.follows = fields_.text("command") == "follow";
    attempt.lines = fields_.text("command") == "line";
    const Json& names = fields_.any("parameter");
    if (names.is_array()) {
      for (const Json& name : names) attempt.moved.push_back(parameter(name));
    } else {
      attempt.moved.push_back(parameter(names));
    }
    attempt.q = configuration();
    attempt.reason = fields_.text_or("reason", "");
    attempt.hit = read_hit();
    if (fields_.has("step") && fields_.array("step").size() != attempt.moved.size()) {
      fields_.fail("a number for each parameter as 'step'");
    }
    return attempt;
  }

  std::vector<std::vector<double>> read_configurations(const char* key) const {
    const Json& values = fields_.array(key);
    const std::size_t width = robot().parameters.size();
    std::vector<std::vector<double>> points;
    if (values.size() % width != 0) {
      fields_.fail(fmt::format("the values of all parameters for each point of '{}'", key));
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!values[i].is_number()) fields_.fail(fmt::format("numbers in '{}'", key));
      if (i % width == 0) points.emplace_back();
      points.back().push_back(values[i].get<double>());
    }
    return points;
  }

  GuidePlan read_guide() const {
    GuidePlan plan;
    plan.name = fields_.text("name");
    plan.way = read_configurations("way");
    if (fields_.truth("found") == plan.way.empty()) fields_.fail("points of 'way' if one is found");
    if (fields_.has("graph")) {
      plan.graph = read_configurations("graph");
      const std::size_t legs = plan.graph.size() / 2;
      if (legs == 0 || plan.graph.size() % 2 != 0 ||
          fields_.integer("legs") < static_cast<int>(legs)) {
        fields_.fail("two configurations for each leg of 'graph', and how many 'legs' there are");
      }
    }
    plan.roughness = fields_.number("roughness");
    plan.length = fields_.number("length");
    plan.motion_time = fields_.number("motion_time");
    plan.checks = fields_.integer("checks");
    return plan;
  }

  std::optional<std::pair<std::string, std::string>> read_hit() const {
    if (!fields_.has("hit")) return std::nullopt;
    const Json& pair = fields_.array("hit");
    if (pair.size() != 2) fields_.fail("two names as 'hit'");
    return std::pair(text_of(pair[0], "what moved"), text_of(pair[1], "what it met"));
  }

  int component() const {
    const auto found = scene_.component_index.find(fields_.text("component"));
    if (found == scene_.component_index.end()) fields_.fail("a component of the header");
    return found->second;
  }

  LoadTurn read_turn() const {
    robot();
    return {component(), fields_.number("angle"), fields_.pose("pose"), fields_.time("from"),
            read_hit()};
  }

  ColdJoint read_cold_joint() const {
    ColdJoint joint;
    double* const ends[] = {&joint.from_x, &joint.from_y, &joint.to_x, &joint.to_y};
    const Json& values = fields_.array("ends");
    if (values.size() != std::size(ends)) fields_.fail("x and y of two places in 'ends'");
    for (std::size_t i = 0; i < std::size(ends); ++i) *ends[i] = number_of(values[i], "'ends'");
    joint.age = fields_.time("age");
    joint.laid = fields_.time("laid");
    joint.joined = fields_.time("joined");
    return joint;
  }

  Foreseen read_foreseen() const {
    robot();
    Foreseen foreseen;
    const auto found = scene_.robot_index.find(fields_.text("machine"));
    if (found == scene_.robot_index.end()) fields_.fail("a robot of the header");
    foreseen.robot = found->second;
    foreseen.seconds = fields_.number("seconds");
    const Json& points = fields_.array("points");
    std::size_t next = 0;
    for (const Json& corners : fields_.array("corners")) {
      const int count = integer_of(corners, "'corners'", 1, 1'000'000);
      std::vector<double>& outline = foreseen.outlines.emplace_back();
      for (int i = 0; i < 2 * count; ++i) {
        if (next >= points.size()) fields_.fail("x and y of each corner in 'points'");
        outline.push_back(number_of(points[next++], "'points'"));
      }
    }
    if (next != points.size()) fields_.fail("a corner for each place in 'points'");
    return foreseen;
  }

  /// More cells than anybody samples: along a side, and in all.
  static constexpr int kMostCells = 10'000;
  static constexpr long kMostCellsInAll = 10'000'000;
  static constexpr std::size_t kMostLayers = 1'000;

  Forbidden read_forbidden() const {
    Forbidden grid;
    const std::size_t width = robot().parameters.size();
    for (const Json& name : fields_.array("parameters")) {
      grid.parameters.push_back(parameter(name));
    }
    const auto pair = [&](const char* key, auto read) {
      const Json& values = fields_.array(key);
      if (values.size() != 2) fields_.fail(fmt::format("two numbers as '{}'", key));
      return std::array{read(values[0]), read(values[1])};
    };
    const auto number = [](const Json& value) { return number_of(value, "a place of a cell"); };
    grid.low = pair("low", number);
    grid.high = pair("high", number);
    grid.cells = pair(
        "cells", [](const Json& value) { return integer_of(value, "'cells'", 1, kMostCells); });
    if (fields_.has("layers")) {
      for (const Json& value : fields_.array("layers")) {
        if (!grid.layers.empty() && !(number(value) > grid.layers.back())) {
          fields_.fail("ascending values as 'layers'");
        }
        grid.layers.push_back(number(value));
      }
      if (grid.layers.empty() || grid.layers.size() > kMostLayers) {
        fields_.fail("some values as 'layers'");
      }
    }
    const std::set<int> different(grid.parameters.begin(), grid.parameters.end());
    if (grid.parameters.size() != (grid.layers.empty() ? 2 : 3) ||
        different.size() != grid.parameters.size()) {
      fields_.fail("two different parameters, or three with 'layers'");
    }
    if (!(grid.low[0] < grid.high[0]) || !(grid.low[1] < grid.high[1])) {
      fields_.fail("'low' below 'high'");
    }
    for (const Json& value : fields_.array("at")) grid.at.push_back(number(value));
    if (grid.at.size() != width) fields_.fail("the values of all parameters as 'at'");
    const long all = static_cast<long>(grid.cells[0]) * grid.cells[1] *
                     static_cast<long>(std::max<std::size_t>(1, grid.layers.size()));
    if (all > kMostCellsInAll) fields_.fail(fmt::format("at most {} cells", kMostCellsInAll));
    long left = all;
    for (const Json& value : fields_.array("runs")) {
      constexpr int kLongest = std::numeric_limits<int>::max();
      const int least = grid.runs.empty() ? 0 : 1;
      grid.runs.push_back(integer_of(value, "'runs'", least, kLongest));
      left -= grid.runs.back();
      if (left < 0) break;
    }
    if (left != 0) fields_.fail(fmt::format("the {} cells of the grid in 'runs'", all));
    return grid;
  }

  SoilTaken read_soil() const {
    robot();
    SoilTaken taken;
    taken.component = component();
    const Json& volume = fields_.any("volume");
    if (!volume.is_number_integer()) fields_.fail("whole mm3 as 'volume'");
    taken.volume = volume.get<std::int64_t>();
    for (const Json& cell : fields_.array("cells")) {
      taken.cells.push_back(integer_of(cell, "'cells'", 0, 1'000'000'000));
    }
    for (const Json& height : fields_.array("heights")) {
      if (!height.is_number_integer()) fields_.fail("whole mm as 'heights'");
      taken.heights.push_back(height.get<std::int64_t>());
    }
    if (taken.cells.size() != taken.heights.size()) fields_.fail("a height for each cell");
    taken.from = fields_.time("from");
    return taken;
  }

  Work read_work() const {
    Work work;
    work.what = fields_.text("what");
    const std::string crew = fields_.text_or("crew", "");
    if (!crew.empty()) {
      const auto found = scene_.crew_index.find(crew);
      if (found == scene_.crew_index.end()) fields_.fail("a crew of the header");
      work.crew = found->second;
    }
    work.from = fields_.time("from");
    work.time = fields_.time("time");
    return work;
  }

  LoadChange read_load_change(const std::string& type) const {
    LoadChange change;
    change.kind = type == "attach"   ? LoadChange::Kind::attach
                  : type == "detach" ? LoadChange::Kind::detach
                                     : LoadChange::Kind::remove;
    change.component = component();
    if (change.kind != LoadChange::Kind::remove) {
      robot();
      change.X = fields_.pose("pose");
      if (fields_.has("overtime")) change.overtime = fields_.time("overtime");
    }
    return change;
  }

  TaskEnd read_task_end() const {
    TaskEnd end{read_result(), fields_.text("reason"), {}, {}};
    if (fields_.has("driving")) end.driving = fields_.number("driving");
    if (fields_.has("serving")) {
      for (const Json& seconds : fields_.array("serving")) {
        end.serving.push_back(number_of(seconds, "'serving'"));
      }
    }
    return end;
  }

  MotionEnd read_end() const {
    MotionEnd end;
    end.status = fields_.text("status");
    end.reached = fields_.truth("reached");
    end.tries = fields_.integer("tries");
    end.accepted = fields_.integer("accepted");
    for (const auto& [reason, count] : fields_.object("rejected").json().items()) {
      end.refused_for[reason] = integer_of(count, "'rejected'", 0, 10'000'000);
      end.refused += end.refused_for[reason];
    }
    end.q = configuration();
    const JsonFields residual = fields_.object("residual");
    for (const auto& [name, off] : residual.json().items()) {
      end.residual.emplace_back(parameter(Json(name)), residual.number(name.c_str()));
    }
    if (fields_.has("position_error")) end.position_error = fields_.number("position_error");
    if (fields_.has("orientation_error")) {
      end.orientation_error = fields_.number("orientation_error");
    }
    if (fields_.has("missed")) {
      const Json& missed = fields_.array("missed");
      const Json& off = fields_.array("missed_by");
      if (missed.size() != off.size()) fields_.fail("a distance for each missed waypoint");
      for (std::size_t i = 0; i < missed.size(); ++i) {
        end.missed.emplace_back(integer_of(missed[i], "'missed'", 1, 10'000'000),
                                number_of(off[i], "'missed_by'"));
      }
    }
    return end;
  }

  TaskResult read_result() const {
    const std::string& result = fields_.text("result");
    if (result == "done") return TaskResult::done;
    if (result == "short") return TaskResult::ended_short;
    if (result == "rejected") return TaskResult::rejected;
    if (result == "not reached") return TaskResult::not_reached;
    fields_.fail("done, short, rejected or not reached");
  }

  const JsonFields& fields_;
  const Scene& scene_;
  Record& record_;
};

}  // namespace

int TraceReader::run_of(const std::string& task) {
  const auto [place, added] = run_index_.try_emplace(task, static_cast<int>(trace_.runs.size()));
  if (added) trace_.runs.push_back(task);
  return place->second;
}

void TraceReader::line(const std::string& text) {
  ++trace_.lines;
  try {
    if (trace_.lines == 1) {
      trace_.scene = read_scene(text);
      return;
    }
    const Json json = parse_json(text);
    const JsonFields fields(json, "a record");
    const std::string& type = fields.text("type");
    if (is_script_record(type)) return;
    if (type == "moving") {
      trace_.movings.push_back(read_moving(fields));
      return;
    }
    if (type == "breakdown") {
      trace_.breakdowns.push_back(read_breakdown(fields));
      return;
    }
    if (type == "lost_days") {
      LostDaysRecord lost{trace_.lines, fields.text("calendar"), fields.integer("of"), {}};
      for (const Json& day : fields.array("days")) lost.days.push_back(text_of(day, "a date"));
      trace_.lost_days.push_back(std::move(lost));
      return;
    }
    Record record;
    record.line = trace_.lines;
    record.run = run_of(fields.text("task"));
    const std::string& robot = fields.text("robot");
    if (!robot.empty()) {
      const auto found = trace_.scene.robot_index.find(robot);
      if (found == trace_.scene.robot_index.end()) fields.fail("a robot of the header");
      record.robot = found->second;
    }
    // A waypoint has no moment of its own: it begins when what comes before it is over.
    Ticks& last = last_time_[record.run];
    record.time = last;
    RecordReader(fields, trace_.scene, record).read(type);
    last = record.time;
    trace_.records.push_back(std::move(record));
  } catch (const UnreadableInput& error) {
    throw UnreadableInput(fmt::format("{}: {}", trace_.lines, error.what()));
  }
}

MovingRecord TraceReader::read_moving(const JsonFields& fields) const {
  MovingRecord record;
  record.line = trace_.lines;
  const std::string& name = fields.text("name");
  for (std::size_t i = 0; i < trace_.scene.movings.size(); ++i) {
    if (trace_.scene.movings[i].name == name) record.moving = static_cast<int>(i);
  }
  if (record.moving < 0) fields.fail("something of the header that moves by a timetable");
  record.time = fields.time("t");
  record.by = fields.text("by");
  record.delay = fields.time("delay");
  return record;
}

BreakdownRecord TraceReader::read_breakdown(const JsonFields& fields) const {
  BreakdownRecord record;
  record.line = trace_.lines;
  const auto robot = trace_.scene.robot_index.find(fields.text("machine"));
  if (robot == trace_.scene.robot_index.end()) fields.fail("a robot of the header");
  record.robot = robot->second;
  record.during = fields.text("during");
  record.every = fields.time("every");
  record.worked = fields.time("worked");
  record.repair = fields.time("repair");
  record.from = fields.time("t");
  record.until = fields.time("until");
  return record;
}

Trace TraceReader::finish() {
  if (trace_.lines == 0) throw UnreadableInput("1: expected the header of a trace, found nothing");
  return std::move(trace_);
}

}  // namespace rubicon::verify
