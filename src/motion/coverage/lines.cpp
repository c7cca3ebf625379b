#include "src/motion/coverage/lines.hpp"

#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>

#include "src/motion/math/index.hpp"

namespace rubicon::coverage {
namespace {

using math::at;

/// A border whose slope leaves out less than this at the end of a line needs no pass: 1 mm.
constexpr std::int64_t kLeastSlope = kUnitsPerMetre / 1000;
/// Passes along a border are cut where it turns by more than this: the cosine of 30 degrees.
constexpr double kSharpTurn = 0.8660254;

std::int64_t count_in(std::int64_t height, std::int64_t width) {
  return std::max<std::int64_t>((height + width - 1) / width, 1);
}

/// The line along x of a cell, and the band that it works.
struct Band {
  std::int64_t y;
  std::int64_t low;
  std::int64_t high;
};

/// A pass across the lines, beside an obstacle.
struct SidePass {
  std::int64_t x;
  Stretch range;        ///< along y
  std::int64_t reach;   ///< lines that come from the left (right) end here
  bool is_left;         ///< of the obstacle
  std::int64_t border;  ///< of the grown obstacle on this side
};

class CellLines {
 public:
  CellLines(const Cell& cell, int number, const FreeSpace& space, std::int64_t width,
            std::vector<WorkLine>& result)
      : cell_(cell), number_(number), space_(space), width_(width), result_(result) {
    const std::int64_t height = cell.top - cell.bottom;
    const std::int64_t count = count_in(height, width);
    for (std::int64_t k = 0; k < count; ++k) {
      bands_.push_back({cell.bottom + (2 * k + 1) * height / (2 * count),
                        cell.bottom + k * height / count, cell.bottom + (k + 1) * height / count});
    }
  }

  void run() {
    const Box box = box_of(cell_.ring());
    std::vector<int> near;
    space_.for_each_near(box, [&](int item) { near.push_back(item); });
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (const int item : near) {
      if (space_.obstacles()[at(item)].is_box) pass_by(space_.obstacles()[at(item)]);
    }
    for (const Band& band : bands_) add_lines(band);
    for (const WorkLine& pass : passes_) result_.push_back(pass);
  }

 private:
  void add_pass(const Point& a, const Point& b) { passes_.push_back({{a, b}, number_, true}); }

  /// Passes round the part of an obstacle's surroundings that lines of this cell leave out.
  void pass_by(const Obstacle& obstacle) {
    const Box& grown = obstacle.grown_box;
    const Box& body = obstacle.body;
    std::int64_t low = cell_.top;
    std::int64_t high = cell_.bottom;
    std::int64_t cell_left = grown.high.x;
    std::int64_t cell_right = grown.low.x;
    for (const Band& band : bands_) {
      if (band.y <= grown.low.y || band.y >= grown.high.y) continue;
      const std::int64_t left = cell_.left_at(band.y);
      const std::int64_t right = cell_.right_at(band.y);
      if (left >= grown.high.x || right <= grown.low.x) continue;
      low = std::min(low, band.low);
      high = std::max(high, band.high);
      cell_left = std::min(cell_left, left);
      cell_right = std::max(cell_right, right);
    }
    if (low >= high) return;
    const std::int64_t half = width_ / 2;
    const bool over = high > body.high.y;  // something to be worked above the obstacle itself
    const bool under = low < body.low.y;
    const std::int64_t body_left = std::clamp(body.low.x, cell_left, cell_right);
    const std::int64_t body_right = std::clamp(body.high.x, cell_left, cell_right);
    // As far from the obstacle as still works up to it, so that lines end early; but where two
    // passes, one on each side, can work what is above and below it too, near enough for that.
    const bool joins = (over || under) && grown.width() <= width_;
    const std::int64_t middle = (grown.low.x + grown.high.x) / 2;
    std::int64_t x_left = joins ? std::max(body_left - half, middle - half) : body_left - half;
    std::int64_t x_right = joins ? std::min(body_right + half, middle + half) : body_right + half;
    x_left = std::min(std::max(x_left, cell_left), grown.low.x);
    x_right = std::max(std::min(x_right, cell_right), grown.high.x);
    const bool has_left = grown.low.x >= cell_left && body_left > cell_left;
    const bool has_right = grown.high.x <= cell_right && body_right < cell_right;
    if (has_left) add_side(x_left, low, high, grown.low.x, true);
    if (has_right) add_side(x_right, low, high, grown.high.x, false);
    const std::int64_t from = has_left ? std::max(x_left + half, cell_left) : cell_left;
    const std::int64_t to = has_right ? std::min(x_right - half, cell_right) : cell_right;
    const std::int64_t gap_from = std::max(from, grown.low.x);
    const std::int64_t gap_to = std::min(to, grown.high.x);
    if (gap_from >= gap_to) return;
    if (over) add_across(grown.high.y, gap_from, gap_to);
    if (under) add_across(grown.low.y, gap_from, gap_to);
  }

