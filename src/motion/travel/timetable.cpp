#include "src/motion/travel/timetable.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "src/motion/math/angles.hpp"

namespace rubicon::travel {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// In [-180, 180].
double short_way(double degrees) { return std::remainder(degrees, 360.0); }

void require_timetable(const Obstacle& obstacle) {
  const auto& stops = obstacle.timetable;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    if (!(stops[i].time < stops[i + 1].time)) {
      throw std::invalid_argument("the times of a timetable do not ascend: " + obstacle.name);
    }
    if (!(std::fabs(stops[i + 1].heading_deg - stops[i].heading_deg) < 180 ||
          std::fabs(short_way(stops[i + 1].heading_deg - stops[i].heading_deg)) < 180)) {
      throw std::invalid_argument("an obstacle turns by 180 degrees at once: " + obstacle.name);
    }
  }
  if (obstacle.repeat && (stops.size() < 2 || stops.front().place != stops.back().place ||
                          short_way(stops.back().heading_deg - stops.front().heading_deg) != 0)) {
    throw std::invalid_argument("a timetable repeats from another place: " + obstacle.name);
  }
}

bool same_place(const Placement& a, const Placement& b) {
  return a.place == b.place && a.heading_deg == b.heading_deg;
}

/// The time of the first round of a timetable that repeats.
double time_in_round(const Obstacle& obstacle, double time) {
  const double first = obstacle.timetable.front().time;
  const double period = obstacle.timetable.back().time - first;
  if (!obstacle.repeat || time < first) return time;
  return time - std::floor((time - first) / period) * period;
}

double next_motion_of(const Obstacle& obstacle, double time) {
  const auto& stops = obstacle.timetable;
  if (stops.size() < 2) return kNever;
  const double now = time_in_round(obstacle, time);
  const double offset = time - now;
  for (int round = 0; round < (obstacle.repeat ? 2 : 1); ++round) {
    const double later = round * (stops.back().time - stops.front().time);
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      if (stops[i + 1].time + later <= now || same_place(stops[i], stops[i + 1])) continue;
      return offset + std::max(now, stops[i].time + later);
    }
  }
  return kNever;
}

std::vector<Piece> pieces_at_start(const std::vector<Obstacle>& obstacles) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    require_timetable(obstacles[i]);
    for (const auto& part : obstacles[i].parts) {
      pieces.push_back({ring_of(part), static_cast<int>(i)});
    }
  }
  return pieces;
}

}  // namespace

Placement placement_at(const Obstacle& obstacle, double time) {
  const auto& stops = obstacle.timetable;
  if (stops.empty()) return {};
  const double now = time_in_round(obstacle, time);
  if (now <= stops.front().time) return stops.front();
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    if (now >= stops[i + 1].time) continue;
    const Placement& a = stops[i];
    const Placement& b = stops[i + 1];
    if (same_place(a, b)) return a;
    const double share = (now - a.time) / (b.time - a.time);
    return {time, a.place + share * (b.place - a.place),
            a.heading_deg + share * short_way(b.heading_deg - a.heading_deg)};
  }
  return stops.back();
}

MovingOutline::MovingOutline(std::vector<Obstacle> obstacles)
    : obstacles_(std::move(obstacles)),
      placements_(obstacles_.size()),
      moved_(obstacles_.size(), false),
      outline_(pieces_at_start(obstacles_)) {
  for (const Piece& piece : outline_.pieces()) own_rings_.push_back(piece.ring);
  move_to(-kNever);
}

double MovingOutline::next_motion(double time) const {
  double next = kNever;
  for (const Obstacle& obstacle : obstacles_) {
    next = std::min(next, next_motion_of(obstacle, time));
  }
  return next;
}

double MovingOutline::longest_slice() const {
  double longest = kNever;
  for (std::size_t i = 0; i < own_rings_.size(); ++i) {
    const auto obstacle = static_cast<std::size_t>(outline_.pieces()[i].obstacle);
    const auto& stops = obstacles_[obstacle].timetable;
    double reach = 0;
    for (const LatticePoint& corner : own_rings_[i]) reach = std::max(reach, metres(corner).norm());
    double fastest = 0;
    for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
      const double turn = short_way(stops[k + 1].heading_deg - stops[k].heading_deg);
      const double way =
          (stops[k + 1].place - stops[k].place).norm() + reach * math::radians(std::fabs(turn));
      fastest = std::max(fastest, way / (stops[k + 1].time - stops[k].time));
    }
    if (fastest > 0) longest = std::min(longest, thickness(own_rings_[i]) / 2 / fastest);
  }
  return longest;
}

Ring MovingOutline::ring_at(std::size_t piece, const Placement& placement) const {
  Ring ring = own_rings_[piece];
  const LatticePoint by = snap(placement.place);
  const auto [sine, cosine] = math::sine_cosine_deg(placement.heading_deg);
  for (LatticePoint& corner : ring) {
    if (placement.heading_deg != 0) {
      const Vec2 own = metres(corner);
      corner = snap({cosine * own.x() - sine * own.y(), sine * own.x() + cosine * own.y()});
    }
    corner = {corner.x + by.x, corner.y + by.y};
  }
  return ring;
}

void MovingOutline::move_to(double time) {
  any_moved_ = false;
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    const Placement placement = placement_at(obstacles_[i], time);
    moved_[i] = !same_place(placement, placements_[i]);
    placements_[i] = placement;
    any_moved_ = any_moved_ || moved_[i];
  }
  if (!any_moved_) return;
  std::vector<Outline::Change> changes;
  for (std::size_t i = 0; i < own_rings_.size(); ++i) {
    const auto obstacle = static_cast<std::size_t>(outline_.pieces()[i].obstacle);
    if (!moved_[obstacle]) continue;
    changes.push_back({static_cast<int>(i), ring_at(i, placements_[obstacle])});
  }
  outline_.replace(changes);
}

}  // namespace rubicon::travel
