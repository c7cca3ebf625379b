#include "src/results/gltf/document.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "src/motion/robot/kinematics.hpp"
#include "tests/unit/gltf/film_player.hpp"
#include "tests/unit/gltf/film_run.hpp"

namespace rubicon::gltf {
namespace {

using math::Pose;
using nlohmann::json;
using test::FilmPlayer;
using test::FilmRun;

/// m: what the film may be off by.
constexpr double kSlack = 5e-4;

/// m/s: nothing moves faster; moments of a film are floats, so that of the plan they are off by
/// some 1e-7 of themselves.
constexpr double kFastest = 3;

double allowed_at(double plan_time) { return kSlack + kFastest * plan_time / (1 << 24); }

/// How far the corners of a cube of 2 m round the origin of a frame are apart.
double distance(const Pose& A, const Pose& B) {
  double most = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    most = std::max(most, (A * p - B * p).norm());
  }
  return most;
}

Pose pose_of(const json& numbers) {
  Pose X = Pose::Identity();
  for (int i = 0; i < 12; ++i) X.matrix()(i / 4, i % 4) = numbers.at(static_cast<std::size_t>(i));
  return X;
}

const interpreter::RobotSpec& robot_of(const FilmRun& run, const std::string& name) {
  for (const auto& robot : run.plan->robots) {
    if (robot.name == name) return robot;
  }
  throw std::out_of_range(name);
}

/// Compares the bodies of a robot (by its own kinematics) and what hangs on it at the end of a
/// step.
class Comparison {
 public:
  Comparison(const FilmRun& run, const FilmPlayer& player, double speed_up)
      : run_(run), player_(player), speed_up_(speed_up) {}

  void compare(const json& step, const std::optional<std::pair<std::string, Pose>>& load) {
    const auto& robot = robot_of(run_, step.at("robot"));
    const robot::RobotModel& model = robot.robot->model;
    std::vector<double> q;
    for (const auto& parameter : model.parameters) {
      q.push_back(step.at("q").at(parameter.display_name));
    }
    const double time = step.at("t").get<double>() / speed_up_;
    const robot::Mounting mounting{robot.X_WM, robot.start};
    std::vector<Pose> X_WB;
    robot::body_poses(model, mounting, q, X_WB);
    for (std::size_t i = 0; i < X_WB.size(); ++i) {
      const auto nodes = player_.named(robot.name + "." + model.bodies[i].name);
      ASSERT_EQ(nodes.size(), 1U);
      EXPECT_LT(distance(player_.pose(nodes[0], time), X_WB[i]), allowed_at(time * speed_up_))
          << robot.name << "." << model.bodies[i].name << " at " << step.at("t");
    }
    if (load) compare_load(time, *load, robot::tool_pose(model, mounting, q));
  }

 private:
  void compare_load(double time, const std::pair<std::string, Pose>& load, const Pose& X_WT) {
    int seen = 0;
    for (const int node : player_.named(load.first)) {
      if (!player_.visible(node, time)) continue;
      ++seen;
      EXPECT_LT(distance(player_.pose(node, time), X_WT * load.second),
                allowed_at(time * speed_up_))
          << load.first;
    }
    EXPECT_EQ(seen, 1) << load.first;
  }

