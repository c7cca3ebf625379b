#include "src/earth/soil/bites.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

#include "src/motion/math/angles.hpp"

namespace rubicon::soil {

namespace {

/// A cut is looked at in steps of this share of a cell.
constexpr double kStepOfCell = 0.25;
/// Steps aside, either way, and back from the far edge of the cell. Where they would not go far
/// enough they are longer.
constexpr int kMostAside = 24;
constexpr int kMostBack = 3;
constexpr int kMostOn = 60;
/// Steps of a cut, and m without any soil after which it is over.
constexpr int kMostSteps = 2000;
constexpr double kMostIdle = 1;
/// m: what overlaps no deeper only touches.
constexpr double kTouches = 1e-6;
/// m: nothing is dug nearer to the middle of the machine.
constexpr double kLeastDistance = 0.1;

/// What the bucket covers in the plan view, as it is held, around the tool: along the heading and
/// across it, and how far below the tool it goes.
struct Footprint {
  double back = 0, front = 0, right = 0, left = 0, low = 0;
};

Footprint footprint_of(const BiteRules& rules) {
  Eigen::AlignedBox3d bounds;
  for (const BucketBox& box : rules.boxes) {
    const Eigen::AlignedBox3d own(box.lower, box.upper);
    for (int corner = 0; corner < 8; ++corner) {
      const math::Vec3 p_T =
          box.X_BS * own.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
      bounds.extend(rules.R_HT * p_T);
    }
  }
  return {bounds.min().x(), bounds.max().x(), bounds.min().y(), bounds.max().y(), bounds.min().z()};
}

class BiteSearch {
 public:
  BiteSearch(const Terrain& now, const Terrain& bottom, const DigTarget& target,
             const BiteRules& rules)
      : now_(now),
        bottom_(bottom),
        target_(target),
        rules_(rules),
        print_(footprint_of(rules)),
        side_(static_cast<double>(now.cell) * 1e-3),
        step_(side_ * kStepOfCell),
        half_along_((print_.front - print_.back) / 2 + kGroundGap),
        half_across_((print_.left - print_.right) / 2 + kGroundGap) {
    // Cuts run from somewhat beyond the cell towards the machine.
    const double margin = std::fabs(print_.front) + std::fabs(print_.back) +
                          std::fabs(print_.left) + std::fabs(print_.right) +
                          std::max(rules.spread, 0.0) + (kMostOn + kMostBack) * step_ + 2 * side_;
    const math::Vec3 cell = place_of_cell(now, target.cell, 0);
    const auto window = [&](double a, double b, int count) {
      const auto number = [&](double value) {
        return static_cast<int>(std::clamp(std::floor(value / side_), 0.0, count - 1.0));
      };
      return std::pair(number(std::min(a, b) - margin), number(std::max(a, b) + margin));
    };
    columns_ = window(cell.x(), rules.p_EM.x(), now.columns);
    rows_ = window(cell.y(), rules.p_EM.y(), now.rows);
    seen_.assign(static_cast<std::size_t>(columns_.second - columns_.first + 1) *
                     static_cast<std::size_t>(rows_.second - rows_.first + 1),
                 0);
  }

  std::vector<Bite> run() {
    const math::Vec3 p = place_of_cell(now_, target_.cell, 0);
    const double x = p.x() - rules_.p_EM.x();
    const double y = p.y() - rules_.p_EM.y();
    const double distance = std::sqrt(x * x + y * y);
    if (distance < kLeastDistance) return {};
    const double bearing_deg = math::atan2_deg(y, x);
    const double width = print_.left - print_.right;
    const double more = rules_.spread;
    const double length = print_.front - print_.back + more;
    const double step_aside = std::max(step_, (width / 2 + more) / (kMostAside - 1));
    const double step_along = std::max({step_, more / kMostAside, length / kMostOn});
    const auto steps = [](double way, double step) {
      return static_cast<int>(std::ceil(way / step));
    };
    const int aside = std::min(kMostAside, steps(width / 2 + more, step_aside) + 1);
    const int back = kMostBack + std::min(kMostAside, steps(more, step_along));
    const int on = std::min(kMostOn, steps(length, step_along));
    struct Found {
      Bite bite;
      int aside = 0;
    };
    std::vector<Found> found;
    for (int j = -aside; j <= aside; ++j) {
      const Heading heading(bearing_deg + math::degrees(j * step_aside / distance));
      // with its far edge at that of the cell, or farther back, or farther on
      for (int k = 0; k <= back + on; ++k) {
        const int i = k <= back ? k : back - k;
        const double far = distance + side_ / 2 - kGroundGap - i * step_along - print_.front;
        if (far > rules_.before - step_ / 2) continue;
        if (auto bite = cut(heading, far)) {
          found.push_back({*bite, j});
          break;
        }
      }
    }
    std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
      return std::tuple(-a.bite.expected, std::abs(a.aside), -a.aside) <
             std::tuple(-b.bite.expected, std::abs(b.aside), -b.aside);
    });
    std::vector<Bite> bites;
    for (const Found& each : found) bites.push_back(each.bite);
    return bites;
  }

