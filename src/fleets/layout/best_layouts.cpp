#include "src/fleets/layout/best_layouts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

namespace rubicon::layout {

namespace {

constexpr int kShifts = 8;            ///< of a period
constexpr int kMostCrossAisles = 2;   ///< beside those along the walls
constexpr int kMostColumnRows = 12;   ///< so many rows of columns may decide where rows stand
constexpr double kSameShift = 0.001;  ///< m
/// Trips that are shorter, or more in an hour, by less of them: no reason to tell of a layout.
constexpr double kWorthTelling = 0.005;
/// s, and trips in an hour: less is rounding.
constexpr double kSameTrips = 1e-6;

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

/// What decides where a layout stands in the table: the less the better.
struct Worth {
  std::int64_t lost_modules, trip, lost_trips;

  explicit Worth(const Layout& layout)
      : lost_modules(-static_cast<std::int64_t>(layout.modules.size())),
        trip(std::llround(layout.mean_trip / kSameTrips)),
        lost_trips(-std::llround(layout.trips_per_hour / kSameTrips)) {}
  auto as_tuple() const { return std::tie(lost_modules, trip, lost_trips); }
};

bool is_tried_before(const Choice& a, const Choice& b) {
  return std::tie(a.along_y, a.ways, a.cross_aisles, a.shift) <
         std::tie(b.along_y, b.ways, b.cross_aisles, b.shift);
}

bool beats(const Layout& a, const Layout& b) {
  const Worth one(a), other(b);
  if (one.as_tuple() == other.as_tuple()) return is_tried_before(a.choice, b.choice);
  return one.lost_modules <= other.lost_modules && one.trip <= other.trip &&
         one.lost_trips <= other.lost_trips;
}

/// Whether who knows of `a` need not be told of `b`.
bool tells_of(const Layout& a, const Layout& b) {
  return a.modules.size() >= b.modules.size() && a.mean_trip <= b.mean_trip * (1 + kWorthTelling) &&
         a.trips_per_hour >= b.trips_per_hour * (1 - kWorthTelling);
}

}  // namespace

void add_to_front(std::vector<Layout>& front, Layout layout) {
  const auto is_better = [&](const Layout& other) { return beats(other, layout); };
  if (std::any_of(front.begin(), front.end(), is_better)) return;
  std::erase_if(front, [&](const Layout& other) { return beats(layout, other); });
  front.push_back(std::move(layout));
}

std::vector<Layout> thinned(std::vector<Layout> front) {
  std::sort(front.begin(), front.end(), [](const Layout& a, const Layout& b) {
    const Worth one(a), other(b);
    return one.as_tuple() != other.as_tuple() ? one.as_tuple() < other.as_tuple()
                                              : is_tried_before(a.choice, b.choice);
  });
  // How many of those that stay tell of each.
  std::vector<int> told(front.size(), 0);
  for (std::size_t i = 0; i < front.size(); ++i) {
    for (const Layout& other : front) told[i] += tells_of(other, front[i]) ? 1 : 0;
  }
  std::vector<bool> stays(front.size(), true);
  for (std::size_t i = front.size(); i-- > 0;) {
    stays[i] = false;
    for (std::size_t k = 0; k < front.size(); ++k) {
      if (told[k] == 1 && tells_of(front[i], front[k])) stays[i] = true;
    }
    for (std::size_t k = 0; !stays[i] && k < front.size(); ++k) {
      told[k] -= tells_of(front[i], front[k]) ? 1 : 0;
    }
  }
  std::vector<Layout> table;
  for (std::size_t i = 0; i < front.size(); ++i) {
    if (stays[i]) table.push_back(std::move(front[i]));
  }
  return table;
}

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
          add_to_front(found.best, std::move(layout));
        }
      }
    }
  }
  found.best = thinned(std::move(found.best));
  return found;
}

}  // namespace rubicon::layout
