#include "src/exchange/mesh_io/mesh_format.hpp"

#include <array>

namespace rubicon::mesh_io {

namespace {

constexpr std::array<MeshFormat, 7> kFormats = {{{"stl", "STL", false, false},
                                                 {"obj", "OBJ", false, false},
                                                 {"ply", "PLY", false, false},
                                                 {"dae", "Collada", true, false},
                                                 {"gltf", "glTF", true, true},
                                                 {"glb", "glTF", true, true},
                                                 {"ifc", "IFC", true, false}}};

}  // namespace

std::optional<MeshFormat> format_of(const std::string& path) {
  const std::size_t dot = path.find_last_of("./");
  if (dot == std::string::npos || path[dot] != '.') return std::nullopt;
  std::string extension = path.substr(dot + 1);
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  for (const MeshFormat& format : kFormats) {
    if (format.extension == extension) return format;
  }
  return std::nullopt;
}

}  // namespace rubicon::mesh_io
