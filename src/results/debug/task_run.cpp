#include "src/results/debug/task_run.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "src/results/debug/clean_text.hpp"

namespace rubicon::debug {

namespace {

/// A state is kept after so many events: to go back replays at most as many, some microseconds of
/// work, and the states take a small part of the memory of the events.
constexpr std::size_t kBetweenCheckpoints = 1024;

}  // namespace

std::uint32_t TaskRun::add_row(trace::Configuration q) {
  if (q.size() > kMostParameters) {
    throw std::invalid_argument("this is no line of a trace: too many parameters");
  }
  if (parameters_.empty()) {
    for (const auto& [name, value] : q) {
      keys_.emplace_back(name);
      parameters_.push_back(clean_text(name));
    }
  }
  const std::size_t width = parameters_.size();
  bool same = q.size() == width;
  for (std::size_t i = 0; same && i < width; ++i) same = q[i].name == keys_[i];
  if (!same) {
    throw std::invalid_argument(
        "this is no line of a trace: its 'q' is of another robot than before");
  }
  const bool stays =
      rows_.size() >= width &&
      std::equal(q.begin(), q.end(), rows_.end() - static_cast<std::ptrdiff_t>(width),
                 [](const auto& one, double value) { return one.value == value; });
  if (!stays) {
    for (const auto& [name, value] : q) rows_.push_back(value);
  }
  return width == 0 ? 0 : static_cast<std::uint32_t>(rows_.size() / width - 1);
}

void TaskRun::add(Event event, trace::Configuration q) {
  // In what begins a loop `row` is where it ends.
  const bool tells = event.kind == EventKind::attempt || event.kind == EventKind::end;
  if (tells && !q.empty()) event.row = add_row(q);
  if (event.kind == EventKind::exit) {
    if (last_.loops.empty() || last_.loops.back().place != event.place ||
        last_.loops.back().kind != event.text) {
      throw std::invalid_argument("this is no line of a trace: no such loop runs");
    }
    events_[last_.loops.back().entered].row = static_cast<std::uint32_t>(events_.size());
  }
  if ((event.kind == EventKind::enter && last_.loops.size() >= kMostLoops) ||
      (event.kind == EventKind::set && last_.variables.size() >= kMostVariables)) {
    throw std::invalid_argument("this is no line of a trace: too many loops or variables");
  }
  if (events_.size() % kBetweenCheckpoints == 0) checkpoints_.push_back(last_);
  events_.push_back(event);
  apply(event, last_);
}

TaskState TaskRun::state_at(std::size_t position) const {
  if (checkpoints_.empty()) return {};
  position = std::min(position, events_.size());
  TaskState state = checkpoints_[std::min(position / kBetweenCheckpoints, checkpoints_.size() - 1)];
  while (state.position < position) apply(events_[state.position], state);
  return state;
}

std::vector<double> TaskRun::configuration(std::uint32_t row) const {
  const std::size_t width = parameters_.size();
  if (row != kNone) {
    const double* first = rows_.data() + row * width;
    return std::vector<double>(first, first + width);
  }
  std::vector<double> values(width, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < width; ++i) {
    const auto known = before_.find(keys_[i]);
    if (known != before_.end()) values[i] = known->second;
  }
  return values;
}

std::map<std::string, double, std::less<>> TaskRun::ended_at() const {
  std::map<std::string, double, std::less<>> q;
  const std::vector<double> values = configuration(last_.row);
  for (std::size_t i = 0; i < values.size(); ++i) q[keys_[i]] = values[i];
  return q;
}

void TaskRun::close() {
  events_.shrink_to_fit();
  rows_.shrink_to_fit();
  checkpoints_.shrink_to_fit();
}

}  // namespace rubicon::debug
