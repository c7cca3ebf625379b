#include "src/schedule/critical_chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace rubicon::schedule {

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

std::string duration_text(Ticks ticks) {
  if (ticks % kHour == 0) return fmt::format("{} h", ticks / kHour);
  if (ticks % kMinute == 0) return fmt::format("{} min", ticks / kMinute);
  return fmt::format("{} s", static_cast<double>(ticks) / static_cast<double>(kSecond));
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

}  // namespace

std::vector<ChainStep> critical_chain(const Network& network, const NetworkTimes& times) {
  std::vector<ChainStep> chain;
  const auto last =
      std::max_element(times.tasks.begin(), times.tasks.end(),
                       [](const TaskTimes& a, const TaskTimes& b) { return a.finish < b.finish; });
  if (last == times.tasks.end()) return chain;
  int task = static_cast<int>(last - times.tasks.begin());
  TaskEnd end = TaskEnd::finish;
  while (task >= 0) {
    const TaskTimes& own = times.tasks[at(task)];
    const std::vector<Link>& links = network.tasks[at(task)].after;
    ChainStep step;
    step.task = task;
    if (end == TaskEnd::finish && own.finish_link >= 0) {
      step.at_finish = true;
      step.held = Held::link;
      step.link = own.finish_link;
      step.wanted = own.finish;
    } else {
      step.work_counts = end == TaskEnd::finish && network.tasks[at(task)].work > 0;
      step.held = own.held;
      step.link = own.link;
      step.resource = own.resource;
      step.wanted = own.wanted;
      step.out_of_shift = own.start - own.wanted;
      step.first_gain = own.first_gain;
    }
    if (step.held == Held::link) {
      const Link& link = links[at(step.link)];
      step.task_before = link.task;
      end = end_before(link.type);
    } else {
      step.task_before = own.task_before;
      end = TaskEnd::finish;
    }
    chain.push_back(step);
    task = step.task_before;
  }
  std::reverse(chain.begin(), chain.end());
  return chain;
}

std::string text_of(const Network& network, const ChainStep& step) {
  const NetworkTask& task = network.tasks[at(step.task)];
  std::string text = task.name;
  if (step.held == Held::plan_start) {
    text += " starts with the plan";
  } else if (step.held == Held::resource) {
    text += fmt::format(" starts when '{}' is free, which {} had",
                        network.resources[at(step.resource)].name,
                        network.tasks[at(step.task_before)].name);
  } else {
    const Link& link = task.after[at(step.link)];
    const std::string& before = network.tasks[at(link.task)].name;
    if (step.at_finish) {
      text += " finishes";
    } else if (end_after(link.type) == TaskEnd::finish) {
      text += " starts so that it finishes";
    } else {
      text += " starts";
    }
    text += fmt::format(" after {} ({})", before, link_text(link));
  }
  if (step.out_of_shift > 0) {
    text += fmt::format(", {} later: the next shift", duration_text(step.out_of_shift));
  }
  if (!step.work_counts && task.work > 0) text += "; its own work does not count";
  return text;
}

}  // namespace rubicon::schedule
