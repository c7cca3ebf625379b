#include "src/motion/robot/kinematics.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "src/exchange/urdf/package_folders_io.hpp"
#include "src/exchange/urdf/read_xml.hpp"
#include "src/exchange/urdf/xacro.hpp"
#include "src/motion/math/angles.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/unit/urdf/machine_support.hpp"
#include "tests/unit/urdf/urdfdom_poses.hpp"

namespace rubicon::urdf::testing {
namespace {

using robot::RobotModel;

constexpr double kNear = 1e-9;

struct RandomJoint {
  std::string type;
  double lower = 0;
  double upper = 0;
  bool mimics = false;
};

/// A machine of random joints in a random tree, as URDF.
class RandomMachine {
 public:
  explicit RandomMachine(unsigned seed) : random_(seed) {
    const int links = whole(2, 12);
    text_ = "<robot name=\"random\">\n<link name=\"link_0\"/>\n";
    for (int i = 1; i < links; ++i) add(i);
    text_ += "</robot>\n";
  }

  const std::string& text() const { return text_; }
  const std::map<std::string, RandomJoint>& joints() const { return joints_; }
  std::string last_link() const { return fmt::format("link_{}", joints_.size()); }

  double real(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(random_);
  }

 private:
  int whole(int lower, int upper) {
    return std::uniform_int_distribution<int>(lower, upper)(random_);
  }

  /// Right angles, as people write them, and any others.
  double angle() {
    constexpr double kRight[] = {0, 1.5707963267948966, -1.5707963267948966, 3.14159265358979,
                                 1.57079632679};
    return whole(0, 1) == 0 ? kRight[whole(0, 4)] : real(-3.2, 3.2);
  }

  std::string axis() {
    constexpr const char* kAxes[] = {"1 0 0",  "0 1 0",  "0 0 1",  "-1 0 0",
                                     "0 -1 0", "0 0 -1", "0 0 2.5"};
    if (whole(0, 1) == 0) return kAxes[whole(0, 6)];
    return fmt::format("{} {} {}", real(-1, 1), real(-1, 1), real(0.1, 1));
  }

  void add(int i) {
    constexpr const char* kTypes[] = {"revolute", "continuous", "prismatic", "fixed"};
    const std::string name = fmt::format("joint_{}", i);
    RandomJoint joint;
    joint.type = kTypes[whole(0, 3)];
    const double span = joint.type == "prismatic" ? 2 : 1.5;
    joint.lower = real(-span, 0);
    joint.upper = real(0, span);
    text_ += fmt::format(
        "<link name=\"link_{0}\"/>\n<joint name=\"{1}\" type=\"{2}\">\n"
        "  <parent link=\"link_{3}\"/><child link=\"link_{0}\"/>\n"
        "  <origin xyz=\"{4} {5} {6}\" rpy=\"{7} {8} {9}\"/>\n",
        i, name, joint.type, whole(0, i - 1), real(-3, 3), real(-3, 3), real(-3, 3), angle(),
        angle(), angle());
    if (joint.type != "fixed") {
      text_ += fmt::format("  <axis xyz=\"{}\"/>\n", axis());
      text_ += fmt::format("  <limit lower=\"{}\" upper=\"{}\" velocity=\"0.5\" effort=\"1\"/>\n",
                           joint.lower, joint.upper);
      if (i > 1 && whole(0, 3) == 0) {
        joint.mimics = true;
        text_ += fmt::format("  <mimic joint=\"joint_{}\" multiplier=\"{}\" offset=\"{}\"/>\n",
                             whole(1, i - 1), real(-2, 2), real(-0.5, 0.5));
      }
    }
    text_ += "</joint>\n";
    joints_[name] = joint;
  }

  std::mt19937 random_;
  std::string text_;
  std::map<std::string, RandomJoint> joints_;
};

void expect_near(const math::Pose& found, const math::Pose& expected, const std::string& what) {
  EXPECT_LT((found.translation() - expected.translation()).norm(), kNear) << what;
  EXPECT_LT((found.linear() - expected.linear()).norm(), kNear) << what;
}

/// Joint values in m and rad for the parameters that can be moved; body BODY moves by the joint
/// `joint_of` names.
void expect_same_poses(const std::string& urdf, const RobotModel& model,
                       const std::map<std::string, double>& values,
                       const std::map<std::string, std::string>& link_of_joint,
                       const std::string& tool) {
  robot::Mounting mounting;
  mounting.starts = model.start_values();
  std::vector<double> q = mounting.starts;
  for (const auto& [joint, value] : values) {
    const int body = model.find_body(link_of_joint.at(joint));
    ASSERT_GE(body, 0);
    const auto p =
        static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(body)].parameters.at(0));
    q[p] = model.parameters[p].rotation ? math::degrees(value) : value;
  }
  robot::update_derived(model, mounting, q);
  std::vector<math::Pose> X_WB;
  robot::body_poses(model, mounting, q, X_WB);
  const auto expected = urdfdom_poses(urdf, values);
  ASSERT_FALSE(expected.empty());
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    expect_near(X_WB[i], expected.at(model.bodies[i].name), model.bodies[i].name + "\n" + urdf);
  }
  expect_near(robot::tool_pose(model, mounting, q), expected.at(tool), "tool\n" + urdf);
}

