#include "src/exchange/mesh_io/convex_hull.hpp"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <utility>

namespace rubicon::mesh_io {

namespace {

using math::Vec3;

std::vector<Vec3> decode_points(std::string_view bytes) {
  constexpr std::size_t kPoint = 3 * sizeof(double);
  std::vector<Vec3> points(bytes.size() / kPoint);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::memcpy(points[i].data(), bytes.data() + i * kPoint, kPoint);
  }
  return points;
}

Vec3 middle(const std::vector<Vec3>& points) {
  Vec3 lower = points.front();
  Vec3 upper = points.front();
  for (const Vec3& p : points) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  return lower + (upper - lower) / 2;
}

/// A run of qhull, freed when done.
class Quickhull {
 public:
  /// 0, or the library's error number. `coordinates` must outlive this object.
  int run(std::vector<double>& coordinates) {
    qh_zero(&state_, stderr);
    started_ = true;
    // Qt: facets of more than three corners are cut into triangles. Pp: no warnings.
    std::string command = "qhull Qt Pp";
    return qh_new_qhull(&state_, 3, static_cast<int>(coordinates.size() / 3), coordinates.data(),
                        False, command.data(), nullptr, stderr);
  }

  /// Indices of points, each triangle in the same sense.
  std::vector<std::array<int, 3>> triangles() {
    std::vector<std::array<int, 3>> result;
    for (facetT* facet = state_.facet_list; facet != nullptr && facet->next != nullptr;
         facet = facet->next) {
      std::array<int, 3> triangle{};
      std::size_t count = 0;
      for (setelemT* element = facet->vertices->e; element->p != nullptr; ++element) {
        const auto* const vertex = static_cast<vertexT*>(element->p);
        if (count < 3) triangle[count] = qh_pointid(&state_, vertex->point);
        ++count;
      }
      if (count != 3) continue;  // the surface then has a hole, which is found
      if ((facet->toporient ^ qh_ORIENTclock) != 0) std::swap(triangle[0], triangle[1]);
      result.push_back(triangle);
    }
    return result;
  }

  Quickhull() = default;
  Quickhull(const Quickhull&) = delete;
  Quickhull& operator=(const Quickhull&) = delete;
  ~Quickhull() {
    if (started_) qh_freeqhull(&state_, qh_ALL);
  }

 private:
  qhT state_{};
  bool started_ = false;
};

}  // namespace

SceneMessage hull_of_points(std::string_view bytes) {
  const std::vector<Vec3> points = decode_points(bytes);
  constexpr std::size_t kMostPoints = std::numeric_limits<int>::max() / 3;
  if (points.size() < 4) return std::string("it has fewer than four corners; a hull needs a body");
  if (points.size() > kMostPoints) return std::string("it has too many corners for a hull");
  // Around the origin the library's rounding is least.
  const Vec3 centre = middle(points);
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Vec3& p : points) {
    for (int k = 0; k < 3; ++k) coordinates.push_back(p[k] - centre[k]);
  }
  Quickhull hull;
  const int error = hull.run(coordinates);
  if (error == qh_ERRsingular) {
    return std::string("its corners lie in one plane; a hull needs a body, so leave out 'hull'");
  }
  if (error == qh_ERRmem) return std::string("its hull needs too much memory; simplify it");
  if (error != 0) return std::string("its hull cannot be found; leave out 'hull', or simplify it");

  FileScene scene;
  scene.in_metres = true;
  FileNode node;
  std::vector<int> place(points.size(), -1);
  for (std::array<int, 3> triangle : hull.triangles()) {
    for (int& corner : triangle) {
      const auto point = static_cast<std::size_t>(corner);
      if (place[point] < 0) {
        place[point] = static_cast<int>(node.vertices.size());
        node.vertices.push_back(points[point]);
      }
      corner = place[point];
    }
    node.triangles.push_back(triangle);
  }
  scene.nodes.push_back(std::move(node));
  return scene;
}

}  // namespace rubicon::mesh_io
