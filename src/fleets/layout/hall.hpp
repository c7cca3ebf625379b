#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rubicon::layout {

/// m, plan view.
struct Point {
  double x = 0;
  double y = 0;
};
using Polygon = std::vector<Point>;

struct Rectangle {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// Where vehicles come in and go out: on the border of the hall, inside or outside.
struct Gate {
  std::string name;
  Point place;
};

struct Hall {
  Polygon outline;                 ///< in either sense
  std::vector<Polygon> obstacles;  ///< columns and shafts
  std::vector<Gate> gates;
};

/// A round column as a polygon that holds it.
Polygon around(Point centre, double diameter);
Polygon square(Point centre, double side);

/// What a rectangle meets first. Touching is free.
enum class Meets { nothing, obstacle, outline };
struct Meeting {
  Meets what = Meets::nothing;
  Rectangle box;  ///< obstacle: round it
};

/// The hall with what is asked often. With `turned` x and y change places, also in the answers.
class HallSpace {
 public:
  HallSpace(const Hall& hall, bool turned);

  const Hall& hall() const { return hall_; }
  const Rectangle& bounds() const { return bounds_; }
  Meeting meeting(const Rectangle& box) const;
  bool is_free(const Rectangle& box) const { return meeting(box).what == Meets::nothing; }
  /// Whether an obstacle lies in the box; the outline is not asked.
  bool is_obstructed(const Rectangle& box) const;
  /// Whether the straight line leaves the hall or comes into it, and how often.
  int crossings(Point from, Point to) const;
  bool is_inside(Point place) const;

  /// A wall that runs along y, and on which side of it the hall is.
  struct Wall {
    double x = 0;
    bool inside_is_right = false;
  };
  std::vector<Wall> walls_along_y() const;

 private:
  std::optional<Rectangle> obstacle_in(const Rectangle& box) const;

  Hall hall_;
  std::vector<Rectangle> boxes_;  ///< round obstacles
  Rectangle bounds_;
};

}  // namespace rubicon::layout
