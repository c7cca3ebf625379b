#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/machine/machine.hpp"
#include "tests/support/memory_files.hpp"

namespace rubicon::test {

/// A world whose obstacles are a predicate on the configuration a step leads to.
class PredicateWorld : public interpreter::World {
 public:
  std::function<bool(std::span<const double>)> blocked = [](std::span<const double>) {
    return false;
  };
  std::vector<std::string> situations;
  bool is_loaded = false;
  std::uint64_t changes = 0;

  std::optional<interpreter::HitPair> propose(const interpreter::MotionStep& step) override {
    if (blocked(step.q_to)) return interpreter::HitPair{"robot.body", "wall"};
    return std::nullopt;
  }
  std::optional<interpreter::HitPair> refusal(const interpreter::MotionStep& step) const override {
    return blocked_at(step.q_to);
  }
  double free_distance(std::span<const double>, double, double range) const override {
    return range;
  }
  std::optional<interpreter::HitPair> blocked_at(std::span<const double> q) const override {
    if (blocked(q)) return interpreter::HitPair{"robot.body", "wall"};
    return std::nullopt;
  }
  std::uint64_t version() const override { return changes; }
  bool situation(const std::string& name, std::span<const double> /*q*/,
                 std::span<const double> /*q_goal*/) const override {
    for (const auto& one : situations) {
      if (one == name) return true;
    }
    return false;
  }
  bool loaded() const override { return is_loaded; }
};

/// Every event as one short line, as `expected.trace` writes it without columns.
class EventLog : public interpreter::EventSink {
 public:
  std::vector<std::string> lines;
  std::vector<double> seeds;  ///< of the ways that guides planned
  void goal(int k, int n) override;
  void guide(const interpreter::GuidePlan& plan) override;
  void way_point(int k, int n) override;
  void set(const std::string& variable, double value, interpreter::Span) override;
  void enter(interpreter::LoopKind kind, interpreter::Span) override;
  void exit(interpreter::LoopKind kind, interpreter::Span, bool reached, int successes) override;
  void which(const std::string& label, interpreter::Span) override;
  void attempt(const interpreter::Attempt& attempt) override;
  void wait(int n, interpreter::Ticks time, interpreter::Span) override;
  void stop(interpreter::Ticks time) override;
};

/// A robot and its script, compiled; texts that do not check are a failure of the test.
struct Scenario {
  std::shared_ptr<const interpreter::CheckedRobot> robot;
  std::unique_ptr<interpreter::Program> program;

  /// A motion from the robot's start values (overridden by `start`) to the named goal values.
  interpreter::MotionTask task(const std::vector<std::pair<std::string, double>>& start,
                               const std::vector<std::pair<std::string, double>>& goal) const;
};
Scenario set_up(const std::string& robot_text, const std::string& script);

/// Runs to the end and returns the end; `log` may be null.
interpreter::MotionEnd run(const Scenario& setup, interpreter::MotionTask task,
                           interpreter::World& world, interpreter::EventSink* log = nullptr);

/// A slider on two axes, steps of 1 m; the script is put in by set_up.
extern const char* const kGantry;

}  // namespace rubicon::test
