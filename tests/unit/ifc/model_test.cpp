#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/exchange/ifc/ifc_model.hpp"
#include "tests/support/ifc_sample.hpp"

namespace rubicon::ifc {
namespace {

using ::rubicon::testing::block_id;
using ::rubicon::testing::ifc_text;
using ::rubicon::testing::IfcSample;
using ::rubicon::testing::SampleBlock;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;

std::variant<IfcModel, IfcFailure> read(const std::string& text) {
  const auto file = StepFile::read(text);
  if (const auto* error = std::get_if<StepError>(&file)) return IfcFailure{error->message};
  return read_model(std::get<StepFile>(file));
}

IfcModel model_of(const std::string& text) {
  const auto model = read(text);
  EXPECT_TRUE(std::holds_alternative<IfcModel>(model)) << std::get<IfcFailure>(model).message;
  return std::get<IfcModel>(model);
}

IfcSample two_storeys(const std::string& schema) {
  IfcSample sample;
  sample.schema = schema;
  sample.storeys = {"Ground floor", "H\\X2\\00F6\\X0\\he 2e"};
  sample.blocks = {{"IFCWALLSTANDARDCASE", "outer ''leaf''", {1, 2, 0}, {2, 0.2, 2.5}, 0},
                   {"IFCSLAB", "floor", {3, 4, 3}, {2, 1.2, 0.3}, 1}};
  return sample;
}

TEST(IfcModel, ElementsHaveWhatTheFileSaysOfThem) {
  for (const char* schema : {"IFC2X3", "IFC4", "IFC4X3_ADD2"}) {
    const IfcModel model = model_of(ifc_text(two_storeys(schema)));
    EXPECT_EQ(model.schema, schema);
    ASSERT_EQ(model.elements.size(), 2U);
    const IfcElement& wall = model.elements[0];
    EXPECT_EQ(wall.type, "IfcWallStandardCase");
    EXPECT_EQ(wall.name, "outer 'leaf'");
    EXPECT_EQ(wall.guid, block_id(0));
    EXPECT_EQ(wall.tag, "tag 0");
    EXPECT_EQ(wall.storey, "Ground floor");
    ASSERT_TRUE(wall.X_WE);
    EXPECT_LT((wall.X_WE->translation() - math::Vec3(1, 2, 0)).norm(), 1e-12);
    const IfcElement& slab = model.elements[1];
    EXPECT_EQ(slab.storey, "H\xC3\xB6he 2e");
    EXPECT_NEAR(slab.storey_height, 3, 1e-12);
    EXPECT_EQ(model.tree[static_cast<std::size_t>(slab.node)].name, "IfcSlab_floor_" + block_id(1));
  }
}

TEST(IfcModel, UnitsAreTurnedIntoMetres) {
  for (const char* unit : {"mm", "m", "ft"}) {
    IfcSample sample = two_storeys("IFC4");
    sample.unit = unit;
    const IfcModel model = model_of(ifc_text(sample));
    EXPECT_LT((model.elements[1].X_WE->translation() - math::Vec3(3, 4, 3)).norm(), 1e-12) << unit;
  }
}

TEST(IfcModel, PlacementsAddUpAndTurn) {
  IfcSample sample = two_storeys("IFC2X3");
  sample.site = {155000.1, 463000.2, 12};
  std::string text = ifc_text(sample);
  EXPECT_LT(
      (model_of(text).elements[0].X_WE->translation() - math::Vec3(155001.1, 463002.2, 12)).norm(),
      1e-9);
}

TEST(IfcModel, AnElementWhosePlacementLeadsInARingHasNoPlace) {
  IfcSample sample = two_storeys("IFC4");
  sample.more =
      "#900= IFCLOCALPLACEMENT(#901,#902);\n#901= IFCLOCALPLACEMENT(#900,#902);\n"
      "#902= IFCAXIS2PLACEMENT3D(#903,$,$);\n#903= IFCCARTESIANPOINT((0.,0.,0.));\n"
      "#904= IFCWALL('ring',$,'ring',$,$,#900,#905,$,$);\n"
      "#905= IFCPRODUCTDEFINITIONSHAPE($,$,());\n";
  const IfcModel model = model_of(ifc_text(sample));
  ASSERT_EQ(model.elements.size(), 3U);
  EXPECT_FALSE(model.elements[2].X_WE);
  EXPECT_TRUE(model.elements[0].X_WE);
}

TEST(IfcModel, SpacesAndOpeningsAreCountedAndNotBuilt) {
  IfcSample sample = two_storeys("IFC4");
  sample.blocks.push_back({"IFCSPACE", "room", {0, 0, 0}, {1, 1, 1}, 0});
  sample.blocks.push_back({"IFCOPENINGELEMENT", "hole", {0, 0, 0}, {1, 1, 1}, 0});
  sample.blocks.push_back({"IFCSPACE", "room", {0, 0, 0}, {1, 1, 1}, 0});
  const IfcModel model = model_of(ifc_text(sample));
  EXPECT_EQ(model.elements.size(), 2U);
  EXPECT_THAT(model.no_elements, ElementsAre(Pair("IfcOpeningElement", 1), Pair("IfcSpace", 2)));
}

TEST(IfcModel, APartBelongsToTheStoreyOfItsWhole) {
  IfcSample sample = two_storeys("IFC4");
  const std::string text = ifc_text(sample);
  // The slab, without a storey of its own, becomes a part of the wall.
  const auto file = StepFile::read(text);
  std::uint64_t wall = 0;
  std::uint64_t slab = 0;
  for (const StepRecord& record : std::get<StepFile>(file).records()) {
    if (record.keyword == "IFCWALLSTANDARDCASE") wall = record.id;
    if (record.keyword == "IFCSLAB") slab = record.id;
  }
  sample.more = "#990= IFCRELAGGREGATES('part',$,$,$,#" + std::to_string(wall) + ",(#" +
                std::to_string(slab) + "));\n";
  const IfcModel model = model_of(ifc_text(sample));
  EXPECT_EQ(model.elements[1].storey, "Ground floor");
  EXPECT_EQ(model.tree[static_cast<std::size_t>(model.elements[1].node)].parent,
            model.elements[0].node);
}

TEST(IfcModel, WhereTheOriginLiesOnTheMapIsTold) {
  IfcSample sample = two_storeys("IFC4");
  sample.more = "#990= IFCMAPCONVERSION(#1,#2,155000.5,463000.25,-1.5,1.,0.,1.);\n";
  const IfcModel model = model_of(ifc_text(sample));
  ASSERT_TRUE(model.map_origin);
  EXPECT_EQ(*model.map_origin, math::Vec3(155000.5, 463000.25, -1.5));
}

TEST(IfcModel, AFileWithoutUnitOrOfAnotherSchemaIsRefused) {
  IfcSample sample = two_storeys("AUTOMOTIVE_DESIGN");
  const auto other = read(ifc_text(sample));
  ASSERT_TRUE(std::holds_alternative<IfcFailure>(other));
  EXPECT_THAT(std::get<IfcFailure>(other).message,
              HasSubstr("no IFC: its schema is 'AUTOMOTIVE_DESIGN'"));
  std::string text = ifc_text(two_storeys("IFC4"));
  text.replace(text.find(".LENGTHUNIT."), 12, ".WEIGHTUNIT.");
  const auto none = read(text);
  ASSERT_TRUE(std::holds_alternative<IfcFailure>(none));
  EXPECT_THAT(std::get<IfcFailure>(none).message, HasSubstr("no unit of length"));
}

}  // namespace
}  // namespace rubicon::ifc
