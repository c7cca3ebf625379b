#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "interpreter/check/check_number.hpp"
#include "interpreter/check/check_plan_parts.hpp"
#include "src/motion/geometry/extent.hpp"
#include "src/motion/guides/leg.hpp"
#include "src/motion/guides/vehicle.hpp"
#include "src/motion/math/index.hpp"
#include "src/motion/robot/kinematics.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

using math::at;

constexpr double kLeastBed = 0.001;        // m3
constexpr double kMostBed = 1e6;           // m3
constexpr double kLeastHaulPayload = 0.1;  // kg
constexpr double kMostHaulPayload = 1e7;   // kg
constexpr std::size_t kMostHaulPlaces = 1000;
/// m: a bucket is wider than the point where it is emptied.
constexpr double kMostBesideTruck = 1;

/// One task in which a robot hauls.
class HaulCheck {
 public:
  HaulCheck(Subject& subject, const Scope& scope, const syntax::HaulItem& item,
            const RobotSpec& robot)
      : subject_(subject), scope_(scope), item_(item), robot_(robot) {}

  std::optional<HaulSpec> run() {
    const int errors = subject_.diagnostics.errors();
    if (!guides::Vehicle(robot_.robot->model, {robot_.X_WM, robot_.start}).travels()) {
      wrong(place(),
            fmt::format("robot '{}' does not drive: a truck has a body with parameters x and y",
                        robot_.name));
    }
    for (const syntax::QualifiedName& name : item_.digs) take_dig(name);
    for (const Clause& clause : item_.clauses) take(clause);
    if (given_.count("tip at") == 0) {
      wrong(place(), "haul does not say where the truck tips", "tip at trans(60, 0, 0);");
    }
    if (given_.count("bed") == 0 && given_.count("payload") == 0) {
      wrong(place(), "haul does not say how much the truck takes",
            "bed 12 m3; or payload 20 t; with the density of the earth");
    }
    if (subject_.diagnostics.errors() != errors) return std::nullopt;
    return std::move(haul_);
  }

 private:
  using Clause = syntax::HaulItem::Clause;

  Span place() const { return item_.digs.front().span; }
  void wrong(Span span, std::string message, std::string hint = {}) {
    subject_.error("P62", span, std::move(message), std::move(hint));
  }

  void take_dig(const syntax::QualifiedName& name) {
    const std::optional<int> task = find_task(subject_, scope_, name);
    if (!task) return;
    if (std::find(haul_.digs.begin(), haul_.digs.end(), *task) != haul_.digs.end()) {
      subject_.error("P02", name.span, fmt::format("'{}' is named twice", name.text()));
      return;
    }
    haul_.digs.push_back(*task);
  }

  void take(const Clause& clause) {
    const std::string key = clause.places.empty() ? clause.key.text : clause.key.text + " at";
    const auto [first, is_new] = given_.emplace(key, clause.key.span);
    if (!is_new) {
      subject_.twice(clause.key.span, key + " is given twice", first->second);
    } else if (!clause.places.empty()) {
      take_places(clause);
    } else if (clause.number) {
      take_number(clause);
    } else if (clause.earth) {
      take_heap(clause);
    } else if (clause.values) {
      haul_.raised = resolve_values(subject_, &robot_, *clause.values, ValueUse::goal);
      check_raised(clause.key.span);
    } else {
      take_tip(clause);
    }
  }

  void take_places(const Clause& clause) {
    if (clause.places.size() > kMostHaulPlaces) {
      wrong(clause.key.span,
            fmt::format("{} places; expected up to {}", clause.places.size(), kMostHaulPlaces));
      return;
    }
    std::vector<math::Pose>& places = clause.key.text == "out"   ? haul_.out
                                      : clause.key.text == "tip" ? haul_.tips
                                                                 : haul_.back;
    for (const syntax::Frame& frame : clause.places) {
      places.push_back(resolve_placed_frame(subject_, frame, scope_.X_WP));
    }
  }

