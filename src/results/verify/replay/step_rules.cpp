#include "src/results/verify/replay/step_rules.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "src/motion/math/index.hpp"
#include "src/motion/math/turns.hpp"

namespace rubicon::verify {

namespace {

/// Share of its step by which a step may be too long and a value out of its range (LANGUAGE 4).
constexpr double kStepShare = 1e-6;

constexpr int kNewtonRounds = 8;

using math::at;

/// All rules of a robot at once: the values after steps of some parameters.
std::vector<double> apply_rules(const SceneRobot& robot, std::span<const double> before,
                                std::span<const double> steps) {
  const FormulaValues old{before, steps, robot.starts};
  std::vector<double> after(before.begin(), before.end());
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (!robot.parameters[i].derived) after[i] = robot.parameters[i].rule.value(old);
  }
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (!robot.parameters[i].derived) continue;
    const FormulaValues values{after, {}, robot.starts};
    after[i] = robot.parameters[i].rule.value(values);
    // A cyclic one runs on from where it is, with the whole turns that the record leaves out.
    if (robot.parameters[i].cyclic) {
      const double off = before[i] - robot.parameters[i].rule.value({before, {}, robot.starts});
      after[i] += 360 * std::floor(off / 360 + 0.5);
    }
  }
  return after;
}

/// after - reached; of an angle that turns freely without whole turns.
double difference(const SceneParameter& parameter, double after, double reached) {
  const double off = after - reached;
  return parameter.cyclic ? math::normalised_deg(off) : off;
}

class StepSolver {
 public:
  StepSolver(const SceneRobot& robot, const StepQuery& query)
      : robot_(robot), query_(query), steps_(query.before.size(), 0.0) {}

  StepResult solve() {
    for (int round = 0; round < kNewtonRounds; ++round) {
      if (!improve()) break;
    }
    unwrap();
    result_.reached = apply_rules(robot_, query_.before, steps_);
    check_values();
    check_whole_turns();
    check_lengths();
    check_duration();
    return std::move(result_);
  }

 private:
  Eigen::VectorXd residual(const std::vector<double>& steps) const {
    const std::vector<double> reached = apply_rules(robot_, query_.before, steps);
    Eigen::VectorXd off(static_cast<Eigen::Index>(reached.size()));
    for (std::size_t i = 0; i < reached.size(); ++i) {
      off[static_cast<Eigen::Index>(i)] =
          difference(robot_.parameters[i], query_.after[i], reached[i]);
    }
    return off;
  }

  /// One round of Newton's method; false when there is nothing left to improve.
  bool improve() {
    const Eigen::VectorXd off = residual(steps_);
    if (!off.allFinite() || off.cwiseAbs().maxCoeff() <= kValueSlack / 100) return false;
    const auto count = static_cast<Eigen::Index>(query_.moved.size());
    Eigen::MatrixXd change(off.size(), count);
    const std::vector<double> here = apply_rules(robot_, query_.before, steps_);
    for (Eigen::Index j = 0; j < count; ++j) {
      const std::size_t p = at(query_.moved[static_cast<std::size_t>(j)]);
      const double h = robot_.parameters[p].step > 0 ? robot_.parameters[p].step : 1;
      std::vector<double> moved = steps_;
      moved[p] += h;
      const std::vector<double> there = apply_rules(robot_, query_.before, moved);
      for (std::size_t i = 0; i < there.size(); ++i) {
        change(static_cast<Eigen::Index>(i), j) = (there[i] - here[i]) / h;
      }
    }
    if (!change.allFinite()) return false;
    const Eigen::VectorXd more = change.colPivHouseholderQr().solve(off);
    for (Eigen::Index j = 0; j < count; ++j) {
      steps_[at(query_.moved[static_cast<std::size_t>(j)])] += more[j];
    }
    return true;
  }

  double speed(const SceneParameter& p) const { return query_.loaded ? p.loaded_speed : p.speed; }

