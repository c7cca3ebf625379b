#include "src/simulation/schedule/critical_chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <tuple>

#include "src/simulation/schedule/index.hpp"
#include "src/simulation/schedule/time_text.hpp"

namespace rubicon::schedule {

namespace {

/// What nobody plans to the nanosecond: whole seconds from a minute on, else tenths; rounded, or
/// down to what is certain.
std::string about_text(Ticks ticks, bool down) {
  const Ticks unit = ticks < kMinute ? kSecond / 10 : kSecond;
  return duration_text((ticks + (down ? 0 : unit / 2)) / unit * unit);
}

std::string link_text(const Link& link) {
  std::string text = name_of(link.type);
  if (link.lag != 0) {
    text += link.lag > 0 ? " + " : " - ";
    text += duration_text(link.lag > 0 ? link.lag : -within_time(link.lag));
    if (link.clock == LagClock::working) text += " of work";
  }
  return text;
}

/// What is followed back: the start of a task, its finish, or a moment between at which it let
/// something go.
enum class Moment { start, midway, finish };
struct Event {
  int task = -1;
  Moment moment = Moment::finish;
  Ticks time = 0;
  std::optional<Parking> parking = {};  ///< of a machine that went out of the way
};

ChainStep step_of(const Network& network, const TaskTimes& own, const Event& event) {
  ChainStep step;
  step.task = event.task;
  step.work_counts = event.moment != Moment::start && network.tasks[at(event.task)].work > 0;
  if (event.parking) {
    step.held = event.parking->held;
    step.resource = event.parking->resource;
    step.task_before = event.parking->task_before;
    step.given_back_midway = event.parking->midway;
    step.repaired = event.parking->repaired;
    step.wanted = event.parking->wanted;
    return step;
  }
  if (event.moment == Moment::finish && own.finish_link >= 0) {
    step.at_finish = true;
    step.work_counts = false;
    step.held = Held::link;
    step.link = own.finish_link;
    step.wanted = own.finish;
    return step;
  }
  const auto waits_for = [&](const MidWait& wait) {
    step.held = wait.held;
    step.resource = wait.resource;
    step.task_before = wait.task_before;
    step.given_back_midway = true;
    step.parking = wait.parking;
    step.wanted = wait.until;
    step.thing = wait.thing;
    step.delayed = wait.delayed;
    return step;
  };
  for (auto wait = own.mid_waits.rbegin(); wait != own.mid_waits.rend(); ++wait) {
    if (event.moment == Moment::start || wait->until > event.time) continue;
    if (wait->held == Held::shift) {
      step.shift_waits += wait->until - wait->since;
      step.first_gain = wait->first_gain;
      if (!wait->missed) continue;
      step.midway = step.missed = true;
      MidWait cause{wait->missed->until, Held::resource};
      cause.resource = wait->missed->resource;
      cause.task_before = wait->missed->task_before;
      return waits_for(cause);
    }
    step.midway = true;
    return waits_for(*wait);
  }
  const auto& zone = own.start_wait;
  if (zone && event.time >= zone->wait.until) return waits_for(zone->wait);
  if (zone) {
    step.could_start = true;
    step.work_counts = false;
  }
  step.held = own.held;
  step.link = own.link;
  step.resource = own.resource;
  step.task_before = own.task_before;
  step.wanted = own.wanted;
  step.out_of_shift = (zone ? zone->since : own.start) - own.wanted;
  if (step.out_of_shift > 0) step.first_gain = own.first_gain;
  step.given_back_midway = own.given_back_midway;
  step.kept = own.kept;
  step.repaired = own.repaired;
  return step;
}

/// The event that held a step; none for the first. Sets the step's task before.
Event cause_of(const Network& network, const NetworkTimes& times, ChainStep& step) {
  if (step.held == Held::link) {
    const Link& link = network.tasks[at(step.task)].after[at(step.link)];
    step.task_before = link.task;
    const TaskTimes& before = times.tasks[at(link.task)];
    // Work that is known tells its finish when it starts.
    const TaskTimes& own = times.tasks[at(step.task)];
    const bool told_at_start = !step.at_finish && own.known_late && before.finish > own.ready;
    if (end_before(link.type) == TaskEnd::start || told_at_start) {
      return {link.task, Moment::start, before.start};
    }
    return {link.task, Moment::finish, before.finish};
  }
  if (step.task_before < 0) return {};
  const Moment moment = step.given_back_midway ? Moment::midway : Moment::finish;
  return {step.task_before, moment, step.wanted, step.parking};
}

}  // namespace

std::vector<ChainStep> critical_chain(const Network& network, const NetworkTimes& times) {
  std::vector<ChainStep> chain;
  const auto last =
      std::max_element(times.tasks.begin(), times.tasks.end(),
                       [](const TaskTimes& a, const TaskTimes& b) { return a.finish < b.finish; });
  if (last == times.tasks.end()) return chain;
  Event event{static_cast<int>(last - times.tasks.begin()), Moment::finish, last->finish};
  // Every event is earlier than the one it led to, or at the same moment another one.
  std::set<std::tuple<int, Moment, Ticks>> seen;
  while (event.task >= 0 && seen.emplace(event.task, event.moment, event.time).second) {
    chain.push_back(step_of(network, times.tasks[at(event.task)], event));
    event = cause_of(network, times, chain.back());
  }
  std::reverse(chain.begin(), chain.end());
  return chain;
}

ChainStep start_step(const Network& network, int task, const TaskTimes& times) {
  ChainStep step = step_of(network, times, {task, Moment::start, times.start});
  step.work_counts = true;
  if (step.held == Held::link) step.task_before = network.tasks[at(task)].after[at(step.link)].task;
  return step;
}

std::string text_of(const Network& network, const ChainStep& step) {
  const NetworkTask& task = network.tasks[at(step.task)];
  std::string text = task.name;
  const std::string starts = step.could_start ? " could start" : " starts";
  if (step.held == Held::plan_start) {
    text += starts + " with the plan";
  } else if (step.held == Held::date) {
    text += fmt::format("{} at its not_before, {} after the beginning of the plan", starts,
                        duration_text(task.not_before));
  } else if (step.held == Held::asked) {
    text += fmt::format(" starts because {} asks for it", network.tasks[at(step.task_before)].name);
  } else if (step.midway || step.held == Held::machine) {
    text += step.missed   ? " misses a shift waiting for "
            : step.midway ? " waits on its way for "
                          : " starts after it waited for ";
    const std::string before =
        step.task_before >= 0 ? network.tasks[at(step.task_before)].name : std::string();
    if (step.held == Held::timetable) {
      text += fmt::format("'{}'{}", step.thing,
                          step.delayed ? ", which came later than its timetable says" : "");
    } else if (step.resource < 0) {
      text += "the zone of " + before;
    } else {
      text += fmt::format("'{}'", network.resources[at(step.resource)].name);
      if (!before.empty()) text += fmt::format(", which {} had", before);
      if (step.held == Held::machine) text += ", to be out of the way";
    }
  } else if (step.held == Held::resource) {
    text += fmt::format("{} when '{}' is {}, which {} had", starts,
                        network.resources[at(step.resource)].name,
                        step.kept       ? "kept for nobody any more"
                        : step.repaired ? "repaired"
                                        : "free",
                        network.tasks[at(step.task_before)].name);
  } else {
    const Link& link = task.after[at(step.link)];
    const std::string& before = network.tasks[at(link.task)].name;
    if (step.at_finish) {
      text += " finishes";
    } else if (end_after(link.type) == TaskEnd::finish) {
      text += starts + " so that it finishes";
    } else {
      text += starts;
    }
    text += fmt::format(" after {} ({})", before, link_text(link));
  }
  if (step.out_of_shift > 0) {
    text += fmt::format(", {} later: the next shift", about_text(step.out_of_shift, false));
  }
  if (step.shift_waits > 0) {
    text += fmt::format(", then waits {} for the next shift", about_text(step.shift_waits, false));
  }
  if (step.first_gain >= kSecond / 10) {
    text += fmt::format(" (less than {} sooner gains nothing)", about_text(step.first_gain, true));
  }
  if (!step.work_counts && task.work > 0) text += "; its own work does not count";
  return text;
}

}  // namespace rubicon::schedule