TEST(Kinematics, RandomMachinesStandWhereUrdfdomPutsThem) {
  int bodies = 0, derived = 0;
  for (unsigned seed = 1; seed <= test::cases(300); ++seed) {
    RandomMachine machine(seed);
    Asked asked{machine.text()};
    asked.tool = machine.last_link();
    const Imported imported = import(asked);
    ASSERT_TRUE(imported.machine) << imported.said() << machine.text();
    const auto robot = checked(imported.machine->robot);
    ASSERT_TRUE(robot && robot->usable) << imported.machine->robot;
    std::map<std::string, std::string> links;
    for (const auto& [name, joint] : machine.joints()) links[name] = "link_" + name.substr(6);
    for (int i = 0; i < 5; ++i) {
      std::map<std::string, double> values;
      for (const auto& [name, joint] : machine.joints()) {
        if (joint.type == "fixed" || joint.mimics) continue;
        values[name] = machine.real(joint.lower, joint.upper);
      }
      expect_same_poses(machine.text(), robot->model, values, links, asked.tool);
      if (::testing::Test::HasFailure()) return;
    }
    bodies += static_cast<int>(robot->model.bodies.size());
    for (const auto& each : robot->model.parameters) derived += each.derived ? 1 : 0;
  }
  EXPECT_GT(bodies, test::at_least(1000));
  EXPECT_GT(derived, test::at_least(100));
}

std::string xml_of(const Element& element) {
  std::string text = "<" + element.name;
  for (const Attribute& each : element.attributes) {
    text += fmt::format(" {}=\"{}\"", each.name, each.value);
  }
  text += ">";
  for (const Element& each : element.children) text += xml_of(each);
  return text + "</" + element.name + ">\n";
}

TEST(Kinematics, TheRealExcavatorStandsWhereUrdfdomPutsIt) {
  const std::string path = test::source_dir() + "/../shared/data/zx200/zx200.xacro";
  if (!std::filesystem::exists(path)) {
    GTEST_SKIP() << "the machine of this test is not there: " << path;
  }
  std::ifstream stream(path);
  std::stringstream text;
  text << stream.rdbuf();
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  const interpreter::FileId file = sources.add(path, text.str());
  PackageFolders folders(path, {});
  Findings findings;
  const Element urdf =
      expand_xacro(read_xml(sources, file), {{}, path, &sources, &folders, &findings});
  const auto imported =
      import_machine({path, {}, "", "meshes"}, sources, file, folders, diagnostics);
  ASSERT_TRUE(imported);
  EXPECT_EQ(imported->meshes.size(), 5U);
  // Shapes apart: they do not move anything.
  std::string robot;
  std::stringstream lines(imported->robot);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("shape mesh") == std::string::npos) robot += line + "\n";
  }
  const auto read = checked(robot);
  ASSERT_TRUE(read && read->usable);
  EXPECT_EQ(read->model.bodies.size(), 6U);
  std::mt19937 random(7);
  for (int i = 0; i < 100; ++i) {
    const auto between = [&](double a, double b) {
      return std::uniform_real_distribution<double>(a, b)(random);
    };
    expect_same_poses(xml_of(urdf), read->model,
                      {{"swing_joint", between(-3, 3)},
                       {"boom_joint", between(-1.137, -0.1)},
                       {"arm_joint", between(0.594, 2.687)},
                       {"bucket_joint", between(-0.622, 2.372)},
                       {"bucket_end_joint", between(-3.14, 3.14)}},
                      {{"swing_joint", "body_link"},
                       {"boom_joint", "boom_link"},
                       {"arm_joint", "arm_link"},
                       {"bucket_joint", "bucket_link"},
                       {"bucket_end_joint", "bucket_end_link"}},
                      "bucket_end_link");
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace rubicon::urdf::testing
