#include "src/results/verify/replay/check_guides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/motion/math/turns.hpp"
#include "src/results/verify/replay/step_rules.hpp"

namespace rubicon::verify {

namespace {

using math::at;

class GuideCheck {
 public:
  GuideCheck(const Trace& trace, const TaskRun& run, Faults& faults)
      : trace_(trace), run_(run), faults_(faults), robot_(trace.scene.robots[at(run.robot)]) {}

  void check() {
    for (const int index : run_.records) {
      record_ = &trace_.records[at(index)];
      if (const auto* plan = std::get_if<GuidePlan>(&record_->what)) {
        begin(*plan);
      } else if (const auto* point = std::get_if<WayPoint>(&record_->what)) {
        begin(*point);
      } else if (const auto* attempt = std::get_if<Try>(&record_->what)) {
        if (attempt->ok && attempt->follows) follow(*attempt);
        q_ = attempt->q;
      } else if (const auto* end = std::get_if<MotionEnd>(&record_->what)) {
        finish(*end);
      } else if (std::holds_alternative<Goal>(record_->what)) {
        way_.clear();
        next_ = 0;
      }
    }
  }

 private:
  void fault(FaultKind kind, std::string text) {
    faults_.push_back({kind, ResultFile::trace, record_->line, trace_.runs[at(run_.run)],
                       record_->time, std::move(text)});
  }

  double off(std::size_t i, double from, double to) const {
    return robot_.parameters[i].cyclic ? math::normalised_deg(to - from) : to - from;
  }

  void begin(const GuidePlan& plan) {
    way_ = plan.way;
    next_ = 0;
    check_kept(plan);
    // Where the robot stands then is judged with its track.
    if (!way_.empty()) q_ = way_.front();
  }

  /// Sums that are kept at both ends of a straight leg are kept all along it.
  void check_kept(const GuidePlan& plan) {
    if (run_.task < 0) return;
    const SceneGuides& guides = trace_.scene.tasks[at(run_.task)].guides;
    const auto guide = guides.find(plan.name);
    if (guide == guides.end()) return;
    for (std::size_t k = 0; k < plan.way.size(); ++k) {
      for (const SceneKept& kept : guide->second) {
        double sum = 0;
        double slack = kValueSlack;
        for (const auto& [parameter, factor] : kept.terms) {
          sum += factor * plan.way[k][at(parameter)];
          slack += std::fabs(factor) * kValueSlack;
        }
        if (sum <= kept.most + slack) continue;
        fault(FaultKind::motion,
              fmt::format("waypoint {} of {} does not keep what the guide has to: {:g} is more "
                          "than {:g}",
                          k, plan.way.size() - 1, sum, kept.most));
        return;
      }
    }
  }

  void begin(const WayPoint& point) {
    ++next_;
    const auto count = static_cast<int>(way_.size()) - 1;
    if (point.k == next_ && point.n == count && point.k <= point.n) return;
    fault(FaultKind::order, fmt::format("waypoint {} of {} of the guide begins where {} of {} was "
                                        "expected",
                                        point.k, point.n, next_, std::max(count, 0)));
    way_.clear();
  }

  /// Whether a step of the parameter changes it by that step, and no other, wherever the robot
  /// stands.
  bool is_plain(int parameter) const {
    constexpr double kElsewhere = 37.3;
    for (const double shift : {0.0, kElsewhere}) {
      std::vector<double> q = q_;
      for (double& value : q) value += shift;
      std::vector<double> steps(q.size(), 0.0);
      steps[at(parameter)] = 1;
      for (std::size_t i = 0; i < q.size(); ++i) {
        const SceneParameter& p = robot_.parameters[i];
        if (p.derived || p.body != robot_.parameters[at(parameter)].body) continue;
        const double there = q[i] + (i == at(parameter) ? 1 : 0);
        if (std::fabs(p.rule.value({q, steps, robot_.starts}) - there) > kValueSlack) return false;
      }
    }
    return true;
  }

  /// A vehicle turns, drives and turns: its steps are held to its rules only.
  bool is_vehicle(const std::vector<int>& moved) const {
    return !std::all_of(moved.begin(), moved.end(), [&](int p) { return is_plain(p); });
  }

  void follow(const Try& attempt) {
    if (way_.empty() || next_ < 1 || next_ >= static_cast<int>(way_.size()) || q_.empty()) return;
    if (is_vehicle(attempt.moved)) return;
    const std::vector<double>& target = way_[at(next_)];
    double share = -1;
    for (const int moved : attempt.moved) {
      const std::size_t i = at(moved);
      // Of an angle that has a range any turn of the waypoint may be meant.
      const double left = off(i, q_[i], target[i]);
      const double made = off(i, q_[i], attempt.q[i]);
      const double slack = kValueSlack + kStepShare * robot_.parameters[i].step;
      if (std::fabs(left) <= slack) {
        if (std::fabs(made) <= slack) continue;
        return stray(i);
      }
      const double part = made / left;
      const double spread = slack / std::fabs(left);
      if (part < -spread || part > 1 + spread) return stray(i);
      if (share >= 0 && std::fabs(part - share) > spread + spread_) return stray(i);
      if (share < 0) {
        share = part;
        spread_ = spread;
      }
    }
  }

  void stray(std::size_t parameter) {
    fault(FaultKind::motion, fmt::format("the step of follow takes {} off the way to waypoint {}",
                                         robot_.parameters[parameter].name, next_));
  }

  /// What is reached under a guide ends at the last of its waypoints.
  void finish(const MotionEnd& end) {
    if (!q_.empty()) q_ = end.q;
    const bool under_way = next_ >= 1 && next_ + 1 < static_cast<int>(way_.size());
    if (end.reached && under_way && !is_at(way_.back(), end.q)) {
      fault(FaultKind::order, fmt::format("the motion is done at waypoint {} of {} of its guide",
                                          next_, way_.size() - 1));
    }
    way_.clear();
    next_ = 0;
  }

  /// As far as steps go: what is allowed beside the goal is judged with the goal.
  bool is_at(const std::vector<double>& there, const std::vector<double>& q) const {
    for (std::size_t i = 0; i < q.size(); ++i) {
      if (robot_.parameters[i].step > 0 &&
          std::fabs(off(i, q[i], there[i])) > robot_.parameters[i].step) {
        return false;
      }
    }
    return true;
  }

  /// Part of its step by which a parameter is at a value (LANGUAGE 4).
  static constexpr double kStepShare = 2e-6;

  const Trace& trace_;
  const TaskRun& run_;
  Faults& faults_;
  const SceneRobot& robot_;
  std::vector<std::vector<double>> way_;
  int next_ = 0;  ///< the waypoint that has begun
  double spread_ = 0;
  std::vector<double> q_;  ///< once it is known
  const Record* record_ = nullptr;
};

}  // namespace

void check_guides(const Trace& trace, const TaskRun& run, Faults& faults) {
  if (run.happened && run.robot >= 0) GuideCheck(trace, run, faults).check();
}

}  // namespace rubicon::verify
