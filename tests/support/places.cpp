#include "tests/support/places.hpp"

namespace rubicon::test {

std::string source_dir() { return RUBICON_SOURCE_DIR; }

std::string build_dir() { return RUBICON_BUILD_DIR; }

std::string mesh_helper() { return build_dir() + "/bin/rubicon-mesh"; }

}  // namespace rubicon::test
