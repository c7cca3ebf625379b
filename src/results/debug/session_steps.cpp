#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

#include "interpreter/syntax/diagnostic.hpp"
#include "src/results/debug/session.hpp"
#include "src/results/debug/stop_text.hpp"

namespace rubicon::debug {

namespace {

/// Of what a step passes so many records are told.
constexpr std::size_t kShownRecords = 12;

bool is_stop(const Event& event) {
  return event.kind == EventKind::attempt || event.kind == EventKind::wait;
}

template <typename Number>
std::optional<Number> number_of(const std::string& word) {
  Number number{};
  const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
  if (read.ec != std::errc() || read.ptr != word.data() + word.size()) return std::nullopt;
  return number;
}

/// How often: 1 without a word.
std::optional<std::int64_t> times(const std::vector<std::string>& words) {
  if (words.empty()) return 1;
  return words.size() == 1 ? number_of<std::int64_t>(words.front()) : std::nullopt;
}

std::string no_count(const std::vector<std::string>& words) {
  return fmt::format("'{}' is no number of steps\n", fmt::join(words, " "));
}

/// Seconds, or h:mm:ss.
std::optional<double> seconds_of(const std::string& word) {
  if (word.find(':') == std::string::npos) {
    const auto seconds = number_of<double>(word);
    return seconds && std::isfinite(*seconds) ? seconds : std::nullopt;
  }
  double total = 0;
  int parts = 0;
  for (std::size_t begin = 0; begin <= word.size(); ++parts) {
    const std::size_t colon = std::min(word.find(':', begin), word.size());
    const auto part = number_of<double>(word.substr(begin, colon - begin));
    if (!part || !(*part >= 0 && *part < 1e9)) return std::nullopt;
    total = total * 60 + *part;
    begin = colon + 1;
  }
  return parts == 3 ? std::optional(total) : std::nullopt;
}

}  // namespace

bool Session::next_record(Cursor& cursor) const {
  if (cursor.position < run_at(cursor).size()) {
    ++cursor.position;
  } else if (cursor.run + 1 < scope_.size()) {
    cursor = {cursor.run + 1, 0};
  } else {
    return false;
  }
  return true;
}

bool Session::record_before(Cursor& cursor) const {
  if (cursor.position > 0) {
    --cursor.position;
  } else if (cursor.run > 0) {
    --cursor.run;
    cursor.position = run_at(cursor).size();
  } else {
    return false;
  }
  return true;
}

bool Session::next_stop(Cursor& cursor) const {
  if (!next_record(cursor)) return false;
  const std::span<const Event> events = run_at(cursor).events();
  while (cursor.position > 0 && cursor.position < events.size() &&
         !is_stop(events[cursor.position - 1])) {
    ++cursor.position;
  }
  return true;
}

bool Session::stop_before(Cursor& cursor) const {
  if (!record_before(cursor)) return false;
  const std::span<const Event> events = run_at(cursor).events();
  while (cursor.position > 0 && cursor.position < events.size() &&
         !is_stop(events[cursor.position - 1])) {
    --cursor.position;
  }
  return true;
}

Session::Cursor Session::end_of_scope() const {
  Cursor end{scope_.size() - 1, 0};
  end.position = run_at(end).size();
  return end;
}

/// Where the motion ends that goes on, or else the next one; the end of the run if none does.
std::size_t Session::end_of_motion() const {
  const std::span<const Event> events = run().events();
  for (std::size_t i = at_.position; i < events.size(); ++i) {
    if (events[i].kind == EventKind::end) return i + 1;
  }
  return events.size();
}

const Breakpoint* Session::stopped_by(const Cursor& cursor) const {
  const TaskRun& run = run_at(cursor);
  for (const Breakpoint& each : breakpoints_) {
    if (cursor.position == 0) {
      if (each.kind == Breakpoint::Kind::task && each.one == recording_.texts[run.name()]) {
        return &each;
      }
    } else if (matches(each, recording_, run.events()[cursor.position - 1])) {
      return &each;
    }
  }
  return nullptr;
}

const Breakpoint* Session::run_on(Cursor& cursor, const Cursor& last) const {
  while (!(cursor == last) && next_record(cursor)) {
    if (const Breakpoint* found = stopped_by(cursor)) return found;
  }
  return nullptr;
}

const Breakpoint* Session::run_back(Cursor& cursor) const {
  while (record_before(cursor)) {
    if (const Breakpoint* found = stopped_by(cursor)) return found;
  }
  return nullptr;
}

std::string Session::go(const Cursor& to, const Breakpoint* why) {
  at_ = to;
  state_ = run().state_at(at_.position);
  std::string text;
  if (why != nullptr) {
    text = paint_.mark(
               fmt::format("breakpoint {}, {}", why->number, breakpoint_text(*why, recording_))) +
           "\n";
  }
  return text + stop_text(recording_, run(), state_, paint_);
}

/// The records between two stops, in short lines.
std::string Session::passed(const Cursor& from, const Cursor& to) const {
  if (from.run != to.run || to.position <= from.position + 1) return {};
  const TaskRun& run = run_at(to);
  const std::size_t count = to.position - 1 - from.position;
  const std::size_t first = to.position - 1 - std::min(count, kShownRecords);
  std::string text;
  if (count > kShownRecords) text += fmt::format("  ... {} before\n", count - kShownRecords);
  for (std::size_t i = first; i + 1 < to.position; ++i) {
    const Event& event = run.events()[i];
    const Place* place = recording_.place_of(event);
    text += fmt::format("  {}{}\n", record_text(recording_, run, event),
                        place == nullptr ? "" : "  " + recording_.place_text(*place));
  }
  return paint_.on ? paint_.dim(text) : text;
}

std::string Session::step(const Words& words) {
  const auto count = times(words);
  if (!count || *count < 1) return no_count(words);
  Cursor cursor = at_;
  Cursor before = at_;
  for (std::int64_t i = 0; i < *count; ++i) {
    const Cursor last = cursor;
    if (!next_stop(cursor)) break;
    before = last;
  }
  if (cursor == at_) return "this is the end\n";
  const std::string between = *count == 1 ? passed(before, cursor) : std::string();
  return between + go(cursor);
}

std::string Session::back(const Words& words) {
  const auto count = times(words);
  if (!count || *count < 1) return no_count(words);
  Cursor cursor = at_;
  for (std::int64_t i = 0; i < *count && stop_before(cursor); ++i) {
  }
  return cursor == at_ ? "this is the beginning\n" : go(cursor);
}

std::string Session::record(const Words& words) {
  const auto count = times(words);
  if (!count || *count == 0) return no_count(words);
  Cursor cursor = at_;
  for (std::int64_t i = 0; i < *count && next_record(cursor); ++i) {
  }
  for (std::int64_t i = 0; i > *count && record_before(cursor); --i) {
  }
  if (cursor == at_) return *count > 0 ? "this is the end\n" : "this is the beginning\n";
  return go(cursor);
}

std::string Session::to_end_of_loop(std::size_t loops_out) {
  if (at_ == end_of_scope()) return "this is the end\n";
  Cursor target = at_;
  if (at_.position == run().size()) {
    target = {at_.run + 1, 0};
  } else if (state_.loops.size() > loops_out) {
    const LoopState& loop = state_.loops[state_.loops.size() - 1 - loops_out];
    const std::uint32_t exit = run().events()[loop.entered].row;
    target.position = exit == kNone ? end_of_motion() : exit + 1;
  } else {
    target.position = end_of_motion();
  }
  Cursor cursor = at_;
  const Breakpoint* found = run_on(cursor, target);
  return go(cursor, found);
}

std::string Session::go_on() {
  if (at_ == end_of_scope()) return "this is the end\n";
  Cursor cursor = at_;
  const Breakpoint* found = run_on(cursor, end_of_scope());
  return (found == nullptr ? "no breakpoint up to the end\n" : "") + go(cursor, found);
}

std::string Session::go_back() {
  if (at_ == Cursor{}) return "this is the beginning\n";
  Cursor cursor = at_;
  const Breakpoint* found = run_back(cursor);
  return (found == nullptr ? "no breakpoint back to the beginning\n" : "") + go(cursor, found);
}

std::string Session::run_to(const Words& words) {
  const bool to = words.size() == 2 && words.front() == "to";
  const auto number = to || words.size() == 1 ? number_of<std::int64_t>(words.back())
                                              : std::optional<std::int64_t>();
  if (!number) return "run to what? run to N, the number of a try\n";
  const std::span<const Event> events = run().events();
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (is_stop(events[i]) && events[i].n == *number) return go({at_.run, i + 1});
  }
  return fmt::format("there is no try {} in this task: they are 1 to {}\n", *number,
                     run().last().n);
}

