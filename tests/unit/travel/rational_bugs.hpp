#pragma once

#include <string>
#include <vector>

#include "src/motion/travel/ring.hpp"

namespace rubicon::travel {

/// What the oracle found: Bug1 and Bug2 written once more, plainly, with every decision made by
/// fractions of whole numbers of any size. Only lengths are rounded.
struct OracleResult {
  bool reached = false;
  double length = 0;
};

/// The start lies in free space, off every border.
OracleResult rational_bug1(const std::vector<Ring>& rings, const LatticePoint& start,
                           const LatticePoint& destination);
OracleResult rational_bug2(const std::vector<Ring>& rings, const LatticePoint& start,
                           const LatticePoint& destination);
/// The lengths of the loops of the outline, ascending.
std::vector<double> rational_loops(const std::vector<Ring>& rings);

/// The length of the shortest way from start to destination, by all ways over all corners, of
/// obstacles that are apart from one another; negative: there is none.
double rational_shortest(const std::vector<Ring>& rings, const LatticePoint& start,
                         const LatticePoint& destination);

}  // namespace rubicon::travel
