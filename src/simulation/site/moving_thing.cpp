#include "src/simulation/site/moving_thing.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace rubicon::site {

namespace {

/// ns; how far ahead a thing looks.
constexpr Ticks kWindow = schedule::kSecond;

/// Most windows of a stretch between two places, so that a way of days does not fill the memory.
constexpr Ticks kMostWindows = 10'000;

collision::SweptQuery window_query(const collision::BodyPtr& body,
                                   const collision::BodyPtr& overhead,
                                   const geometry::Motion& motion, double contact_tolerance) {
  collision::SweptQuery query;
  query.contact_tolerance = contact_tolerance;
  query.items.push_back({{body.get(), motion}, true});
  if (overhead) query.items.push_back({{overhead.get(), motion}, false});
  return query;
}

}  // namespace

MovingThing::MovingThing(std::string name, collision::BodyPtr body, collision::BodyPtr overhead,
                         geometry::Timetable timetable, double contact_tolerance)
    : name_(std::move(name)),
      body_(std::move(body)),
      overhead_(std::move(overhead)),
      timetable_(std::move(timetable)),
      contact_tolerance_(contact_tolerance) {
  for (std::size_t i = 0; i + 1 < timetable_.places.size(); ++i) {
    const Ticks from = timetable_.places[i].time;
    const Ticks to = timetable_.places[i + 1].time;
    const bool stays = !geometry::motions_between(timetable_, from, to).front().motion.moves();
    const Ticks length = stays ? to - from : std::max(kWindow, (to - from) / kMostWindows);
    for (Ticks begin = from; begin < to; begin += length) {
      add_windows(
          geometry::motions_between(timetable_, begin, std::min(begin + length, to)).front());
    }
  }
}

void MovingThing::add_windows(const geometry::TimedMotion& stretch) {
  const collision::SweptQuery swept =
      window_query(body_, overhead_, stretch.motion, contact_tolerance_);
  const collision::Bounds bounds = collision::MovingBodies(swept).bounds();
  reach_.add(bounds);
  windows_.push_back({stretch.from, stretch.to, stretch.motion, bounds, {}, {}, {}, {}, {}, {}});
}

void MovingThing::go_on(Ticks now) {
  assert(state_.stop);
  state_.delay += now - state_.stop->since;
  state_.stop.reset();
}

bool MovingThing::is_gone(Ticks now) const {
  return !timetable_.repeat && own_time(now) >= timetable_.end();
}

bool MovingThing::is_present(Ticks now) const {
  const Ticks own = own_time(now);
  if (own < timetable_.begin() || is_gone(now)) return false;
  // What comes on later comes when its first second is free.
  return !(state_.stop && own == timetable_.begin() && own > 0);
}

Ticks MovingThing::passed(Ticks own) const {
  if (!timetable_.repeat || own < timetable_.begin()) return 0;
  return (own - timetable_.begin()) / period() * period();
}

int MovingThing::window_at(Ticks now) const {
  const Ticks own = own_time(now) - passed(own_time(now));
  const auto next =
      std::upper_bound(windows_.begin(), windows_.end(), own,
                       [](Ticks time, const Window& each) { return time < each.from; });
  return std::max(0, static_cast<int>(next - windows_.begin()) - 1);
}

int MovingThing::window_after(Ticks now, int ahead) const {
  const int window = window_at(now) + ahead;
  if (window < windows()) return window;
  return timetable_.repeat ? window % windows() : -1;
}

Ticks MovingThing::window_begin(Ticks now, int ahead) const {
  const Ticks own = own_time(now);
  const int window = window_at(now) + ahead;
  const Ticks passages = passed(own) + window / windows() * period();
  return schedule::within_time(at(window % windows()).from + passages + state_.delay +
                               (state_.stop ? now - state_.stop->since : 0));
}

Ticks MovingThing::next_window(Ticks now) const {
  const Ticks own = own_time(now);
  if (own < timetable_.begin()) return schedule::within_time(timetable_.begin() + now - own);
  return window_after(now, 1) < 0 ? schedule::kEndOfTime : window_begin(now, 1);
}

Ticks MovingThing::last_time() const {
  return timetable_.repeat ? schedule::kEndOfTime
                           : schedule::within_time(timetable_.end() + state_.delay);
}

const collision::SweptQuery& MovingThing::query(int window) const {
  const Window& asked = at(window);
  if (!asked.query) {
    asked.query = std::make_shared<const collision::SweptQuery>(
        window_query(body_, overhead_, asked.motion, contact_tolerance_));
  }
  return *asked.query;
}

const ReservedVolume& MovingThing::volume_of(int window, bool overhead, bool standing) const {
  const Window& asked = at(window);
  auto& kept = overhead ? (standing ? asked.standing_overhead : asked.overhead)
                        : (standing ? asked.standing : asked.volume);
  if (!kept) {
    std::vector<ReservedPart> parts;
    parts.push_back({overhead ? overhead_ : body_,
                     standing ? geometry::stationary(asked.motion.pose(0)) : asked.motion, 0});
    kept = std::make_shared<const ReservedVolume>(std::move(parts),
                                                  reserved_growth(contact_tolerance_));
  }
  return *kept;
}

const ReservedVolume& MovingThing::volume(Ticks now) const {
  return volume_of(window_at(now), false, state_.stop.has_value());
}

const ReservedVolume& MovingThing::overhead(Ticks now) const {
  return volume_of(window_at(now), true, state_.stop.has_value());
}

std::optional<ReservedVolume::Hit> MovingThing::meets(collision::MovingBodies& bodies, Ticks now,
                                                      Ticks until, bool with_overhead) const {
  if (bodies.bounds().disjoint(reach_) || is_gone(now)) return std::nullopt;
  const bool stands = state_.stop.has_value();
  if (stands) {
    if (!is_present(now)) return std::nullopt;
    return volume_of(window_at(now), with_overhead, true).meets(bodies);
  }
  const bool is_here = is_present(now);
  for (int ahead = 0; ahead <= windows(); ++ahead) {
    const int window = window_after(now, ahead);
    if (window < 0) break;
    if ((ahead > 0 || !is_here) && window_begin(now, ahead) >= until) break;
    if (bodies.bounds().disjoint(bounds(window))) continue;
    if (auto hit = volume_of(window, with_overhead, false).meets(bodies)) return hit;
  }
  return std::nullopt;
}

}  // namespace rubicon::site
