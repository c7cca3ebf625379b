#pragma once

#include "src/motion/coverage/floor.hpp"

namespace rubicon::coverage {

/// The plan view turned so that lines run along x. Quarter turns are exact; others round to the
/// grid.
class Frame {
 public:
  Frame() = default;
  /// Lines along x (0) or along y (1).
  static Frame of_quarter(int quarter);
  /// Lines along a direction, which is not (0, 0).
  static Frame along(const Point& direction);

  bool is_exact() const { return cosine_ == 0 || sine_ == 0; }
  /// Of the lines in the plan view; 0 or more, below 180.
  double direction_deg() const;
  Point turned(const Point& p) const;
  Point turned(const Place& place) const { return turned(snap(place)); }
  Floor turned(const Floor& floor) const;
  /// From a point of the frame to the plan view, m.
  Place back(const Point& p) const;

 private:
  double cosine_ = 1;
  double sine_ = 0;
};

}  // namespace rubicon::coverage
