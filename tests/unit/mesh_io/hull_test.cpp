#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>

#include "src/exchange/mesh_io/hull_check.hpp"
#include "src/exchange/mesh_io/mesh_repair.hpp"
#include "tests/unit/mesh_io/mesh_files_io.hpp"

// The convex hull in place of a mesh: closed, outward, and around every corner.

namespace rubicon::mesh_io::testing {
namespace {

using geometry::TriangleMesh;
using geometry::Vec3;

/// A triangle for every three points in a row: a file that holds these points as corners.
Soup soup_of(const std::vector<Vec3>& points) {
  Soup soup;
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    soup.push_back({points[i], points[i + 1], points[i + 2]});
  }
  return soup;
}

std::variant<ReadMesh, MeshFailure> hull_of(const Soup& soup, bool hull = true) {
  const TemporaryFolder folder;
  MeshRequest request;
  request.hull = hull;
  return read_in_own_folder(folder.write("a.obj", as_obj(soup)), request);
}

const TriangleMesh& hull_in(const std::variant<ReadMesh, MeshFailure>& result) {
  if (const auto* failure = std::get_if<MeshFailure>(&result)) {
    throw std::runtime_error(failure->message);
  }
  return *std::get<ReadMesh>(result).mesh;
}

/// Farthest any point lies outside any face that has a plane, by trying all (m).
double farthest_outside(const TriangleMesh& hull, const std::vector<Vec3>& points) {
  double farthest = -1;
  for (const auto& t : hull.triangles) {
    const auto corner = [&](std::size_t k) {
      return hull.vertices.at(static_cast<std::size_t>(t.at(k)));
    };
    const Vec3 cross = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    if (cross.norm() < 1e-5) continue;
    for (const Vec3& p : points) {
      farthest = std::max(farthest, cross.normalized().dot(p - corner(0)));
    }
  }
  return farthest;
}

/// Every edge runs once in each direction.
bool is_closed_surface(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> uses;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++uses[{t.at(k), t.at((k + 1) % 3)}];
  }
  return std::all_of(uses.begin(), uses.end(), [&](const auto& use) {
    const auto back = uses.find({use.first.second, use.first.first});
    return use.second == 1 && back != uses.end() && back->second == 1;
  });
}

void expect_hull(const TriangleMesh& hull, const std::vector<Vec3>& points) {
  EXPECT_TRUE(hull.closed);
  EXPECT_TRUE(is_closed_surface(hull));
  EXPECT_GT(volume(hull), 0);
  EXPECT_LT(farthest_outside(hull, points), kHullSlack);
  EXPECT_EQ(hull_contains(hull, points), HullCheck::kContains);
}

TEST(Hull, OfTwoBoxesSpansTheGapBetweenThem) {
  Soup soup = box_soup({0, 0, 0}, {1, 1, 1});
  const Soup second = box_soup({3, 0, 0}, {4, 1, 1});
  soup.insert(soup.end(), second.begin(), second.end());
  const auto plain = hull_of(soup, false);
  EXPECT_NEAR(volume(hull_in(plain)), 2, 1e-9);
  const auto hull = hull_of(soup);
  EXPECT_NEAR(volume(hull_in(hull)), 4, 1e-9);
  expect_hull(hull_in(hull), hull_in(plain).vertices);
  // Corners inside its faces have gone.
  EXPECT_LE(hull_in(hull).vertices.size(), 16U);
}

TEST(Hull, OfAnOpenSheetThatIsBentIsASolid) {
  const auto hull =
      hull_of({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}});
  EXPECT_NEAR(volume(hull_in(hull)), 1.0 / 6, 1e-9);
  EXPECT_EQ(hull_in(hull).triangles.size(), 4U);
}

TEST(Hull, OfAPartInItsUnitScaleAndAxis) {
  const TemporaryFolder folder;
  MeshRequest request;
  request.part = "part_a";
  request.scale = 3;
  request.hull = true;
  const auto hull = read_in_own_folder(
      folder.write("a.dae", as_dae(box_soup({0, 0, 0}, {1, 1, 1}), "Y_UP", "2")), request);
  EXPECT_NEAR(volume(hull_in(hull)), 216, 1e-3);
  EXPECT_LT((extent(hull_in(hull)).lower - Vec3(60, -6, 0)).norm(), 1e-3);
  EXPECT_EQ(hull_in(hull).triangles.size(), 12U);
}

