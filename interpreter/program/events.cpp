#include "interpreter/program/events.hpp"

#include <cmath>

namespace rubicon::interpreter {

Ticks ticks_from_seconds(double seconds) {
  // Half away from zero, without the rounding mode; saturates far beyond any construction site (292
  // years).
  constexpr double kLargest = 9.2e18;
  const double ticks = seconds * kTicksPerSecond;
  if (!(ticks < kLargest)) return static_cast<Ticks>(kLargest);
  if (ticks < -kLargest) return -static_cast<Ticks>(kLargest);
  return static_cast<Ticks>(ticks < 0 ? -std::floor(-ticks + 0.5) : std::floor(ticks + 0.5));
}

const char* name_of(LoopKind kind) {
  switch (kind) {
    case LoopKind::chain:
      return "chain";
    case LoopKind::cycle:
      return "cycle";
    case LoopKind::first:
      return "first";
  }
  return "";
}

std::string reason_text(const Attempt& attempt) {
  switch (attempt.refusal) {
    case Refusal::none:
      return "";
    case Refusal::at_goal:
      return "at goal";
    case Refusal::no_direction:
      return "no direction";
    case Refusal::limit:
      return "limit " + attempt.limit;
    case Refusal::hit:
      return "hit";
  }
  return "";
}

}  // namespace rubicon::interpreter
