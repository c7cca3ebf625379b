#pragma once

#include <optional>

#include "src/cli/commands.hpp"

namespace rubicon::cli {

/// Runs a plan that has a network with policy charts, tarry or fraenkel: the exit code. Nothing for
/// every other plan, and for one with mistakes, which the usual way of loading plans tells.
std::optional<int> run_network(const RunOptions& options);

}  // namespace rubicon::cli
