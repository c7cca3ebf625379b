#include "src/studies/answers/judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/simulation/schedule/ticks.hpp"
#include "src/studies/answers/value_text.hpp"

namespace rubicon::study {

namespace {

constexpr double kNotKnown = 2;
constexpr double kCannotRun = 3;

/// Of a limit that is not held, 0 to 1.
double share_missed(double value, double limit) {
  const double miss = std::abs(value - limit);
  if (!std::isfinite(miss)) return 1;
  return miss == 0 ? 0 : miss / (std::abs(limit) + miss);
}

double limit_of(const Condition& condition, const VariantRuns& variant) {
  if (!condition.date || !variant.start_at) return condition.limit;
  const auto ticks = schedule::ticks_between(*variant.start_at, *condition.date);
  return ticks ? schedule::seconds_from_ticks(*ticks) : std::numeric_limits<double>::infinity();
}

}  // namespace

std::optional<double> measured(const Statistic& statistic, const VariantRuns& variant) {
  const auto question = static_cast<std::size_t>(statistic.question);
  const std::vector<double>& values = variant.values[question];
  const bool missing =
      std::any_of(values.begin(), values.end(), [](double value) { return std::isnan(value); });
  if (values.empty() || missing || (question == kCost && !variant.costed)) return std::nullopt;
  return value_of(statistic, values);
}

Judgement judge(const StudyModel& study, const Choice& rule, const VariantRuns& variant) {
  if (!variant.fault.empty() || variant.runs() == 0) return {"cannot run", 0, kCannotRun};
  const auto asked_of = [&](const Condition& each) {
    return study.questions[static_cast<std::size_t>(each.statistic.question)].asked;
  };
  const bool allows_rejections =
      std::any_of(rule.with.begin(), rule.with.end(),
                  [&](const Condition& each) { return asked_of(each) == Asked::rejected; });
  const std::vector<double>& times = variant.values[kMakespan];
  const auto unfinished =
      std::count_if(times.begin(), times.end(), [](double time) { return !std::isfinite(time); });
  if (unfinished > 0 && !allows_rejections) {
    double tasks = 0;  // that are rejected in a run
    for (const auto& [task, rejection] : variant.rejections) {
      tasks += static_cast<double>(rejection.runs) / static_cast<double>(times.size());
    }
    return {fmt::format("something is rejected in {} of {} runs", unfinished, times.size()), 0,
            1 + tasks / (1 + tasks)};
  }
  Judgement result;
  for (const Condition& each : rule.with) {
    const auto value = measured(each.statistic, variant);
    if (!value) return {fmt::format("{} is not known", each.statistic.text), 0, kNotKnown};
    const double limit = limit_of(each, variant);
    if (each.holds(*value, limit)) continue;
    result.shortfall += share_missed(*value, limit) / static_cast<double>(rule.with.size());
    if (!result.why_not.empty()) continue;
    result.why_not = fmt::format("{} is {}, not {}", each.statistic.text,
                                 value_text(study, each.statistic, *value, variant),
                                 each.text.substr(each.statistic.text.size() + 1));
  }
  if (!result.why_not.empty()) return result;
  const auto value = measured(rule.statistic, variant);
  if (!value) return {fmt::format("{} is not known", rule.statistic.text), 0, kNotKnown};
  if (!std::isfinite(*value)) return {fmt::format("{} is never", rule.statistic.text), 0, 1};
  result.value = *value;
  return result;
}

}  // namespace rubicon::study
