#include "src/results/verify/input/read_scene.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "src/motion/math/angles.hpp"
#include "src/results/verify/input/json_fields.hpp"
#include "src/results/verify/input/read_robot.hpp"
#include "src/results/verify/input/read_shapes.hpp"
#include "src/results/verify/input/read_times.hpp"

namespace rubicon::verify {

namespace {

const Json& list_or_empty(const JsonFields& fields, const char* name) {
  static const Json kEmpty = Json::array();
  return fields.has(name) ? fields.array(name) : kEmpty;
}

int index_in(const std::map<std::string, int>& index, const std::string& name, const char* what) {
  const auto found = index.find(name);
  if (found == index.end()) {
    throw UnreadableInput(fmt::format("expected {} of the header, found '{}'", what, name));
  }
  return found->second;
}

/// Everything that is spoken of by name has one of its own.
void add_name(std::map<std::string, int>& index, const std::string& name) {
  const int next = static_cast<int>(index.size());
  if (!index.emplace(name, next).second) {
    throw UnreadableInput(fmt::format("expected different names, found '{}' twice", name));
  }
}

int calendar_named(const Scene& scene, const JsonFields& fields, const char* member) {
  const std::string name = fields.text_or(member, "");
  if (name.empty()) return -1;
  for (std::size_t i = 0; i < scene.calendars.size(); ++i) {
    if (scene.calendars[i].name == name) return static_cast<int>(i);
  }
  fields.fail("the name of a calendar");
}

int calendar_of(const Scene& scene, const JsonFields& fields) {
  return calendar_named(scene, fields, "calendar");
}

SceneCalendar read_calendar(const JsonFields& fields) {
  SceneCalendar calendar;
  calendar.name = fields.text("name");
  calendar.carry_over = fields.has("carry_over") && fields.truth("carry_over");
  for (const Json& object : fields.array("shifts")) {
    const JsonFields read(object, "a shift");
    SceneCalendar::Shift shift;
    const Json& days = read.array("days");
    if (days.size() != 2) read.fail("two days");
    shift.first_day = integer_of(days[0], "a day", 0, 6);
    shift.last_day = integer_of(days[1], "a day", 0, 6);
    for (const Json& pair : read.array("minutes")) {
      if (!pair.is_array() || pair.size() != 2) read.fail("pairs of minutes");
      shift.minutes.emplace_back(integer_of(pair[0], "a minute", 0, 1440),
                                 integer_of(pair[1], "a minute", 0, 1440));
    }
    calendar.shifts.push_back(std::move(shift));
  }
  for (const Json& day : list_or_empty(fields, "off")) {
    calendar.off.push_back(text_of(day, "a day off"));
  }
  for (const Json& share : list_or_empty(fields, "lost")) {
    calendar.lost.push_back(number_of(share, "a share of lost days"));
  }
  if (!calendar.lost.empty() && calendar.lost.size() != 12) fields.fail("12 shares as 'lost'");
  return calendar;
}

void read_components(const JsonFields& header, Scene& scene) {
  for (const Json& object : header.array("components")) {
    const JsonFields fields(object, "a component");
    SceneComponent component;
    component.name = fields.text("name");
    component.X_WO = fields.pose("pose");
    component.X_OG = fields.pose("grip");
    component.mass = fields.number("mass");
    if (fields.has("cost")) component.cost = fields.number("cost");
    for (const auto& [key, names] : {std::pair("fixed_to", &component.fixed_to),
                                     std::pair("braced_by", &component.braced_by)}) {
      for (const Json& name : list_or_empty(fields, key)) names->push_back(text_of(name, "a name"));
    }
    for (const Json& name : list_or_empty(fields, "fixed_after")) {
      component.fixed_after.push_back(text_of(name, "a name"));
    }
    component.fixed_after.resize(component.fixed_to.size());
    component.has_brace_crew = fields.has("braced_by_crews");
    component.attributes = fields.texts("attributes");
    component.shapes = read_shapes(fields.array("shapes"), scene.meshes.size());
    add_name(scene.component_index, component.name);
    scene.components.push_back(std::move(component));
  }
}

std::vector<std::pair<int, double>> read_values(const JsonFields& goal, const SceneRobot& robot) {
  std::vector<std::pair<int, double>> values;
  for (std::size_t i = 0; i < robot.parameters.size(); ++i) {
    const char* name = robot.parameters[i].name.c_str();
    if (goal.has(name)) values.emplace_back(static_cast<int>(i), goal.number(name));
  }
  return values;
}

double cost_per_hour(const JsonFields& fields) {
  return fields.has("cost_per_hour") ? fields.number("cost_per_hour") : 0;
}

SceneCharges read_charges(const JsonFields& fields, const Scene& scene) {
  SceneCharges charges;
  if (fields.has("rental_per_day")) charges.rental_per_day = fields.number("rental_per_day");
  if (fields.has("rental_days")) {
    const Json& days = fields.array("rental_days");
    if (days.size() != 2) fields.fail("two dates");
    charges.rental_days.emplace(text_of(days[0], "a date"), text_of(days[1], "a date"));
  }
  if (fields.has("mobilisation")) charges.mobilisation = fields.number("mobilisation");
  if (fields.has("overtime")) charges.overtime = fields.number("overtime");
  if (fields.has("overtime_outside"))
    charges.normal = calendar_named(scene, fields, "overtime_outside");
  if (fields.has("fuel")) {
    const JsonFields fuel = fields.object("fuel");
    charges.fuel = SceneFuel{fuel.number("working"), fuel.number("idling"), std::nullopt};
    if (fuel.has("price")) charges.fuel->price = fuel.number("price");
  }
  return charges;
}

/// Of 64 bits, whatever they mean.
std::uint64_t any_integer(const JsonFields& fields, const char* name) {
  const Json& value = fields.any(name);
  if (!value.is_number_integer()) fields.fail(fmt::format("a whole number as '{}'", name));
  return value.is_number_unsigned() ? value.get<std::uint64_t>()
                                    : static_cast<std::uint64_t>(value.get<std::int64_t>());
}

/// The law of an object; the times of a `measured` one are read when they are first named.
SceneLaw read_law(const JsonFields& fields, Scene& scene) {
  SceneLaw law;
  law.law = fields.text("law");
  if (law.law != "measured") {
    for (const Json& value : fields.array("values")) {
      law.values.push_back(number_of(value, "a value of a law"));
    }
    return law;
  }
  law.times = times_of(scene, fields.text("file"), fields.text("unit"),
                       integer_of(fields.any("column"), "'column'", 1, 10000));
  return law;
}

void read_resources(const JsonFields& header, Scene& scene) {
  for (const Json& object : list_or_empty(header, "calendars")) {
    scene.calendars.push_back(read_calendar(JsonFields(object, "a calendar")));
  }
  for (const Json& object : header.array("robots")) {
    const JsonFields fields(object, "a robot");
    SceneRobot robot = read_robot(fields, scene.meshes.size());
    robot.calendar = calendar_of(scene, fields);
    robot.cost_per_hour = cost_per_hour(fields);
    robot.charges = read_charges(fields, scene);
    if (fields.has("park")) robot.park = read_values(fields.object("park"), robot);
    add_name(scene.robot_index, robot.name);
    if (fields.has("breakdown")) {
      const JsonFields laws = fields.object("breakdown");
      SceneLaw every = read_law(laws.object("every"), scene);
      robot.breakdown = std::pair(std::move(every), read_law(laws.object("takes"), scene));
    }
    scene.robots.push_back(std::move(robot));
  }
  for (const Json& object : header.array("crews")) {
    const JsonFields fields(object, "a crew");
    SceneCrew& crew = scene.crews.emplace_back();
    crew.name = fields.text("name");
    crew.calendar = calendar_of(scene, fields);
    crew.cost_per_hour = cost_per_hour(fields);
    if (fields.has("size")) crew.size = integer_of(fields.any("size"), "'size'", 1, 1000000);
    crew.charges = read_charges(fields, scene);
    add_name(scene.crew_index, scene.crews.back().name);
  }
}

SceneWork read_work(const Json& object, const char* what, Scene& scene) {
  const JsonFields fields(object, "a work");
  SceneWork work;
  work.what = what;
  work.time = fields.time("duration");
  if (fields.has("crew")) work.crew = index_in(scene.crew_index, fields.text("crew"), "a crew");
  work.turning = fields.has("turning");
  if (fields.has("law")) {
    SceneLaw law = read_law(fields, scene);
    work.law = std::move(law.law);
    work.values = std::move(law.values);
    work.times = law.times;
  }
  return work;
}

SceneWithin read_within(const Json& value) {
  SceneWithin within;
  if (value.is_number()) {
    within.length = number_of(value, "'within'");
    return within;
  }
  const JsonFields fields(value, "'within'");
  for (const auto& [name, number] : value.items()) {
    const double allowed = number_of(number, "'within'");
    if (name == "length") {
      within.length = allowed;
    } else {
      within.values.emplace_back(name, allowed);
    }
  }
  return within;
}

SceneGuides read_guides(const JsonFields& fields, const SceneRobot& robot) {
  SceneGuides guides;
  for (const Json& object : list_or_empty(fields, "guides")) {
    const JsonFields guide(object, "a guide");
    SceneGuide& its = guides[guide.text("name")];
    if (guide.has("turn_radius")) its.turn_radius = guide.number("turn_radius");
    if (guide.has("thinks")) its.thinks = guide.number("thinks");
    for (const Json& bound : guide.array("keep")) {
      const JsonFields kept(bound, "what a guide keeps");
      its.keep.push_back({read_values(kept.object("sum"), robot), kept.number("most")});
    }
  }
  return guides;
}

void read_clauses(const JsonFields& fields, const Scene& scene, SceneTask& task) {
  if (fields.has("free")) {
    static constexpr const char* kTurns[] = {"rotx", "roty", "rotz", "all"};
    const auto* const turn = std::find(std::begin(kTurns), std::end(kTurns), fields.text("free"));
    if (turn == std::end(kTurns)) fields.fail("rotx, roty, rotz or all as 'free'");
    task.free_axis = static_cast<int>(turn - std::begin(kTurns));
  }
  for (const Json& name : list_or_empty(fields, "lock")) {
    const auto& parameters = scene.robots[static_cast<std::size_t>(task.robot)].parameters;
    const std::string& wanted = text_of(name, "'lock'");
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const auto& each) { return each.name == wanted; });
    if (found == parameters.end()) fields.fail("parameters of the robot as 'lock'");
    task.locked.push_back(static_cast<int>(found - parameters.begin()));
  }
  if (fields.has("deviation")) task.deviation = read_deviation(fields.object("deviation"));
  for (const Json& pair : list_or_empty(fields, "enter")) {
    if (!pair.is_array() || pair.size() != 2) fields.fail("a body and a component as 'enter'");
    task.entered.emplace_back(
        text_of(pair[0], "a body"),
        index_in(scene.component_index, text_of(pair[1], "a component"), "a component"));
  }
}

