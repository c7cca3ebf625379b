#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "src/motion/guides/guide_spec.hpp"
#include "src/motion/guides/leg.hpp"
#include "src/motion/math/random.hpp"

namespace rubicon::guides {

using math::exp_of;
using math::log_of;
using math::Random;

/// Something that stands on the site: shapes (m) in a frame of their own, which must outlive it.
struct Thing {
  std::string name;
  const std::vector<geometry::Shape>* shapes = nullptr;
  math::Pose X_W = math::Pose::Identity();
  int machine = -1;  ///< whose part or load it is; -1 for a part that it never moves
  int moving = -1;   ///< the thing with a timetable that it is

  /// Whether it may go out of the way.
  bool may_leave() const { return machine >= 0 || moving >= 0; }
};

/// What a vehicle on a network is told when it asks where to drive next.
struct LaneAnswer {
  enum class Kind { node, goal, waits, no_way };
  Kind kind = Kind::no_way;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();  ///< node: where it is (world, m)
  int left = 0;                                     ///< node: how many come after it
  std::string reason = {};                          ///< waits, no_way
  /// It begins to drive, or a way was just found: then the places of all nodes ahead.
  bool tells_way = false;
  std::vector<Eigen::Vector2d> way = {};
};

/// What it says of itself when it asks.
struct LaneQuestion {
  Eigen::Vector2d place;  ///< where it is (world, m)
  Eigen::Vector2d goal;   ///< where it wants to be
  bool reached = false;   ///< it has come to the node that it was sent to last
};

/// What comes nearest to a robot that stands somewhere.
struct Nearness {
  double distance = 0;  ///< m; infinite: nothing is in range
  std::string moved;    ///< a body of the robot, or its load
  std::string met;      ///< what stands there
};

/// Pairs of names, as of `Nearness`, that are not looked at.
using PairsLeftOut = std::vector<std::pair<std::string, std::string>>;

/// What a look along a leg found, in shares of it.
struct LegShares {
  double free_until = 0;  ///< proved free up to here
  /// All longer parts of the leg are refused; infinite: nothing is known to be met.
  double met_from = std::numeric_limits<double>::infinity();
};

/// What a guide asks of the site; configurations have all parameters of the robot.
class MotionTests {
 public:
  virtual ~MotionTests() = default;
  /// Whether the robot may stand at q: within its ranges, and nothing overlaps.
  virtual bool stands(std::span<const double> q) = 0;
  /// Whether all that it sweeps is free while q runs straight from one value to the other.
  virtual bool sweeps_free(std::span<const double> q_from, std::span<const double> q_to) = 0;
  /// How far it is free while q runs straight from one value to the other: sooner answered than by
  /// tests of ever shorter parts, and as `sweeps_free` would answer. `whole`: only whether all of
  /// it is free; else the longest of its parts 1, 1/2, 1/4 ... that is, if it is no shorter than
  /// `least` of it.
  virtual LegShares look_along(std::span<const double>, std::span<const double>, bool whole,
                               double least) {
    static_cast<void>(whole);
    static_cast<void>(least);
    return {};
  }
  /// All that is on the site but the robot, as it stands now: for ways in the plan view.
  virtual std::vector<Thing> things() const { return {}; }
  /// Told of each of these that may leave and bars the way: without them there would be one.
  virtual void note_barring(const Thing&) {}
  /// What comes nearest within `range` (m) to anything that the robot can move, if it stands at q.
  virtual Nearness nearest(std::span<const double>, double, const PairsLeftOut&) {
    return {std::numeric_limits<double>::infinity(), {}, {}};
  }
  /// The next node for a vehicle of a fleet, which it may enter now and holds from now on.
  virtual LaneAnswer next_node(const LaneQuestion&) {
    LaneAnswer answer;
    answer.reason = "it drives on no network";
    return answer;
  }
};

/// A configuration as planners see it: the parameters of a leg, in their order.
using Point = std::vector<double>;

/// The configurations of a robot that a planner searches. It counts what it tests.
class Space {
 public:
  /// `q` has the values of what no leg changes, locked parameters among them. All but the result
  /// must outlive it.
  Space(const robot::RobotModel& model, const robot::Mounting& mounting, std::span<const double> q,
        const GuideSpec& spec, MotionTests& tests, const robot::GoalClauses& clauses = {});

