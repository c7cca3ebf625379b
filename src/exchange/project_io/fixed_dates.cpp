#include "src/exchange/project_io/fixed_dates.hpp"

#include <algorithm>

#include "src/exchange/project_io/dates.hpp"

namespace rubicon::project_io {

std::optional<FixedDates> fixed_dates(const Task& task, const Moment& start) {
  const bool is_point = task.duration.seconds == 0;
  Moment from = task.actual_start, to = task.actual_finish;
  // A milestone may be known by its finish alone.
  if (from.text.empty() && !to.text.empty()) from = is_point ? to : task.start;
  if (from.text.empty() && task.manual) from = task.start;
  if (to.text.empty()) to = is_point ? from : task.finish;
  const auto begin = second_number(start.text), first = second_number(from.text);
  if (!begin || !first || *first - *begin > kFarthestDate) return std::nullopt;
  FixedDates dates;
  dates.start = std::max(*first - *begin, 0LL);
  dates.cut = *first < *begin;
  const auto last = second_number(to.text);
  // Dates that contradict each other or the duration say no more than when it begins.
  const bool makes_sense = last && (*last > *first || (*last == *first && is_point));
  if (makes_sense && *last - *begin <= kFarthestDate) dates.finish = std::max(*last - *begin, 0LL);
  return dates;
}

}  // namespace rubicon::project_io
