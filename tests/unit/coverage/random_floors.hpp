#pragma once

#include <random>
#include <vector>

#include "src/motion/coverage/floor.hpp"

namespace rubicon::coverage {

/// A floor, and how much longer than area over width its way may be, with a tool of 1 m and a
/// clearance of 0.25 m.
struct FloorCase {
  const char* name;
  FloorDescription floor;
  double most;
};
/// Ten floors of our own: docs/coverage.md has what comes of them.
std::vector<FloorCase> ten_floors();

/// The corners of a rectangle.
std::vector<Place> box(double x0, double y0, double x1, double y1);

/// Numbers from a seed, the same on every machine.
class FloorRandom {
 public:
  explicit FloorRandom(std::uint32_t seed) : engine_(seed) {}
  /// 0 .. count - 1.
  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(count)); }
  /// In steps of a millimetre.
  double between(double low, double high) {
    return low + 0.001 * below(static_cast<int>((high - low) * 1000) + 1);
  }

 private:
  std::mt19937 engine_;
};

/// Squares of a chequered floor: which are floor, with the places of the lines between them.
struct Chequer {
  std::vector<std::vector<bool>> floor;  ///< [row][column]
  std::vector<double> x;
  std::vector<double> y;
};

/// A connected floor of up to `columns` times `rows` squares that meet along lines only; what is
/// left out inside are shafts.
Chequer random_chequer(FloorRandom& random, int columns, int rows, double most_pitch);
FloorDescription floor_of(const Chequer& chequer);
/// The fewest rectangles that its squares can be put together to, by trying all.
int fewest_by_trying(const Chequer& chequer);

/// A star-shaped polygon with `corners` corners round a place.
std::vector<Place> random_star(FloorRandom& random, const Place& centre, double least, double most,
                               int corners);
/// A star-shaped floor with shafts and columns of any shape in it.
FloorDescription random_general_floor(FloorRandom& random, const CoverageOptions& options);
/// A chequered floor with columns.
FloorDescription random_orthogonal_floor(FloorRandom& random, const CoverageOptions& options);

}  // namespace rubicon::coverage
