#include "src/motion/coverage/measure.hpp"

#include <cmath>
#include <limits>

#include "src/motion/math/angles.hpp"

namespace rubicon::coverage {
namespace {

struct Interval {
  double low;
  double high;
};
using Intervals = std::vector<Interval>;

/// Sorted, without overlaps.
void unite(Intervals& intervals) {
  std::sort(intervals.begin(), intervals.end(),
            [](const Interval& a, const Interval& b) { return a.low < b.low; });
  std::size_t count = 0;
  for (const Interval& next : intervals) {
    if (next.high <= next.low) continue;
    if (count > 0 && next.low <= intervals[count - 1].high) {
      intervals[count - 1].high = std::max(intervals[count - 1].high, next.high);
    } else {
      intervals[count++] = next;
    }
  }
  intervals.resize(count);
}

double total(const Intervals& united) {
  double sum = 0;
  for (const Interval& interval : united) sum += interval.high - interval.low;
  return sum;
}

Intervals common(const Intervals& a, const Intervals& b) {
  Intervals result;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const double low = std::max(a[i].low, b[j].low);
    const double high = std::min(a[i].high, b[j].high);
    if (low < high) result.push_back({low, high});
    a[i].high < b[j].high ? ++i : ++j;
  }
  return result;
}

Intervals less(const Intervals& a, const Intervals& b) {
  Intervals result;
  std::size_t j = 0;
  for (Interval rest : a) {
    while (j < b.size() && b[j].high <= rest.low) ++j;
    for (std::size_t k = j; k < b.size() && b[k].low < rest.high; ++k) {
      if (b[k].low > rest.low) result.push_back({rest.low, b[k].low});
      rest.low = std::max(rest.low, b[k].high);
    }
    if (rest.low < rest.high) result.push_back(rest);
  }
  return result;
}

/// Corners moved as the planner moves them, so that both speak of the same floor.
std::vector<Place> on_grid(const std::vector<Place>& corners) {
  std::vector<Place> result;
  for (const Place& corner : corners) result.push_back(metres(snap(corner)));
  return result;
}

/// Where a line at y has the inside of a polygon.
Intervals inside_at(const std::vector<Place>& polygon, double y) {
  std::vector<double> crossings;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Place& a = polygon[i];
    const Place& b = polygon[(i + 1) % polygon.size()];
    if ((a.y <= y) == (b.y <= y)) continue;
    crossings.push_back(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
  }
  std::sort(crossings.begin(), crossings.end());
  Intervals result;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    result.push_back({crossings[i], crossings[i + 1]});
  }
  return result;
}

/// Where a line at y comes within `reach`, in x and in y, of a segment.
void add_near(const Place& a, const Place& b, double y, double reach, Intervals& result) {
  const Place& low = a.y <= b.y ? a : b;
  const Place& high = a.y <= b.y ? b : a;
  if (high.y <= y - reach || low.y >= y + reach) return;
  const auto x_at = [&](double level) {
    const double share = (level - low.y) / (high.y - low.y);
    return low.x + (high.x - low.x) * std::clamp(share, 0.0, 1.0);
  };
  const double x0 = high.y > low.y ? x_at(y - reach) : low.x;
  const double x1 = high.y > low.y ? x_at(y + reach) : high.x;
  result.push_back({std::min(x0, x1) - reach, std::max(x0, x1) + reach});
}

/// A shaft or a column.
struct Body {
  std::vector<Place> ring;  ///< empty: round
  Place centre;
  double radius = 0;

  Intervals at(double y, double grown) const {
    if (!ring.empty()) {
      Intervals result = inside_at(ring, y);
      if (grown > 0) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
          add_near(ring[i], ring[(i + 1) % ring.size()], y, grown, result);
        }
        unite(result);
      }
      return result;
    }
    const double off = std::max(std::abs(y - centre.y) - grown, 0.0);
    if (off >= radius) return {};
    const double half = std::sqrt(radius * radius - off * off) + grown;
    return {{centre.x - half, centre.x + half}};
  }
};

std::vector<Body> bodies_of(const FloorDescription& floor) {
  std::vector<Body> bodies;
  for (const ShaftDescription& shaft : floor.shafts) bodies.push_back({on_grid(shaft.corners), {}});
  for (const ColumnDescription& column : floor.columns) {
    const double half = column.size / 2;
    const Place c = column.centre;
    if (column.round) {
      bodies.push_back({{}, c, half});
    } else {
      bodies.push_back({on_grid({{c.x - half, c.y - half},
                                 {c.x + half, c.y - half},
                                 {c.x + half, c.y + half},
                                 {c.x - half, c.y + half}}),
                        {}});
    }
  }
  return bodies;
}

