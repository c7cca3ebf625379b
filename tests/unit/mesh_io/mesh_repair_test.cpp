#include "src/exchange/mesh_io/mesh_repair.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "src/exchange/ifc/solid_cut.hpp"
#include "src/motion/math/angles.hpp"
#include "tests/unit/mesh_io/mesh_files_io.hpp"

namespace rubicon::mesh_io::testing {
namespace {

using geometry::Vec3;
using Triangle = std::array<int, 3>;

RepairedMesh repair_soup(const Soup& soup) {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  for (const auto& t : soup) {
    const auto base = static_cast<int>(vertices.size());
    vertices.insert(vertices.end(), t.begin(), t.end());
    triangles.push_back({base, base + 1, base + 2});
  }
  return repair(vertices, triangles);
}

Soup unit_box() { return box_soup({0, 0, 0}, {1, 1, 1}); }

TEST(MeshRepair, WeldsASoupIntoAClosedBox) {
  const RepairedMesh result = repair_soup(unit_box());
  EXPECT_EQ(result.mesh.vertices.size(), 8U);
  EXPECT_EQ(result.mesh.triangles.size(), 12U);
  EXPECT_EQ(result.report.welded_vertices, 28);
  EXPECT_EQ(result.report.turned_triangles, 0);
  EXPECT_TRUE(result.mesh.closed);
  EXPECT_DOUBLE_EQ(volume(result.mesh), 1);
}

TEST(MeshRepair, KeepsTheOrderOfTriangles) {
  const Soup soup = unit_box();
  const RepairedMesh result = repair_soup(soup);
  for (std::size_t i = 0; i < soup.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = static_cast<std::size_t>(result.mesh.triangles.at(i).at(k));
      EXPECT_EQ(result.mesh.vertices.at(corner), soup.at(i).at(k));
    }
  }
}

TEST(MeshRepair, WeldsWithinTheToleranceOnly) {
  Soup near = unit_box();
  near[0][0] += Vec3(0.5 * kWeldTolerance, 0, 0);
  EXPECT_TRUE(repair_soup(near).mesh.closed);
  Soup apart = unit_box();
  apart[0][0] += Vec3(4 * kWeldTolerance, 0, 0);
  EXPECT_FALSE(repair_soup(apart).mesh.closed);
}

TEST(MeshRepair, FarFromTheOriginTheToleranceFollowsSinglePrecision) {
  const Vec3 far(100, 200, 0);
  Soup soup = box_soup(far, far + Vec3(1, 1, 1));
  soup[0][0] += Vec3(0, 1.5e-5, 0);  // the spacing of floats at 200
  EXPECT_TRUE(repair_soup(soup).mesh.closed);
}

TEST(MeshRepair, AMissingTriangleLeavesItOpen) {
  Soup soup = unit_box();
  soup.pop_back();
  const RepairedMesh result = repair_soup(soup);
  EXPECT_FALSE(result.mesh.closed);
  EXPECT_EQ(result.mesh.triangles.size(), 11U);
}

TEST(MeshRepair, TurnsAnInsideOutBox) {
  Soup soup = unit_box();
  for (auto& t : soup) std::swap(t[0], t[1]);
  const RepairedMesh result = repair_soup(soup);
  EXPECT_TRUE(result.mesh.closed);
  EXPECT_EQ(result.report.turned_triangles, 12);
  EXPECT_DOUBLE_EQ(volume(result.mesh), 1);
}

TEST(MeshRepair, MakesNeighboursAgree) {
  Soup soup = unit_box();
  for (const std::size_t i : {1U, 4U, 5U, 9U}) std::swap(soup.at(i)[1], soup.at(i)[2]);
  const RepairedMesh result = repair_soup(soup);
  EXPECT_TRUE(result.mesh.closed);
  EXPECT_EQ(result.report.turned_triangles, 4);
  EXPECT_DOUBLE_EQ(volume(result.mesh), 1);
}

TEST(MeshRepair, KeepsACavityFacingInwards) {
  Soup soup = box_soup({0, 0, 0}, {4, 4, 4});
  for (auto t : box_soup({1, 1, 1}, {2, 2, 2})) {
    std::swap(t[0], t[1]);
    soup.push_back(t);
  }
  const RepairedMesh result = repair_soup(soup);
  EXPECT_TRUE(result.mesh.closed);
  EXPECT_EQ(result.report.turned_triangles, 0);
  EXPECT_DOUBLE_EQ(volume(result.mesh), 63);
}

TEST(MeshRepair, TurnsAPartThatIsInsideOutAndLiesInNoOther) {
  // Into the first, beside it, and beside it with as much volume.
  for (const auto& [low, high] :
       {std::pair(Vec3(2, 1, 1), Vec3(7, 2, 2)), std::pair(Vec3(9, 1, 1), Vec3(14, 2, 2)),
        std::pair(Vec3(9, 0, 0), Vec3(13, 4, 4))}) {
    Soup soup = box_soup({0, 0, 0}, {4, 4, 4});
    for (auto t : box_soup(low, high)) {
      std::swap(t[0], t[1]);
      soup.push_back(t);
    }
    const RepairedMesh result = repair_soup(soup);
    EXPECT_TRUE(result.mesh.closed);
    EXPECT_EQ(result.report.turned_triangles, 12);
    EXPECT_NEAR(volume(result.mesh), 64 + (high - low).prod(), 1e-12);
  }
}

TEST(MeshRepair, TwoBoxesThatShareAFaceStayClosed) {
  Soup soup = unit_box();
  for (const auto& t : box_soup({1, 0, 0}, {2, 1, 1})) soup.push_back(t);
  const RepairedMesh result = repair_soup(soup);
  EXPECT_TRUE(result.mesh.closed);
  EXPECT_EQ(result.mesh.triangles.size(), 24U);
  EXPECT_DOUBLE_EQ(volume(result.mesh), 2);
}

TEST(MeshRepair, LeavesOutTheBacksOfTrianglesWithTwoSides) {
  const auto back = [](std::array<Vec3, 3> t) {
    std::swap(t[1], t[2]);
    return t;
  };
  for (const std::size_t doubled : {1U, 12U}) {
    for (const bool back_first : {false, true}) {
      Soup soup = unit_box();
      Soup backs;
      for (std::size_t i = 0; i < doubled; ++i) backs.push_back(back(soup[i]));
      soup.insert(back_first ? soup.begin() : soup.end(), backs.begin(), backs.end());
      const RepairedMesh result = repair_soup(soup);
      EXPECT_TRUE(result.mesh.closed) << doubled;
      EXPECT_EQ(result.report.duplicate_triangles, static_cast<int>(doubled));
      EXPECT_DOUBLE_EQ(volume(result.mesh), 1);
    }
  }
  // Of two shells, one in the other, nobody knows which shows outwards.
  Soup hollow = box_soup({0, 0, 0}, {4, 4, 4});
  for (const auto& t : box_soup({1, 1, 1}, {2, 2, 2})) hollow.push_back(t);
  for (std::size_t i = 0; i < 24; ++i) hollow.push_back(back(hollow[i]));
  EXPECT_FALSE(repair_soup(hollow).mesh.closed);
}

TEST(MeshRepair, LeavesOutDuplicatesAndDegenerates) {
  Soup soup = unit_box();
  const auto first = soup.front();
  soup.push_back({first[1], first[2], first[0]});                 // the same, begun elsewhere
  soup.push_back({first[0], first[0], first[1]});                 // two corners are one
  soup.push_back({Vec3(0, 0, 5), Vec3(1, 0, 5), Vec3(3, 0, 5)});  // on a line, apart from the box
  const RepairedMesh result = repair_soup(soup);
  EXPECT_TRUE(result.mesh.closed);
  EXPECT_EQ(result.mesh.triangles.size(), 12U);
  EXPECT_EQ(result.report.duplicate_triangles, 1);
  EXPECT_EQ(result.report.degenerate_triangles, 2);
}

TEST(MeshRepair, KeepsAThinTriangleThatAClosedSurfaceNeeds) {
  // A tetrahedron one face of which is split at the middle of an edge that the neighbour does not
  // split: a triangle without area closes the joint.
  const Vec3 a(0, 0, 0);
  const Vec3 b(2, 0, 0);
  const Vec3 c(0, 2, 0);
  const Vec3 d(0, 0, 2);
  const Vec3 m(1, 0, 0);
  const Soup soup = {{a, c, m}, {m, c, b}, {a, m, b}, {a, b, d}, {b, c, d}, {c, a, d}};
  const RepairedMesh result = repair_soup(soup);
  EXPECT_TRUE(result.mesh.closed);
  EXPECT_EQ(result.report.thin_triangles_kept, 1);
  EXPECT_EQ(result.mesh.triangles.size(), 6U);
}

TEST(MeshRepair, AFoldOfTwoEqualTrianglesOfAClosedSurfaceIsNotTorn) {
  // A tetrahedron whose corner d is split in two that lie nearer than is welded: two equal
  // triangles and one seen from behind remain of what lay between.
  const Vec3 a(0, 0, 0);
  const Vec3 b(2, 0, 0);
  const Vec3 c(0, 2, 0);
  const Vec3 d(0, 0, 2);
  const Soup soup = {{a, c, b}, {a, b, d}, {b, c, d}, {b, c, d}, {c, b, d}, {c, a, d}};
  const RepairedMesh result = repair_soup(soup);
  EXPECT_TRUE(result.mesh.closed);
  EXPECT_EQ(result.report.duplicate_triangles, 2);
  EXPECT_EQ(result.mesh.triangles.size(), 4U);
}

TEST(MeshRepair, ARoundHoleAsDeepAsItsBlockLeavesAClosedBody) {
  // What is cut has hundreds of thin triangles, some of which fold when corners are welded.
  ifc::Solid block;
  for (int i = 0; i < 8; ++i) {
    block.points.emplace_back((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 2 : -2, (i & 4) != 0 ? 3 : 0);
  }
  block.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  for (int sides = 15; sides <= 40; ++sides) {
    SCOPED_TRACE(sides);
    const double half_deg = 180.0 / sides;
    ifc::Cell hole = {{{0, 0, 1}, 3}, {{0, 0, -1}, 0}};
    for (int i = 0; i < sides; ++i) {
      const double towards = (2 * i + 1) * half_deg;
      const Vec3 n(math::cos_deg(towards), math::sin_deg(towards), 0);
      hole.push_back({n, 1.5 * n.y() + 0.3 * math::cos_deg(half_deg)});
    }
    ifc::WorkBudget budget(10'000'000);
    const auto rest = ifc::subtract(block, hole, budget);
    ASSERT_TRUE(rest);
    const RepairedMesh result = repair(rest->points, rest->triangles);
    EXPECT_TRUE(result.mesh.closed);
    const double removed = 3 * sides * 0.3 * 0.3 * math::sin_deg(2 * half_deg) / 2;
    EXPECT_NEAR(volume(result.mesh), 24 - removed, 1e-4);
  }
}

TEST(MeshRepair, ASheetWithTwoFacesEnclosesNothing) {
  const Vec3 a(0, 0, 0);
  const Vec3 b(2, 0, 0);
  const Vec3 c(0, 2, 0);
  const RepairedMesh result = repair_soup({{a, b, c}, {a, c, b}});
  EXPECT_FALSE(result.mesh.closed);
  EXPECT_EQ(result.mesh.triangles.size(), 2U);
}

TEST(MeshRepair, NothingOfAnySizeGivesNoTriangles) {
  const Vec3 p(1, 2, 3);
  EXPECT_TRUE(repair_soup({{p, p, p}}).mesh.triangles.empty());
  EXPECT_TRUE(repair({}, {}).mesh.triangles.empty());
}

}  // namespace
}  // namespace rubicon::mesh_io::testing
