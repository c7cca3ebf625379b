#include "src/results/verify/replay/check_guides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/index.hpp"
#include "src/motion/math/turns.hpp"
#include "src/results/verify/replay/step_rules.hpp"
#include "src/results/verify/replay/vehicle_rules.hpp"
#include "src/results/verify/replay/way_figures.hpp"

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
      if (!std::holds_alternative<Think>(record_->what) &&
          !std::holds_alternative<Stop>(record_->what) &&
          !std::holds_alternative<Forbidden>(record_->what)) {
        expect_thought();
      }
      if (const auto* plan = std::get_if<GuidePlan>(&record_->what)) {
        begin(*plan);
      } else if (std::holds_alternative<Foreseen>(record_->what)) {
        foreseen_ = record_->time;
      } else if (const auto* thought = std::get_if<Think>(&record_->what)) {
        follow(*thought);
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
      } else if (const auto* load = std::get_if<LoadChange>(&record_->what)) {
        hanging_ = load->kind == LoadChange::Kind::attach ||
                   (hanging_ && load->kind != LoadChange::Kind::detach);
      } else if (const auto* taken = std::get_if<SoilTaken>(&record_->what)) {
        soil_ = run_.task >= 0 && trace_.scene.tasks[at(run_.task)].haul && taken->volume > 0;
      }
      if (const auto* grid = std::get_if<Forbidden>(&record_->what)) check_place(*grid);
      told_ = std::get_if<GuidePlan>(&record_->what);
      before_ = record_->time;
    }
    expect_thought();
  }

 private:
  void fault(FaultKind kind, std::string text) {
    const int line = record_ != nullptr ? record_->line : run_.end_line;
    const Ticks time = record_ != nullptr ? record_->time : run_.end;
    faults_.push_back(
        {kind, ResultFile::trace, line, trace_.runs[at(run_.run)], time, std::move(text)});
  }

  /// What is forbidden is told right behind a search, of where the robot stands then.
  void check_place(const Forbidden& grid) {
    if (told_ == nullptr || told_->graph.empty() || record_->time != before_) {
      fault(FaultKind::order, "what is forbidden is told without a search right before it");
      return;
    }
    for (std::size_t i = 0; i < q_.size(); ++i) {
      if (std::fabs(off(i, q_[i], grid.at[i])) <= kValueSlack) continue;
      fault(FaultKind::motion, fmt::format("what is forbidden is told with {} at {:g} where the "
                                           "search began at {:g}",
                                           robot_.parameters[i].name, grid.at[i], q_[i]));
      return;
    }
  }

  double off(std::size_t i, double from, double to) const {
    return robot_.parameters[i].cyclic ? math::normalised_deg(to - from) : to - from;
  }

  void begin(const GuidePlan& plan) {
    // Where no way round what is foreseen was found, all goes on as it was.
    if (!plan.way.empty() || record_->time != foreseen_) {
      way_ = plan.way;
      next_ = 0;
    }
    check_kept(plan);
    check_steering(plan);
    check_graph(plan);
    check_figures(plan);
    const SceneGuide* const guide = guide_of(plan);
    thinks_ = guide != nullptr ? guide->thinks : 0;
    if (thinks_ > 0) checks_ = plan.checks;
    // Where the robot stands then is judged with its track.
    if (!way_.empty()) q_ = way_.front();
  }

  const SceneGuide* guide_of(const GuidePlan& plan) const {
    if (run_.task < 0) return nullptr;
    const SceneGuides& guides = trace_.scene.tasks[at(run_.task)].guides;
    const auto guide = guides.find(plan.name);
    return guide == guides.end() ? nullptr : &guide->second;
  }

  static Ticks ticks_of(double seconds) {
    return static_cast<Ticks>(std::llround(seconds * static_cast<double>(kSecond)));
  }

  /// What a plan takes is thought before anything else happens; less than half a tick is nothing.
  void expect_thought() {
    if (checks_ > 0 && ticks_of(thinks_ * checks_) > 0) {
      fault(FaultKind::clock, "its guide planned, and did not think");
    }
    checks_ = 0;
  }

  void follow(const Think& thought) {
    const Ticks expected = ticks_of(thinks_ * checks_);
    if (checks_ == 0 || thought.checks != checks_) {
      fault(FaultKind::order, fmt::format("its guide thinks about {} checks where it planned {}",
                                          thought.checks, checks_));
    } else if (std::llabs(record_->time - before_ - expected) > kTimeSlack) {
      fault(FaultKind::clock,
            fmt::format("{} checks take {:g} s of thinking instead of {:g} s", checks_,
                        static_cast<double>(record_->time - before_) / kSecond,
                        static_cast<double>(expected) / kSecond));
    }
    checks_ = 0;
  }

  /// A vehicle that steers: where it is displaced from one point of its way to the next it lies in
  /// the direction of the mean heading, forwards or backwards, and turns no more than its radius
  /// allows for that. Which parameters those are the way itself tells: an angle, and the two that
  /// driving changes.
  void check_steering(const GuidePlan& plan) {
    const SceneGuide* const guide = guide_of(plan);
    if (guide == nullptr || !(guide->turn_radius > 0)) return;
    const auto vehicle = find_vehicle(robot_);
    if (!vehicle) return;
    constexpr double kOnChord = 1e-6;  // m
    for (std::size_t k = 1; k < plan.way.size(); ++k) {
      const std::vector<double>& from = plan.way[k - 1];
      const std::vector<double>& to = plan.way[k];
      const double dx = to[vehicle->x] - from[vehicle->x];
      const double dy = to[vehicle->y] - from[vehicle->y];
      const double turned = math::normalised_deg(to[vehicle->heading] - from[vehicle->heading]);
      const double mean = from[vehicle->heading] + turned / 2 + vehicle->drift_deg;
      const double beside = dx * math::sin_deg(mean) - dy * math::cos_deg(mean);
      const double chord = std::sqrt(dx * dx + dy * dy);
      const double least = 2 * guide->turn_radius * std::fabs(math::sin_deg(turned / 2));
      if (std::fabs(beside) <= kOnChord && chord + kOnChord >= least) continue;
      fault(
          FaultKind::motion,
          fmt::format("from waypoint {} to {} of its way it turns by {:g} degrees on {:g} m, {:g} "
                      "m beside its heading: narrower than its radius of {:g} m",
                      k - 1, k, turned, chord, std::fabs(beside), guide->turn_radius));
      return;
    }
  }

  /// Sums that are kept at both ends of a straight leg are kept all along it.
  void check_kept(const GuidePlan& plan) {
    const SceneGuide* const guide = guide_of(plan);
    if (guide == nullptr) return;
    for (std::size_t k = 0; k < plan.way.size(); ++k) {
      for (const SceneKept& kept : guide->keep) {
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

  /// What is told of the way, reckoned again from its points.
  void check_figures(const GuidePlan& plan) {
    if (plan.way.empty()) return;
    const SceneGuide* const guide = guide_of(plan);
    const WayFigures own =
        way_figures(robot_, plan.way, hanging_ || soil_, guide != nullptr ? guide->turn_radius : 0);
    const auto expect = [&](const char* what, const char* unit, double told,
                            const WayFigure& found) {
      if (found.fits(told)) return;
      fault(FaultKind::motion, fmt::format("the {} of the guide's way is told as {:.9g}{} and is "
                                           "{:.9g}{}",
                                           what, told, unit, found.value, unit));
    };
    expect("roughness", "", plan.roughness, own.roughness);
    expect("length", " m", plan.length, own.length);
    expect("motion time", " s", plan.motion_time, own.motion_time);
  }

  /// What it searched through are configurations that the robot can have.
  void check_graph(const GuidePlan& plan) {
    for (std::size_t k = 0; k < plan.graph.size(); ++k) {
      for (std::size_t i = 0; i < robot_.parameters.size(); ++i) {
        const SceneParameter& p = robot_.parameters[i];
        const double value = plan.graph[k][i];
        if (p.derived || p.cyclic) continue;
        if (value >= p.lower.value_or(value) - kValueSlack &&
            value <= p.upper.value_or(value) + kValueSlack) {
          continue;
        }
        fault(FaultKind::motion, fmt::format("leg {} of what the guide searched leads past the "
                                             "limits of {}: {:g}",
                                             k / 2 + 1, p.name, value));
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
  int next_ = 0;                     ///< the waypoint that has begun
  Ticks foreseen_ = -1;              ///< when its way met what others are foreseen to sweep last
  double thinks_ = 0;                ///< s for each check, of the guide that planned last
  int checks_ = 0;                   ///< that it has not thought about yet
  const GuidePlan* told_ = nullptr;  ///< the record before this one, if it is a plan
  Ticks before_ = 0;                 ///< when the record before this one was over
  double spread_ = 0;
  bool hanging_ = false;   ///< a load on its tool
  bool soil_ = false;      ///< a truck with soil
  std::vector<double> q_;  ///< once it is known
  const Record* record_ = nullptr;
};

}  // namespace

void check_guides(const Trace& trace, const TaskRun& run, Faults& faults) {
  if (run.happened && run.robot >= 0) GuideCheck(trace, run, faults).check();
}

}  // namespace rubicon::verify
