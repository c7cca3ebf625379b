#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/motion/travel/exact.hpp"

namespace rubicon::travel {

/// Ways to travel without a map. Sources and proofs: docs/travel.md.
enum class Method { kBug1, kBug2, kVisBug21, kPledge, kSimple, kTangent, kAce };
inline constexpr Method kMethods[] = {Method::kBug1,   Method::kBug2,   Method::kVisBug21,
                                      Method::kPledge, Method::kSimple, Method::kTangent,
                                      Method::kAce};
/// As in files: "bug1", "visbug21".
std::string_view name_of(Method method);

/// On which side the robot keeps what it follows.
enum class Hand { kRight, kLeft };

/// A place of the timetable of an obstacle: where its frame is, and how it is turned.
struct Placement {
  double time = 0;  ///< s
  Vec2 place{0, 0};
  double heading_deg = 0;
};

/// An obstacle, grown by the robot. Its parts are simple polygons (corners in m, in either sense)
/// and may touch and overlap. Without a timetable corners are places of the plan view; with one
/// they are given in the obstacle's own frame, which goes straight and evenly from one placement to
/// the next, turning the short way, and stands before the first and after the last one, unless it
/// repeats.
struct Obstacle {
  std::string name;
  std::vector<std::vector<Vec2>> parts;
  std::vector<Placement> timetable;  ///< times ascending
  bool repeat = false;               ///< the last placement is the first one again
};

struct TravelQuery {
  std::vector<Obstacle> obstacles;
  Vec2 start{0, 0};
  Vec2 destination{0, 0};
};

struct TravelSettings {
  Hand hand = Hand::kRight;
  double speed = 1;      ///< m/s
  double vision = 10;    ///< m; how far visbug21 sees, nobody else sees anything
  double stride = 0.25;  ///< m; visbug21 looks round once a stride
  /// Pledge: the direction to keep, x east and y north; (0, 0): from the start to the destination.
  Vec2 compass{0, 0};
  /// s; obstacles move once in so much time, the robot in between. A whole part of it is taken
  /// where an obstacle would move by more than half of its thickness at once.
  double slice = 0.25;
  double most_length = 100'000;         ///< m of way, then the verdict is kLimit
  double most_time = 1e7;               ///< s, likewise
  std::int64_t most_steps = 1'000'000;  ///< stretches of way between two decisions, likewise
};

enum class Verdict { kReached, kUnreachable, kLimit };
enum class Mode { kTowards, kSearching, kTracking };
enum class EventKind {
  kCovered,       ///< an obstacle stands on the start
  kHit,           ///< an obstacle is in the way, or ran into the robot, which begins to follow it
  kLeave,         ///< back on the line to the destination, nearer than before, and it goes on there
  kNearest,       ///< bug1: at the point of the outline that is nearest to the destination
  kClear,         ///< the direction to the destination (pledge: of the compass) is free again
  kTrack,         ///< the outline is a trap: from here on the line to the destination counts
  kTrackedMoves,  ///< ace: what it follows moves
  kRevisit,       ///< ace: back on its own trail, clockwise
  kTarget,        ///< visbug21: sees the line to the destination beyond what it follows
  kSqueezed,      ///< an obstacle ran over the place where the robot follows another one
  kEscaped,       ///< pledge: nothing is in the direction of the compass any more
  kBack,          ///< back at the beginning of the loop: the verdict is kUnreachable
  kReached,
  kLimit,
};
std::string_view name_of(EventKind kind);
std::string_view name_of(Verdict verdict);

struct Event {
  EventKind kind = EventKind::kHit;
  double time = 0;  ///< s
  Vec2 point{0, 0};
  std::vector<std::string> obstacles;  ///< whose outline the robot is on; by their order
};

/// A corner of the way; `mode` is that of the stretch that leads to it.
struct WayPoint {
  Vec2 point{0, 0};
  double time = 0;
  Mode mode = Mode::kTowards;
};

/// What the length of a way is proved not to exceed, among standing obstacles.
struct Bound {
  double length = 0;      ///< m
  double distance = 0;    ///< D, from start to destination
  double perimeters = 0;  ///< of the outlines that count: bug1 those that come within D of the
                          ///< destination, bug2 those that the line crosses
  int crossings = 0;      ///< of outlines with the line from start to destination
};

struct TravelResult {
  Verdict verdict = Verdict::kLimit;
  double length = 0;  ///< m; with what the robot was carried and pushed
  double time = 0;    ///< s
  std::vector<Event> events;
  std::vector<WayPoint> way;
  std::optional<Bound> bound;  ///< bug1 and bug2
};

/// The way of a point robot that knows where it is, where the destination is, and what it touches.
/// Among standing obstacles on which side of a line a corner is, and what a way enters, is decided
/// exactly (docs/travel.md). The same query and settings give the same result, bit for bit.
/// Throws std::invalid_argument for polygons that
/// are not simple, places further than 524 km from the origin, settings that are not positive, and
/// timetables for bug1 and visbug21, which their authors give for standing obstacles only.
TravelResult travel(Method method, const TravelQuery& query, const TravelSettings& settings = {});

}  // namespace rubicon::travel
