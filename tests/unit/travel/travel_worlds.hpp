#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/motion/travel/outline.hpp"
#include "src/motion/travel/travel.hpp"

namespace rubicon::travel {

/// Random numbers that are the same everywhere (SplitMix64).
class TestRandom {
 public:
  explicit TestRandom(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits();
  /// In [low, high).
  double between(double low, double high);
  /// In [low, high], both included.
  int whole(int low, int high);

 private:
  std::uint64_t state_;
};

/// Cases of a property test: `few`, times the whole number in the environment variable
/// RUBICON_TRAVEL_CASES where it is set.
int cases(int few);

using Corners = std::vector<Vec2>;

/// A box from its lower left corner, and shapes from boxes.
Corners box(double x, double y, double width, double height);
/// A U that opens to the south (turned by quarters: west, north, east), its outer box given.
Corners u_shape(double x, double y, double width, double height, double wall, int quarters = 0);
/// A star about a centre: corners at random distances in even directions.
Corners star(TestRandom& random, const Vec2& centre, double least, double most, int corners);
/// A random convex polygon about a centre: corners on a circle.
Corners convex(TestRandom& random, const Vec2& centre, double radius, int corners);

/// Obstacles of a random world; `lattice`: corners on whole metres, many touching and aligned.
enum class WorldKind { kBoxes, kStars, kLattice, kMixed };
std::vector<Corners> random_world(TestRandom& random, WorldKind kind, int obstacles, double reach);

/// A maze of walls on a grid with the given pitch: each wall between two cells stands with a chance
/// of `density`. It starts at the origin.
std::vector<Corners> wall_maze(TestRandom& random, int cells, double pitch, double density);

/// One piece an obstacle.
std::vector<Piece> pieces_of(const std::vector<Corners>& world);

/// Obstacles named a, b, c ... that stand.
TravelQuery query_of(const std::vector<Corners>& world, const Vec2& start, const Vec2& destination);

/// Events as text: hit(0,0) leave(0,10) reached(0,30), with two decimals where needed.
std::string told(const TravelResult& result);

/// Whether no obstacle has p inside or on its border.
bool is_free(const std::vector<Corners>& world, const Vec2& p);

}  // namespace rubicon::travel
