#pragma once

#include <string>

#include "src/cli/commands.hpp"

namespace rubicon::cli {

/// Whether a file is a map or a scenario of the MovingAI benchmarks, by its name.
bool is_grid_file(const std::string& path);

/// Makes a plan of a map, and of a scenario if there is one.
int import_grid(const ImportOptions& options);

}  // namespace rubicon::cli
