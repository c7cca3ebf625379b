#include "tests/proof/grid_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace rubicon::collision::proof {
namespace {

using Corner = std::array<int, 3>;  ///< indices of planes

/// A rectangle of the surface, between planes; `axis` is its normal's.
struct Face {
  int axis = 0;
  bool outward_up = true;
  Corner lower{};
  Corner upper{};
};

constexpr std::size_t kMostTriangles = 3000;

/// Joins faces of one plane along one axis, then along the other.
void add_faces_of_plane(const GridSolid& solid, int axis, int plane, bool up, bool merged,
                        std::vector<Face>& faces) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  std::vector<std::vector<bool>> open(
      static_cast<std::size_t>(solid.count(v)),
      std::vector<bool>(static_cast<std::size_t>(solid.count(u)), false));
  const auto at = [&](int i, int j) {
    return open[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)];
  };
  for (int j = 0; j < solid.count(v); ++j) {
    for (int i = 0; i < solid.count(u); ++i) {
      Corner below{};
      below[axis] = plane - 1;
      below[u] = i;
      below[v] = j;
      Corner above = below;
      above[axis] = plane;
      const bool inside = solid.has(up ? below : above);
      const bool outside = !solid.has(up ? above : below);
      open[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] = inside && outside;
    }
  }
  for (int j = 0; j < solid.count(v); ++j) {
    for (int i = 0; i < solid.count(u); ++i) {
      if (!at(i, j)) continue;
      int end_i = i + 1;
      int end_j = j + 1;
      while (merged && end_i < solid.count(u) && at(end_i, j)) ++end_i;
      const auto row_is_open = [&](int row) {
        for (int k = i; k < end_i; ++k) {
          if (!at(k, row)) return false;
        }
        return true;
      };
      while (merged && end_j < solid.count(v) && row_is_open(end_j)) ++end_j;
      for (int row = j; row < end_j; ++row) {
        for (int k = i; k < end_i; ++k) {
          open[static_cast<std::size_t>(row)][static_cast<std::size_t>(k)] = false;
        }
      }
      Face face;
      face.axis = axis;
      face.outward_up = up;
      face.lower[axis] = face.upper[axis] = plane;
      face.lower[u] = i;
      face.upper[u] = end_i;
      face.lower[v] = j;
      face.upper[v] = end_j;
      faces.push_back(face);
    }
  }
}

/// The rim of a face, counter-clockwise as seen along the axis from above, with all corners of
/// other faces on it.
std::vector<Corner> rim_of(const Face& face, const std::set<Corner>& corners) {
  const int u = (face.axis + 1) % 3;
  const int v = (face.axis + 2) % 3;
  std::vector<Corner> rim;
  Corner at = face.lower;
  const auto go = [&](int axis, int to) {
    const int step = to > at[axis] ? 1 : -1;
    while (at[axis] != to) {
      if (corners.count(at) > 0) rim.push_back(at);
      at[axis] += step;
    }
  };
  go(u, face.upper[u]);
  go(v, face.upper[v]);
  go(u, face.lower[u]);
  go(v, face.lower[v]);
  return rim;
}

/// Cuts off ears in random order; the polygon is convex, some corners lie in the middle of a side.
void add_ears(std::vector<int> polygon, const Face& face, geometry::TriangleMesh& mesh,
              Random& random) {
  const auto area = [&](int a, int b, int c) {
    const auto& p = mesh.vertices;
    return (p[b] - p[a]).cross(p[c] - p[a])[face.axis];
  };
  const auto area_without = [&](int left_out) {
    double sum = 0;
    const int count = static_cast<int>(polygon.size());
    const int first = left_out == 0 ? 1 : 0;
    for (int i = first + 1; i + 1 < count; ++i) {
      if (i == left_out) continue;
      const int next = i + 1 == left_out ? i + 2 : i + 1;
      if (next < count) sum += area(polygon[first], polygon[i], polygon[next]);
    }
    return sum;
  };
  while (polygon.size() >= 3) {
    const int count = static_cast<int>(polygon.size());
    const int start = random.below(count);
    int ear = -1;
    for (int k = 0; k < count && ear < 0; ++k) {
      const int i = (start + k) % count;
      const double cut =
          area(polygon[(i + count - 1) % count], polygon[i], polygon[(i + 1) % count]);
      if (cut > 0 && (count == 3 || area_without(i) > 0)) ear = i;
    }
    if (ear < 0) return;
    const int before = polygon[(ear + count - 1) % count];
    const int after = polygon[(ear + 1) % count];
    if (face.outward_up) {
      mesh.triangles.push_back({before, polygon[ear], after});
    } else {
      mesh.triangles.push_back({before, after, polygon[ear]});
    }
    polygon.erase(polygon.begin() + ear);
  }
}

