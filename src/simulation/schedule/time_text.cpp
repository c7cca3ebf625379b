#include "src/simulation/schedule/time_text.hpp"

#include <fmt/format.h>

namespace rubicon::schedule {

std::string clock_text(Ticks ticks) {
  const Ticks seconds = (ticks + kSecond / 2) / kSecond;
  return fmt::format("{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

std::string duration_text(Ticks ticks) {
  std::string text;
  if (ticks >= kHour) text += fmt::format("{} h ", ticks / kHour);
  if (ticks % kHour >= kMinute) text += fmt::format("{} min ", ticks % kHour / kMinute);
  const Ticks rest = ticks % kMinute;
  if (rest != 0 || text.empty()) {
    return text + fmt::format("{} s", static_cast<double>(rest) / static_cast<double>(kSecond));
  }
  text.pop_back();
  return text;
}

}  // namespace rubicon::schedule