TEST(Hull, ContainsEveryCornerWhateverTheirOrder) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::uniform_int_distribution<int> lattice(0, 4);
  for (int variant = 0; variant < 40; ++variant) {
    const double far = variant % 4 == 3 ? 1e5 : 0;
    const double size = variant % 3 == 2 ? 0.01 : 5;
    std::vector<Vec3> points;
    for (int i = 0; i < 300; ++i) {
      Vec3 p(normal(random), normal(random), normal(random));
      switch (variant % 5) {
        case 0:  // inside a ball
          break;
        case 1:  // on a sphere
          p.normalize();
          break;
        case 2:  // on a lattice: many in one plane and on one line
          p = Vec3(lattice(random), lattice(random), lattice(random));
          break;
        case 3:  // on a cylinder with flat ends
          p.head<2>().normalize();
          p.z() = p.z() > 0 ? 1 : -1;
          break;
        default:  // a plate, turned
          p.z() *= 1e-3;
          p = Vec3(p.x() * 0.6 - p.z() * 0.8, p.y(), p.x() * 0.8 + p.z() * 0.6);
      }
      points.push_back(p * size + Vec3(far, -far, 0));
    }
    const Soup soup = soup_of(points);
    const auto plain = hull_of(soup, false);
    const auto hull = hull_of(soup);
    SCOPED_TRACE(variant);
    expect_hull(hull_in(hull), hull_in(plain).vertices);
  }
}

TEST(Hull, ItsCornersAreCornersOfTheMesh) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> place(-3, 3);
  std::vector<Vec3> points;
  for (int i = 0; i < 60; ++i) points.emplace_back(place(random), place(random), place(random));
  const auto plain = hull_of(soup_of(points), false);
  const auto hull = hull_of(soup_of(points));
  for (const Vec3& p : hull_in(hull).vertices) {
    const auto& all = hull_in(plain).vertices;
    EXPECT_NE(std::find(all.begin(), all.end(), p), all.end());
  }
}

TEST(Hull, OfAFlatMeshIsRefusedKindly) {
  const auto message = [](const Soup& soup) {
    const auto result = hull_of(soup);
    const auto* failure = std::get_if<MeshFailure>(&result);
    return failure == nullptr ? std::string() : failure->message;
  };
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  const std::string triangle = message({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}});
  EXPECT_TRUE(has(triangle, "fewer than four corners")) << triangle;
  const std::string square =
      message({{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}, {{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}}});
  EXPECT_TRUE(has(square, "lie in one plane")) << square;
  // 30 degrees and rounding: not exactly in one plane.
  Soup tilted;
  for (int i = 0; i < 20; ++i) {
    const auto point = [&](int k) {
      const double u = 0.37 * (i + k);
      return Vec3(u, 1.0 * ((i * 7 + k * 3) % 5), u * 0.57735026919);
    };
    tilted.push_back({point(0), point(1), point(2)});
  }
  const std::string almost = message(tilted);
  EXPECT_TRUE(has(almost, "in one plane") || has(almost, "thin as a sheet")) << almost;
}

TEST(Hull, OfManyCornersTakesBoundedTime) {
  std::vector<Vec3> points;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 60'000; ++i) {
    points.push_back(Vec3(normal(random), normal(random), normal(random)).normalized() * 10);
  }
  const auto begin = std::chrono::steady_clock::now();
  const auto hull = hull_of(soup_of(points));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(seconds.count(), 30);
  ASSERT_TRUE(std::holds_alternative<ReadMesh>(hull)) << std::get<MeshFailure>(hull).message;
  EXPECT_GT(hull_in(hull).vertices.size(), 30'000U);
  EXPECT_TRUE(is_closed_surface(hull_in(hull)));
}

TEST(HullCheck, FindsWhatSticksOut) {
  const RepairedMesh box = repair({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                  {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  ASSERT_TRUE(box.mesh.closed);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(0, 1);
  std::vector<Vec3> inside;
  while (inside.size() < 500) {
    const Vec3 p(place(random), place(random), place(random));
    if (p.sum() < 1) inside.push_back(p);
  }
  EXPECT_EQ(hull_contains(box.mesh, inside), HullCheck::kContains);
  for (const Vec3& out : {Vec3(0.2, 0.2, -1e-6), Vec3(-1e-6, 0.2, 0.2), Vec3(0.34, 0.34, 0.34),
                          Vec3(0, 0, 1 + 1e-6), Vec3(50, 50, 50)}) {
    std::vector<Vec3> points = inside;
    points.insert(points.begin() + 250, out);
    EXPECT_EQ(hull_contains(box.mesh, points), HullCheck::kSticksOut) << out.transpose();
  }
  EXPECT_EQ(hull_contains({}, inside), HullCheck::kSticksOut);
}

TEST(HullCheck, GivesUpWhenThereIsTooMuchToDo) {
  // Every point lies in the plane of every face, and the faces are many: nothing can be left out.
  TriangleMesh sheet;
  sheet.vertices = {{0, 0, 0}, {1, 0, 0.57735}, {0, 1, 0.31}};
  sheet.triangles.assign(20'000, {0, 1, 2});
  std::vector<Vec3> points;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(0, 1);
  for (int i = 0; i < 50'000; ++i) {
    const double u = place(random);
    const double v = place(random);
    points.emplace_back(u, v, 0.57735 * u + 0.31 * v);
  }
  EXPECT_EQ(hull_contains(sheet, points), HullCheck::kTooMuchWork);
}

}  // namespace
}  // namespace rubicon::mesh_io::testing