void read_via(const Json& list, const Scene& scene, SceneTask& task) {
  for (const Json& object : list) {
    const JsonFields fields(object, "a waypoint");
    SceneGoal goal;
    if (fields.has("pose")) goal.pose = fields.pose("pose");
    if (task.robot >= 0) {
      goal.values = read_values(fields, scene.robots[static_cast<std::size_t>(task.robot)]);
    }
    task.via.push_back(std::move(goal));
  }
}

/// m
constexpr double kWidestStrip = 100;

/// Sides of what a round column is looked at as, inside its circle.
constexpr int kRoundSides = 32;

/// A row of `columns`: x, y, size, round or not.
FloorHole read_column(const JsonFields& floor, const Json& row, std::size_t number) {
  if (!row.is_array() || row.size() != 4 || !row[0].is_number() || !row[1].is_number() ||
      !row[2].is_number() || !row[3].is_boolean()) {
    floor.fail("x, y, size, and whether it is round, for each of 'columns'");
  }
  FloorHole column{fmt::format("column {}", number), {}};
  const double half = row[2].get<double>() / 2;
  const bool round = row[3].get<bool>();
  const int sides = round ? kRoundSides : 4;
  for (int i = 0; i < sides; ++i) {
    const math::SineCosine turn = math::sine_cosine_deg(360.0 * (i + 0.5) / sides);
    const double reach = round ? half : half * std::sqrt(2.0);
    column.corners.emplace_back(row[0].get<double>() + reach * turn.cosine,
                                row[1].get<double>() + reach * turn.sine);
  }
  return column;
}

