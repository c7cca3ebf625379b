#pragma once

#include <string>
#include <vector>

#include "interpreter/expand/expand.hpp"

namespace CLI {
class App;
}

namespace rubicon::cli {

/// Declares `--set NAME=VALUE`, which may be given many times.
void declare_set(CLI::App& app, std::vector<std::string>& given);

/// What it gave, in that order.
interpreter::ParameterTexts parameter_texts(const std::vector<std::string>& given);

}  // namespace rubicon::cli
