#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/urdf/machine_support.hpp"

namespace rubicon::urdf::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kTwoLinks = R"(<link name="base"/><link name="arm"/>)";

std::string arm_joint(const std::string& type, const std::string& inside,
                      const std::string& name = "j") {
  return "<joint name=\"" + name + "\" type=\"" + type +
         "\"><parent link=\"base\"/><child link=\"arm\"/>" + inside + "</joint>";
}

TEST(Machine, JointsBecomeParametersInTheUnitsOfTheLanguage) {
  const std::string robot =
      robot_of(kTwoLinks +
               arm_joint("revolute",
                         R"(<origin xyz="0 0 1.5" rpy="0 0 1.5707963267948966"/><axis xyz="0 -1 0"/>
                           <limit lower="-0.5235987755982988" upper="1.0471975511965976" velocity="0.1"/>)"));
  EXPECT_THAT(robot,
              HasSubstr("param phi range(-30, 60) step(5) speed(5.72957795 deg/s);  # joint j"));
  EXPECT_THAT(robot, HasSubstr("frame trans(0, 0, 1.5) * rotz(90) * roty(-phi);"));
  EXPECT_THAT(robot, HasSubstr("tool arm;"));
  EXPECT_THAT(robot, HasSubstr("behaviour { chain { follow }; }"));
  EXPECT_TRUE(checked(robot)->usable);
}

TEST(Machine, PrismaticAndContinuousJoints) {
  const std::string slide =
      robot_of(kTwoLinks +
               arm_joint("prismatic",
                         R"(<axis xyz="1 0 0"/><limit lower="0" upper="0.25" velocity="0.5"/>)"));
  EXPECT_THAT(slide, HasSubstr("param x range(0, 0.25) step(0.02) speed(0.5 m/s);"));
  EXPECT_THAT(slide, HasSubstr("frame trans(x, 0, 0);"));
  const std::string wheel = robot_of(kTwoLinks + arm_joint("continuous", R"(<axis xyz="0 0 1"/>)"));
  EXPECT_THAT(
      wheel,
      HasSubstr("param theta cyclic step(5) speed(10 deg/s);  # joint j; the speed is assumed"));
  EXPECT_TRUE(checked(slide)->usable);
  EXPECT_TRUE(checked(wheel)->usable);
}

TEST(Machine, TheAxisIsXUnlessItIsSaid) {
  EXPECT_THAT(robot_of(kTwoLinks + arm_joint("continuous", "")), HasSubstr("frame rotx(psi);"));
}

TEST(Machine, ObliqueAxesAreTurnedByFixedFrames) {
  EXPECT_THAT(robot_of(kTwoLinks + arm_joint("continuous", R"(<axis xyz="1 1 0"/>)")),
              HasSubstr("frame rotz(45) * roty(90) * rotz(theta) * roty(-90) * rotz(-45);"));
}

TEST(Machine, FixedLinksArePartOfTheBodyTheyHangOn) {
  const std::string robot = robot_of(R"(
    <link name="base"/>
    <link name="lamp"><collision><origin xyz="0 0 1"/><geometry><sphere radius="0.1"/></geometry></collision></link>
    <joint name="f" type="fixed"><parent link="base"/><child link="lamp"/><origin xyz="2 0 0"/></joint>)");
  EXPECT_THAT(robot, HasSubstr("body base {  # with lamp"));
  EXPECT_THAT(robot, HasSubstr("shape sphere(0, 0, 0, 0.1) at trans(2, 0, 0) * trans(0, 0, 1);"));
  EXPECT_THAT(robot, HasSubstr("tool base at trans(2, 0, 0);"));
  EXPECT_THAT(robot, Not(HasSubstr("behaviour")));
}

TEST(Machine, ShapesOfTheLanguage) {
  const std::string robot = robot_of(R"(<link name="base">
    <collision><geometry><box size="2 4 6"/></geometry></collision>
    <collision><geometry><cylinder radius="0.5" length="3"/></geometry></collision>
    <collision><geometry><capsule radius="0.5" length="3"/></geometry></collision></link>)");
  EXPECT_THAT(robot, HasSubstr("shape box(-1, -2, -3, 1, 2, 3);"));
  EXPECT_THAT(robot, HasSubstr("shape cylinder(0.5, -1.5, 1.5);"));
  EXPECT_THAT(robot, HasSubstr("shape capsule(0, 0, -1.5, 0, 0, 1.5, 0.5);"));
  checked(robot);
}

TEST(Machine, ShapesOfNothingAreLeftOut) {
  const Imported imported = import({R"(<robot name="r"><link name="base">
<collision><geometry><box size="0 0 0"/></geometry></collision>
<collision><geometry><sphere radius="0"/></geometry></collision></link></robot>)"});
  ASSERT_TRUE(imported.machine);
  EXPECT_THAT(imported.machine->robot, Not(HasSubstr("shape")));
  EXPECT_THAT(
      imported.said(),
      HasSubstr("I25 2: this <box> has no volume: the link goes without it (1 more like it)\n"));
}

TEST(Machine, CollisionElseVisualAndBothAreSaid) {
  const Imported imported = import({R"(<robot name="r">
<link name="a"><visual><geometry><box size="1 1 1"/></geometry></visual></link>
<link name="b"><visual><geometry><box size="1 1 1"/></geometry></visual>
  <collision><geometry><sphere radius="1"/></geometry></collision></link>
<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint></robot>)"});
  ASSERT_TRUE(imported.machine);
  EXPECT_THAT(imported.machine->robot, HasSubstr("box("));
  EXPECT_THAT(imported.machine->robot, HasSubstr("sphere("));
  EXPECT_THAT(
      imported.said(),
      HasSubstr("I26 2: link 'a' has no <collision>: its <visual> is taken for its body\n"));
  EXPECT_THAT(imported.said(),
              HasSubstr("I25 3: <visual> is not taken over where a link has a <collision>\n"));
}

TEST(Machine, MimicJointsAreDerivedInTheirUnit) {
  const std::string robot =
      robot_of(R"(<link name="base"/><link name="arm"/><link name="rod"/><link name="twin"/>
    <joint name="j" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>
      <limit lower="0" upper="1" velocity="1"/></joint>
    <joint name="r" type="prismatic"><parent link="base"/><child link="rod"/>
      <mimic joint="j" multiplier="1.8" offset="-0.25"/></joint>
    <joint name="t" type="revolute"><parent link="base"/><child link="twin"/>
      <mimic joint="j" multiplier="-1"/></joint>)");
  EXPECT_THAT(
      robot,
      HasSubstr("param x = 0.031415926535897934 * arm.theta - 0.25;  # joint r, which mimics j"));
  EXPECT_THAT(robot, HasSubstr("param psi = -arm.theta;"));
  EXPECT_TRUE(checked(robot)->usable);
}

TEST(Machine, NoGuideWhereTurnsAreCounted) {
  const Imported imported =
      import({R"(<robot name="r"><link name="base"/><link name="arm"/><link name="rod"/>
<joint name="j" type="continuous"><parent link="base"/><child link="arm"/><limit velocity="1"/></joint>
<joint name="r" type="prismatic"><parent link="base"/><child link="rod"/><mimic joint="j" multiplier="0.1"/></joint></robot>)"});
  ASSERT_TRUE(imported.machine);
  EXPECT_EQ(
      imported.said(),
      "I26 3: this machine gets no guide: joint 'r' mimics 'j', which turns without limits\n");
  EXPECT_THAT(imported.machine->robot, Not(HasSubstr("guide")));
  EXPECT_TRUE(checked(imported.machine->robot)->usable);
}

TEST(Machine, LimitsThatForbidAllMotionAreAWarningAtTheirLine) {
  const Imported imported =
      import({"<robot name=\"r\"><link name=\"base\"/><link name=\"arm\"/>\n" +
              arm_joint("revolute", "\n<limit effort=\"1\" velocity=\"1\"/>") + "</robot>"});
  ASSERT_TRUE(imported.machine);
  EXPECT_THAT(imported.said(),
              HasSubstr("I27 3: the limits of joint 'j' forbid all motion: 0 to 0\n"));
  EXPECT_THAT(imported.machine->robot, HasSubstr("range(0, 0)"));
  EXPECT_TRUE(checked(imported.machine->robot)->usable);
}

TEST(Machine, WhatIsNotTakenOverIsListed) {
  const Imported imported = import({R"(<robot name="r">
<link name="base" flavour="mint"><inertial/></link><link name="arm"><inertial/></link>
<joint name="j" type="continuous"><parent link="base"/><child link="arm"/><dynamics damping="1"/></joint>
<joint name="k" type="floating"><parent link="arm"/><child link="cab"/></joint><link name="cab"/>
<transmission name="t"/><surprise/></robot>)"});
  ASSERT_TRUE(imported.machine);
  const std::string said = imported.said();
  EXPECT_THAT(said, HasSubstr("I25 2: 'flavour' of <link> is not taken over\n"));
  EXPECT_THAT(said, HasSubstr("I25 2: <inertial> is not taken over (masses: in plans, loads have "
                              "them) (1 more like it)\n"));
  EXPECT_THAT(said, HasSubstr("I25 3: <dynamics> is not taken over (friction and damping)\n"));
  EXPECT_THAT(said, HasSubstr("I26 3: joint 'j' has no velocity: 10 deg/s is assumed\n"));
  EXPECT_THAT(said, HasSubstr("I26 4: joint 'k' is floating: it is held fast at its origin\n"));
  EXPECT_THAT(said, HasSubstr("I25 5: <transmission> is not taken over (drives)\n"));
  EXPECT_THAT(said,
              HasSubstr("I25 5: <surprise> of <robot> is not known here and not taken over\n"));
}

TEST(Machine, NamesThatAreNoneAreMended) {
  const Imported imported = import({R"(<robot name="my robot"><link name="1st-link"/>
<link name="1st.link"/><link name="chain"/>
<joint name="j" type="continuous"><parent link="1st-link"/><child link="1st.link"/></joint>
<joint name="k" type="continuous"><parent link="1st-link"/><child link="chain"/></joint></robot>)"});
  ASSERT_TRUE(imported.machine);
  EXPECT_THAT(imported.machine->robot, HasSubstr("robot my_robot {"));
  EXPECT_THAT(imported.machine->robot, HasSubstr("body _1st_link {"));
  EXPECT_THAT(imported.machine->robot, HasSubstr("body _1st_link_2 on _1st_link {"));
  EXPECT_THAT(imported.machine->robot, HasSubstr("body chain_ on _1st_link {"));
  EXPECT_THAT(imported.said(),
              HasSubstr("I28 2: '1st.link' is called _1st_link_2 in the robot file\n"));
  EXPECT_TRUE(checked(imported.machine->robot)->usable);
}

TEST(Machine, TheToolIsTheEndOfTheLongestChainOrTheOneThatIsNamed) {
  const std::string text =
      R"(<robot name="r"><link name="base"/><link name="a"/><link name="b"/><link name="c"/>
<joint name="1" type="continuous"><parent link="base"/><child link="a"/></joint>
<joint name="2" type="continuous"><parent link="base"/><child link="b"/></joint>
<joint name="3" type="fixed"><parent link="b"/><child link="c"/><origin xyz="1 0 0"/></joint></robot>)";
  EXPECT_THAT(import({text}).machine->robot, HasSubstr("tool b at trans(1, 0, 0);"));
  Asked asked{text};
  asked.tool = "a";
  EXPECT_THAT(import(asked).machine->robot, HasSubstr("tool a;"));
  asked.tool = "bsae";
  EXPECT_EQ(error_of(asked), "I24 1: there is no link 'bsae' for --tool; did you mean base?");
}

TEST(Machine, NeighboursOverABodyWithoutShapeMayTouch) {
  const std::string ball = R"(<collision><geometry><sphere radius="1"/></geometry></collision>)";
  const std::string robot =
      robot_of("<link name=\"base\">" + ball + R"(</link><link name="cross"/><link name="arm">)" +
               ball + R"(</link>
<joint name="1" type="continuous"><parent link="base"/><child link="cross"/></joint>
<joint name="2" type="continuous"><parent link="cross"/><child link="arm"/><axis xyz="0 1 0"/></joint>)");
  EXPECT_THAT(robot, HasSubstr("touching base arm;"));
  EXPECT_TRUE(checked(robot)->usable);
}

TEST(Machine, MeshesLieBesideTheRobotFile) {
  Asked asked{R"(<robot name="r"><link name="base">
<collision><geometry><mesh filename="package://p/a/arm.STL" scale="0.001 0.001 0.001"/></geometry></collision>
<collision><geometry><mesh filename="package://p/b/arm.stl" scale="-1 1 1"/></geometry></collision>
<collision><geometry><mesh filename="package://p/b/arm.stl"/></geometry></collision>
<collision><geometry><mesh filename="up.dae"/></geometry></collision>
<collision><geometry><mesh filename="flat.dae"/></geometry></collision>
<collision><geometry><mesh filename="old.max"/></geometry></collision></link></robot>)"};
  asked.files = {{"a/arm.STL", ""},
                 {"b/arm.stl", ""},
                 {"up.dae", "<up_axis>Z_UP</up_axis>"},
                 {"flat.dae", "<up_axis>Y_UP</up_axis>"},
                 {"old.max", ""}};
  const Imported imported = import(asked);
  ASSERT_TRUE(imported.machine) << imported.said();
  const std::string& robot = imported.machine->robot;
  EXPECT_THAT(robot, HasSubstr(R"(shape mesh("machine_meshes/arm.stl", m, scale 0.001);)"));
  EXPECT_THAT(robot, HasSubstr(R"(shape mesh("machine_meshes/arm_scaled.obj", m);)"));
  EXPECT_THAT(robot, HasSubstr(R"(shape mesh("machine_meshes/arm_2.stl", m);)"));
  EXPECT_THAT(robot, HasSubstr(R"(shape mesh("machine_meshes/up.dae");)"));
  EXPECT_THAT(robot, HasSubstr(R"(shape mesh("machine_meshes/flat.dae", up z);)"));
  EXPECT_THAT(imported.said(), HasSubstr("I25 7: expected an STL, DAE, OBJ, PLY or GLB file, found "
                                         "'old.max': the link goes without it\n"));
  ASSERT_EQ(imported.machine->meshes.size(), 5U);
  EXPECT_EQ(imported.machine->meshes[1].scale, (Triple{-1, 1, 1}));
}

}  // namespace
}  // namespace rubicon::urdf::testing