/// What the tool works over between two places: a rectangle.
struct Swath {
  std::vector<Place> corners;
  double low_y = 0;
  double high_y = 0;
};

std::vector<Swath> swaths_of(std::span<const WayPoint> way, double width) {
  std::vector<Swath> result;
  for (std::size_t i = 1; i < way.size(); ++i) {
    if (!way[i].working) continue;
    const Place& a = way[i - 1].place;
    const Place& b = way[i].place;
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double length = std::sqrt(dx * dx + dy * dy);
    if (length == 0) continue;
    const double half = width / 2 + kMeasureTolerance;
    const double nx = -dy / length * half;
    const double ny = dx / length * half;
    const double tx = dx / length * kMeasureTolerance;
    const double ty = dy / length * kMeasureTolerance;
    Swath swath{{{a.x + nx - tx, a.y + ny - ty},
                 {b.x + nx + tx, b.y + ny + ty},
                 {b.x - nx + tx, b.y - ny + ty},
                 {a.x - nx - tx, a.y - ny - ty}}};
    swath.low_y = std::numeric_limits<double>::infinity();
    swath.high_y = -swath.low_y;
    for (const Place& corner : swath.corners) {
      swath.low_y = std::min(swath.low_y, corner.y);
      swath.high_y = std::max(swath.high_y, corner.y);
    }
    result.push_back(std::move(swath));
  }
  return result;
}

bool is_exact(const FloorDescription& floor, std::span<const WayPoint> way) {
  const auto is_along = [](const Place& a, const Place& b) {
    return std::abs(a.x - b.x) < 1e-9 || std::abs(a.y - b.y) < 1e-9;
  };
  const auto is_orthogonal_polygon = [&](const std::vector<Place>& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (!is_along(corners[i], corners[(i + 1) % corners.size()])) return false;
    }
    return true;
  };
  if (!is_orthogonal_polygon(floor.outline)) return false;
  for (const ShaftDescription& shaft : floor.shafts) {
    if (!is_orthogonal_polygon(shaft.corners)) return false;
  }
  for (const ColumnDescription& column : floor.columns) {
    if (column.round) return false;
  }
  for (std::size_t i = 1; i < way.size(); ++i) {
    if (way[i].working && !is_along(way[i - 1].place, way[i].place)) return false;
  }
  return true;
}

class AreaMeasure {
 public:
  AreaMeasure(const FloorDescription& floor, const CoverageOptions& options,
              std::span<const WayPoint> way)
      : outline_(on_grid(floor.outline)),
        bodies_(bodies_of(floor)),
        swaths_(swaths_of(way, options.width)),
        clearance_(options.clearance),
        half_(options.width / 2),
        exact_(is_exact(floor, way)) {
    std::sort(swaths_.begin(), swaths_.end(),
              [](const Swath& a, const Swath& b) { return a.low_y < b.low_y; });
    make_strips(options.width);
  }

  void run(Measures& measures) {
    std::vector<Intervals> slab(strips_.size());
    std::vector<Intervals> allowed(strips_.size());
    for (std::size_t i = 0; i < strips_.size(); ++i) {
      const double y = middle(i);
      const Intervals floor = inside_at(outline_, y);
      slab[i] = without_bodies(floor, y, 0);
      allowed[i] = clearance_ > 0 ? without_bodies(floor, y, clearance_) : slab[i];
    }
    double covered = 0;
    std::size_t first_swath = 0;
    double tallest = 0;
    for (const Swath& swath : swaths_) tallest = std::max(tallest, swath.high_y - swath.low_y);
    for (std::size_t i = 0; i < strips_.size(); ++i) {
      const double y = middle(i);
      const double height = strips_[i].high - strips_[i].low;
      Intervals reach;
      // An allowed place on the strip's edge reaches as far as one inside it.
      for (std::size_t k = i; k-- > 0 && strips_[k].high + half_ > y;) add_reach(allowed[k], reach);
      for (std::size_t k = i; k < strips_.size() && strips_[k].low - half_ < y; ++k) {
        add_reach(allowed[k], reach);
      }
      unite(reach);
      reach = common(reach, slab[i]);
      while (first_swath < swaths_.size() && swaths_[first_swath].low_y < y - tallest)
        ++first_swath;
      Intervals worked;
      for (std::size_t k = first_swath; k < swaths_.size() && swaths_[k].low_y < y; ++k) {
        if (swaths_[k].high_y <= y) continue;
        for (const Interval& interval : inside_at(swaths_[k].corners, y))
          worked.push_back(interval);
      }
      unite(worked);
      measures.floor_area += height * total(slab[i]);
      measures.reachable_area += height * total(reach);
      covered += height * total(common(reach, worked));
    }
    measures.coverage =
        measures.reachable_area > 0 ? std::min(covered / measures.reachable_area, 1.0) : 1;
    if (measures.coverage > 1 - 1e-9) measures.coverage = 1;
  }

