#include "src/motion/travel/walker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include "src/motion/math/angles.hpp"

namespace rubicon::travel {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

std::size_t in(int index) { return static_cast<std::size_t>(index); }

const TravelSettings& checked(const TravelSettings& settings) {
  if (!(settings.speed > 0 && settings.slice > 0 && settings.stride > 0 && settings.vision >= 0 &&
        settings.most_length > 0 && settings.most_time > 0 && settings.most_steps > 0)) {
    throw std::invalid_argument("settings of travel that are not positive");
  }
  return settings;
}

}  // namespace

double angle_between(const Vec2& a, const Vec2& b) {
  return math::atan2_deg(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

Walker::Walker(const TravelQuery& query, const TravelSettings& settings)
    : settings_(checked(settings)),
      world_(query.obstacles),
      start_(snap(query.start)),
      destination_(snap(query.destination)),
      position_(metres(start_)) {
  // Else what is thin and fast would jump over the robot.
  settings_.slice /= std::max(1.0, std::ceil(settings_.slice / world_.longest_slice()));
  world_.move_to(0);
  result_.way.push_back({position_, 0, Mode::kTowards});
}

const Edge& Walker::edge() const {
  return outline().composites()[in(footing_->composite)].edges[in(footing_->edge)];
}

ExactPoint Walker::exact_position() const {
  if (at_start_) return ExactPoint(start_);
  if (footing_ && footing_->along == 0) {
    return outline().composites()[in(footing_->composite)].nodes[in(edge().from)];
  }
  return nearby(position_);
}

bool Walker::free_towards(const Aim& aim) const {
  if (!footing_) return true;
  if (footing_->along > 0) return side(edge().line_a, edge().line_b, aim) >= 0;
  return corner_before(outline().composites()[in(footing_->composite)], footing_->edge).admits(aim);
}

bool Walker::contact_moves() const {
  if (!footing_) return false;
  const auto moves = [this](const Owner& owner) {
    return world_.moved(outline().pieces()[in(owner.piece)].obstacle);
  };
  return moves(edge().owner) ||
         std::any_of(edge().co_owners.begin(), edge().co_owners.end(), moves);
}

void Walker::begin_trail() {
  keeps_trail_ = true;
  trail_.clear();
}

void Walker::end_trail() {
  keeps_trail_ = false;
  trail_.clear();
}

bool Walker::at_limit() {
  ++steps_;
  return steps_ > settings_.most_steps || result_.length >= settings_.most_length ||
         time_ >= settings_.most_time;
}

double Walker::budget() const { return (slice_end_ - time_) * settings_.speed; }

void Walker::advance_to(const Vec2& point, bool by_itself) {
  const double length = (point - position_).norm();
  if (length == 0) return;
  const Vec2 goal = metres(destination_);
  bearing_turned_ += angle_between(goal - position_, goal - point);
  if (keeps_trail_) {
    trail_.push_back({position_, point, by_itself && footing_ ? footing_->version : 0});
  }
  result_.length += length;
  if (by_itself) time_ = std::min(slice_end_, time_ + length / settings_.speed);
  position_ = point;
  at_start_ = false;
  result_.way.push_back({position_, time_, mode_});
}

void Walker::begin_slice() {
  time_ = slice_end_;
  struck_ = false;
  squeezed_ = false;
  const double next = world_.next_motion(time_);
  if (next == kForever) {
    slice_end_ = kForever;
    world_.move_to(time_);
    return;
  }
  const double idle = std::floor(next / settings_.slice);
  if (idle > static_cast<double>(slices_)) {
    // Nothing moves up to there: one long slice.
    slices_ = static_cast<std::int64_t>(idle);
    slice_end_ = idle * settings_.slice;
    world_.move_to(time_);
    return;
  }
  ++slices_;
  slice_end_ = static_cast<double>(slices_) * settings_.slice;
  world_.move_to(slice_end_);
  if (world_.any_moved()) settle_after_motion();
}

void Walker::settle_after_motion() {
  if (footing_) {
    const Composite& composite = outline().composites()[in(footing_->composite)];
    if (composite.version != footing_->version) carry();
  } else if (run_over()) {
    place_at_nearest();
    struck_ = true;
  }
}

bool Walker::run_over() const {
  const ExactPoint here = nearby(position_);
  for (std::size_t i = 0; i < outline().pieces().size(); ++i) {
    const Piece& piece = outline().pieces()[i];
    if (world_.moved(piece.obstacle) && place_of_middle(here, here, piece.ring) > 0) return true;
  }
  return false;
}

void Walker::carry() {
  // The old edge is gone; what is left of the place is where it was in the frame of its obstacle.
  const Footing before = *footing_;
  const Vec2 old_heading = heading_;
  footing_.reset();
  const Piece& piece = outline().pieces()[in(before.owner.piece)];
  if (world_.moved(piece.obstacle)) {
    const Vec2 a = metres(next_corner(piece.ring, in(before.owner.edge)));
    const Vec2 b = metres(piece.ring[in(before.owner.edge)]);
    advance_to(a + before.along_owner * (b - a).normalized(), false);
  }
  if (!find_footing_again(before.owner, before.along_owner)) {
    place_at_nearest();
    squeezed_ = true;
  }
  turned_ += angle_between(old_heading, heading_);
}

bool Walker::find_footing_again(const Owner& owner, double along_owner) {
  const int index = outline().composite_of(owner.piece);
  const Composite& composite = outline().composites()[in(index)];
  const Ring& ring = outline().pieces()[in(owner.piece)].ring;
  const Vec2 a = metres(next_corner(ring, in(owner.edge)));
  // At a node that two of its edges share, the one that starts there.
  for (const double margin : {-kNoWayLeft, kNoWayLeft}) {
    for (std::size_t i = 0; i < composite.edges.size(); ++i) {
      const Edge& edge = composite.edges[i];
      if (edge.owner != owner &&
          std::find(edge.co_owners.begin(), edge.co_owners.end(), owner) == edge.co_owners.end()) {
        continue;
      }
      const double begin = (composite.nodes[in(edge.from)].p - a).dot(edge.heading);
      const double along = along_owner - begin;
      if (along < -kNoWayLeft || along > edge.length + margin) continue;
      stand_on(index, static_cast<int>(i), along < kNoWayLeft ? 0 : std::min(along, edge.length));
      return true;
    }
  }
  return false;
}

void Walker::place_at_nearest() {
  double best = kForever;
  int best_composite = -1;
  int best_edge = -1;
  double best_along = 0;
  Vec2 best_point = position_;
  for (std::size_t c = 0; c < outline().composites().size(); ++c) {
    const Composite& composite = outline().composites()[c];
    for (std::size_t i = 0; i < composite.edges.size(); ++i) {
      const Edge& edge = composite.edges[i];
      const Vec2 from = composite.nodes[in(edge.from)].p;
      const double along = std::clamp((position_ - from).dot(edge.heading), 0.0, edge.length);
      const Vec2 point = from + along * edge.heading;
      const double distance = (point - position_).norm();
      if (distance >= best) continue;
      best = distance;
      best_composite = static_cast<int>(c);
      best_edge = static_cast<int>(i);
      best_along = along;
      best_point = point;
    }
  }
  advance_to(best_point, false);
  stand_on(best_composite, best_edge, best_along);
}

void Walker::stand_on(int composite, int edge_index, double along) {
  const Composite& on = outline().composites()[in(composite)];
  const Edge& edge = on.edges[in(edge_index)];
  Footing footing;
  footing.composite = composite;
  footing.edge = edge_index;
  footing.along = along;
  footing.version = on.version;
  footing.owner = edge.owner;
  footing.along_owner = (on.nodes[in(edge.from)].p - metres(edge.line_a)).dot(edge.heading) + along;
  footing_ = footing;
  heading_ = edge.heading;
}

void Walker::arrive_at_next_edge() {
  const Vec2 before = heading_;
  stand_on(footing_->composite, edge().next, 0);
  turned_ += angle_between(before, heading_);
}

Walker::Outcome Walker::go(const Leg& leg) {
  bool departing = footing_.has_value();
  if (at_limit()) return Outcome::kLimit;
  if (!free_towards(leg.aim())) return Outcome::kHit;
  double begin = std::max(0.0, leg.distance_of(position_));
  while (true) {
    if (at_limit()) return Outcome::kLimit;
    if (budget() <= kNoWayLeft) {
      footing_.reset();
      begin_slice();
      if (struck_) {
        // Pushed from behind it just goes on. Else it has hit what ran into it: which of the two
        // moved last hangs on the slices.
        if (!free_towards(leg.aim())) return Outcome::kHit;
        return Outcome::kPushed;
      }
    }
    const std::optional<Hit> hit = first_hit(outline(), leg, begin, departing);
    const double end = hit ? hit->distance : leg.length();
    if (end == kForever && budget() == kForever) return Outcome::kEndless;
    footing_.reset();
    const double reach = begin + budget();
    if (reach < end) {
      if (reach > begin + 1e-6) departing = false;
      begin = reach;
      advance_to(leg.at(reach));
      time_ = slice_end_;
      continue;
    }
    advance_to(hit ? hit->point : leg.through().p);
    if (!hit) return Outcome::kArrived;
    stand_on(hit->composite, hit->edge, hit->along);
    return Outcome::kHit;
  }
}

void Walker::follow_back(int edge_index, double along) {
  while (footing_->edge != edge_index || footing_->along < along) {
    const Composite& composite = outline().composites()[in(footing_->composite)];
    advance_to(composite.nodes[in(edge().from)].p);
    const int previous = edge().previous;
    stand_on(footing_->composite, previous, composite.edges[in(previous)].length);
  }
  const Vec2 from = outline().composites()[in(footing_->composite)].nodes[in(edge().from)].p;
  advance_to(from + along * edge().heading);
  stand_on(footing_->composite, edge_index, along);
}

void Walker::go_to(const Vec2& point) {
  footing_.reset();
  if (budget() <= kNoWayLeft) begin_slice();
  advance_to(point);
}

std::vector<std::string> Walker::names() const {
  if (!footing_) return {};
  std::set<int> obstacles;
  obstacles.insert(outline().pieces()[in(edge().owner.piece)].obstacle);
  for (const Owner& owner : edge().co_owners) {
    obstacles.insert(outline().pieces()[in(owner.piece)].obstacle);
  }
  std::vector<std::string> result;
  result.reserve(obstacles.size());
  for (const int obstacle : obstacles) result.push_back(world_.obstacles()[in(obstacle)].name);
  return result;
}

void Walker::note(EventKind kind) { result_.events.push_back({kind, time_, position_, names()}); }

void Walker::note_at(EventKind kind, const Vec2& point, int piece) {
  Event event{kind, time_, point, {}};
  if (piece >= 0) {
    event.obstacles.push_back(world_.obstacles()[in(outline().pieces()[in(piece)].obstacle)].name);
  }
  result_.events.push_back(std::move(event));
}

TravelResult Walker::finish(Verdict verdict, EventKind last) {
  note(last);
  result_.verdict = verdict;
  result_.time = time_;
  return std::move(result_);
}

}  // namespace rubicon::travel
