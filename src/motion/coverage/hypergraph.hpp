#pragma once

#include <array>
#include <vector>

#include "src/motion/coverage/floor.hpp"

namespace rubicon::coverage {

/// A piece of a beam or of an edge of the floor between two nodes that follow each other.
struct BeamPiece {
  int from = 0;  ///< nodes; from the lower or left one
  int to = 0;
  bool is_edge = false;      ///< of the outline or a shaft
  std::vector<int> beams;    ///< numbers of beams that have it
  std::vector<int> columns;  ///< numbers of columns that, grown, obstruct it
};

/// A face of the slab between beams.
struct SlabFace {
  Ring outline;               ///< counter-clockwise
  std::vector<Ring> islands;  ///< clockwise: what lies in it and touches no beam of its border
  std::vector<int> pieces;    ///< of its outline and of its islands: the hyperedge
};

/// The pieces of one beam, in order: a hyperedge too.
struct BeamEdge {
  int beam = 0;
  std::vector<int> pieces;
};

/// Beams and slab faces of an orthogonal floor as a hypergraph (V, E, H): nodes where beams and
/// edges meet, pieces between them, and as hyperedges the pieces round each face and those along
/// each beam (PLANNERS: Kunigahalli, Russell, Skibniewski on concrete placement).
struct Hypergraph {
  std::vector<Point> nodes;
  /// Of each node: the next one to the east, north, west and south; -1 for none.
  std::vector<std::array<int, 4>> neighbours;
  std::vector<BeamPiece> pieces;
  std::vector<SlabFace> faces;
  std::vector<BeamEdge> beams;
};

/// Of a floor whose outline, shafts and beams are parallel to the axes. Beams are cut off where
/// they leave the floor; one that ends inside a face bounds none. Throws std::invalid_argument for
/// others. `clearance` in m: how far columns are grown.
Hypergraph hypergraph_of(const Floor& floor, double clearance);

/// The rings of a floor with the slab on their left: outline, then shafts clockwise.
std::vector<Ring> slab_rings(const Floor& floor);

}  // namespace rubicon::coverage