 private:
  double middle(std::size_t i) const { return (strips_[i].low + strips_[i].high) / 2; }

  void add_reach(const Intervals& places, Intervals& reach) const {
    for (const Interval& place : places) reach.push_back({place.low - half_, place.high + half_});
  }

  Intervals without_bodies(const Intervals& floor, double y, double grown) const {
    Intervals taken;
    for (const Body& body : bodies_) {
      for (const Interval& interval : body.at(y, grown)) taken.push_back(interval);
    }
    unite(taken);
    return less(floor, taken);
  }

  void make_strips(double width) {
    std::vector<double> marks;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Place& corner : outline_) {
      low = std::min(low, corner.y);
      high = std::max(high, corner.y);
    }
    if (exact_) {
      const auto mark = [&](double y) {
        for (const double reach : {-half_, 0.0, half_}) marks.push_back(y + reach);
      };
      for (const Place& corner : outline_) mark(corner.y);
      for (const Body& body : bodies_) {
        for (const Place& corner : body.ring) {
          marks.push_back(corner.y);
          mark(corner.y - clearance_);
          mark(corner.y + clearance_);
        }
      }
      for (const Swath& swath : swaths_) {
        marks.push_back(swath.low_y);
        marks.push_back(swath.high_y);
      }
    } else {
      const int count = static_cast<int>(std::ceil((high - low) / width * 40));
      for (int i = 0; i <= count; ++i) marks.push_back(low + (high - low) * i / count);
    }
    std::sort(marks.begin(), marks.end());
    for (std::size_t i = 1; i < marks.size(); ++i) {
      const Interval strip{std::max(marks[i - 1], low), std::min(marks[i], high)};
      if (strip.high - strip.low > 1e-9) strips_.push_back(strip);
    }
  }

  std::vector<Place> outline_;
  std::vector<Body> bodies_;
  std::vector<Swath> swaths_;
  double clearance_;
  double half_;
  bool exact_;
  Intervals strips_;
};

double distance_to(const Place& p, const Place& a, const Place& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double squared = dx * dx + dy * dy;
  const double share =
      squared > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0, 1.0) : 0;
  const double x = a.x + share * dx - p.x;
  const double y = a.y + share * dy - p.y;
  return std::sqrt(x * x + y * y);
}

/// Where the way from a to b is within `reach` of c, as shares of its length.
void add_near_point(const Place& a, const Place& b, const Place& c, double reach,
                    Intervals& result) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double squared = dx * dx + dy * dy;
  const double along = ((c.x - a.x) * dx + (c.y - a.y) * dy) / squared;
  const double ox = a.x + along * dx - c.x;
  const double oy = a.y + along * dy - c.y;
  const double rest = reach * reach - ox * ox - oy * oy;
  if (rest <= 0) return;
  const double half = std::sqrt(rest / squared);
  result.push_back({along - half, along + half});
}

/// The same of a segment, its ends left out.
void add_near_segment(const Place& a, const Place& b, const Place& c, const Place& d, double reach,
                      Intervals& result) {
  const double ex = d.x - c.x;
  const double ey = d.y - c.y;
  const double length = std::sqrt(ex * ex + ey * ey);
  if (length == 0) return;
  double low = 0;
  double high = 1;
  const auto clip = [&](double at_a, double at_b, double least, double most) {
    const double change = at_b - at_a;
    if (std::abs(change) < 1e-12) {
      if (at_a <= least || at_a >= most) high = low - 1;
      return;
    }
    const double first = (least - at_a) / change;
    const double second = (most - at_a) / change;
    low = std::max(low, std::min(first, second));
    high = std::min(high, std::max(first, second));
  };
  const auto along = [&](const Place& p) { return ((p.x - c.x) * ex + (p.y - c.y) * ey) / length; };
  const auto off = [&](const Place& p) { return ((p.y - c.y) * ex - (p.x - c.x) * ey) / length; };
  clip(along(a), along(b), 0, length);
  clip(off(a), off(b), -reach, reach);
  if (low < high) result.push_back({low, high});
}