  void take_number(const Clause& clause) {
    const syntax::Number& value = *clause.number;
    if (clause.key.text == "payload") {
      haul_.payload = bounded(subject_, value, syntax::UnitKind::mass, "payload", kLeastHaulPayload,
                              kMostHaulPayload)
                          .value_or(1);
      return;
    }
    const bool is_volume =
        value.dimension == syntax::Dimension{} || value.dimension == syntax::Dimension{3, 0, 0, 0};
    if (is_volume && value.value >= kLeastBed && value.value <= kMostBed) {
      haul_.bed = value.value;
      return;
    }
    wrong(value.span,
          fmt::format("expected a volume from {:g} to {:g} m3 as bed{}", kLeastBed, kMostBed,
                      is_volume ? fmt::format(", found {:g} m3", value.value) : ""),
          "12 m3");
  }

  void take_tip(const Clause& clause) {
    if (clause.law) {
      wrong(clause.law->span, "tip takes a certain duration of the truck alone", "tip takes 30 s;");
      return;
    }
    haul_.tip.span = clause.key.span;
    if (const auto seconds = resolve_duration(subject_, *clause.duration, "tip")) {
      haul_.tip.duration = *seconds;
    }
  }

  void take_heap(const Clause& clause) {
    haul_.earth = subject_.find(subject_.earths, *clause.earth, "earth");
    haul_.p_TH = resolve_frame_or_identity(subject_, *clause.frame).translation();
    if (haul_.earth < 0) return;
    EarthSpec& earth = subject_.model.earths[at(haul_.earth)];
    if (!earth.repose_deg) {
      wrong(clause.earth->span,
            fmt::format("earth '{}' does not say how steep loose soil lies", earth.name),
            "repose 35 deg; in the earth");
    }
    if (earth.heap >= 0) return;
    ComponentSpec& heap = subject_.model.components.emplace_back();
    heap.name = earth.name + ".heap";
    heap.span = clause.earth->span;
    heap.X_WO = earth.X_WE;
    earth.heap = static_cast<int>(subject_.model.components.size()) - 1;
  }

  /// What is raised to tip is no part of how the truck drives.
  void check_raised(Span span) {
    const guides::Vehicle vehicle(robot_.robot->model, {robot_.X_WM, robot_.start});
    const guides::Leg leg(robot_.robot->model, {robot_.X_WM, robot_.start});
    for (const auto& [parameter, value] : haul_.raised) {
      const bool drives = parameter == vehicle.x() || parameter == vehicle.y() ||
                          parameter == leg.drive() || parameter == leg.heading();
      if (!drives) continue;
      wrong(span, fmt::format("the truck drives with '{}': it is not raised",
                              robot_.robot->model.parameters[at(parameter)].display_name));
    }
  }

  Subject& subject_;
  const Scope& scope_;
  const syntax::HaulItem& item_;
  const RobotSpec& robot_;
  HaulSpec haul_;
  std::map<std::string, Span> given_;
};

/// m, in the plan view: how far the place where buckets are emptied is from the box round a truck
/// that stands to be loaded.
double off_truck(const RobotSpec& truck, const MotionDigSpec& dig) {
  const robot::RobotModel& model = truck.robot->model;
  const robot::Mounting mounting = {truck.X_WM, truck.start};
  std::vector<math::Pose> X_WB;
  robot::body_poses(model, mounting, truck.start, X_WB);
  const math::Pose X_TW = robot::tool_pose(model, mounting, truck.start).inverse(Eigen::Isometry);
  Eigen::AlignedBox2d box;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    for (const geometry::Shape& shape : model.bodies[i].shapes) {
      const Eigen::AlignedBox3d own = geometry::extent_of(shape);
      for (int corner = 0; corner < 8; ++corner) {
        const math::Vec3 p = own.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
        box.extend((X_TW * X_WB[i] * p).head<2>());
      }
    }
  }
  if (box.isEmpty()) return 0;
  const math::Vec3 p_TD = dig.X_WL->inverse(Eigen::Isometry) * dig.p_WD;
  return box.exteriorDistance(Eigen::Vector2d(p_TD.head<2>()));
}

