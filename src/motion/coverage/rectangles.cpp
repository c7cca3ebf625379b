#include "src/motion/coverage/rectangles.hpp"

#include <limits>
#include <map>
#include <set>

#include "src/motion/coverage/subdivision.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::coverage {
namespace {

using math::at;

/// A corner of more than 180 degrees; the directions in which the floor goes on beyond its edges.
struct ReflexCorner {
  Point p;
  int free_x = 0;
  int free_y = 0;
};

std::vector<ReflexCorner> reflex_corners(std::span<const Ring> rings) {
  const auto sign = [](std::int64_t value) { return value > 0 ? 1 : value < 0 ? -1 : 0; };
  std::vector<ReflexCorner> result;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point& before = corner_before(ring, i);
      const Point& p = ring[i];
      const Point& next = next_corner(ring, i);
      if (cross(before, p, next) >= 0) continue;
      const Point& along_x = before.y == p.y ? before : next;
      const Point& along_y = before.y == p.y ? next : before;
      result.push_back({p, sign(p.x - along_x.x), sign(p.y - along_y.y)});
    }
  }
  return result;
}

/// Something across the way of a shot: where along the shot, and its range, ends included.
struct Wall {
  std::int64_t along;
  std::int64_t low;
  std::int64_t high;
};
struct Shot {
  std::int64_t along;
  std::int64_t level;
  int direction;
};

/// Where each shot first meets a wall beyond its own place.
std::vector<std::int64_t> hits(const std::vector<Shot>& shots, const std::vector<Wall>& walls) {
  enum Kind { kBegin, kShot, kEnd };
  struct Happening {
    std::int64_t level;
    int kind;
    std::size_t index;
    auto operator<=>(const Happening&) const = default;
  };
  std::vector<Happening> order;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    order.push_back({walls[i].low, kBegin, i});
    order.push_back({walls[i].high, kEnd, i});
  }
  for (std::size_t i = 0; i < shots.size(); ++i) order.push_back({shots[i].level, kShot, i});
  std::sort(order.begin(), order.end());
  std::set<std::pair<std::int64_t, std::size_t>> active;
  std::vector<std::int64_t> result(shots.size(), 0);
  for (const Happening& event : order) {
    if (event.kind == kBegin) active.emplace(walls[event.index].along, event.index);
    if (event.kind == kEnd) active.erase({walls[event.index].along, event.index});
    if (event.kind != kShot) continue;
    const Shot& shot = shots[event.index];
    if (shot.direction > 0) {
      const auto hit = active.upper_bound({shot.along, std::numeric_limits<std::size_t>::max()});
      result[event.index] = hit == active.end() ? shot.along : hit->first;
    } else {
      const auto hit = active.lower_bound({shot.along, 0});
      result[event.index] = hit == active.begin() ? shot.along : std::prev(hit)->first;
    }
  }
  return result;
}

Wall across_x(const Point& a, const Point& b) {
  return {a.x, std::min(a.y, b.y), std::max(a.y, b.y)};
}
Wall across_y(const Point& a, const Point& b) {
  return {a.y, std::min(a.x, b.x), std::max(a.x, b.x)};
}

/// The largest set of chords without common points: 1 for each chord that is in it. `meets[i]` are
/// the chords along y that chord i along x meets. By a largest matching and Koenig's theorem; of
/// equal sets the one with most chords along x.
struct IndependentChords {
  std::vector<bool> along_x;
  std::vector<bool> along_y;
};

class ChordMatching {
 public:
  ChordMatching(std::vector<std::vector<int>> meets, std::size_t count_y)
      : meets_(std::move(meets)),
        met_by_(count_y),
        partner_of_x_(meets_.size(), -1),
        partner_of_y_(count_y, -1),
        seen_(count_y, 0) {
    for (std::size_t i = 0; i < meets_.size(); ++i) {
      for (const int j : meets_[i]) met_by_[at(j)].push_back(static_cast<int>(i));
    }
    for (std::size_t i = 0; i < meets_.size(); ++i) {
      ++round_;
      augment(static_cast<int>(i));
    }
  }

  IndependentChords chosen() const {
    // What an alternating way from an unmatched chord along y reaches.
    IndependentChords result{std::vector<bool>(meets_.size(), true),
                             std::vector<bool>(met_by_.size(), false)};
    std::vector<int> open;
    for (std::size_t j = 0; j < met_by_.size(); ++j) {
      if (partner_of_y_[j] >= 0) continue;
      result.along_y[j] = true;
      open.push_back(static_cast<int>(j));
    }
    while (!open.empty()) {
      const int j = open.back();
      open.pop_back();
      for (const int i : met_by_[at(j)]) {
        if (!result.along_x[at(i)]) continue;
        result.along_x[at(i)] = false;
        const int next = partner_of_x_[at(i)];
        if (result.along_y[at(next)]) continue;
        result.along_y[at(next)] = true;
        open.push_back(next);
      }
    }
    return result;
  }

