#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rubicon::mesh_io {

/// A file format that is read.
struct MeshFormat {
  std::string_view extension;     ///< lower case, without the dot
  std::string_view name;          ///< as people call it
  bool declares_unit = false;     ///< unit and up axis come with the file or the format
  bool has_parts_beside = false;  ///< may lie in several files (glTF buffers)
};

/// The format by the extension of a file name, case ignored.
std::optional<MeshFormat> format_of(const std::string& path);

/// Extensions that are read, for messages.
inline constexpr std::string_view kKnownExtensions = ".stl, .obj, .ply, .dae, .gltf, .glb or .ifc";

}  // namespace rubicon::mesh_io
