#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/motion/travel/leg.hpp"
#include "src/motion/travel/timetable.hpp"
#include "src/motion/travel/travel.hpp"

namespace rubicon::travel {

/// A line to the destination, on which a robot may leave what it follows.
struct LineWatch {
  Leg line;
  double nearer_than = 0;  ///< m; only points nearer to the destination count
};

/// A place on an outline, with the direction of walking there.
struct Mark {
  Vec2 point{0, 0};
  Vec2 heading{1, 0};
};

/// A stretch of the way since tracking began.
struct TrailPart {
  Vec2 from{0, 0};
  Vec2 to{0, 0};
  std::uint64_t version = 0;  ///< of the composite that it was walked on; 0: carried or pushed
};

/// What a robot looks out for while it follows an outline; null: not for that.
struct Watches {
  const LineWatch* line = nullptr;
  const Mark* mark = nullptr;
  bool trail = false;
};

/// m; what is left of a slice below this is no way: far above rounding, far below the lattice.
inline constexpr double kNoWayLeft = 1e-9;

/// What a stretch of following ended with; several may be at one point.
struct Stop {
  bool limit = false;
  bool destination = false;
  bool line = false;   ///< on the watched line, nearer, and free to go on along it
  bool mark = false;   ///< at the mark, in its direction
  bool trail = false;  ///< on the trail
  std::size_t trail_part = 0;
  bool lap = false;       ///< and that part was walked on the same outline, unchanged since
  bool node = false;      ///< on a new edge
  bool slice = false;     ///< obstacles have moved
  bool squeezed = false;  ///< and put the robot on another edge
};

/// A point robot among obstacles: goes straight, follows outlines with the obstacle on the right,
/// is carried, struck and squeezed by what moves, and writes down its way and events. Exact and
/// driven by events: it stops only where there is something to decide. After each time slice
/// obstacles move at once, then the robot walks for a slice.
class Walker {
 public:
  Walker(const TravelQuery& query, const TravelSettings& settings);

  const Outline& outline() const { return world_.outline(); }
  const MovingOutline& world() const { return world_; }
  const TravelSettings& settings() const { return settings_; }
  const LatticePoint& start() const { return start_; }
  const LatticePoint& destination() const { return destination_; }
  Aim aim() const { return {destination_, false}; }
  const Vec2& position() const { return position_; }
  double distance_to_destination() const { return (metres(destination_) - position_).norm(); }
  bool on_outline() const { return footing_.has_value(); }
  /// Requires on_outline.
  const Edge& edge() const;
  int composite() const { return footing_->composite; }
  int edge_index() const { return footing_->edge; }
  double along() const { return footing_->along; }
  /// Of the composite that it stands at.
  std::uint64_t here_version() const { return footing_->version; }
  Mark here() const { return {position_, edge().heading}; }
  /// The position without error where it is known so: the start, a node.
  ExactPoint exact_position() const;
  /// Whether a straight way that starts here is free at its beginning, along an edge included.
  bool free_towards(const Aim& aim) const;
  /// Whether what the robot is in contact with moved in this slice.
  bool contact_moves() const;

  /// Degrees that the robot has turned left while following, and that the bearing of the
  /// destination has turned left by its motion, both counted on over whole turns.
  double turned() const { return turned_; }
  double bearing_turned() const { return bearing_turned_; }

  /// Begins a new trail here, or forgets it.
  void begin_trail();
  void end_trail();
  const std::vector<TrailPart>& trail() const { return trail_; }

  enum class Outcome { kArrived, kHit, kPushed, kLimit, kEndless };
  /// Goes along `leg`, on which the robot is, to its end or to the first obstacle; that one it then
  /// stands at. kPushed: an obstacle ran into it and has set it aside, free to go on from there.
  /// kEndless: along a direction nothing will ever be in the way.
  Outcome go(const Leg& leg);
  /// Follows the outline to the next thing to decide.
  Stop follow(const Watches& watches);
  /// Follows the outline the other way round, to a place on it. For standing obstacles.
  void follow_back(int edge, double along);
  /// Goes straight to a point without looking: visbug21, which sees that the way is free.
  void go_to(const Vec2& point);
  /// Stands on the outline where it is.
  void stand_on(int composite, int edge, double along);

  void set_mode(Mode mode) { mode_ = mode; }
  void note(EventKind kind);
  /// Of a place that the robot sees, on an edge of a piece; -1: on none.
  void note_at(EventKind kind, const Vec2& point, int piece);
  bool at_limit();
  /// Leaves the result behind.
  TravelResult finish(Verdict verdict, EventKind last);

 private:
  /// Where on the outline the robot is.
  struct Footing {
    int composite = 0;
    int edge = 0;
    double along = 0;  ///< m from the start of the edge
    std::uint64_t version = 0;
    // The same in the frame of an obstacle:
    Owner owner;
    double along_owner = 0;  ///< m from the corner of its edge where walking it begins
  };

  double budget() const;
  void begin_slice();
  void settle_after_motion();
  bool run_over() const;
  void carry();
  void place_at_nearest();
  bool find_footing_again(const Owner& owner, double along_owner);
  /// By its own motion, or by that of obstacles.
  void advance_to(const Vec2& point, bool by_itself = true);
  void arrive_at_next_edge();
  void look_at_node(const Watches& watches, Stop& stop) const;
  std::vector<std::string> names() const;

  TravelSettings settings_;
  MovingOutline world_;
  LatticePoint start_;
  LatticePoint destination_;
  Vec2 position_{0, 0};
  std::optional<Footing> footing_;
  bool at_start_ = true;
  double time_ = 0;
  double slice_end_ = 0;
  std::int64_t slices_ = 0;
  std::int64_t steps_ = 0;
  Mode mode_ = Mode::kTowards;
  Vec2 heading_{1, 0};  ///< of the edge that it is on, or was on last
  double turned_ = 0;
  double bearing_turned_ = 0;
  bool keeps_trail_ = false;
  std::vector<TrailPart> trail_;
  bool struck_ = false;    ///< by the last motion
  bool squeezed_ = false;  ///< likewise
  TravelResult result_;
};

/// The angle from direction a to direction b, degrees in (-180, 180].
double angle_between(const Vec2& a, const Vec2& b);

}  // namespace rubicon::travel
