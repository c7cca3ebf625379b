#include "tests/unit/travel/travel_worlds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "src/motion/math/angles.hpp"

namespace rubicon::travel {

std::uint64_t TestRandom::bits() {
  state_ += 0x9e3779b97f4a7c15;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

double TestRandom::between(double low, double high) {
  return low + (high - low) * (static_cast<double>(bits() >> 11) / 9007199254740992.0);
}

int TestRandom::whole(int low, int high) {
  const auto span = static_cast<std::uint64_t>(std::int64_t{high} - low + 1);
  return static_cast<int>(low + static_cast<std::int64_t>(bits() % span));
}

int cases(int few) {
  const char* times = std::getenv("RUBICON_TRAVEL_CASES");
  return times == nullptr ? few : few * std::max(1, std::stoi(times));
}

Corners box(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

Corners u_shape(double x, double y, double width, double height, double wall, int quarters) {
  if (quarters % 2 != 0) std::swap(width, height);
  Corners corners = {{0, 0},
                     {wall, 0},
                     {wall, height - wall},
                     {width - wall, height - wall},
                     {width - wall, 0},
                     {width, 0},
                     {width, height},
                     {0, height}};
  for (int i = 0; i < quarters; ++i) {
    // A quarter clockwise, back into the first quadrant: from a south to a west opening.
    for (Vec2& corner : corners) corner = Vec2(corner.y(), width - corner.x());
    std::swap(width, height);
  }
  for (Vec2& corner : corners) corner += Vec2(x, y);
  return corners;
}

Corners star(TestRandom& random, const Vec2& centre, double least, double most, int corners) {
  Corners result;
  const double turn = random.between(0, 360);
  for (int i = 0; i < corners; ++i) {
    const double angle = turn + 360.0 * i / corners;
    result.push_back(centre + random.between(least, most) *
                                  Vec2(math::cos_deg(angle), math::sin_deg(angle)));
  }
  return result;
}

Corners convex(TestRandom& random, const Vec2& centre, double radius, int corners) {
  std::vector<double> angles;
  angles.reserve(static_cast<std::size_t>(corners));
  const double turn = random.between(0, 360);
  for (int i = 0; i < corners; ++i) {
    angles.push_back(turn + 360.0 * (i + random.between(0.1, 0.9)) / corners);
  }
  Corners result;
  for (const double angle : angles) {
    result.push_back(centre + radius * Vec2(math::cos_deg(angle), math::sin_deg(angle)));
  }
  return result;
}

std::vector<Corners> random_world(TestRandom& random, WorldKind kind, int obstacles, double reach) {
  std::vector<Corners> world;
  const int whole_reach = static_cast<int>(reach);
  for (int i = 0; i < obstacles; ++i) {
    const Vec2 centre(random.between(-reach, reach), random.between(-reach, reach));
    const int choice = kind == WorldKind::kMixed ? random.whole(0, 2) : static_cast<int>(kind);
    if (choice == 0) {
      world.push_back(box(centre.x(), centre.y(), random.between(2, 10), random.between(2, 10)));
    } else if (choice == 1) {
      world.push_back(star(random, centre, 2, 8, random.whole(4, 9)));
    } else {
      const int x = random.whole(-whole_reach, whole_reach);
      const int y = random.whole(-whole_reach, whole_reach);
      const int width = random.whole(4, 12);
      const int height = random.whole(4, 12);
      if (random.whole(0, 2) == 0) {
        world.push_back(u_shape(x, y, width, height, 1, random.whole(0, 3)));
      } else {
        world.push_back(box(x, y, width, height));
      }
    }
  }
  return world;
}

std::vector<Corners> wall_maze(TestRandom& random, int cells, double pitch, double density) {
  std::vector<Corners> walls;
  constexpr double kThick = 0.25;
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      if (random.between(0, 1) < density) {
        walls.push_back(
            box(j * pitch - kThick, i * pitch - kThick, pitch + 2 * kThick, 2 * kThick));
      }
      if (random.between(0, 1) < density) {
        walls.push_back(
            box(i * pitch - kThick, j * pitch - kThick, 2 * kThick, pitch + 2 * kThick));
      }
    }
  }
  return walls;
}

std::vector<Piece> pieces_of(const std::vector<Corners>& world) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < world.size(); ++i) {
    pieces.push_back({ring_of(world[i]), static_cast<int>(i)});
  }
  return pieces;
}

TravelQuery query_of(const std::vector<Corners>& world, const Vec2& start,
                     const Vec2& destination) {
  TravelQuery query;
  for (std::size_t i = 0; i < world.size(); ++i) {
    query.obstacles.push_back({std::string(1, static_cast<char>('a' + i % 26)), {world[i]}, {}});
  }
  query.start = start;
  query.destination = destination;
  return query;
}

std::string told(const TravelResult& result) {
  std::string text;
  for (const Event& event : result.events) {
    text += fmt::format("{}{}({:.6g},{:.6g})", text.empty() ? "" : " ", name_of(event.kind),
                        std::round(event.point.x() * 100) / 100 + 0.0,
                        std::round(event.point.y() * 100) / 100 + 0.0);
  }
  return text;
}

bool is_free(const std::vector<Corners>& world, const Vec2& p) {
  const ExactPoint point(snap(p));
  return std::all_of(world.begin(), world.end(), [&point](const Corners& corners) {
    return place_of_middle(point, point, ring_of(corners)) < 0;
  });
}

}  // namespace rubicon::travel
