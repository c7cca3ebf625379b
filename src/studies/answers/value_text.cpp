#include "src/studies/answers/value_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/results/report/schedule_text.hpp"

namespace rubicon::study {

namespace {

std::string time_text(double seconds) {
  const auto ticks = schedule::ticks_from_seconds(seconds);
  return ticks < 0 ? "-" + schedule::clock_text(-ticks) : schedule::clock_text(ticks);
}

/// In quotes for a shell, where that is needed.
std::string quoted(const std::string& text) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '.' || c == '/' || c == '=' || c == '-' || c == ':';
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), plain)) return text;
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
    } else {
      result += c;
    }
  }
  return result + "'";
}

}  // namespace

std::string value_text(Unit unit, double value, const VariantRuns& variant) {
  if (std::isnan(value)) return "-";
  if (std::isinf(value)) return value > 0 ? "never" : "-";
  switch (unit) {
    case Unit::money:
      return fmt::format("{:.2f}", value);
    case Unit::number:
      return fmt::format("{:.3f}", value);
    case Unit::share:
      return fmt::format("{:.1f} %", 100 * value);
    case Unit::moment:
      if (variant.start_at) {
        return report::date_text(*variant.start_at, schedule::ticks_from_seconds(value));
      }
      break;
    case Unit::seconds:
      break;
  }
  return time_text(value);
}

std::string value_text(const StudyModel& study, const Statistic& statistic, double value,
                       const VariantRuns& variant) {
  const Unit unit = unit_of(study.questions[static_cast<std::size_t>(statistic.question)].asked);
  return value_text(statistic.width && unit == Unit::moment ? Unit::seconds : unit, value, variant);
}

std::string settings_text(const interpreter::ParameterTexts& set) {
  if (set.empty()) return "as the plan says";
  std::string text;
  for (const auto& [name, value] : set) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, value);
  }
  return text;
}

std::string run_command(const StudyModel& study, const VariantRuns& variant, std::int64_t run) {
  std::string text = "rubicon run " + quoted(study.plan);
  for (const auto& [name, value] : variant.set) text += " --set " + quoted(name + "=" + value);
  if (study.sampled) text += fmt::format(" --sample {}:{}", study.seed, run);
  return text;
}

}  // namespace rubicon::study