  /// At x, or right at the obstacle where something else is in the way there, or both in parts.
  void add_side(std::int64_t x, std::int64_t low, std::int64_t high, std::int64_t border,
                bool is_left) {
    const auto is_whole = [&](const std::vector<Stretch>& ranges) {
      return ranges.size() == 1 && ranges[0].low == low && ranges[0].high == high;
    };
    const std::vector<Stretch> far = space_.stretches_along_y(x, low, high);
    if (is_whole(far) || x == border) return add_sides(x, far, border, is_left);
    const std::vector<Stretch> near = space_.stretches_along_y(border, low, high);
    if (!is_whole(near)) add_sides(x, far, border, is_left);
    add_sides(border, near, border, is_left);
  }

  void add_sides(std::int64_t x, const std::vector<Stretch>& ranges, std::int64_t border,
                 bool is_left) {
    for (const Stretch& range : ranges) {
      const Point a{x, range.low};
      const Point b{x, range.high};
      if (!space_.allows(a) || !space_.sees(a, b)) continue;
      add_pass(a, b);
      const std::int64_t reach = is_left ? x - width_ / 2 : x + width_ / 2;
      sides_.push_back({x, range, reach, is_left, border});
    }
  }

  void add_across(std::int64_t y, std::int64_t low, std::int64_t high) {
    for (const Stretch& range : space_.stretches_along_x(y, low, high)) {
      const Point a{range.low, y};
      const Point b{range.high, y};
      if (space_.allows(a) && space_.sees(a, b)) add_pass(a, b);
    }
  }

  void add_lines(const Band& band) {
    const std::int64_t left = cell_.left_at(band.y);
    const std::int64_t right = cell_.right_at(band.y);
    if (left >= right) return;
    for (Stretch stretch : space_.stretches_along_x(band.y, left, right)) {
      for (const SidePass& side : sides_) {
        if (side.range.low > band.low || side.range.high < band.high) continue;
        if (side.is_left && stretch.high == side.border) {
          stretch.high = std::min(stretch.high, side.reach);
        }
        if (!side.is_left && stretch.low == side.border) {
          stretch.low = std::max(stretch.low, side.reach);
        }
      }
      if (stretch.low >= stretch.high) continue;
      result_.push_back({{{stretch.low, band.y}, {stretch.high, band.y}}, number_, false});
    }
  }

  const Cell& cell_;
  int number_;
  const FreeSpace& space_;
  std::int64_t width_;
  std::vector<WorkLine>& result_;
  std::vector<Band> bands_;
  std::vector<SidePass> sides_;
  std::vector<WorkLine> passes_;
};

/// The allowed place next to p, at most a unit away in x and in y.
std::optional<Point> nudged(const FreeSpace& space, const Point& p) {
  for (int ring = 0; ring <= 2; ++ring) {
    for (std::int64_t x = -2; x <= 2; ++x) {
      for (std::int64_t y = -2; y <= 2; ++y) {
        if (std::max(std::abs(x), std::abs(y)) != ring) continue;
        if (space.allows({p.x + x, p.y + y})) return Point{p.x + x, p.y + y};
      }
    }
  }
  return std::nullopt;
}

/// Passes along the edges a to b of a border that follow each other, cut where obstacles are.
class BorderPasses {
 public:
  BorderPasses(const FreeSpace& space, int cell, std::vector<WorkLine>& result, bool on_outline)
      : space_(space), cell_(cell), result_(result), on_outline_(on_outline) {}
  ~BorderPasses() { finish(); }
  BorderPasses(const BorderPasses&) = delete;
  BorderPasses& operator=(const BorderPasses&) = delete;

