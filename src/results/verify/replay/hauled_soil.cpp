#include "src/results/verify/replay/hauled_soil.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/index.hpp"
#include "src/results/verify/geometry/pose_miss.hpp"
#include "src/results/verify/replay/dug_soil.hpp"

namespace rubicon::verify {

namespace {

using math::at;

/// m: a truck may be so far from its place.
constexpr double kStandSlack = 1e-3;
/// mm from cell to cell that rounding may add to a slope.
constexpr double kSlopeSlack = 2;

/// m: ground may be so much lower than the wheels of a truck that drives over it.
constexpr double kDriven = 0.15;

/// A load that was tipped on a heap, or that was not.
struct Tipping {
  const Record* record = nullptr;
  const SoilTaken* taken = nullptr;
  const TaskRun* run = nullptr;
};

/// All that trucks tipped on a component, in the order of time.
std::vector<Tipping> tippings(const Trace& trace, const std::vector<TaskRun>& runs, int component) {
  std::vector<Tipping> found;
  for (const TaskRun& run : runs) {
    if (!run.happened || run.task < 0 || !trace.scene.tasks[at(run.task)].haul) continue;
    for (const int index : run.records) {
      const Record& record = trace.records[at(index)];
      const auto* taken = std::get_if<SoilTaken>(&record.what);
      if (taken != nullptr && taken->component == component && taken->volume < 0) {
        found.push_back({&record, taken, &run});
      }
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const Tipping& a, const Tipping& b) {
    return std::tie(a.record->time, a.record->line) < std::tie(b.record->time, b.record->line);
  });
  return found;
}

const SceneTask* task_named(const Scene& scene, const std::string& name) {
  for (const SceneTask& task : scene.tasks) {
    if (task.name == name) return &task;
  }
  return nullptr;
}

/// The dig of a haul whose soil this is; null: none.
const SceneTask* dig_of_soil(const Scene& scene, const SceneHaul& haul, int component) {
  for (const std::string& name : haul.digs) {
    const SceneTask* const dig = task_named(scene, name);
    if (dig != nullptr && dig->motion_dig && dig->motion_dig->soil == component) return dig;
  }
  return nullptr;
}

/// All hauls of a plan.
class HaulReplay {
 public:
  HaulReplay(const Trace& trace, const std::vector<TaskRun>& runs,
             const std::vector<RobotTrack>& tracks, const SiteParts& site, Faults& faults)
      : trace_(trace), runs_(runs), tracks_(tracks), site_(site), faults_(faults) {}

  void check() {
    for (const TaskRun& run : runs_) {
      if (!run.happened || run.task < 0 || run.robot < 0) continue;
      const SceneTask& task = trace_.scene.tasks[at(run.task)];
      if (!task.motion_dig || !task.motion_dig->load_at) continue;
      buckets_[&task] = emptied_buckets(trace_, run, *site_.robots[at(run.robot)].mechanism);
      used_[&task].resize(buckets_[&task].size());
    }
    for (const TaskRun& run : runs_) {
      const bool hauls = run.happened && run.task >= 0 && run.robot >= 0 &&
                         trace_.scene.tasks[at(run.task)].haul.has_value();
      if (hauls) check_run(run);
    }
    for (const TaskRun& run : runs_) {
      if (!run.happened || run.task < 0) continue;
      const auto used = used_.find(&trace_.scene.tasks[at(run.task)]);
      if (used == used_.end()) continue;
      record_ = nullptr;
      const auto left = std::count(used->second.begin(), used->second.end(), false);
      if (left > 0) fault(run, fmt::format("{} of its buckets went away with no truck", left));
    }
    for (const SceneHeap& heap : trace_.scene.heaps) check_heap(heap);
    for (const TaskRun& run : runs_) {
      if (!run.happened || run.task < 0) continue;
      const SceneTask& task = trace_.scene.tasks[at(run.task)];
      if (task.motion_dig) check_buckets_pit(run, *task.motion_dig);
      if (task.dig && task.dig->pit) check_crews_pit(run, *task.dig->pit);
    }
  }

 private:
  void fault(const TaskRun& run, const std::string& text) {
    const int line = record_ != nullptr ? record_->line : run.end_line;
    const Ticks time = record_ != nullptr ? record_->time : run.end;
    faults_.push_back({FaultKind::load, ResultFile::trace, line, trace_.runs[at(run.run)], time,
                       "soil: " + text});
  }

