#include "src/exchange/building_io/read_elements.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/ifc_sample.hpp"
#include "tests/unit/building_io/building_support.hpp"
#include "tests/unit/mesh_io/mesh_files_io.hpp"

namespace rubicon::building_io {
namespace {

using mesh_io::testing::box_soup;
using rubicon::testing::block_id;
using rubicon::testing::ifc_text;
using rubicon::testing::IfcSample;
using test::read_models;
using test::ReadModels;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The object of an OBJ text under another name.
std::string objects_called(const std::string& name, std::string text) {
  const std::size_t at = text.find("\no ") + 3;
  return text.replace(at, text.find('\n', at) - at, name);
}

IfcSample house(const std::string& schema) {
  IfcSample sample;
  sample.schema = schema;
  sample.storeys = {"Ground floor", "First floor"};
  sample.blocks = {{"IFCWALL", "wall \\X2\\00E9\\X0\\", {1, 2, 0}, {4, 0.2, 2.5}, 0},
                   {"IFCSLAB", "slab", {1, 2, 2.5}, {4, 1.2, 0.3}, 1},
                   {"IFCSLAB", "slab", {1, 3.2, 2.5}, {4, 1.2, 0.3}, 1}};
  return sample;
}

TEST(ReadElements, OfAnIfcFileInBothVersions) {
  for (const char* schema : {"IFC2X3", "IFC4"}) {
    const ReadModels read = read_models({{"house.ifc", ifc_text(house(schema))}});
    EXPECT_THAT(read.said, IsEmpty());
    ASSERT_EQ(read.elements.all.size(), 3U);
    const Element& wall = read.elements.all[0];
    EXPECT_EQ(wall.component, "wall_e_ground_floor");
    EXPECT_EQ(wall.name, "wall \xC3\xA9");
    EXPECT_EQ(wall.storey, "Ground floor");
    EXPECT_EQ(wall.type, "IfcWall");
    EXPECT_EQ(wall.guid, block_id(0));
    EXPECT_EQ(wall.part, block_id(0));
    EXPECT_EQ(wall.model, "house.ifc");
    EXPECT_LT((wall.frame.origin - Vec3(3, 2.1, 0)).norm(), 2e-5);
    EXPECT_LT((wall.frame.size - Vec3(4, 0.2, 2.5)).norm(), 2e-5);
    EXPECT_NEAR(wall.frame.volume, 2, 1e-5);
    EXPECT_EQ(read.elements.all[1].component, "slab_first_floor");
    EXPECT_EQ(read.elements.all[2].component, "slab_first_floor_2");
    EXPECT_THAT(read.elements.notes.at(0), HasSubstr("3 elements, lengths in 0.001 m"));
  }
}

TEST(ReadElements, FarOutTheBuildingGetsAnOriginOfItsOwn) {
  IfcSample sample = house("IFC4");
  sample.site = {155000.1234, 463000.5678, 12};
  const ReadModels read = read_models({{"house.ifc", ifc_text(sample)}});
  EXPECT_EQ(read.elements.origin, Vec3(155000, 463000, 0));
  EXPECT_LT((read.elements.all[0].frame.origin - Vec3(155003.1234, 463002.6678, 12)).norm(), 2e-5);
}

TEST(ReadElements, WhatHasNoShapeThatCanBeReadIsListed) {
  IfcSample sample = house("IFC4");
  sample.more =
      "#900= IFCADVANCEDBREP(#1);\n#901= IFCSHAPEREPRESENTATION($,'Body','x',(#900));\n"
      "#902= IFCPRODUCTDEFINITIONSHAPE($,$,(#901));\n"
      "#903= IFCROOF('roof_00000000000000000',$,'dome',$,$,$,#902,$,$);\n"
      "#910= IFCLOCALPLACEMENT(#910,#911);\n"
      "#912= IFCDOOR('door_00000000000000000',$,'ring',$,$,#910,#902,$,$);\n";
  sample.more +=
      "#920= IFCDOOR('door_00000000000000001',$,'on the grid',$,$,#921,#902,$,$);\n"
      "#921= IFCLOCALPLACEMENT(#922,#923);\n#922= IFCGRIDPLACEMENT(#924,$);\n"
      "#923= IFCAXIS2PLACEMENT3D(#925,$,$);\n#925= IFCCARTESIANPOINT((0.,0.,0.));\n"
      "#930= IFCDOOR('door_00000000000000002',$,'nowhere',$,$,#931,#902,$,$);\n";
  sample.blocks.push_back({"IFCSPACE", "room", {0, 0, 0}, {1, 1, 1}, 0});
  const ReadModels read = read_models({{"house.ifc", ifc_text(sample)}});
  EXPECT_EQ(read.elements.all.size(), 3U);
  EXPECT_TRUE(
      test::says(read.said, "it is placed by #922, an IfcGridPlacement, which is not read"));
  EXPECT_TRUE(test::says(read.said, "there is no placement #931"));
  EXPECT_TRUE(test::says(read.said, "export it with a placement of its own"));
  EXPECT_TRUE(test::says(read.said, "I14 IfcRoof 'dome'"));
  EXPECT_TRUE(test::says(read.said, "its shape has nothing that can be read (IfcAdvancedBrep)"));
  EXPECT_TRUE(test::says(read.said, "I14 IfcDoor 'ring'"));
  EXPECT_TRUE(test::says(read.said, "its placement #910 leads nowhere"));
  EXPECT_TRUE(test::says(read.elements.notes, "1 IfcSpace left out"));
}

TEST(ReadElements, WhatIsNotCutOffIsListed) {
  IfcSample sample = house("IFC4");
  sample.more =
      "#900= IFCBOOLEANRESULT(.DIFFERENCE.,#910,#920);\n#910= IFCBLOCK(#911,100.,100.,100.);\n"
      "#911= IFCAXIS2PLACEMENT3D(#912,$,$);\n#912= IFCCARTESIANPOINT((0.,0.,0.));\n"
      "#920= IFCADVANCEDBREP(#912);\n"
      "#901= IFCSHAPEREPRESENTATION($,'Body','x',(#900));\n"
      "#902= IFCPRODUCTDEFINITIONSHAPE($,$,(#901));\n"
      "#903= IFCROOF('roof_00000000000000000',$,'dome',$,$,$,#902,$,$);\n";
  const ReadModels read = read_models({{"house.ifc", ifc_text(sample)}});
  EXPECT_EQ(read.elements.all.size(), 4U);
  EXPECT_TRUE(test::says(read.said, "I14 IfcRoof 'dome'"));
  EXPECT_TRUE(test::says(read.said, "is not quite as in the model: what is to be cut off"));
}

TEST(ReadElements, TwiceTheSameGlobalIdIsNoNameForAPart) {
  std::string text = ifc_text(house("IFC4"));
  text.replace(text.find(block_id(1)), block_id(1).size(), block_id(2));
  const ReadModels read = read_models({{"house.ifc", text}});
  ASSERT_EQ(read.elements.all.size(), 3U);
  EXPECT_FALSE(read.elements.all[0].mesh);
  for (const std::size_t i : {1U, 2U}) {
    ASSERT_TRUE(read.elements.all[i].mesh);
    const geometry::Box extent = mesh_io::testing::extent(*read.elements.all[i].mesh);
    EXPECT_LT((extent.upper - Vec3(2, 0.6, 0.3)).norm(), 2e-5);
  }
}

TEST(ReadElements, AModelThatCannotBeReadIsAnError) {
  EXPECT_TRUE(test::says(read_models({{"a.ifc", "ISO-10303-21;"}}).said, "I11 mesh"));
  EXPECT_TRUE(test::says(read_models({{"a.obj", "hello"}}, "m").said, "I11 mesh"));
  EXPECT_TRUE(test::says(read_models({{"a.stl", std::string(90, '\xff')}}, "m").said, "I11 mesh"));
  // Bombs only ever kill the helper's child.
  std::string deep = "<COLLADA>";
  for (int i = 0; i < 300000; ++i) deep += "<node>";
  EXPECT_TRUE(test::says(read_models({{"a.dae", deep}}).said, "I11 mesh"));
}

TEST(ReadElements, AnObjFileOfTwoObjectsInMillimetresYUp) {
  const std::string one = mesh_io::testing::as_obj(box_soup({0, 0, 0}, {4000, 2500, 200}));
  const ReadModels read = read_models({{"a.obj", objects_called("wall", one)}}, "mm", 'y');
  ASSERT_EQ(read.elements.all.size(), 1U);
  EXPECT_EQ(read.elements.all[0].component, "wall");
  EXPECT_EQ(read.elements.all[0].part, "");
  EXPECT_LT((read.elements.all[0].frame.size - Vec3(4, 0.2, 2.5)).norm(), 2e-5);
}

TEST(ReadElements, AFileOfOneMeshIsOneElement) {
  const auto soup = box_soup({0, 0, 0}, {4, 0.2, 2.5});
  const std::vector<std::pair<std::string, std::string>> files = {
      {"text.stl", mesh_io::testing::as_stl_text(soup)},
      {"binary.stl", mesh_io::testing::as_stl_binary(soup)},
      {"mesh.ply", mesh_io::testing::as_ply(soup)},
      {"mesh.obj", mesh_io::testing::as_obj(soup)}};
  for (const auto& file : files) {
    SCOPED_TRACE(file.first);
    const ReadModels read = read_models({file}, "m");
    EXPECT_THAT(read.said, IsEmpty());
    ASSERT_EQ(read.elements.all.size(), 1U);
    EXPECT_EQ(read.elements.all[0].part, "");
    EXPECT_LT((read.elements.all[0].frame.size - Vec3(4, 0.2, 2.5)).norm(), 2e-5);
  }
}

TEST(ReadElements, WhatIsNotClosedIsListed) {
  auto soup = box_soup({0, 0, 0}, {4, 0.2, 2.5});
  soup.pop_back();
  const ReadModels read = read_models({{"mesh.obj", mesh_io::testing::as_obj(soup)}}, "m");
  ASSERT_EQ(read.elements.all.size(), 1U);
  EXPECT_TRUE(test::says(read.said, "I14 1 element with a surface that is not closed"));
}

TEST(ReadElements, GltfSaysItsUnitAndAxes) {
  const auto soup = box_soup({0, 0, 0}, {4, 2.5, 0.2});
  const ReadModels read = read_models({{"a.gltf", mesh_io::testing::as_gltf(soup, "")}});
  EXPECT_THAT(read.said, IsEmpty());
  ASSERT_EQ(read.elements.all.size(), 1U);
  EXPECT_LT((read.elements.all[0].frame.size - Vec3(4, 0.2, 2.5)).norm(), 2e-5);
}

TEST(ReadElements, NodesOfColladaAreElements) {
  // part_a at 10; part_b with part_c below it, 100 m towards us, with y up: south.
  const auto soup = box_soup({0, 0, 0}, {4, 2.5, 0.2});
  const ReadModels read = read_models({{"a.dae", mesh_io::testing::as_dae(soup, "Y_UP", "1")}});
  EXPECT_THAT(read.said, IsEmpty());
  ASSERT_EQ(read.elements.all.size(), 3U);
  const Element& a = read.elements.all[0];
  EXPECT_EQ(a.component, "part_a");
  EXPECT_EQ(a.part, "part_a");
  EXPECT_LT((a.frame.size - Vec3(4, 0.2, 2.5)).norm(), 2e-5);
  EXPECT_LT((a.frame.origin - Vec3(12, -0.1, 0)).norm(), 2e-5);
  // As a part it would come with what is below it.
  EXPECT_TRUE(read.elements.all[1].mesh);
  const Element& c = read.elements.all[2];
  EXPECT_EQ(c.part, "part_c");
  EXPECT_EQ(c.storey, "part_b");
  EXPECT_LT((c.frame.origin - Vec3(2, -100.1, 0)).norm(), 2e-5);
}

TEST(ReadElements, NodesOfOneNameComeAsMeshesOfTheirOwn) {
  const std::string one = mesh_io::testing::as_obj(box_soup({0, 0, 0}, {4, 0.2, 2.5}));
  const ReadModels two = read_models(
      {{"a.obj", objects_called("wall", one)}, {"b.obj", objects_called("wall", one)}}, "m");
  ASSERT_EQ(two.elements.all.size(), 2U);
  EXPECT_EQ(two.elements.all[0].component, "wall");
  EXPECT_EQ(two.elements.all[1].component, "wall_2");
  EXPECT_FALSE(two.elements.all[0].mesh);  // each is the whole of its file
}

}  // namespace
}  // namespace rubicon::building_io
