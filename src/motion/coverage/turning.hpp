#pragma once

#include <optional>
#include <vector>

#include "src/motion/coverage/cells.hpp"
#include "src/motion/coverage/dubins.hpp"
#include "src/motion/coverage/lines.hpp"

namespace rubicon::coverage {

/// A way of a machine that turns with a radius and does not go back, over the lines of a floor.
struct TurningQuery {
  const std::vector<WorkLine>* lines = nullptr;  ///< in an order that is short for one that turns
                                                 ///< on the spot
  const std::vector<Cell>* cells = nullptr;
  const FreeSpace* space = nullptr;
  std::int64_t width = 0;  ///< units; of a strip
  double radius = 0;       ///< m
  int tries = 0;           ///< random changes of the order at the end
  std::optional<Point> from;
  std::optional<Point> inlet;  ///< the way begins at the line's end that is farthest from it
};

/// A place of such a way; `working` tells of the stretch that leads to it.
struct TurningPoint {
  Heading at;
  bool working = false;
};

struct TurningResult {
  std::vector<TurningPoint> points;
  std::vector<WorkLine> lines;  ///< as they are driven, and in this direction
  double length = 0;            ///< m; exact, arcs as arcs
  int turns = 0;                ///< arcs
  int cut_off = 0;              ///< lines that are left out: no turn leads to them
};

/// Lines are cut back at their ends until a quarter of a circle leads away from there on allowed
/// floor, to both sides where that costs less than a radius; what wide fronts of such ends leave
/// out is worked by lines across them. Then the order for a short way: between two lines the
/// shortest of the six words of Dubins that stays where the tool's point may be. First orders leave
/// out as many lines as two radii are wide, there and back; 2-opt, or-opt and random changes
/// follow.
TurningResult plan_turning(const TurningQuery& query);

/// Degrees: an arc is driven in straight steps that turn by no more.
inline constexpr double kTurnStep_deg = 10;

}  // namespace rubicon::coverage
