#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "tests/unit/mesh_io/mesh_files_io.hpp"

namespace rubicon::mesh_io::testing {
namespace {

using geometry::Vec3;

/// Not the same along any two axes, so that a wrong axis shows.
const Soup& brick() {
  static const Soup soup = box_soup({1, 2, 3}, {2, 4, 6});
  return soup;
}

void expect_extent(const std::variant<ReadMesh, MeshFailure>& result, const Vec3& lower,
                   const Vec3& upper) {
  ASSERT_TRUE(std::holds_alternative<ReadMesh>(result)) << std::get<MeshFailure>(result).message;
  const geometry::TriangleMesh& mesh = *std::get<ReadMesh>(result).mesh;
  const geometry::Box box = extent(mesh);
  EXPECT_LT((box.lower - lower).norm(), 1e-6) << box.lower.transpose();
  EXPECT_LT((box.upper - upper).norm(), 1e-6) << box.upper.transpose();
  EXPECT_TRUE(mesh.closed);
  EXPECT_GT(volume(mesh), 0);
}

std::string failure_of(const std::variant<ReadMesh, MeshFailure>& result) {
  const auto* failure = std::get_if<MeshFailure>(&result);
  return failure == nullptr ? "" : failure->message;
}

struct Format {
  std::string name;
  std::string bytes;
};

/// For the names of the cases; without it they would carry addresses.
void PrintTo(const Format& format, std::ostream* out) { *out << format.name; }

class UnitlessFormats : public ::testing::TestWithParam<Format> {};

TEST_P(UnitlessFormats, UnitScaleAndUpAreApplied) {
  const TemporaryFolder folder;
  const std::string path = folder.write(GetParam().name, GetParam().bytes);
  EXPECT_TRUE(needs_unit(path));
  MeshRequest millimetres;
  millimetres.metres_per_unit = 0.001;
  millimetres.scale = 2;
  expect_extent(read_in_own_folder(path), {1, 2, 3}, {2, 4, 6});
  expect_extent(read_in_own_folder(path, millimetres), {0.002, 0.004, 0.006},
                {0.004, 0.008, 0.012});
  MeshRequest y_up;
  y_up.up = 'y';
  expect_extent(read_in_own_folder(path, y_up), {1, -6, 2}, {2, -3, 4});
  MeshRequest z_up;
  z_up.up = 'z';
  expect_extent(read_in_own_folder(path, z_up), {1, 2, 3}, {2, 4, 6});
}

TEST_P(UnitlessFormats, WithoutUnitIsRefused) {
  const TemporaryFolder folder;
  MeshRequest request;
  request.path = folder.write(GetParam().name, GetParam().bytes);
  request.folder = folder.path().string();
  EXPECT_NE(failure_of(reader().read(request)).find("carry no unit; name one"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Files, UnitlessFormats,
                         ::testing::Values(Format{"text.stl", as_stl_text(brick())},
                                           Format{"binary.STL", as_stl_binary(brick())},
                                           Format{"a.obj", as_obj(brick())},
                                           Format{"a.ply", as_ply(brick())}),
                         [](const auto& format) {
                           std::string name = format.param.name;
                           name[name.find('.')] = '_';
                           return name;
                         });

TEST(Formats, ColladaDeclaresUnitAndUpAxis) {
  const TemporaryFolder folder;
  const std::string z = folder.write("z.dae", as_dae(brick(), "Z_UP", "0.01"));
  const std::string y = folder.write("y.dae", as_dae(brick(), "Y_UP", "0.01"));
  EXPECT_FALSE(needs_unit(z));
  MeshRequest part;
  part.part = "part_a";
  expect_extent(read_in_own_folder(z, part), {0.11, 0.02, 0.03}, {0.12, 0.04, 0.06});
  expect_extent(read_in_own_folder(y, part), {0.11, -0.06, 0.02}, {0.12, -0.03, 0.04});
}

TEST(Formats, UnitAndUpAxisOfTheRequestWinOverThoseDeclared) {
  const TemporaryFolder folder;
  const std::string y = folder.write("y.dae", as_dae(brick(), "Y_UP", "0.01"));
  const std::string z = folder.write("z.dae", as_dae(brick(), "Z_UP", "0.01"));
  MeshRequest request;
  request.part = "part_a";
  request.metres_per_unit = 1;
  request.up = 'z';
  expect_extent(read_in_own_folder(y, request), {11, 2, 3}, {12, 4, 6});
  request.up = 'y';
  expect_extent(read_in_own_folder(z, request), {11, -6, 2}, {12, -3, 4});
}

TEST(Formats, APartComesWithAllBelowIt) {
  const TemporaryFolder folder;
  const std::string path = folder.write("z.dae", as_dae(brick(), "Z_UP", "1"));
  MeshRequest request;
  request.part = "part_b";
  expect_extent(read_in_own_folder(path, request), {1, 2, 3}, {2, 4, 106});
  request.part = "part_c";
  expect_extent(read_in_own_folder(path, request), {1, 2, 103}, {2, 4, 106});
  request.part = "part_d";
  EXPECT_NE(failure_of(read_in_own_folder(path, request))
                .find("no part 'part_d'; it has 'part_a', 'part_b', 'part_c'"),
            std::string::npos);
}

TEST(Formats, ANameBorneTwiceIsNotGuessed) {
  const TemporaryFolder folder;
  std::string text = as_dae(brick(), "Z_UP", "1");
  for (std::size_t i = 0; (i = text.find("part_b", i)) != std::string::npos;) {
    text.replace(i, 6, "part_a");
  }
  MeshRequest request;
  request.part = "part_a";
  const std::string path = folder.write("twice.dae", text);
  EXPECT_NE(
      failure_of(read_in_own_folder(path, request)).find("2 of its parts are called 'part_a'"),
      std::string::npos);
}

TEST(Formats, GltfIsInMetresAndYUp) {
  const TemporaryFolder folder;
  const std::string embedded = folder.write("embedded.gltf", as_gltf(brick(), ""));
  expect_extent(read_in_own_folder(embedded), {1, -6, 2}, {2, -3, 4});
  folder.write("buffers/b.bin", gltf_buffer(brick()));
  const std::string beside = folder.write("beside.gltf", as_gltf(brick(), "buffers/b.bin"));
  expect_extent(read_in_own_folder(beside), {1, -6, 2}, {2, -3, 4});
  MeshRequest as_written;
  as_written.up = 'z';
  as_written.metres_per_unit = 0.01;
  expect_extent(read_in_own_folder(beside, as_written), {0.01, 0.02, 0.03}, {0.02, 0.04, 0.06});
}

TEST(Formats, AGltfBufferMayLieAnywhereInTheFolderOfTheRequest) {
  const TemporaryFolder folder;
  folder.write("b.bin", gltf_buffer(brick()));
  MeshRequest request;
  request.path = folder.write("deep/a.gltf", as_gltf(brick(), "../b.bin"));
  request.folder = folder.path().string();
  expect_extent(reader().read(request), {1, -6, 2}, {2, -3, 4});
}

TEST(Formats, ASymbolicLinkInsideTheFolderIsFollowed) {
  const TemporaryFolder folder;
  folder.write("content", as_stl_text(brick()));
  std::filesystem::create_symlink("content", folder.path() / "link.stl");
  expect_extent(read_in_own_folder((folder.path() / "link.stl").string()), {1, 2, 3}, {2, 4, 6});
}

TEST(Formats, AMirroredNodeStaysOutward) {
  const TemporaryFolder folder;
  std::string text = as_gltf(brick(), "");
  text.replace(text.find("\"mesh\":0"), 8, "\"mesh\":0,\"scale\":[-1,1,1]");
  const auto result = read_in_own_folder(folder.write("mirrored.gltf", text));
  expect_extent(result, {-2, -6, 2}, {-1, -3, 4});
  EXPECT_EQ(std::get<ReadMesh>(result).report.turned_triangles, 0);
}

TEST(Formats, ASceneListsItsNodesWithPaths) {
  const TemporaryFolder folder;
  SceneRequest request;
  request.path = folder.write("z.dae", as_dae(brick(), "Z_UP", "1"));
  request.folder = folder.path().string();
  const auto scene = reader().read_scene(request);
  ASSERT_TRUE(std::holds_alternative<std::vector<NamedMesh>>(scene));
  const auto& meshes = std::get<std::vector<NamedMesh>>(scene);
  ASSERT_EQ(meshes.size(), 3U);
  EXPECT_EQ(meshes[0].name, "part_a");
  EXPECT_EQ(meshes[2].name, "part_c");
  EXPECT_TRUE(meshes[2].path.ends_with("/part_b/part_c")) << meshes[2].path;
  const geometry::Box box = extent(meshes[0].mesh);
  EXPECT_LT((box.lower - Vec3(11, 3, -4)).norm(), 1e-6) << box.lower.transpose();  // Y up
}

TEST(Formats, TwoReadsGiveTheSameMesh) {
  const TemporaryFolder folder;
  const std::string path = folder.write("z.dae", as_dae(brick(), "Z_UP", "0.0254"));
  const auto first = read_in_own_folder(path);
  const auto second = read_in_own_folder(path);
  ASSERT_TRUE(std::holds_alternative<ReadMesh>(first));
  ASSERT_TRUE(std::holds_alternative<ReadMesh>(second));
  EXPECT_EQ(std::get<ReadMesh>(first).mesh->vertices, std::get<ReadMesh>(second).mesh->vertices);
  EXPECT_EQ(std::get<ReadMesh>(first).mesh->triangles, std::get<ReadMesh>(second).mesh->triangles);
}

TEST(Formats, RequestsThatMakeNoSenseAreRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.stl", as_stl_text(brick()));
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()}) {
    MeshRequest request;
    request.scale = bad;
    EXPECT_NE(failure_of(read_in_own_folder(path, request)).find("a scale must be"),
              std::string::npos);
  }
  MeshRequest unit;
  unit.metres_per_unit = -1;
  EXPECT_NE(failure_of(read_in_own_folder(path, unit)).find("a unit must be"), std::string::npos);
  MeshRequest huge;
  huge.metres_per_unit = 1e9;
  EXPECT_NE(failure_of(read_in_own_folder(path, huge)).find("check the unit"), std::string::npos);
  MeshRequest tiny;
  tiny.metres_per_unit = 1e-9;
  EXPECT_NE(failure_of(read_in_own_folder(path, tiny)).find("no triangle of any size"),
            std::string::npos);
}

// What docs/meshes.md says about single precision: 8 mm is one unit in the last place at 100 km.
TEST(FarFromTheOrigin, WrittenCoordinatesAreGoodToEightMillimetres) {
  const TemporaryFolder folder;
  const geometry::Vec3 lower(100'000.123, -50'000.456, 100.789);
  const geometry::Vec3 upper = lower + geometry::Vec3(1.2, 7.9, 0.333);
  const Soup soup = box_soup(lower, upper);
  for (const auto& [name, bytes] :
       std::map<std::string, std::string>{{"a.stl", as_stl_text(soup)},
                                          {"b.stl", as_stl_binary(soup)},
                                          {"a.obj", as_obj(soup)},
                                          {"a.ply", as_ply(soup)}}) {
    const auto result = read_in_own_folder(folder.write(name, bytes));
    ASSERT_TRUE(std::holds_alternative<ReadMesh>(result)) << name;
    const geometry::Box box = extent(*std::get<ReadMesh>(result).mesh);
    EXPECT_LT((box.lower - lower).cwiseAbs().maxCoeff(), 0.004) << name;
    EXPECT_LT((box.upper - upper).cwiseAbs().maxCoeff(), 0.004) << name;
    EXPECT_TRUE(std::get<ReadMesh>(result).mesh->closed) << name;
  }
}

TEST(FarFromTheOrigin, APlacedNodeKeepsItsShape) {
  const TemporaryFolder folder;
  const Soup soup = box_soup({0.123456, 0, 0}, {1.323456, 7.9, 0.333});
  std::string text = as_dae(soup, "Z_UP", "1");
  text.replace(text.find("10 0 0</translate>"), 6, "100000.123 0 0");
  MeshRequest request;
  request.part = "part_a";
  const auto result = read_in_own_folder(folder.write("a.dae", text), request);
  ASSERT_TRUE(std::holds_alternative<ReadMesh>(result));
  const geometry::Box box = extent(*std::get<ReadMesh>(result).mesh);
  EXPECT_LT((box.upper - box.lower - geometry::Vec3(1.2, 7.9, 0.333)).norm(), 1e-6);
  EXPECT_NEAR(box.lower.x(), 100'000.123 + 0.123456, 0.004);
}

}  // namespace
}  // namespace rubicon::mesh_io::testing