 private:
  bool augment(int i) {
    for (const int j : meets_[at(i)]) {
      if (partner_of_y_[at(j)] < 0) return pair_up(i, j);
    }
    for (const int j : meets_[at(i)]) {
      if (seen_[at(j)] == round_) continue;
      seen_[at(j)] = round_;
      if (augment(partner_of_y_[at(j)])) return pair_up(i, j);
    }
    return false;
  }
  bool pair_up(int i, int j) {
    partner_of_x_[at(i)] = j;
    partner_of_y_[at(j)] = i;
    return true;
  }

  std::vector<std::vector<int>> meets_;
  std::vector<std::vector<int>> met_by_;
  std::vector<int> partner_of_x_;
  std::vector<int> partner_of_y_;
  std::vector<int> seen_;
  int round_ = 0;
};

struct Chord {
  int from = 0;  ///< reflex corners
  int to = 0;
};

}  // namespace

std::vector<Cut> cuts_of_fewest_rectangles(std::span<const Ring> rings) {
  const std::vector<ReflexCorner> corners = reflex_corners(rings);
  std::vector<Wall> walls_x;
  std::vector<Wall> walls_y;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point& a = ring[i];
      const Point& b = next_corner(ring, i);
      if (a.x == b.x) {
        walls_x.push_back(across_x(a, b));
      } else {
        walls_y.push_back(across_y(a, b));
      }
    }
  }
  std::map<Point, std::vector<int>> by_place;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    by_place[corners[i].p].push_back(static_cast<int>(i));
  }

  // Chords: from each corner that is open to the right (upwards) to the next one open to it.
  const auto find_chords = [&](bool along_x) {
    std::vector<int> shooters;
    std::vector<Shot> shots;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const ReflexCorner& corner = corners[i];
      if ((along_x ? corner.free_x : corner.free_y) < 0) continue;
      shooters.push_back(static_cast<int>(i));
      shots.push_back(along_x ? Shot{corner.p.x, corner.p.y, 1} : Shot{corner.p.y, corner.p.x, 1});
    }
    const std::vector<std::int64_t> ends = hits(shots, along_x ? walls_x : walls_y);
    std::vector<Chord> chords;
    for (std::size_t k = 0; k < shooters.size(); ++k) {
      const Point& p = corners[at(shooters[k])].p;
      const auto found = by_place.find(along_x ? Point{ends[k], p.y} : Point{p.x, ends[k]});
      if (found == by_place.end()) continue;
      for (const int other : found->second) {
        if ((along_x ? corners[at(other)].free_x : corners[at(other)].free_y) >= 0) continue;
        chords.push_back({shooters[k], other});
        break;
      }
    }
    return chords;
  };
  const std::vector<Chord> chords_x = find_chords(true);
  const std::vector<Chord> chords_y = find_chords(false);
  const auto cut_of = [&](const Chord& chord) {
    return Cut{corners[at(chord.from)].p, corners[at(chord.to)].p};
  };
  std::vector<Cut> cuts_x;
  std::vector<Cut> cuts_y;
  for (const Chord& chord : chords_x) cuts_x.push_back(cut_of(chord));
  for (const Chord& chord : chords_y) cuts_y.push_back(cut_of(chord));
  std::vector<std::vector<int>> meets(cuts_x.size());
  for (const auto& [i, j] : crossings(cuts_x, cuts_y)) meets[at(i)].push_back(j);
  const IndependentChords chosen = ChordMatching(std::move(meets), cuts_y.size()).chosen();

  std::vector<Cut> result;
  std::vector<bool> done(corners.size(), false);
  for (std::size_t i = 0; i < cuts_x.size(); ++i) {
    if (!chosen.along_x[i]) continue;
    done[at(chords_x[i].from)] = done[at(chords_x[i].to)] = true;
    result.push_back(cuts_x[i]);
  }
  for (std::size_t j = 0; j < cuts_y.size(); ++j) {
    if (!chosen.along_y[j]) continue;
    done[at(chords_y[j].from)] = done[at(chords_y[j].to)] = true;
    result.push_back(cuts_y[j]);
    walls_x.push_back(across_x(cuts_y[j].a, cuts_y[j].b));
  }
  std::vector<Shot> shots;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!done[i]) shots.push_back({corners[i].p.x, corners[i].p.y, corners[i].free_x});
  }
  const std::vector<std::int64_t> ends = hits(shots, walls_x);
  for (std::size_t k = 0; k < shots.size(); ++k) {
    result.push_back({{shots[k].along, shots[k].level}, {ends[k], shots[k].level}});
  }
  return result;
}

std::vector<Box> fewest_rectangles(std::span<const Ring> rings) {
  std::vector<Line> lines;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      lines.push_back({ring[i], next_corner(ring, i), LineKind::kBorder, -1});
    }
  }
  for (const Cut& cut : cuts_of_fewest_rectangles(rings)) {
    lines.push_back({cut.a, cut.b, LineKind::kInner, -1});
  }
  std::vector<Box> boxes;
  const Subdivision subdivision(lines);
  for (const Loop& loop : subdivision.loops()) {
    if (!loop.is_outside) boxes.push_back(box_of(loop.ring));
  }
  std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) {
    return std::pair(a.low.y, a.low.x) < std::pair(b.low.y, b.low.x);
  });
  return boxes;
}

}  // namespace rubicon::coverage
