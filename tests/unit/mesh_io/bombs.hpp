#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/unit/mesh_io/mesh_files_io.hpp"

namespace rubicon::mesh_io::testing {

/// Where a bomb is laid: its own folder, and one beside it that nobody may look into.
struct Place {
  const TemporaryFolder& inside;
  const TemporaryFolder& outside;
  std::string secret() const { return (outside.path() / "secret.bin").string(); }
};

struct Bomb {
  std::string name;
  std::function<std::string(const Place&)> lay;  ///< the path of the mesh
};

/// All of them.
std::vector<Bomb> bombs();

/// Names and contents of files that differ from bombs in one thing only, and are in order.
std::vector<std::pair<std::string, std::string>> harmless_files();

}  // namespace rubicon::mesh_io::testing
