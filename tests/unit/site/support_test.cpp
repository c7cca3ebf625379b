#include "src/simulation/site/support.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/simulation/site/beginning.hpp"
#include "src/simulation/site/make_site.hpp"

namespace rubicon::site {
namespace {

using interpreter::ComponentSpec;
using interpreter::Fixing;
using interpreter::PlanModel;
using interpreter::SupportRules;
using interpreter::ThingRef;
using math::translation;
using math::Vec3;
using ::testing::HasSubstr;

ThingRef component_ref(int index) { return {ThingRef::Kind::component, index}; }

class SupportTest : public ::testing::Test {
 protected:
  SupportTest() { plan_.support.mode = SupportRules::Mode::on; }

  void ground() {
    plan_.site.emplace_back();
    plan_.site.back().solid = geometry::Box{{-50, -50, -1}, {50, 50, 0}};
  }
  int add(const std::string& name, std::vector<geometry::Shape> shapes,
          const math::Pose& X_WO = math::Pose::Identity()) {
    ComponentSpec component;
    component.name = name;
    component.X_WO = X_WO;
    component.shapes = std::move(shapes);
    plan_.components.push_back(std::move(component));
    return static_cast<int>(plan_.components.size()) - 1;
  }
  int add_box(const std::string& name, const Vec3& lower, const Vec3& upper) {
    return add(name, {{geometry::Box{lower, upper}}});
  }
  ComponentSpec& spec(int index) { return plan_.components[static_cast<std::size_t>(index)]; }
  /// Why a component does not stand where it is; "" if it does.
  std::string why_not(int component) {
    const SiteWorld site = make_site(plan_);
    Support support(plan_, site, prepare_site(plan_).surfaces);
    support.find_floating();
    return support.why_not(component, spec(component).X_WO).value_or("");
  }

