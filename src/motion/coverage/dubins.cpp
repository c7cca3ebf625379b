#include "src/motion/coverage/dubins.hpp"

#include <algorithm>
#include <cmath>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/turns.hpp"

namespace rubicon::coverage {
namespace {

/// Degrees: an arc that is a whole turn but for less is none.
constexpr double kNoArc_deg = 1e-7;
/// m: circles that miss each other by less touch.
constexpr double kTouch = 1e-9;
/// Degrees: smaller changes of heading are no turns.
constexpr double kNoTurn_deg = 1;

Place moved(const Place& from, double heading_deg, double distance) {
  return {from.x + distance * math::cos_deg(heading_deg),
          from.y + distance * math::sin_deg(heading_deg)};
}

/// The middle of the circle that a turn runs along: side 1 left, -1 right.
Place middle_of_turn(const Heading& at, double side, double radius) {
  return moved(at.place, at.heading_deg + 90 * side, radius);
}

/// How far a turn to one side goes from one heading to another, with its sign.
double arc_deg(double from_deg, double to_deg, double side) {
  double turned = math::turn_above_deg(side * (to_deg - from_deg), 0);
  if (turned > math::kTurn_deg - kNoArc_deg || turned < kNoArc_deg) turned = 0;
  return side * turned;
}

struct Sides {
  double first, last;
};
Sides sides_of(DubinsWord word) {
  switch (word) {
    case DubinsWord::kLsl:
    case DubinsWord::kLrl:
      return {1, 1};
    case DubinsWord::kLsr:
      return {1, -1};
    case DubinsWord::kRsl:
      return {-1, 1};
    case DubinsWord::kRsr:
    case DubinsWord::kRlr:
      break;
  }
  return {-1, -1};
}

Heading after_arc(const Heading& at, double turned_deg, double radius) {
  if (turned_deg == 0) return at;
  const double side = turned_deg > 0 ? 1 : -1;
  const Place middle = middle_of_turn(at, side, radius);
  const double heading = at.heading_deg + turned_deg;
  return {moved(middle, heading - 90 * side, radius), math::normalised_deg(heading)};
}

}  // namespace

double DubinsWay::length() const {
  double turned = 0;
  for (const double each : turned_deg) turned += std::fabs(each);
  return math::radians(turned) * radius + straight;
}

int DubinsWay::turns() const {
  return static_cast<int>(std::count_if(turned_deg.begin(), turned_deg.end(),
                                        [](double each) { return std::fabs(each) > kNoTurn_deg; }));
}

std::vector<Heading> DubinsWay::corners(double most_deg) const {
  std::vector<Heading> corners{from};
  Heading at = from;
  for (std::size_t part = 0; part < turned_deg.size(); ++part) {
    const double turned = turned_deg[part];
    if (turned != 0) {
      const int steps =
          std::max(1, static_cast<int>(std::ceil(std::fabs(turned) / most_deg - 1e-9)));
      for (int i = 1; i <= steps; ++i) corners.push_back(after_arc(at, turned * i / steps, radius));
      at = corners.back();
    } else if (part == 1 && straight > 0) {
      at.place = moved(at.place, at.heading_deg, straight);
      corners.push_back(at);
    }
  }
  return corners;
}

std::optional<DubinsWay> dubins_way(DubinsWord word, const Heading& from, const Heading& to,
                                    double radius) {
  DubinsWay way;
  way.word = word;
  way.from = from;
  way.radius = radius;
  const auto [first, last] = sides_of(word);
  const Place a = middle_of_turn(from, first, radius);
  const Place b = middle_of_turn(to, last, radius);
  const double apart = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
  const double towards = apart > 0 ? math::atan2_deg(b.y - a.y, b.x - a.x) : from.heading_deg;
  if (word == DubinsWord::kRlr || word == DubinsWord::kLrl) {
    // The circle between touches both.
    const double cosine = apart / (4 * radius);
    if (cosine > 1) return std::nullopt;
    const double up = math::atan2_deg(std::sqrt(std::max(0.0, 1 - cosine * cosine)), cosine);
    // Of the two places of it the one whose arc is longer than half a turn: the other is no
    // shortest way.
    const double to_middle = towards + first * up;
    const Place c = moved(a, to_middle, 2 * radius);
    const double heading_in = to_middle + 90 * first;  // where the first arc ends
    const double back = math::atan2_deg(b.y - c.y, b.x - c.x);
    const double heading_out = back - 90 * first;  // where the middle one ends
    way.turned_deg = {arc_deg(from.heading_deg, heading_in, first),
                      arc_deg(heading_in, heading_out, -first),
                      arc_deg(heading_out, to.heading_deg, first)};
    return way;
  }
  double heading = towards;
  if (first == last) {
    way.straight = apart;
  } else {
    // The straight crosses between the circles.
    const double square = apart * apart - 4 * radius * radius;
    if (square < -kTouch * radius) return std::nullopt;
    way.straight = std::sqrt(std::max(0.0, square));
    heading += first * math::atan2_deg(2 * radius, way.straight);
  }
  way.turned_deg = {arc_deg(from.heading_deg, heading, first), 0,
                    arc_deg(heading, to.heading_deg, last)};
  return way;
}

std::vector<DubinsWay> dubins_ways(const Heading& from, const Heading& to, double radius) {
  std::vector<DubinsWay> ways;
  for (const DubinsWord word : kDubinsWords) {
    if (auto way = dubins_way(word, from, to, radius)) ways.push_back(*way);
  }
  std::stable_sort(ways.begin(), ways.end(),
                   [](const DubinsWay& a, const DubinsWay& b) { return a.length() < b.length(); });
  return ways;
}

}  // namespace rubicon::coverage