void read_holes(const JsonFields& floor, SceneTask& task) {
  for (const Json& column : floor.array("columns")) {
    task.holes.push_back(read_column(floor, column, task.holes.size() + 1));
  }
  int number = 0;
  for (const Json& shaft : floor.array("shafts")) {
    std::vector<std::pair<double, double>> corners;
    const bool is_ring = shaft.is_array() && shaft.size() >= 6 && shaft.size() % 2 == 0;
    for (std::size_t i = 0; is_ring && i < shaft.size(); i += 2) {
      if (!shaft[i].is_number() || !shaft[i + 1].is_number()) break;
      corners.emplace_back(shaft[i].get<double>(), shaft[i + 1].get<double>());
    }
    if (!is_ring || 2 * corners.size() != shaft.size()) {
      floor.fail("x and y of three corners or more for each of 'shafts'");
    }
    task.holes.push_back({fmt::format("shaft {}", ++number), std::move(corners)});
  }
}

void read_cover(const JsonFields& cover, SceneTask& task) {
  SceneCover& figures = task.cover.emplace();
  figures.area = cover.text_or("area", "");
  const auto number = [&](const char* name) { return cover.has(name) ? cover.number(name) : 0; };
  figures.thickness = number("thickness");
  figures.covered = number("covered");
  figures.covered_area = number("covered_area");
  figures.length = number("length");
  figures.depth = number("depth");
  if (cover.has("turns")) figures.turns = cover.integer("turns");
  if (cover.has("holes")) figures.holes = cover.integer("holes");
  if (cover.has("pace")) task.pace = cover.number("pace");
  if (!cover.has("holes")) {
    task.width = cover.number("width");
    if (!(task.width > 0 && task.width <= kWidestStrip)) cover.fail("a width up to 100 m");
  }
  if (cover.has("pose")) task.area = cover.pose("pose");
  if (cover.has("guided")) read_holes(cover.object("floor"), task);
  if (cover.has("turn_radius")) task.turn_radius = cover.number("turn_radius");
  if (cover.has("cold_after")) task.cold_after = cover.time("cold_after");
  for (const Json& works : cover.array("working")) {
    if (!works.is_boolean()) cover.fail("true or false in 'working'");
    task.working.push_back(works.get<bool>());
  }
  if (task.working.size() != task.via.size() + 1) {
    cover.fail("one value in 'working' for each waypoint and the goal");
  }
}

