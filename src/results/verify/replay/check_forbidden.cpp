#include "src/results/verify/replay/check_forbidden.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/results/verify/replay/leg_motion.hpp"
#include "src/results/verify/replay/step_rules.hpp"

namespace rubicon::verify {

namespace {

using math::at;

/// Of each grid so many of its free cells are judged again, spread evenly.
constexpr long kCellsJudged = 64;

/// One grid of a run, and what was there when it was sampled.
class ForbiddenCheck {
 public:
  ForbiddenCheck(const Trace& trace, const TaskRun& run, const RobotTrack& track,
                 const SiteParts& site, const Record& record, Faults& faults)
      : trace_(trace),
        run_(run),
        track_(track),
        site_(site),
        record_(record),
        grid_(std::get<Forbidden>(record.what)),
        faults_(faults),
        robot_(trace.scene.robots[at(run.robot)]),
        machine_(site.robots[at(run.robot)]) {}

  void check() {
    if (!is_in_range() || !is_judged()) return;
    find_load();
    long free = 0;
    for (std::size_t i = 0; i < grid_.runs.size(); i += 2) free += grid_.runs[i];
    const long stride = std::max(1L, free / kCellsJudged);
    long cell = 0;
    long count = 0;
    for (std::size_t i = 0; i < grid_.runs.size(); ++i) {
      for (long k = 0; i % 2 == 0 && k < grid_.runs[i]; ++k, ++count) {
        if (count % stride == stride / 2 && !is_free(cell + k)) return;
      }
      cell += grid_.runs[i];
    }
  }

 private:
  bool fault(FaultKind kind, std::string text) {
    faults_.push_back({kind, ResultFile::trace, record_.line, trace_.runs[at(run_.run)],
                       record_.time, std::move(text)});
    return false;
  }

  /// The values of a parameter that the grid goes over.
  std::pair<double, double> range(std::size_t axis) const {
    if (axis < 2) return {grid_.low[axis], grid_.high[axis]};
    return {grid_.layers.front(), grid_.layers.back()};
  }

  bool is_in_range() {
    for (std::size_t i = 0; i < grid_.parameters.size(); ++i) {
      const SceneParameter& p = robot_.parameters[at(grid_.parameters[i])];
      const auto [low, high] = range(i);
      constexpr double kHalfTurn = 180;
      const double least = p.cyclic ? -kHalfTurn : p.lower.value_or(low);
      const double most = p.cyclic ? kHalfTurn : p.upper.value_or(high);
      if (low >= least - kValueSlack && high <= most + kValueSlack) continue;
      return fault(FaultKind::motion, fmt::format("what is told as forbidden goes past the limits "
                                                  "of {}: from {:g} to {:g}",
                                                  p.name, low, high));
    }
    return true;
  }

  /// What digs and hauls cuts into soil that changes.
  bool is_judged() const {
    if (run_.task < 0) return true;
    const SceneTask& task = trace_.scene.tasks[at(run_.task)];
    return !task.motion_dig && !task.haul;
  }

  /// What hangs on the tool then, where that is beyond doubt.
  void find_load() {
    int hanging = -2;
    for (const Leg& each : track_.legs) {
      if (each.from > record_.time || each.to < record_.time) continue;
      if (hanging != -2 && hanging != each.hanging) return;
      hanging = each.hanging;
    }
    if (hanging >= 0 && track_.loads[at(hanging)].turn_deg == 0) load_ = hanging;
  }

  std::vector<double> configuration(long cell) const {
    std::vector<double> q = grid_.at;
    const long rows = cell / grid_.cells[0];
    const std::pair<long, long> place = {cell % grid_.cells[0], rows % grid_.cells[1]};
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
      const auto index = static_cast<double>(k == 0 ? place.first : place.second);
      q[at(grid_.parameters[k])] =
          grid_.low[k] + (index + 0.5) / grid_.cells[k] * (grid_.high[k] - grid_.low[k]);
    }
    if (grid_.parameters.size() > 2) {
      q[at(grid_.parameters[2])] = grid_.layers[static_cast<std::size_t>(rows / grid_.cells[1])];
    }
    for (std::size_t i = 0; i < q.size(); ++i) {
      const SceneParameter& p = robot_.parameters[i];
      if (p.derived) q[i] = p.rule.value({q, {}, robot_.starts});
    }
    return q;
  }

