#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "src/exchange/ifc/element_bodies.hpp"
#include "src/exchange/ifc/ifc_model.hpp"
#include "src/exchange/ifc/plain_ifc.hpp"
#include "src/exchange/ifc/step_file.hpp"
#include "tests/support/growth.hpp"
#include "tests/support/ifc_sample.hpp"

// Nothing a file says may crash, hang or swell the reader. What it makes of nonsense does not
// matter.

namespace rubicon::ifc {
namespace {

using ::rubicon::testing::ifc_text;
using ::rubicon::testing::IfcSample;

/// Everything there is, with whatever the text is.
void read_all(const std::string& text) {
  const auto file = StepFile::read(text);
  const auto* step = std::get_if<StepFile>(&file);
  if (step == nullptr) return;
  const auto model = read_model(*step);
  if (const auto* building = std::get_if<IfcModel>(&model)) {
    plain_ifc(*step, *building);
    WorkBudget budget = shape_budget(*step);
    element_bodies(*step, *building, budget);
  }
}

std::vector<std::string> samples() {
  std::vector<std::string> texts;
  for (const char* shape :
       {"extrusion", "brep", "triangles", "polygons", "indexed curve", "mapped"}) {
    IfcSample sample;
    sample.schema = "IFC4";
    sample.shape = shape;
    texts.push_back(ifc_text(sample));
  }
  return texts;
}

TEST(HostileIfc, SmokeOfDamagedBytes) {
  std::mt19937 random(7);
  for (const std::string& whole : samples()) {
    for (int round = 0; round < 2000; ++round) {
      std::string text = whole;
      for (unsigned k = 0; k <= random() % 4; ++k) {
        const std::size_t at = random() % text.size();
        switch (random() % 4) {
          case 0:
            text[at] = static_cast<char>(random());
            break;
          case 1:
            text[at] = "#$*'(),.;0123456789"[random() % 19];
            break;
          case 2:
            text.erase(at, random() % 20);
            break;
          default:
            text.insert(at, text.substr(random() % text.size(), random() % 40));
            break;
        }
        if (text.empty()) break;
      }
      read_all(text);
    }
  }
}

TEST(HostileIfc, SmokeOfReferencesLedAstray) {
  std::mt19937 random(8);
  for (const std::string& whole : samples()) {
    for (int round = 0; round < 2000; ++round) {
      std::string text = whole;
      // Some references point at other records: rings, wrong classes, nothing there.
      for (int k = 0; k < 3; ++k) {
        const std::size_t at = text.find('#', random() % text.size());
        if (at == std::string::npos || at + 3 > text.size()) continue;
        const std::size_t end = text.find_first_not_of("0123456789", at + 1);
        text.replace(at + 1, end - at - 1, std::to_string(1 + random() % 110));
      }
      read_all(text);
    }
  }
}

/// Seconds of processor time that reading takes.
double seconds_for(const std::string& text) {
  return test::processor_seconds([&] { read_all(text); });
}

/// Seconds. What these texts are made to provoke takes hours or never ends; what reading takes may
/// be ninety times as long under sanitizers.
constexpr double kSoon = 60;

/// Twice the size may take this much longer: 2 where time grows with size, 4 where it grows with
/// its square, and what a busy machine adds.
constexpr double kGrowth = 3.2;

void expect_linear(const std::function<std::string(int)>& make, int count) {
  double ratio = 0;
  for (int attempt = 0; attempt < 5; ++attempt) {
    const double once = seconds_for(make(count));
    const double twice = seconds_for(make(2 * count));
    ratio = twice / once;
    if (ratio < kGrowth) return;
  }
  FAIL() << "twice the size takes " << ratio << " times as long";
}

std::string with(const std::string& more) {
  IfcSample sample;
  sample.schema = "IFC4";
  sample.more = more;
  return ifc_text(sample);
}

TEST(HostileIfc, ManyElementsTakeTimeInProportion) {
  expect_linear(
      [](int count) {
        IfcSample sample;
        sample.blocks.assign(static_cast<std::size_t>(count), {});
        return ifc_text(sample);
      },
      2000);
}

TEST(HostileIfc, ALongChainOfPlacementsTakesTimeInProportion) {
  expect_linear(
      [](int count) {
        std::string more =
            "#100000= IFCAXIS2PLACEMENT3D(#100001,$,$);\n"
            "#100001= IFCCARTESIANPOINT((0.,0.,0.));\n";
        for (int i = 0; i < count; ++i) {
          const int id = 200000 + 3 * i;
          more += "#" + std::to_string(id) + "= IFCLOCALPLACEMENT(" +
                  (i == 0 ? "$" : "#" + std::to_string(id - 3)) + ",#100000);\n#" +
                  std::to_string(id + 1) + "= IFCWALL('x',$,$,$,$,#" + std::to_string(id) + ",#" +
                  std::to_string(id + 2) + ",$,$);\n#" + std::to_string(id + 2) +
                  "= IFCPRODUCTDEFINITIONSHAPE($,$,());\n";
        }
        return with(more);
      },
      20000);
}

TEST(HostileIfc, ALongChainOfPartsIsCut) {
  std::string more;
  constexpr int kParts = 20000;
  for (int i = 0; i < kParts; ++i) {
    const int id = 200000 + 3 * i;
    more += "#" + std::to_string(id) + "= IFCWALL('x',$,$,$,$,$,#" + std::to_string(id + 1) +
            ",$,$);\n#" + std::to_string(id + 1) + "= IFCPRODUCTDEFINITIONSHAPE($,$,());\n#" +
            std::to_string(id + 2) + "= IFCRELAGGREGATES('r',$,$,$,#" + std::to_string(id + 3) +
            ",(#" + std::to_string(id) + "));\n";
  }
  EXPECT_LT(seconds_for(with(more)), kSoon);
}

TEST(HostileIfc, DeepBooleansAndHugeListsDoNotOverflow) {
  std::string deep;
  for (int i = 0; i < 200000; ++i) {
    deep += "#" + std::to_string(1000 + i) + "= IFCBOOLEANRESULT(.UNION.,#" +
            std::to_string(1001 + i) + ",#" + std::to_string(1001 + i) + ");\n";
  }
  deep +=
      "#500000= IFCWALL('x',$,$,$,$,$,#500001,$,$);\n"
      "#500001= IFCPRODUCTDEFINITIONSHAPE($,$,(#500002));\n"
      "#500002= IFCSHAPEREPRESENTATION($,'Body','CSG',(#1000));\n";
  EXPECT_LT(seconds_for(with(deep)), kSoon);
  std::string list =
      "#1000= IFCTRIANGULATEDFACESET(#1001,$,.T.,((1,2,999999999999)),$);\n"
      "#1001= IFCCARTESIANPOINTLIST3D((";
  for (int i = 0; i < 300000; ++i) list += (i == 0 ? "(0.,0.,0.)" : ",(0.,0.,0.)");
  list +=
      "));\n#500000= IFCWALL('x',$,$,$,$,$,#500001,$,$);\n"
      "#500001= IFCPRODUCTDEFINITIONSHAPE($,$,(#500002));\n"
      "#500002= IFCSHAPEREPRESENTATION($,'Body','Tessellation',(#1000));\n";
  EXPECT_LT(seconds_for(with(list)), kSoon);
}

/// A wall whose shape is item #1000.
std::string wall_of(const std::string& items) {
  return with(items +
              "#500000= IFCWALL('x',$,$,$,$,$,#500001,$,$);\n"
              "#500001= IFCPRODUCTDEFINITIONSHAPE($,$,(#500002));\n"
              "#500002= IFCSHAPEREPRESENTATION($,'Body','x',(#1000));\n");
}

std::string numbered(int id, const std::string& record) {
  return "#" + std::to_string(id) + "= " + record + ";\n";
}

TEST(HostileIfc, ShapesThatLeadInRingsOrBranchWithoutEndAreGivenUp) {
  // A union of itself with itself, twice as often at each level.
  std::string doubling;
  for (int i = 0; i < 60; ++i) {
    const std::string next = "#" + std::to_string(1001 + i);
    doubling += numbered(1000 + i, "IFCBOOLEANRESULT(.UNION.," + next + "," + next + ")");
  }
  doubling += numbered(1060, "IFCBLOCK(#1061,1.,1.,1.)") +
              numbered(1061, "IFCAXIS2PLACEMENT3D(#1062,$,$)") +
              numbered(1062, "IFCCARTESIANPOINT((0.,0.,0.))");
  EXPECT_LT(seconds_for(wall_of(doubling)), kSoon);
  EXPECT_LT(seconds_for(wall_of(numbered(1000, "IFCBOOLEANRESULT(.UNION.,#1000,#1000)"))), kSoon);
  EXPECT_LT(seconds_for(wall_of(numbered(1000, "IFCCSGSOLID(#1000)"))), kSoon);
  EXPECT_LT(seconds_for(wall_of(numbered(1000, "IFCSWEPTDISKSOLID(#1001,1.,$,$,$)") +
                                numbered(1001, "IFCCOMPOSITECURVE((#1002,#1002),.F.)") +
                                numbered(1002, "IFCCOMPOSITECURVESEGMENT(.C.,.T.,#1001)"))),
            kSoon);
  EXPECT_LT(seconds_for(wall_of(
                numbered(1000, "IFCEXTRUDEDAREASOLID(#1001,$,#1003,1.)") +
                numbered(1001, "IFCCOMPOSITEPROFILEDEF(.AREA.,$,(#1001,#1001,#1001,#1001),$)") +
                numbered(1003, "IFCDIRECTION((0.,0.,1.))"))),
            kSoon);
}

/// An extrusion of a profile with many corners, none of which is an ear for long.
TEST(HostileIfc, LargeProfilesAreBounded) {
  std::string points;
  std::string list;
  constexpr int kCorners = 40000;
  for (int i = 0; i < kCorners; ++i) {
    const double r = i % 2 == 0 ? 1000 : 999;
    const double t = 6.28318530717958 * i / kCorners;
    points += numbered(10000 + i, "IFCCARTESIANPOINT((" + std::to_string(r * std::cos(t)) + "," +
                                      std::to_string(r * std::sin(t)) + "))");
    list += (i == 0 ? "#" : ",#") + std::to_string(10000 + i);
  }
  EXPECT_LT(seconds_for(wall_of(points + numbered(1001, "IFCPOLYLINE((" + list + "))") +
                                numbered(1002, "IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#1001)") +
                                numbered(1003, "IFCDIRECTION((0.,0.,1.))") +
                                numbered(1000, "IFCEXTRUDEDAREASOLID(#1002,$,#1003,1.)"))),
            kSoon);
}

}  // namespace
}  // namespace rubicon::ifc
