#include "src/motion/guides/reeds_shepp.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/turns.hpp"

namespace rubicon::guides {

namespace {

/// Radii by which the end of a word may be off: words that are farther off do not join the poses.
constexpr double kJoins = 1e-7;

/// Degrees below which a part of a word is none: rounding.
constexpr double kNoPart_deg = 1e-9;

/// The words of Reeds and Shepp, for a radius of 1 and a start at the origin along x: up to five
/// parts, each an arc (degrees) or straight (radii).
enum class Turn : std::int8_t { right = -1, straight = 0, left = 1 };
struct WordPart {
  Turn turn = Turn::straight;
  double amount = 0;  ///< degrees of an arc, radii of a straight part; backwards negative
};
using Word = std::vector<WordPart>;

struct Polar {
  double r = 0;
  double angle_deg = 0;
};
Polar polar(double x, double y) { return {std::sqrt(x * x + y * y), math::atan2_deg(y, x)}; }
double turn_of(double degrees) { return math::normalised_deg(degrees); }
double arc_sine_deg(double s) { return math::atan2_deg(s, std::sqrt((1 - s) * (1 + s))); }
double arc_cosine_deg(double c) { return math::atan2_deg(std::sqrt((1 - c) * (1 + c)), c); }
constexpr double kQuarter = 90;

constexpr Turn kToLeft = Turn::left;
constexpr Turn kToRight = Turn::right;
constexpr Turn kAhead = Turn::straight;

/// (8.1) left, straight, left, all forwards.
std::optional<Word> left_straight_left(double x, double y, double phi) {
  const Polar p = polar(x - math::sin_deg(phi), y - 1 + math::cos_deg(phi));
  return Word{{kToLeft, p.angle_deg}, {kAhead, p.r}, {kToLeft, turn_of(phi - p.angle_deg)}};
}

/// (8.2) left, straight, right, all forwards.
std::optional<Word> left_straight_right(double x, double y, double phi) {
  const Polar p = polar(x + math::sin_deg(phi), y - 1 - math::cos_deg(phi));
  if (p.r < 2) return std::nullopt;
  const double u = std::sqrt((p.r - 2) * (p.r + 2));
  const double t = turn_of(p.angle_deg + math::atan2_deg(2, u));
  return Word{{kToLeft, t}, {kAhead, u}, {kToRight, turn_of(t - phi)}};
}

/// (8.3, 8.4) left, right back, left: three arcs with one or two cusps.
std::optional<Word> left_right_left(double x, double y, double phi) {
  const Polar p = polar(x - math::sin_deg(phi), y - 1 + math::cos_deg(phi));
  if (p.r > 4) return std::nullopt;
  const double u = -2 * arc_sine_deg(p.r / 4);
  const double t = turn_of(p.angle_deg + u / 2 + 180);
  return Word{{kToLeft, t}, {kToRight, u}, {kToLeft, turn_of(phi - t + u)}};
}

/// The outer arcs of four, of which the inner two turn by u and v.
std::optional<Word> four_arcs(double u, double v, double xi, double eta, double phi) {
  const double delta = turn_of(u - v);
  const double a = math::sin_deg(u) - math::sin_deg(delta);
  const double b = math::cos_deg(u) - math::cos_deg(delta) - 1;
  const double t1 = math::atan2_deg(eta * a - xi * b, xi * a + eta * b);
  const double t2 = 2 * (math::cos_deg(delta) - math::cos_deg(v) - math::cos_deg(u)) + 3;
  const double t = turn_of(t2 < 0 ? t1 + 180 : t1);
  return Word{{kToLeft, t}, {kToRight, u}, {kToLeft, v}, {kToRight, turn_of(t - u + v - phi)}};
}

/// (8.7) left, right, left back, right back.
std::optional<Word> cusp_between(double x, double y, double phi) {
  const double xi = x + math::sin_deg(phi);
  const double eta = y - 1 - math::cos_deg(phi);
  const double rho = (2 + std::sqrt(xi * xi + eta * eta)) / 4;
  if (rho > 1) return std::nullopt;
  const double u = arc_cosine_deg(rho);
  return four_arcs(u, -u, xi, eta, phi);
}

/// (8.8) left, right back, left back, right.
std::optional<Word> cusps_outside(double x, double y, double phi) {
  const double xi = x + math::sin_deg(phi);
  const double eta = y - 1 - math::cos_deg(phi);
  const double rho = (20 - xi * xi - eta * eta) / 16;
  if (rho < 0 || rho > 1) return std::nullopt;
  const double u = -arc_cosine_deg(rho);
  return four_arcs(u, u, xi, eta, phi);
}

/// (8.9) left, a quarter right back, straight back, left back.
std::optional<Word> quarter_left(double x, double y, double phi) {
  const Polar p = polar(x - math::sin_deg(phi), y - 1 + math::cos_deg(phi));
  if (p.r < 2) return std::nullopt;
  const double r = std::sqrt((p.r - 2) * (p.r + 2));
  const double t = turn_of(p.angle_deg + math::atan2_deg(r, -2));
  return Word{
      {kToLeft, t}, {kToRight, -kQuarter}, {kAhead, 2 - r}, {kToLeft, turn_of(phi - kQuarter - t)}};
}

/// (8.10) left, a quarter right back, straight back, right back.
std::optional<Word> quarter_right(double x, double y, double phi) {
  const double xi = x + math::sin_deg(phi);
  const double eta = y - 1 - math::cos_deg(phi);
  const Polar p = polar(-eta, xi);
  if (p.r < 2) return std::nullopt;
  const double t = p.angle_deg;
  return Word{{kToLeft, t},
              {kToRight, -kQuarter},
              {kAhead, 2 - p.r},
              {kToRight, turn_of(t + kQuarter - phi)}};
}

/// (8.11) left, a quarter right back, straight back, a quarter left back, right.
std::optional<Word> two_quarters(double x, double y, double phi) {
  const double xi = x + math::sin_deg(phi);
  const double eta = y - 1 - math::cos_deg(phi);
  const double r = std::sqrt(xi * xi + eta * eta);
  if (r < 2) return std::nullopt;
  const double u = 4 - std::sqrt((r - 2) * (r + 2));
  const double t = turn_of(math::atan2_deg((4 - u) * xi - 2 * eta, -2 * xi + (u - 4) * eta));
  return Word{{kToLeft, t},
              {kToRight, -kQuarter},
              {kAhead, u},
              {kToLeft, -kQuarter},
              {kToRight, turn_of(t - phi)}};
}

using MakeWord = std::optional<Word> (*)(double x, double y, double phi);
struct Family {
  MakeWord make;
  bool reversed;  ///< it is also driven from its other end
};
constexpr std::array kFamilies{
    Family{left_straight_left, false}, Family{left_straight_right, false},
    Family{left_right_left, true},     Family{cusp_between, false},
    Family{cusps_outside, false},      Family{quarter_left, true},
    Family{quarter_right, true},       Family{two_quarters, false}};

PlanePart part_of(const WordPart& part) {
  if (part.turn == Turn::straight) return {0, part.amount};
  return {part.amount * static_cast<double>(part.turn), math::radians(part.amount)};
}

double length_of(const Word& word) {
  double length = 0;
  for (const WordPart& part : word) length += std::fabs(part_of(part).driven);
  return length;
}

/// Whether a word leads to where it shall: formulas give angles that do not, too.
bool joins(const Word& word, double x, double y, double phi) {
  PlanePose pose;
  for (const WordPart& part : word) pose = after(pose, part_of(part));
  return std::fabs(pose.x - x) <= kJoins && std::fabs(pose.y - y) <= kJoins &&
         std::fabs(math::radians(turn_of(pose.heading_deg - phi))) <= kJoins;
}

/// Keeps the shortest word.
struct Shortest {
  double x, y, phi;
  std::optional<Word> word = {};
  double length = std::numeric_limits<double>::infinity();

