#include <gtest/gtest.h>

#include "interpreter/check/check.hpp"
#include "src/motion/robot/kinematics.hpp"
#include "tests/support/find_parameter.hpp"
#include "tests/unit/check/check_cases.hpp"
#include "tests/unit/check/memory_files.hpp"

namespace rubicon::test {

namespace {

using interpreter::CheckedRobot;
using interpreter::Diagnostics;
using interpreter::SourceMap;

const std::string kPath = "site/machine.robot";

/// A robot text, checked, with all that was said.
struct Checked {
  explicit Checked(const std::string& text) : files(case_files()) {
    files.texts[kPath] = text;
    robot = interpreter::load_robot(kPath, sources, files, nullptr, diagnostics);
  }
  std::string said() const { return listed(diagnostics, sources, kPath); }
  const robot::Parameter& parameter(const std::string& name) const {
    return robot->model.parameters.at(static_cast<std::size_t>(find_parameter(robot->model, name)));
  }

  SourceMap sources;
  MemoryFiles files;
  Diagnostics diagnostics;
  std::shared_ptr<const CheckedRobot> robot;
};

TEST(RobotCheck, SaysExactlyWhatEachCaseDeserves) {
  const std::vector<CheckCase> cases = read_check_cases("robot_cases.txt");
  ASSERT_GT(cases.size(), 80u);
  for (const CheckCase& given : cases) {
    EXPECT_EQ(Checked(given.text).said(), listed(given.expected)) << given.title << "\n"
                                                                  << given.text;
  }
}

TEST(RobotCheck, EveryCodeIsProvokedByACase) {
  std::string all;
  for (const CheckCase& given : read_check_cases("robot_cases.txt")) all += listed(given.expected);
  for (const char* code :
       {"R01", "R02", "R03", "R04", "R05", "R06", "R07", "R08", "R09", "R10", "R11", "R12",
        "R13", "R14", "R15", "R16", "R17", "R18", "R19", "R20", "R21", "R22", "F01", "F02",
        "F03", "F04", "F05", "F06", "F07", "F08", "F09", "F10", "F11", "F12", "F13"}) {
    EXPECT_NE(all.find(std::string(": ") + code + " "), std::string::npos) << code;
  }
}

TEST(RobotCheck, ReadsTheCraneAsItIsWritten) {
  const Checked crane(case_files().texts.at("site/crane.robot"));
  ASSERT_EQ(crane.said(), "");
  ASSERT_TRUE(crane.robot->usable);
  const robot::RobotModel& model = crane.robot->model;
  ASSERT_EQ(model.bodies.size(), 3u);
  EXPECT_EQ(model.bodies[1].parent, 0);
  EXPECT_EQ(model.bodies[2].parent, 1);
  EXPECT_EQ(model.tool_body, 2);
  EXPECT_EQ(model.time_step, 2);
  const robot::Parameter& theta = crane.parameter("theta");
  EXPECT_TRUE(theta.rotation);
  EXPECT_TRUE(theta.direct);
  EXPECT_TRUE(theta.free);
  EXPECT_EQ(theta.lower, -180);
  EXPECT_EQ(theta.step, 5);
  EXPECT_EQ(theta.speed, 2.5);
  EXPECT_EQ(theta.loaded_speed, 2.5);
  EXPECT_EQ(model.start_values(), (std::vector<double>{0, 20, 10}));
  ASSERT_TRUE(crane.robot->script.has_value());
  EXPECT_EQ(crane.robot->script->statements.size(), 1u);
  const math::Pose X = robot::tool_pose(model, {math::Pose::Identity(), model.start_values()},
                                        std::vector<double>{90, 20, 10});
  EXPECT_NEAR((X.translation() - math::Vec3(0, 20, 10)).norm(), 0, 1e-12);
}

TEST(RobotCheck, TellsLocalAndUnmovedParametersFromDirectOnes) {
  const Checked agent(case_files().texts.at("site/agent.robot"));
  ASSERT_EQ(agent.said(), "");
  EXPECT_FALSE(agent.parameter("x").direct);
  EXPECT_TRUE(agent.parameter("x").free);
  EXPECT_TRUE(agent.parameter("y").free);
  EXPECT_EQ(agent.parameter("y").step, 0);
  EXPECT_EQ(agent.parameter("y").quantum, 1);
  EXPECT_FALSE(agent.parameter("z").free);
  EXPECT_TRUE(agent.parameter("theta").direct);
  EXPECT_TRUE(agent.parameter("theta").cyclic);
}

TEST(RobotCheck, FillsInWhatIsNotGiven) {
  const Checked robot(R"(robot r {
    time_step 2;
    body a { param x range(3, 9) speed(0.5 m/s) loaded(0.25 m/s); param theta; frame trans(x, 0, 0); }
    body b on a { param x step(10 cm); param theta cyclic step(15) start(350); frame rotz(theta); }
    behaviour "ok.motion";
  })");
  EXPECT_EQ(robot.robot->model.parameters[0].display_name, "a.x");
  EXPECT_EQ(robot.parameter("a.x").start, 3);
  EXPECT_EQ(robot.parameter("a.x").step, 1);
  EXPECT_EQ(robot.parameter("a.x").speed, 0.5);
  EXPECT_EQ(robot.parameter("a.x").loaded_speed, 0.25);
  EXPECT_DOUBLE_EQ(robot.parameter("b.x").speed, 0.05);
  EXPECT_EQ(robot.parameter("a.theta").quantum, 15);
  EXPECT_EQ(robot.parameter("b.theta").start, -10);
  EXPECT_EQ(robot.robot->model.tool_body, 1);
}

TEST(RobotCheck, ComputesDerivedParametersFromTheOthersInAnyOrder) {
  const Checked robot(R"(robot r {
    const level = 35 deg;
    body boom { param phi range(-60, 60) step(1) start(10); frame roty(phi); }
    body mid on boom { param phi = last.phi + 1; frame roty(phi); }
    body last on mid { param phi = level - boom.phi; frame roty(phi); }
    behaviour { chain {move_to(boom.phi, goal(boom.phi))}; }
  })");
  ASSERT_EQ(robot.said(), "");
  EXPECT_EQ(robot.parameter("last.phi").start, 25);
  EXPECT_EQ(robot.parameter("mid.phi").start, 26);
  EXPECT_FALSE(robot.parameter("last.phi").free);
  std::vector<double> q = {20, 0, 0};
  robot::update_derived(robot.robot->model, {math::Pose::Identity(), q}, q);
  EXPECT_EQ(q, (std::vector<double>{20, 16, 15}));
}

