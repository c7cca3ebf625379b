#include "src/fleets/layout/best_layouts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <utility>

namespace rubicon::layout {

namespace {

constexpr int kShifts = 8;            ///< of a period
constexpr int kMostCrossAisles = 2;   ///< beside those along the walls
constexpr int kMostColumnRows = 12;   ///< so many rows of columns may decide where rows stand
constexpr double kSameShift = 0.001;  ///< m
/// Trips that are shorter, or more in an hour, by less of them: no reason to tell of a layout.
constexpr double kWorthTelling = 0.005;

/// Where the first aisle may lie: ascending.
std::vector<double> shifts_of(const HallSpace& space, const Sizes& sizes, Ways ways) {
  const double period = period_of(sizes, ways);
  const double passage = period - 2 * sizes.depth;
  const Rectangle& bounds = space.bounds();
  std::vector<double> shifts;
  const auto add = [&](double shift) {
    shift -= std::floor(shift / period) * period;
    const auto same = [&](double other) {
      const double apart = std::abs(shift - other);
      return std::min(apart, period - apart) < kSameShift;
    };
    if (std::none_of(shifts.begin(), shifts.end(), same)) shifts.push_back(shift);
  };
  const double height = bounds.y1 - bounds.y0;
  // An aisle, or a row, at the lower or the upper wall.
  for (const double shift : {0.0, sizes.depth, height - passage, height - passage - sizes.depth}) {
    add(shift);
  }
  for (int i = 1; i < kShifts; ++i) add(i * period / kShifts);
  std::vector<double> columns;
  for (const Polygon& polygon : space.hall().obstacles) {
    const auto [low, high] = std::minmax_element(
        polygon.begin(), polygon.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
    columns.push_back((low->y + high->y) / 2);
  }
  std::sort(columns.begin(), columns.end());
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
  if (columns.size() > kMostColumnRows) columns.resize(kMostColumnRows);
  for (const double y : columns) add(y - bounds.y0 - passage - sizes.depth);
  std::sort(shifts.begin(), shifts.end());
  return shifts;
}

void check(const Hall& hall, const Sizes& sizes) {
  if (hall.gates.empty()) {
    throw std::invalid_argument("the hall has no gate: a layout has to be reached from somewhere");
  }
  for (const auto& [what, value] : std::initializer_list<std::pair<const char*, double>>{
           {"length of a module", sizes.length},
           {"depth of a module", sizes.depth},
           {"width of a lane", sizes.lane},
           {"width of a lane across", sizes.width(true)},
           {"spacing of nodes", sizes.spacing},
           {"speed in aisles", sizes.aisle_speed},
           {"speed across", sizes.cross_speed}}) {
    if (!(value > 0 && std::isfinite(value))) {
      throw std::invalid_argument(fmt::format("the {} is not above 0", what));
    }
  }
  const Rectangle bounds = HallSpace(hall, false).bounds();
  const double width = bounds.x1 - bounds.x0;
  const double height = bounds.y1 - bounds.y0;
  const double modules = width * height / (sizes.length * sizes.depth);
  if (modules > kMostModules) {
    throw std::invalid_argument(fmt::format(
        "modules of {} m by {} m are too small for a hall of {} m by {} m: {:.0f} of them would "
        "fit, and a layout has up to {:.0f}",
        sizes.length, sizes.depth, width, height, modules, kMostModules));
  }
  // Nodes are counted the same way.
  if (width * height / (sizes.spacing * sizes.lane) > kMostModules) {
    throw std::invalid_argument(
        "the lanes are too narrow, or their nodes too near to each other, "
        "for a hall of this size");
  }
}

bool beats(const Layout& a, const Layout& b) {
  return a.modules.size() >= b.modules.size() && a.mean_trip <= b.mean_trip * (1 + kWorthTelling) &&
         a.trips_per_hour >= b.trips_per_hour * (1 - kWorthTelling);
}

}  // namespace

BestLayouts best_layouts(const Hall& hall, const Sizes& sizes) {
  check(hall, sizes);
  BestLayouts found;
  for (const bool along_y : {false, true}) {
    const HallSpace space(hall, along_y);
    for (const Ways ways : {Ways::one_way, Ways::shared, Ways::two_lanes}) {
      for (int cross = 0; cross <= kMostCrossAisles; ++cross) {
        for (const double shift : shifts_of(space, sizes, ways)) {
          const Choice choice{along_y, ways, cross, shift};
          ++found.tried;
          Layout layout = judge(choice, arrange(space, sizes, choice), sizes);
          if (layout.modules.empty()) continue;
          ++found.worked;
          const auto is_beaten = [&](const Layout& other) { return beats(other, layout); };
          if (std::any_of(found.best.begin(), found.best.end(), is_beaten)) continue;
          std::erase_if(found.best, [&](const Layout& other) { return beats(layout, other); });
          found.best.push_back(std::move(layout));
        }
      }
    }
  }
  std::stable_sort(found.best.begin(), found.best.end(), [](const Layout& a, const Layout& b) {
    return a.modules.size() != b.modules.size() ? a.modules.size() > b.modules.size()
                                                : a.mean_trip < b.mean_trip;
  });
  return found;
}

}  // namespace rubicon::layout
