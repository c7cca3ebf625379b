#include "bench/bench_meshes.hpp"

#include <cmath>

#include "bench/random.hpp"
#include "src/motion/math/angles.hpp"

namespace rubicon::bench {
namespace {

using geometry::TriangleMesh;
using math::Vec3;

/// Two triangles for the quadrilateral a b c d, counterclockwise seen from outside.
void add_quad(TriangleMesh& mesh, int a, int b, int c, int d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

}  // namespace

MeshPtr corrugated_panel() {
  constexpr int kAlong = 22;
  constexpr int kUp = 10;
  auto mesh = std::make_shared<TriangleMesh>();
  const auto vertex = [](int side, int i, int j) {
    return (side * (kUp + 1) + j) * (kAlong + 1) + i;
  };
  for (int side = 0; side < 2; ++side) {
    for (int j = 0; j <= kUp; ++j) {
      for (int i = 0; i <= kAlong; ++i) {
        const double x = -1.5 + 3.0 * i / kAlong;
        const double z = -1.3 + 2.6 * j / kUp;
        const double bend = 0.12 * std::sin(4 * x) + 0.05 * std::cos(3 * z);
        mesh->vertices.emplace_back(x, bend + (side == 0 ? -0.075 : 0.075), z);
      }
    }
  }
  for (int j = 0; j < kUp; ++j) {
    for (int i = 0; i < kAlong; ++i) {
      add_quad(*mesh, vertex(0, i, j), vertex(0, i + 1, j), vertex(0, i + 1, j + 1),
               vertex(0, i, j + 1));
      add_quad(*mesh, vertex(1, i, j), vertex(1, i, j + 1), vertex(1, i + 1, j + 1),
               vertex(1, i + 1, j));
    }
  }
  for (int i = 0; i < kAlong; ++i) {
    add_quad(*mesh, vertex(0, i, 0), vertex(1, i, 0), vertex(1, i + 1, 0), vertex(0, i + 1, 0));
    add_quad(*mesh, vertex(0, i, kUp), vertex(0, i + 1, kUp), vertex(1, i + 1, kUp),
             vertex(1, i, kUp));
  }
  for (int j = 0; j < kUp; ++j) {
    add_quad(*mesh, vertex(0, 0, j), vertex(0, 0, j + 1), vertex(1, 0, j + 1), vertex(1, 0, j));
    add_quad(*mesh, vertex(0, kAlong, j), vertex(1, kAlong, j), vertex(1, kAlong, j + 1),
             vertex(0, kAlong, j + 1));
  }
  mesh->closed = true;
  return mesh;
}

MeshPtr boulder() {
  constexpr int kRound = 31;
  constexpr int kRings = 16;  // of vertices, between the poles
  Random random(3);
  auto mesh = std::make_shared<TriangleMesh>();
  mesh->vertices.emplace_back(0, 0, 1.2);
  for (int j = 1; j <= kRings; ++j) {
    const double polar = math::kPi * j / (kRings + 1);
    for (int i = 0; i < kRound; ++i) {
      const double round = 2 * math::kPi * i / kRound;
      const double radius =
          1.2 + 0.15 * std::sin(3 * round) * std::sin(2 * polar) + random.between(-0.03, 0.03);
      mesh->vertices.push_back(radius * Vec3(std::sin(polar) * std::cos(round),
                                             std::sin(polar) * std::sin(round), std::cos(polar)));
    }
  }
  mesh->vertices.emplace_back(0, 0, -1.2);
  const int last = static_cast<int>(mesh->vertices.size()) - 1;
  const auto vertex = [](int j, int i) { return 1 + (j - 1) * kRound + i % kRound; };
  for (int i = 0; i < kRound; ++i) {
    mesh->triangles.push_back({0, vertex(1, i), vertex(1, i + 1)});
    mesh->triangles.push_back({last, vertex(kRings, i + 1), vertex(kRings, i)});
    for (int j = 1; j < kRings; ++j) {
      add_quad(*mesh, vertex(j, i), vertex(j + 1, i), vertex(j + 1, i + 1), vertex(j, i + 1));
    }
  }
  mesh->closed = true;
  return mesh;
}

MeshPtr ring() {
  constexpr int kRound = 32;
  constexpr int kAcross = 16;
  auto mesh = std::make_shared<TriangleMesh>();
  for (int i = 0; i < kRound; ++i) {
    const double round = 2 * math::kPi * i / kRound;
    for (int j = 0; j < kAcross; ++j) {
      const double across = 2 * math::kPi * j / kAcross;
      const double radius = 1.2 + 0.15 * std::cos(across);
      mesh->vertices.emplace_back(radius * std::cos(round), radius * std::sin(round),
                                  0.15 * std::sin(across));
    }
  }
  const auto vertex = [](int i, int j) { return i % kRound * kAcross + j % kAcross; };
  for (int i = 0; i < kRound; ++i) {
    for (int j = 0; j < kAcross; ++j) {
      add_quad(*mesh, vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  }
  mesh->closed = true;
  return mesh;
}

}  // namespace rubicon::bench
