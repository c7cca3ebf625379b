#include "src/results/gantt/chart_labels.hpp"

#include <fmt/format.h>

#include "src/results/report/schedule_text.hpp"
#include "src/simulation/schedule/ticks.hpp"

namespace rubicon::gantt {

using interpreter::Ticks;
using report::clock_text;
using taskplan::Schedule;
using taskplan::TaskOutcome;
using taskplan::TaskResult;

std::string moment_label(const Schedule& schedule, Ticks time) {
  return schedule.start_at ? report::date_text(*schedule.start_at, time) : duration_label(time);
}

std::string duration_label(Ticks time) {
  if (time + schedule::kSecond / 2 < schedule::kDay) return clock_text(time);
  const Ticks minutes = (time + schedule::kMinute / 2) / schedule::kMinute;
  return fmt::format("{} d {:02}:{:02}", minutes / 1440, minutes / 60 % 24, minutes % 60);
}

std::string money_label(double amount, const std::string& currency) {
  std::string text = fmt::format("{:.2f}", amount);
  const std::size_t first = text.starts_with('-') ? 1 : 0;
  for (std::size_t place = text.size() - 3; place > first + 3;) {
    place -= 3;
    text.insert(place, "\u202F");  // narrow, and not broken at the end of a line
  }
  return currency.empty() ? text : text + "\u202F" + currency;
}

std::vector<std::string> fact_labels(const Schedule& schedule) {
  std::vector<std::string> facts;
  std::string time = "Process time " + duration_label(schedule.process_time);
  if (schedule.start_at) {
    time += fmt::format(", {} to {}", schedule::text_of(*schedule.start_at),
                        report::date_text(*schedule.start_at, schedule.process_time));
  }
  facts.push_back(std::move(time));
  if (schedule.costed) facts.push_back("Cost " + money_label(schedule.cost, schedule.currency));
  facts.push_back(report::count_text(report::count_tasks(schedule)));
  return facts;
}

std::string stopped_label(int stops, Ticks late) {
  return fmt::format("{} {}, {} late", stops, stops == 1 ? "stop" : "stops", duration_label(late));
}

std::string use_label(const Schedule& schedule, const taskplan::ResourceUse& use) {
  std::string text = fmt::format("{} tasks, {:.0f} % used", use.tasks, 100 * use.utilisation());
  if (use.tasks == 1) text = fmt::format("1 task, {:.0f} % used", 100 * use.utilisation());
  if (use.rate) text += ", " + money_label(use.cost, schedule.currency);
  return text;
}

std::string percent_label(const taskplan::ResourceUse& use) {
  return fmt::format("{:.0f} %", 100 * use.utilisation());
}

std::string task_label(const Schedule& schedule, const TaskOutcome& task, bool critical) {
  std::string text = fmt::format("{}\n{} to {} ({})", task.task, moment_label(schedule, task.start),
                                 moment_label(schedule, task.start + task.duration),
                                 duration_label(task.duration));
  if (!task.robot.empty()) text += "\nmachine: " + task.robot;
  if (!task.crews.empty()) text += "\ncrews: " + report::crew_text(task);
  text +=
      fmt::format("\nmotion {}, work {}", clock_text(task.motion_time), clock_text(task.work_time));
  if (task.waits.machine > 0) text += ", waited for machines " + duration_label(task.waits.machine);
  if (schedule.costed) text += "\ncost " + money_label(task.cost, schedule.currency);
  if (task.due) text += "\ndue " + moment_label(schedule, *task.due);
  if (task.late().value_or(0) > 0) text += ", late by " + duration_label(*task.late());
  if (task.baseline) {
    text += fmt::format("\nbaseline {} to {}", moment_label(schedule, task.baseline->start),
                        moment_label(schedule, task.baseline->finish));
  }
  if (task.floats) {
    text += fmt::format("\ntotal float {}, free float {}", clock_text(task.floats->total),
                        clock_text(task.floats->free));
  }
  if (critical) text += "\non the critical path";
  if (task.result != TaskResult::done) text += fmt::format("\n{}", name_of(task.result));
  if (!task.reason.empty()) text += ": " + task.reason;
  return text;
}

}  // namespace rubicon::gantt
