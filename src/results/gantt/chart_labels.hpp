#pragma once

#include <string>
#include <vector>

#include "src/simulation/taskplan/schedule.hpp"

namespace rubicon::gantt {

/// A moment as a date and time, or as a duration where the plan has no date.
std::string moment_label(const taskplan::Schedule& schedule, interpreter::Ticks time);

/// "4:10:07"; of a day and more "12 d 04:10", as on the report page.
std::string duration_label(interpreter::Ticks time);

/// An amount of money with two digits, thousands apart: "66 865.05 EUR".
std::string money_label(double amount, const std::string& currency);

/// Process time, cost and what became of the tasks.
std::vector<std::string> fact_labels(const taskplan::Schedule& schedule);

/// How a robot or crew was used, in short.
std::string use_label(const taskplan::Schedule& schedule, const taskplan::ResourceUse& use);

/// The same, shorter: "16 %".
std::string percent_label(const taskplan::ResourceUse& use);

/// How often something with a timetable was stopped, and for how long: "2 stops, 0:00:04 late".
std::string stopped_label(int stops, interpreter::Ticks late);

/// All about a task, in lines.
std::string task_label(const taskplan::Schedule& schedule, const taskplan::TaskOutcome& task,
                       bool critical);

}  // namespace rubicon::gantt