/// A truck is loaded while the dig goes on, so nobody can be in both.
void check_shared_crews(Subject& subject, const TaskSpec& haul, const TaskSpec& dig) {
  for (const int crew : haul.crews) {
    if (std::find(dig.crews.begin(), dig.crews.end(), crew) == dig.crews.end()) continue;
    const CrewSpec& spec = subject.model.crews[at(crew)];
    const int people = people_of(subject, haul, crew) + people_of(subject, dig, crew);
    if (people <= spec.size) continue;
    subject.error("P62", haul.span,
                  fmt::format("'{}' and '{}', which loads it, need {} people of crew '{}' at once, "
                              "and it has {}",
                              haul.name, dig.name, people, spec.name, spec.size),
                  "another crew, or a larger one of which each of them needs a part");
  }
}

/// What a truck takes of what a task digs.
void finish_haul(Subject& subject, TaskSpec& task) {
  HaulSpec& haul = *task.haul;
  haul.loads.clear();
  const auto wrong = [&](std::string message, std::string hint = {}) {
    subject.error("P62", task.span, std::move(message), std::move(hint));
  };
  for (const int index : haul.digs) {
    const TaskSpec& other = subject.model.tasks[at(index)];
    // What is wrong with a dig was said.
    if (!other.motion_dig && subject.diagnostics.has_errors()) return;
    if (!other.motion_dig || !other.motion_dig->loads_bodies()) {
      wrong(fmt::format("'{}' hauls for '{}', which {}", task.name, other.name,
                        other.motion_dig ? "does not say where a truck is loaded"
                                         : "is no task in which a robot digs"),
            other.motion_dig ? "load at trans(2, 6, 0); in its dig" : "");
      return;
    }
    const MotionDigSpec& dig = *other.motion_dig;
    double load = haul.bed > 0 ? haul.bed / (1 + dig.swell) : kMostBed;
    if (haul.payload > 0 && !dig.density) {
      wrong(fmt::format("the payload of '{}' needs the density of earth '{}'", task.name,
                        subject.model.earths[at(dig.earth)].name),
            "density 1.8 t per m3;");
      return;
    }
    if (haul.payload > 0) load = std::min(load, haul.payload / *dig.density);
    const auto whole =
        static_cast<soil::CubicMillimetres>(std::llround(load * hauling::kPerCubicMetre));
    if (whole < dig.bucket) {
      wrong(fmt::format("the truck of '{}' takes {:.3f} m3 as it lies, less than a bucket of '{}' "
                        "of {:.3f} m3",
                        task.name, load, other.name, static_cast<double>(dig.bucket) * 1e-9),
            "larger trucks, or a smaller bucket");
      return;
    }
    haul.loads.push_back(whole);
    const double beside = off_truck(subject.model.robots[at(task.robot)], dig);
    if (beside > kMostBesideTruck) {
      wrong(fmt::format("'{}' empties its bucket {:.1f} m beside the truck of '{}', where that "
                        "stands to be loaded",
                        other.name, beside, task.name),
            "dump at a place over it, or load at another");
      return;
    }
  }
}

}  // namespace

std::optional<HaulSpec> resolve_haul(Subject& subject, const Scope& scope,
                                     const syntax::HaulItem& item, const RobotSpec& robot) {
  return HaulCheck(subject, scope, item, robot).run();
}