  const Mechanism& mechanism(const TaskRun& run) const {
    return *site_.robots[at(run.robot)].mechanism;
  }

  /// Whether the truck stood there all the time.
  bool stood(const TaskRun& run, const Pose& X_WL, Ticks from, Ticks to) const {
    for (const Leg& leg : tracks_[at(run.robot)].legs) {
      if (leg.to <= from || leg.from >= to) continue;
      if (leg.moves()) return false;
      if (!is_there(run, leg.q0, X_WL)) return false;
    }
    return true;
  }

  bool is_there(const TaskRun& run, const std::vector<double>& q, const Pose& X_WL) const {
    const Pose X_WT = mechanism(run).pose(mechanism(run).tool(), q);
    return (X_WT.translation() - X_WL.translation()).norm() <= kStandSlack &&
           (X_WT.linear() - X_WL.linear()).norm() <= kStandSlack;
  }

  /// Whether a point is at a place, or straight away from it, from where loads fall.
  static bool is_in_row(const SceneHaul& haul, const Pose& X_WL, const Vec3& p) {
    const Vec3 way = p - X_WL.translation();
    if (haul.heap < 0 || way.norm() <= kStandSlack) return way.norm() <= kStandSlack;
    Vec3 away = X_WL.linear() * -haul.p_TH;
    away.z() = 0;
    return away.norm() > 0 && (away.normalized() * way.norm() - way).norm() <= kStandSlack;
  }

  void check_run(const TaskRun& run) {
    const SceneHaul& haul = *trace_.scene.tasks[at(run.task)].haul;
    std::int64_t carried = 0;
    std::vector<double> q;
    const SceneTask* dig = nullptr;
    for (const int index : run.records) {
      record_ = &trace_.records[at(index)];
      if (const auto* end = std::get_if<MotionEnd>(&record_->what)) q = end->q;
      const auto* taken = std::get_if<SoilTaken>(&record_->what);
      if (taken == nullptr) continue;
      if (taken->volume > 0) {
        if (carried != 0) fault(run, "it is loaded before it has tipped");
        carried = taken->volume;
        dig = dig_of_soil(trace_.scene, haul, taken->component);
        check_load(run, haul, *taken, dig);
      } else {
        if (taken->volume != -carried) {
          fault(run, fmt::format("it tips {} mm3 and carries {} mm3", -taken->volume, carried));
        }
        carried = 0;
        const bool at_tip =
            !q.empty() && std::any_of(haul.tips.begin(), haul.tips.end(), [&](const Pose& X_WL) {
              const Pose X_WT = mechanism(run).pose(mechanism(run).tool(), q);
              return is_in_row(haul, X_WL, X_WT.translation());
            });
        if (!at_tip) fault(run, "it tips where it does not stand at one of its places");
        const int expected = haul.heap >= 0                      ? haul.heap
                             : dig != nullptr && dig->motion_dig ? dig->motion_dig->soil
                                                                 : -1;
        if (taken->component != expected) fault(run, "it tips something else");
      }
    }
    record_ = nullptr;
    if (carried != 0) fault(run, "its last load was not tipped");
  }

  void check_load(const TaskRun& run, const SceneHaul& haul, const SoilTaken& taken,
                  const SceneTask* dig) {
    if (dig == nullptr || !dig->motion_dig->load_at) {
      fault(run, "it is loaded by a task for which it does not haul");
      return;
    }
    if (!stood(run, *dig->motion_dig->load_at, taken.from, record_->time)) {
      fault(run, "it does not stand where it is loaded while it is");
    }
    const auto number = static_cast<std::size_t>(
        std::find(haul.digs.begin(), haul.digs.end(), dig->name) - haul.digs.begin());
    if (taken.volume > haul.loads[number]) {
      fault(run, fmt::format("it takes {} mm3, and has room for {} mm3", taken.volume,
                             haul.loads[number]));
    }
    std::int64_t sum = 0;
    const std::vector<EmptiedBucket>& buckets = buckets_[dig];
    for (std::size_t i = 0; i < buckets.size(); ++i) {
      if (buckets[i].time < taken.from || buckets[i].time > record_->time) continue;
      if (used_[dig][i]) fault(run, "a bucket is loaded on two trucks");
      used_[dig][i] = true;
      sum += buckets[i].volume;
    }
    if (sum != taken.volume) {
      fault(run,
            fmt::format("{} mm3 were emptied on it, and it carries {} mm3", sum, taken.volume));
    }
  }

