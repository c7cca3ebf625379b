#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/program/world.hpp"
#include "interpreter/syntax/source.hpp"
#include "src/motion/guides/forbidden_grid.hpp"
#include "src/motion/guides/guide.hpp"

namespace rubicon::interpreter {

enum class LoopKind { chain, cycle, first };
const char* name_of(LoopKind kind);

/// Why an attempt made no step.
enum class Refusal { none, at_goal, no_direction, limit, hit };

/// One attempt of a command, accepted or refused.
struct Attempt {
  int n = 0;                                ///< from 1 per task
  const char* command = "";                 ///< move_to, move_dir, together or follow
  std::span<const std::string> parameters;  ///< display names; one but for together and follow
  Span span;                                ///< the command
  bool accepted = false;
  Refusal refusal = Refusal::none;
  std::string limit;  ///< display name of the parameter at its limit
  const HitPair* hit = nullptr;
  std::span<const double> steps;  ///< of a hit: how far each of `parameters` was to go, file units
  Ticks time = 0;                 ///< after the step; unchanged when refused
  std::span<const double> q;      ///< after the step, file units, per parameter of the robot
};

/// A way that a guide has planned, or tried to.
struct GuidePlan {
  std::string_view name;
  std::string kind = {};
  double seed = 0;
  const guides::PlanReport* report = nullptr;
  std::string_view cause;           ///< of no way
  std::span<const HitPair> others;  ///< other machines and zones that were in the way
  Ticks time = 0;
  /// Where the robot may not stand about what was searched, for who tells of that: it takes many
  /// tests. Empty where the guide does not tell what it searched through.
  std::function<std::optional<guides::ForbiddenGrid>()> forbidden = {};
};

/// A guide thinks: its checks take time, in which the robot stands.
struct Thinking {
  std::size_t checks = 0;
  Ticks time = 0;  ///< when it is over
};

/// Receives what a machine does, as it happens.
class EventSink {
 public:
  virtual ~EventSink() = default;
  virtual void goal(int k, int n) = 0;  ///< waypoint k of n begins
  /// The way to the next waypoint meets what another machine is foreseen to sweep.
  virtual void foreseen(const ForeseenWay&, Ticks) {}
  /// A guide planned a way for the goal that has begun, or found none.
  virtual void guide(const GuidePlan& plan) = 0;
  /// What it planned took time.
  virtual void think(const Thinking&) {}
  /// The script begins at waypoint k of the n that its guide has for the goal.
  virtual void way_point(int k, int n) = 0;
  virtual void set(const std::string& variable, double value, Span span) = 0;
  virtual void enter(LoopKind kind, Span span) = 0;
  virtual void exit(LoopKind kind, Span span, bool reached, int successes) = 0;
  virtual void which(const std::string& label,
                     Span span) = 0;  ///< the label that held; "when" for a condition
  virtual void attempt(const Attempt& attempt) = 0;
  virtual void wait(int n, Ticks time, Span span) = 0;  ///< time after the wait
  /// The machine has come to a stop: what was left of its run is charged up to `time`.
  virtual void stop(Ticks time) = 0;
};

/// The reason of a refusal as traces write it: "", "at goal", "no direction", "limit P", "hit".
std::string reason_text(const Attempt& attempt);

}  // namespace rubicon::interpreter
