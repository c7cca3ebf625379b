#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "src/motion/coverage/rectangles.hpp"

namespace rubicon::coverage {

/// The pairs (i, j) where cut i along x meets cut j along y, ends included; in order.
std::vector<std::pair<int, int>> crossings(std::span<const Cut> along_x,
                                           std::span<const Cut> along_y);

enum class LineKind {
  kBorder,  ///< an edge of the floor, which is on its left
  kInner,   ///< floor on both sides
};

/// A line of a drawing, parallel to an axis.
struct Line {
  Point a;
  Point b;
  LineKind kind = LineKind::kInner;
  int owner = -1;  ///< any number
};

/// A piece of a line between two nodes that follow each other.
struct Piece {
  int from = 0;  ///< nodes; from the lower or left one
  int to = 0;
  bool is_border = false;
  /// Floor is on the left, on the right, going from `from` to `to`.
  bool floor_left = true;
  bool floor_right = true;
  std::vector<int> owners;  ///< of the lines that have this piece, -1 left out; ascending
  int loop_left = -1;       ///< -1: the piece ends in the middle of a face and bounds none
  int loop_right = -1;
};

/// A closed line round a face, the face on its left: counter-clockwise round its outside, clockwise
/// round whatever lies in it without contact.
struct Loop {
  Ring ring;                ///< without corners on the line of their neighbours
  std::vector<int> pieces;  ///< in order
  bool is_outside = false;  ///< not floor
  std::int64_t twice_area = 0;
};

/// What lines parallel to the axes part the plane into.
class Subdivision {
 public:
  explicit Subdivision(std::span<const Line> lines);

  const std::vector<Point>& nodes() const { return nodes_; }
  const std::vector<Piece>& pieces() const { return pieces_; }
  const std::vector<Loop>& loops() const { return loops_; }
  /// The pieces that leave a node to the east, north, west and south; -1 for none.
  const std::array<int, 4>& pieces_at(int node) const {
    return pieces_at_[static_cast<std::size_t>(node)];
  }

 private:
  void cut_up(std::span<const Line> lines);
  void prune();
  bool trace();

  std::vector<Point> nodes_;
  std::vector<Piece> pieces_;
  std::vector<std::array<int, 4>> pieces_at_;
  std::vector<std::array<int, 4>> bounding_;  ///< the same without pieces that bound no face
  std::vector<Loop> loops_;
};

}  // namespace rubicon::coverage