  void check_heap(const SceneHeap& heap) {
    std::vector<std::int64_t> heights = heap.ground;
    const double area = static_cast<double>(heap.cell) * static_cast<double>(heap.cell);
    std::int64_t loose = 0;
    std::int64_t placed = 0;
    for (const Tipping& each : tippings(trace_, runs_, heap.component)) {
      record_ = each.record;
      const SceneHaul& haul = *trace_.scene.tasks[at(each.run->task)].haul;
      loose += std::llround(static_cast<double>(-each.taken->volume) *
                            (1 + swell_of(*each.run, *each.record)));
      const std::int64_t before = placed;
      placed = std::max(loose / static_cast<std::int64_t>(area), before + 1);
      std::int64_t raised = 0;
      for (std::size_t i = 0; i < each.taken->cells.size(); ++i) {
        const int cell = each.taken->cells[i];
        const std::int64_t height = each.taken->heights[i];
        if (cell >= static_cast<int>(heights.size()) || height <= heights[at(cell)] ||
            std::find(heap.dug.begin(), heap.dug.end(), cell) != heap.dug.end()) {
          fault(*each.run, fmt::format("nothing can be tipped on cell {}", cell));
          return;
        }
        raised += height - heights[at(cell)];
        heights[at(cell)] = height;
      }
      if (raised != placed - before) {
        fault(*each.run, fmt::format("a heap grows by {} mm of cells, and its loads are {}", raised,
                                     placed - before));
      }
      check_slopes(heap, heights, each);
      check_place(heap, haul, heights, each);
    }
  }

  /// Of the soil that a load is of.
  double swell_of(const TaskRun& run, const Record& tipped) const {
    double swell = 0;
    for (const int index : run.records) {
      const Record& record = trace_.records[at(index)];
      if (record.line >= tipped.line) break;
      const auto* taken = std::get_if<SoilTaken>(&record.what);
      if (taken == nullptr || taken->volume <= 0) continue;
      const SceneTask* const dig =
          dig_of_soil(trace_.scene, *trace_.scene.tasks[at(run.task)].haul, taken->component);
      if (dig != nullptr) swell = dig->motion_dig->swell;
    }
    return swell;
  }

  void check_slopes(const SceneHeap& heap, const std::vector<std::int64_t>& heights,
                    const Tipping& tipped) {
    const double slope = math::sin_deg(heap.repose_deg) / math::cos_deg(heap.repose_deg);
    const int rows = static_cast<int>(heights.size()) / heap.columns;
    for (const int cell : tipped.taken->cells) {
      const int column = cell % heap.columns;
      const int row = cell / heap.columns;
      for (int r = std::max(row - 1, 0); r <= std::min(row + 1, rows - 1); ++r) {
        for (int c = std::max(column - 1, 0); c <= std::min(column + 1, heap.columns - 1); ++c) {
          const double apart = std::sqrt((c - column) * (c - column) + (r - row) * (r - row)) *
                               static_cast<double>(heap.cell);
          const double down =
              static_cast<double>(heights[at(cell)] - heights[at(r * heap.columns + c)]);
          if (down <= slope * apart + kSlopeSlack) continue;
          fault(*tipped.run, fmt::format("cell {} of a heap is {} mm above the one beside it, "
                                         "steeper than {:g} deg",
                                         cell, down, heap.repose_deg));
          return;
        }
      }
    }
  }

