#include "src/cli/set_option.hpp"

#include <CLI/CLI.hpp>

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

interpreter::ParameterTexts parameter_texts(const std::vector<std::string>& given) {
  interpreter::ParameterTexts result;
  for (const std::string& text : given) {
    const std::size_t equals = text.find('=');
    result.emplace_back(text.substr(0, equals), text.substr(equals + 1));
  }
  return result;
}

}  // namespace rubicon::cli