  /// How far a parameter has gone in the run that goes on, if a step in this direction belongs to
  /// it.
  double gone(std::size_t p, double step) const {
    for (const RunPart& part : query_.run.parts) {
      if (at(part.parameter) == p && (part.gone > 0) == (step > 0)) return part.gone;
    }
    return 0;
  }

  RunTime time_of(std::size_t p, double step) const {
    return step_time(robot_.parameters[p], query_.loaded, gone(p, step), query_.run.steps, step);
  }

  /// A step of more than half a turn looks like one the other way round; its duration tells.
  void unwrap() {
    for (const int moved : query_.moved) {
      const SceneParameter& p = robot_.parameters[at(moved)];
      if (!p.cyclic || !(p.step > 180) || !(speed(p) > 0)) continue;
      const double step = steps_[at(moved)];
      const double other = step > 0 ? step - 360 : step + 360;
      const auto off = [&](double ds) {
        return std::llabs(time_of(at(moved), ds).time - query_.duration);
      };
      if (std::fabs(other) <= p.step && off(other) < off(step)) steps_[at(moved)] = other;
    }
  }

  void fault(std::string text) { result_.faults.push_back(std::move(text)); }

  void check_values() {
    for (std::size_t i = 0; i < result_.reached.size(); ++i) {
      const SceneParameter& p = robot_.parameters[i];
      const double off = difference(p, query_.after[i], result_.reached[i]);
      if (!(std::fabs(off) <= kValueSlack)) {
        fault(fmt::format("{} is {:g} after the step, its rule gives {:g} (it was {:g})", p.name,
                          query_.after[i], result_.reached[i], query_.before[i]));
        result_.reached[i] += std::isfinite(off) ? off : 0;
      } else if (p.derived) {
        check_derived(i);
      }
      const double slack = kStepShare * std::max(p.step, 1.0);
      const double value = query_.after[i];
      if (!p.cyclic &&
          ((p.lower && value < *p.lower - slack) || (p.upper && value > *p.upper + slack))) {
        fault(fmt::format("{} is out of its range at {:g}", p.name, value));
      }
    }
  }

  /// A derived value is what its formula gives of the values written beside it, not only of those
  /// that the step reached: without whole turns they may differ.
  void check_derived(std::size_t i) {
    const SceneParameter& p = robot_.parameters[i];
    const double value = p.rule.value({query_.after, {}, robot_.starts});
    if (std::fabs(difference(p, query_.after[i], value)) <= kValueSlack) return;
    fault(fmt::format("{} is {:g} after the step, the values beside it give {:g}", p.name,
                      query_.after[i], value));
  }

  /// A record gives cyclic angles without whole turns. No frame and no rule may mind that: they are
  /// at the values written what they are at those that the step reached.
  void check_whole_turns() {
    const std::vector<double>& reached = result_.reached;
    const FormulaValues now{reached, {}, robot_.starts};
    const FormulaValues written{query_.after, {}, robot_.starts};
    const bool turned = std::any_of(reached.begin(), reached.end(), [&](const double& value) {
      const auto i = static_cast<std::size_t>(&value - reached.data());
      return robot_.parameters[i].cyclic && std::fabs(query_.after[i] - value) > 180;
    });
    if (!turned) return;
    const auto differs = [&](const Formula& formula, bool angle) {
      const double off = formula.value(written) - formula.value(now);
      return !(std::fabs(angle ? math::normalised_deg(off) : off) <= kValueSlack);
    };
    const auto jumps = [&](const FrameElement& each) {
      return differs(each.a, each.kind != FrameElement::Kind::trans) || differs(each.b, false) ||
             differs(each.c, false);
    };
    const auto check_frame = [&](const std::vector<FrameElement>& frame, const std::string& name) {
      if (std::none_of(frame.begin(), frame.end(), jumps)) return;
      fault(fmt::format("a whole turn that the record leaves out moves the frame of {}", name));
    };
    for (const SceneBody& body : robot_.bodies) check_frame(body.frame, body.name);
    check_frame(robot_.tool_frame, "the tool");
    check_rules_alike(now, written);
  }

