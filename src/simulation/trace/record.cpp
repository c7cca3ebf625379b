#include "src/simulation/trace/record.hpp"

#include <charconv>
#include <string>

#include "src/simulation/trace/json_builder.hpp"

namespace rubicon::trace {

double seconds(Ticks time) {
  constexpr Ticks kExact = Ticks{1} << 53;  // 104 days; beyond, a double would be rounded twice
  if (-kExact <= time && time <= kExact) return interpreter::seconds_from_ticks(time);
  std::string text;
  append_seconds(text, time);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace rubicon::trace