  /// The heap is highest where the load fell.
  void check_place(const SceneHeap& heap, const SceneHaul& haul,
                   const std::vector<std::int64_t>& heights, const Tipping& tipped) {
    const std::vector<double>* q = nullptr;
    for (const int index : tipped.run->records) {
      const Record& record = trace_.records[at(index)];
      if (record.line >= tipped.record->line) break;
      if (const auto* end = std::get_if<MotionEnd>(&record.what)) q = &end->q;
    }
    if (q == nullptr) return;
    const Mechanism& truck = mechanism(*tipped.run);
    const Vec3 p_E =
        heap.X_WE.inverse(Eigen::Isometry) * (truck.pose(truck.tool(), *q) * haul.p_TH);
    const double side = static_cast<double>(heap.cell) * 1e-3;
    std::int64_t top = 0;
    bool is_known = false;
    // where it fell, or beside it where that is at the edge of two cells
    for (const double dx : {-kStandSlack, kStandSlack}) {
      for (const double dy : {-kStandSlack, kStandSlack}) {
        const auto column = static_cast<int>(std::floor((p_E.x() + dx) / side));
        const auto row = static_cast<int>(std::floor((p_E.y() + dy) / side));
        const int cell = row * heap.columns + column;
        if (column < 0 || row < 0 || column >= heap.columns ||
            cell >= static_cast<int>(heights.size())) {
          continue;
        }
        top = is_known ? std::max(top, heights[at(cell)]) : heights[at(cell)];
        is_known = true;
      }
    }
    const bool is_highest = std::all_of(tipped.taken->heights.begin(), tipped.taken->heights.end(),
                                        [&](std::int64_t height) { return height <= top + 1; });
    if (!is_known || !is_highest) fault(*tipped.run, "a load does not lie where it fell");
  }

  /// When cells were lowered, and to which heights.
  using Lowered = std::map<int, std::vector<std::pair<Ticks, std::int64_t>>>;

  /// That of a dig by durations is open from its beginning.
  void check_crews_pit(const TaskRun& dug, const ScenePit& pit) {
    if (dug.result != TaskResult::done) return;
    Lowered lower;
    for (std::size_t i = 0; i < pit.cells.size(); ++i) {
      lower[pit.cells[i]].emplace_back(dug.start, pit.after[i]);
    }
    check_pit(dug, pit, lower);
  }

  void check_buckets_pit(const TaskRun& dug, const SceneMotionDig& dig) {
    Lowered lower;
    for (const int index : dug.records) {
      const Record& record = trace_.records[at(index)];
      const auto* taken = std::get_if<SoilTaken>(&record.what);
      if (taken == nullptr) continue;
      for (std::size_t i = 0; i < taken->cells.size(); ++i) {
        lower[taken->cells[i]].emplace_back(record.time, taken->heights[i]);
      }
    }
    check_pit(dug, {dig.X_WE, dig.columns, dig.cell, dig.cells, dig.before, {}}, lower);
  }

  /// No truck drives over the middle of a cell that was dug.
  void check_pit(const TaskRun& dug, const ScenePit& pit, const Lowered& lower) {
    record_ = nullptr;
    for (std::size_t r = 0; r < tracks_.size(); ++r) {
      if (!drives(static_cast<int>(r))) continue;
      for (const Leg& leg : tracks_[r].legs) {
        if (!leg.moves() || leg.run < 0) continue;
        const TaskRun& run = runs_[at(leg.run)];
        if (!is_over(static_cast<int>(r), leg, pit, lower)) continue;
        faults_.push_back({FaultKind::contact, ResultFile::trace, leg.line,
                           trace_.runs[at(run.run)], leg.to,
                           fmt::format("soil: it drives over the pit of {}",
                                       trace_.scene.tasks[at(dug.task)].name)});
        return;  // one of a pit is enough
      }
    }
  }

  /// Whether it is on wheels: it hauls, or its tool is on a body that goes along x and y by itself,
  /// and is not lifted.
  bool drives(int robot) const {
    const bool hauls = std::any_of(runs_.begin(), runs_.end(), [&](const TaskRun& run) {
      return run.robot == robot && run.task >= 0 &&
             trace_.scene.tasks[at(run.task)].haul.has_value();
    });
    if (hauls) return true;
    const SceneRobot& machine = trace_.scene.robots[at(robot)];
    const auto has = [&](const std::string& name) {
      return std::any_of(machine.parameters.begin(), machine.parameters.end(),
                         [&](const SceneParameter& each) {
                           const bool is_so = each.name == name || each.name.ends_with("." + name);
                           return each.body == machine.tool_body && is_so;
                         });
    };
    const SceneBody& body = machine.bodies[at(machine.tool_body)];
    return body.parent < 0 && !body.shapes.empty() && has("x") && has("y") && !has("z");
  }

