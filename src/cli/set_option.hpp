#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/expand/expand.hpp"

namespace CLI {
class App;
}

namespace rubicon::cli {

/// Declares `--set NAME=VALUE`, which may be given many times.
void declare_set(CLI::App& app, std::vector<std::string>& given);

/// Declares `--sample SEED` or `--sample SEED:RUN`.
void declare_sample(CLI::App& app, std::string& given);

/// What it gave; nothing of "".
std::optional<interpreter::SampleSpec> sample_spec(const std::string& given);

/// What it gave, in that order.
interpreter::ParameterTexts parameter_texts(const std::vector<std::string>& given);

}  // namespace rubicon::cli
