#include "src/exchange/urdf/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "src/motion/math/angles.hpp"

namespace rubicon::urdf {

namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

}  // namespace

std::optional<double> number_of(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

std::optional<std::vector<double>> numbers_of(std::string_view text) {
  std::vector<double> result;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const std::size_t end = std::min(text.find_first_of(kBlanks), text.size());
    const std::optional<double> value = number_of(text.substr(0, end));
    if (!value) return std::nullopt;
    result.push_back(*value);
    text.remove_prefix(end);
  }
  return result;
}

std::string text_of(double value) { return fmt::format("{}", value == 0 ? 0.0 : value); }

double degrees_of(double radians) {
  constexpr double kWhole = 1e-9;
  const double degrees = math::degrees(radians);
  const double whole = std::round(degrees);
  return std::fabs(degrees - whole) < kWhole ? whole : degrees;
}

}  // namespace rubicon::urdf
