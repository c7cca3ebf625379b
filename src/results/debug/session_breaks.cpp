#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "src/results/debug/session.hpp"

namespace rubicon::debug {

namespace {

/// More breakpoints than this help nobody, and every one costs time at every record.
constexpr std::size_t kMostBreakpoints = 100;

/// Of the lines near a wrong one so many are told.
constexpr std::size_t kShownLines = 3;

/// "; near it are 14, 16" for a line at which nothing is tried.
std::string lines_near(const Recording& recording, const Breakpoint& breakpoint) {
  std::vector<int> lines = lines_with_records(recording, breakpoint.file);
  if (std::find(lines.begin(), lines.end(), breakpoint.line) != lines.end()) return {};
  std::stable_sort(lines.begin(), lines.end(), [&](int a, int b) {
    return std::abs(a - breakpoint.line) < std::abs(b - breakpoint.line);
  });
  lines.resize(std::min(lines.size(), kShownLines));
  std::sort(lines.begin(), lines.end());
  return lines.empty() ? "; nothing is tried in this file"
                       : fmt::format("; nothing is tried there, but at {}", fmt::join(lines, ", "));
}

}  // namespace

std::string Session::add_break(const Words& words) {
  if (breakpoints_.size() >= kMostBreakpoints) return "these are enough breakpoints: delete some\n";
  const std::optional<Place> place = here();
  const auto answer =
      breakpoint_of(words, recording_, place ? place->file : recording_.files.size());
  if (const auto* message = std::get_if<std::string>(&answer)) return *message + "\n";
  Breakpoint breakpoint = std::get<Breakpoint>(answer);
  breakpoint.number = ++last_breakpoint_;
  breakpoints_.push_back(breakpoint);
  return fmt::format(
      "breakpoint {}: {}{}\n", breakpoint.number, breakpoint_text(breakpoint, recording_),
      breakpoint.kind == Breakpoint::Kind::line ? lines_near(recording_, breakpoint) : "");
}

std::string Session::list_breaks() const {
  std::string text;
  for (const Breakpoint& each : breakpoints_) {
    text += fmt::format("{:3}  {}\n", each.number, breakpoint_text(each, recording_));
  }
  return text.empty() ? "no breakpoints\n" : text;
}

std::string Session::delete_break(const Words& words) {
  if (words.empty()) {
    breakpoints_.clear();
    return "all breakpoints are gone\n";
  }
  const auto found =
      std::find_if(breakpoints_.begin(), breakpoints_.end(), [&](const Breakpoint& each) {
        return words.size() == 1 && std::to_string(each.number) == words.front();
      });
  if (found == breakpoints_.end()) {
    return fmt::format("there is no breakpoint {}\n", fmt::join(words, " "));
  }
  breakpoints_.erase(found);
  return fmt::format("breakpoint {} is gone\n", words.front());
}

}  // namespace rubicon::debug
