#pragma once

#include <cstdint>

namespace rubicon::mesh_io {

/// How often what costs time in proportion to a file was done: once for each file, however many of
/// its parts are asked for.
struct SceneWork {
  std::uint64_t hashed = 0;   ///< files read for their digest
  std::uint64_t parsed = 0;   ///< files read by the helper
  std::uint64_t decoded = 0;  ///< scenes taken from the helper or the user's cache folder
};

}  // namespace rubicon::mesh_io
