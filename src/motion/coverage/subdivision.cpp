#include "src/motion/coverage/subdivision.hpp"

#include <map>
#include <set>

#include "src/motion/math/index.hpp"

namespace rubicon::coverage {
namespace {

using math::at;

constexpr int kEast = 0;
constexpr int kNorth = 1;

/// A line seen along its own axis: its level across, its range, its number.
struct Span {
  std::int64_t low;
  std::int64_t high;
  std::size_t line;
};

}  // namespace

std::vector<std::pair<int, int>> crossings(std::span<const Cut> along_x,
                                           std::span<const Cut> along_y) {
  enum Kind { kBegin, kAsk, kEnd };
  struct Happening {
    std::int64_t x;
    int kind;
    std::size_t index;
    auto operator<=>(const Happening&) const = default;
  };
  std::vector<Happening> order;
  for (std::size_t i = 0; i < along_x.size(); ++i) {
    order.push_back({std::min(along_x[i].a.x, along_x[i].b.x), kBegin, i});
    order.push_back({std::max(along_x[i].a.x, along_x[i].b.x), kEnd, i});
  }
  for (std::size_t j = 0; j < along_y.size(); ++j) order.push_back({along_y[j].a.x, kAsk, j});
  std::sort(order.begin(), order.end());
  std::set<std::pair<std::int64_t, std::size_t>> active;
  std::vector<std::pair<int, int>> result;
  for (const Happening& event : order) {
    if (event.kind == kAsk) {
      const Cut& cut = along_y[event.index];
      const std::int64_t low = std::min(cut.a.y, cut.b.y);
      const std::int64_t high = std::max(cut.a.y, cut.b.y);
      for (auto it = active.lower_bound({low, 0}); it != active.end() && it->first <= high; ++it) {
        result.emplace_back(static_cast<int>(it->second), static_cast<int>(event.index));
      }
    } else if (event.kind == kBegin) {
      active.emplace(along_x[event.index].a.y, event.index);
    } else {
      active.erase({along_x[event.index].a.y, event.index});
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

Subdivision::Subdivision(std::span<const Line> lines) {
  cut_up(lines);
  bounding_ = pieces_at_;
  prune();
  // A piece with the same face on both sides is no border of it: without it, again.
  while (trace()) prune();
}

void Subdivision::cut_up(std::span<const Line> lines) {
  std::vector<Cut> cuts[2];
  std::vector<std::size_t> numbers[2];
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const int axis = lines[i].a.y == lines[i].b.y ? 0 : 1;
    cuts[axis].push_back({lines[i].a, lines[i].b});
    numbers[axis].push_back(i);
  }
  // Where each level of lines is cut: at the ends of its lines and where others meet one.
  std::map<std::int64_t, std::vector<std::int64_t>> marks[2];
  std::map<std::int64_t, std::vector<Span>> spans[2];
  for (int axis = 0; axis < 2; ++axis) {
    for (std::size_t k = 0; k < cuts[axis].size(); ++k) {
      const Box box = box_of(cuts[axis][k].a, cuts[axis][k].b);
      const std::int64_t level = axis == 0 ? box.low.y : box.low.x;
      const std::int64_t low = axis == 0 ? box.low.x : box.low.y;
      const std::int64_t high = axis == 0 ? box.high.x : box.high.y;
      marks[axis][level].insert(marks[axis][level].end(), {low, high});
      spans[axis][level].push_back({low, high, numbers[axis][k]});
    }
  }
  for (const auto& [i, j] : crossings(cuts[0], cuts[1])) {
    const Point p{cuts[1][at(j)].a.x, cuts[0][at(i)].a.y};
    marks[0][p.y].push_back(p.x);
    marks[1][p.x].push_back(p.y);
  }
  std::map<Point, int> node_of;
  const auto node = [&](int axis, std::int64_t level, std::int64_t along) {
    const Point p = axis == 0 ? Point{along, level} : Point{level, along};
    const auto [found, is_new] = node_of.try_emplace(p, static_cast<int>(nodes_.size()));
    if (is_new) {
      nodes_.push_back(p);
      pieces_at_.push_back({-1, -1, -1, -1});
    }
    return found->second;
  };
  for (int axis = 0; axis < 2; ++axis) {
    for (auto& [level, places] : marks[axis]) {
      std::sort(places.begin(), places.end());
      places.erase(std::unique(places.begin(), places.end()), places.end());
      std::map<std::size_t, Piece> found;  // by the place it begins at
      for (const Span& span : spans[axis][level]) {
        const auto first = std::lower_bound(places.begin(), places.end(), span.low);
        for (auto it = first; *it < span.high; ++it) {
          Piece& piece = found[static_cast<std::size_t>(it - places.begin())];
          const Line& line = lines[span.line];
          if (line.kind == LineKind::kBorder) {
            piece.is_border = true;
            const bool forward = axis == 0 ? line.a.x < line.b.x : line.a.y < line.b.y;
            (forward ? piece.floor_right : piece.floor_left) = false;
          }
          if (line.owner >= 0) piece.owners.push_back(line.owner);
        }
      }
      for (auto& [index, piece] : found) {
        piece.from = node(axis, level, places[index]);
        piece.to = node(axis, level, places[index + 1]);
        std::sort(piece.owners.begin(), piece.owners.end());
        const int number = static_cast<int>(pieces_.size());
        const std::size_t direction = axis == 0 ? kEast : kNorth;
        pieces_at_[at(piece.from)][direction] = number;
        pieces_at_[at(piece.to)][direction + 2] = number;
        pieces_.push_back(std::move(piece));
      }
    }
  }
}

void Subdivision::prune() {
  std::vector<int> open;
  const auto degree = [&](int node) {
    return 4 - std::count(bounding_[at(node)].begin(), bounding_[at(node)].end(), -1);
  };
  for (std::size_t i = 0; i < nodes_.size(); ++i) open.push_back(static_cast<int>(i));
  while (!open.empty()) {
    const int node = open.back();
    open.pop_back();
    if (degree(node) != 1) continue;
    for (int& slot : bounding_[at(node)]) {
      if (slot < 0) continue;
      const Piece& piece = pieces_[at(slot)];
      const int other = piece.from == node ? piece.to : piece.from;
      const int number = slot;
      slot = -1;
      for (int& back : bounding_[at(other)]) {
        if (back == number) back = -1;
      }
      open.push_back(other);
    }
  }
}

/// Goes round every face; true where it took out a piece that has one face on both sides.
bool Subdivision::trace() {
  loops_.clear();
  for (Piece& piece : pieces_) piece.loop_left = piece.loop_right = -1;
  for (std::size_t start = 0; start < nodes_.size(); ++start) {
    for (int first = 0; first < 4; ++first) {
      int direction = first;
      int number = bounding_[start][at(direction)];
      if (number < 0) continue;
      if ((direction < 2 ? pieces_[at(number)].loop_left : pieces_[at(number)].loop_right) >= 0) {
        continue;
      }
      Loop loop;
      const int loop_number = static_cast<int>(loops_.size());
      Ring corners;
      std::vector<int> turns;
      while (true) {
        Piece& piece = pieces_[at(number)];
        const bool forward = direction < 2;
        int& side = forward ? piece.loop_left : piece.loop_right;
        if (side >= 0) break;  // round
        side = loop_number;
        loop.pieces.push_back(number);
        loop.is_outside = loop.is_outside || !(forward ? piece.floor_left : piece.floor_right);
        const int from = forward ? piece.from : piece.to;
        corners.push_back(nodes_[at(from)]);
        turns.push_back(direction);
        const int to = forward ? piece.to : piece.from;
        for (const int turn : {1, 0, 3, 2}) {  // the leftmost way on keeps the face on the left
          const int way = (direction + turn) % 4;
          number = bounding_[at(to)][at(way)];
          if (number < 0) continue;
          direction = way;
          break;
        }
      }
      for (std::size_t i = 0; i < corners.size(); ++i) {
        if (turns[i] != turns[i > 0 ? i - 1 : turns.size() - 1]) loop.ring.push_back(corners[i]);
      }
      loop.twice_area = coverage::twice_area(loop.ring);
      loops_.push_back(std::move(loop));
    }
  }
  bool removed = false;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    for (int& slot : bounding_[i]) {
      if (slot < 0) continue;
      const Piece& piece = pieces_[at(slot)];
      if (piece.is_border || piece.loop_left != piece.loop_right) continue;
      slot = -1;
      removed = true;
    }
  }
  return removed;
}

}  // namespace rubicon::coverage
