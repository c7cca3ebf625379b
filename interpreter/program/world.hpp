#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "src/motion/guides/space.hpp"
#include "src/simulation/schedule/ticks.hpp"

namespace rubicon::interpreter {

/// Simulated time in integer ticks of 1 ns; every duration is rounded once.
using schedule::kTicksPerSecond;
using schedule::seconds_from_ticks;
using schedule::Ticks;
using schedule::ticks_from_seconds;

/// One proposed motion step of one robot: every changed parameter runs linearly from q_from to q_to
/// (file units; cyclic angles unwrapped, so |q_to - q_from| is what the step turns), all at once.
struct MotionStep {
  std::span<const double> q_from;
  std::span<const double> q_to;
  Ticks start = 0;
  Ticks duration = 0;
  std::span<const double> q_goal = {};  ///< where the machine will stand next; empty: not told
  std::span<const double> q_aim = {};   ///< where it goes now: the goal, or a guide's waypoint
};

/// Who is in the way: what moved (robot.body, or the load by its component's name) and what it met.
struct HitPair {
  std::string moved;
  std::string met;
  int machine = -1;    ///< index of the machine that was met; -1 for a part that it never moves
  int zone_task = -1;  ///< task whose zone was met
  int moving = -1;     ///< index of the thing with a timetable that was met
  /// Nothing was touched: the machine has its turn before the other at `met`, a node; `moved` is
  /// "is at" or "goes first at".
  bool turn = false;

  /// Whether what was met may go out of the way.
  bool may_leave() const { return machine >= 0 || zone_task >= 0 || moving >= 0; }
};

/// What a look along a leg found: shares of it, between which nothing is known.
struct LegLook {
  double free_until = 0;  ///< proved free up to here
  /// All longer parts of the leg would be refused; infinite: nothing is known to be met.
  double met_from = std::numeric_limits<double>::infinity();
  std::optional<HitPair> pair = {};  ///< that is met there, where it was seen
};

/// What another machine that goes first is foreseen to sweep (docs/earthwork.md, looking ahead).
struct ForeseenWay {
  std::string machine;
  double seconds = 0;         ///< so far ahead
  std::vector<double> q_aim;  ///< where it goes now
  /// In the plan view (m): convex, counter-clockwise, x and y in turn.
  std::vector<std::vector<double>> outlines;
};

/// What the machine knows of the site: it accepts or refuses steps and says who is in the way.
/// Owned by the interpreter, implemented by the site; the machine never sees geometry.
class World {
 public:
  virtual ~World() = default;

  /// Makes the step if its whole swept volume is free; otherwise nothing changes and the pair is
  /// returned.
  virtual std::optional<HitPair> propose(const MotionStep& step) = 0;

  /// The pair for which `propose` would refuse the step now, from wherever it begins; nothing
  /// changes.
  virtual std::optional<HitPair> refusal(const MotionStep& step) const = 0;
  bool would_accept(const MotionStep& step) const { return !refusal(step); }

  /// How far a straight leg of the robot is free, for guides: sooner answered than by `refusal`,
  /// which says the same. `whole`: only whether the whole leg is. Else the longest of its parts
  /// 1, 1/2, 1/4 ... that is free is wanted, and none shorter than `least` of it.
  virtual LegLook look_along(std::span<const double>, std::span<const double>, bool whole,
                             double least) const {
    static_cast<void>(whole);
    static_cast<void>(least);
    return {};
  }

  /// How far (m) the robot, standing at q, could be pushed along the horizontal heading (degrees,
  /// world) before a step would be refused; at most `range`.
  virtual double free_distance(std::span<const double> q, double heading_deg,
                               double range) const = 0;

  /// Whether what it would meet there first moves now: a machine in a step, or a thing with a
  /// timetable on its way. False: nothing within `range`, or it stands.
  virtual bool is_met_moving(std::span<const double>, double, double) const { return false; }

  /// The pair that overlaps where the robot stands at q, if any.
  virtual std::optional<HitPair> blocked_at(std::span<const double> q) const = 0;

  /// Changes whenever anything but this robot's own steps changed what would be accepted.
  virtual std::uint64_t version() const = 0;

  /// What others are foreseen to sweep of which the straight way would meet any.
  virtual std::vector<ForeseenWay> foreseen(std::span<const double>, std::span<const double>) {
    return {};
  }
  /// From now on `refusal` of steps without a duration and `blocked_at` keep out of what was
  /// foreseen last; or no more.
  virtual void keep_out_of_foreseen(bool) {}

  /// All that is on the site but the robot, as it stands now, for guides that go by the plan
  /// view.
  virtual std::vector<guides::Thing> things() const { return {}; }

  /// What comes nearest within `range` (m) to what the robot can move, standing at q, for guides
  /// that keep away from it.
  virtual guides::Nearness nearest(std::span<const double>, double,
                                   const guides::PairsLeftOut&) const {
    return {std::numeric_limits<double>::infinity(), {}, {}};
  }

  /// The next node for a vehicle of a fleet; nothing changes for one that is in none. `before`:
  /// who has to leave it first, where it waits.
  virtual guides::LaneAnswer next_node(const guides::LaneQuestion&, std::optional<HitPair>& before);

  /// Whether a situation is on by itself now (such as `safety`), besides those given to the
  /// motion, for the robot that stands at q on its way to `q_goal`.
  virtual bool situation(const std::string& name, std::span<const double> q,
                         std::span<const double> q_goal) const = 0;

  /// Whether an object is attached to the tool (loaded speeds, situation `transport` in the full
  /// form).
  virtual bool loaded() const = 0;
};

inline guides::LaneAnswer World::next_node(const guides::LaneQuestion&, std::optional<HitPair>&) {
  guides::LaneAnswer answer;
  answer.reason = "it drives on no network";
  return answer;
}

}  // namespace rubicon::interpreter