void finish_hauls(Subject& subject) {
  std::vector<TaskSpec>& tasks = subject.model.tasks;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (tasks[i].haul) finish_haul(subject, tasks[i]);
    for (TaskSpec& choice : tasks[i].choices) {
      if (choice.haul) finish_haul(subject, choice);
    }
    if (!tasks[i].haul) continue;
    for (const int dig : tasks[i].haul->digs) {
      TaskSpec& other = tasks[at(dig)];
      if (other.motion_dig) other.motion_dig->haulers.push_back(static_cast<int>(i));
      if (tasks[i].choices.empty() && other.choices.empty()) {
        check_shared_crews(subject, tasks[i], other);
      }
      for (TaskSpec& choice : other.choices) {
        if (choice.motion_dig) choice.motion_dig->haulers.push_back(static_cast<int>(i));
      }
    }
  }
  if (subject.diagnostics.has_errors()) return;
  for (const TaskSpec& task : tasks) {
    if (!task.motion_dig || !task.motion_dig->loads_bodies()) continue;
    if (!task.motion_dig->haulers.empty()) continue;
    subject.error("P62", task.span, fmt::format("nobody hauls what '{}' loads", task.name),
                  fmt::format("task haul {{ by lorry; haul {} {{ ... }} }}", task.name));
  }
}

void check_workspaces(Subject& subject) {
  using syntax::UnitKind;
  const syntax::WorkspacesItem* first = nullptr;
  for (const syntax::PlanItem& each : subject.plan.items) {
    const auto* item = std::get_if<syntax::WorkspacesItem>(&each);
    if (item == nullptr) continue;
    if (first != nullptr) {
      subject.twice(item->keyword, "workspaces is given twice", first->keyword);
      continue;
    }
    first = item;
    WorkspacesSpec spec;
    spec.span = item->keyword;
    std::map<int, Span> known;
    for (const syntax::Name& name : item->of) {
      std::vector<int> robots;
      const auto pool = subject.pools.find(name.text);
      const auto robot = subject.robots.find(name.text);
      if (robot != subject.robots.end()) {
        robots.push_back(robot->second);
      } else if (pool != subject.pools.end() && pool->second >= 0 &&
                 subject.model.pools[at(pool->second)].of_robots) {
        robots = subject.model.pools[at(pool->second)].members;
      } else {
        subject.unknown(name.span, "robot or fleet", name.text, {&subject.robots, &subject.pools});
        continue;
      }
      for (const int each_robot : robots) {
        const auto [place, is_new] = known.emplace(each_robot, name.span);
        if (is_new) {
          spec.robots.push_back(each_robot);
        } else {
          subject.twice(
              name.span,
              fmt::format("'{}' is named twice", subject.model.robots[at(each_robot)].name),
              place->second);
        }
      }
    }
    std::map<std::string, Span> given;
    for (const syntax::NumberItem& number : item->numbers) {
      const std::string& key = number.name.text;
      const auto [place, is_new] = given.emplace(key, number.name.span);
      if (!is_new) subject.twice(number.name.span, key + " is given twice", place->second);
      const auto value = [&](UnitKind kind, double least, double most) {
        return bounded(subject, number.value, kind, key, least, most);
      };
      if (key == "reaction") {
        spec.reaction = value(UnitKind::time, 0, 60).value_or(1);
      } else if (key == "braking") {
        spec.braking = value(UnitKind::acceleration, 0.01, 100).value_or(1);
      } else if (key == "turn_braking") {
        spec.turn_braking = value(UnitKind::turn_acceleration, 0.1, 10000).value_or(1);
      } else if (key == "look_ahead") {
        spec.look_ahead = value(UnitKind::time, 0.1, 60);
      } else {
        spec.risk = value(UnitKind::none, 0.01, 1).value_or(1);
      }
    }
    if (given.contains("risk") && !given.contains("look_ahead")) {
      subject.error("P63", given.at("risk"), "risk is of what is foreseen, and nothing is",
                    "look_ahead 2.3 s;");
    }
    for (const Span& each_watch : item->watch) {
      if (spec.watch) subject.twice(each_watch, "watch is given twice", item->watch.front());
      spec.watch = true;
    }
    if (spec.robots.size() < 2) {
      subject.error("P63", item->keyword,
                    fmt::format("workspaces are of several machines, found {}", spec.robots.size()),
                    "of excavator, lorry_1, lorry_2;");
      continue;
    }
    subject.model.workspaces = std::move(spec);
  }
}

}  // namespace rubicon::interpreter::plan_check
