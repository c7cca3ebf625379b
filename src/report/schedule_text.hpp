#pragma once

#include <string>

#include "src/taskplan/schedule.hpp"

namespace rubicon::report {

/// A table for people: task, robot, crew, start and duration as h:mm:ss, steps tried and accepted,
/// result with the reason; then the process time.
std::string schedule_table(const taskplan::Schedule& schedule);

/// {"tasks":[{task,robot,crew,start,duration,tried,accepted,result,reason}],"process_time":s};
/// times in seconds.
std::string schedule_json(const taskplan::Schedule& schedule);

/// The same columns as CSV (RFC 4180, line ends "\n"), a header line first.
std::string schedule_csv(const taskplan::Schedule& schedule);

/// h:mm:ss, rounded to seconds.
std::string clock_text(interpreter::Ticks ticks);

}  // namespace rubicon::report
