#include "src/motion/travel/travel.hpp"

#include <stdexcept>
#include <utility>

#include "src/motion/travel/methods.hpp"

namespace rubicon::travel {
namespace {

/// East stays, north becomes south: what has been on the left hand is on the right hand.
Vec2 mirrored(const Vec2& p) { return {p.x(), -p.y()}; }

void mirror(TravelQuery& query, TravelSettings& settings) {
  query.start = mirrored(query.start);
  query.destination = mirrored(query.destination);
  settings.compass = mirrored(settings.compass);
  for (Obstacle& obstacle : query.obstacles) {
    for (auto& part : obstacle.parts) {
      for (Vec2& corner : part) corner = mirrored(corner);
    }
    for (Placement& placement : obstacle.timetable) {
      placement.place = mirrored(placement.place);
      placement.heading_deg = -placement.heading_deg;
    }
  }
}

void mirror(TravelResult& result) {
  for (Event& event : result.events) event.point = mirrored(event.point);
  for (WayPoint& corner : result.way) corner.point = mirrored(corner.point);
}

void require_standing(Method method, const TravelQuery& query) {
  if (method != Method::kBug1 && method != Method::kVisBug21) return;
  for (const Obstacle& obstacle : query.obstacles) {
    if (obstacle.timetable.size() < 2) continue;
    throw std::invalid_argument(std::string(name_of(method)) +
                                " knows standing obstacles only, and one moves: " + obstacle.name);
  }
}

TravelResult run(Method method, const TravelQuery& query, const TravelSettings& settings) {
  Walker walker(query, settings);
  const ExactPoint start(walker.start());
  if (walker.outline().covers(start)) {
    return walker.finish(Verdict::kUnreachable, EventKind::kCovered);
  }
  if (walker.start() == walker.destination()) {
    return walker.finish(Verdict::kReached, EventKind::kReached);
  }
  std::optional<Bound> bound;
  if (method == Method::kBug1) {
    bound = bug1_bound(walker.outline(), walker.start(), walker.destination());
  } else if (method == Method::kBug2) {
    bound = bug2_bound(walker.outline(), walker.start(), walker.destination());
  }
  TravelResult result;
  switch (method) {
    case Method::kBug1:
      result = travel_bug1(std::move(walker));
      break;
    case Method::kBug2:
      result = travel_bug2(std::move(walker));
      break;
    case Method::kVisBug21:
      result = travel_visbug21(std::move(walker));
      break;
    case Method::kPledge:
      result = travel_pledge(std::move(walker));
      break;
    default:
      result = travel_tangent(std::move(walker), method);
  }
  result.bound = bound;
  return result;
}

}  // namespace

std::string_view name_of(Method method) {
  constexpr std::string_view kNames[] = {"bug1",   "bug2",    "visbug21", "pledge",
                                         "simple", "tangent", "ace"};
  return kNames[static_cast<std::size_t>(method)];
}

std::string_view name_of(EventKind kind) {
  constexpr std::string_view kNames[] = {
      "covered", "hit",    "leave",    "nearest", "clear", "track",   "tracked moves",
      "revisit", "target", "squeezed", "escaped", "back",  "reached", "limit"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string_view name_of(Verdict verdict) {
  constexpr std::string_view kNames[] = {"reached", "unreachable", "limit"};
  return kNames[static_cast<std::size_t>(verdict)];
}

TravelResult travel(Method method, const TravelQuery& query, const TravelSettings& settings) {
  require_standing(method, query);
  if (settings.hand == Hand::kRight) return run(method, query, settings);
  TravelQuery other_query = query;
  TravelSettings other_settings = settings;
  mirror(other_query, other_settings);
  TravelResult result = run(method, other_query, other_settings);
  mirror(result);
  return result;
}

}  // namespace rubicon::travel