  void offer(Word candidate) {
    const double candidate_length = length_of(candidate);
    // Equals differ by rounding, which must not choose between them.
    constexpr double kShorter = 1e-9;
    if (!(candidate_length < length - kShorter) || !joins(candidate, x, y, phi)) return;
    length = candidate_length;
    word = std::move(candidate);
  }
};

}  // namespace

double ReedsSheppWay::length() const {
  double length = 0;
  for (const PlanePart& part : parts) length += std::fabs(part.driven);
  return length;
}

PlanePose after(const PlanePose& from, const PlanePart& part) {
  PlanePose to = from;
  to.heading_deg += part.turned_deg;
  const auto along = math::sine_cosine_deg(from.heading_deg);
  if (part.turned_deg == 0) {
    to.x += part.driven * along.cosine;
    to.y += part.driven * along.sine;
    return to;
  }
  const double radius = part.driven / math::radians(part.turned_deg);  // left positive
  const auto then = math::sine_cosine_deg(to.heading_deg);
  to.x += radius * (then.sine - along.sine);
  to.y -= radius * (then.cosine - along.cosine);
  return to;
}

ReedsSheppWay reeds_shepp_way(const PlanePose& from, const PlanePose& to, double radius) {
  const auto along = math::sine_cosine_deg(from.heading_deg);
  const double dx = (to.x - from.x) / radius;
  const double dy = (to.y - from.y) / radius;
  Shortest shortest{dx * along.cosine + dy * along.sine, dy * along.cosine - dx * along.sine,
                    turn_of(to.heading_deg - from.heading_deg)};
  const double x = shortest.x;
  const double y = shortest.y;
  const double phi = shortest.phi;
  // Each word also backwards in time (all parts the other way), mirrored, and both; some from their
  // other end, too.
  for (const Family& family : kFamilies) {
    for (const bool reversed : {false, true}) {
      if (reversed && !family.reversed) continue;
      const auto heading = math::sine_cosine_deg(phi);
      const double a = reversed ? x * heading.cosine + y * heading.sine : x;
      const double b = reversed ? x * heading.sine - y * heading.cosine : y;
      for (const bool back : {false, true}) {
        for (const bool mirrored : {false, true}) {
          const auto made =
              family.make(back ? -a : a, mirrored ? -b : b, back != mirrored ? -phi : phi);
          if (!made) continue;
          Word word = *made;
          if (reversed) word.assign(made->rbegin(), made->rend());
          for (WordPart& part : word) {
            if (back) part.amount = -part.amount;
            if (mirrored) part.turn = static_cast<Turn>(-static_cast<int>(part.turn));
          }
          shortest.offer(std::move(word));
        }
      }
    }
  }
  ReedsSheppWay way;
  if (!shortest.word) return way;
  for (const WordPart& part : *shortest.word) {
    PlanePart each = part_of(part);
    each.driven *= radius;
    const double size = part.turn == Turn::straight ? math::degrees(part.amount) : part.amount;
    if (std::fabs(size) <= kNoPart_deg) continue;
    // Two arcs of one circle with nothing between them are one: where they meet is rounding.
    const bool goes_on = !way.parts.empty() && way.parts.back().turned_deg * each.turned_deg > 0 &&
                         way.parts.back().driven * each.driven > 0;
    if (goes_on) {
      way.parts.back().turned_deg += each.turned_deg;
      way.parts.back().driven += each.driven;
    } else {
      way.parts.push_back(each);
    }
  }
  return way;
}

}  // namespace rubicon::guides
