#include "src/simulation/trace/trace_header.hpp"

#include <algorithm>

#include "interpreter/check/driving_robots.hpp"
#include "src/exchange/encoding/sha256.hpp"
#include "src/simulation/trace/cover_header.hpp"
#include "src/simulation/trace/json_builder.hpp"
#include "src/simulation/trace/scene_json.hpp"

namespace rubicon::trace {

namespace {

using interpreter::PlanModel;

constexpr int kFormatVersion = 1;

const char* name_of(TraceDetail detail) {
  switch (detail) {
    case TraceDetail::steps:
      return "steps";
    case TraceDetail::tasks:
      return "tasks";
    case TraceDetail::none:
      return "none";
  }
  return "";
}

void write_files(JsonBuilder& json, const interpreter::SourceMap& sources) {
  json.key("files").begin_array();
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const interpreter::SourceFile& file = sources.file(static_cast<interpreter::FileId>(i));
    json.begin_object().field("path", file.path).field("sha256", encoding::sha256_hex(file.text));
    json.field("text", file.text).end_object();
  }
  json.end_array();
}

/// Nothing where there are none, so that traces without attributes stay as they were.
void write_attributes(JsonBuilder& json, const interpreter::Attributes& attributes) {
  if (attributes.empty()) return;
  json.key("attributes").begin_object();
  for (const auto& [key, text] : attributes) json.field(key, std::string_view(text));
  json.end_object();
}

/// Nothing where nothing was given.
void write_set(JsonBuilder& json, const PlanModel& plan) {
  if (plan.set.empty()) return;
  json.key("set").begin_object();
  for (const auto& [name, text] : plan.set) json.field(name, std::string_view(text));
  json.end_object();
}

/// As waivers and components call it.
const std::string& name_of(const PlanModel& plan, const interpreter::ThingRef& thing) {
  static const std::string kSite = "site";
  switch (thing.kind) {
    case interpreter::ThingRef::Kind::component:
      return plan.components[static_cast<std::size_t>(thing.index)].name;
    case interpreter::ThingRef::Kind::robot:
      return plan.robots[static_cast<std::size_t>(thing.index)].name;
    case interpreter::ThingRef::Kind::crew:
      return plan.crews[static_cast<std::size_t>(thing.index)].name;
    case interpreter::ThingRef::Kind::site:
      break;
  }
  return kSite;
}

/// Nothing where there are none.
void write_holders(JsonBuilder& json, const PlanModel& plan, const char* key,
                   const std::vector<interpreter::ThingRef>& holders, bool crews) {
  std::vector<std::string> names;
  for (const interpreter::ThingRef& each : holders) {
    if ((each.kind == interpreter::ThingRef::Kind::crew) == crews) {
      names.push_back(name_of(plan, each));
    }
  }
  if (!names.empty()) json.key(key).strings(names);
}

void write_fixings(JsonBuilder& json, const PlanModel& plan,
                   const std::vector<interpreter::Fixing>& fixings) {
  std::vector<interpreter::ThingRef> holders;
  std::vector<std::string> tasks;
  bool is_any = false;
  for (const interpreter::Fixing& each : fixings) {
    holders.push_back(each.to);
    is_any = is_any || each.after >= 0;
    tasks.push_back(each.after < 0 ? std::string()
                                   : plan.tasks[static_cast<std::size_t>(each.after)].name);
  }
  write_holders(json, plan, "fixed_to", holders, false);
  if (is_any) json.key("fixed_after").strings(tasks);
}

void write_components(JsonBuilder& json, const PlanModel& plan, MeshTable& meshes) {
  json.key("components").begin_array();
  for (const interpreter::ComponentSpec& component : plan.components) {
    json.begin_object().field("name", component.name);
    json.key("pose").pose(component.X_WO).key("grip").pose(component.X_OG);
    json.field("mass", component.mass);
    if (component.cost) json.field("cost", *component.cost);
    json.key("shapes");
    write_shapes(json, component.shapes, meshes);
    write_fixings(json, plan, component.fixed_to);
    write_holders(json, plan, "braced_by", component.braced_by, false);
    write_holders(json, plan, "braced_by_crews", component.braced_by, true);
    if (component.people) json.field("people", true);
    write_attributes(json, component.attributes);
    json.end_object();
  }
  json.end_array();
}

void write_rate(JsonBuilder& json, const std::optional<double>& cost_per_hour,
                const std::string& calendar) {
  json.key("cost_per_hour");
  if (cost_per_hour) {
    json.value(*cost_per_hour);
  } else {
    json.null();
  }
  json.field("calendar", calendar);
}

/// What a robot or crew costs besides its hours, if the plan says so.
void write_charges(JsonBuilder& json, const interpreter::Charges& charges) {
  if (charges.rental_per_day) json.field("rental_per_day", *charges.rental_per_day);
  if (charges.rental_days) {
    json.key("rental_days").begin_array().value(schedule::text_of(charges.rental_days->first));
    json.value(schedule::text_of(charges.rental_days->second)).end_array();
  }
  if (charges.mobilisation) json.field("mobilisation", *charges.mobilisation);
  if (charges.fuel) {
    json.key("fuel").begin_object().field("working", charges.fuel->working);
    json.field("idling", charges.fuel->idling);
    if (charges.fuel->price) json.field("price", *charges.fuel->price);
    json.end_object();
  }
  if (charges.overtime == 1) return;
  json.field("overtime", charges.overtime);
  if (!charges.normal.empty()) json.field("overtime_outside", charges.normal);
}

void write_values(JsonBuilder& json, const robot::RobotModel& model,
                  const std::vector<std::pair<int, double>>& values) {
  json.begin_object();
  for (const auto& [index, value] : values) {
    json.field(model.parameters[static_cast<std::size_t>(index)].display_name, value);
  }
  json.end_object();
}

void write_calendars(JsonBuilder& json, const PlanModel& plan) {
  json.key("start_at");
  if (plan.start_at) {
    json.value(schedule::text_of(*plan.start_at));
  } else {
    json.null();
  }
  json.field("currency", plan.currency).key("calendars").begin_array();
  for (const interpreter::CalendarSpec& calendar : plan.calendars) {
    json.begin_object().field("name", calendar.name).key("shifts").begin_array();
    for (const schedule::CalendarRules::Shift& shift : calendar.shifts) {
      json.begin_object().key("days").begin_array();
      json.value(shift.first_day).value(shift.last_day).end_array().key("minutes").begin_array();
      for (const auto& [from, to] : shift.minutes) {
        json.begin_array().value(from).value(to).end_array();
      }
      json.end_array().end_object();
    }
    json.end_array().key("off").begin_array();
    for (const schedule::Date& day : calendar.off) json.value(schedule::text_of(day));
    json.end_array().field("carry_over", calendar.carry_over);
    if (calendar.loses_days()) {
      json.key("lost").begin_array();
      for (const double share : calendar.lost) json.value(share);
      json.end_array();
    }
    json.end_object();
  }
  json.end_array();
}

void write_law(JsonBuilder& json, const sampling::DurationLaw& law) {
  json.field("law", sampling::info_of(law.law).name);
  if (law.measured) {
    json.field("file", law.measured->file).field("column", law.measured->column);
    json.field("unit", law.measured->unit);
    return;
  }
  json.key("values").begin_array();
  for (const double value : law.values) json.value(value);
  json.end_array();
}

void write_robots(JsonBuilder& json, const PlanModel& plan, MeshTable& meshes) {
  json.key("robots").begin_array();
  for (const interpreter::RobotSpec& spec : plan.robots) {
    const robot::RobotModel& model = spec.robot->model;
    json.begin_object().field("name", spec.name).field("type", model.name);
    json.field("path", spec.robot->path).key("pose").pose(spec.X_WM);
    json.key("start").begin_object();
    for (std::size_t i = 0; i < spec.start.size(); ++i) {
      json.field(model.parameters[i].display_name, spec.start[i]);
    }
    json.end_object();
    write_rate(json, spec.cost_per_hour, spec.calendar);
    write_charges(json, spec.charges);
    json.key("park");
    if (spec.park) {
      write_values(json, model, *spec.park);
    } else {
      json.null();
    }
    if (spec.breakdown) {
      json.key("breakdown").begin_object().key("every").begin_object();
      write_law(json, spec.breakdown->every);
      json.end_object().key("takes").begin_object();
      write_law(json, spec.breakdown->takes);
      json.end_object().end_object();
    }
    write_robot_model(json, model, meshes);
    json.end_object();
  }
  json.end_array();
}

/// A goal's values by parameter name, or its frame.
void write_goal(JsonBuilder& json, const PlanModel& plan, int robot,
                const interpreter::GoalSpec& goal) {
  json.begin_object();
  if (goal.X_WG) json.key("pose").pose(*goal.X_WG);
  if (robot >= 0) {
    const auto& parameters = plan.robots[static_cast<std::size_t>(robot)].robot->model.parameters;
    for (const auto& [index, value] : goal.values) {
      json.field(parameters[static_cast<std::size_t>(index)].display_name, value);
    }
  }
  json.end_object();
}

void write_work(JsonBuilder& json, const PlanModel& plan, const interpreter::WorkSpec& work) {
  json.begin_object().field("duration", work.duration).key("crew");
  if (work.crew < 0) {
    json.null();
  } else {
    json.value(std::string_view(plan.crews[static_cast<std::size_t>(work.crew)].name));
  }
  if (work.turning) json.key("turning").value(std::string_view("theta"));
  if (work.law) write_law(json, *work.law);
  json.end_object();
}

/// What the plan gives: `length` for the tool's position, values by parameter.
void write_within(JsonBuilder& json, const PlanModel& plan, int robot,
                  const interpreter::Within& within) {
  json.key("within").begin_object();
  if (within.length >= 0) json.field("length", within.length);
  const auto& parameters = plan.robots[static_cast<std::size_t>(robot)].robot->model.parameters;
  for (const auto& [index, value] : within.values) {
    json.field(parameters[static_cast<std::size_t>(index)].display_name, value);
  }
  json.end_object();
}

/// Nothing where nothing is asked.
void write_clauses(JsonBuilder& json, const PlanModel& plan, int robot,
                   const interpreter::MotionClauses& clauses) {
  const auto& parameters = plan.robots[static_cast<std::size_t>(robot)].robot->model.parameters;
  static constexpr const char* kTurns[] = {"", "rotx", "roty", "rotz", "all"};
  if (clauses.free != robot::FreeTurn::none) {
    json.field("free", kTurns[static_cast<std::size_t>(clauses.free)]);
  }
  if (!clauses.near.empty()) {
    json.key("near").begin_object();
    for (const auto& [index, value] : clauses.near) {
      json.field(parameters[static_cast<std::size_t>(index)].display_name, value);
    }
    json.end_object();
  }
  if (!clauses.locked.empty()) {
    json.key("lock").begin_array();
    for (const int index : clauses.locked) {
      json.value(std::string_view(parameters[static_cast<std::size_t>(index)].display_name));
    }
    json.end_array();
  }
  if (clauses.deviation) write_deviation(json, *clauses.deviation);
  if (clauses.entered.empty()) return;
  const auto& bodies = plan.robots[static_cast<std::size_t>(robot)].robot->model.bodies;
  json.key("enter").begin_array();
  for (const auto& [body, component] : clauses.entered) {
    json.begin_array().value(std::string_view(bodies[static_cast<std::size_t>(body)].name));
    json.value(std::string_view(plan.components[static_cast<std::size_t>(component)].name));
    json.end_array();
  }
  json.end_array();
}

/// What guides keep on their ways, how they steer, what thinking takes; nothing where none does any
/// of it.
void write_kept(JsonBuilder& json, const PlanModel& plan, int robot,
                const std::vector<guides::GuideSpec>& guides) {
  const auto keeps = [](const guides::GuideSpec& guide) {
    return !guide.keep.empty() || guide.turn_radius > 0 || guide.thinks > 0;
  };
  if (std::none_of(guides.begin(), guides.end(), keeps)) return;
  const robot::RobotModel& model = plan.robots[static_cast<std::size_t>(robot)].robot->model;
  json.key("guides").begin_array();
  for (const guides::GuideSpec& guide : guides) {
    if (!keeps(guide)) continue;
    json.begin_object().field("name", guide.name);
    if (guide.turn_radius > 0) json.field("turn_radius", guide.turn_radius);
    if (guide.thinks > 0) json.field("thinks", guide.thinks);
    json.key("keep").begin_array();
    for (const guides::KeptBound& bound : guide.keep) {
      json.begin_object().key("sum");
      write_values(json, model, bound.terms);
      json.field("most", bound.most).end_object();
    }
    json.end_array().end_object();
  }
  json.end_array();
}

void write_task_motions(JsonBuilder& json, const PlanModel& plan,
                        const interpreter::TaskSpec& task) {
  if (task.move) {
    json.field("move", plan.components[static_cast<std::size_t>(*task.move)].name);
    json.key("to").pose(task.X_WO_goal);
  }
  if (task.go) write_goal(json.key("go"), plan, task.robot, *task.go);
  if (task.cover) write_cover(json, plan, task);
  if (!task.via.empty()) {
    json.key("via").begin_array();
    for (const interpreter::GoalSpec& goal : task.via) write_goal(json, plan, task.robot, goal);
    json.end_array();
  }
  if (task.robot >= 0) {
    write_within(json, plan, task.robot, task.within);
    write_clauses(json, plan, task.robot, task.clauses);
    write_kept(json, plan, task.robot, task.guides);
  }
  if (!task.situations.empty()) json.key("situations").strings(task.situations);
}

void write_stage_time(JsonBuilder& json, const hauling::StageTime& time) {
  json.field("seconds", time.seconds);
  if (time.law) write_law(json, *time.law);
}

/// What trucks do after loading.
void write_stages(JsonBuilder& json, const hauling::Operation& operation) {
  json.key("stages").begin_array();
  for (const hauling::Stage& stage : operation.stages) {
    json.begin_object().field("name", stage.name);
    write_stage_time(json, stage.time);
    if (stage.servers > 0) json.field("by", stage.by).field("servers", stage.servers);
    json.end_object();
  }
  json.end_array().field("tip", operation.stages[operation.tip].name);
  if (operation.efficiency < 1) json.field("efficiency", operation.efficiency);
}

/// The cells that a task digs, with where they lie; they are returned.
template <typename Dig>
std::vector<std::size_t> write_cells(JsonBuilder& json, const PlanModel& plan, const Dig& dig) {
  json.key("pose").pose(plan.earths[static_cast<std::size_t>(dig.earth)].X_WE);
  json.field("columns", dig.before->columns).field("cell", dig.before->cell);
  std::vector<std::size_t> cells;
  const soil::Heights& before = dig.before->heights;
  const soil::Heights& after = dig.after->heights;
  before.for_each_difference(after, [&](std::size_t i) {
    if (before[i] > after[i]) cells.push_back(i);
  });
  json.key("cells").begin_array();
  for (const std::size_t cell : cells) json.value(static_cast<std::int64_t>(cell));
  json.end_array();
  return cells;
}

/// Heights of these cells, mm.
void write_heights(JsonBuilder& json, const char* key, const soil::Terrain& ground,
                   const std::vector<std::size_t>& cells) {
  json.key(key).begin_array();
  for (const std::size_t cell : cells) json.value(ground.heights[cell]);
  json.end_array();
}

/// What a task leaves, cell by cell, for those who must not drive over it.
void write_pit(JsonBuilder& json, const PlanModel& plan, const interpreter::DigSpec& dig) {
  json.key("pit").begin_object();
  const std::vector<std::size_t> cells = write_cells(json, plan, dig);
  write_heights(json, "before", *dig.before, cells);
  write_heights(json, "after", *dig.after, cells);
  json.end_object();
}

/// How a task digs, with whole mm3 of bank volume, and what came of it.
void write_dig(JsonBuilder& json, const PlanModel& plan, const interpreter::DigSpec& dig) {
  const hauling::Operation& operation = dig.operation;
  json.key("dig").begin_object().field("volume", operation.volume).field("load", operation.load);
  if (operation.bucket > 0) json.field("bucket", operation.bucket);
  if (dig.swell > 0) json.field("swell", dig.swell);
  json.key("loading").begin_object();
  write_stage_time(json, operation.loading);
  json.end_object().key("diggers").begin_array();
  for (const hauling::Diggers& each : operation.diggers) {
    json.begin_object().field("crew", each.name).field("count", each.count).end_object();
  }
  json.end_array();
  if (dig.soil >= 0) {
    json.field("earth", plan.earths[static_cast<std::size_t>(dig.earth)].name);
    json.field("soil", plan.components[static_cast<std::size_t>(dig.soil)].name);
    const std::vector<bool> drives = interpreter::driving_robots(plan);
    if (std::find(drives.begin(), drives.end(), true) != drives.end()) write_pit(json, plan, dig);
  }
  json.field("hauled_by", plan.crews[static_cast<std::size_t>(dig.trucks)].name);
  json.field("trucks", operation.trucks);
  if (operation.loaded > 0) json.field("loaded", operation.loaded);
  write_stages(json, operation);
  if (operation.until) json.key("limit").seconds(*operation.until);
  json.field("loads", dig.result.loads).field("tipped", dig.result.tipped);
  json.key("time").seconds(dig.result.time).end_object();
}

/// How a robot digs, with the ground that it digs cell by cell (mm).
void write_motion_dig(JsonBuilder& json, const PlanModel& plan,
                      const interpreter::MotionDigSpec& dig) {
  const interpreter::EarthSpec& earth = plan.earths[static_cast<std::size_t>(dig.earth)];
  json.key("motion_dig").begin_object().field("earth", earth.name);
  json.field("soil", plan.components[static_cast<std::size_t>(dig.soil)].name);
  json.field("volume", dig.volume).field("bucket", dig.bucket).field("layer", dig.layer);
  json.field("tolerance", dig.tolerance).field("clearance", dig.clearance);
  json.field("swell", dig.swell);
  const std::vector<std::size_t> cells = write_cells(json, plan, dig);
  write_heights(json, "before", *dig.before, cells);
  write_heights(json, "after", *dig.after, cells);
  json.key("place").begin_array();
  for (const double value : {dig.p_WD.x(), dig.p_WD.y(), dig.p_WD.z()}) json.value(value);
  json.end_array();
  if (dig.fill.duration > 0) write_work(json.key("fill"), plan, dig.fill);
  if (dig.dump.duration > 0) write_work(json.key("dump"), plan, dig.dump);
  if (dig.loads_bodies()) {
    json.key("load_at").pose(*dig.X_WL).key("queue").begin_array();
    for (const math::Pose& X : dig.queue) json.pose(X);
    json.end_array();
  }
  if (dig.trucks >= 0) {
    json.field("hauled_by", plan.crews[static_cast<std::size_t>(dig.trucks)].name);
    json.field("trucks", dig.hauls.trucks).field("load", dig.hauls.load);
    write_stages(json, dig.hauls);
  }
  json.end_object();
}

/// How a truck hauls what others dig.
void write_haul(JsonBuilder& json, const PlanModel& plan, const interpreter::TaskSpec& task) {
  const interpreter::HaulSpec& haul = *task.haul;
  json.key("haul").begin_object().key("digs").begin_array();
  for (const int dig : haul.digs) {
    json.value(std::string_view(plan.tasks[static_cast<std::size_t>(dig)].name));
  }
  json.end_array().key("loads").begin_array();
  for (const soil::CubicMillimetres load : haul.loads) json.value(load);
  json.end_array().key("tips").begin_array();
  for (const math::Pose& X : haul.tips) json.pose(X);
  json.end_array();
  if (haul.tip.duration > 0) write_work(json.key("tip"), plan, haul.tip);
  if (haul.earth >= 0) {
    const interpreter::EarthSpec& earth = plan.earths[static_cast<std::size_t>(haul.earth)];
    json.field("heap", plan.components[static_cast<std::size_t>(earth.heap)].name);
    json.key("falls_at").begin_array();
    for (const double value : {haul.p_TH.x(), haul.p_TH.y(), haul.p_TH.z()}) json.value(value);
    json.end_array();
  }
  json.end_object();
}

/// Whose workspaces are kept apart, and how far ahead they reach.
void write_workspaces(JsonBuilder& json, const PlanModel& plan) {
  if (!plan.workspaces) return;
  const interpreter::WorkspacesSpec& spec = *plan.workspaces;
  json.key("workspaces").begin_object().key("of").begin_array();
  for (const int robot : spec.robots) {
    json.value(std::string_view(plan.robots[static_cast<std::size_t>(robot)].name));
  }
  json.end_array().field("reaction", spec.reaction).field("braking", spec.braking);
  json.field("turn_braking", spec.turn_braking);
  if (spec.foreseen() > 0) json.field("foreseen", spec.foreseen());
  if (spec.watch) json.field("watch", true);
  json.end_object();
}

/// The ground on which loads are tipped, cell by cell (mm), and where none may lie.
void write_heaps(JsonBuilder& json, const PlanModel& plan) {
  const auto is_heap = [](const interpreter::EarthSpec& earth) { return earth.heap >= 0; };
  if (std::none_of(plan.earths.begin(), plan.earths.end(), is_heap)) return;
  json.key("heaps").begin_array();
  for (const interpreter::EarthSpec& earth : plan.earths) {
    if (!is_heap(earth)) continue;
    json.begin_object();
    json.field("component", plan.components[static_cast<std::size_t>(earth.heap)].name);
    json.field("earth", earth.name).key("pose").pose(earth.X_WE);
    json.field("columns", earth.before.columns).field("cell", earth.before.cell);
    json.field("repose", *earth.repose_deg).key("ground").begin_array();
    const soil::Heights& before = earth.before.heights;
    for (std::size_t i = 0; i < before.size(); ++i) json.value(before[i]);
    json.end_array().key("dug").begin_array();
    before.for_each_difference(earth.after.heights,
                               [&](std::size_t i) { json.value(static_cast<std::int64_t>(i)); });
    json.end_array().end_object();
  }
  json.end_array();
}

void write_task_work(JsonBuilder& json, const PlanModel& plan, const interpreter::TaskSpec& task) {
  if (task.hook) write_work(json.key("hook"), plan, *task.hook);
  if (task.adjust) write_work(json.key("adjust"), plan, *task.adjust);
  if (task.release) write_work(json.key("release"), plan, *task.release);
  if (!task.takes.empty()) {
    json.key("takes").begin_array();
    for (const interpreter::WorkSpec& work : task.takes) write_work(json, plan, work);
    json.end_array();
  }
  if (task.dig) write_dig(json, plan, *task.dig);
  if (task.motion_dig) write_motion_dig(json, plan, *task.motion_dig);
  if (task.haul) write_haul(json, plan, task);
  if (!task.remove.empty()) {
    json.key("remove").begin_array();
    for (const int component : task.remove) {
      json.value(std::string_view(plan.components[static_cast<std::size_t>(component)].name));
    }
    json.end_array();
  }
}

/// Robots and crews that the plan names for a task.
void write_doers(JsonBuilder& json, const PlanModel& plan, const interpreter::TaskSpec& task) {
  const auto robot = [&](int index) {
    return std::string_view(plan.robots[static_cast<std::size_t>(index)].name);
  };
  const auto crew = [&](int index) {
    return std::string_view(plan.crews[static_cast<std::size_t>(index)].name);
  };
  json.key("robot").value(task.robot < 0 ? std::string_view() : robot(task.robot));
  json.key("crews").begin_array();
  for (const int index : task.crews) json.value(crew(index));
  json.end_array();
  if (!task.also_robots.empty()) {
    json.key("also_robots").begin_array();
    for (const int index : task.also_robots) json.value(robot(index));
    json.end_array();
  }
  if (task.needs.empty()) return;
  json.key("needs").begin_object();
  for (const interpreter::NeedSpec& need : task.needs) json.field(crew(need.crew), need.people);
  json.end_object();
}

/// Of a task by pools: whom it may have, and what it does with these.
void write_choices(JsonBuilder& json, const PlanModel& plan, const interpreter::TaskSpec& task) {
  if (task.choices.empty()) return;
  if (task.same_as) {
    json.field("same_as", plan.tasks[static_cast<std::size_t>(*task.same_as)].name);
  }
  json.key("choices").begin_array();
  for (const interpreter::TaskSpec& choice : task.choices) {
    json.begin_object().field("members", member_names(plan, choice));
    write_doers(json, plan, choice);
    write_task_motions(json, plan, choice);
    write_task_work(json, plan, choice);
    if (interpreter::held_whole(plan, choice)) json.field("whole", true);
    json.end_object();
  }
  json.end_array();
}

void write_pools(JsonBuilder& json, const PlanModel& plan) {
  if (plan.pools.empty()) return;
  json.key("pools").begin_array();
  for (const interpreter::PoolSpec& pool : plan.pools) {
    json.begin_object().field("name", pool.name).key("of").begin_array();
    for (const int member : pool.members) {
      const auto index = static_cast<std::size_t>(member);
      json.value(
          std::string_view(pool.of_robots ? plan.robots[index].name : plan.crews[index].name));
    }
    json.end_array().field("choose", name_of(pool.choice)).end_object();
  }
  json.end_array();
}

/// Only those that the plan gives: other traces stay as they were.
void write_dates(JsonBuilder& json, const interpreter::TaskSpec& task) {
  if (task.not_before > 0) json.key("not_before").seconds(task.not_before);
  if (task.due) json.key("due").seconds(*task.due);
  if (!task.baseline) return;
  json.key("baseline").begin_object();
  json.key("start").seconds(task.baseline->start).key("finish").seconds(task.baseline->finish);
  json.end_object();
}

void write_tasks(JsonBuilder& json, const PlanModel& plan, MeshTable& meshes) {
  json.key("tasks").begin_array();
  for (const interpreter::TaskSpec& task : plan.tasks) {
    json.begin_object().field("name", task.name);
    write_doers(json, plan, task);
    write_task_motions(json, plan, task);
    write_task_work(json, plan, task);
    if (interpreter::held_whole(plan, task)) json.field("whole", true);
    write_choices(json, plan, task);
    json.field("priority", task.priority).key("zones");
    write_shapes(json, task.zones, meshes);
    if (!task.zones.empty()) {
      json.key("zones_overhead");
      write_shapes(json, task.zones_overhead, meshes);
    }
    write_dates(json, task);
    json.key("after").begin_array();
    for (const interpreter::LinkSpec& link : task.after) {
      json.begin_object();
      json.field("task", plan.tasks[static_cast<std::size_t>(link.task)].name);
      json.field("type", schedule::name_of(link.type));
      json.field("lag", schedule::seconds_from_ticks(link.lag)).end_object();
    }
    json.end_array();
    write_attributes(json, task.attributes);
    json.end_object();
  }
  json.end_array();
}

/// Nothing where nobody has looked, and in short plans, whose traces stay as they were.
void write_beginning(JsonBuilder& json, const PlanModel& plan) {
  if (!plan.overlaps || plan.short_form) return;
  json.key("beginning").begin_object().key("overlaps").begin_array();
  for (const interpreter::OverlapSpec& each : *plan.overlaps) {
    json.begin_object().field("first", each.first).field("second", each.second);
    json.field("depth", each.depth).end_object();
  }
  json.end_array().key("waived").begin_array();
  for (const interpreter::WaiverSpec& waiver : plan.waivers) {
    json.begin_array().value(std::string_view(name_of(plan, waiver.first)));
    json.value(std::string_view(name_of(plan, waiver.second))).end_array();
  }
  json.end_array().end_object();
}

/// Nothing in short plans, whose traces stay as they were.
void write_support(JsonBuilder& json, const PlanModel& plan) {
  if (plan.short_form || plan.tasks.empty()) return;
  json.key("support").begin_object().field("mode", name_of(plan.support.mode));
  json.field("gap", plan.support.gap);
  if (plan.support.equilibrium) json.field("friction", interpreter::SupportRules::kFriction);
  if (plan.floating) {
    json.key("floating").begin_array();
    for (const int component : *plan.floating) {
      json.value(std::string_view(plan.components[static_cast<std::size_t>(component)].name));
    }
    json.end_array();
  }
  json.end_object();
}

void write_movings(JsonBuilder& json, const PlanModel& plan, MeshTable& meshes) {
  if (plan.movings.empty()) return;
  json.key("movings").begin_array();
  for (const interpreter::MovingSpec& moving : plan.movings) {
    json.begin_object().field("name", moving.name).key("path").begin_array();
    for (const geometry::TimedPlace& place : moving.timetable.places) {
      json.begin_object().field("t", interpreter::seconds_from_ticks(place.time)).key("pose");
      json.pose(place.X_WO).end_object();
    }
    json.end_array().field("repeat", moving.timetable.repeat).key("shapes");
    write_shapes(json, moving.shapes, meshes);
    if (!moving.overhead.empty()) write_shapes(json.key("overhead"), moving.overhead, meshes);
    json.end_object();
  }
  json.end_array();
}

/// Nodes with their poses, lanes by the numbers of their nodes and their class; who drives there.
void write_networks(JsonBuilder& json, const PlanModel& plan) {
  if (plan.networks.empty()) return;
  json.key("networks").begin_array();
  for (const interpreter::NetworkSpec& network : plan.networks) {
    json.begin_object().field("name", network.name).key("classes").begin_array();
    for (const lanes::LaneClass& each : network.description.classes) {
      json.begin_object().field("name", each.name).field("speed", each.speed);
      json.field("width", each.width).end_object();
    }
    json.end_array().key("nodes").begin_array();
    for (std::size_t i = 0; i < network.X_WN.size(); ++i) {
      json.begin_object().field("name", network.description.nodes[i].name).key("pose");
      json.pose(network.X_WN[i]).end_object();
    }
    json.end_array().key("lanes").begin_array();
    for (const lanes::Lane& lane : network.description.lanes) {
      json.begin_object().field("from", lane.from).field("to", lane.to);
      json.field("class", lane.lane_class);
      if (lane.length) json.field("length", *lane.length);
      json.end_object();
    }
    json.end_array().end_object();
  }
  json.end_array();
  json.key("fleets").begin_array();
  for (const interpreter::FleetSpec& fleet : plan.fleets) {
    json.begin_object().field("name", fleet.name);
    json.field("network", plan.networks[static_cast<std::size_t>(fleet.network)].name);
    json.key("robots").begin_array();
    for (const int robot : fleet.robots) {
      json.value(std::string_view(plan.robots[static_cast<std::size_t>(robot)].name));
    }
    json.end_array().key("nodes").begin_array();
    for (const lanes::NodeIndex node : fleet.nodes) json.value(node);
    json.end_array().end_object();
  }
  json.end_array();
}

}  // namespace

