#include "src/results/debug/number_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rubicon::debug {

std::string number_text(double value) {
  return std::isnan(value) ? std::string("?") : fmt::format("{:g}", value + 0.0);
}

std::string change_text(double before, double after) {
  const std::string from = number_text(before);
  const std::string to = number_text(after);
  if (from != to || before == after) return from + " -> " + to;
  return fmt::format("{} -> {}", before, after);
}

std::string seconds_text(double seconds) {
  std::string text = fmt::format("{:.3f}", seconds + 0.0);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text + " s";
}

}  // namespace rubicon::debug