  bool is_free(long cell) {
    const std::vector<double> q = configuration(cell);
    const Leg there{record_.time, record_.time, q, {}, load_, -1, record_.line};
    // What of the robot is elsewhere there than where the search began.
    const Leg way{record_.time, record_.time, grid_.at, q, load_, -1, record_.line};
    const LegFrames frames(*machine_.mechanism, there);
    const LegFrames way_frames(*machine_.mechanism, way);
    std::vector<RobotPart> parts = machine_.bodies;
    if (load_ >= 0) add_load(parts);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const bool is_load = i >= machine_.bodies.size();
      if (LegPart(way_frames, parts[i]).state(0, 1).reach.most() > 0 &&
          !is_clear(cell, frames, parts[i], is_load)) {
        return false;
      }
    }
    for (const auto& [first, second] : machine_.own_pairs) {
      if (!is_clear(cell, frames, way_frames, parts[at(first)], parts[at(second)])) return false;
    }
    return true;
  }

  void add_load(std::vector<RobotPart>& parts) const {
    const Hanging& load = track_.loads[at(load_)];
    const auto& solid = load.component < 0 ? site_.carry : site_.components[at(load.component)];
    if (!solid) return;
    parts.push_back({solid.get(), machine_.mechanism->tool(), load.X_TO,
                     load.component < 0 ? "load" : trace_.scene.components[at(load.component)].name,
                     nullptr});
  }

  bool stands_then(const Obstacle& obstacle) const {
    const bool from_before = obstacle.from < record_.time || obstacle.from <= 0;
    return from_before && obstacle.to > record_.time;
  }

  /// What the task lets bodies enter is left out.
  bool may_be_entered(const Obstacle& obstacle) const {
    if (obstacle.component < 0 || run_.task < 0) return false;
    const auto& entered = trace_.scene.tasks[at(run_.task)].entered;
    return std::any_of(entered.begin(), entered.end(),
                       [&](const auto& pair) { return pair.second == obstacle.component; });
  }

  bool is_clear(long cell, const LegFrames& frames, const RobotPart& part, bool is_load) {
    const LegPart motion(frames, part);
    const PartState state = motion.state(0, 1);
    const Solid& solid = state.solid ? *state.solid : *part.solid;
    const Bounds box = solid.bounds.placed(state.X_WS).grown(kBoundsMargin);
    const int hung = load_ < 0 ? -1 : track_.loads[at(load_)].component;
    for (const Obstacle& obstacle : site_.obstacles) {
      if (!stands_then(obstacle) || obstacle.exempt == run_.robot || may_be_entered(obstacle)) {
        continue;
      }
      if ((hung >= 0 && obstacle.component == hung) || (obstacle.for_loads && !is_load)) continue;
      if (!box.meets(obstacle.solid->bounds.placed(obstacle.X_WS))) continue;
      const auto contact = PairSweep(*part.solid, motion, *obstacle.solid,
                                     StandingPart(obstacle.X_WS), trace_.scene.contact)
                               .run();
      if (contact) return told_free(cell, part.name, obstacle.name, *contact);
    }
    return true;
  }

  bool is_clear(long cell, const LegFrames& frames, const LegFrames& way_frames, const RobotPart& a,
                const RobotPart& b) {
    int base = machine_.mechanism->common_frame(a.frame, b.frame);
    for (const RobotPart* part : {&a, &b}) {
      if (part->rope != nullptr) base = machine_.mechanism->common_frame(base, part->rope->from);
    }
    const Reach between = LegPart(way_frames, a, base).state(0, 1).reach +
                          LegPart(way_frames, b, base).state(0, 1).reach;
    if (!(between.most() > 0)) return true;
    const auto contact = PairSweep(*a.solid, LegPart(frames, a, base), *b.solid,
                                   LegPart(frames, b, base), trace_.scene.contact)
                             .run();
    return !contact || told_free(cell, a.name, b.name, *contact);
  }

  /// That two cannot be told apart says nothing of a cell.
  bool told_free(long cell, const std::string& moved, const std::string& met,
                 const Contact& contact) {
    if (!(contact.depth > 0)) return true;
    return fault(FaultKind::contact,
                 fmt::format("cell {} of what is forbidden is told as free, and {} meets {} there "
                             "(at least {:.1f} mm deep)",
                             cell + 1, moved, met, contact.depth * 1000));
  }

  const Trace& trace_;
  const TaskRun& run_;
  const RobotTrack& track_;
  const SiteParts& site_;
  const Record& record_;
  const Forbidden& grid_;
  Faults& faults_;
  const SceneRobot& robot_;
  const RobotParts& machine_;
  int load_ = -1;  ///< index into the loads of the track
};

}  // namespace

void check_forbidden(const Trace& trace, const std::vector<TaskRun>& runs,
                     const std::vector<RobotTrack>& tracks, const SiteParts& site, Faults& faults) {
  for (const TaskRun& run : runs) {
    if (!run.happened || run.robot < 0) continue;
    for (const int index : run.records) {
      const Record& record = trace.records[at(index)];
      if (!std::holds_alternative<Forbidden>(record.what)) continue;
      ForbiddenCheck(trace, run, tracks[at(run.robot)], site, record, faults).check();
    }
  }
}

}  // namespace rubicon::verify
