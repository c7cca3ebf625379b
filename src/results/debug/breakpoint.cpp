#include "src/results/debug/breakpoint.hpp"

#include <fmt/format.h>

namespace rubicon::debug {

namespace {

bool meets(const Breakpoint& breakpoint, const Refusal& refusal) {
  if (refusal.met.empty()) return false;
  const auto pair = [&](const std::string& one, const std::string& other) {
    return breakpoint.one == one && (breakpoint.other.empty() || breakpoint.other == other);
  };
  return pair(refusal.moved, refusal.met) || pair(refusal.met, refusal.moved);
}

bool is_at(const Breakpoint& breakpoint, const Recording& recording, const Event& event) {
  if (event.kind != EventKind::attempt && event.kind != EventKind::enter &&
      event.kind != EventKind::which) {
    return false;
  }
  const Place* place = recording.place_of(event);
  return place != nullptr && place->line == breakpoint.line && place->file == breakpoint.file;
}

}  // namespace

bool matches(const Breakpoint& breakpoint, const Recording& recording, const Event& event) {
  const bool refused = event.kind == EventKind::attempt && !event.ok;
  switch (breakpoint.kind) {
    case Breakpoint::Kind::line:
      return is_at(breakpoint, recording, event);
    case Breakpoint::Kind::refused:
      return refused;
    case Breakpoint::Kind::hit:
      return refused && !recording.refusals[event.other].met.empty();
    case Breakpoint::Kind::pair:
      return refused && meets(breakpoint, recording.refusals[event.other]);
    case Breakpoint::Kind::task:
      return false;
  }
  return false;
}

std::string breakpoint_text(const Breakpoint& breakpoint, const Recording& recording) {
  switch (breakpoint.kind) {
    case Breakpoint::Kind::line:
      return fmt::format("{}:{}", recording.files[breakpoint.file].name, breakpoint.line);
    case Breakpoint::Kind::refused:
      return "refused";
    case Breakpoint::Kind::hit:
      return "hit";
    case Breakpoint::Kind::pair:
      return fmt::format("pair {}{}{}", breakpoint.one, breakpoint.other.empty() ? "" : " ",
                         breakpoint.other);
    case Breakpoint::Kind::task:
      return "task " + breakpoint.one;
  }
  return {};
}

}  // namespace rubicon::debug
