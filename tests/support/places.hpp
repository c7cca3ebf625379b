#pragma once

#include <string>

namespace rubicon::test {

/// The folder of the project, without a slash at the end. The places are functions of one unit,
/// because a path in the options of every test would keep two checkouts from sharing what the
/// compiler cache holds.
std::string source_dir();

/// The folder of the build that the test belongs to.
std::string build_dir();

/// The program that reads meshes, as `rubicon` starts it.
std::string mesh_helper();

}  // namespace rubicon::test
