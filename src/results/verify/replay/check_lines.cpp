#include "src/results/verify/replay/check_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/motion/math/turns.hpp"
#include "src/results/verify/geometry/pose_miss.hpp"
#include "src/results/verify/input/mechanism.hpp"

namespace rubicon::verify {

namespace {

/// Moments of each step at which the tool is looked at.
constexpr int kMoments = 16;

/// Beside the deviation: rounding, and that the ends of steps are found to 1e-9 m and rad.
constexpr double kSlack = 1e-6;
constexpr double kSlack_deg = 1e-5;

/// A way shorter than that (m) has no direction.
constexpr double kNoWay = 1e-6;

using math::at;

class LineCheck {
 public:
  LineCheck(const Trace& trace, const TaskRun& run, Faults& faults)
      : trace_(trace),
        run_(run),
        faults_(faults),
        robot_(trace.scene.robots[at(run.robot)]),
        task_(run.task < 0 ? nullptr : &trace.scene.tasks[at(run.task)]),
        mechanism_(robot_) {}

  void check() {
    for (const int index : run_.records) {
      const Record& record = trace_.records[at(index)];
      if (const auto* attempt = std::get_if<Try>(&record.what)) {
        if (attempt->ok) step(*attempt, record);
        q_ = attempt->q;
      } else if (const auto* end = std::get_if<MotionEnd>(&record.what)) {
        judge();
        q_ = end->q;
      } else if (const auto* plan = std::get_if<GuidePlan>(&record.what)) {
        judge();
        if (!plan->way.empty()) q_ = plan->way.front();
      } else if (!std::holds_alternative<Wait>(record.what) &&
                 !std::holds_alternative<Stop>(record.what) &&
                 !std::holds_alternative<Think>(record.what) &&
                 !std::holds_alternative<Forbidden>(record.what) &&
                 !std::holds_alternative<Pause>(record.what)) {
        judge();
      }
    }
    judge();
  }

 private:
  void fault(const Record& record, std::string text) {
    faults_.push_back({FaultKind::motion, ResultFile::trace, record.line, trace_.runs[at(run_.run)],
                       record.time, std::move(text)});
  }

  void step(const Try& attempt, const Record& record) {
    if (q_.empty()) return;  // the first step of a trace; where it began is judged with its track
    if (task_ != nullptr) {
      for (const int locked : task_->locked) {
        if (attempt.q[at(locked)] == q_[at(locked)]) continue;
        fault(record, fmt::format("a step changes {}, which is locked",
                                  robot_.parameters[at(locked)].name));
      }
    }
    if (!attempt.lines) return judge();
    if (way_.empty()) way_.push_back({q_, &record});
    way_.push_back({attempt.q, &record});
  }

  Pose tool(std::vector<double> q) const {
    for (std::size_t i = 0; i < q.size(); ++i) {
      if (robot_.parameters[i].derived) {
        q[i] = robot_.parameters[i].rule.value(FormulaValues{q, {}, robot_.starts});
      }
    }
    return mechanism_.pose(mechanism_.tool(), q);
  }

  /// The steps of `line` since anything else happened are one straight way.
  void judge() {
    const auto way = std::exchange(way_, {});
    if (way.size() < 2) return;
    const SceneDeviation allowed =
        task_ != nullptr && task_->deviation ? *task_->deviation : robot_.deviation;
    const int free_axis = task_ != nullptr ? task_->free_axis : kNothingFree;
    const Pose first = tool(way.front().first);
    const Pose last = tool(way.back().first);
    const Vec3 along = last.translation() - first.translation();
    const double length = along.norm();
    const double turn = pose_miss(first, last, free_axis).turned_deg;
    for (std::size_t k = 0; k + 1 < way.size(); ++k) {
      for (int m = 1; m <= kMoments; ++m) {
        const Pose now = tool(between(way[k].first, way[k + 1].first, m));
        const Vec3 gone = now.translation() - first.translation();
        const double share =
            length > kNoWay ? std::clamp(gone.dot(along) / (length * length), 0.0, 1.0) : 0;
        const double off = (gone - share * along).norm();
        const double since = pose_miss(first, now, free_axis).turned_deg;
        const double left = pose_miss(now, last, free_axis).turned_deg;
        double turned = std::max(0.0, (since + left - turn) / 2);
        if (length > kNoWay) {
          turned = std::max(std::fabs(since - share * turn), std::fabs(left - (1 - share) * turn));
        }
        if (off <= allowed.position + kSlack && turned <= allowed.orientation + kSlack_deg) {
          continue;
        }
        fault(*way[k + 1].second,
              fmt::format("the tool is {:.1f} mm and {:.3f} degrees beside its straight way, of "
                          "{:g} mm and {:g} degrees that it may be",
                          off * 1000, turned, allowed.position * 1000, allowed.orientation));
        return;
      }
    }
  }

  std::vector<double> between(const std::vector<double>& from, const std::vector<double>& to,
                              int moment) const {
    const double share = static_cast<double>(moment) / kMoments;
    std::vector<double> q = from;
    for (std::size_t i = 0; i < q.size(); ++i) {
      const double off =
          robot_.parameters[i].cyclic ? math::normalised_deg(to[i] - from[i]) : to[i] - from[i];
      q[i] += share * off;
    }
    return q;
  }

  const Trace& trace_;
  const TaskRun& run_;
  Faults& faults_;
  const SceneRobot& robot_;
  const SceneTask* const task_;
  const Mechanism mechanism_;
  std::vector<double> q_;                                           ///< once it is known
  std::vector<std::pair<std::vector<double>, const Record*>> way_;  ///< under way
};

}  // namespace

void check_lines(const Trace& trace, const TaskRun& run, Faults& faults) {
  if (run.happened && run.robot >= 0) LineCheck(trace, run, faults).check();
}

}  // namespace rubicon::verify
