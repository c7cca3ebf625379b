#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

#include "tests/support/places.hpp"
#include "tests/unit/mesh_io/mesh_files_io.hpp"

namespace rubicon::mesh_io::testing {
namespace {

std::filesystem::path data_folder() {
  return std::filesystem::path(test::source_dir()) / "../shared/data";
}

bool data_is_here() { return std::filesystem::is_directory(data_folder()); }

TEST(RealData, AllPartsOfTheExcavatorAreRead) {
  if (!data_is_here()) GTEST_SKIP() << "the shared data folder is not beside the project";
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(data_folder() / "zx200/meshes")) {
    files.insert(entry.path());
  }
  EXPECT_EQ(files.size(), 13U);
  for (const std::filesystem::path& file : files) {
    const auto result = read_in_own_folder(file.string());
    ASSERT_TRUE(std::holds_alternative<ReadMesh>(result)) << std::get<MeshFailure>(result).message;
    const geometry::Box box = extent(*std::get<ReadMesh>(result).mesh);
    const geometry::Vec3 size = box.upper - box.lower;
    EXPECT_GT(size.maxCoeff(), 0.1) << file;
    EXPECT_LT(size.maxCoeff(), 8) << file;
  }
}

TEST(RealData, TheBoomOfTheExcavatorReachesForwardAndUp) {
  if (!data_is_here()) GTEST_SKIP() << "the shared data folder is not beside the project";
  const auto result = read_in_own_folder((data_folder() / "zx200/meshes/zx200-boom.dae").string());
  ASSERT_TRUE(std::holds_alternative<ReadMesh>(result)) << std::get<MeshFailure>(result).message;
  const geometry::Vec3 size = extent(*std::get<ReadMesh>(result).mesh).upper -
                              extent(*std::get<ReadMesh>(result).mesh).lower;
  EXPECT_GT(size.x(), 4.5);
  EXPECT_LT(size.y(), 1.5);       // a flat box girder
  EXPECT_GT(size.z(), size.y());  // bent upwards
}

TEST(RealData, TheFloorElementsComeInMetresYUp) {
  if (!data_is_here()) GTEST_SKIP() << "the shared data folder is not beside the project";
  SceneRequest request;
  request.path = (data_folder() / "schependomlaan/IFC-kanaalplaatvloer.ifc").string();
  request.folder = data_folder().string();
  const auto scene = reader().read_scene(request);
  ASSERT_TRUE(std::holds_alternative<std::vector<NamedMesh>>(scene))
      << std::get<MeshFailure>(scene).message;
  int elements = 0;
  for (const NamedMesh& node : std::get<std::vector<NamedMesh>>(scene)) {
    if (!node.name.starts_with("IfcSlab_vloer_")) continue;
    ++elements;
    EXPECT_NE(node.path.find("IfcBuildingStorey_00 begane grond"), std::string::npos) << node.path;
    const geometry::Box box = extent(node.mesh);
    EXPECT_NEAR(box.upper.y(), -0.09, 1e-5) << node.name;
    EXPECT_TRUE(node.mesh.closed) << node.name;
  }
  EXPECT_EQ(elements, 48);
}

TEST(RealData, AnIfcElementCanBeReadAsAPartZUp) {
  if (!data_is_here()) GTEST_SKIP() << "the shared data folder is not beside the project";
  MeshRequest request;
  request.part = "IfcSlab_vloer_V0_152mZBEq1ABBFkricfATYn";
  const std::string path = (data_folder() / "schependomlaan/IFC-kanaalplaatvloer.ifc").string();
  for (const char up : {'\0', 'z'}) {
    request.up = up;
    const auto result = read_in_own_folder(path, request);
    ASSERT_TRUE(std::holds_alternative<ReadMesh>(result)) << std::get<MeshFailure>(result).message;
    const geometry::Box box = extent(*std::get<ReadMesh>(result).mesh);
    EXPECT_LT((box.lower - geometry::Vec3(5.53, 2.066, -0.423)).norm(), 1e-5)
        << box.lower.transpose();
    EXPECT_LT((box.upper - geometry::Vec3(13.44, 3.266, -0.09)).norm(), 1e-5)
        << box.upper.transpose();
  }
}

/// The program that drew the models wrote their net volumes into them.
TEST(RealData, EveryElementIsClosedAndAsLargeAsItsModelSays) {
  if (!data_is_here()) GTEST_SKIP() << "the shared data folder is not beside the project";
  const std::map<std::string, double> net = {
      {"0sfnf50Vz6qxgaVSSC_9Ng", 6.2928625939},   // a wall whose library mesh had lost two thirds
      {"0jxtYk_DPFmfsr5FLf4yfo", 9.42464267111},  // a floor of a single outline with many bays
      {"3xcd5VqGn5fu$PUBghiK4$", 5.32395004646}};
  std::size_t elements = 0;
  std::size_t compared = 0;
  for (const char* file : {"kalkzandsteen", "kanaalplaatvloer", "prefab_trappen", "staal"}) {
    MeshRequest request;
    request.folder = data_folder().string();
    request.path = (data_folder() / "schependomlaan/IFC-").string() + file + ".ifc";
    const auto nodes = reader().read_nodes(request);
    ASSERT_TRUE(std::holds_alternative<std::vector<NamedMesh>>(nodes)) << file;
    for (const NamedMesh& node : std::get<std::vector<NamedMesh>>(nodes)) {
      ++elements;
      EXPECT_TRUE(node.mesh.closed) << node.name;
      EXPECT_EQ(node.note, "") << node.name;
      const auto known = net.find(node.name.substr(node.name.size() - 22));
      if (known == net.end()) continue;
      ++compared;
      EXPECT_NEAR(volume(node.mesh), known->second, 1e-6) << node.name;
    }
  }
  EXPECT_EQ(elements, 273U);
  EXPECT_EQ(compared, net.size());
}

}  // namespace
}  // namespace rubicon::mesh_io::testing