bool is_inside(const std::vector<Place>& ring, const Place& p) {
  bool inside = false;
  for (const Interval& interval : inside_at(ring, p.y)) {
    inside = inside || (interval.low <= p.x && p.x <= interval.high);
  }
  return inside;
}

/// The parts of a way between its crossings with a polygon that lie inside it (or outside), deeper
/// than the tolerance in their middle.
Intervals parts(const std::vector<Place>& ring, const Place& a, const Place& b, bool inside) {
  std::vector<double> marks{0, 1};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Place& c = ring[i];
    const Place& d = ring[(i + 1) % ring.size()];
    const double at_a = (d.x - c.x) * (a.y - c.y) - (d.y - c.y) * (a.x - c.x);
    const double at_b = (d.x - c.x) * (b.y - c.y) - (d.y - c.y) * (b.x - c.x);
    if (at_a == at_b) continue;
    const double share = at_a / (at_a - at_b);
    if (share <= 0 || share >= 1) continue;
    const Place p{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    if (distance_to(p, c, d) < 1e-6) marks.push_back(share);
  }
  std::sort(marks.begin(), marks.end());
  Intervals result;
  for (std::size_t i = 1; i < marks.size(); ++i) {
    const double share = (marks[i - 1] + marks[i]) / 2;
    const Place p{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    if (is_inside(ring, p) != inside) continue;
    double depth = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < ring.size() && depth > kMeasureTolerance; ++k) {
      depth = std::min(depth, distance_to(p, ring[k], ring[(k + 1) % ring.size()]));
    }
    if (depth > kMeasureTolerance) result.push_back({marks[i - 1], marks[i]});
  }
  return result;
}

double length_inside(const std::vector<Body>& bodies, double clearance, const Place& a,
                     const Place& b, double length) {
  Intervals inside;
  const double reach = clearance - kMeasureTolerance;
  for (const Body& body : bodies) {
    if (body.ring.empty()) {
      add_near_point(a, b, body.centre, body.radius + reach, inside);
      continue;
    }
    Place low = body.ring[0];
    Place high = low;
    for (const Place& p : body.ring) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    if (std::max(a.x, b.x) < low.x - clearance || std::min(a.x, b.x) > high.x + clearance ||
        std::max(a.y, b.y) < low.y - clearance || std::min(a.y, b.y) > high.y + clearance) {
      continue;
    }
    for (const Interval& part : parts(body.ring, a, b, true)) inside.push_back(part);
    if (reach <= 0) continue;
    for (std::size_t i = 0; i < body.ring.size(); ++i) {
      const Place& c = body.ring[i];
      add_near_point(a, b, c, reach, inside);
      add_near_segment(a, b, c, body.ring[(i + 1) % body.ring.size()], reach, inside);
    }
  }
  unite(inside);
  return length * total(common(inside, {{0, 1}}));
}

}  // namespace

Measures measure(const FloorDescription& floor, const CoverageOptions& options,
                 std::span<const WayPoint> way) {
  Measures result;
  AreaMeasure(floor, options, way).run(result);
  result.lower_bound = result.reachable_area / options.width;
  const std::vector<Body> bodies = bodies_of(floor);
  const std::vector<Place> outline = on_grid(floor.outline);
  double heading = 0;
  bool moving = false;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Place& a = way[i - 1].place;
    const Place& b = way[i].place;
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double length = std::sqrt(dx * dx + dy * dy);
    if (length == 0) continue;
    result.length += length;
    if (way[i].working) result.working_length += length;
    const double direction = math::atan2_deg(dy, dx);
    double change = std::abs(direction - heading);
    change = std::min(change, 360 - change);
    if (moving && change > 1) ++result.turns;
    moving = true;
    heading = direction;
    result.inside_holes += length_inside(bodies, options.clearance, a, b, length);
    for (const Interval& part : parts(outline, a, b, false)) {
      result.outside += length * (part.high - part.low);
    }
  }
  return result;
}

}  // namespace rubicon::coverage
