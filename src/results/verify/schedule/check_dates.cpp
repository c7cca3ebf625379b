#include "src/results/verify/schedule/check_dates.hpp"

#include <fmt/format.h>

#include <utility>

#include "src/results/verify/schedule/civil_date.hpp"

namespace rubicon::verify {

namespace {

/// Whole minutes, downwards.
std::int64_t minutes_of(Ticks time) {
  return time >= 0 ? time / kMinute : -((-time + kMinute - 1) / kMinute);
}

/// Whether a date is the minute of a moment. Where the moment is within rounding of a full minute,
/// either side of it is.
bool is_date_of(const Scene& scene, const std::string& date, Ticks time) {
  const std::int64_t minute = minute_number(date) - minute_number(scene.start_at);
  return minute == minutes_of(time) || minute == minutes_of(time - kTimeSlack) ||
         minute == minutes_of(time + kTimeSlack);
}

/// What is wrong with a date; "" if nothing is.
std::string mistake_of(const Scene& scene, const char* what, const std::string& date, Ticks time) {
  if (scene.start_at.empty()) {
    return date.empty() ? "" : fmt::format("'{}' is {}, and the plan has no dates", what, date);
  }
  if (date.empty()) return fmt::format("'{}' is missing", what);
  constexpr std::size_t kLength = 16;  // YYYY-MM-DD HH:MM
  if (date.size() == kLength && is_date_of(scene, date, time)) return "";
  return fmt::format("'{}' is {}, which is not {} min after {}", what, date, minutes_of(time),
                     scene.start_at);
}

}  // namespace

void check_dates(const Scene& scene, const std::vector<ScheduleRow>& rows, ResultFile file,
                 Faults& faults) {
  for (const ScheduleRow& row : rows) {
    for (std::string text : {mistake_of(scene, "begins", row.begins, row.start),
                             mistake_of(scene, "ends", row.ends, row.start + row.duration)}) {
      if (text.empty()) continue;
      faults.push_back({FaultKind::schedule, file, row.line, row.task, row.start, std::move(text)});
    }
    if (!row.baseline || file != ResultFile::schedule_json) continue;
    for (const std::string& text :
         {mistake_of(scene, "begins", row.baseline_begins, row.baseline->first),
          mistake_of(scene, "ends", row.baseline_ends, row.baseline->second)}) {
      if (text.empty()) continue;
      faults.push_back(
          {FaultKind::schedule, file, row.line, row.task, row.start, "of its baseline " + text});
    }
  }
}

void check_whole(const Scene& scene, const ScheduleJson& schedule, Faults& faults) {
  const auto whole = [&](std::string text) {
    faults.push_back({FaultKind::schedule, ResultFile::schedule_json, 0, "", -1, std::move(text)});
  };
  if (schedule.start_at != scene.start_at) {
    whole(fmt::format("the plan begins at '{}', in the trace at '{}'", schedule.start_at,
                      scene.start_at));
  }
  std::string ends = mistake_of(scene, "ends", schedule.ends, schedule.process_time);
  if (!ends.empty()) whole(std::move(ends));
  if (schedule.cost && schedule.currency != scene.currency) {
    whole(fmt::format("the cost is in '{}', in the trace in '{}'", schedule.currency,
                      scene.currency));
  }
}

}  // namespace rubicon::verify
