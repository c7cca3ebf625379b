#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "src/simulation/schedule/ticks.hpp"
#include "src/simulation/trace/header.hpp"
#include "src/simulation/trace/shape_reader_simdjson.hpp"
#include "src/simulation/trace/trace_reader.hpp"

namespace rubicon::trace {

namespace {

using Element = simdjson::dom::element;

constexpr int kDaysOfAWeek = 7;
constexpr int kMinutesOfADay = 24 * 60;

/// Two whole numbers from 0 to `most`.
std::pair<int, int> read_pair(const JsonValue& value, int most) {
  std::vector<int> pair;
  for (const Element element : value.list()) {
    pair.push_back(JsonValue{element, value.place}.whole());
  }
  if (pair.size() != 2 || std::max(pair[0], pair[1]) > most) {
    value.fail(fmt::format("two whole numbers from 0 to {}", most));
  }
  return {pair[0], pair[1]};
}

/// The members of an object that are numbers.
HeaderValues read_values(const JsonObject& object) {
  HeaderValues values;
  for (const auto member : object.members()) {
    values.emplace_back(member.key, object.number(member.key));
  }
  return values;
}

/// Texts by name; none where there is no such member.
HeaderAttributes read_texts(const JsonObject& object, const char* name) {
  HeaderAttributes result;
  if (!object.has(name)) return result;
  const JsonObject texts = object.object(name);
  for (const auto member : texts.members()) {
    result.emplace_back(member.key, texts.text(member.key));
  }
  return result;
}

HeaderAttributes read_attributes(const JsonObject& object) {
  return read_texts(object, "attributes");
}

HeaderGoal read_goal(const JsonObject& object) {
  HeaderGoal goal;
  for (const auto member : object.members()) {
    if (member.key == "pose") {
      goal.pose = object.pose("pose");
    } else {
      const auto value = object.number_or_null(member.key);
      if (value) goal.values.emplace_back(member.key, *value);
    }
  }
  return goal;
}

HeaderCalendar read_calendar(const JsonObject& object) {
  HeaderCalendar calendar;
  calendar.name = object.text("name");
  object.each_object("shifts", [&](const JsonObject& entry) {
    HeaderCalendar::Shift shift;
    std::tie(shift.first_day, shift.last_day) = read_pair(entry.at("days"), kDaysOfAWeek - 1);
    entry.each("minutes", [&](const JsonValue& pair) {
      shift.minutes.push_back(read_pair(pair, kMinutesOfADay));
    });
    calendar.shifts.push_back(std::move(shift));
  });
  calendar.off = object.texts("off");
  calendar.carry_over = object.truth("carry_over");
  return calendar;
}

HeaderParameter read_parameter(const JsonObject& object) {
  HeaderParameter parameter;
  parameter.name = object.text("name");
  parameter.body = object.text("body");
  const std::string kind = object.text("kind");
  if (kind != "translation" && kind != "rotation") {
    object.at("kind").fail("translation or rotation");
  }
  parameter.rotation = kind == "rotation";
  parameter.cyclic = object.truth("cyclic");
  parameter.lower = object.number_or_null("lower");
  parameter.upper = object.number_or_null("upper");
  parameter.step = object.number("step");
  parameter.speed = object.number("speed");
  parameter.loaded_speed = object.number("loaded_speed");
  if (object.has("acceleration")) parameter.acceleration = object.number("acceleration");
  parameter.start = object.number("start");
  parameter.prefer = object.number("prefer") < 0 ? -1 : 1;
  parameter.derived = object.has("derived");
  parameter.formula = object.text(parameter.derived ? "derived" : "rule");
  return parameter;
}

/// The member `bodies`; parents come before children.
std::vector<HeaderBody> read_bodies(const JsonObject& robot, const HeaderMeshes& meshes) {
  std::vector<HeaderBody> bodies;
  robot.each_object("bodies", [&](const JsonObject& object) {
    HeaderBody body{object.text("name"), object.text_or_null("parent"), object.text("frame"),
                    read_shapes(object, "shapes", meshes)};
    if (!body.parent.empty() &&
        std::none_of(bodies.begin(), bodies.end(),
                     [&](const HeaderBody& each) { return each.name == body.parent; })) {
      object.at("parent").fail("a body before this one");
    }
    if (object.has("buffer")) {
      body.buffer = object.number("buffer");
      if (!(body.buffer > 0)) object.at("buffer").fail("a number greater than 0");
    }
    if (object.has("rope")) {
      const JsonObject rope = object.object("rope");
      body.rope = HeaderRope{rope.number("radius"), rope.text("from"), rope.point("p_from"),
                             rope.point("p_to")};
      if (!(body.rope->radius > 0)) rope.at("radius").fail("a number greater than 0");
      if (body.parent.empty()) object.at("parent").fail("the body that the rope goes to");
      if (std::none_of(bodies.begin(), bodies.end(),
                       [&](const HeaderBody& each) { return each.name == body.rope->from; })) {
        rope.at("from").fail("a body before this one");
      }
    }
    bodies.push_back(std::move(body));
  });
  return bodies;
}

/// What a robot file says of its machine.
void read_model(const JsonObject& object, const HeaderMeshes& meshes, HeaderRobot& robot) {
  const auto expect_body = [&](const JsonValue& value, const std::string& name) {
    if (std::none_of(robot.bodies.begin(), robot.bodies.end(),
                     [&](const HeaderBody& body) { return body.name == name; })) {
      value.fail("a body of the robot");
    }
  };
  robot.time_step = object.number("time_step");
  robot.sensor = object.number("sensor");
  robot.bodies = read_bodies(object, meshes);
  object.each_object("parameters", [&](const JsonObject& parameter) {
    robot.parameters.push_back(read_parameter(parameter));
    expect_body(parameter.at("body"), robot.parameters.back().body);
  });
  const JsonObject tool = object.object("tool");
  robot.tool_body = tool.text("body");
  expect_body(tool.at("body"), robot.tool_body);
  robot.tool_frame = tool.text("frame");
  object.each("touching", [&](const JsonValue& value) {
    std::vector<std::string> pair;
    for (const Element element : value.list()) {
      pair.push_back(JsonValue{element, value.place}.text());
      expect_body({element, value.place}, pair.back());
    }
    if (pair.size() != 2) value.fail("two bodies");
    robot.touching.emplace_back(pair[0], pair[1]);
  });
  object.each("capacity", [&](const JsonValue& value) {
    const std::vector<double> point = value.numbers(2);
    robot.capacity.emplace_back(point[0], point[1]);
  });
}

HeaderRobot read_robot(const JsonObject& object, const HeaderMeshes& meshes) {
  HeaderRobot robot;
  robot.name = object.text("name");
  robot.type = object.text("type");
  robot.path = object.text("path");
  robot.X_WM = object.pose("pose");
  robot.cost_per_hour = object.number_or_null("cost_per_hour");
  robot.calendar = object.text("calendar");
  if (!object.at("park").is_null()) robot.park = read_values(object.object("park"));
  read_model(object, meshes, robot);
  const JsonObject start = object.object("start");
  for (const HeaderParameter& parameter : robot.parameters) {
    robot.start.push_back(start.number(parameter.name));
  }
  return robot;
}

HeaderWork read_work(const JsonObject& object) {
  return {object.number("duration"), object.text_or_null("crew"), object.has("turning")};
}

std::optional<HeaderWork> read_work_if_any(const JsonObject& task, std::string_view name) {
  if (!task.has(name)) return std::nullopt;
  return read_work(task.object(name));
}

HeaderTask read_task(const JsonObject& object, const HeaderMeshes& meshes) {
  HeaderTask task;
  task.name = object.text("name");
  task.robot = object.text("robot");
  task.crews = object.texts("crews");
  if (object.has("move")) {
    task.move = object.text("move");
    task.X_WO_goal = object.pose("to");
  }
  if (object.has("go")) task.go = read_goal(object.object("go"));
  if (object.has("via")) {
    object.each_object("via", [&](const JsonObject& goal) { task.via.push_back(read_goal(goal)); });
  }
  if (object.has("within")) task.within = read_values(object.object("within"));
  if (object.has("situations")) task.situations = object.texts("situations");
  task.hook = read_work_if_any(object, "hook");
  task.adjust = read_work_if_any(object, "adjust");
  task.release = read_work_if_any(object, "release");
  if (object.has("takes")) {
    object.each_object("takes",
                       [&](const JsonObject& work) { task.takes.push_back(read_work(work)); });
  }
  if (object.has("remove")) task.remove = object.texts("remove");
  task.priority = object.number("priority");
  task.zones = read_shapes(object, "zones", meshes);
  if (object.has("zones_overhead")) {
    task.zones_overhead = read_shapes(object, "zones_overhead", meshes);
  }
  object.each_object("after", [&](const JsonObject& link) {
    task.after.push_back({link.text("task"), link.text("type"), link.number("lag")});
  });
  task.attributes = read_attributes(object);
  return task;
}

Element parse(simdjson::dom::parser& parser, std::string_view line) {
  Element root;
  const auto error = parser.parse(line.data(), line.size()).get(root);
  if (error != simdjson::SUCCESS) {
    throw std::invalid_argument(
        fmt::format("expected a header, found no JSON: {}", simdjson::error_message(error)));
  }
  return root;
}

/// Members of other formats and versions mean other things: nothing else is looked at before.
void expect_format(const JsonObject& header) {
  if (header.text("type") != "header") header.at("type").fail("\"header\"");
  if (header.text("format") != "rubicon-trace") header.at("format").fail("\"rubicon-trace\"");
}

void expect_version(const JsonObject& header) {
  if (header.whole("version") == kTraceVersion) return;
  throw std::invalid_argument(fmt::format(
      "the trace has version {}; this rubicon reads {}: read it with the rubicon that wrote it, or "
      "run the plan again",
      header.whole("version"), kTraceVersion));
}

void read_plan(const JsonObject& header, TraceHeader& read) {
  read.plan = header.text("plan");
  read.path = header.text("path");
  const std::string form = header.text("form");
  if (form != "short" && form != "full") header.at("form").fail("short or full");
  read.short_form = form == "short";
  read.detail = header.text("detail");
  read.contact = header.number("contact");
  read.budget = header.number("budget");
  read.situations = header.texts("situations");
  if (!header.at("start_at").is_null()) read.start_at = header.text("start_at");
  read.currency = header.text("currency");
  header.each_object("calendars", [&](const JsonObject& calendar) {
    read.calendars.push_back(read_calendar(calendar));
  });
  header.each_object("files", [&](const JsonObject& file) {
    read.files.push_back({file.text("path"), file.text("sha256"), file.text("text")});
  });
  read.set = read_texts(header, "set");
}

HeaderMoving read_moving(const JsonObject& object, const HeaderMeshes& meshes) {
  HeaderMoving moving;
  moving.name = object.text("name");
  object.each_object("path", [&](const JsonObject& place) {
    const std::int64_t time = schedule::ticks_from_seconds(place.number("t"));
    if (!moving.timetable.places.empty() && time <= moving.timetable.end()) {
      throw std::invalid_argument("the times of a path do not ascend");
    }
    moving.timetable.places.push_back({time, place.pose("pose")});
  });
  if (moving.timetable.places.size() < 2) {
    throw std::invalid_argument("a path has fewer than two places");
  }
  moving.timetable.repeat = object.truth("repeat");
  moving.shapes = read_shapes(object, "shapes", meshes);
  if (object.has("overhead")) moving.overhead = read_shapes(object, "overhead", meshes);
  return moving;
}

TraceHeader read_scene(const JsonObject& header) {
  TraceHeader read;
  read_plan(header, read);
  read.meshes = read_meshes(header);
  read.site = read_shapes(header, "site", read.meshes);
  if (header.has("site_names")) read.site_names = header.texts("site_names");
  if (header.has("storages")) {
    header.each_object("storages", [&](const JsonObject& object) {
      read.storages.push_back({object.text("name"), read_shapes(object, "shapes", read.meshes)});
    });
  }
  if (header.has("networks")) {
    header.each_object("networks", [&](const JsonObject& object) {
      HeaderNetwork& network = read.networks.emplace_back();
      network.name = object.text("name");
      object.each_object("nodes", [&](const JsonObject& node) {
        network.nodes.push_back({node.text("name"), node.pose("pose")});
      });
    });
  }
  if (header.has("fleets")) {
    header.each_object("fleets", [&](const JsonObject& object) {
      read.fleets.push_back({object.text("name"), object.text("network"), object.texts("robots")});
    });
  }
  if (header.has("movings")) {
    header.each_object("movings", [&](const JsonObject& object) {
      read.movings.push_back(read_moving(object, read.meshes));
    });
  }
  header.each_object("components", [&](const JsonObject& object) {
    read.components.push_back({object.text("name"), object.pose("pose"), object.pose("grip"),
                               object.number("mass"), read_shapes(object, "shapes", read.meshes),
                               read_attributes(object)});
  });
  header.each_object("robots", [&](const JsonObject& object) {
    read.robots.push_back(read_robot(object, read.meshes));
  });
  read.carry = read_shapes(header, "carry", read.meshes);
  header.each_object("crews", [&](const JsonObject& object) {
    read.crews.push_back({object.text("name"), object.number("size"),
                          object.number_or_null("cost_per_hour"), object.text("calendar")});
  });
  if (header.has("via")) {
    header.each_object("via", [&](const JsonObject& goal) { read.via.push_back(read_goal(goal)); });
  }
  if (header.has("goal")) read.goal = read_goal(header.object("goal"));
  header.each_object("tasks", [&](const JsonObject& object) {
    read.tasks.push_back(read_task(object, read.meshes));
  });
  return read;
}

}  // namespace

TraceHeader read_header(std::string_view line) {
  simdjson::dom::parser parser;
  std::optional<JsonObject> header;
  try {
    header.emplace(parse(parser, line), "the header of the trace");
    expect_format(*header);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(
        fmt::format("this is no trace: {}; 'rubicon run PLAN --out DIR' writes one", error.what()));
  }
  expect_version(*header);
  try {
    return read_scene(*header);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(
        fmt::format("this is no header of a trace: {}; run the plan again", error.what()));
  }
}

}  // namespace rubicon::trace
