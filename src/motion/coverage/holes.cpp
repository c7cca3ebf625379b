#include "src/motion/coverage/holes.hpp"

#include <algorithm>
#include <cmath>

#include "src/motion/coverage/free_space.hpp"
#include "src/motion/coverage/tour.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::coverage {
namespace {

using math::at;

/// Up to so many holes random changes of the order are tried.
constexpr std::size_t kMostHolesForTries = 120;

/// The lowest of the places `apart` units from each other in the middle of a stretch, and how many
/// there are.
struct GridRow {
  std::int64_t first = 0;
  std::int64_t count = 0;
};
GridRow grid_row(std::int64_t low, std::int64_t high, std::int64_t apart) {
  const std::int64_t count = std::max<std::int64_t>((high - low) / apart, 1);
  return {low + (high - low - (count - 1) * apart) / 2, count};
}

/// The places of the grid where a hole can be, row by row there and back.
std::vector<Point> places_for_holes(const Floor& floor, const FreeSpace& space, const GridRow& x,
                                    const GridRow& y, const Point& apart, int& left_out) {
  std::vector<Point> places;
  for (std::int64_t row = 0; row < y.count; ++row) {
    for (std::int64_t i = 0; i < x.count; ++i) {
      const std::int64_t column = row % 2 == 0 ? i : x.count - 1 - i;
      const Point p{x.first + column * apart.x, y.first + row * apart.y};
      if (space.allows(p)) {
        places.push_back(p);
      } else if (place_in(floor.outline, p) >= 0) {
        ++left_out;
      }
    }
  }
  return places;
}

}  // namespace

HolePattern plan_holes(const FloorDescription& description, const CoverageOptions& options,
                       const Place& apart_m) {
  const Floor floor = make_floor(description, options);
  const FreeSpace space(floor, options.clearance);
  const Box box = box_of(floor.outline);
  const Point apart{std::max<std::int64_t>(in_units(apart_m.x), 1),
                    std::max<std::int64_t>(in_units(apart_m.y), 1)};
  const GridRow x = grid_row(box.low.x, box.high.x, apart.x);
  const GridRow y = grid_row(box.low.y, box.high.y, apart.y);
  HolePattern pattern;
  if (x.count * y.count > kMostHoles) {
    pattern.left_out = static_cast<int>(std::min<std::int64_t>(x.count * y.count, 1'000'000'000));
    return pattern;
  }
  const std::vector<Point> places = places_for_holes(floor, space, x, y, apart, pattern.left_out);
  if (places.empty()) return pattern;
  const auto length = [&](const Point& a, const Point& b) {
    return space.sees(a, b) ? distance(a, b) : space.shortest_length(a, b);
  };
  TourQuery tour;
  std::vector<DirectedLine> order;
  for (std::size_t i = 0; i < places.size(); ++i) {
    tour.ends.push_back(places[i]);
    tour.ends.push_back(places[i]);
    order.push_back({static_cast<int>(i), false});
  }
  // Where no way leads it is dearer than any way.
  constexpr double kNoWay = 1e12;
  tour.between = [&](int a, int b) {
    return std::min(length(tour.ends[at(a)], tour.ends[at(b)]), kNoWay);
  };
  if (options.from) {
    const Point from = snap(*options.from);
    tour.from_start = [&, from](int end) {
      return std::min(length(from, tour.ends[at(end)]), kNoWay);
    };
  }
  tour.kicks = places.size() <= kMostHolesForTries ? options.tries : 0;
  improve_tour(tour, order);
  const auto add = [&](const Point& p, bool is_hole) {
    pattern.way.push_back({metres(p), is_hole});
  };
  std::optional<Point> here;
  if (options.from) {
    here = snap(*options.from);
    add(*here, false);
  }
  for (const DirectedLine& each : order) {
    const Point& p = places[at(each.line)];
    if (here) {
      const std::vector<Point> way = space.shortest_way(*here, p);
      if (way.empty()) {
        ++pattern.left_out;
        continue;
      }
      for (std::size_t i = 1; i + 1 < way.size(); ++i) add(way[i], false);
    }
    add(p, true);
    ++pattern.holes;
    here = p;
  }
  return pattern;
}

}  // namespace rubicon::coverage