std::string header_line(const PlanModel& plan, const interpreter::SourceMap& sources,
                        TraceDetail detail) {
  JsonBuilder json;
  MeshTable meshes;
  json.begin_object().field("type", "header").field("format", "rubicon-trace");
  json.field("version", kFormatVersion).field("plan", plan.name).field("path", plan.path);
  json.field("form", plan.short_form ? "short" : "full").field("detail", name_of(detail));
  json.field("contact", plan.contact).field("budget", plan.budget);
  json.key("situations").strings(plan.situations);
  write_calendars(json, plan);
  write_files(json, sources);
  write_set(json, plan);
  if (plan.sample) {
    json.key("sample").begin_object();
    json.field("seed", static_cast<std::int64_t>(plan.sample->seed));
    json.field("run", static_cast<std::int64_t>(plan.sample->run)).end_object();
  }
  json.key("site");
  write_shapes(json, plan.site, meshes);
  if (!plan.site_names.empty()) json.key("site_names").strings(plan.site_names);
  if (!plan.storages.empty()) {
    json.key("storages").begin_array();
    for (const interpreter::StorageSpec& storage : plan.storages) {
      json.begin_object().field("name", storage.name).key("shapes");
      write_shapes(json, storage.shapes, meshes);
      json.end_object();
    }
    json.end_array();
  }
  write_movings(json, plan, meshes);
  write_networks(json, plan);
  write_components(json, plan, meshes);
  write_robots(json, plan, meshes);
  json.key("carry");
  write_shapes(json, plan.carry, meshes);
  json.key("crews").begin_array();
  for (const interpreter::CrewSpec& crew : plan.crews) {
    json.begin_object().field("name", crew.name).field("size", crew.size);
    write_rate(json, crew.cost_per_hour, crew.calendar);
    write_charges(json, crew.charges);
    json.end_object();
  }
  json.end_array();
  write_pools(json, plan);
  if (plan.overhead_per_day) json.field("overhead_per_day", *plan.overhead_per_day);
  if (plan.short_form) {
    json.key("via").begin_array();
    for (const interpreter::GoalSpec& goal : plan.via) write_goal(json, plan, 0, goal);
    json.end_array();
    if (plan.goal) write_goal(json.key("goal"), plan, 0, *plan.goal);
    write_within(json, plan, 0, plan.within);
    write_clauses(json, plan, 0, plan.clauses);
    write_kept(json, plan, 0, plan.guides);
  }
  write_tasks(json, plan, meshes);
  write_heaps(json, plan);
  write_workspaces(json, plan);
  write_beginning(json, plan);
  write_support(json, plan);
  meshes.write(json.key("meshes"));
  json.end_object();
  return json.take();
}

}  // namespace rubicon::trace
