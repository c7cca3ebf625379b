#pragma once

#include <array>
#include <optional>
#include <vector>

#include "src/motion/coverage/grid.hpp"

namespace rubicon::coverage {

/// A place of the plan view, m, and the heading there, from x towards y.
struct Heading {
  Place place;
  double heading_deg = 0;
};

/// The six ways of Dubins: two arcs with a straight between them, or three arcs; L turns left, R
/// right.
enum class DubinsWord { kLsl, kRsr, kLsr, kRsl, kRlr, kLrl };
inline constexpr std::array<DubinsWord, 6> kDubinsWords = {DubinsWord::kLsl, DubinsWord::kRsr,
                                                           DubinsWord::kLsr, DubinsWord::kRsl,
                                                           DubinsWord::kRlr, DubinsWord::kLrl};

/// A way of one word: forwards only, no turn narrower than the radius.
struct DubinsWay {
  DubinsWord word = DubinsWord::kLsl;
  Heading from;
  double radius = 0;                   ///< m
  std::array<double, 3> turned_deg{};  ///< of each part: left positive, right negative; straight 0
  double straight = 0;                 ///< m; of a straight middle part

  /// m; exact.
  double length() const;
  /// Arcs of more than a degree.
  int turns() const;
  /// Its corners as a machine drives them in straight steps: where it begins, places on each arc
  /// that are `most_deg` or less of it apart, where it ends. The headings are those of the way.
  std::vector<Heading> corners(double most_deg) const;
};

/// The way of a word from one place and heading to another; nothing where the word does not join
/// them. After L. E. Dubins, "On curves of minimal length with a constraint on average curvature",
/// American Journal of Mathematics 79, 1957; found by the circles that the arcs lie on.
std::optional<DubinsWay> dubins_way(DubinsWord word, const Heading& from, const Heading& to,
                                    double radius);

/// All of them, the shortest first; of equal ones that whose word stands first.
std::vector<DubinsWay> dubins_ways(const Heading& from, const Heading& to, double radius);

}  // namespace rubicon::coverage
