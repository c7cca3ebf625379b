#include "src/exchange/project_io/plan_terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "src/exchange/project_io/plan_text.hpp"

namespace rubicon::project_io {

namespace {

/// Largest crew that a plan takes.
constexpr double kMaxCrew = 1e6;
/// Largest cost per hour that is written; anything more is damage.
constexpr double kMaxCost = 1e9;

/// The number of at most 12 digits that is nearest.
double without_rounding(double value) {
  const std::string text = fmt::format("{:.12g}", value);
  double rounded = value;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return rounded;
}

}  // namespace

Moment plan_start(const Project& project) {
  std::string start = project.start.text;
  if (start.empty()) {
    for (const Task& task : project.tasks) {
      if (!task.start.text.empty() && (start.empty() || task.start.text < start)) {
        start = task.start.text;
      }
    }
  }
  return {start.substr(0, 16)};
}

std::int64_t plan_seconds(const Task& task) {
  return std::clamp<std::int64_t>(task.duration.seconds, 0,
                                  static_cast<std::int64_t>(kMaxPlanSeconds));
}

bool runs_day_and_night(const Task& task) {
  return task.format.elapsed && task.duration.seconds > 0;
}

bool goes_by_itself(const Task& task) {
  return task.ignores_resource_calendars && task.calendar != kNone;
}

bool works_always(const Project& project, std::int64_t calendar) {
  if (calendar == kNone) return false;
  const auto found = std::find_if(project.calendars.begin(), project.calendars.end(),
                                  [&](const Calendar& each) { return each.uid == calendar; });
  if (found == project.calendars.end() || found->base != kNone || !found->exceptions.empty()) {
    return false;
  }
  const DayTimes whole_day{{0, 1440}};
  return std::all_of(found->week.begin(), found->week.end(),
                     [&](const std::optional<DayTimes>& day) { return day == whole_day; });
}

double crew_size(const Resource& resource) {
  return std::floor(std::clamp(resource.max_units, 1.0, kMaxCrew));
}

double crew_people(double units, double size) {
  return std::round(std::clamp(units, 1.0, std::max(size, 1.0)));
}

std::optional<double> cost_per_hour(const Resource& resource, double size) {
  constexpr int kPerPiece = 8;
  if (resource.rate_format == kPerPiece) return std::nullopt;
  const double cost = resource.standard_rate * size;
  if (!(cost > 0) || cost > kMaxCost) return std::nullopt;
  // 123 shared by seven was written as 17.571428571428573: what comes back is 123 again.
  return size == 1 ? cost : without_rounding(cost);
}

std::int64_t crew_calendar(const Project& project, const Resource& resource) {
  return resource.calendar != kNone ? resource.calendar : project.calendar;
}

Calendar calendar_of(const PlanCalendar& plan, std::int64_t uid, const std::string& name) {
  Calendar calendar;
  calendar.uid = uid;
  calendar.name = name;
  for (std::size_t day = 0; day < 7; ++day) calendar.week[day] = plan.week[day];
  for (const std::string& date : plan.off) calendar.exceptions.push_back({date, date, {}, ""});
  return calendar;
}

}  // namespace rubicon::project_io
