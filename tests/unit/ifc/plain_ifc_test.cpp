#include "src/exchange/ifc/plain_ifc.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "src/exchange/ifc/step_values.hpp"
#include "tests/support/ifc_sample.hpp"

namespace rubicon::ifc {
namespace {

using ::rubicon::testing::ifc_text;
using ::rubicon::testing::IfcSample;
using ::testing::HasSubstr;
using ::testing::Not;

PlainIfc plain_of(const std::string& text) {
  const auto file = StepFile::read(text);
  const auto& step = std::get<StepFile>(file);
  return plain_ifc(step, std::get<IfcModel>(read_model(step)));
}

PlainIfc plain_of(const IfcSample& sample) { return plain_of(ifc_text(sample)); }

IfcSample shaped(const std::string& shape) {
  IfcSample sample;
  sample.schema = "IFC4";
  sample.shape = shape;
  return sample;
}

TEST(PlainIfc, WhatComesOutIsAFileWithoutLooseEnds) {
  for (const char* shape : {"extrusion", "extrusion without positions", "brep", "triangles",
                            "polygons", "indexed curve", "mapped", "advanced"}) {
    const std::string text = plain_of(shaped(shape)).text;
    const auto file = StepFile::read(text);
    ASSERT_TRUE(std::holds_alternative<StepFile>(file)) << std::get<StepError>(file).message;
    const auto& step = std::get<StepFile>(file);
    EXPECT_EQ(step.schema(), "IFC2X3");
    for (const StepRecord& record : step.records()) {
      EXPECT_THAT(std::string(record.keyword), Not(HasSubstr("LIST")));
      EXPECT_THAT(std::string(record.keyword), Not(HasSubstr("INDEXED")));
      const auto values = StepValues::read(record.arguments);
      ASSERT_TRUE(values) << record.arguments;
      for (const std::uint64_t id : values->references()) {
        EXPECT_NE(step.find(id), nullptr) << shape << " #" << id;
      }
    }
  }
}

TEST(PlainIfc, AShapeThatCannotBeSaidIsLeftOutWhole) {
  EXPECT_THAT(plain_of(shaped("advanced")).text, Not(HasSubstr("IFCBUILDINGELEMENTPROXY")));
  EXPECT_THAT(plain_of(shaped("brep")).text, HasSubstr("IFCBUILDINGELEMENTPROXY"));
}

TEST(PlainIfc, PositionsThatAreLeftOutArePutIn) {
  const std::string text = plain_of(shaped("extrusion without positions")).text;
  const auto file = StepFile::read(text);
  for (const StepRecord& record : std::get<StepFile>(file).records()) {
    const auto values = StepValues::read(record.arguments);
    if (record.keyword == "IFCRECTANGLEPROFILEDEF") {
      EXPECT_NE((*values)[2].reference(), 0U);
    }
    if (record.keyword == "IFCEXTRUDEDAREASOLID") {
      EXPECT_NE((*values)[1].reference(), 0U);
    }
  }
}

TEST(PlainIfc, PointsFarOutAreMovedByOneRoundOffset) {
  IfcSample sample = shaped("brep");
  sample.coordinates = {155000.1234, 463000.5678, 5};
  const PlainIfc plain = plain_of(sample);
  ASSERT_EQ(plain.offsets.size(), 1U);
  EXPECT_EQ(plain.offsets[0], math::Vec3(155000e3, 463000e3, 0));
  EXPECT_THAT(plain.text, Not(HasSubstr("155000")));
}

TEST(PlainIfc, WhereAShapeHasPointsNearAndFarNothingIsMoved) {
  IfcSample sample = shaped("brep");
  sample.coordinates = {155000.1234, 463000.5678, 5};
  std::string text = ifc_text(sample);
  const std::size_t point = text.find("(155000123");
  text.replace(point, text.find(')', point) - point, "(0.,0.,0.");
  EXPECT_EQ(plain_of(text).offsets[0], math::Vec3(0, 0, 0));
}

TEST(PlainIfc, RingsEndTheShapeTheyAreIn) {
  IfcSample sample = shaped("extrusion");
  std::string text = ifc_text(sample);
  // The profile becomes a map of the representation that holds it.
  const std::size_t at = text.find("IFCEXTRUDEDAREASOLID(");
  const std::size_t line = text.rfind('#', at);
  const std::string id = text.substr(line, text.find('=', line) - line);
  text.replace(at, text.find(';', at) - at, "IFCBOOLEANRESULT(.UNION.," + id + "," + id + ")");
  EXPECT_THAT(plain_of(text).text, Not(HasSubstr("IFCBUILDINGELEMENTPROXY")));
}

TEST(PlainIfc, TheNameOfANodeLeadsBackToItsElement) {
  EXPECT_EQ(element_of("IfcBuildingElementProxy_x__element_17"), 17U);
  EXPECT_EQ(element_of("IfcMappedItem"), std::nullopt);
  EXPECT_EQ(element_of("IfcBuildingElementProxy_x__element_"), std::nullopt);
  EXPECT_EQ(element_of("IfcBuildingElementProxy_x__element_1x"), std::nullopt);
}

}  // namespace
}  // namespace rubicon::ifc