  /// The next step of any parameter does the same from the values written as from those reached.
  void check_rules_alike(const FormulaValues& now, const FormulaValues& written) {
    std::vector<double> steps(robot_.parameters.size(), 0.0);
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = robot_.parameters[i].step;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const SceneParameter& p = robot_.parameters[i];
      if (p.derived) continue;
      const double from_now = p.rule.value({now.values, steps, robot_.starts}) - now.values[i];
      const double from_written =
          p.rule.value({written.values, steps, robot_.starts}) - written.values[i];
      if (std::fabs(from_now - from_written) <= kValueSlack) continue;
      fault(fmt::format("a whole turn that the record leaves out changes the rule of {}", p.name));
    }
  }

  void check_lengths() {
    for (const int moved : query_.moved) {
      const SceneParameter& p = robot_.parameters[at(moved)];
      const double length = std::fabs(steps_[at(moved)]);
      if (p.step > 0 && length > p.step * (1 + kStepShare)) {
        fault(fmt::format("the step of {} is {:g}, the longest is {:g}", p.name, length, p.step));
      }
      if (!(p.step > 0)) fault(fmt::format("{} cannot be moved", p.name));
    }
  }

  /// The run that the step belongs to: the one that goes on, if the same moves the same way.
  void find_run() {
    MotionRun& run = result_.run;
    run.loaded = query_.loaded;
    std::vector<int> moved(query_.moved.begin(), query_.moved.end());
    std::sort(moved.begin(), moved.end());
    for (const int p : moved) {
      const double step = steps_[at(p)];
      if (std::fabs(step) > robot_.parameters[at(p)].step * kStepShare) {
        run.parts.push_back({p, step});
      }
    }
    if (run.parts.empty() && !moved.empty()) {
      // A turn of less than that was still a turn, if nothing else moved.
      const int most = *std::max_element(moved.begin(), moved.end(), [&](int a, int b) {
        return std::fabs(steps_[at(a)]) < std::fabs(steps_[at(b)]);
      });
      run.parts.push_back({most, steps_[at(most)]});
    }
    result_.goes_on = !run.parts.empty() && run.is_of_same_parts(query_.run);
    run.steps = 1;
    if (!result_.goes_on) return;
    for (std::size_t i = 0; i < run.parts.size(); ++i) {
      run.parts[i].gone += query_.run.parts[i].gone;
    }
    run.steps += query_.run.steps;
  }

  void check_duration() {
    find_run();
    RunTime longest{0, kTimeSlack};
    bool accelerates = false;
    for (const RunPart& part : result_.run.parts) {
      const std::size_t p = at(part.parameter);
      const double gone = result_.goes_on ? part.gone - steps_[p] : 0;
      const RunTime own = step_time(robot_.parameters[p], query_.loaded, gone,
                                    result_.goes_on ? query_.run.steps : 0, steps_[p]);
      if (own.time > longest.time) longest = own;
      accelerates = accelerates || robot_.parameters[p].acceleration > 0;
    }
    if (!accelerates) result_.run.parts.clear();
    if (query_.least > longest.time) longest = {query_.least, kTimeSlack};
    if (std::llabs(longest.time - query_.duration) <= longest.slack) return;
    const auto text = [](Ticks time) {
      return fmt::format("{:g} s", static_cast<double>(time) / static_cast<double>(kSecond));
    };
    fault(
        fmt::format("the step lasts {} instead of {}", text(query_.duration), text(longest.time)));
  }

  const SceneRobot& robot_;
  const StepQuery& query_;
  std::vector<double> steps_;
  StepResult result_;
};

}  // namespace

StepResult check_step(const SceneRobot& robot, const StepQuery& query) {
  return StepSolver(robot, query).solve();
}

std::vector<double> start_values(const SceneRobot& robot) {
  std::vector<double> values = robot.starts;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!robot.parameters[i].derived) continue;
    values[i] = robot.parameters[i].rule.value({values, {}, robot.starts});
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (robot.parameters[i].cyclic) values[i] = math::normalised_deg(values[i]);
  }
  return values;
}

}  // namespace rubicon::verify
