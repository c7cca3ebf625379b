#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "src/results/golden/tolerance.hpp"

namespace rubicon::golden {

/// A golden is written by people too: what a task is called may be missing ("").
std::string task_name(const nlohmann::ordered_json& task);

/// Where what a golden says of tasks differs from what is found: a line for each task, with what
/// was expected and what was found; empty if there is no difference.
std::string task_difference(const nlohmann::ordered_json& expected,
                            const nlohmann::ordered_json& found, const Tolerance& tolerance);

/// Of a time or cost of the plan: "process_time: expected 90 s, found 95 s (5 s more)"; empty if
/// it is near enough.
std::string total_difference(const std::string& what, const nlohmann::ordered_json& expected,
                             const nlohmann::ordered_json& found, const Tolerance& tolerance);

}  // namespace rubicon::golden
