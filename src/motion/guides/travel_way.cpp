#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "src/motion/guides/planners.hpp"
#include "src/motion/guides/vehicle.hpp"
#include "src/motion/math/angles.hpp"
#include "src/motion/math/index.hpp"
#include "src/motion/travel/grown_view.hpp"
#include "src/motion/travel/visibility.hpp"

namespace rubicon::guides {

namespace {

using math::at;
using travel::Vec2;

/// m by which a disc is larger than the machine: corners of outlines lie on a lattice of 1 um, and
/// a leg along an edge must be free for the engine, too.
constexpr double kRoom = 1e-4;

/// m; corners nearer to a straight line than this are none.
constexpr double kStraight = 1e-7;

/// m; corners of outlines and the ends of a way are moved to the lattice by less than this. Corners
/// nearer to an end are none.
constexpr double kAtEnd = 2 / travel::kPitchesPerMetre;

/// What is seen without a setting: neither the guide nor the robot says how far.
constexpr double kUsualVision = 10;

travel::Method method_of(GuideKind kind) {
  switch (kind) {
    case GuideKind::bug1:
      return travel::Method::kBug1;
    case GuideKind::visbug21:
      return travel::Method::kVisBug21;
    case GuideKind::pledge:
      return travel::Method::kPledge;
    case GuideKind::simple:
      return travel::Method::kSimple;
    case GuideKind::tangent:
      return travel::Method::kTangent;
    case GuideKind::ace:
      return travel::Method::kAce;
    default:
      return travel::Method::kBug2;
  }
}

/// The corners of a way, without those that are none.
std::vector<Vec2> corners_of(const std::vector<Vec2>& way) {
  std::vector<Vec2> corners;
  for (const Vec2& p : way) {
    if (!corners.empty() && (p - corners.back()).norm() <= kStraight) continue;
    while (corners.size() > 1) {
      const Vec2 before = corners.back() - corners[corners.size() - 2];
      const Vec2 after = p - corners.back();
      const double beside = before.x() * after.y() - before.y() * after.x();
      if (std::fabs(beside) > kStraight * before.norm() || before.dot(after) < 0) break;
      corners.pop_back();
    }
    corners.push_back(p);
  }
  return corners;
}

/// A way was searched between places of the lattice; it begins and ends where it was asked to.
void set_ends(std::vector<Vec2>& corners, const travel::TravelQuery& query) {
  const auto near = [](const Vec2& end) {
    return [&end](const Vec2& p) { return (p - end).norm() <= kAtEnd; };
  };
  while (!corners.empty() && near(query.destination)(corners.back())) corners.pop_back();
  const auto first = std::find_if_not(corners.begin(), corners.end(), near(query.start));
  corners.erase(corners.begin(), first);
  corners.insert(corners.begin(), query.start);
  corners.push_back(query.destination);
}

std::string text_of(const travel::Event& event) {
  std::string text =
      fmt::format("{} at ({:.2f}, {:.2f})", name_of(event.kind), event.point.x(), event.point.y());
  if (!event.obstacles.empty()) text += fmt::format(" by {}", fmt::join(event.obstacles, ", "));
  return text;
}

/// The edges of a visibility graph whose ends the machine may be at, turned as it stands.
std::vector<std::pair<Point, Point>> sight_lines(const Space& space, const Vehicle& vehicle,
                                                 std::span<const double> q,
                                                 const travel::VisibilityResult& shortest) {
  std::vector<Point> points;
  std::vector<double> there(q.begin(), q.end());
  for (const Vec2& node : shortest.nodes) {
    vehicle.set_place(node, there);
    points.push_back(space.point(there));
  }
  const auto is_in_range = [&](const Point& point) {
    for (std::size_t i = 0; i < point.size(); ++i) {
      if (point[i] < space.lower(i) || point[i] > space.upper(i)) return false;
    }
    return true;
  };
  std::vector<std::pair<Point, Point>> lines;
  for (const auto& [a, b] : shortest.edges) {
    const Point& from = points[at(a)];
    const Point& to = points[at(b)];
    if (is_in_range(from) && is_in_range(to)) lines.emplace_back(from, to);
  }
  return lines;
}

/// The first of very many, and how many more there are.
std::vector<std::string> texts_of(const std::vector<travel::Event>& events) {
  constexpr std::size_t kMostTold = 200;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < std::min(events.size(), kMostTold); ++i) {
    texts.push_back(text_of(events[i]));
  }
  if (events.size() > kMostTold) texts.push_back(fmt::format("{} more", events.size() - kMostTold));
  return texts;
}

/// A way in the plan view; empty: none, and `search` has the cause.
std::vector<Vec2> way_among(const travel::TravelQuery& query, Space& space, const GuideTask& task,
                            std::span<const double> q, Search& search) {
  const GuideSpec& spec = space.spec();
  if (spec.kind == GuideKind::visibility) {
    travel::VisibilityResult shortest = travel::shortest_way(query);
    search.nodes = shortest.nodes.size();
    if (spec.tells_tree) {
      search.tree = sight_lines(space, Vehicle(*task.model, task.mounting), q, shortest);
    }
    if (!shortest.reached) {
      search.cause = "there is none round what stands, for a disc that holds the machine";
    }
    return std::move(shortest.way);
  }
  travel::TravelSettings settings;
  settings.hand = spec.left_hand ? travel::Hand::kLeft : travel::Hand::kRight;
  settings.vision = spec.vision > 0          ? spec.vision
                    : task.model->sensor > 0 ? task.model->sensor
                                             : kUsualVision;
  settings.most_steps = static_cast<std::int64_t>(spec.nodes);
  const travel::TravelResult result = travel::travel(method_of(spec.kind), query, settings);
  search.nodes = result.events.size();
  search.events = texts_of(result.events);
  // Pledge may get out and be elsewhere.
  const bool there =
      !result.events.empty() && result.events.back().kind == travel::EventKind::kReached;
  std::vector<Vec2> way;
  if (result.verdict != travel::Verdict::kReached || !there) {
    search.cause = result.verdict == travel::Verdict::kUnreachable
                       ? "as far as it was seen the goal cannot be reached"
                   : result.verdict == travel::Verdict::kLimit
                       ? fmt::format("{} stretches were not enough", settings.most_steps)
                       : std::string("it got out, and seeks no goal");
    if (!result.events.empty()) search.cause += "; last " + text_of(result.events.back());
    return way;
  }
  for (const travel::WayPoint& point : result.way) way.push_back(point.point);
  return way;
}

/// There is no way: if there were one without what may leave, what of that is met on it bars it.
/// `owners` are the things that the obstacles of the query are.
void note_barring(const travel::TravelQuery& query, const std::vector<Thing>& owners, Space& space,
                  const GuideTask& task, std::span<const double> q, MotionTests& tests) {
  travel::TravelQuery rest = query;
  rest.obstacles.clear();
  for (std::size_t i = 0; i < owners.size(); ++i) {
    if (!owners[i].may_leave()) rest.obstacles.push_back(query.obstacles[i]);
  }
  if (rest.obstacles.size() == query.obstacles.size()) return;
  Search unused;
  const std::vector<Vec2> way = way_among(rest, space, task, q, unused);
  for (std::size_t i = 0; i < owners.size(); ++i) {
    if (owners[i].may_leave() && travel::meets(query.obstacles[i], way)) {
      tests.note_barring(owners[i]);
    }
  }
}

}  // namespace

