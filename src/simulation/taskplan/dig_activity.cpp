#include "src/simulation/taskplan/dig_activity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/motion/geometry/extent.hpp"
#include "src/motion/math/angles.hpp"
#include "src/motion/math/index.hpp"
#include "src/motion/robot/kinematics.hpp"
#include "src/motion/robot/turns.hpp"
#include "src/simulation/taskplan/handling_activity.hpp"
#include "src/simulation/taskplan/stage.hpp"
#include "src/simulation/taskplan/work_activity.hpp"

namespace rubicon::taskplan {

namespace {

using math::at;

/// Cuts that are looked at for one bucket, and shorter ones of each.
constexpr std::size_t kMostCuts = 12;
constexpr int kShorterCuts = 4;
/// A bucket that is less than half full makes another pass, but no more than these in all.
constexpr int kMostPasses = 6;
/// What a bucket takes is found where it is on its way, at places no farther apart than this share
/// of a cell, and no more of them in a step.
constexpr double kShareOfCell = 0.2;
constexpr int kMostPlaces = 2000;

/// The parts of a bucket in the frame of its body. What is no box counts by the box around it.
std::vector<soil::BucketBox> bucket_boxes(const robot::RobotModel& model) {
  std::vector<soil::BucketBox> boxes;
  for (const geometry::Shape& shape : model.bodies[at(model.tool_body)].shapes) {
    if (const auto* box = std::get_if<geometry::Box>(&shape.solid)) {
      boxes.push_back({box->lower, box->upper, shape.X_BS});
      continue;
    }
    const Eigen::AlignedBox3d around = geometry::extent_of(shape);
    boxes.push_back({around.min(), around.max(), math::Pose::Identity()});
  }
  return boxes;
}

/// The highest of a cell and the cells round it.
soil::Millimetres highest_round(const soil::Terrain& ground, int cell) {
  const int column = cell % ground.columns;
  const int row = cell / ground.columns;
  soil::Millimetres highest = ground.heights[at(cell)];
  for (int r = std::max(row - 1, 0); r <= std::min(row + 1, ground.rows - 1); ++r) {
    for (int c = std::max(column - 1, 0); c <= std::min(column + 1, ground.columns - 1); ++c) {
      highest = std::max(highest, ground.heights[ground.index(c, r)]);
    }
  }
  return highest;
}

/// The names of an earth and of all soil that is dug in it, by whomever.
std::set<std::string> grounds_of(const Stage& stage, int earth) {
  std::set<std::string> names = {stage.plan.earths[at(earth)].name};
  for (int task = 0; task < stage.plan_tasks(); ++task) {
    const interpreter::TaskSpec& spec = stage.spec(task);
    if (spec.dig && spec.dig->earth == earth) {
      names.insert(stage.site.component_name(spec.dig->soil));
    }
    if (spec.motion_dig && spec.motion_dig->earth == earth) {
      names.insert(stage.site.component_name(spec.motion_dig->soil));
    }
  }
  return names;
}

std::string point_text(const math::Vec3& p) {
  return fmt::format("({:.2f}, {:.2f}, {:.2f})", p.x(), p.y(), p.z());
}

}  // namespace

const interpreter::MotionDigSpec& DigActivity::spec_of(const ActiveTask& task, const Stage& stage) {
  return *stage.spec(task.task).motion_dig;
}

math::Pose DigActivity::X_WE(const ActiveTask& task, const Stage& stage) const {
  return stage.plan.earths[at(spec_of(task, stage).earth)].X_WE;
}

hauling::Nanoseconds DigActivity::worked(const ActiveTask& task, const Stage& stage) const {
  return stage.calendar(task.task).work_between(begun_, stage.now());
}

/// The dig point of the bucket, for people.
std::string DigActivity::place_text(const ActiveTask& task, const Stage& stage) const {
  const soil::Terrain& bottom = *spec_of(task, stage).after;
  return point_text(X_WE(task, stage) * soil::place_of_cell(bottom, target_.cell, target_.floor));
}

Step DigActivity::begin(ActiveTask& task, Stage& stage) {
  const interpreter::TaskSpec& spec = stage.spec(task.task);
  const interpreter::MotionDigSpec& dig = *spec.motion_dig;
  if (!stage.site.stands(dig.soil)) {
    stage.reject(task.task, stage.gone(dig.soil), stage.users_of(dig.soil));
    return Step::pending;
  }
  if (undercuts(task, stage, dig.soil)) return Step::pending;
  begun_ = stage.now();
  const robot::RobotModel& model = stage.robot_spec(spec.robot).robot->model;
  const robot::Mounting& mounting = stage.site.robot(spec.robot).mounting;
  const std::vector<double>& q = stage.site.configuration(spec.robot);
  std::vector<math::Pose> X_WB;
  robot::body_poses(model, mounting, q, X_WB);
  const math::Pose X_EW = X_WE(task, stage).inverse(Eigen::Isometry);
  const math::Pose X_TB =
      robot::tool_pose(model, mounting, q).inverse(Eigen::Isometry) * X_WB[at(model.tool_body)];
  boxes_ = bucket_boxes(model);
  grounds_ = std::make_shared<const std::set<std::string>>(grounds_of(stage, dig.earth));
  rules_.boxes = boxes_;
  for (soil::BucketBox& box : rules_.boxes) box.X_BS = X_TB * box.X_BS;
  rules_.p_EM = X_EW * X_WB.front().translation();
  rules_.R_HT = dig.X_HT_cut.linear();
  rules_.layer = dig.layer;
  rules_.tolerance = dig.tolerance;
  rules_.clearance = dig.clearance;
  rules_.room = dig.bucket;
  std::vector<int> cells;
  const soil::Heights& before = dig.before->heights;
  before.for_each_difference(dig.after->heights, [&](std::size_t i) {
    if (before[i] <= dig.after->heights[i]) return;
    rules_.top = cells.empty() ? before[i] : std::max(rules_.top, before[i]);
    cells.push_back(static_cast<int>(i));
    rules_.rim = std::max(rules_.rim, highest_round(*dig.before, static_cast<int>(i)));
  });
  cells_ = std::make_shared<const std::vector<int>>(std::move(cells));
  stage.site_changes.open_soil(dig.soil, dig);
  MotionDigOutcome outcome;
  outcome.earth = stage.plan.earths[at(dig.earth)].name;
  outcome.volume = dig.volume;
  outcome.bucket = dig.bucket;
  if (dig.trucks >= 0) {
    outcome.trucks = stage.plan.crews[at(dig.trucks)].name;
    outcome.truck_count = dig.hauls.trucks;
    outcome.load = dig.hauls.load;
    outcome.uncertain = dig.hauls.uncertain_stages() > 0;
    std::optional<std::pair<std::uint64_t, std::uint64_t>> by;
    if (const auto& sample = stage.draws.sample) by = {sample->seed, sample->run};
    trucks_ = hauling::TruckRounds(dig.hauls, by, spec.name);
  }
  if (dig.loads_bodies()) {
    outcome.bodies = static_cast<int>(dig.haulers.size());
    LoadingPlace& place = stage.haulage.places[task.task];
    place = {};
    place.is_open = true;
    place.claims.assign(1 + dig.queue.size(), -1);
  }
  task.account.outcome.motion_dig = std::move(outcome);
  if (dig.loads_bodies()) stage.announce({-1, -1, -1, true});
  return go_on(task, stage, call_truck(task, stage));
}

Step DigActivity::resume(ActiveTask& task, Stage& stage) {
  if (inner_) return go_on(task, stage, inner_->resume(task, stage));
  if (part_ == Part::awaiting) return go_on(task, stage, await_truck(task, stage));
  if (waits_for_truck_) {
    waits_for_truck_ = false;
    if (part_ == Part::calling) {
      task.account.outcome.motion_dig->waited +=
          stage.calendar(task.task).work_between(since_, stage.now());
    }
    task.account.outcome.waits.resource += stage.now() - since_;
    stage.pause(task.task, "truck", task.account.outcome.motion_dig->trucks, since_);
  }
  if (part_ == Part::tipping) return go_on(task, stage, finish(task, stage));
  return go_on(task, stage, call_truck(task, stage));
}

/// Whatever is over is followed by what comes next, until something takes time.
Step DigActivity::go_on(ActiveTask& task, Stage& stage, Step step) {
  while (step == Step::over && part_ != Part::done) {
    inner_ = {};
    step = next(task, stage);
  }
  if (step == Step::pending && is_over_truck()) reject_for_truck(task, stage);
  return step;
}

/// The truck under the bucket is in its way: it stands there until it is loaded. Nothing that
/// another task does would help.
void DigActivity::reject_for_truck(ActiveTask& task, Stage& stage) {
  const interpreter::MotionDigSpec& dig = spec_of(task, stage);
  if (!dig.loads_bodies() || stage.rejection) return;
  const int standing = stage.haulage.places.at(task.task).standing;
  if (standing < 0) return;
  const int truck = stage.spec(standing).robot;
  const std::vector<int> met = inner_->robots_in_the_way(stage);
  if (std::find(met.begin(), met.end(), truck) == met.end()) return;
  stage.reject(task.task,
               fmt::format("bucket {}: {} cannot empty it over {}, which is in its way where it "
                           "stands to be loaded",
                           task.account.outcome.motion_dig->buckets.size() + 1,
                           stage.robot_spec(stage.spec(task.task).robot).name,
                           stage.robot_spec(truck).name));
}

Step DigActivity::next(ActiveTask& task, Stage& stage) {
  const interpreter::MotionDigSpec& dig = spec_of(task, stage);
  const math::Pose X_WH = X_WE(task, stage);
  const auto tool = [&](double distance, double height) {
    return X_WH * bite_.X_ET(rules_, distance, height);
  };
  const auto dump_pose = [&](const math::Pose& X_HT) {
    const math::Vec3 p_E = X_WH.inverse(Eigen::Isometry) * dig.p_WD;
    const math::Vec3 away = p_E - rules_.p_EM;
    soil::BiteRules held = rules_;
    held.R_HT = X_HT.linear();
    soil::Bite dump;
    dump.heading_deg = math::atan2_deg(away.y(), away.x());
    return X_WH * dump.X_ET(held, std::sqrt(away.x() * away.x() + away.y() * away.y()), p_E.z());
  };
  switch (part_) {
    case Part::calling:
      return choose_cut(task, stage);
    case Part::approaching:
      part_ = Part::entering;
      if (passes_ == 1) bucket_.at_cut = worked(task, stage);
      entered_ = stage.now();
      q_entering_ = stage.site.configuration(stage.spec(task.task).robot);
      task.hits.keep_way(true);
      return begin_leg(task, stage, tool(bite_.far, bite_.low), "digging", "on its way down to");
    case Part::entering:
      if (!task.ended_short.empty()) {
        bite_.near = bite_.far;
        return take(task, stage);
      }
      part_ = Part::cutting;
      return begin_leg(task, stage, tool(bite_.near, bite_.low), "digging", "cutting at");
    case Part::cutting:
      if (!task.ended_short.empty()) bite_.near = distance_now(task, stage);
      return take(task, stage);
    case Part::filling:
      part_ = Part::raising;
      return begin_leg(task, stage, tool(bite_.near, bite_.high), "digging", "on its way up from");
    case Part::raising:
      if (!raise(task, stage)) return Step::pending;
      if (wants_more(task, stage)) {
        const Step step = choose_cut(task, stage);
        if (part_ == Part::approaching || step != Step::over) return step;
      }
      if (bucket_.volume == 0 && !blocked_.empty()) {
        stage.reject(task.task, blocked_);
        return Step::pending;
      }
      part_ = Part::awaiting;
      return dig.loads_bodies() ? await_truck(task, stage) : Step::over;
    case Part::awaiting:
      part_ = Part::swinging;
      return begin_leg(task, stage, dump_pose(dig.X_HT_carry), "loaded",
                       "to where it is emptied, from");
    case Part::swinging:
      part_ = Part::opening;
      bucket_.at_truck = worked(task, stage);
      if (!dig.X_HT_open) return Step::over;
      return begin_leg(task, stage, dump_pose(*dig.X_HT_open), "dumping",
                       "emptying what it dug at");
    case Part::opening:
      part_ = Part::dumping;
      return begin_work(task, stage, dig.dump, "dump");
    case Part::dumping:
      empty(task, stage);
      return call_truck(task, stage);
    case Part::tipping:
    case Part::done:
      break;
  }
  return Step::over;
}

/// Where the tool is, along the heading of the cut.
double DigActivity::distance_now(const ActiveTask& task, const Stage& stage) const {
  const math::Vec3 p_E = X_WE(task, stage).inverse(Eigen::Isometry) *
                         stage.site.tool_pose(stage.spec(task.task).robot).translation();
  const math::Vec3 away = p_E - rules_.p_EM;
  return away.x() * math::cos_deg(bite_.heading_deg) + away.y() * math::sin_deg(bite_.heading_deg);
}

/// The cut is over.
Step DigActivity::take(ActiveTask& task, Stage& stage) {
  part_ = Part::filling;
  fill(task, stage);
  return begin_work(task, stage, spec_of(task, stage).fill, "fill");
}

/// Time in which the trucks are under way.
Step DigActivity::wait_for_trucks(ActiveTask& task, Stage& stage, hauling::Nanoseconds time) {
  const Ticks then = stage.calendar(task.task).finish(begun_, time);
  if (then >= schedule::kEndOfTime) {
    stage.reject(task.task, "the trucks need longer than 126 years");
    return Step::pending;
  }
  waits_for_truck_ = true;
  since_ = stage.now();
  stage.events.set(task.task, std::max(then, stage.now()));
  return Step::pending;
}

/// The next bucket, once a truck is there for it.
Step DigActivity::call_truck(ActiveTask& task, Stage& stage) {
  const interpreter::MotionDigSpec& dig = spec_of(task, stage);
  part_ = Part::calling;
  if (!stage.site.stands(dig.soil)) {
    stage.reject(task.task, stage.gone(dig.soil), stage.users_of(dig.soil));
    return Step::pending;
  }
  if (!soil::next_target(*stage.site.surface(dig.soil), *dig.after, *cells_, put_off_, rules_)) {
    if (trucks_.is_loading()) trucks_.leave(worked(task, stage));
    return finish(task, stage);
  }
  if (dig.trucks < 0 || trucks_.is_loading()) return Step::over;
  const hauling::Nanoseconds now = worked(task, stage);
  const hauling::Nanoseconds then = trucks_.next_arrival(now);
  if (then > now) return wait_for_trucks(task, stage, then);
  trucks_.call(now);
  return Step::over;
}

/// Whether a truck with a body stands where it is loaded; it waits for one with a full bucket.
Step DigActivity::await_truck(ActiveTask& task, Stage& stage) {
  const interpreter::MotionDigSpec& dig = spec_of(task, stage);
  const LoadingPlace& place = stage.haulage.places.at(task.task);
  if (place.standing >= 0 && !stage.haulage.trucks.at(place.standing).is_full) {
    if (!std::exchange(waits_for_truck_, false)) return Step::over;
    task.account.outcome.motion_dig->waited +=
        stage.calendar(task.task).work_between(since_, stage.now());
    task.account.outcome.waits.resource += stage.now() - since_;
    stage.pause(task.task, "truck", stage.robot_spec(stage.spec(place.standing).robot).name,
                since_);
    return Step::over;
  }
  if (std::all_of(dig.haulers.begin(), dig.haulers.end(),
                  [&](int truck) { return stage.is_over(truck); })) {
    stage.reject(task.task,
                 fmt::format("bucket {}: no truck is left to load",
                             task.account.outcome.motion_dig->buckets.size() + 1),
                 dig.haulers);
    return Step::pending;
  }
  if (!waits_for_truck_) since_ = stage.now();
  waits_for_truck_ = true;
  stage.begins_to_wait(task.task);
  return Step::pending;
}

/// The truck that stands there has the bucket; it leaves when no whole one goes on it any more.
void DigActivity::load_truck(ActiveTask& task, Stage& stage) {
  const interpreter::MotionDigSpec& dig = spec_of(task, stage);
  const int standing = stage.haulage.places.at(task.task).standing;
  TruckLoad& truck = stage.haulage.trucks.at(standing);
  truck.volume += bucket_.volume;
  const interpreter::HaulSpec& haul = *stage.spec(standing).haul;
  const auto which = std::find(haul.digs.begin(), haul.digs.end(), task.task) - haul.digs.begin();
  truck.is_full = truck.volume + dig.bucket > haul.loads[static_cast<std::size_t>(which)];
  if (!truck.is_full) return;
  ++task.account.outcome.motion_dig->body_loads;
  stage.announce({-1, -1, -1, true});
}

/// Whether the bucket makes another pass before it is emptied.
bool DigActivity::wants_more(const ActiveTask& task, const Stage& stage) const {
  const interpreter::MotionDigSpec& dig = spec_of(task, stage);
  return passes_ < kMostPasses && bucket_.volume < dig.bucket / 2 &&
         soil::next_target(*stage.site.surface(dig.soil), *dig.after, *cells_, put_off_, rules_);
}

/// What is dug next, and the cuts for it; none: the bucket does not fit in there.
std::vector<soil::Bite> DigActivity::find_cuts(const ActiveTask& task, const Stage& stage) {
  const interpreter::MotionDigSpec& dig = spec_of(task, stage);
  const soil::Terrain& surface = *stage.site.surface(dig.soil);
  rules_.room = dig.bucket - bucket_.volume;
  for (;;) {
    target_ = *soil::next_target(surface, *dig.after, *cells_, put_off_, rules_);
    rules_.spread = target_.is_last ? soil::kTrimmed : 0;
    const auto blocked = blocked_from_.find(target_.cell);
    rules_.before = blocked == blocked_from_.end() ? soil::kAnywhere : blocked->second;
    std::vector<soil::Bite> bites = soil::bites_for(surface, *dig.after, target_, rules_);
    // It comes last in its layer.
    if (bites.empty() && put_off_.insert(target_.cell).second) continue;
    put_off_.erase(target_.cell);
    return bites;
  }
}

/// The next cut, of a new bucket or of one that is not full. Step::over: there is none for this
/// bucket.
Step DigActivity::choose_cut(ActiveTask& task, Stage& stage) {
  const interpreter::TaskSpec& spec = stage.spec(task.task);
  const interpreter::MotionDigSpec& dig = *spec.motion_dig;
  const bool is_new = part_ == Part::calling;
  if (is_new) {
    bucket_ = {};
    passes_ = 0;
  }
  const std::vector<soil::Bite> bites = find_cuts(task, stage);
  const std::size_t number = task.account.outcome.motion_dig->buckets.size() + 1;
  if (bites.empty()) {
    if (!is_new) return Step::over;
    stage.reject(
        task.task,
        !blocked_.empty()
            ? blocked_
            : fmt::format("bucket {}: the tool of {} does not fit in at {} beside the "
                          "ground that stays",
                          number, stage.robot_spec(spec.robot).name, place_text(task, stage)));
    return Step::pending;
  }
  const robot::RobotModel& model = stage.robot_spec(spec.robot).robot->model;
  const robot::Mounting& mounting = stage.site.robot(spec.robot).mounting;
  const std::vector<double>& q = stage.site.configuration(spec.robot);
  const math::Pose X = X_WE(task, stage);
  double miss = -1;
  double turn = 0;
  // Where the robot is when its tool gets there from `from`; nothing: it does not.
  using Place = std::optional<std::vector<double>>;
  const auto reach = [&](const std::vector<double>& from, double distance, double height) -> Place {
    robot::GoalSolution solution = robot::solve_goal(
        model, mounting, from, X * bite_.X_ET(rules_, distance, height), {}, spec.clauses);
    if (solution.reachable) return std::move(solution.q);
    if (miss < 0 || solution.position_error < miss) {
      miss = solution.position_error;
      turn = math::degrees(solution.orientation_error);
    }
    return std::nullopt;
  };
  for (std::size_t i = 0; i < std::min(bites.size(), kMostCuts); ++i) {
    bite_ = bites[i];
    const Place above = reach(q, bite_.far, bite_.high);
    const Place down = above ? reach(*above, bite_.far, bite_.low) : std::nullopt;
    if (!down) continue;
    const double cut = bite_.far - bites[i].near;
    for (int k = kShorterCuts; k >= 0; --k) {
      bite_.near = bite_.far - cut * k / kShorterCuts;
      const Place end = reach(*down, bite_.near, bite_.low);
      if (!end || !reach(*end, bite_.near, bite_.high)) continue;
      if (is_new) {
        bucket_.begin = worked(task, stage);
        if (dig.trucks >= 0) bucket_.truck = trucks_.truck();
      }
      ++passes_;
      cut_.clear();
      part_ = Part::approaching;
      return begin_leg(task, stage, X * bite_.X_ET(rules_, bite_.far, bite_.high),
                       is_new ? "empty" : "loaded", "on its way to above");
    }
  }
  if (!is_new) return Step::over;
  stage.reject(task.task,
               fmt::format("bucket {}: {} cannot reach {} to dig there: its tool comes no nearer "
                           "than {:.2f} m and {:.0f} deg",
                           number, stage.robot_spec(spec.robot).name, place_text(task, stage),
                           std::max(miss, 0.0), turn));
  return Step::pending;
}

Step DigActivity::begin_leg(ActiveTask& task, Stage& stage, const math::Pose& X_WG,
                            const char* situation, const char* what) {
  const interpreter::TaskSpec& spec = stage.spec(task.task);
  MotionLeg leg;
  interpreter::GoalSpec& goal = leg.goals.emplace_back();
  goal.X_WG = X_WG;
  goal.span = spec.span;
  leg.situation = situation;
  task.ended_short.clear();
  const bool cuts = part_ == Part::entering || part_ == Part::cutting;
  if (cuts) {
    // Nearer to the machine it may be free of the ground; of what else is there, nobody knows.
    leg.may_end_at = grounds_;
  }
  const bool digs = cuts || part_ == Part::raising;
  if (digs) {
    const robot::RobotModel& model = stage.robot_spec(spec.robot).robot->model;
    leg.entered.emplace_back(model.tool_body, spec.motion_dig->soil);
    leg.guided = false;
  }
  leg.what = fmt::format("bucket {}, {} {}", task.account.outcome.motion_dig->buckets.size() + 1,
                         what, place_text(task, stage));
  inner_ = Snapshot<Activity>(std::make_unique<MotionActivity>(std::move(leg)));
  return inner_->begin(task, stage);
}

Step DigActivity::begin_work(ActiveTask& task, Stage& stage, const interpreter::WorkSpec& work,
                             const char* what) {
  task.phases[task.phase].work = &work;
  task.phases[task.phase].what = what;
  inner_ = Snapshot<Activity>(std::make_unique<WorkActivity>());
  return inner_->begin(task, stage);
}

/// What the bucket has taken on its way.
void DigActivity::fill(ActiveTask& task, Stage& stage) {
  const interpreter::TaskSpec& spec = stage.spec(task.task);
  const interpreter::MotionDigSpec& dig = *spec.motion_dig;
  const robot::RobotModel& model = stage.robot_spec(spec.robot).robot->model;
  const robot::Mounting& mounting = stage.site.robot(spec.robot).mounting;
  const soil::Terrain& surface = *stage.site.surface(dig.soil);
  const math::Pose X_EW = X_WE(task, stage).inverse(Eigen::Isometry);
  task.hits.keep_way(false);
  soil::BucketFill bucket(surface, *dig.after, boxes_, rules_.room, dig.tolerance, rules_.spread);
  const double apart = kShareOfCell * static_cast<double>(surface.cell) * 1e-3;
  std::vector<math::Pose> X_WB;
  std::vector<double> q0 = q_entering_;
  for (const std::vector<double>& q : task.hits.way()) {
    std::vector<double> q1 = q0;
    for (std::size_t i = 0; i < q.size(); ++i) {
      q1[i] += robot::way_between(model.parameters[i], q0[i], q[i]);
    }
    const auto tool = [&](const std::vector<double>& at_q) -> math::Vec3 {
      return robot::tool_pose(model, mounting, at_q).translation();
    };
    const double way = (tool(q1) - tool(q0)).norm();
    const int places = std::clamp(static_cast<int>(std::ceil(way / apart)), 1, kMostPlaces);
    for (int i = 1; i <= places; ++i) {
      const std::vector<double> here =
          robot::configuration_at(q0, q1, static_cast<double>(i) / places);
      robot::body_poses(model, mounting, here, X_WB);
      bucket.pass(X_EW * X_WB[at(model.tool_body)]);
    }
    q0 = q;
  }
  is_blocked_ = !task.ended_short.empty();
  if (is_blocked_) blocked_ = task.ended_short;
  cut_ = bucket.changes();
  bucket_.volume += bucket.volume();
  cut_volume_ = bucket.volume();
  is_full_ = bucket.is_full();
}

/// The bucket is above the soil, which is without what it has taken. False: it gets nowhere, and
/// the task is rejected.
bool DigActivity::raise(ActiveTask& task, Stage& stage) {
  const interpreter::MotionDigSpec& dig = spec_of(task, stage);
  bucket_.raised = worked(task, stage);
  if (!cut_.empty()) stage.site_changes.set_surface(dig.soil, cut_);
  const soil::Terrain& surface = *stage.site.surface(dig.soil);
  const bool stays_above = surface.heights[at(target_.cell)] > target_.floor + dig.tolerance;
  if (!cut_.empty()) blocked_from_.clear();
  if (!cut_.empty() && !is_blocked_) blocked_.clear();
  if (is_blocked_) {
    // One that is nearer may get there.
    blocked_from_.insert_or_assign(bite_.cell, bite_.far);
  } else if (!is_full_ && stays_above) {
    stage.reject(task.task, fmt::format("bucket {}: {} does not get down to the soil at {}",
                                        task.account.outcome.motion_dig->buckets.size() + 1,
                                        stage.robot_spec(stage.spec(task.task).robot).name,
                                        place_text(task, stage)));
    return false;
  }
  // The next cut would be the same, for the soil is: what is left there is within the tolerance.
  if (!is_full_ && cut_.empty() && !is_blocked_) leave_cell();
  if (auto* const trace = stage.trace_of(task.task)) {
    trace->soil(stage.site.component_name(dig.soil), cut_volume_, cut_, entered_, stage.now());
  }
  stage.made_progress();
  return true;
}

/// The cell that is dug now is not looked at any more.
void DigActivity::leave_cell() {
  auto cells = std::make_shared<std::vector<int>>(*cells_);
  std::erase(*cells, target_.cell);
  cells_ = std::move(cells);
  put_off_.erase(target_.cell);
}

/// The bucket is empty. A truck leaves when no whole bucket goes into it any more.
void DigActivity::empty(ActiveTask& task, Stage& stage) {
  const interpreter::MotionDigSpec& dig = spec_of(task, stage);
  bucket_.empty = worked(task, stage);
  if (dig.loads_bodies()) {
    const int standing = stage.haulage.places.at(task.task).standing;
    bucket_.truck = static_cast<int>(std::find(dig.haulers.begin(), dig.haulers.end(), standing) -
                                     dig.haulers.begin());
  }
  task.account.outcome.motion_dig->buckets.push_back(bucket_);
  if (dig.loads_bodies()) load_truck(task, stage);
  if (dig.trucks < 0) return;
  trucks_.load(bucket_.volume);
  if (trucks_.loaded() + dig.bucket > dig.hauls.load) trucks_.leave(bucket_.empty);
}

/// All is dug; it is done when the last truck has tipped.
Step DigActivity::finish(ActiveTask& task, Stage& stage) {
  const interpreter::MotionDigSpec& dig = spec_of(task, stage);
  part_ = Part::tipping;
  const hauling::Nanoseconds now = worked(task, stage);
  if (dig.trucks >= 0) {
    const hauling::Nanoseconds tipped = trucks_.last_tip();
    if (tipped > now) return wait_for_trucks(task, stage, tipped);
  }
  MotionDigOutcome& outcome = *task.account.outcome.motion_dig;
  if (dig.loads_bodies()) {
    LoadingPlace& place = stage.haulage.places.at(task.task);
    place.is_open = false;
    place.is_over = true;
    if (place.standing >= 0) {
      TruckLoad& truck = stage.haulage.trucks.at(place.standing);
      if (!truck.is_full && truck.volume > 0) ++outcome.body_loads;
      truck.is_full = true;
    }
    stage.announce({-1, -1, -1, true});
  }
  outcome.time = now;
  outcome.loads = trucks_.loads();
  outcome.queues = trucks_.queues();
  outcome.hauling = trucks_.work_until(now);
  part_ = Part::done;
  return Step::over;
}

Step DigActivity::granted(ActiveTask& task, Stage& stage, const ResourceAllocator::Grant& grant) {
  return inner_ ? go_on(task, stage, inner_->granted(task, stage, grant)) : Step::pending;
}

WaitSet DigActivity::waits(const ActiveTask& task, const Stage& stage) const {
  if (inner_) return inner_->waits(task, stage);
  WaitSet waits;
  if (part_ != Part::awaiting || !waits_for_truck_) return waits;
  waits.any = true;
  WaitTarget target;
  for (const int truck : spec_of(task, stage).haulers) {
    if (!stage.is_over(truck)) target.by.push_back(truck);
  }
  waits.targets.push_back(std::move(target));
  return waits;
}

std::string DigActivity::text_of(const ActiveTask& task, const Stage& stage,
                                 const WaitTarget& target) const {
  if (inner_) return inner_->text_of(task, stage, target);
  return fmt::format("{} waits for a truck", stage.who_is(task.task));
}

std::string DigActivity::standstill_reason(const ActiveTask& task, const Stage& stage) const {
  if (inner_) return inner_->standstill_reason(task, stage);
  return part_ == Part::awaiting ? "no truck ever comes to be loaded" : std::string();
}

bool DigActivity::wakes_at(const ActiveTask& task, const Stage& stage,
                           const SiteEvent& event) const {
  if (inner_) return inner_->wakes_at(task, stage, event);
  return part_ == Part::awaiting && waits_for_truck_ && event.haulage;
}

std::vector<int> DigActivity::robots_in_the_way(const Stage& stage) const {
  return inner_ ? inner_->robots_in_the_way(stage) : std::vector<int>();
}

}  // namespace rubicon::taskplan
