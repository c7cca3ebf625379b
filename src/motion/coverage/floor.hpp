#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/motion/coverage/grid.hpp"

namespace rubicon::coverage {

/// An opening through the floor, for stairs or a lift: a polygon, corners in m in either sense.
struct ShaftDescription {
  std::string name;  ///< empty: known by its number
  std::vector<Place> corners;
};

/// What stands on the floor: a square parallel to the axes, or a round column.
struct ColumnDescription {
  std::string name;  ///< empty: known by its number
  Place centre;
  double size = 0;  ///< m; side of the square, or diameter
  bool round = false;
};

/// An edge of the hypergraph: the middle line of a beam below the slab.
struct BeamDescription {
  std::string name;  ///< empty: known by its number
  Place from;
  Place to;
};

/// A floor as users give it, plan view, m.
struct FloorDescription {
  std::vector<Place> outline;  ///< a polygon, in either sense
  std::vector<ShaftDescription> shafts;
  std::vector<ColumnDescription> columns;
  std::vector<BeamDescription> beams;
};

/// How a floor is cut into cells.
enum class Partition {
  kMinimum,  ///< into as few rectangles as can be; a floor that is not orthogonal at its corners
  kBeams,    ///< along beams, then as above where a face is no rectangle
};

/// How the order of cells is found.
enum class OrderRule {
  kAuto,         ///< exact up to 12 cells, else local search
  kExact,        ///< dynamic programming over sets of cells
  kLocalSearch,  ///< nearest next, then 2-opt and or-opt
};

/// In which direction lines run.
enum class LineRule {
  kShortest,     ///< each likely direction is planned; the one with the shortest way is taken
  kFewestTurns,  ///< the one with the fewest lines
  kAlongX,
  kAlongY,
};

struct CoverageOptions {
  double width = 1;        ///< m; of the tool, across its travel
  double clearance = 0;    ///< m; between the tool's own point and shafts and columns
  double turn_radius = 0;  ///< m; no turn of the way is narrower; 0: it turns on the spot
  Partition partition = Partition::kMinimum;
  OrderRule order = OrderRule::kAuto;
  LineRule lines = LineRule::kShortest;
  /// Every cell is finished before the next is begun, as a pour without cold joints wants it. Else
  /// lines of different cells may follow each other where that makes the way shorter.
  bool whole_cells = false;
  /// How many random changes of the order are tried at the end, from a fixed seed, where there are
  /// no more than 120 lines: counted work, so that every machine finds the same way.
  int tries = 1000;
  std::optional<Place> from;   ///< where the way begins; else where it is shortest
  std::optional<Place> inlet;  ///< where what is placed comes from: the way begins far from it
};

/// Everything that is wrong with a floor and the options for it, in words for users, things by
/// their name or their number from 1; empty: nothing.
std::vector<std::string> faults_of(const FloorDescription& floor, const CoverageOptions& options);

/// A hole of the floor, on the grid.
struct Hole {
  Ring ring;              ///< counter-clockwise; a round column's is the square around it
  bool is_shaft = false;  ///< else a column
  bool round = false;
  int number = 0;  ///< of the shaft or column in the description
};

struct BeamLine {
  Point from;
  Point to;
  int number = 0;
};

/// A checked floor on the grid. Corners on the line of their neighbours are left out.
struct Floor {
  Ring outline;
  std::vector<Hole> holes;  ///< shafts, then columns
  std::vector<BeamLine> beams;

  /// Twice the area of the outline less shafts, in square units.
  std::int64_t twice_area_of_slab() const;
};

/// Whether the rings of a floor are still simple and apart: turning one to another direction rounds
/// its corners.
bool is_sound(const Floor& floor);

/// The floor of a description without faults; throws std::invalid_argument with the first fault.
Floor make_floor(const FloorDescription& description, const CoverageOptions& options = {});

}  // namespace rubicon::coverage
