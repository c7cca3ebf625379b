#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "src/motion/coverage/floor.hpp"
#include "src/motion/coverage/region.hpp"

namespace rubicon::coverage {

/// What stands on a floor, in the plan view.
struct Standing {
  std::string name;             ///< for people; may be empty
  Ring ring;                    ///< counter-clockwise; of a round one unused
  bool round = false;           ///< a circle
  Place centre;                 ///< of a circle, m
  double diameter = 0;          ///< m
  std::string kind = "column";  ///< for people: "wall"
};

/// A standing thing of a closed line: round where all of its corners, eight or more, are equally
/// far from their middle, within 3 %.
Standing standing_of(std::string name, Ring ring);

/// What is known of floors in the plan view.
struct FloorParts {
  std::vector<Region> slabs;
  std::vector<ShaftDescription> shafts;
  std::vector<Standing> columns;
  std::vector<BeamDescription> beams;
};

struct MadeFloor {
  FloorDescription floor;
  double slab = 0;  ///< m2; outline less shafts
};

/// A floor for each slab, the largest first. Shafts are cut out of slabs. Columns that are squares
/// along the axes, or round, and stand clear of borders become columns; others are cut out of the
/// slab. Beams are those of a slab in whose outline their middle lies. Shafts that belong to no
/// slab, and slabs of less than kLeastSlab, are told in `notes`; the places in `columns` of those
/// that belong to none are in `outside`.
std::vector<MadeFloor> make_floors(const FloorParts& parts, std::vector<std::string>& notes,
                                   std::vector<std::size_t>& outside);

/// Without what is told of it.
std::vector<MadeFloor> make_floors(const FloorParts& parts);

/// "column 'c 7' lies outside of every slab".
std::string text_of_outside(const Standing& thing);

/// m2
inline constexpr double kLeastSlab = 0.1;

}  // namespace rubicon::coverage
