#pragma once

#include <string>

#include "src/exchange/project_io/project.hpp"

namespace rubicon::project_io {

/// The project as Microsoft Project XML (MSPDI), UTF-8. `read_mspdi` of it gives an equal project,
/// for every project that a reader or `project_of` gave. Outline numbers and headings are computed
/// here; exceptions are written in the form of Project 2007 and later.
std::string write_mspdi(const Project& project);

}  // namespace rubicon::project_io