void quarter(geometry::TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [found, is_new] =
        middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.vertices.size()));
    if (is_new) mesh.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
    return found->second;
  };
  const auto old = std::exchange(mesh.triangles, {});
  for (const auto& [a, b, c] : old) {
    const int ab = middle(a, b);
    const int bc = middle(b, c);
    const int ca = middle(c, a);
    mesh.triangles.insert(mesh.triangles.end(),
                          {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
}

void cut_into_slivers(geometry::TriangleMesh& mesh, Random& random) {
  const int t = random.below(static_cast<int>(mesh.triangles.size()));
  const auto [a, b, c] = mesh.triangles[static_cast<std::size_t>(t)];
  double share = random.between(0.05, 0.33);
  for (int i = random.below(4); i > 0; --i) share *= 0.1;
  const double other = random.between(0.1, 0.9) * (1 - share);
  const int fresh = static_cast<int>(mesh.vertices.size());
  mesh.vertices.push_back(share * mesh.vertices[a] + other * mesh.vertices[b] +
                          (1 - share - other) * mesh.vertices[c]);
  mesh.triangles[static_cast<std::size_t>(t)] = {a, b, fresh};
  mesh.triangles.push_back({b, c, fresh});
  mesh.triangles.push_back({c, a, fresh});
}

}  // namespace

GridMeshStyle random_style(Random& random) {
  GridMeshStyle style;
  style.merged = random.below(3) > 0;
  if (random.below(3) == 0) style.quarterings = 1 + random.below(3);
  if (random.below(3) == 0) style.slivers = 1 + random.below(20);
  return style;
}

geometry::TriangleMesh grid_mesh(const GridSolid& solid, const GridMeshStyle& style,
                                 Random& random) {
  std::vector<Face> faces;
  for (int axis = 0; axis < 3; ++axis) {
    for (int plane = 0; plane <= solid.count(axis); ++plane) {
      for (const bool up : {false, true}) {
        add_faces_of_plane(solid, axis, plane, up, style.merged, faces);
      }
    }
  }
  std::set<Corner> corners;
  for (const Face& face : faces) {
    const int u = (face.axis + 1) % 3;
    const int v = (face.axis + 2) % 3;
    for (int k = 0; k < 4; ++k) {
      Corner corner = face.lower;
      if (k & 1) corner[u] = face.upper[u];
      if (k & 2) corner[v] = face.upper[v];
      corners.insert(corner);
    }
  }
  geometry::TriangleMesh mesh;
  mesh.closed = true;
  std::map<Corner, int> vertex_of;
  for (const Corner& corner : corners) {
    vertex_of[corner] = static_cast<int>(mesh.vertices.size());
    mesh.vertices.emplace_back(solid.planes[0][corner[0]], solid.planes[1][corner[1]],
                               solid.planes[2][corner[2]]);
  }
  for (const Face& face : faces) {
    std::vector<int> polygon;
    for (const Corner& corner : rim_of(face, corners)) polygon.push_back(vertex_of.at(corner));
    add_ears(polygon, face, mesh, random);
  }
  for (int i = 0; i < style.quarterings && 4 * mesh.triangles.size() < kMostTriangles; ++i) {
    quarter(mesh);
  }
  for (int i = 0; i < style.slivers; ++i) cut_into_slivers(mesh, random);
  for (Vec3& vertex : mesh.vertices) vertex += random.vector(style.noise);
  return mesh;
}

double finest_altitude(const geometry::TriangleMesh& mesh) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 ab = mesh.vertices[b] - mesh.vertices[a];
    const Vec3 ac = mesh.vertices[c] - mesh.vertices[a];
    const double longest = std::max({ab.norm(), ac.norm(), (ac - ab).norm()});
    least = std::min(least, ab.cross(ac).norm() / longest);
  }
  return least;
}

}  // namespace rubicon::collision::proof
