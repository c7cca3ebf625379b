#include "src/simulation/schedule/time_text.hpp"

#include <fmt/format.h>

namespace rubicon::schedule {

std::string clock_text(Ticks ticks) {
  const Ticks seconds = (ticks + kSecond / 2) / kSecond;
  return fmt::format("{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

}  // namespace rubicon::schedule
