#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace rubicon::verify {

/// Time in whole nanoseconds from the beginning of the plan.
using Ticks = std::int64_t;
inline constexpr Ticks kSecond = 1'000'000'000;
inline constexpr Ticks kMinute = 60 * kSecond;
inline constexpr Ticks kHour = 60 * kMinute;
inline constexpr Ticks kDay = 24 * kHour;

/// Times are compared to this (1 us). Reason: a double holds a time of a year to 4 ns, and the
/// length of a step comes from values that are rounded themselves. Consequence: a clock that is off
/// by less is not seen.
inline constexpr Ticks kTimeSlack = 1'000;

/// What cannot be read: not JSON, not a trace, members missing or of the wrong type.
class UnreadableInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class FaultKind {
  order,
  clock,
  motion,
  contact,
  load,
  resource,
  shift,
  link,
  support,
  joint,
  schedule,
  report
};
enum class ResultFile { trace, schedule_json, schedule_csv, loads_csv, report };

/// One thing that is wrong with a result, and where.
struct Fault {
  FaultKind kind = FaultKind::order;
  ResultFile file = ResultFile::trace;
  int line = 0;      ///< of the file, from 1; 0: of the whole file
  std::string task;  ///< "" if it belongs to none
  Ticks time = -1;   ///< -1: at no moment
  std::string text;
};

using Faults = std::vector<Fault>;

/// The one word of a kind that machines read.
const char* name_of(FaultKind kind);
/// trace.jsonl, schedule.json, schedule.csv, report.html.
const char* name_of(ResultFile file);

}  // namespace rubicon::verify