std::string Session::until(const Words& words) {
  const auto time = words.size() == 1 ? seconds_of(words.front()) : std::optional<double>();
  if (!time) return "until when? until T, in seconds or as h:mm:ss\n";
  const std::span<const Event> events = run().events();
  for (std::size_t i = 0; i < events.size(); ++i) {
    const bool stop = is_stop(events[i]) || i + 1 == events.size();
    if (stop && events[i].t >= *time) return go({at_.run, i + 1});
  }
  return fmt::format("this task ends before, at {}\n", time_text(recording_, run().last().t));
}

std::string Session::go_to_task(const Words& words) {
  if (words.size() != 1) return "which task? task NAME or task NUMBER; tasks lists them\n";
  std::vector<std::string> names;
  for (std::size_t i = 0; i < recording_.runs.size(); ++i) {
    const std::string& name = recording_.texts[recording_.runs[i].name()];
    names.push_back(name);
    if (name != words[0] && std::to_string(i + 1) != words[0]) continue;
    if (!only_.empty()) set_scope(name);
    const auto in_scope = std::find(scope_.begin(), scope_.end(), i);
    if (in_scope == scope_.end()) continue;
    return go({static_cast<std::size_t>(in_scope - scope_.begin()), 0});
  }
  const std::string near = interpreter::did_you_mean(words[0], names);
  return fmt::format("no task '{}' began{}\n", words[0],
                     near.empty() ? "" : "; did you mean " + near + "?");
}

}  // namespace rubicon::debug