  std::size_t size() const { return leg_.parameters().size(); }
  const Leg& leg() const { return leg_; }
  Point point(std::span<const double> q) const;
  /// All parameters, cyclic angles reduced, derived ones computed.
  std::vector<double> configuration(std::span<const double> point) const;

  const robot::Parameter& parameter(std::size_t i) const {
    return model_.parameters[static_cast<std::size_t>(leg_.parameters()[i])];
  }
  double weight(std::size_t i) const { return weights_[i]; }
  /// Of a vehicle: its heading parameter when it drives along a direction of the plan (world).
  double heading_along(std::span<const double> q, const Eigen::Vector2d& direction_W) const;
  /// The range of a coordinate; of a cyclic angle from -180 to 180.
  double lower(std::size_t i) const;
  double upper(std::size_t i) const;

  /// From a to b in coordinate i, the short way round, times its weight.
  double offset(std::span<const double> a, std::span<const double> b, std::size_t i) const;
  double distance(std::span<const double> a, std::span<const double> b) const;
  /// The point that is so far from a on the straight way to b; b itself if that is no farther.
  Point towards(std::span<const double> a, std::span<const double> b, double distance) const;
  /// a plus weighted offsets, kept within the ranges.
  Point moved(std::span<const double> a, std::span<const double> offsets) const;

  Point sample(Random& random) const;
  /// The same, into a point that is there.
  void sample(Random& random, Point& point) const;
  /// With the goal as its mean in each coordinate (Langari 2015, 3.3.2).
  Point sample_about(std::span<const double> goal, double concentration, Random& random) const;

  /// Whether what the guide keeps holds at a configuration.
  bool keeps(std::span<const double> q) const;
  bool stands(std::span<const double> point);
  bool leg_is_free(std::span<const double> a, std::span<const double> b);
  /// How far the leg from a to b is free, as a share of it, where that can be seen at once; none:
  /// ask for each part of it. Parts shorter than the share `least` count as none. One check.
  std::optional<double> free_share(std::span<const double> a, std::span<const double> b,
                                   double least);
  /// Tests a way again by the very steps that `follow` makes.
  bool steps_are_free(std::span<const double> q, const std::vector<Point>& way);
  /// A way of a vehicle that steers, with the ends of the chords that its arcs are driven in; of
  /// any other the way itself.
  std::vector<Point> with_chords(const std::vector<Point>& way) const;
  Nearness nearest(std::span<const double> point, double range, const PairsLeftOut& left_out) {
    return tests_.nearest(configuration(point), range, left_out);
  }
  /// From now on legs are tested by the steps of `follow`.
  void test_by_steps() { by_steps_ = true; }

  std::size_t checks() const { return checks_; }
  std::size_t refused() const { return refused_; }
  bool spent() const { return static_cast<double>(checks_) >= spec_.checks; }
  const GuideSpec& spec() const { return spec_; }

 private:
  void make_kept(Point& point) const;
  bool sweeps_free(std::span<const double> q_from, std::span<const double> q_to);
  std::optional<std::vector<double>> end_of_straight(std::span<const double> q,
                                                     std::span<const double> target) const;
  bool follow_is_free(std::vector<double>& q, std::span<const double> target);

  const robot::RobotModel& model_;
  const robot::Mounting& mounting_;
  std::vector<double> q_;
  const GuideSpec& spec_;
  MotionTests& tests_;
  Leg leg_;
  std::vector<double> weights_;
  std::size_t checks_ = 0;
  std::size_t refused_ = 0;
  bool by_steps_ = false;
};

}  // namespace rubicon::guides
