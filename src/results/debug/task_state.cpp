#include "src/results/debug/task_state.hpp"

#include <algorithm>

namespace rubicon::debug {

namespace {

/// Something directly in the innermost loop is tried or begun.
void count_round(TaskState& state, std::uint32_t place) {
  if (state.loops.empty()) return;
  LoopState& loop = state.loops.back();
  if (loop.first == kNone) loop.first = place;
  if (loop.first == place) ++loop.rounds;
}

void begin_motion(TaskState& state) {
  if (!state.moving) ++state.motion;
  state.moving = true;
}

void enter(const Event& event, TaskState& state) {
  count_round(state, event.place);
  const auto known = std::find_if(state.visits.begin(), state.visits.end(),
                                  [&](const auto& each) { return each.first == event.place; });
  LoopState loop;
  loop.kind = event.text;
  loop.place = event.place;
  loop.entered = state.position;
  if (known != state.visits.end()) {
    loop.visit = ++known->second;
  } else if (state.visits.size() < kMostVisited) {
    loop.visit = 1;
    state.visits.emplace_back(event.place, 1);
  }
  state.loops.push_back(loop);
}

void assign(const Event& event, TaskState& state) {
  const auto known = std::find_if(state.variables.begin(), state.variables.end(),
                                  [&](const auto& each) { return each.first == event.text; });
  if (known == state.variables.end()) {
    state.variables.emplace_back(event.text, event.value);
  } else {
    known->second = event.value;
  }
}

void attempt(const Event& event, TaskState& state) {
  begin_motion(state);
  count_round(state, event.place);
  state.n = event.n;
  ++state.tried;
  state.made += event.ok ? 1 : 0;
  for (LoopState& loop : state.loops) {
    ++loop.tried;
    loop.made += event.ok ? 1 : 0;
  }
  state.row_before = state.row;
  state.row = event.row;
}

void end_motion(const Event& event, TaskState& state) {
  begin_motion(state);
  state.moving = false;
  state.loops.clear();
  state.row_before = state.row;
  state.row = event.row;
  if (state.carries != kNone) ++state.carried;
}

/// A waypoint begins: the script runs anew (docs/trace.md), nothing is remembered.
void restart_script(TaskState& state) {
  state.loops.clear();
  state.variables.clear();
  state.visits.clear();
}

void begin_way_point(const Event& event, TaskState& state) {
  begin_motion(state);
  state.way_point = event.n;
  restart_script(state);
}

}  // namespace

void apply(const Event& event, TaskState& state) {
  switch (event.kind) {
    case EventKind::goal:
      begin_way_point(event, state);
      break;
    case EventKind::way_point:
      restart_script(state);
      break;
    case EventKind::set:
      assign(event, state);
      break;
    case EventKind::enter:
      enter(event, state);
      break;
    case EventKind::exit:
      if (!state.loops.empty()) state.loops.pop_back();
      break;
    case EventKind::attempt:
      attempt(event, state);
      break;
    case EventKind::wait:
      begin_motion(state);
      state.n = event.n;
      ++state.waits;
      break;
    case EventKind::end:
      end_motion(event, state);
      break;
    case EventKind::attach:
      state.carries = event.text;
      break;
    case EventKind::detach:
      state.carries = kNone;
      state.carried = 0;
      break;
    case EventKind::task_start:
    case EventKind::which:
    case EventKind::work:
    case EventKind::turn:
    case EventKind::pause:
    case EventKind::remove:
    case EventKind::task_end:
    case EventKind::stop:
    case EventKind::guide:
    case EventKind::moving:
    case EventKind::cold_joint:
    case EventKind::breakdown:
    case EventKind::lost_days:
    case EventKind::soil:
    case EventKind::foreseen:
    case EventKind::forbidden:
    case EventKind::think:
      break;
  }
  state.t = event.t;
  ++state.position;
}

}  // namespace rubicon::debug
