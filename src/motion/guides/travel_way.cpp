#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "src/motion/guides/planners.hpp"
#include "src/motion/guides/vehicle.hpp"
#include "src/motion/math/angles.hpp"
#include "src/motion/math/index.hpp"
#include "src/motion/robot/turns.hpp"
#include "src/motion/travel/border.hpp"
#include "src/motion/travel/exits.hpp"
#include "src/motion/travel/grown_view.hpp"
#include "src/motion/travel/timetable.hpp"
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

/// m by which a way may be beyond a bound, and a bound that is an obstacle is nearer: corners are
/// moved to the lattice.
constexpr double kBeyond = 2 / travel::kPitchesPerMetre;

/// m; so much room is left round all that stands, beside that for the machine.
constexpr double kMargin = 1;

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
void set_ends(std::vector<Vec2>& corners, const Vec2& start, const Vec2& destination) {
  const auto near = [](const Vec2& end) {
    return [&end](const Vec2& p) { return (p - end).norm() <= kAtEnd; };
  };
  while (!corners.empty() && near(destination)(corners.back())) corners.pop_back();
  const auto first = std::find_if_not(corners.begin(), corners.end(), near(start));
  corners.erase(corners.begin(), first);
  corners.insert(corners.begin(), start);
  corners.push_back(destination);
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

/// What bounds where a machine's place may be, beside what stands, and its name.
struct PlaceBound {
  travel::HalfPlane where;
  std::string name;
};

/// The ranges of its parameters x and y, and what the guide keeps of them, all others being as in
/// q, on the plane. The heading is free.
std::vector<PlaceBound> place_bounds(const Space& space, const robot::RobotModel& model,
                                     const Vehicle& vehicle, std::span<const double> q) {
  std::vector<PlaceBound> bounds;
  std::vector<double> there(q.begin(), q.end());
  const auto place_at = [&](double x, double y) {
    there[at(vehicle.x())] = x;
    there[at(vehicle.y())] = y;
    return vehicle.place(there);
  };
  const Vec2 origin = place_at(0, 0);
  const Vec2 along_x = place_at(1, 0) - origin;
  const Vec2 along_y = place_at(0, 1) - origin;
  const double turns = along_x.x() * along_y.y() - along_x.y() * along_y.x();
  if (turns == 0) return bounds;
  // x and y by the place.
  const Vec2 x_by_place = Vec2(along_y.y(), -along_y.x()) / turns;
  const Vec2 y_by_place = Vec2(-along_x.y(), along_x.x()) / turns;
  const auto add = [&](double factor_x, double factor_y, double most, const std::string& name) {
    const Vec2 normal = factor_x * x_by_place + factor_y * y_by_place;
    const double length = normal.norm();
    if (!(length > 0)) return;
    bounds.push_back({{normal / length, most / length + (normal / length).dot(origin)}, name});
  };
  for (const int i : {vehicle.x(), vehicle.y()}) {
    const robot::Parameter& p = model.parameters[at(i)];
    if (p.cyclic || !std::isfinite(p.lower) || !std::isfinite(p.upper)) continue;
    const double x = i == vehicle.x() ? 1 : 0;
    const std::string name = "the range of " + p.display_name;
    add(x, 1 - x, p.upper, name);
    add(-x, x - 1, -p.lower, name);
  }
  for (const KeptBound& kept : space.spec().keep) {
    double factor_x = 0;
    double factor_y = 0;
    double most = kept.most;
    bool is_of_heading = false;
    for (const auto& [index, factor] : kept.terms) {
      if (index == vehicle.x()) {
        factor_x += factor;
      } else if (index == vehicle.y()) {
        factor_y += factor;
      } else {
        most -= factor * q[at(index)];
        is_of_heading = is_of_heading || index == space.leg().heading();
      }
    }
    if (!is_of_heading) add(factor_x, factor_y, most, "what the guide keeps");
  }
  return bounds;
}

/// The search of one way in the plan view.
class TravelSearch {
 public:
  TravelSearch(Space& space, const GuideTask& task, std::span<const double> q, const Point& goal,
               MotionTests& tests)
      : space_(space),
        task_(task),
        tests_(tests),
        vehicle_(*task.model, task.mounting),
        q_(q.begin(), q.end()),
        q_goal_(space.configuration(goal)),
        goal_(goal),
        start_(vehicle_.place(q_)),
        destination_(vehicle_.place(q_goal_)),
        bounds_(place_bounds(space, *task.model, vehicle_, q)) {}

  Search run() {
    Search search;
    if (!may_go_anywhere(search)) return search;
    travel::GrownView view(vehicle_.heights(q_), vehicle_.radius(q_) + kRoom);
    for (const Thing& thing : tests_.things()) {
      if (view.add(thing.name, *thing.shapes, thing.X_W) != nullptr) owners_.push_back(thing);
    }
    obstacles_ = std::move(view.obstacles());
    if (!find_within_bounds(obstacles_, search)) note_barring();
    return search;
  }

 private:
  /// Where x or y stays as it is there is at most the straight way.
  bool may_go_anywhere(Search& search) {
    const std::vector<int>& moved = space_.leg().parameters();
    std::string fixed;
    for (const int i : {vehicle_.x(), vehicle_.y()}) {
      if (std::find(moved.begin(), moved.end(), i) != moved.end()) continue;
      if (!fixed.empty()) fixed += ", ";
      fixed += task_.model->parameters[at(i)].display_name;
    }
    if (fixed.empty()) return true;
    const Point here = space_.point(q_);
    if (space_.leg_is_free(here, goal_)) {
      search.way = {here, goal_};
    } else {
      search.cause = "the straight way is not free, and any other would change " + fixed;
      search.was_refused = true;
    }
    return false;
  }

  /// A way that keeps within the bounds: they are obstacles, too, once a way has left them.
  bool find_within_bounds(std::vector<travel::Obstacle> obstacles, Search& search) {
    std::vector<Vec2> way;
    if (!find(obstacles, search, way)) return false;
    std::string names;
    for (const PlaceBound& bound : bounds_) {
      const bool is_left = std::any_of(
          way.begin(), way.end(), [&](const Vec2& p) { return bound.where.beyond(p) > kBeyond; });
      if (!is_left || names.find(bound.name) != std::string::npos) continue;
      names += (names.empty() ? "" : ", ") + bound.name;
    }
    if (names.empty()) return true;
    search.way.clear();
    obstacles.push_back({names, border(obstacles), {}});
    if (find(obstacles, search, way)) return true;
    search.cause += "; the way among what stands leaves " + names;
    return false;
  }

  /// What is left of the bounds, so far as anything stands; the machine stands on this side.
  std::vector<std::vector<Vec2>> border(const std::vector<travel::Obstacle>& obstacles) const {
    Vec2 low = start_.cwiseMin(destination_);
    Vec2 high = start_.cwiseMax(destination_);
    for (const travel::Obstacle& obstacle : obstacles) {
      for (const std::vector<Vec2>& part : obstacle.parts) {
        for (const Vec2& corner : part) {
          low = low.cwiseMin(corner);
          high = high.cwiseMax(corner);
        }
      }
    }
    const Vec2 margin = Vec2::Constant(2 * vehicle_.radius(q_) + kMargin);
    std::vector<travel::HalfPlane> planes;
    for (const PlaceBound& bound : bounds_) {
      travel::HalfPlane& plane = planes.emplace_back(bound.where);
      const auto keep = [&](const Vec2& p) {
        plane.most = std::max(plane.most, plane.normal.dot(p));
      };
      plane.most -= kBeyond;
      keep(start_);
      keep(destination_);
    }
    return travel::border_of(planes, low - margin, high + margin);
  }

  /// A way among obstacles; where they cover an end of it, it leaves or comes there straight.
  bool find(const std::vector<travel::Obstacle>& obstacles, Search& search,
            std::vector<Vec2>& way) {
    travel::MovingOutline world(obstacles);
    world.move_to(0);
    const travel::Outline& outline = world.outline();
    const bool starts_covered = outline.covers(travel::ExactPoint(travel::snap(start_)));
    const bool ends_covered = outline.covers(travel::ExactPoint(travel::snap(destination_)));
    const Point here = space_.point(q_);
    if ((starts_covered || ends_covered) && space_.leg_is_free(here, goal_)) {
      search.way = {here, goal_};
      way = {start_, destination_};
      return true;
    }
    const std::vector<Vec2> starts =
        starts_covered ? free_exits(outline, true) : std::vector<Vec2>{start_};
    const std::vector<Vec2> ends =
        ends_covered ? free_exits(outline, false) : std::vector<Vec2>{destination_};
    if (starts.empty() || ends.empty()) {
      search.cause = fmt::format(
          "something is nearer to the {} than the disc that holds the machine, and no straight way "
          "leads {}",
          starts.empty() ? "start" : "goal", starts.empty() ? "away" : "there");
      search.was_refused = true;
      return false;
    }
    for (const Vec2& from : starts) {
      for (const Vec2& to : ends) {
        search.cause.clear();
        way = way_among({obstacles, from, to}, space_, task_, q_, search);
        if (way.empty()) continue;
        take(way, starts_covered, ends_covered, search);
        return true;
      }
    }
    return false;
  }

  /// Where a straight leg of the machine leads out of what covers the start, or from where one
  /// leads to the goal: the shortest to each loop of the outlines.
  std::vector<Vec2> free_exits(const travel::Outline& outline, bool of_start) {
    constexpr std::size_t kMostExits = 4;
    const Vec2& place = of_start ? start_ : destination_;
    std::vector<Vec2> directions;
    const Vec2 straight = of_start ? Vec2(destination_ - start_) : Vec2(start_ - destination_);
    if (straight.norm() > 0) directions.push_back(straight.normalized());
    if (space_.leg().heading() >= 0) {
      directions.push_back((of_start ? 1 : -1) * ahead(of_start ? q_ : q_goal_));
    }
    std::vector<std::pair<int, int>> loops;
    std::vector<Vec2> exits;
    for (const travel::Exit& exit : travel::exits_of(outline, place, directions)) {
      const std::pair loop(exit.composite, exit.loop);
      if (exits.size() == kMostExits) break;
      if (std::find(loops.begin(), loops.end(), loop) != loops.end()) continue;
      const Vec2 along = of_start ? Vec2(exit.place - place) : Vec2(place - exit.place);
      const Point there = point_at(exit.place, along);
      const bool is_free =
          of_start ? space_.leg_is_free(space_.point(q_), there) : space_.leg_is_free(there, goal_);
      if (!is_free) continue;
      loops.push_back(loop);
      exits.push_back(exit.place);
    }
    return exits;
  }

  /// The direction that the vehicle drives in.
  Vec2 ahead(const std::vector<double>& q) const {
    const double from_east_deg =
        q[at(space_.leg().heading())] - space_.heading_along(q, Vec2(1, 0));
    return {math::cos_deg(from_east_deg), math::sin_deg(from_east_deg)};
  }

  /// The machine at a place of the plan, facing a direction if it drives along one.
  Point point_at(const Vec2& place, const Vec2& along) const {
    std::vector<double> there = q_;
    vehicle_.set_place(place, there);
    // Corners lie on a lattice, and bounds need not.
    for (const int i : {vehicle_.x(), vehicle_.y()}) {
      const robot::Parameter& p = task_.model->parameters[at(i)];
      if (!p.cyclic) there[at(i)] = std::clamp(there[at(i)], p.lower, p.upper);
    }
    const int heading = space_.leg().heading();
    if (heading >= 0) there[at(heading)] = space_.heading_along(q_, along);
    return space_.point(there);
  }

  /// The corners of a way are waypoints, each with the heading of arrival: that of the leg, as the
  /// vehicle turns to drive it. An end that is covered is joined to the way straight, by its exit
  /// if it must be.
  void take(const std::vector<Vec2>& way, bool starts_covered, bool ends_covered, Search& search) {
    std::vector<Vec2> corners = corners_of(way);
    set_ends(corners, starts_covered ? way.front() : start_,
             ends_covered ? way.back() : destination_);
    if (starts_covered) corners.insert(corners.begin(), start_);
    if (ends_covered) corners.push_back(destination_);
    const auto point = [&](std::size_t i) {
      if (i == 0) return space_.point(q_);
      if (i + 1 == corners.size()) return goal_;
      return point_at(corners[i], corners[i] - corners[i - 1]);
    };
    if (starts_covered && corners.size() > 2) {
      const Point next = corners.size() == 3 ? goal_ : point_at(corners[2], corners[2] - start_);
      if (space_.leg_is_free(space_.point(q_), next)) corners.erase(corners.begin() + 1);
    }
    if (ends_covered && corners.size() > 2 &&
        space_.leg_is_free(point(corners.size() - 3), goal_)) {
      corners.erase(corners.end() - 2);
    }
    search.way.clear();
    for (std::size_t i = 0; i < corners.size(); ++i) search.way.push_back(point(i));
  }

  /// There is no way: if there were one without what may leave, what of that is met on it bars it.
  void note_barring() {
    std::vector<travel::Obstacle> rest;
    for (std::size_t i = 0; i < owners_.size(); ++i) {
      if (!owners_[i].may_leave()) rest.push_back(obstacles_[i]);
    }
    if (rest.size() == obstacles_.size()) return;
    Search search;
    if (!find_within_bounds(rest, search)) return;
    std::vector<Vec2> way;
    for (const Point& point : search.way)
      way.push_back(vehicle_.place(space_.configuration(point)));
    for (std::size_t i = 0; i < owners_.size(); ++i) {
      if (owners_[i].may_leave() && travel::meets(obstacles_[i], way)) {
        tests_.note_barring(owners_[i]);
      }
    }
  }

  Space& space_;
  const GuideTask& task_;
  MotionTests& tests_;
  Vehicle vehicle_;
  std::vector<double> q_;
  std::vector<double> q_goal_;
  Point goal_;
  Vec2 start_;
  Vec2 destination_;
  std::vector<PlaceBound> bounds_;
  std::vector<travel::Obstacle> obstacles_;
  std::vector<Thing> owners_;  ///< the things that the obstacles are
};

}  // namespace

Search travel_way(Space& space, const GuideTask& task, std::span<const double> q, const Point& goal,
                  MotionTests& tests) {
  return TravelSearch(space, task, q, goal, tests).run();
}

}  // namespace rubicon::guides
