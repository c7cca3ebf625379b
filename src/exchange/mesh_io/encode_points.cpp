#include <cstring>

#include "src/exchange/mesh_io/convex_hull.hpp"

namespace rubicon::mesh_io {

std::string encode_points(const std::vector<math::Vec3>& points) {
  std::string bytes(points.size() * 3 * sizeof(double), '\0');
  char* place = bytes.data();
  for (const math::Vec3& p : points) {
    std::memcpy(place, p.data(), 3 * sizeof(double));
    place += 3 * sizeof(double);
  }
  return bytes;
}

}  // namespace rubicon::mesh_io