  void add(const Point& a, const Point& b) {
    if (is_free(a) && is_free(b) && space_.sees(a, b)) {
      if (!points_.empty() && (points_.back() != a || is_sharp(b))) finish();
      if (points_.empty()) points_.push_back(a);
      points_.push_back(b);
      return;
    }
    finish();
    // Halve it until what is left is free or shorter than 5 cm.
    if (distance(a, b) < 0.05 * static_cast<double>(kUnitsPerMetre)) return;
    const std::optional<Point> middle = nudged(space_, {(a.x + b.x) / 2, (a.y + b.y) / 2});
    // The middle, rounded, may lie just off the floor: not on the outline any more.
    const Point m = middle.value_or(Point{(a.x + b.x) / 2, (a.y + b.y) / 2});
    if (m == a || m == b) return;
    const bool kept = std::exchange(on_outline_, false);
    add(a, m);
    add(m, b);
    on_outline_ = kept;
  }
  void finish() {
    if (points_.size() > 1) result_.push_back({points_, cell_, true});
    points_.clear();
  }

 private:
  /// Corners of the outline lie on the floor; those of an obstacle may lie outside.
  bool is_free(const Point& p) const { return on_outline_ ? space_.is_clear(p) : space_.allows(p); }
  bool is_sharp(const Point& next) const {
    const Point& before = points_[points_.size() - 2];
    const Point& p = points_.back();
    const Point on{p.x + (p.x - before.x), p.y + (p.y - before.y)};
    return static_cast<double>(dot(p, on, next)) < kSharpTurn * distance(p, on) * distance(p, next);
  }

  const FreeSpace& space_;
  int cell_;
  std::vector<WorkLine>& result_;
  bool on_outline_;
  std::vector<Point> points_;
};

/// Whether lines along x end at this edge so that they leave out a triangle that counts.
bool needs_pass(const Point& a, const Point& b, std::int64_t width) {
  if (a.x == b.x || a.y == b.y) return false;
  const double slope =
      static_cast<double>(std::abs(b.x - a.x)) / static_cast<double>(std::abs(b.y - a.y));
  return slope * static_cast<double>(width) / 2 > static_cast<double>(kLeastSlope);
}

}  // namespace

std::int64_t count_lines(const std::vector<Cell>& cells, std::int64_t width) {
  std::int64_t count = 0;
  for (const Cell& cell : cells) count += count_in(cell.top - cell.bottom, width);
  return count;
}

std::vector<WorkLine> lines_of(const std::vector<Cell>& cells, const Ring& outline,
                               const FreeSpace& space, std::int64_t width) {
  // Which cell a slanted edge belongs to: the lowest number of those that have it.
  std::map<std::pair<Point, Point>, int> owner;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (const auto* chain : {&cells[i].left, &cells[i].right}) {
      for (const Side& side : *chain) {
        owner.try_emplace({side.low, side.high}, static_cast<int>(i));
      }
    }
  }
  std::vector<std::vector<WorkLine>> passes(cells.size());
  const auto add_border = [&](const Ring& ring, auto cell_of_edge) {
    std::optional<BorderPasses> run;
    int last = -1;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point& a = ring[i];
      const Point& b = next_corner(ring, i);
      const int cell = needs_pass(a, b, width) ? cell_of_edge(a, b) : -1;
      if (cell != last) run.reset();
      last = cell;
      if (cell < 0) continue;
      if (!run) run.emplace(space, cell, passes[at(cell)], true);
      run->add(a, b);
    }
  };
  add_border(outline, [&](const Point& a, const Point& b) {
    const auto found = owner.find(a.y < b.y ? std::pair(a, b) : std::pair(b, a));
    return found == owner.end() ? -1 : found->second;
  });
  // Obstacles that are no boxes are gone round; their passes belong to the first cell they touch.
  std::vector<int> cell_of_obstacle(space.obstacles().size(), -1);
  for (std::size_t i = cells.size(); i-- > 0;) {
    space.for_each_near(box_of(cells[i].ring()),
                        [&](int item) { cell_of_obstacle[at(item)] = static_cast<int>(i); });
  }
  for (std::size_t i = 0; i < space.obstacles().size(); ++i) {
    const Obstacle& obstacle = space.obstacles()[i];
    const int cell = cell_of_obstacle[i];
    if (obstacle.is_box || cell < 0) continue;
    BorderPasses run(space, cell, passes[at(cell)], false);
    for (std::size_t k = 0; k < obstacle.grown.size(); ++k) {
      run.add(obstacle.grown[k], next_corner(obstacle.grown, k));
    }
  }
  std::vector<WorkLine> result;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    CellLines(cells[i], static_cast<int>(i), space, width, result).run();
    for (WorkLine& pass : passes[i]) result.push_back(std::move(pass));
  }
  return result;
}

}  // namespace rubicon::coverage