/// Values by parameter, or a pose of the tool.
void read_go(const JsonFields& goal, const Scene& scene, SceneTask& task) {
  task.goes = true;
  if (goal.has("pose")) task.go_pose = goal.pose("pose");
  if (task.robot < 0) return;
  task.go = read_values(goal, scene.robots[static_cast<std::size_t>(task.robot)]);
}

std::int64_t volume_of(const JsonFields& fields, const char* name, std::int64_t least) {
  const Json& value = fields.any(name);
  const bool fits = value.is_number_integer() && value.get<std::int64_t>() >= least &&
                    value.get<std::int64_t>() <= 2'000'000'000'000'000'000;
  if (!fits) fields.fail(fmt::format("whole mm3 as '{}'", name));
  return value.get<std::int64_t>();
}

SceneStage read_stage(const JsonFields& fields, std::string name, Scene& scene) {
  SceneStage stage;
  stage.name = std::move(name);
  stage.seconds = fields.number("seconds");
  if (fields.has("law")) {
    SceneLaw law = read_law(fields, scene);
    stage.law = std::move(law.law);
    stage.values = std::move(law.values);
    stage.times = law.times;
  }
  if (stage.law == "sequence" && stage.values.empty()) fields.fail("values of a sequence");
  if (fields.has("servers")) {
    stage.servers = integer_of(fields.any("servers"), "'servers'", 1, 1000000);
    stage.crew = index_in(scene.crew_index, fields.text("by"), "a crew");
  }
  return stage;
}

}  // namespace

std::string Scene::site_name(std::size_t i) const {
  if (i < site_names.size() && !site_names[i].empty()) return site_names[i];
  std::size_t unnamed = site.size();
  for (const std::string& each : site_names) unnamed -= each.empty() ? 0 : 1;
  return unnamed == 1 ? "site" : fmt::format("site {}", i + 1);
}