  bool is_over(int robot, const Leg& leg, const ScenePit& dig, const Lowered& lower) const {
    const SceneBody& body =
        trace_.scene.robots[at(robot)].bodies[at(trace_.scene.robots[at(robot)].tool_body)];
    const Mechanism& truck = *site_.robots[at(robot)].mechanism;
    const Bounds bounds = make_solid(body.shapes, trace_.scene.meshes)->bounds;
    const double side = static_cast<double>(dig.cell) * 1e-3;
    for (const double part : {0.5, 1.0}) {
      std::vector<double> q = leg.q0;
      for (std::size_t i = 0; i < q.size(); ++i) q[i] += part * (leg.q1[i] - leg.q0[i]);
      const Pose X_BE =
          truck.pose(trace_.scene.robots[at(robot)].tool_body, q).inverse(Eigen::Isometry) *
          dig.X_WE;
      const double ground = truck.pose(truck.tool(), q).translation().z() - kDriven;
      for (const auto& [cell, heights] : lower) {
        if (heights.front().first > leg.from) continue;
        const Vec3 p_E((cell % dig.columns + 0.5) * side,
                       (static_cast<double>(cell / dig.columns) + 0.5) * side, 0);
        const Vec3 p_B = X_BE * p_E;
        if (p_B.x() < bounds.lower.x() || p_B.x() > bounds.upper.x() ||
            p_B.y() < bounds.lower.y() || p_B.y() > bounds.upper.y()) {
          continue;
        }
        std::int64_t height = heights.front().second;
        for (const auto& each : heights) {
          if (each.first <= leg.from) height = each.second;
        }
        const double z = dig.X_WE.translation().z();
        if (z + static_cast<double>(height) * 1e-3 >= ground) continue;
        // What hangs over the ground as it was does not drive there.
        const auto known = std::lower_bound(dig.cells.begin(), dig.cells.end(), cell);
        if (known == dig.cells.end() || *known != cell) continue;
        const std::int64_t before = dig.before[static_cast<std::size_t>(known - dig.cells.begin())];
        if (z + static_cast<double>(before) * 1e-3 >= ground) return true;
      }
    }
    return false;
  }

  const Trace& trace_;
  const std::vector<TaskRun>& runs_;
  const std::vector<RobotTrack>& tracks_;
  const SiteParts& site_;
  Faults& faults_;
  const Record* record_ = nullptr;
  std::map<const SceneTask*, std::vector<EmptiedBucket>> buckets_;
  std::map<const SceneTask*, std::vector<bool>> used_;
};

std::shared_ptr<const Solid> heap_column(const SceneHeap& heap, int cell, std::int64_t top) {
  const double side = static_cast<double>(heap.cell) * 1e-3;
  const double x = cell % heap.columns * side;
  const double y = static_cast<double>(cell / heap.columns) * side;
  ShapeData box;
  box.a = {x, y, static_cast<double>(heap.ground[at(cell)]) * 1e-3};
  box.b = {x + side, y + side, static_cast<double>(top) * 1e-3};
  return make_solid({box}, {});
}

}  // namespace

void add_heaps(const Trace& trace, const std::vector<TaskRun>& runs, Ticks until,
               std::vector<Obstacle>& obstacles) {
  for (const SceneHeap& heap : trace.scene.heaps) {
    std::map<int, std::pair<std::int64_t, Ticks>> columns;
    const auto add = [&](int cell, Ticks to) {
      const auto& [height, since] = columns.at(cell);
      if (since >= to) return;
      obstacles.push_back({trace.scene.components[at(heap.component)].name,
                           heap_column(heap, cell, height), heap.X_WE, since, to, heap.component,
                           -1});
    };
    for (const Tipping& each : tippings(trace, runs, heap.component)) {
      for (std::size_t i = 0; i < each.taken->cells.size(); ++i) {
        const int cell = each.taken->cells[i];
        if (cell >= static_cast<int>(heap.ground.size())) continue;
        if (columns.contains(cell)) add(cell, each.record->time);
        columns[cell] = {each.taken->heights[i], each.record->time};
      }
    }
    for (const auto& each : columns) add(each.first, until);
  }
}

void check_hauled_soil(const Trace& trace, const std::vector<TaskRun>& runs,
                       const std::vector<RobotTrack>& tracks, const SiteParts& site,
                       Faults& faults) {
  HaulReplay(trace, runs, tracks, site, faults).check();
}

}  // namespace rubicon::verify
