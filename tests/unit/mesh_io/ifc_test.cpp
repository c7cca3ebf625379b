#include <gtest/gtest.h>

#include <map>

#include "tests/support/ifc_sample.hpp"
#include "tests/unit/mesh_io/mesh_files_io.hpp"

namespace rubicon::mesh_io::testing {
namespace {

using geometry::Vec3;
using ::rubicon::testing::block_id;
using ::rubicon::testing::ifc_text;
using ::rubicon::testing::IfcSample;

/// Two blocks, 2 m x 0.2 m x 2.5 m, the second at (3, 4, 3).
IfcSample sample_with(const std::string& schema, const std::string& shape,
                      const std::string& unit = "mm") {
  IfcSample sample;
  sample.schema = schema;
  sample.shape = shape;
  sample.unit = unit;
  sample.blocks = {{}, {"IFCSLAB", "floor", {3, 4, 3}, {2, 0.2, 2.5}, 0}};
  return sample;
}

/// The extent of one block of a file, z up.
geometry::Box block_extent(const std::string& text, std::size_t block) {
  TemporaryFolder folder;
  const std::string path = folder.write("a.ifc", text);
  MeshRequest request;
  request.part = block_id(block);
  const auto result = read_in_own_folder(path, request);
  if (const auto* failure = std::get_if<MeshFailure>(&result)) {
    ADD_FAILURE() << failure->message;
    return {};
  }
  EXPECT_TRUE(std::get<ReadMesh>(result).mesh->closed);
  return extent(*std::get<ReadMesh>(result).mesh);
}

void expect_block(const std::string& text, const Vec3& lower, double tolerance) {
  const geometry::Box box = block_extent(text, 1);
  EXPECT_LT((box.lower - lower).norm(), tolerance) << box.lower.transpose();
  EXPECT_LT((box.upper - lower - Vec3(2, 0.2, 2.5)).norm(), tolerance) << box.upper.transpose();
}

TEST(Ifc, EveryShapeOfEveryVersionStandsWhereTheFileHasIt) {
  for (const char* schema : {"IFC2X3", "IFC4", "IFC4X3_ADD2"}) {
    for (const char* shape : {"extrusion", "brep", "mapped"}) {
      SCOPED_TRACE(std::string(schema) + " " + shape);
      expect_block(ifc_text(sample_with(schema, shape)), {3, 4, 3}, 1e-6);
    }
  }
}

TEST(Ifc, ShapesOfVersion4AreRead) {
  for (const char* shape : {"triangles", "polygons", "indexed curve"}) {
    SCOPED_TRACE(shape);
    expect_block(ifc_text(sample_with("IFC4", shape)), {3, 4, 3}, 1e-6);
  }
  // A profile without position lies about the origin.
  expect_block(ifc_text(sample_with("IFC4", "extrusion without positions")), {2, 3.9, 3}, 1e-6);
}

TEST(Ifc, AFileOfVersion4NeedsNoOwners) {
  IfcSample sample = sample_with("IFC4", "extrusion");
  sample.owner_history = false;
  expect_block(ifc_text(sample), {3, 4, 3}, 1e-6);
}

TEST(Ifc, ClassesThatVersion2x3DoesNotKnowAreRead) {
  IfcSample sample = sample_with("IFC4", "extrusion");
  sample.blocks[1].keyword = "IFCCHIMNEY";
  expect_block(ifc_text(sample), {3, 4, 3}, 1e-6);
}

TEST(Ifc, EveryUnitBecomesMetres) {
  for (const char* unit : {"mm", "m", "ft"}) {
    SCOPED_TRACE(unit);
    expect_block(ifc_text(sample_with("IFC2X3", "extrusion", unit)), {3, 4, 3}, 1e-6);
  }
}

TEST(Ifc, FarFromTheOriginNoDigitIsLost) {
  IfcSample placed = sample_with("IFC2X3", "extrusion");
  placed.site = {155000.1234, 463000.5678, 12.3};
  expect_block(ifc_text(placed), {155003.1234, 463004.5678, 15.3}, 1e-6);
  for (const char* shape : {"brep", "triangles"}) {
    SCOPED_TRACE(shape);
    IfcSample drawn = sample_with("IFC4", shape, "m");
    drawn.coordinates = {155000.1234, 463000.5678, 12.3};
    expect_block(ifc_text(drawn), {155003.1234, 463004.5678, 15.3}, 1e-6);
  }
}

TEST(Ifc, OneShapeThatCannotBeReadDoesNotSpoilTheOthers) {
  IfcSample sample = sample_with("IFC4", "extrusion");
  sample.more =
      "#900= IFCADVANCEDBREP(#901);\n#902= IFCSHAPEREPRESENTATION($,'Body','x',(#900));\n"
      "#903= IFCPRODUCTDEFINITIONSHAPE($,$,(#902));\n#904= IFCWALL('w',$,$,$,$,$,#903,$,$);\n";
  expect_block(ifc_text(sample), {3, 4, 3}, 1e-6);
}

TEST(Ifc, AnOpeningIsCutOutOfItsWall) {
  IfcSample sample = sample_with("IFC4", "extrusion");
  // A hole of 1 m x 1 m through the first block.
  sample.blocks = {{"IFCWALL", "wall", {10, 20, 0}, {4, 0.2, 2.5}, 0},
                   {"IFCOPENINGELEMENT", "hole", {11, 19.9, 0.5}, {1, 0.4, 1}, 0}};
  std::string text = ifc_text(sample);
  const auto record_of = [&](const char* keyword) {
    const std::size_t at = text.find(keyword);
    const std::size_t line = text.rfind('#', at);
    return text.substr(line, text.find('=', line) - line);
  };
  sample.more = "#900= IFCRELVOIDSELEMENT('v',$,$,$," + record_of("IFCWALL(") + "," +
                record_of("IFCOPENINGELEMENT(") + ");\n";
  TemporaryFolder folder;
  const std::string path = folder.write("a.ifc", ifc_text(sample));
  const auto result = read_in_own_folder(path);
  ASSERT_TRUE(std::holds_alternative<ReadMesh>(result)) << std::get<MeshFailure>(result).message;
  const geometry::TriangleMesh& mesh = *std::get<ReadMesh>(result).mesh;
  EXPECT_LT((extent(mesh).lower - Vec3(10, 20, 0)).norm(), 1e-5);
  // The front without the hole: 4 x 2.5 - 1 x 1.
  double front = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3& a = mesh.vertices[static_cast<std::size_t>(t[0])];
    const Vec3& b = mesh.vertices[static_cast<std::size_t>(t[1])];
    const Vec3& c = mesh.vertices[static_cast<std::size_t>(t[2])];
    const Vec3 area = (b - a).cross(c - a) / 2;
    if (area.y() < 0 && std::abs(a.y() - 20) < 1e-4) front -= area.y();
  }
  EXPECT_NEAR(front, 9, 1e-3);
}

TEST(Ifc, NodesStandBelowTheirStoreyInTheOrderOfTheFile) {
  IfcSample sample = sample_with("IFC4", "mapped");
  sample.storeys = {"Ground floor", "First floor"};
  sample.blocks[1].storey = 1;
  sample.blocks[1].name = "caf\\X2\\00E9\\X0\\ ''s";
  TemporaryFolder folder;
  SceneRequest request;
  request.path = folder.write("a.ifc", ifc_text(sample));
  request.folder = folder.path();
  const auto scene = reader().read_scene(request);
  ASSERT_TRUE(std::holds_alternative<std::vector<NamedMesh>>(scene))
      << std::get<MeshFailure>(scene).message;
  const auto& nodes = std::get<std::vector<NamedMesh>>(scene);
  ASSERT_EQ(nodes.size(), 2U);
  EXPECT_EQ(nodes[0].name, "IfcWall_wall_" + block_id(0));
  EXPECT_EQ(nodes[1].name, "IfcSlab_caf\xC3\xA9 's_" + block_id(1));
  EXPECT_EQ(nodes[1].path,
            "IfcSite_Site_site/IfcBuilding_B_building/IfcBuildingStorey_First floor_storey1/" +
                nodes[1].name);
}

TEST(Ifc, AStoreyIsAPartWithAllThatIsInIt) {
  IfcSample sample = sample_with("IFC4", "extrusion");
  sample.storeys = {"Ground floor", "First floor"};
  sample.blocks[1].storey = 1;
  sample.blocks.push_back({"IFCWALL", "other", {9, 9, 3}, {1, 1, 1}, 1});
  TemporaryFolder folder;
  MeshRequest request;
  request.part = "IfcBuildingStorey_First floor_storey1";
  const auto result = read_in_own_folder(folder.write("a.ifc", ifc_text(sample)), request);
  ASSERT_TRUE(std::holds_alternative<ReadMesh>(result)) << std::get<MeshFailure>(result).message;
  EXPECT_LT((extent(*std::get<ReadMesh>(result).mesh).lower - Vec3(3, 4, 3)).norm(), 1e-6);
  EXPECT_LT((extent(*std::get<ReadMesh>(result).mesh).upper - Vec3(10, 10, 5.5)).norm(), 1e-6);
}

}  // namespace
}  // namespace rubicon::mesh_io::testing
