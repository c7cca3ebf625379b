#include <gtest/gtest.h>

#include "interpreter/parse/parse.hpp"

namespace rubicon {
namespace {

using interpreter::Diagnostics;
using interpreter::FileId;
using interpreter::SourceMap;

constexpr const char* kText =
    "robot robot {\n"
    "  time_step 1 s; sensor 10 m;\n"
    "  const level = 35 deg;\n"
    "  body base {\n"
    "    param θ cyclic step(5 deg) speed(2 rpm) loaded(1 rpm) start(-3) prefer(-1);\n"
    "    rule θ ← θ + θ_s;\n"
    "    frame rotz(θ);\n"
    "    shape cylinder(1, 0, 2) at trans(0, 0, 1) * rotx(90);\n"
    "    shape mesh(\"arm.stl\", mm, scale 2, up y, part \"arm\", hull);\n"
    "  }\n"
    "  body boom on base {\n"
    "    param phi range(-30 deg, 60 deg) step(1);\n"
    "    param psi = level - boom.phi - base.theta;\n"
    "    behaviour { chain { move_to(phi, goal(phi)) }; }\n"
    "  }\n"
    "  tool boom at trans(3, 0, 0);\n"
    "  touching base boom;\n"
    "  capacity (3 m, 4 t), (20, 1000 kg);\n"
    "  behaviour { behaviour up { wait; } up; }\n"
    "  behaviour \"robot.motion\";\n"
    "}\n";

TEST(ParseRobot, EveryItem) {
  SourceMap sources;
  Diagnostics diagnostics;
  const FileId file = sources.add("a.robot", kText);
  const syntax::Robot robot = interpreter::parse_robot(sources, file, diagnostics);
  ASSERT_TRUE(diagnostics.all().empty()) << diagnostics.all()[0].message;
  EXPECT_FALSE(robot.broken);
  EXPECT_EQ(robot.name.text, "robot");
  ASSERT_EQ(robot.items.size(), 10u);

  EXPECT_EQ(std::get<syntax::SettingItem>(robot.items[1]).name.text, "sensor");
  EXPECT_EQ(std::get<syntax::SettingItem>(robot.items[1]).value.value, 10);
  EXPECT_EQ(std::get<syntax::ConstItem>(robot.items[2]).name.text, "level");

  const auto& base = std::get<syntax::BodyItem>(robot.items[3]);
  ASSERT_EQ(base.parameters.size(), 1u);
  EXPECT_EQ(base.parameters[0].name.text, "theta");
  ASSERT_EQ(base.parameters[0].attributes.size(), 6u);
  EXPECT_EQ(base.parameters[0].attributes[0].name.text, "cyclic");
  EXPECT_TRUE(base.parameters[0].attributes[0].numbers.empty());
  EXPECT_EQ(base.parameters[0].attributes[2].numbers[0].value, 12);
  EXPECT_EQ(base.parameters[0].attributes[4].numbers[0].value, -3);
  EXPECT_EQ(sources.text(base.parameters[0].attributes[4].numbers[0].span), "-3");
  ASSERT_EQ(base.rules.size(), 1u);
  EXPECT_EQ(base.rules[0].value->operands[1]->name.text(), "theta_s");
  ASSERT_EQ(base.frames.size(), 1u);
  EXPECT_EQ(base.frames[0].frame.elements[0].kind, syntax::FrameElement::Kind::rotz);
  ASSERT_EQ(base.shapes.size(), 2u);
  EXPECT_EQ(base.shapes[0].shape.numbers.size(), 3u);
  EXPECT_EQ(base.shapes[0].shape.at->elements.size(), 2u);
  const syntax::Shape& mesh = base.shapes[1].shape;
  EXPECT_EQ(mesh.file.text, "arm.stl");
  EXPECT_EQ(mesh.unit->text, "mm");
  EXPECT_EQ(mesh.scale->value, 2);
  EXPECT_EQ(mesh.up->text, "y");
  EXPECT_EQ(mesh.part->text, "arm");
  EXPECT_EQ(mesh.hull->text, "hull");
  EXPECT_FALSE(base.shapes[0].shape.hull);

  const auto& boom = std::get<syntax::BodyItem>(robot.items[4]);
  EXPECT_EQ(boom.on->text, "base");
  EXPECT_EQ(boom.parameters[0].attributes[0].numbers[0].value, -30);
  EXPECT_TRUE(boom.parameters[1].derived);
  EXPECT_EQ(boom.behaviours[0].script.statements.size(), 1u);

  EXPECT_TRUE(std::get<syntax::ToolItem>(robot.items[5]).at);
  EXPECT_EQ(std::get<syntax::TouchingItem>(robot.items[6]).b.text, "boom");
  const auto& capacity = std::get<syntax::CapacityItem>(robot.items[7]);
  ASSERT_EQ(capacity.points.size(), 2u);
  EXPECT_EQ(capacity.points[0].second.value, 4000);
  EXPECT_EQ(std::get<syntax::BehaviourItem>(robot.items[8]).script.behaviours.size(), 1u);
  EXPECT_EQ(std::get<syntax::BehaviourItem>(robot.items[9]).file->text, "robot.motion");
}

TEST(ParseRobot, ABrokenItemIsLeftOutAndTheRestStays) {
  SourceMap sources;
  Diagnostics diagnostics;
  const FileId file = sources.add(
      "a.robot", "robot r { tool 3; sensor 4; body b { frame 3; shape sphere(0,0,0,1); } }");
  const syntax::Robot robot = interpreter::parse_robot(sources, file, diagnostics);
  EXPECT_EQ(diagnostics.errors(), 2);
  EXPECT_TRUE(robot.broken);
  ASSERT_EQ(robot.items.size(), 2u);
  EXPECT_EQ(std::get<syntax::BodyItem>(robot.items[1]).shapes.size(), 1u);
}

}  // namespace
}  // namespace rubicon
