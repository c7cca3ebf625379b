#pragma once

#include <optional>
#include <string>

#include "interpreter/syntax/diagnostic.hpp"
#include "interpreter/syntax/file_provider.hpp"
#include "src/exchange/project_io/project.hpp"

namespace rubicon::cli {

/// Reads a schedule of another program from the disk; what is wrong or doubtful goes into
/// `diagnostics`. Nothing if it cannot be read.
std::optional<project_io::Project> read_schedule(const std::string& path,
                                                 interpreter::FileProvider& disk,
                                                 interpreter::SourceMap& sources,
                                                 interpreter::Diagnostics& diagnostics);

/// Says on stderr how many tasks wait for resources, and how long at most.
void tell_levelling(const project_io::Project& project);

}  // namespace rubicon::cli
