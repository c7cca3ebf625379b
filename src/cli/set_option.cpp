#include "src/cli/set_option.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <string_view>

namespace rubicon::cli {

void declare_set(CLI::App& app, std::vector<std::string>& given) {
  const auto well_formed = [](const std::string& text) -> std::string {
    const std::size_t equals = text.find('=');
    if (equals != 0 && equals != std::string::npos && equals + 1 != text.size()) return {};
    return "expected NAME=VALUE, such as bays=6, found '" + text + "'";
  };
  app.add_option("--set", given)
      ->expected(1)
      ->take_all()
      ->check(CLI::Validator(well_formed, "NAME=VALUE"));
}

namespace {

/// Numbers of more digits are not the same in every reader of JSON.
constexpr std::uint64_t kMostSeed = 9'007'199'254'740'991;

std::optional<std::uint64_t> whole_number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && value <= kMostSeed ? std::optional(value) : std::nullopt;
}

}  // namespace

void declare_sample(CLI::App& app, std::string& given) {
  const auto well_formed = [](const std::string& text) -> std::string {
    if (sample_spec(text)) return {};
    return "expected SEED or SEED:RUN, such as 7 or 7:12, found '" + text + "'";
  };
  app.add_option("--sample", given)->check(CLI::Validator(well_formed, "SEED"));
}

std::optional<interpreter::SampleSpec> sample_spec(const std::string& given) {
  const std::size_t colon = given.find(':');
  const auto seed = whole_number(std::string_view(given).substr(0, colon));
  if (!seed) return std::nullopt;
  if (colon == std::string::npos) return interpreter::SampleSpec{*seed, 0};
  const auto run = whole_number(std::string_view(given).substr(colon + 1));
  if (!run) return std::nullopt;
  return interpreter::SampleSpec{*seed, *run};
}

interpreter::ParameterTexts parameter_texts(const std::vector<std::string>& given) {
  interpreter::ParameterTexts result;
  for (const std::string& text : given) {
    const std::size_t equals = text.find('=');
    result.emplace_back(text.substr(0, equals), text.substr(equals + 1));
  }
  return result;
}

}  // namespace rubicon::cli
