#include <gtest/gtest.h>

#include "src/exchange/ifc/chords.hpp"
#include "src/exchange/ifc/ifc_curve.hpp"
#include "src/motion/math/angles.hpp"

namespace rubicon::ifc {
namespace {

std::optional<PointLine> curve(const std::string& points, const std::string& segments) {
  const std::string text = "ISO-10303-21;HEADER;ENDSEC;DATA;#1=IFCCARTESIANPOINTLIST2D((" + points +
                           "));#2=IFCINDEXEDPOLYCURVE(#1," + segments +
                           ",.F.);ENDSEC;END-ISO-10303-21;";
  const auto file = StepFile::read(text);
  const auto& step = std::get<StepFile>(file);
  return indexed_curve(step, *step.find(2), 1);
}

TEST(IndexedCurve, WithoutSegmentsAllPointsAreTaken) {
  const auto line = curve("(0.,0.),(1.,0.),(1.,2.)", "$");
  ASSERT_TRUE(line);
  EXPECT_TRUE(line->flat);
  EXPECT_EQ(line->points.size(), 3U);
}

TEST(IndexedCurve, AnArcStaysOnItsCircleAndTurnsALittleAtATime) {
  // Three quarters of the circle about (1, 2) with radius 5.
  const auto line = curve("(6.,2.),(-4.,2.),(1.,-3.)", "(IFCARCINDEX((1,2,3)))");
  ASSERT_TRUE(line);
  const math::Vec3 centre(1, 2, 0);
  double turned = 0;
  for (std::size_t i = 0; i < line->points.size(); ++i) {
    const math::Vec3 r = line->points[i] - centre;
    EXPECT_NEAR(r.norm(), 5, 1e-12);
    if (i == 0) continue;
    const math::Vec3 before = line->points[i - 1] - centre;
    const double step = math::atan2_deg(before.cross(r).z(), before.dot(r));
    EXPECT_GT(step, 0);
    EXPECT_LE(step, kChordTurnDeg + 1e-9);
    turned += step;
  }
  EXPECT_NEAR(turned, 270, 1e-9);
  EXPECT_EQ(line->points.back(), math::Vec3(1, -3, 0));
}

TEST(IndexedCurve, AnArcOfThreePointsOnALineIsThatLine) {
  const auto line = curve("(0.,0.),(1.,0.),(2.,0.)", "(IFCARCINDEX((1,2,3)))");
  ASSERT_TRUE(line);
  EXPECT_EQ(line->points.size(), 3U);
}

TEST(IndexedCurve, WhatIsNotThereMakesNoCurve) {
  EXPECT_FALSE(curve("(0.,0.),(1.,0.)", "(IFCLINEINDEX((1,3)))"));
  EXPECT_FALSE(curve("(0.,0.),(1.,0.)", "(IFCLINEINDEX((0,1)))"));
  EXPECT_FALSE(curve("(0.,0.),(1.,0.)", "(IFCLINEINDEX((1)))"));
  EXPECT_FALSE(curve("(0.,0.),(1.,0.)", "(IFCARCINDEX((1,2)))"));
  EXPECT_FALSE(curve("(0.,0.),(1.,$)", "$"));
  EXPECT_FALSE(curve("(0.,0.,0.)", "$"));
  EXPECT_FALSE(curve("", "$"));
}

}  // namespace
}  // namespace rubicon::ifc
