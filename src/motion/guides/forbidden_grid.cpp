#include "src/motion/guides/forbidden_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "src/motion/guides/vehicle.hpp"
#include "src/motion/math/index.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::guides {

namespace {

/// Cells along each of two parameters: with layers for a third, and without.
constexpr int kLayeredCells = 48;
constexpr int kFlatCells = 96;
/// Even layers; those of start and goal come on top.
constexpr int kEvenLayers = 17;

/// What is sampled beyond what was searched: this share of it, and at least so much.
constexpr double kBeyondShare = 0.15;
constexpr double kBeyondMetres = 1;
constexpr double kBeyondDegrees = 10;

/// Ranges end at whole parts of that, for people.
constexpr double kPartsOfMetre = 10;

/// m or degrees below which nothing has changed: rounding.
constexpr double kUnchanged = 1e-9;

/// What a search went through of one coordinate.
struct SearchedSpan {
  std::size_t coordinate = 0;
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double extent() const { return high - low; }
};

class Extents {
 public:
  explicit Extents(const Space& space) : space_(space) {
    for (std::size_t i = 0; i < space.size(); ++i) spans_.push_back({i});
  }

  void add(const Point& point) {
    for (SearchedSpan& span : spans_) {
      const double value = robot::reduced(parameter(span), point[span.coordinate]);
      span.low = std::min(span.low, value);
      span.high = std::max(span.high, value);
    }
  }

  /// The short way round; past half a turn it goes through the whole range.
  void add(const Point& from, const Point& to) {
    add(from);
    add(to);
    for (SearchedSpan& span : spans_) {
      const robot::Parameter& p = parameter(span);
      const double begin = robot::reduced(p, from[span.coordinate]);
      const double end = robot::reduced(p, to[span.coordinate]);
      if (p.cyclic && std::fabs(end - begin) > 180) {
        span.low = space_.lower(span.coordinate);
        span.high = space_.upper(span.coordinate);
      }
    }
  }

  /// Those that changed most first.
  std::vector<SearchedSpan> by_extent() const {
    std::vector<SearchedSpan> spans = spans_;
    std::stable_sort(spans.begin(), spans.end(), [](const SearchedSpan& a, const SearchedSpan& b) {
      return a.extent() > b.extent();
    });
    return spans;
  }

 private:
  const robot::Parameter& parameter(const SearchedSpan& span) const {
    return space_.parameter(span.coordinate);
  }

  const Space& space_;
  std::vector<SearchedSpan> spans_;
};

GridAxis axis_about(const Space& space, const SearchedSpan& span, int cells) {
  const bool rotation = space.parameter(span.coordinate).rotation;
  const double beyond =
      std::max(rotation ? kBeyondDegrees : kBeyondMetres, kBeyondShare * span.extent());
  const double parts = rotation ? 1 : kPartsOfMetre;
  return {span.coordinate,
          std::max(space.lower(span.coordinate), std::floor((span.low - beyond) * parts) / parts),
          std::min(space.upper(span.coordinate), std::ceil((span.high + beyond) * parts) / parts),
          cells};
}

/// Of a vehicle its place first, then its heading.
void put_place_first(const Space& space, const Vehicle& vehicle, std::vector<SearchedSpan>& spans) {
  const auto rank = [&](const SearchedSpan& span) {
    const int parameter = space.leg().parameters()[span.coordinate];
    if (parameter == vehicle.x()) return 0;
    if (parameter == vehicle.y()) return 1;
    return parameter == space.leg().heading() ? 2 : 3;
  };
  std::stable_sort(spans.begin(), spans.end(),
                   [&](const SearchedSpan& a, const SearchedSpan& b) { return rank(a) < rank(b); });
}

}  // namespace

std::vector<bool> blocked_cells(Space& space, Point point, const std::array<GridAxis, 2>& axes) {
  std::vector<bool> blocked;
  blocked.reserve(math::at(axes[0].cells * axes[1].cells));
  for (int j = 0; j < axes[1].cells; ++j) {
    for (int i = 0; i < axes[0].cells; ++i) {
      point[axes[0].coordinate] = axes[0].middle(i);
      point[axes[1].coordinate] = axes[1].middle(j);
      blocked.push_back(!space.stands(point));
    }
  }
  return blocked;
}

std::optional<ForbiddenGrid> sample_forbidden(const GuideSpec& spec, const GuideTask& task,
                                              std::span<const double> q, const PlanReport& report,
                                              MotionTests& tests) {
  Space space(*task.model, task.mounting, q, spec, tests, task.clauses);
  if (space.size() < 2) return std::nullopt;
  const Point start = space.point(q);
  const Point goal = report.goal.empty() ? start : space.point(report.goal);
  Extents extents(space);
  extents.add(start);
  extents.add(goal);
  for (const auto& [from, to] : report.tree) extents.add(space.point(from), space.point(to));
  for (std::size_t k = 1; k < report.way.size(); ++k) {
    extents.add(space.point(report.way[k - 1]), space.point(report.way[k]));
  }
  std::vector<SearchedSpan> spans = extents.by_extent();
  const Vehicle vehicle(*task.model, task.mounting);
  if (vehicle.travels()) put_place_first(space, vehicle, spans);
  const bool layered = spans.size() > 2 && spans[2].extent() > kUnchanged;
  const int cells = layered ? kLayeredCells : kFlatCells;
  const std::array<GridAxis, 2> axes = {axis_about(space, spans[0], cells),
                                        axis_about(space, spans[1], cells)};
  ForbiddenGrid grid;
  grid.q.assign(q.begin(), q.end());
  for (std::size_t k = 0; k < 2; ++k) {
    if (!std::isfinite(axes[k].low) || !(axes[k].high > axes[k].low) ||
        !std::isfinite(axes[k].high)) {
      return std::nullopt;
    }
    grid.parameters.push_back(space.leg().parameters()[axes[k].coordinate]);
    grid.low[k] = axes[k].low;
    grid.high[k] = axes[k].high;
    grid.cells[k] = cells;
  }
  if (!layered) {
    grid.blocked = blocked_cells(space, start, axes);
    return grid;
  }
  const GridAxis third = axis_about(space, spans[2], kEvenLayers);
  const robot::Parameter& parameter = space.parameter(third.coordinate);
  std::set<double> layers = {robot::reduced(parameter, start[third.coordinate]),
                             robot::reduced(parameter, goal[third.coordinate])};
  for (int k = 0; k < kEvenLayers; ++k) {
    layers.insert(third.low + (third.high - third.low) * k / (kEvenLayers - 1));
  }
  grid.parameters.push_back(space.leg().parameters()[third.coordinate]);
  grid.layers.assign(layers.begin(), layers.end());
  Point point = start;
  for (const double layer : grid.layers) {
    point[third.coordinate] = layer;
    const std::vector<bool> blocked = blocked_cells(space, point, axes);
    grid.blocked.insert(grid.blocked.end(), blocked.begin(), blocked.end());
  }
  return grid;
}

}  // namespace rubicon::guides
