#include "src/exchange/ifc/element_bodies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <variant>

#include "tests/support/ifc_sample.hpp"

namespace rubicon::ifc {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::optional<ElementBody>> bodies_of(const std::string& more) {
  ::rubicon::testing::IfcSample sample;
  sample.schema = "IFC4";
  sample.unit = "m";
  sample.blocks.clear();
  sample.more =
      "#500000= IFCWALL('x',$,$,$,$,$,#500001,$,$);\n"
      "#500001= IFCPRODUCTDEFINITIONSHAPE($,$,(#500002));\n"
      "#500002= IFCSHAPEREPRESENTATION($,'Body','x',(#1000));\n"
      "#1001= IFCAXIS2PLACEMENT3D(#1002,$,$);\n#1002= IFCCARTESIANPOINT((0.,0.,0.));\n" +
      more;
  const std::string text = ::rubicon::testing::ifc_text(sample);
  const auto file = StepFile::read(text);
  const auto& step = std::get<StepFile>(file);
  WorkBudget budget = shape_budget(step);
  return element_bodies(step, std::get<IfcModel>(read_model(step)), budget);
}

TEST(ElementBodies, ACutThatCannotBeReadIsNotedAndLeftOut) {
  const auto bodies = bodies_of(
      "#1000= IFCBOOLEANRESULT(.DIFFERENCE.,#1003,#1004);\n#1003= IFCBLOCK(#1001,1.,2.,3.);\n"
      "#1004= IFCADVANCEDBREP(#1002);\n");
  ASSERT_EQ(bodies.size(), 1U);
  ASSERT_TRUE(bodies[0]);
  EXPECT_NEAR(volume_of(bodies[0]->solid), 6, 1e-12);
  EXPECT_THAT(bodies[0]->notes, ElementsAre(HasSubstr("nothing is cut off")));
}

TEST(ElementBodies, AnOpeningThatCannotBeReadIsNoted) {
  const auto bodies = bodies_of(
      "#1000= IFCBLOCK(#1001,1.,2.,3.);\n"
      "#600000= IFCOPENINGELEMENT('o',$,$,$,$,$,#600001,$,$);\n"
      "#600001= IFCPRODUCTDEFINITIONSHAPE($,$,(#600002));\n"
      "#600002= IFCSHAPEREPRESENTATION($,'Body','x',(#1002));\n"
      "#600003= IFCRELVOIDSELEMENT('v',$,$,$,#500000,#600000);\n");
  ASSERT_EQ(bodies.size(), 1U);
  ASSERT_TRUE(bodies[0]);
  EXPECT_THAT(bodies[0]->notes, ElementsAre(HasSubstr("an opening")));
}

/// A block of 6 x 0.3 x 3 m, and a projection of 1 x DEPTH x 3 m that begins at y.
std::vector<std::optional<ElementBody>> with_projection(const std::string& y,
                                                        const std::string& depth,
                                                        const std::string& shape = "#600001") {
  return bodies_of(
      "#1000= IFCBLOCK(#1001,6.,0.3,3.);\n"
      "#600000= IFCPROJECTIONELEMENT('o',$,$,$,$,#600010," +
      shape +
      ",$,$);\n"
      "#600001= IFCPRODUCTDEFINITIONSHAPE($,$,(#600002));\n"
      "#600002= IFCSHAPEREPRESENTATION($,'Body','x',(#600003));\n"
      "#600003= IFCBLOCK(#1001,1.," +
      depth +
      ",3.);\n"
      "#600004= IFCADVANCEDBREP(#1002);\n"
      "#600005= IFCPRODUCTDEFINITIONSHAPE($,$,(#600006));\n"
      "#600006= IFCSHAPEREPRESENTATION($,'Body','x',(#600004));\n"
      "#600010= IFCLOCALPLACEMENT($,#600011);\n#600011= IFCAXIS2PLACEMENT3D(#600012,$,$);\n"
      "#600012= IFCCARTESIANPOINT((1.," +
      y +
      ",0.));\n"
      "#600020= IFCRELPROJECTSELEMENT('v',$,$,$,#500000,#600000);\n");
}

TEST(ElementBodies, WhatProjectsIsAPartOfItsElementAndCountsOnce) {
  for (const auto& [y, depth] :
       {std::pair("0.3", "0.5"), std::pair("0.1", "0.7"), std::pair("0.", "0.8")}) {
    const auto bodies = with_projection(y, depth);
    ASSERT_EQ(bodies.size(), 1U);
    ASSERT_TRUE(bodies[0]);
    EXPECT_NEAR(volume_of(bodies[0]->solid), 6 * 0.3 * 3 + 1 * 0.5 * 3, 1e-9) << y;
    EXPECT_TRUE(is_closed(bodies[0]->solid)) << y;
    EXPECT_TRUE(bodies[0]->notes.empty()) << y;
    double reach = 0;
    for (const auto& p : bodies[0]->solid.points) reach = std::max(reach, p.y());
    EXPECT_NEAR(reach, 0.8, 1e-9) << y;
  }
  // All of it inside: nothing is added.
  EXPECT_NEAR(volume_of(with_projection("0.1", "0.1")[0]->solid), 5.4, 1e-9);
}

/// Two blocks of 2 x 1 x 1 m, the second moved along x.
TEST(ElementBodies, WhatTwoBodiesHaveInCommonCountsOnce) {
  for (const auto& [x, volume] :
       {std::pair("1.", 3.0), std::pair("0.5", 2.5), std::pair("2.", 4.0), std::pair("5.", 4.0)}) {
    const auto bodies = bodies_of(
        "#1000= IFCBOOLEANRESULT(.UNION.,#1010,#1011);\n#1010= IFCBLOCK(#1001,2.,1.,1.);\n"
        "#1011= IFCBLOCK(#1012,2.,1.,1.);\n#1012= IFCAXIS2PLACEMENT3D(#1013,$,$);\n"
        "#1013= IFCCARTESIANPOINT((" +
        std::string(x) + ",0.,0.));\n");
    ASSERT_EQ(bodies.size(), 1U);
    ASSERT_TRUE(bodies[0]);
    EXPECT_NEAR(volume_of(bodies[0]->solid), volume, 1e-9) << x;
    EXPECT_TRUE(is_closed(bodies[0]->solid)) << x;
    EXPECT_TRUE(bodies[0]->notes.empty()) << x;
  }
}

/// 101 blocks in a row, each with half of it in the next.
TEST(ElementBodies, TooManyBodiesThatOverlapAreNoted) {
  for (const int step : {1, 3}) {
    std::string text;
    for (int i = 0; i <= 100; ++i) {
      const int block = 10'000 + 10 * i;
      text += "#" + std::to_string(block) + "= IFCBLOCK(#" + std::to_string(block + 1) +
              ",2.,1.,1.);\n#" + std::to_string(block + 1) + "= IFCAXIS2PLACEMENT3D(#" +
              std::to_string(block + 2) + ",$,$);\n#" + std::to_string(block + 2) +
              "= IFCCARTESIANPOINT((" + std::to_string(step * i) + ".,0.,0.));\n";
      if (i == 0) continue;
      const int before = i == 1 ? 10'000 : 20'000 + i - 1;
      text += "#" + std::to_string(i == 100 ? 1000 : 20'000 + i) + "= IFCBOOLEANRESULT(.UNION.,#" +
              std::to_string(before) + ",#" + std::to_string(block) + ");\n";
    }
    const auto bodies = bodies_of(text);
    ASSERT_EQ(bodies.size(), 1U);
    ASSERT_TRUE(bodies[0]);
    EXPECT_NEAR(volume_of(bodies[0]->solid), 202, 1e-9) << step;
    if (step == 1) {
      EXPECT_THAT(bodies[0]->notes, ElementsAre(HasSubstr("101 of its bodies may overlap")));
    } else {
      EXPECT_TRUE(bodies[0]->notes.empty());
    }
  }
}

TEST(ElementBodies, AProjectionThatCannotBeReadIsNoted) {
  const auto bodies = with_projection("0.3", "0.5", "#600005");
  ASSERT_EQ(bodies.size(), 1U);
  EXPECT_NEAR(volume_of(bodies[0]->solid), 5.4, 1e-9);
  EXPECT_THAT(bodies[0]->notes,
              ElementsAre(HasSubstr("a projection cannot be read and is missing")));
}

/// One that projects from nothing that has a shape stands for itself.
TEST(ElementBodies, AProjectionWithoutItsElementIsAnElement) {
  const auto bodies = bodies_of(
      "#1000= IFCBLOCK(#1001,1.,2.,3.);\n#600000= "
      "IFCPROJECTIONELEMENT('o',$,$,$,$,$,#500001,$,$);\n"
      "#600020= IFCRELPROJECTSELEMENT('v',$,$,$,#600099,#600000);\n");
  EXPECT_EQ(bodies.size(), 2U);
}

TEST(ElementBodies, WhatCannotBeReadWholeIsNotRead) {
  for (const char* item :
       {"#1000= IFCADVANCEDBREP(#1002);\n", "#1000= IFCBLOCK(#1001,0.,2.,3.);\n",
        "#1000= IFCBLOCK(#1001,-1.,2.,3.);\n", "#1000= IFCBLOCK(#1002,1.,2.,3.);\n",
        "#1000= IFCSPHERE(#1001,$);\n", "#1000= IFCRIGHTCIRCULARCYLINDER(#1001,1.,1.E400);\n",
        // The lines of the profile cross.
        "#1000= IFCEXTRUDEDAREASOLID(#1003,$,#1004,1.);\n#1004= IFCDIRECTION((0.,0.,1.));\n"
        "#1003= IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#1005);\n"
        "#1005= IFCPOLYLINE((#1006,#1007,#1008,#1009));\n#1006= IFCCARTESIANPOINT((0.,0.));\n"
        "#1007= IFCCARTESIANPOINT((1.,1.));\n#1008= IFCCARTESIANPOINT((1.,0.));\n"
        "#1009= IFCCARTESIANPOINT((0.,1.));\n",
        // A disk along no way, and back on its way.
        "#1000= IFCSWEPTDISKSOLID(#1003,1.,$,$,$);\n#1003= IFCPOLYLINE((#1002,#1002));\n",
        "#1000= IFCSWEPTDISKSOLID(#1003,1.,$,$,$);\n#1003= IFCPOLYLINE((#1002,#1004,#1002));\n"
        "#1004= IFCCARTESIANPOINT((1.,0.,0.));\n"}) {
    const auto bodies = bodies_of(item);
    ASSERT_EQ(bodies.size(), 1U) << item;
    EXPECT_FALSE(bodies[0]) << item;
  }
}

}  // namespace
}  // namespace rubicon::ifc