namespace {

std::vector<std::int64_t> read_heights(const JsonFields& fields, const char* name,
                                       std::size_t count) {
  std::vector<std::int64_t> heights;
  for (const Json& value : fields.array(name)) {
    if (!value.is_number_integer()) fields.fail(fmt::format("whole mm as '{}'", name));
    heights.push_back(value.get<std::int64_t>());
  }
  if (heights.size() != count) fields.fail(fmt::format("a height for each cell as '{}'", name));
  for (const std::int64_t height : heights) {
    if (std::llabs(height) > 100'000'000)
      fields.fail(fmt::format("heights on earth as '{}'", name));
  }
  return heights;
}

SceneDig read_dig(const JsonFields& fields, Scene& scene) {
  SceneDig dig;
  dig.volume = volume_of(fields, "volume", 1);
  dig.load = volume_of(fields, "load", 1);
  if (fields.has("bucket")) dig.bucket = volume_of(fields, "bucket", 1);
  dig.loading = read_stage(fields.object("loading"), "load", scene);
  for (const Json& object : fields.array("diggers")) {
    const JsonFields crew(object, "a crew that digs");
    dig.diggers.push_back(integer_of(crew.any("count"), "'count'", 1, 1000000));
    dig.digger_crews.push_back(index_in(scene.crew_index, crew.text("crew"), "a crew"));
  }
  dig.trucks = integer_of(fields.any("trucks"), "'trucks'", 1, 1000000);
  dig.hauled_by = index_in(scene.crew_index, fields.text("hauled_by"), "a crew");
  if (fields.has("loaded"))
    dig.loaded = integer_of(fields.any("loaded"), "'loaded'", 0, dig.trucks);
  bool tips = false;
  for (const Json& object : fields.array("stages")) {
    const JsonFields stage(object, "a stage of a dig");
    dig.stages.push_back(read_stage(stage, stage.text("name"), scene));
    if (dig.stages.back().name != fields.text("tip")) continue;
    dig.tip = dig.stages.size() - 1;
    tips = true;
  }
  if (!tips || dig.diggers.empty()) fields.fail("diggers, and the stage that tips");
  if (fields.has("efficiency")) dig.efficiency = fields.number("efficiency");
  if (!(dig.efficiency > 0)) fields.fail("an efficiency above 0");
  dig.soil = fields.text_or("soil", "");
  if (fields.has("pit")) {
    const JsonFields pit = fields.object("pit");
    ScenePit& read = dig.pit.emplace();
    read.X_WE = pit.pose("pose");
    read.columns = integer_of(pit.any("columns"), "'columns'", 1, 1'000'000);
    read.cell = integer_of(pit.any("cell"), "'cell'", 1, 1'000'000);
    for (const Json& value : pit.array("cells")) {
      read.cells.push_back(integer_of(value, "'cells'", 0, 1'000'000'000));
    }
    read.before = read_heights(pit, "before", read.cells.size());
    read.after = read_heights(pit, "after", read.cells.size());
  }
  if (fields.has("limit")) dig.limit = fields.time("limit");
  dig.loads =
      fields.any("loads").is_number_integer() ? fields.any("loads").get<std::int64_t>() : -1;
  dig.tipped = volume_of(fields, "tipped", 0);
  dig.time = fields.time("time");
  return dig;
}

SceneMotionDig read_motion_dig(const JsonFields& fields, Scene& scene) {
  SceneMotionDig dig;
  dig.soil = index_in(scene.component_index, fields.text("soil"), "a component");
  dig.volume = volume_of(fields, "volume", 1);
  dig.bucket = volume_of(fields, "bucket", 1);
  dig.tolerance = volume_of(fields, "tolerance", 0);
  dig.X_WE = fields.pose("pose");
  dig.columns = integer_of(fields.any("columns"), "'columns'", 1, 1'000'000);
  dig.cell = integer_of(fields.any("cell"), "'cell'", 1, 1'000'000);
  for (const Json& value : fields.array("cells")) {
    dig.cells.push_back(integer_of(value, "'cells'", 0, 1'000'000'000));
    if (dig.cells.size() > 1 && dig.cells[dig.cells.size() - 2] >= dig.cells.back()) {
      fields.fail("cells in their order");
    }
  }
  dig.before = read_heights(fields, "before", dig.cells.size());
  dig.after = read_heights(fields, "after", dig.cells.size());
  const Json& place = fields.array("place");
  if (place.size() != 3) fields.fail("three numbers as 'place'");
  for (int i = 0; i < 3; ++i) {
    dig.p_W[i] = number_of(place[static_cast<std::size_t>(i)], "a coordinate");
  }
  if (fields.has("swell")) dig.swell = fields.number("swell");
  if (fields.has("load_at")) dig.load_at = fields.pose("load_at");
  if (fields.has("fill")) dig.fill = read_work(fields.any("fill"), "fill", scene);
  if (fields.has("dump")) dig.dump = read_work(fields.any("dump"), "dump", scene);
  if (!fields.has("trucks")) return dig;
  if (fields.has("hauled_by")) {
    dig.hauled_by = index_in(scene.crew_index, fields.text("hauled_by"), "a crew");
  }
  dig.trucks = integer_of(fields.any("trucks"), "'trucks'", 1, 1000000);
  dig.load = volume_of(fields, "load", 1);
  bool tips = false;
  for (const Json& object : fields.array("stages")) {
    const JsonFields stage(object, "a stage of a dig");
    dig.stages.push_back(read_stage(stage, stage.text("name"), scene));
    if (dig.stages.back().name != fields.text("tip")) continue;
    dig.tip = dig.stages.size() - 1;
    tips = true;
  }
  if (!tips) fields.fail("the stage that tips");
  if (fields.has("efficiency")) dig.efficiency = fields.number("efficiency");
  if (!(dig.efficiency > 0)) fields.fail("an efficiency above 0");
  return dig;
}

Vec3 read_point(const JsonFields& fields, const char* name) {
  const Json& place = fields.array(name);
  if (place.size() != 3) fields.fail(fmt::format("three numbers as '{}'", name));
  Vec3 p = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    p[i] = number_of(place[static_cast<std::size_t>(i)], "a coordinate");
  }
  return p;
}

SceneHaul read_haul(const JsonFields& fields, Scene& scene) {
  SceneHaul haul;
  for (const Json& name : fields.array("digs")) haul.digs.push_back(text_of(name, "a task"));
  for (const Json& load : fields.array("loads")) {
    if (!load.is_number_integer()) fields.fail("whole mm3 as 'loads'");
    haul.loads.push_back(load.get<std::int64_t>());
  }
  if (haul.loads.size() != haul.digs.size()) fields.fail("a load for each dig");
  for (const Json& pose : fields.array("tips")) haul.tips.push_back(pose_of(pose, "a tip"));
  if (fields.has("tip")) haul.tip = read_work(fields.any("tip"), "tip", scene);
  if (!fields.has("heap")) return haul;
  haul.heap = index_in(scene.component_index, fields.text("heap"), "a component");
  haul.p_TH = read_point(fields, "falls_at");
  return haul;
}

SceneHeap read_heap(const JsonFields& fields, Scene& scene) {
  SceneHeap heap;
  heap.component = index_in(scene.component_index, fields.text("component"), "a component");
  heap.X_WE = fields.pose("pose");
  heap.columns = integer_of(fields.any("columns"), "'columns'", 1, 1'000'000);
  heap.cell = integer_of(fields.any("cell"), "'cell'", 1, 1'000'000);
  heap.repose_deg = fields.number("repose");
  heap.ground = read_heights(fields, "ground", fields.array("ground").size());
  if (heap.ground.size() % static_cast<std::size_t>(heap.columns) != 0) {
    fields.fail("whole rows as 'ground'");
  }
  for (const Json& cell : fields.array("dug")) {
    heap.dug.push_back(integer_of(cell, "'dug'", 0, static_cast<int>(heap.ground.size()) - 1));
  }
  return heap;
}

void read_task_work(const JsonFields& fields, Scene& scene, SceneTask& task) {
  if (fields.has("hook")) task.hook = read_work(fields.any("hook"), "hook", scene);
  if (fields.has("adjust")) task.adjust = read_work(fields.any("adjust"), "adjust", scene);
  if (fields.has("release")) task.release = read_work(fields.any("release"), "release", scene);
  for (const Json& work : list_or_empty(fields, "takes")) {
    task.takes.push_back(read_work(work, "takes", scene));
  }
  if (fields.has("dig")) task.dig = read_dig(fields.object("dig"), scene);
  if (fields.has("motion_dig")) {
    task.motion_dig = read_motion_dig(fields.object("motion_dig"), scene);
  }
  if (fields.has("haul")) task.haul = read_haul(fields.object("haul"), scene);
  for (const Json& name : list_or_empty(fields, "remove")) {
    task.remove.push_back(
        index_in(scene.component_index, text_of(name, "'remove'"), "a component"));
  }
  if (fields.has("zones")) task.zones = read_shapes(fields.any("zones"), scene.meshes.size());
  if (fields.has("zones_overhead")) {
    task.zones_overhead = read_shapes(fields.any("zones_overhead"), scene.meshes.size());
  }
}

/// Who does a task, and what.
void read_doing(const JsonFields& fields, Scene& scene, SceneTask& task) {
  const std::string& robot = fields.text("robot");
  if (!robot.empty()) task.robot = index_in(scene.robot_index, robot, "a robot");
  for (const Json& name : fields.array("crews")) {
    task.crews.push_back(index_in(scene.crew_index, text_of(name, "'crews'"), "a crew"));
  }
  if (fields.has("move")) {
    task.move = index_in(scene.component_index, fields.text("move"), "a component");
    task.X_WO_goal = fields.pose("to");
  }
  if (fields.has("go")) read_go(fields.object("go"), scene, task);
  for (const Json& name : list_or_empty(fields, "also_robots")) {
    task.also_robots.push_back(
        index_in(scene.robot_index, text_of(name, "'also_robots'"), "a robot"));
  }
  if (fields.has("needs")) {
    for (const auto& [name, people] : fields.object("needs").json().items()) {
      const int crew = index_in(scene.crew_index, name, "a crew");
      task.needs[crew] =
          integer_of(people, "'needs'", 1, scene.crews[static_cast<std::size_t>(crew)].size);
    }
  }
  read_via(list_or_empty(fields, "via"), scene, task);
  if (fields.has("cover")) read_cover(fields.object("cover"), task);
  const bool has_choices = fields.has("choices");
  if ((task.move >= 0 || task.goes) && task.robot < 0 && !has_choices) {
    fields.fail("a robot for the motion");
  }
  if (fields.has("within")) task.within = read_within(fields.any("within"));
  if (task.robot >= 0) {
    read_clauses(fields, scene, task);
    task.guides = read_guides(fields, scene.robots[static_cast<std::size_t>(task.robot)]);
  }
}

SceneTask read_task(const JsonFields& fields, Scene& scene) {
  SceneTask task;
  task.name = fields.text("name");
  read_doing(fields, scene, task);
  read_task_work(fields, scene, task);
  task.whole = task.move >= 0 && fields.has("whole") && fields.truth("whole");
  task.attributes = fields.texts("attributes");
  if (fields.has("not_before")) task.not_before = fields.time("not_before");
  if (fields.has("due")) task.due = fields.time("due");
  if (fields.has("baseline")) {
    const JsonFields baseline = fields.object("baseline");
    task.baseline = std::pair(baseline.time("start"), baseline.time("finish"));
  }
  for (const Json& object : list_or_empty(fields, "choices")) {
    const JsonFields choice(object, "a choice of a task");
    SceneTask& spec = task.choices.emplace_back();
    spec.name = task.name;
    spec.members = choice.text("members");
    read_doing(choice, scene, spec);
    read_task_work(choice, scene, spec);
    spec.zones = task.zones;
    spec.zones_overhead = task.zones_overhead;
    spec.not_before = task.not_before;
    spec.due = task.due;
    spec.baseline = task.baseline;
    spec.attributes = task.attributes;
    spec.whole = spec.move >= 0 && choice.has("whole") && choice.truth("whole");
  }
  return task;
}

LinkType link_type(const JsonFields& fields) {
  const std::string& type = fields.text("type");
  if (type == "FS") return LinkType::FS;
  if (type == "SS") return LinkType::SS;
  if (type == "FF") return LinkType::FF;
  if (type == "SF") return LinkType::SF;
  fields.fail("FS, SS, FF or SF");
}

void read_tasks(const JsonFields& header, Scene& scene) {
  for (const Json& object : header.array("tasks")) {
    const JsonFields fields(object, "a task");
    scene.tasks.push_back(read_task(fields, scene));
    add_name(scene.task_index, scene.tasks.back().name);
  }
  for (std::size_t i = 0; i < scene.tasks.size(); ++i) {
    const JsonFields task(header.array("tasks")[i], "a task");
    if (task.has("same_as")) {
      scene.tasks[i].same_as = index_in(scene.task_index, task.text("same_as"), "a task");
    }
    for (const Json& object :
         list_or_empty(JsonFields(header.array("tasks")[i], "a task"), "after")) {
      const JsonFields fields(object, "a link");
      SceneLink link;
      link.task = index_in(scene.task_index, fields.text("task"), "a task");
      link.type = link_type(fields);
      link.lag = fields.time("lag");
      scene.tasks[i].after.push_back(link);
    }
  }
}

SceneBeginning read_beginning(const JsonFields& fields) {
  SceneBeginning beginning;
  for (const Json& object : fields.array("overlaps")) {
    const JsonFields pair(object, "an overlap");
    beginning.overlaps.push_back({pair.text("first"), pair.text("second"), pair.number("depth")});
  }
  for (const Json& pair : fields.array("waived")) {
    if (!pair.is_array() || pair.size() != 2) fields.fail("pairs of names");
    beginning.waived.emplace_back(text_of(pair[0], "a name"), text_of(pair[1], "a name"));
  }
  return beginning;
}

SceneMoving read_moving(const JsonFields& fields, std::size_t meshes) {
  SceneMoving moving;
  moving.name = fields.text("name");
  for (const Json& object : fields.array("path")) {
    const JsonFields place(object, "a place of a path");
    moving.path.push_back({place.time("t"), place.pose("pose")});
    const std::size_t count = moving.path.size();
    if (count > 1 && moving.path[count - 2].time >= moving.path[count - 1].time) {
      fields.fail("times that ascend in 'path'");
    }
  }
  if (moving.path.size() < 2) fields.fail("two or more places in 'path'");
  moving.repeat = fields.truth("repeat");
  moving.shapes = read_shapes(fields.array("shapes"), meshes);
  if (fields.has("overhead")) moving.overhead = read_shapes(fields.any("overhead"), meshes);
  return moving;
}

/// The one motion of a short plan is a task without goal here: it may end short.
void add_short_task(const JsonFields& header, Scene& scene) {
  if (scene.robots.size() != 1) throw UnreadableInput("expected one robot in a short plan");
  SceneTask task;
  task.name = scene.plan;
  task.robot = 0;
  task.goes = true;
  read_via(list_or_empty(header, "via"), scene, task);
  if (header.has("goal")) read_go(header.object("goal"), scene, task);
  if (header.has("within")) task.within = read_within(header.any("within"));
  read_clauses(header, scene, task);
  task.guides = read_guides(header, scene.robots.front());
  add_name(scene.task_index, task.name);
  scene.tasks.push_back(std::move(task));
}

}  // namespace

Scene read_scene(const std::string& line) {
  const Json json = parse_json(line);
  const JsonFields header(json, "the header");
  if (header.text("type") != "header" || header.text("format") != "rubicon-trace") {
    header.fail("\"type\":\"header\" and \"format\":\"rubicon-trace\"");
  }
  if (header.integer("version") != 1) header.fail("version 1");
  if (header.text("detail") != "steps") {
    header.fail("every step (rubicon run --trace-detail steps)");
  }
  Scene scene;
  scene.plan = header.text("plan");
  scene.short_form = header.text("form") == "short";
  scene.sampled = header.has("sample");
  if (scene.sampled) {
    const JsonFields sample(header.any("sample"), "'sample'");
    scene.seed = any_integer(sample, "seed");
    scene.run = any_integer(sample, "run");
  }
  scene.contact = header.number("contact");
  scene.start_at = header.text_or("start_at", "");
  scene.currency = header.text_or("currency", "");
  if (header.has("overhead_per_day")) scene.overhead_per_day = header.number("overhead_per_day");
  for (const Json& object : list_or_empty(header, "files")) {
    const JsonFields file(object, "a file");
    scene.files.push_back({file.text("path"), file.text("text"), file.text("sha256")});
  }
  scene.meshes = read_meshes(header.array("meshes"));
  scene.site = read_shapes(header.array("site"), scene.meshes.size());
  for (const Json& name : list_or_empty(header, "site_names")) {
    scene.site_names.push_back(name.is_string() ? name.get<std::string>() : "");
  }
  scene.carry = read_shapes(header.array("carry"), scene.meshes.size());
  for (const Json& object : list_or_empty(header, "movings")) {
    scene.movings.push_back(read_moving(JsonFields(object, "a moving"), scene.meshes.size()));
  }
  if (header.has("beginning")) {
    scene.beginning = read_beginning(JsonFields(header.any("beginning"), "'beginning'"));
  }
  if (header.has("support")) {
    const JsonFields fields(header.any("support"), "'support'");
    SceneSupport& support = scene.support.emplace();
    support.mode = fields.text("mode");
    support.gap = fields.number("gap");
    if (fields.has("friction")) support.friction = fields.number("friction");
    for (const Json& name : list_or_empty(fields, "floating")) {
      support.floating.push_back(text_of(name, "a name"));
    }
  }
  read_components(header, scene);
  read_resources(header, scene);
  if (scene.short_form) {
    add_short_task(header, scene);
  } else {
    read_tasks(header, scene);
  }
  if (header.has("workspaces")) {
    const JsonFields fields(header.any("workspaces"), "'workspaces'");
    SceneWorkspaces& rules = scene.workspaces.emplace();
    for (const Json& name : fields.array("of")) {
      rules.robots.push_back(index_in(scene.robot_index, text_of(name, "a robot"), "a robot"));
    }
    rules.reaction = fields.number("reaction");
    rules.braking = fields.number("braking");
    rules.turn_braking = fields.number("turn_braking");
    if (fields.has("foreseen")) rules.foreseen = fields.number("foreseen");
    rules.watch = fields.has("watch") && fields.truth("watch");
    if (!(rules.reaction >= 0 && rules.braking > 0 && rules.turn_braking > 0)) {
      fields.fail("a reaction from 0, brakings above 0");
    }
  }
  for (const Json& object : list_or_empty(header, "heaps")) {
    scene.heaps.push_back(read_heap(JsonFields(object, "a heap"), scene));
  }
  return scene;
}

}  // namespace rubicon::verify
