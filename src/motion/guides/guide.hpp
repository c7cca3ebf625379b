#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "src/motion/guides/guide_spec.hpp"
#include "src/motion/guides/space.hpp"
#include "src/motion/guides/way_metrics.hpp"

namespace rubicon::guides {

/// The task of a guide: where the robot stands, and the configurations that are its goal, of which
/// the first that it may stand at is taken. The robot must outlive the guide.
struct GuideTask {
  const robot::RobotModel* model = nullptr;
  robot::Mounting mounting;
  std::vector<std::vector<double>> goals;
  bool loaded = false;
  robot::GoalClauses clauses = {};  ///< what is locked stays on the way
};

/// What planning a way took and gave.
struct PlanReport {
  enum class Outcome : std::uint8_t {
    found,
    start_blocked,
    goal_blocked,
    start_not_kept,  ///< what shall hold on the whole way does not hold where it begins
    goal_not_kept,
    out_of_nodes,
    out_of_checks,
    not_certified,  ///< a way was found that `follow` could not make, or no first or last leg of
                    ///< one
    no_way          ///< and `cause` says why
  };
  Outcome outcome = Outcome::found;
  std::string cause;  ///< of no_way; of not_certified if it is known
  double seed = 0;    ///< with which it was planned
  std::size_t nodes = 0;
  std::size_t checks = 0;
  std::size_t refused = 0;
  std::vector<std::vector<double>> way;  ///< where it begins, its waypoints, the goal last
  WayMetrics metrics = {};
  std::vector<double> goal = {};  ///< the configuration that it shall lead to, once it is known
  /// Legs of what was grown, parent first; only where the spec asks for it.
  std::vector<std::pair<std::vector<double>, std::vector<double>>> tree = {};
  /// Of guides that travel without a map, in words: "hit at (4.28, 22.00) by ring, fence".
  std::vector<std::string> events = {};
  bool found() const { return outcome == Outcome::found; }
};

/// What a guide says when it is asked.
struct GuideAnswer {
  enum class Kind : std::uint8_t { way_point, gave_up };
  Kind kind = Kind::gave_up;
  std::vector<double> q;              ///< way_point: a whole configuration
  int k = 0;                          ///< way_point: which of its way, from 1
  int n = 0;                          ///< way_point: of so many; the last is the goal
  std::optional<PlanReport> planned;  ///< if it planned for this answer
  std::string reason;                 ///< gave_up: why

  bool leads_to_goal() const { return k == n; }
};

/// A source of waypoints for one goal of a motion. Its state is a value: `copy`. The script makes
/// the steps; the guide is asked when a waypoint is reached, and when the script ended short of
/// one.
class Guide {
 public:
  virtual ~Guide() = default;
  virtual std::unique_ptr<Guide> copy() const = 0;

  /// The first waypoint for a robot that stands at q.
  virtual GuideAnswer begin(std::span<const double> q, MotionTests& tests) = 0;
  /// The waypoint was reached and is not the last: the next one.
  virtual GuideAnswer reached(std::span<const double> q, MotionTests& tests) = 0;
  /// The script ended short of the waypoint, at q: another one, or no more.
  virtual GuideAnswer ended_short(std::span<const double> q, MotionTests& tests) = 0;
};

std::unique_ptr<Guide> make_guide(const GuideSpec& spec, GuideTask task);

/// Plans a way once: what `make_guide` does, without a script.
PlanReport plan_way(const GuideSpec& spec, const GuideTask& task, std::span<const double> q,
                    MotionTests& tests);

/// Whether a way that was planned before is free now, step by step: from where the robot stands
/// over the points of the way behind the first.
bool way_is_free(const GuideSpec& spec, const GuideTask& task, std::span<const double> q,
                 const std::vector<std::vector<double>>& way, MotionTests& tests);

/// A guide that is copied with what it is a part of.
class GuideValue {
 public:
  GuideValue() = default;
  explicit GuideValue(std::unique_ptr<Guide> guide) : guide_(std::move(guide)) {}
  GuideValue(const GuideValue& other) : guide_(other.guide_ ? other.guide_->copy() : nullptr) {}
  GuideValue(GuideValue&&) noexcept = default;
  GuideValue& operator=(const GuideValue& other) {
    if (this != &other) guide_ = other.guide_ ? other.guide_->copy() : nullptr;
    return *this;
  }
  GuideValue& operator=(GuideValue&&) noexcept = default;
  ~GuideValue() = default;

  explicit operator bool() const { return guide_ != nullptr; }
  Guide* operator->() const { return guide_.get(); }
  void reset() { guide_.reset(); }

 private:
  std::unique_ptr<Guide> guide_;
};

}  // namespace rubicon::guides