  const FilmRun& run_;
  const FilmPlayer& player_;
  double speed_up_;
};

/// Plans of which every task is done, so that all that the trace tells happened.
class Film : public testing::TestWithParam<const char*> {};

TEST_P(Film, StandsWhereTheRobotsStood) {
  const FilmRun run = test::run_for_film(GetParam());
  const double speed_up = 60;
  const FilmPlayer player(test::film_of(run, speed_up));
  std::map<std::string, std::pair<std::string, Pose>> loads;  // by robot
  std::size_t steps = 0;
  for (const json& record : run.records) steps += record.at("type") == "try" && record.at("ok");
  const std::size_t each = std::max<std::size_t>(steps / 40, 1);
  Comparison comparison(run, player, speed_up);
  std::size_t step = 0;
  for (std::size_t i = 0; i < run.records.size(); ++i) {
    const json& record = run.records[i];
    const std::string robot = record.at("robot");
    if (record.at("type") == "attach") {
      loads[robot] = {record.at("component"), pose_of(record.at("pose"))};
    }
    if (record.at("type") == "detach") loads.erase(robot);
    if (record.at("type") != "try" || !record.at("ok") || step++ % each != 0) continue;
    const auto load = loads.find(robot);
    const bool loaded = load != loads.end();
    comparison.compare(record, loaded ? std::optional(load->second) : std::nullopt);
  }
  EXPECT_GT(step, 10U);
}

TEST_P(Film, EndsWithTheBuildingAsItWasBuilt) {
  const FilmRun run = test::run_for_film(GetParam());
  const FilmPlayer player(test::film_of(run, 0));
  std::map<std::string, Pose> places;
  const json header = json::parse(run.lines.front());
  for (const json& component : header.at("components")) {
    places[component.at("name")] = pose_of(component.at("pose"));
  }
  for (const auto& [name, X_WO] : places) {  // at the beginning
    int seen = 0;
    for (const int node : player.named(name)) {
      if (!player.visible(node, 0)) continue;
      ++seen;
      EXPECT_LT(distance(player.pose(node, 0), X_WO), kSlack) << name;
    }
    EXPECT_EQ(seen, 1) << name;
  }
  std::set<std::string> gone;
  for (const json& record : run.records) {
    if (record.at("type") == "detach") places[record.at("component")] = pose_of(record.at("pose"));
    if (record.at("type") == "remove") gone.insert(record.at("component").get<std::string>());
  }
  for (const auto& [name, X_WO] : places) {
    int seen = 0;
    for (const int node : player.named(name)) {
      if (!player.visible(node, player.end() + 1)) continue;
      ++seen;
      EXPECT_LT(distance(player.pose(node, player.end() + 1), X_WO), kSlack) << name;
    }
    EXPECT_EQ(seen, gone.contains(name) ? 0 : 1) << name;
  }
  EXPECT_GT(player.end(), 20);  // crews may go on when nothing moves any more
  EXPECT_LE(player.end(), 60.1);
}

INSTANTIATE_TEST_SUITE_P(Plans, Film,
                         testing::Values("taskplans/unit.plan", "taskplans/two_cranes.plan",
                                         "taskplans/crane_and_trucks.plan",
                                         "taskplans/three_tow_motors.plan",
                                         "taskplans/people_below.plan"));

TEST(FilmDocument, LeavesOutWhatDidNotHappen) {
  const FilmRun run = test::run_for_film("examples/08_what_cannot_be_done/site.plan");
  const FilmPlayer player(test::film_of(run, 1));
  for (const char* name : {"a", "b", "c"}) {
    const auto nodes = player.named(name);
    ASSERT_EQ(nodes.size(), 1U) << name;  // it never left its place
    EXPECT_TRUE(player.visible(nodes[0], 0) && player.visible(nodes[0], 1000));
  }
}

/// The one node of a name.
int only(const FilmPlayer& player, const std::string& name) {
  const auto nodes = player.named(name);
  EXPECT_EQ(nodes.size(), 1U) << name;
  return nodes.empty() ? 0 : nodes.front();
}

TEST(FilmDocument, HangsHooksOnRopes) {
  const FilmRun run = test::run_for_film("taskplans/two_cranes.plan");
  const FilmPlayer player(test::film_of(run, 60));
  for (const char* crane : {"low", "high"}) {
    const std::string name = crane;
    const int rope = only(player, name + " rope");
    std::set<int> lengths;
    for (int i = 0; i <= 50; ++i) {
      const double time = player.end() * i / 50;
      const Pose trolley = player.pose(only(player, name + ".trolley"), time);
      const Pose hook = player.pose(only(player, name + ".hook"), time);
      const double length = player.scale(rope, time)[2];
      const Vec3 end = player.pose(rope, time) * Vec3(0, 0, -length);
      EXPECT_LT((player.pose(rope, time).translation() - trolley.translation()).norm(), kSlack);
      EXPECT_LT((end - hook.translation()).norm(), kSlack) << name << " at " << time;
      lengths.insert(static_cast<int>(length));
    }
    EXPECT_GT(lengths.size(), 3U) << name;  // it hoists
  }
}

TEST(FilmDocument, HangsLoadsOnSlings) {
  const FilmRun run = test::run_for_film("taskplans/two_cranes.plan");
  const FilmPlayer player(test::film_of(run, 60));
  const auto slings = player.named("slings");
  EXPECT_GE(slings.size(), 6U);  // a load each
  for (const int node : slings) EXPECT_EQ(player.material(node).at("name"), "rope");
}

TEST(FilmDocument, HasNoRopeWhereNothingHangs) {
  const FilmRun run = test::run_for_film("taskplans/three_tow_motors.plan");
  const FilmPlayer player(test::film_of(run, 0));
  for (const auto& node : player.json().at("nodes")) {
    EXPECT_EQ(node.at("name").get<std::string>().find(" rope"), std::string::npos);
    EXPECT_NE(node.at("name"), "slings");
  }
}

TEST(FilmDocument, LetsOneSeeThroughTheRoomOfAMachine) {
  const FilmRun run = test::run_for_film("taskplans/two_cranes.plan");
  const FilmPlayer player(test::film_of(run, 60));
  const json& room = player.material(only(player, "high.hook"));  // the drum about its rope
  EXPECT_EQ(room.value("alphaMode", "OPAQUE"), "BLEND");
  EXPECT_LT(room.at("pbrMetallicRoughness").at("baseColorFactor").at(3), 0.5);
  EXPECT_EQ(room.at("doubleSided"), true);
  for (const char* thing : {"high.jib", "high.block", "high.rope_1", "low.hook"}) {
    EXPECT_FALSE(player.material(only(player, thing)).contains("alphaMode")) << thing;
  }
}

TEST(FilmDocument, ShowsZonesOfPeopleWhileTheirTaskGoesOn) {
  const FilmRun run = test::run_for_film("taskplans/people_below.plan");
  const FilmPlayer player(test::film_of(run, 1));
  std::size_t zones = 0;
  for (const json& record : run.records) {
    if (record.at("type") != "task_start") continue;
    const auto nodes = player.named("zone of " + record.at("task").get<std::string>());
    if (nodes.empty()) continue;
    ++zones;
    const double start = record.at("t");
    EXPECT_TRUE(player.visible(nodes[0], start + 1));
    EXPECT_FALSE(start > 1 && player.visible(nodes[0], start - 1));
    EXPECT_EQ(player.material(nodes[0]).value("alphaMode", ""), "BLEND");
  }
  EXPECT_GT(zones, 0U);
}

TEST(FilmDocument, LastsAMinuteAndIsNeverSlowerThanItWas) {
  const FilmPlayer unit(test::film_of(test::run_for_film("taskplans/unit.plan"), 0));
  const json& extras = unit.json().at("asset").at("extras");
  EXPECT_NEAR(extras.at("seconds").get<double>() / extras.at("speed_up").get<double>(), 60, 1e-9);
  EXPECT_GT(unit.end(), 30);
  const FilmPlayer bucket(
      test::film_of(test::run_for_film("examples/05_level_bucket/site.plan"), 0));
  EXPECT_GE(bucket.json().at("asset").at("extras").at("speed_up"), 1);
}

TEST(FilmDocument, IsTheSameEachTime) {
  const FilmRun run = test::run_for_film("taskplans/two_cranes.plan");
  EXPECT_EQ(test::film_of(run, 0), test::film_of(run, 0));
}

TEST(FilmDocument, SharesMeshesOfEqualShapes) {
  const FilmRun run = test::run_for_film("taskplans/unit.plan");
  const FilmPlayer player(test::film_of(run, 0));
  std::set<std::size_t> floors;
  for (int i = 1; i <= 10; ++i) {
    for (const int node : player.named(fmt::format("floor_{}", i))) {
      floors.insert(player.json()
                        .at("nodes")
                        .at(static_cast<std::size_t>(node))
                        .at("mesh")
                        .get<std::size_t>());
    }
  }
  EXPECT_EQ(floors.size(), 3U);  // waiting, carried, placed
}

}  // namespace
}  // namespace rubicon::gltf
