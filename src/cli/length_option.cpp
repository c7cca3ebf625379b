#include "src/cli/length_option.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

namespace rubicon::cli {

std::optional<std::string> take_length(const char* option, const std::string& text, double least,
                                       double most, double& length) {
  if (text.empty()) return std::nullopt;
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  std::string_view unit(rest, static_cast<std::size_t>(end - rest));
  while (unit.starts_with(' ')) unit.remove_prefix(1);
  const double metres = unit == "mm" ? 1e-3 : unit == "cm" ? 1e-2 : unit == "m" ? 1 : 0;
  if (error != std::errc() || metres == 0) {
    return fmt::format("{} takes a length such as \"5 mm\" or \"0.5 m\", found '{}'", option, text);
  }
  if (!(value * metres >= least && value * metres <= most)) {
    return fmt::format("{} is from {} to {} m, found '{}'", option, least, most, text);
  }
  length = value * metres;
  return std::nullopt;
}

}  // namespace rubicon::cli