 private:
  /// The direction of a cut.
  struct Heading {
    explicit Heading(double heading_deg)
        : deg(heading_deg), c(math::cos_deg(heading_deg)), s(math::sin_deg(heading_deg)) {}
    double deg, c, s;
  };

  /// What lies under the bucket at a place of the tool.
  struct Under {
    bool is_free = true;  ///< it is all on the grid, and no ground that stays is above the limit
    Millimetres ground = std::numeric_limits<Millimetres>::min();  ///< highest that stays
    Millimetres soil = std::numeric_limits<Millimetres>::min();    ///< highest of all
    std::vector<int> covered;                                      ///< cells

    void clear() {
      is_free = true;
      ground = soil = std::numeric_limits<Millimetres>::min();
      covered.clear();
    }
  };

  /// The middle of the footprint, in {E}.
  Eigen::Vector2d middle_at(const Heading& heading, double distance) const {
    const auto& [deg, c, s] = heading;
    const double u = distance + (print_.back + print_.front) / 2;
    const double v = (print_.right + print_.left) / 2;
    return {rules_.p_EM.x() + u * c - v * s, rules_.p_EM.y() + u * s + v * c};
  }

  /// Whether the bucket covers a cell, with its middle at p.
  bool covers(const Heading& heading, const Eigen::Vector2d& p, int column, int row) const {
    const auto& [deg, c, s] = heading;
    const double more = std::max(rules_.spread, 0.0);
    const double dx = now_.middle(column) - p.x();
    const double dy = now_.middle(row) - p.y();
    return covers(dx * c + dy * s, dy * c - dx * s, c, s, half_along_ - kGroundGap + more,
                  half_across_ - kGroundGap + more);
  }

  /// Whether a bucket there takes of the target what comes away with it: as `BucketFill` does, from
  /// where that is beside the bucket straight towards its middle.
  bool reaches_target(const Heading& heading, double distance) const {
    const auto& [deg, c, s] = heading;
    const Eigen::Vector2d p = middle_at(heading, distance);
    for (const double a : kQuarters) {
      for (const double b : kQuarters) {
        const double dx = (target_.cell % now_.columns + a) * side_ - p.x();
        const double dy = (static_cast<double>(target_.cell / now_.columns) + b) * side_ - p.y();
        const double way = std::sqrt(dx * dx + dy * dy);
        const double left = way <= rules_.spread ? 0 : 1 - rules_.spread / way;
        if (std::fabs(dx * c + dy * s) * left <= half_along_ - kGroundGap &&
            std::fabs(dy * c - dx * s) * left <= half_across_ - kGroundGap) {
          return true;
        }
      }
    }
    return false;
  }

