#include "src/motion/coverage/hypergraph.hpp"

#include <map>
#include <stdexcept>

#include "src/motion/coverage/subdivision.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::coverage {
namespace {

using math::at;

/// Whether a point of doubled coordinates lies inside doubled rings.
bool in_slab(const std::vector<Ring>& doubled, const Point& p) {
  if (place_in(doubled[0], p) <= 0) return false;
  for (std::size_t i = 1; i < doubled.size(); ++i) {
    if (place_in(doubled[i], p) >= 0) return false;
  }
  return true;
}

/// The parts of a beam that run inside the slab, its edges left out.
std::vector<Line> parts_inside(const BeamLine& beam, const std::vector<Ring>& rings,
                               const std::vector<Ring>& doubled) {
  const bool along_x = beam.from.y == beam.to.y;
  const Box box = box_of(beam.from, beam.to);
  const std::int64_t level = along_x ? box.low.y : box.low.x;
  std::vector<std::int64_t> marks{along_x ? box.low.x : box.low.y,
                                  along_x ? box.high.x : box.high.y};
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point& a = ring[i];
      const Point& b = next_corner(ring, i);
      if (!segments_meet(a, b, box.low, box.high)) continue;
      for (const Point& p : {a, b}) {
        // A corner on the beam's line, or where an edge across crosses it.
        const std::int64_t mark = along_x ? p.x : p.y;
        if (marks[0] < mark && mark < marks[1]) marks.push_back(mark);
      }
    }
  }
  std::sort(marks.begin(), marks.end());
  std::vector<Line> result;
  for (std::size_t i = 1; i < marks.size(); ++i) {
    if (marks[i - 1] == marks[i]) continue;
    const std::int64_t middle = marks[i - 1] + marks[i];  // doubled
    if (!in_slab(doubled, along_x ? Point{middle, 2 * level} : Point{2 * level, middle})) continue;
    const auto place = [&](std::int64_t along) {
      return along_x ? Point{along, level} : Point{level, along};
    };
    result.push_back({place(marks[i - 1]), place(marks[i]), LineKind::kInner, beam.number});
  }
  return result;
}

}  // namespace

std::vector<Ring> slab_rings(const Floor& floor) {
  std::vector<Ring> rings{floor.outline};
  for (const Hole& hole : floor.holes) {
    if (!hole.is_shaft) continue;
    rings.push_back(hole.ring);
    std::reverse(rings.back().begin(), rings.back().end());
  }
  return rings;
}

Hypergraph hypergraph_of(const Floor& floor, double clearance) {
  const std::vector<Ring> rings = slab_rings(floor);
  std::vector<Line> lines;
  for (const Ring& ring : rings) {
    if (!is_orthogonal(ring)) {
      throw std::invalid_argument(
          "the outline or a shaft has an edge that is parallel to neither x nor y: such a floor "
          "cannot be parted along beams");
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
      lines.push_back({ring[i], next_corner(ring, i), LineKind::kBorder, -1});
    }
  }
  std::vector<Ring> doubled = rings;
  for (Ring& ring : doubled) {
    for (Point& p : ring) p = {2 * p.x, 2 * p.y};
  }
  for (const BeamLine& beam : floor.beams) {
    if (beam.from.x != beam.to.x && beam.from.y != beam.to.y) {
      throw std::invalid_argument("a beam is parallel to neither x nor y");
    }
    for (const Line& line : parts_inside(beam, rings, doubled)) lines.push_back(line);
  }
  const Subdivision subdivision(lines);

  Hypergraph graph;
  graph.nodes = subdivision.nodes();
  const std::int64_t grown = in_units(clearance);
  std::map<int, std::vector<int>> beams;
  for (std::size_t i = 0; i < subdivision.pieces().size(); ++i) {
    const Piece& piece = subdivision.pieces()[i];
    BeamPiece result{piece.from, piece.to, piece.is_border, piece.owners, {}};
    for (const Hole& hole : floor.holes) {
      if (hole.is_shaft) continue;
      Box box = box_of(hole.ring);
      box = {{box.low.x - grown, box.low.y - grown}, {box.high.x + grown, box.high.y + grown}};
      if (enters_convex(box.ring(), graph.nodes[at(piece.from)], graph.nodes[at(piece.to)])) {
        result.columns.push_back(hole.number);
      }
    }
    for (const int beam : piece.owners) beams[beam].push_back(static_cast<int>(i));
    graph.pieces.push_back(std::move(result));
  }
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    std::array<int, 4> next{};
    for (std::size_t k = 0; k < 4; ++k) {
      const int number = subdivision.pieces_at(static_cast<int>(i))[k];
      next[k] = -1;
      if (number < 0) continue;
      const Piece& piece = subdivision.pieces()[at(number)];
      next[k] = piece.from == static_cast<int>(i) ? piece.to : piece.from;
    }
    graph.neighbours.push_back(next);
  }
  for (auto& [beam, pieces] : beams) graph.beams.push_back({beam, std::move(pieces)});

  // Faces: what goes round counter-clockwise; the rest lies in the smallest of them round it.
  std::vector<const Loop*> islands;
  std::vector<std::int64_t> areas;
  for (const Loop& loop : subdivision.loops()) {
    if (loop.is_outside) continue;
    if (loop.twice_area < 0) {
      islands.push_back(&loop);
      continue;
    }
    graph.faces.push_back({loop.ring, {}, loop.pieces});
    areas.push_back(loop.twice_area);
  }
  for (const Loop* island : islands) {
    std::size_t best = graph.faces.size();
    for (std::size_t i = 0; i < graph.faces.size(); ++i) {
      if (areas[i] <= -island->twice_area) continue;
      if (place_in(graph.faces[i].outline, island->ring[0]) <= 0) continue;
      if (best == graph.faces.size() || areas[i] < areas[best]) best = i;
    }
    if (best == graph.faces.size()) continue;
    SlabFace& face = graph.faces[best];
    face.islands.push_back(island->ring);
    face.pieces.insert(face.pieces.end(), island->pieces.begin(), island->pieces.end());
  }
  return graph;
}

}  // namespace rubicon::coverage
