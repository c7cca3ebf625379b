#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "interpreter/check/bare_seconds.hpp"
#include "interpreter/check/check_number.hpp"
#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

std::optional<schedule::Ticks> resolve_date_of_plan(Subject& subject, const syntax::String& date) {
  const auto time = resolve_civil_time(subject, date);
  if (!time) return std::nullopt;
  if (!subject.model.start_at) {
    const auto is_start = [](const auto& use) { return use.what == "start_at"; };
    const bool is_wrong =
        std::any_of(subject.model.uses.begin(), subject.model.uses.end(), is_start);
    if (is_wrong || subject.plan.broken) return std::nullopt;  // told there
    subject.error("P10", date.span,
                  "a date says nothing in a plan that does not say when it begins",
                  "give the plan start_at \"2026-03-02 07:00\", or write a duration after its "
                  "beginning, such as 8 h");
    return std::nullopt;
  }
  const auto ticks = schedule::ticks_between(*subject.model.start_at, *time);
  if (!ticks) {
    subject.error("P10", date.span,
                  fmt::format("{} is more than 126 years from the beginning of the plan, {}",
                              date.text, schedule::text_of(*subject.model.start_at)));
  }
  return ticks;
}

}  // namespace

std::optional<schedule::CivilTime> resolve_civil_time(Subject& subject,
                                                      const syntax::String& written) {
  const auto time = schedule::parse_civil_time(written.text);
  if (!time) {
    subject.error("P10", written.span,
                  fmt::format("expected a date and time such as \"2026-03-02 07:00\", found \"{}\"",
                              written.text),
                  schedule::parse_date(written.text)
                      ? fmt::format("say at what time of the day: \"{} 07:00\"", written.text)
                      : "");
  }
  return time;
}

void warn_of_bare_seconds(Subject& subject, const syntax::Number& number, const std::string& what,
                          double seconds) {
  if (seconds == 0 || number.unit != syntax::UnitKind::none) return;
  subject.diagnostics.warning(
      "P22", number.span,
      fmt::format("{0} {1:g} has no unit and is taken as {1:g} s", what, seconds),
      fmt::format("write {0:g} s, {0:g} min or {0:g} h", std::fabs(seconds)));
}

std::optional<double> resolve_duration(Subject& subject, const syntax::Number& number,
                                       const std::string& what) {
  const auto seconds = bounded(subject, number, syntax::UnitKind::time, what, 0, kMaxDuration);
  if (seconds) warn_of_bare_seconds(subject, number, what, *seconds);
  return seconds;
}

std::optional<schedule::Ticks> resolve_moment(Subject& subject, const syntax::Moment& moment,
                                              const std::string& what) {
  if (moment.date) return resolve_date_of_plan(subject, *moment.date);
  const auto seconds = resolve_duration(subject, *moment.after_start, what);
  if (!seconds) return std::nullopt;
  return schedule::ticks_from_seconds(*seconds);
}

}  // namespace rubicon::interpreter::plan_check