  /// It is looked at no further than to ground that stays above `limit`.
  void look(const Heading& heading, double distance, Millimetres limit, Under& under) const {
    const auto& [deg, c, s] = heading;
    const Eigen::Vector2d p = middle_at(heading, distance);
    const double wide = half_along_ * std::fabs(c) + half_across_ * std::fabs(s);
    const double high = half_along_ * std::fabs(s) + half_across_ * std::fabs(c);
    const double half = side_ / 2 * (std::fabs(c) + std::fabs(s));
    const double more = std::max(rules_.spread, 0.0);
    under.clear();
    const auto cell_of = [&](double value) { return std::floor(value / side_); };
    const double columns[] = {cell_of(p.x() - wide + kTouches), cell_of(p.x() + wide - kTouches)};
    const double rows[] = {cell_of(p.y() - high + kTouches), cell_of(p.y() + high - kTouches)};
    if (columns[0] < 0 || rows[0] < 0 || columns[1] >= now_.columns || rows[1] >= now_.rows) {
      under.is_free = false;
      return;
    }
    const auto within = [&](double value, int count) {
      return static_cast<int>(std::clamp(cell_of(value), 0.0, count - 1.0));
    };
    const int end_row = within(p.y() + high + more, now_.rows);
    const int end_column = within(p.x() + wide + more, now_.columns);
    for (int row = within(p.y() - high - more, now_.rows); row <= end_row; ++row) {
      for (int column = within(p.x() - wide - more, now_.columns); column <= end_column; ++column) {
        const double dx = now_.middle(column) - p.x();
        const double dy = now_.middle(row) - p.y();
        const double du = dx * c + dy * s;
        const double dv = dy * c - dx * s;
        const std::size_t cell = now_.index(column, row);
        if (std::fabs(du) < half_along_ + half - kTouches &&
            std::fabs(dv) < half_across_ + half - kTouches) {
          under.ground = std::max(under.ground, bottom_.heights[cell]);
          under.soil = std::max(under.soil, now_.heights[cell]);
          if (under.ground > limit) {
            under.is_free = false;
            return;
          }
        }
        if (covers(du, dv, c, s, half_along_ - kGroundGap + more,
                   half_across_ - kGroundGap + more)) {
          under.covered.push_back(static_cast<int>(cell));
        }
      }
    }
  }

  /// Whether one of the four points of a cell whose middle is at (du, dv) is in the footprint.
  bool covers(double du, double dv, double c, double s, double along, double across) const {
    for (const double a : kQuarters) {
      for (const double b : kQuarters) {
        const double ex = (a - 0.5) * side_;
        const double ey = (b - 0.5) * side_;
        if (std::fabs(du + ex * c + ey * s) <= along && std::fabs(dv + ey * c - ex * s) <= across) {
          return true;
        }
      }
    }
    return false;
  }

  /// The cut that covered a cell last.
  std::uint32_t& seen_at(int cell) {
    const int column = std::clamp(cell % now_.columns, columns_.first, columns_.second);
    const int row = std::clamp(cell / now_.columns, rows_.first, rows_.second);
    const int width = columns_.second - columns_.first + 1;
    return seen_[static_cast<std::size_t>((row - rows_.first) * width + column - columns_.first)];
  }

  /// Down to which a cell is lowered by a cut at that height.
  Millimetres lowered(int cell, Millimetres height) const {
    const Millimetres bottom = bottom_.heights[static_cast<std::size_t>(cell)];
    return height <= bottom + rules_.tolerance ? bottom : height;
  }

  /// The cut that begins there; nothing: it does not reach the target, or meets ground that stays.
  std::optional<Bite> cut(const Heading& heading, double far) {
    const int column = target_.cell % now_.columns;
    const int row = target_.cell / now_.columns;
    if (!covers(heading, middle_at(heading, far), column, row)) return std::nullopt;
    constexpr auto kGap = static_cast<Millimetres>(kGroundGap * 1e3);
    Under& under = under_;
    look(heading, far, target_.floor + rules_.tolerance - kGap, under);
    if (!under.is_free) return std::nullopt;
    const Millimetres floor = std::max(target_.floor, under.ground);
    const auto cutting = floor + kGap;
    if (cutting > target_.floor + rules_.tolerance) return std::nullopt;
    Bite bite;
    bite.cell = target_.cell;
    bite.heading_deg = heading.deg;
    bite.far = bite.near = far;
    Millimetres soil = under.soil;
    Millimetres passed = under.soil;
    bool reaches = rules_.spread <= 0;
    ++stamp_;
    const CubicMillimetres area = now_.cell * now_.cell;
    for (int i = 0; i < kMostSteps; ++i) {
      const double distance = far - i * step_;
      if (i > 0) {
        if (distance + print_.back < kLeastDistance || bite.near - distance > kMostIdle) break;
        look(heading, distance, floor, under);
        if (!under.is_free) break;
      }
      passed = std::max(passed, under.soil);
      reaches = reaches || reaches_target(heading, distance);
      const CubicMillimetres before = bite.expected;
      for (const int cell : under.covered) {
        std::uint32_t& seen = seen_at(cell);
        if (seen == stamp_) continue;
        seen = stamp_;
        const Millimetres height = now_.heights[static_cast<std::size_t>(cell)];
        bite.expected += std::max<Millimetres>(height - lowered(cell, cutting), 0) * area;
      }
      if (bite.expected == before) continue;
      bite.near = distance;
      soil = passed;
      if (bite.expected >= rules_.room) break;
    }
    if (bite.expected == 0 || (!reaches && bite.expected < rules_.room)) return std::nullopt;
    bite.expected = std::min(bite.expected, rules_.room);
    bite.low = static_cast<double>(cutting) * 1e-3 - print_.low;
    const Millimetres over = std::max({soil, rules_.rim, cutting});
    bite.high = static_cast<double>(over) * 1e-3 + rules_.clearance - print_.low;
    return bite;
  }

