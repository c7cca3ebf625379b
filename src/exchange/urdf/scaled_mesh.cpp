#include "src/exchange/urdf/scaled_mesh.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <utility>

namespace rubicon::urdf {

std::string scaled_mesh_text(const geometry::TriangleMesh& mesh, const Triple& scale) {
  std::string text = "# Scaled by rubicon import.\n";
  auto out = std::back_inserter(text);
  for (const auto& p : mesh.vertices) {
    fmt::format_to(out, "v {} {} {}\n", p.x() * scale[0], p.y() * scale[1], p.z() * scale[2]);
  }
  const bool mirrored = scale[0] * scale[1] * scale[2] < 0;
  for (std::array<int, 3> each : mesh.triangles) {
    if (mirrored) std::swap(each[1], each[2]);
    fmt::format_to(out, "f {} {} {}\n", each[0] + 1, each[1] + 1, each[2] + 1);
  }
  return text;
}

}  // namespace rubicon::urdf
