#include "src/fleets/layout/hall.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace rubicon::layout {

namespace {

/// m: rectangles that overlap by less touch.
constexpr double kTouching = 1e-6;

Rectangle box_of(const Polygon& polygon) {
  Rectangle box{polygon[0].x, polygon[0].y, polygon[0].x, polygon[0].y};
  for (const Point& each : polygon) {
    box.x0 = std::min(box.x0, each.x);
    box.y0 = std::min(box.y0, each.y);
    box.x1 = std::max(box.x1, each.x);
    box.y1 = std::max(box.y1, each.y);
  }
  return box;
}

Rectangle shrunken(const Rectangle& box) {
  return {box.x0 + kTouching, box.y0 + kTouching, box.x1 - kTouching, box.y1 - kTouching};
}

bool overlap(const Rectangle& a, const Rectangle& b) {
  return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

/// Whether a straight line has a point in the box (Y.-D. Liang and B. A. Barsky, 1984).
bool meets_line(const Rectangle& box, Point a, Point b) {
  double from = 0;
  double to = 1;
  const auto cut = [&](double step, double room) {
    if (step == 0) return room >= 0;
    const double t = room / step;
    if (step < 0) {
      from = std::max(from, t);
    } else {
      to = std::min(to, t);
    }
    return from <= to;
  };
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  return cut(-dx, a.x - box.x0) && cut(dx, box.x1 - a.x) && cut(-dy, a.y - box.y0) &&
         cut(dy, box.y1 - a.y);
}

template <typename Visit>
void each_edge(const Polygon& polygon, Visit visit) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    visit(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
}

bool has_edge_in(const Polygon& polygon, const Rectangle& box) {
  bool found = false;
  each_edge(polygon, [&](Point a, Point b) { found = found || meets_line(box, a, b); });
  return found;
}

/// By crossings of a ray to the right.
bool contains(const Polygon& polygon, Point place) {
  bool inside = false;
  each_edge(polygon, [&](Point a, Point b) {
    if ((a.y > place.y) == (b.y > place.y)) return;
    const double x = a.x + (place.y - a.y) / (b.y - a.y) * (b.x - a.x);
    if (place.x < x) inside = !inside;
  });
  return inside;
}

Point middle(const Rectangle& box) { return {(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2}; }

double side_of(Point a, Point b, Point place) {
  return (b.x - a.x) * (place.y - a.y) - (b.y - a.y) * (place.x - a.x);
}

}  // namespace

Polygon around(Point centre, double diameter) {
  // Eight sides, which touch the circle: corners at the radius times 1 and tan(22.5 degrees).
  constexpr double kTan = 0.41421356237309503;
  const double r = diameter / 2;
  const double s = r * kTan;
  const std::array<Point, 8> corners = {Point{r, -s}, Point{r, s},   Point{s, r},   Point{-s, r},
                                        Point{-r, s}, Point{-r, -s}, Point{-s, -r}, Point{s, -r}};
  Polygon polygon;
  for (const Point& each : corners) polygon.push_back({centre.x + each.x, centre.y + each.y});
  return polygon;
}

Polygon square(Point centre, double side) {
  const double h = side / 2;
  return {{centre.x - h, centre.y - h},
          {centre.x + h, centre.y - h},
          {centre.x + h, centre.y + h},
          {centre.x - h, centre.y + h}};
}

HallSpace::HallSpace(const Hall& hall, bool turned) : hall_(hall) {
  if (turned) {
    const auto turn = [](Point& place) { std::swap(place.x, place.y); };
    for (Point& each : hall_.outline) turn(each);
    for (Polygon& polygon : hall_.obstacles) {
      for (Point& each : polygon) turn(each);
    }
    for (Gate& gate : hall_.gates) turn(gate.place);
  }
  for (const Polygon& polygon : hall_.obstacles) boxes_.push_back(box_of(polygon));
  bounds_ = box_of(hall_.outline);
}

std::optional<Rectangle> HallSpace::obstacle_in(const Rectangle& box) const {
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    if (!overlap(box, boxes_[i])) continue;
    if (has_edge_in(hall_.obstacles[i], box) || contains(hall_.obstacles[i], middle(box))) {
      return boxes_[i];
    }
  }
  return std::nullopt;
}

Meeting HallSpace::meeting(const Rectangle& box) const {
  const Rectangle inner = shrunken(box);
  if (has_edge_in(hall_.outline, inner) || !contains(hall_.outline, middle(inner))) {
    return {Meets::outline, {}};
  }
  if (const auto found = obstacle_in(inner)) return {Meets::obstacle, *found};
  return {};
}

bool HallSpace::is_obstructed(const Rectangle& box) const {
  return obstacle_in(shrunken(box)).has_value();
}

bool HallSpace::is_inside(Point place) const { return contains(hall_.outline, place); }

int HallSpace::crossings(Point from, Point to) const {
  int count = 0;
  each_edge(hall_.outline, [&](Point a, Point b) {
    const bool parts = (side_of(from, to, a) > 0) != (side_of(from, to, b) > 0);
    const bool parted = (side_of(a, b, from) > 0) != (side_of(a, b, to) > 0);
    if (parts && parted) ++count;
  });
  return count;
}

std::vector<HallSpace::Wall> HallSpace::walls_along_y() const {
  double area = 0;  // twice, counter-clockwise
  each_edge(hall_.outline, [&](Point a, Point b) { area += a.x * b.y - b.x * a.y; });
  std::vector<Wall> walls;
  each_edge(hall_.outline, [&](Point a, Point b) {
    if (a.x != b.x || a.y == b.y) return;
    // Counter-clockwise, the hall is on the left of each edge: of one that goes down, at larger x.
    walls.push_back({a.x, (a.y > b.y) == (area > 0)});
  });
  return walls;
}

}  // namespace rubicon::layout