  const Terrain& now_;
  const Terrain& bottom_;
  const DigTarget& target_;
  const BiteRules& rules_;
  Footprint print_;
  double side_, step_;                  ///< m
  double half_along_, half_across_;     ///< m, of the footprint, grown by the gap
  std::pair<int, int> columns_, rows_;  ///< first and last of the cells that cuts can cover
  std::vector<std::uint32_t> seen_;     ///< to each of these, row by row
  std::uint32_t stamp_ = 0;
  Under under_;  ///< where it looked last
};

}  // namespace

math::Pose Bite::X_ET(const BiteRules& rules, double distance, double height) const {
  math::Pose X = math::translation(rules.p_EM.x() + distance * math::cos_deg(heading_deg),
                                   rules.p_EM.y() + distance * math::sin_deg(heading_deg), height) *
                 math::rotation_z_deg(heading_deg);
  X.linear() = X.linear() * rules.R_HT;
  return X;
}

math::Vec3 place_of_cell(const Terrain& terrain, int cell, Millimetres height) {
  return {terrain.middle(cell % terrain.columns), terrain.middle(cell / terrain.columns),
          static_cast<double>(height) * 1e-3};
}

std::optional<DigTarget> next_target(const Terrain& now, const Terrain& bottom,
                                     const std::vector<int>& cells, const std::set<int>& put_off,
                                     const BiteRules& rules) {
  // The layer of a cell that is not done down to its bottom, from 0 above.
  const auto layer_of = [&](int cell) -> std::int64_t {
    const auto index = static_cast<std::size_t>(cell);
    const Millimetres height = now.heights[index];
    if (height <= bottom.heights[index]) return -1;
    // Of a layer whose floor lies above the bottom, what is left is within the tolerance.
    const Millimetres depth = std::max<Millimetres>(rules.top - height, 0);
    const std::int64_t layer = depth / rules.layer;
    const Millimetres floor = rules.top - (layer + 1) * rules.layer;
    const bool is_done = floor > bottom.heights[index] && height <= floor + rules.tolerance;
    return is_done ? layer + 1 : layer;
  };
  std::int64_t highest = std::numeric_limits<std::int64_t>::max();
  std::optional<DigTarget> target;
  double farthest = -1;
  for (const int cell : cells) {
    const std::int64_t layer = layer_of(cell);
    if (layer < 0 || layer > highest) continue;
    const math::Vec3 away = place_of_cell(now, cell, 0) - rules.p_EM;
    const double distance = away.x() * away.x() + away.y() * away.y();
    const bool is_last = put_off.contains(cell);
    const bool is_sooner = layer < highest || (target->is_last && !is_last) ||
                           (target->is_last == is_last && distance > farthest);
    if (!is_sooner) continue;
    highest = layer;
    farthest = distance;
    const Millimetres floor = rules.top - (layer + 1) * rules.layer;
    target =
        DigTarget{cell, std::max(floor, bottom.heights[static_cast<std::size_t>(cell)]), is_last};
  }
  return target;
}

std::vector<Bite> bites_for(const Terrain& now, const Terrain& bottom, const DigTarget& target,
                            const BiteRules& rules) {
  return BiteSearch(now, bottom, target, rules).run();
}

}  // namespace rubicon::soil