  PlanModel plan_;
};

TEST_F(SupportTest, ABoxStandsOnTheGroundWithAndWithoutASite) {
  const int box = add_box("box", {0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(why_not(box), "");
  ground();
  EXPECT_EQ(why_not(box), "");
  const int high = add_box("high", {5, 0, 0.12}, {6, 1, 1});
  EXPECT_EQ(why_not(high), "the nearest below is site, 120 mm lower");
  plan_.site.clear();
  EXPECT_EQ(why_not(high), "the nearest below is the ground (z = 0), 120 mm lower");
  const int low = add_box("low", {8, 0, -0.5}, {9, 1, 1});
  EXPECT_EQ(why_not(low), "it reaches 500 mm below the ground (z = 0, as the plan has no site)");
}

TEST_F(SupportTest, GapsUpToThatOfThePlanCarry) {
  ground();
  add_box("slab", {0, 0, 0}, {2, 2, 0.2});
  const int nine = add_box("nine", {0, 0, 0.209}, {1, 1, 1});
  const int ten = add_box("ten", {1, 0, 0.21}, {2, 1, 1});
  const int eleven = add_box("eleven", {0, 1, 0.211}, {1, 2, 1});
  EXPECT_EQ(why_not(nine), "");
  EXPECT_EQ(why_not(ten), "");
  EXPECT_EQ(why_not(eleven), "the nearest below is slab, 11 mm lower");
  plan_.support.gap = 0.02;
  EXPECT_EQ(why_not(eleven), "");
}

TEST_F(SupportTest, TheCentreOfMassIsOverWhatCarries) {
  ground();
  add_box("beam", {0, 0, 0}, {0.2, 4, 1});
  add_box("other", {2, 0, 0}, {2.2, 4, 1});
  // Between two beams, on one, on the edge of one, beside it.
  const int between = add_box("between", {0, 1, 1}, {2.2, 2, 1.2});
  const int middle = add_box("middle", {-0.5, 2, 1}, {0.7, 3, 1.2});
  const int edge = add_box("edge", {-0.8, 3, 1}, {0.8, 3.4, 1.2});
  const int outside = add_box("outside", {0.1, 3.5, 1}, {1.1, 4, 1.2});
  EXPECT_EQ(why_not(between), "");
  EXPECT_EQ(why_not(middle), "");
  EXPECT_EQ(why_not(edge), "its centre of mass is on the edge of what carries it, beam");
  EXPECT_EQ(why_not(outside), "its centre of mass is 400 mm outside of what carries it, beam");
}

// Rounding decided it: at 0, 5, 7, 20 and 30 m it stood, at the others not.
TEST_F(SupportTest, TheMarginIsTheSameWhereverThePlanLies) {
  ground();
  for (const double x : {0.0, 1.0, 2.0, 3.0, 5.0, 7.0, 10.0, 20.0, 30.0}) {
    plan_.components.clear();
    add("base", {{geometry::Box{{-0.5, -0.5, 0}, {0.5, 0.5, 1}}}}, translation(x, 0, 0));
    const auto said = [&](double shift) {
      plan_.components.resize(1);
      return why_not(add("slab", {{geometry::Box{{-0.5, -0.5, 0}, {0.5, 0.5, 0.2}}}},
                         translation(x + shift, 0, 1)));
    };
    const std::string edge = " of what carries it, base";
    EXPECT_EQ(said(0.499), "") << x;
    EXPECT_EQ(said(0.4991), "its centre of mass is only 0.9 mm inside" + edge) << x;
    EXPECT_EQ(said(0.49902), "its centre of mass is only 0.98 mm inside" + edge) << x;
    EXPECT_EQ(said(0.5), "its centre of mass is on the edge" + edge) << x;
    EXPECT_EQ(said(0.501), "its centre of mass is 1.0 mm outside" + edge) << x;
  }
}

TEST_F(SupportTest, ACantileverStandsAsFarAsItsMassIsOverItsWall) {
  ground();
  add_box("wall", {0, 0, 0}, {1, 1, 2});
  // Of two shapes, the heavy one inside.
  const int stands = add(
      "stands", {{geometry::Box{{0, 0, 2}, {1, 1, 3}}}, {geometry::Box{{1, 0, 2.8}, {4, 1, 3}}}});
  EXPECT_NE(why_not(stands), "");  // 1 m3 at 0.5, 0.6 m3 at 2.5: 1.25
  spec(stands).shapes[1] = {geometry::Box{{1, 0, 2.8}, {2, 1, 3}}};
  EXPECT_EQ(why_not(stands), "");
}

TEST_F(SupportTest, WhatIsBesideOrAroundDoesNotCarry) {
  ground();
  add_box("wall", {0, 0, 0}, {0.2, 4, 3});
  const int beside = add_box("beside", {0.1995, 0, 1}, {1, 1, 1.2});
  EXPECT_EQ(why_not(beside), "the nearest below is site, 1000 mm lower");
  const int inside = add_box("inside", {0.05, 1, 1}, {0.15, 2, 1.2});
  EXPECT_THAT(why_not(inside), HasSubstr("the nearest below is"));
  // Exactly into an opening: it falls through.
  add_box("left", {5, 0, 0}, {6, 4, 1});
  add_box("right", {8, 0, 0}, {9, 4, 1});
  const int lid = add_box("lid", {6, 0, 1}, {8, 4, 1.2});
  EXPECT_THAT(why_not(lid), HasSubstr("the nearest below is site"));
  spec(lid).X_WO = translation(0.0005, 0, 0);
  EXPECT_THAT(why_not(lid), HasSubstr("the nearest below is"));
}

TEST_F(SupportTest, WhatIsFixedTouchesAndWhatIsBracedRests) {
  ground();
  const int wall = add_box("wall", {0, 0, 0}, {0.2, 4, 3});
  const int shelf = add_box("shelf", {0.205, 0, 1}, {1, 1, 1.2});
  const int panel = add_box("panel", {2, 0, 0}, {2.2, 4, 3});
  EXPECT_NE(why_not(shelf), "");
  spec(shelf).braced_by = {component_ref(wall)};
  EXPECT_NE(why_not(shelf), "");
  spec(shelf).braced_by.clear();
  spec(shelf).fixed_to = {Fixing{component_ref(panel)}};
  EXPECT_NE(why_not(shelf), "");
  spec(shelf).fixed_to = {Fixing{component_ref(wall)}};
  EXPECT_EQ(why_not(shelf), "");
  spec(shelf).fixed_to = {Fixing{{ThingRef::Kind::site, -1}}};
  EXPECT_NE(why_not(shelf), "");

  // Its foot is under its side: it turns over unless somebody holds it.
  const int bracket = add("bracket", {{geometry::Box{{10, 0, 0}, {10.2, 1, 2}}},
                                      {geometry::Box{{10.2, 0, 1.5}, {14, 1, 2}}}});
  EXPECT_THAT(why_not(bracket), HasSubstr("outside of what carries it, site"));
  spec(bracket).braced_by = {{ThingRef::Kind::crew, 0}};
  EXPECT_EQ(why_not(bracket), "");
}

TEST_F(SupportTest, WhatIsFixedAfterATaskHangsOnlyThen) {
  ground();
  const int wall = add_box("wall", {0, 0, 0}, {0.2, 4, 3});
  const int shelf = add_box("shelf", {0.2, 0, 1.5}, {1, 4, 1.6});
  plan_.tasks.emplace_back().name = "bolt";
  spec(shelf).fixed_to = {Fixing{component_ref(wall), 0}};
  SiteWorld site = make_site(plan_);
  Support support(plan_, site, prepare_site(plan_).surfaces);
  bool is_bolted = false;
  support.set_done([&](int task) { return task == 0 && is_bolted; });
  const math::Pose X_WO = site.X_WO(shelf);
  EXPECT_THAT(support.why_not(shelf, X_WO).value_or(""),
              HasSubstr("; it is fixed to wall only after bolt"));
  is_bolted = true;
  EXPECT_FALSE(support.why_not(shelf, X_WO));
  EXPECT_THAT(support.left_without(wall), ::testing::ElementsAre(shelf));
}

TEST_F(SupportTest, WhatOthersStandOnCannotBeTakenAway) {
  ground();
  const int left = add_box("left", {0, 0, 0}, {0.2, 4, 1});
  const int right = add_box("right", {2, 0, 0}, {2.2, 4, 1});
  const int middle = add_box("middle", {1.2, 0, 0}, {1.4, 4, 1});
  const int slab = add_box("slab", {0, 0, 1}, {2.2, 4, 1.2});
  const int lamp = add_box("lamp", {1, 1, 0.5}, {1.1, 1.1, 1});
  spec(lamp).fixed_to = {Fixing{component_ref(slab)}};
  SiteWorld site = make_site(plan_);
  Support support(plan_, site, prepare_site(plan_).surfaces);
  EXPECT_TRUE(support.find_floating().empty());
  EXPECT_THAT(support.left_without(left), ::testing::ElementsAre(slab));
  EXPECT_THAT(support.left_without(middle), ::testing::IsEmpty());
  EXPECT_THAT(support.left_without(slab), ::testing::ElementsAre(lamp));
  site.remove(lamp);
  site.remove(right);
  EXPECT_THAT(support.left_without(slab), ::testing::IsEmpty());
  EXPECT_THAT(support.left_without(middle), ::testing::ElementsAre(slab));
}

TEST_F(SupportTest, PartsThatHoldOnlyEachOtherFall) {
  ground();
  const int post = add_box("post", {0, 0, 0}, {2, 1, 3});
  const int prop = add_box("prop", {3, 0, 0}, {3.2, 1, 3});
  const int left = add_box("left", {0, 0, 3}, {1, 1, 3.5});
  const int right = add_box("right", {1, 0, 3}, {3.2, 1, 3.5});
  const int load = add_box("load", {0.5, 0, 3.5}, {1.5, 1, 4});
  spec(left).fixed_to = {Fixing{component_ref(right)}};
  spec(right).fixed_to = {Fixing{component_ref(left)}};
  SiteWorld site = make_site(plan_);
  Support support(plan_, site, prepare_site(plan_).surfaces);
  EXPECT_TRUE(support.find_floating().empty());
  // While the prop carries one of them, that one carries the other; then the post must.
  EXPECT_THAT(support.left_without(prop), ::testing::IsEmpty());
  site.remove(prop);
  EXPECT_THAT(support.left_without(post), ::testing::ElementsAre(left, right));
  EXPECT_THAT(support.left_without(load), ::testing::IsEmpty());
  // One of them fixed to a wall is enough.
  spec(right).fixed_to.push_back(Fixing{component_ref(add_box("wall", {3.2, 0, 0}, {4, 1, 4}))});
  SiteWorld walled = make_site(plan_);
  Support held(plan_, walled, prepare_site(plan_).surfaces);
  EXPECT_TRUE(held.find_floating().empty());
  EXPECT_THAT(held.left_without(post), ::testing::IsEmpty());
}

TEST_F(SupportTest, TheBeginningTellsWhatDoesNotStandAndWhatRestsOnThat) {
  ground();
  add_box("stands", {0, 0, 0}, {1, 1, 1});
  const int lid = add_box("lid", {5, 0, 2}, {6, 1, 2.2});
  const int on_lid = add_box("on_lid", {5, 0, 2.2}, {6, 1, 3});
  // Each says that the other holds it.
  const int one = add_box("one", {10, 0, 2}, {11, 1, 3});
  const int two = add_box("two", {11, 0, 2}, {12, 1, 3});
  spec(one).fixed_to = {Fixing{component_ref(two)}};
  spec(two).fixed_to = {Fixing{component_ref(one)}};
  const auto floating = look_at_beginning(plan_).floating;
  ASSERT_EQ(floating.size(), 4u);
  EXPECT_EQ(floating[0].first, lid);
  EXPECT_EQ(floating[0].second, "the nearest below is site, 2000 mm lower");
  EXPECT_EQ(floating[1].first, on_lid);
  EXPECT_EQ(floating[1].second, "it rests on lid, which does not stand");
  EXPECT_EQ(floating[2].first, one);
  EXPECT_EQ(floating[3].first, two);
  const auto told = warnings_of(plan_, look_at_beginning(plan_));
  ASSERT_EQ(told.size(), 4u);
  EXPECT_EQ(told[0].code, "P45");
  EXPECT_EQ(told[0].message,
            "at the beginning lid does not stand: the nearest below is site, 2000 mm lower");
  plan_.support.mode = SupportRules::Mode::warn;
  EXPECT_EQ(look_at_beginning(plan_).floating.at(0).first, lid);
  plan_.support.mode = SupportRules::Mode::off;
  EXPECT_TRUE(look_at_beginning(plan_).floating.empty());
}

TEST_F(SupportTest, RoundThingsStandWhereTheyTouch) {
  ground();
  const int drum = add("drum", {{geometry::Cylinder{0.6, 0, 1.4}}});
  const int pipe = add("pipe", {{geometry::Cylinder{0.3, -2, 2}}},
                       translation(5, 0, 0.3) * math::rotation_x_deg(90));
  const int ball = add("ball", {{geometry::Sphere{{0, 0, 0.5}, 0.5}}}, translation(10, 0, 0));
  const int rod =
      add("rod", {{geometry::Capsule{{0, 0, 0.2}, {3, 0, 0.2}, 0.2}}}, translation(12, 0, 0));
  EXPECT_EQ(why_not(drum), "");
  EXPECT_EQ(why_not(pipe), "");
  EXPECT_EQ(why_not(ball), "");
  EXPECT_EQ(why_not(rod), "");
  spec(ball).X_WO = translation(10, 0, 0.02);
  EXPECT_EQ(why_not(ball), "the nearest below is site, 20 mm lower");
  // A ball beside the top of a drum touches its edge only.
  const int off = add("off", {{geometry::Sphere{{0, 0, 0.5}, 0.5}}}, translation(0.9, 0, 1.1));
  EXPECT_NE(why_not(off), "");
}

TEST_F(SupportTest, TiltedThingsRestOnWhatIsNearThem) {
  ground();
  const int tilted =
      add("tilted", {{geometry::Box{{0, 0, 0}, {1, 1, 1}}}}, math::rotation_y_deg(-10));
  EXPECT_THAT(why_not(tilted), HasSubstr("outside of what carries it"));
  spec(tilted).X_WO = math::rotation_y_deg(-0.5);
  EXPECT_EQ(why_not(tilted), "");
}

TEST_F(SupportTest, PrismsWithNotchesRestOnTheirLegs) {
  ground();
  // A portal: two legs and a lintel, a concave prism that lies, and one that stands.
  geometry::Prism portal;
  portal.z1 = 1;
  portal.polygon = {{0, 0}, {1, 0}, {1, 3}, {4, 3}, {4, 0}, {5, 0}, {5, 4}, {0, 4}};
  const int stands = add("stands", {{portal, math::rotation_x_deg(90)}});
  EXPECT_EQ(why_not(stands), "");
  // Half of it turns over.
  portal.polygon = {{0, 0}, {1, 0}, {1, 3}, {6, 3}, {6, 4}, {0, 4}};
  spec(stands).shapes = {{portal, math::rotation_x_deg(90)}};
  EXPECT_THAT(why_not(stands), HasSubstr("outside of what carries it"));
}

/// An L-shaped solid over (0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2), from 0 to 1.
geometry::Mesh l_mesh(bool closed) {
  auto mesh = std::make_shared<geometry::TriangleMesh>();
  for (const double z : {0.0, 1.0}) {
    for (const auto& [x, y] : {std::pair(0, 0), {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}) {
      mesh->vertices.emplace_back(x, y, z);
    }
  }
  for (const auto& t :
       std::vector<std::array<int, 3>>{{0, 1, 3}, {1, 2, 3}, {0, 3, 5}, {3, 4, 5}}) {
    mesh->triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
    mesh->triangles.push_back({t[0], t[2], t[1]});
  }
  for (int i = 0; i < 6; ++i) {
    const int k = (i + 1) % 6;
    mesh->triangles.push_back({i, k, k + 6});
    mesh->triangles.push_back({i, k + 6, i + 6});
  }
  mesh->closed = closed;
  return {"l.stl", mesh};
}

TEST_F(SupportTest, MeshesRestAndCarryWithTheirTriangles) {
  ground();
  for (const bool closed : {true, false}) {
    plan_.components.clear();
    const int corner = add("corner", {{l_mesh(closed)}});
    EXPECT_EQ(why_not(corner), "");
    const int on_corner = add_box("on_corner", {0.2, 0.2, 1}, {1.2, 0.8, 2});
    const int in_notch = add_box("in_notch", {1.1, 1.1, 1}, {1.9, 1.9, 2});
    EXPECT_EQ(why_not(on_corner), "");
    EXPECT_EQ(why_not(in_notch), "the nearest below is site, 1000 mm lower");
    spec(corner).X_WO = translation(0, 0, 0.011);
    EXPECT_EQ(why_not(corner), "the nearest below is site, 11 mm lower");
    // Hanging under a closed ceiling is not standing on it.
    if (!closed) continue;
    spec(corner).X_WO = translation(0, 0, 3);
    const int hangs = add_box("hangs", {0.2, 0.2, 2.5}, {0.8, 0.8, 3});
    EXPECT_EQ(why_not(hangs), "the nearest below is on_corner, 500 mm lower");
  }
}

// Nothing is 1 mm inside of a rail that is narrower than 2 mm: of two rails something is.
TEST_F(SupportTest, InTheBalanceOfForcesSomethingMustBeTheMarginInside) {
  ground();
  plan_.support.equilibrium = true;
  const ThingRef site{ThingRef::Kind::site, -1};
  spec(add_box("rail", {0, 0, 0}, {0.0018, 4, 1})).fixed_to = {Fixing{site}};
  const int plank = add_box("plank", {-0.5, 1, 1}, {0.5018, 2, 1.2});
  spec(plank).mass = 100;
  EXPECT_EQ(why_not(plank), "it rests on less than 2 mm of rail");
  spec(plank).braced_by = {{ThingRef::Kind::crew, 0}};
  EXPECT_EQ(why_not(plank), "");
  spec(plank).braced_by.clear();
  spec(add_box("other", {0.4, 0, 0}, {0.4018, 4, 1})).fixed_to = {Fixing{site}};
  EXPECT_EQ(why_not(plank), "");
}

}  // namespace
}  // namespace rubicon::site
