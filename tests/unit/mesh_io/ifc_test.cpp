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

/// Profiles that are given by their measures, with area and extent worked out by hand.
TEST(Ifc, ProfilesByTheirMeasuresAreRead) {
  struct Case {
    const char* profile;
    double area;  // mm2
    double width, depth;
  };
  for (const Case& each : {
           Case{"IFCLSHAPEPROFILEDEF(.AREA.,$,$,150.,100.,10.,$,$,$)", 150 * 10 + 90 * 10, 100,
                150},
           Case{"IFCLSHAPEPROFILEDEF(.AREA.,$,$,100.,$,10.,$,$,$)", 1900, 100, 100},
           Case{"IFCUSHAPEPROFILEDEF(.AREA.,$,$,200.,75.,8.,11.,$,$,$)", 2 * 75 * 11 + 178 * 8, 75,
                200},
           Case{"IFCTSHAPEPROFILEDEF(.AREA.,$,$,100.,80.,6.,9.,$,$,$,$,$)", 80 * 9 + 91 * 6, 80,
                100},
           Case{"IFCCSHAPEPROFILEDEF(.AREA.,$,$,200.,60.,2.,20.,$)",
                200 * 2 + 2 * 58 * 2 + 2 * 18 * 2, 60, 200},
           Case{"IFCZSHAPEPROFILEDEF(.AREA.,$,$,160.,70.,8.,10.,$,$)", 160 * 8 + 2 * 62 * 10, 132,
                160},
           Case{"IFCASYMMETRICISHAPEPROFILEDEF(.AREA.,$,$,200.,300.,8.,12.,$,150.,10.,$)",
                200 * 12 + 150 * 10 + 278 * 8, 200, 300},
           Case{"IFCTRAPEZIUMPROFILEDEF(.AREA.,$,$,200.,100.,80.,-20.)", 150 * 80, 220, 80},
           Case{"IFCRECTANGLEHOLLOWPROFILEDEF(.AREA.,$,$,120.,80.,5.,$,$)", 120 * 80 - 110 * 70,
                120, 80},
           Case{"IFCISHAPEPROFILEDEF(.AREA.,$,$,100.,200.,6.,9.,$)", 2 * 100 * 9 + 182 * 6, 100,
                200},
       }) {
    SCOPED_TRACE(each.profile);
    IfcSample sample;
    sample.shape = each.profile;
    TemporaryFolder folder;
    const auto result = read_in_own_folder(folder.write("a.ifc", ifc_text(sample)));
    ASSERT_TRUE(std::holds_alternative<ReadMesh>(result)) << std::get<MeshFailure>(result).message;
    const geometry::TriangleMesh& mesh = *std::get<ReadMesh>(result).mesh;
    const Vec3 size = extent(mesh).upper - extent(mesh).lower;
    EXPECT_LT((size - Vec3(each.width / 1000, each.depth / 1000, 2.5)).norm(), 1e-6)
        << size.transpose();
    EXPECT_TRUE(mesh.closed);
    EXPECT_NEAR(volume(mesh), each.area * 1e-6 * 2.5, 1e-9);
  }
}

TEST(Ifc, AProfileStandsWhereItsPositionSays) {
  IfcSample sample;
  sample.shape = "IFCLSHAPEPROFILEDEF(.AREA.,$,#900,100.,50.,10.,$,$,$)";
  sample.more =
      "#900= IFCAXIS2PLACEMENT2D(#901,#902);\n#901= IFCCARTESIANPOINT((1000.,500.));\n"
      "#902= IFCDIRECTION((0.,1.));\n";
  TemporaryFolder folder;
  const auto result = read_in_own_folder(folder.write("a.ifc", ifc_text(sample)));
  ASSERT_TRUE(std::holds_alternative<ReadMesh>(result)) << std::get<MeshFailure>(result).message;
  const geometry::TriangleMesh& mesh = *std::get<ReadMesh>(result).mesh;
  // Turned by a right angle: the short leg, at the lower end, now lies at the right.
  EXPECT_LT((extent(mesh).lower - Vec3(0.95, 0.475, 0)).norm(), 1e-6);
  EXPECT_LT((extent(mesh).upper - Vec3(1.05, 0.525, 2.5)).norm(), 1e-6);
  double right = 0;  // area of the face at x 1.05
  for (const auto& t : mesh.triangles) {
    const auto corner = [&](std::size_t k) {
      return mesh.vertices[static_cast<std::size_t>(t[k])];
    };
    const Vec3 area = (corner(1) - corner(0)).cross(corner(2) - corner(0)) / 2;
    if (area.x() > 0 && std::abs(corner(0).x() - 1.05) < 1e-5) right += area.x();
  }
  EXPECT_NEAR(right, 0.05 * 2.5, 1e-6);
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