Search travel_way(Space& space, const GuideTask& task, std::span<const double> q, const Point& goal,
                  MotionTests& tests) {
  const Vehicle vehicle(*task.model, task.mounting);
  const std::vector<double> q_goal = space.configuration(goal);
  Search search;
  travel::TravelQuery query;
  query.start = vehicle.place(q);
  query.destination = vehicle.place(q_goal);
  travel::GrownView view(vehicle.heights(q), vehicle.radius(q) + kRoom);
  // The machine stands there, if only turned so: what is nearer than the disc is tested step by
  // step.
  view.keep_free(query.start);
  view.keep_free(query.destination);
  std::vector<Thing> owners;
  for (const Thing& thing : tests.things()) {
    if (view.add(thing.name, *thing.shapes, thing.X_W) != nullptr) owners.push_back(thing);
  }
  query.obstacles = std::move(view.obstacles());
  const std::vector<Vec2> way = way_among(query, space, task, q, search);
  if (way.empty()) {
    note_barring(query, owners, space, task, q, tests);
    return search;
  }
  std::vector<Vec2> corners = corners_of(way);
  set_ends(corners, query);
  std::vector<double> at_corner(q.begin(), q.end());
  search.way.push_back(space.point(q));
  const int heading = space.leg().heading();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    vehicle.set_place(corners[i], at_corner);
    if (heading >= 0) {
      // The heading of arrival: that of the leg, as the vehicle turns to drive it.
      const Vec2 along = corners[i] - corners[i - 1];
      at_corner[at(heading)] = space.heading_along(q, along);
    }
    search.way.push_back(space.point(at_corner));
  }
  search.way.push_back(goal);
  return search;
}

}  // namespace rubicon::guides