TEST(RobotCheck, FoldsConstants) {
  const Checked robot(R"(robot r {
    const half = 3 m / 2;
    const whole = 2 * half + 50 cm;
    body b { param x step(1); frame trans(x + whole, -half, cos(60) * 4); }
    behaviour "ok.motion";
  })");
  ASSERT_EQ(robot.said(), "");
  const math::Pose X =
      robot::tool_pose(robot.robot->model, {math::Pose::Identity(), {1}}, std::vector<double>{1});
  EXPECT_NEAR((X.translation() - math::Vec3(4.5, -1.5, 2)).norm(), 0, 1e-12);
}

TEST(RobotCheck, AsksForMeshesInsideTheFolderOfTheRobotOnce) {
  const Checked robot(R"(robot r {
    body b {
      shape mesh("cube.stl", mm, scale 2, up y, part "a");
      shape mesh("./cube.stl", mm, scale 2, up y, part "a") at trans(1, 0, 0);
      shape mesh("hall.glb");
      shape mesh("hall.glb", hull);
    }
    behaviour { wait; }
  })");
  ASSERT_EQ(robot.diagnostics.errors(), 0) << robot.said();
  ASSERT_EQ(robot.files.requests.size(), 3u);
  const interpreter::MeshRequest& first = robot.files.requests[0];
  EXPECT_EQ(first.path, "site/cube.stl");
  EXPECT_EQ(first.folder, "site");
  EXPECT_EQ(first.metres_per_unit, 0.001);
  EXPECT_EQ(first.scale, 2);
  EXPECT_EQ(first.up, 'y');
  EXPECT_EQ(first.part, "a");
  EXPECT_FALSE(first.hull);
  EXPECT_EQ(robot.files.requests[1].metres_per_unit, 0);
  EXPECT_FALSE(robot.files.requests[1].hull);
  EXPECT_TRUE(robot.files.requests[2].hull);
  const auto& shapes = robot.robot->model.bodies[0].shapes;
  ASSERT_EQ(shapes.size(), 4u);
  EXPECT_EQ(std::get<geometry::Mesh>(shapes[0].solid).mesh,
            std::get<geometry::Mesh>(shapes[1].solid).mesh);
  EXPECT_EQ(shapes[1].X_BS.translation().x(), 1);
}

TEST(RobotCheck, SaysWhenTheFileItselfCannotBeRead) {
  MemoryFiles files;
  SourceMap sources;
  Diagnostics diagnostics;
  EXPECT_EQ(interpreter::load_robot("no.robot", sources, files, nullptr, diagnostics), nullptr);
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].code, "F01");
  EXPECT_EQ(diagnostics.all()[0].message, "'no.robot': there is no such file");
}

TEST(RobotCheck, SurvivesLongChainsOfBodiesAndDerivedParameters) {
  std::string bodies = "robot r { body b0 { param x step(1); }";
  for (int i = 1; i < 1200; ++i) {
    bodies += " body b" + std::to_string(i) + " on b" + std::to_string(i - 1) + " { param x = b" +
              std::to_string(i - 1) + ".x + b" + std::to_string(i - 1) + ".x; }";
  }
  const Checked doubled(bodies + " behaviour \"ok.motion\"; }");
  EXPECT_NE(doubled.said().find("R18 error: this robot has more than 1000 bodies"),
            std::string::npos);
  EXPECT_NE(doubled.said().find("has more than 10000 operations"), std::string::npos);

  std::string chain = "robot r { body a { param x step(1); param z = b0.x; }";
  for (int i = 0; i < 900; ++i) {
    chain += " body b" + std::to_string(i) + " { param x = b" + std::to_string(i + 1) + ".x; }";
  }
  const Checked forward(chain + " body b900 { param x step(1); } behaviour \"ok.motion\"; }");
  EXPECT_NE(forward.said().find("more than 64 derived parameters need each other"),
            std::string::npos);
}

TEST(ResolvePath, JoinsWithTheFolderOfTheNamingFile) {
  using interpreter::resolve_path;
  EXPECT_EQ(resolve_path("site/a.plan", "crane.robot"), "site/crane.robot");
  EXPECT_EQ(resolve_path("site/a.plan", "../robots/./crane.robot"), "robots/crane.robot");
  EXPECT_EQ(resolve_path("a.plan", "../crane.robot"), "../crane.robot");
  EXPECT_EQ(resolve_path("../../a.plan", "../crane.robot"), "../../../crane.robot");
  EXPECT_EQ(resolve_path("/x/a.plan", "../../../crane.robot"), "/crane.robot");
  EXPECT_EQ(resolve_path("site/a.plan", "/abs/crane.robot"), "/abs/crane.robot");
  EXPECT_EQ(resolve_path("a.plan", "b//c/../d"), "b/d");
  EXPECT_EQ(resolve_path("a.plan", ""), ".");
}

}  // namespace

}  // namespace rubicon::test
