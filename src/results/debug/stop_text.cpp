#include "src/results/debug/stop_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/results/debug/number_text.hpp"
#include "src/results/report/schedule_text.hpp"

namespace rubicon::debug {

namespace {

/// Later than this (s) no date is told: nanoseconds would not fit their integer.
constexpr double kLatestDate = 9e9;

std::string trimmed(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(' ');
  return begin == std::string::npos ? std::string() : line.substr(begin);
}

/// "jib.theta  -36 -> -34" for each parameter that was to move.
std::string motion_text(const Recording& recording, const TaskRun& run, const TaskState& state,
                        const Event& event) {
  const Command& command = recording.commands[event.text];
  const std::vector<double> before = run.configuration(state.row_before);
  const std::vector<double> after = run.configuration(state.row);
  std::string text = command.text.substr(0, command.text.find(' '));
  const auto& names = run.parameters();
  for (const std::string& parameter : command.parameters) {
    const auto found = std::find(names.begin(), names.end(), parameter);
    text += fmt::format("{}{}", parameter == command.parameters.front() ? " " : ",  ", parameter);
    if (found == names.end()) continue;
    const auto i = static_cast<std::size_t>(found - names.begin());
    text += "  " + (event.ok ? change_text(before[i], after[i]) : number_text(after[i]));
  }
  return text;
}

std::string attempt_text(const Recording& recording, const TaskRun& run, const TaskState& state,
                         const Event& event, const Paint& paint) {
  const std::string moved = motion_text(recording, run, state, event);
  if (event.ok) return fmt::format("{}  {}", moved, paint.good("accepted"));
  return fmt::format(
      "{}  {}", moved,
      paint.bad("refused: " + recording.refusal_text(recording.refusals[event.other])));
}

std::string beginning_text(const Recording& recording, const TaskRun& run) {
  const PlannedTask* task = recording.task_of(run);
  std::string text;
  if (run.undone() && task != nullptr) {
    text += fmt::format("  what follows did not happen: it is {} and was undone\n", task->result);
    if (!task->reason.empty()) text += fmt::format("  reason: {}\n", task->reason);
  }
  const Event& first = run.events().front();
  if (first.kind == EventKind::task_start && first.text != kNone) {
    text += fmt::format("  {}\n", recording.texts[first.text]);
  }
  return text;
}

std::string head_text(const Recording& recording, const TaskRun& run, const TaskState& state,
                      const Paint& paint) {
  std::string text = paint.bold(recording.texts[run.name()]);
  const EventKind kind =
      state.position == 0 ? EventKind::task_start : run.events()[state.position - 1].kind;
  if (state.position == 0) {
    text += "  begins";
  } else if (kind == EventKind::attempt || kind == EventKind::wait) {
    text +=
        fmt::format("  {} {}/{}", kind == EventKind::wait ? "wait" : "try", state.n, run.last().n);
  } else if (state.n > 0) {
    text += fmt::format("  after {}/{}", state.n, run.last().n);
  }
  const double t = state.position == 0 ? run.events().front().t : state.t;
  text += "  " + time_text(recording, t);
  if (run.undone()) text += "  " + paint.bad("did not happen");
  return text + "\n";
}

std::string line_text(const Recording& recording, const Event& event, const Paint& paint) {
  const Place* place = recording.place_of(event);
  if (place == nullptr) return {};
  const std::string* line = recording.line(*place);
  return fmt::format("  {}  {}\n", paint.mark(recording.place_text(*place)),
                     line == nullptr ? std::string() : trimmed(*line));
}

/// The whole time from its begin to its end.
std::string duration_text(const Event& event) { return seconds_text(event.t - event.value); }

std::string pause_text(const std::string& why, const std::string& whom) {
  if (why == "machine") return whom + " was in the way";
  if (why == "crew" || why == "truck") return "waited for " + whom;
  if (why == "held") return "was done, and held by its link to " + whom;
  if (why == "repair") return whom + " was under repair";
  if (why == "lift") return "its lift waited for a shift: " + whom;
  return "out of shift";
}

}  // namespace

std::string time_text(const Recording& recording, double t) {
  std::string text = "t " + seconds_text(t);
  if (recording.start_at && t >= 0 && t < kLatestDate) {
    text += fmt::format("  ({})", report::moment_text(*recording.start_at, std::llround(t * 1e9)));
  }
  return text;
}

std::string record_text(const Recording& recording, const TaskRun& run, const Event& event) {
  const std::string& text = recording.texts[event.text];
  const std::string& other = recording.texts[event.other];
  switch (event.kind) {
    case EventKind::task_start:
      return "the task begins";
    case EventKind::goal:
      return fmt::format("waypoint {} of {} begins", event.n, event.value);
    case EventKind::set:
      return fmt::format("var({}) = {}", text, number_text(event.value));
    case EventKind::enter:
      return text + " begins";
    case EventKind::exit:
      return fmt::format("{} ends {}, {} {}", text, event.ok ? "reached" : "exhausted", event.value,
                         event.value == 1 ? "success" : "successes");
    case EventKind::which:
      return "which: " + text;
    case EventKind::attempt:
      return fmt::format(
          "{}  {}", recording.commands[event.text].text,
          event.ok ? "accepted"
                   : "refused: " + recording.refusal_text(recording.refusals[event.other]));
    case EventKind::wait:
      return "wait";
    case EventKind::work:
      return fmt::format("{}{}: {}", text, other.empty() ? std::string() : " by " + other,
                         seconds_text(event.value));
    case EventKind::pause:
      return fmt::format("pause: {}: {}", pause_text(text, other), duration_text(event));
    case EventKind::attach:
      return text + " hangs on the tool";
    case EventKind::detach:
      return text + " is put down";
    case EventKind::remove:
      return text + " leaves the site";
    case EventKind::end:
      return fmt::format("the motion ends {}, {} tried, {} accepted{}{}", text, event.n,
                         event.value, other.empty() ? "" : ": ", other);
    case EventKind::task_end:
      return fmt::format("{} is {}{}{}", recording.texts[run.name()], text,
                         other.empty() ? "" : ": ", other);
    case EventKind::turn:
      return fmt::format("{} is turned by {:.6g} degrees about the vertical", text, event.value);
    case EventKind::stop:
      return "the machine comes to a stop";
    case EventKind::think:
      return fmt::format("the guide has thought: {} checks", event.n);
    case EventKind::guide:
      return event.ok ? fmt::format("guide {} has a way ({} nodes, {} checks)", text, event.n,
                                    event.value)
                      : fmt::format("guide {}: {}", text, other);
    case EventKind::cold_joint:
      return fmt::format("a cold joint from {}: what was laid first had lain {:.1f} min", text,
                         event.value / 60);
    case EventKind::moving:
    case EventKind::breakdown:
    case EventKind::lost_days:
    case EventKind::forbidden:
      break;
    case EventKind::soil:
      return fmt::format("the bucket has taken {:.3f} m3 of {}", event.value * 1e-9, text);
    case EventKind::foreseen:
      return fmt::format("the way meets what {} is foreseen to sweep within {:g} s", text,
                         event.value);
    case EventKind::way_point:
      return fmt::format("waypoint {} of {} of the guide begins", event.n, event.value);
  }
  return {};
}

std::string stop_text(const Recording& recording, const TaskRun& run, const TaskState& state,
                      const Paint& paint) {
  std::string text = head_text(recording, run, state, paint);
  if (state.position == 0) return text + beginning_text(recording, run);
  const Event& event = run.events()[state.position - 1];
  text += line_text(recording, event, paint);
  if (event.kind == EventKind::attempt) {
    return text + "  " + attempt_text(recording, run, state, event, paint) + "\n";
  }
  if (event.kind == EventKind::wait) {
    const double before = run.state_at(state.position - 1).t;
    return text + fmt::format("  wait  {}\n", seconds_text(event.t - before));
  }
  return text + "  " + record_text(recording, run, event) + "\n";
}

std::string situation_text(const Recording& recording, const TaskRun& run, const TaskState& state) {
  const PlannedTask* task = recording.task_of(run);
  const std::string moves = task == nullptr ? std::string() : task->moves;
  const bool carries = state.carries != kNone;
  if (!state.moving) {
    return carries ? fmt::format("no motion goes on; {} hangs on the tool",
                                 recording.texts[state.carries])
                   : std::string("no motion goes on");
  }
  std::string what = "going";
  if (carries) {
    what = (state.carried == 0 ? "carrying " : "placing ") + recording.texts[state.carries];
  } else if (!moves.empty()) {
    what = "on the way to " + moves;
  }
  return fmt::format("motion {} of {}: {}; waypoint {}", state.motion, run.motions(), what,
                     state.way_point);
}

}  // namespace rubicon::debug
