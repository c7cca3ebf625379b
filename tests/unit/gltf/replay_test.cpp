#include "src/results/replay/replay.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "src/results/verify/input/mechanism.hpp"
#include "src/results/verify/input/trace_reader.hpp"
#include "src/results/verify/replay/component_stays.hpp"
#include "tests/unit/gltf/film_run.hpp"

namespace rubicon::replay {
namespace {

constexpr double kSlack = 1e-6;  // m, and of the numbers of a rotation

/// The same lines, replayed by the second opinion, which shares nothing with this one.
struct SecondOpinion {
  explicit SecondOpinion(const std::vector<std::string>& lines) {
    verify::TraceReader reader;
    for (const std::string& line : lines) reader.line(line);
    trace = reader.finish();
    runs = verify::task_runs(trace, faults);
  }

  void follow(Ticks until) {
    std::vector<verify::LoadEvent> events;
    for (std::size_t robot = 0; robot < trace.scene.robots.size(); ++robot) {
      tracks.push_back(
          verify::follow_robot(trace, runs, static_cast<int>(robot), until, events, faults));
    }
    stays = verify::component_stays(trace, runs, tracks, std::move(events), until, faults);
  }

  verify::Trace trace;
  verify::Faults faults;
  std::vector<verify::TaskRun> runs;
  std::vector<verify::RobotTrack> tracks;
  std::vector<verify::Stay> stays;
};

double distance(const math::Pose& a, const math::Pose& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

std::vector<double> middle(const std::vector<double>& from, const std::vector<double>& to) {
  std::vector<double> q = from;
  for (std::size_t i = 0; i < to.size(); ++i) q[i] = (from[i] + to[i]) / 2;
  return q;
}

/// Bodies and tool at the beginning and in the middle of a leg.
void compare_leg(const Machine& machine, const Leg& leg, const verify::Mechanism& other,
                 const verify::Leg& other_leg) {
  ASSERT_EQ(leg.from, other_leg.from);
  ASSERT_EQ(leg.to, other_leg.to);
  ASSERT_EQ(leg.moves(), other_leg.moves());
  ASSERT_EQ(leg.hanging, other_leg.hanging);
  for (const bool half : {false, true}) {
    const std::vector<double> q = half ? middle(leg.q0, leg.q1) : leg.q0;
    const std::vector<double> p = half ? middle(other_leg.q0, other_leg.q1) : other_leg.q0;
    std::vector<math::Pose> X_WB;
    robot::body_poses(machine.model, machine.mounting, q, X_WB);
    X_WB.push_back(robot::tool_pose(machine.model, machine.mounting, q));
    ASSERT_EQ(static_cast<int>(X_WB.size()), other.tool() + 1);
    for (std::size_t i = 0; i < X_WB.size(); ++i) {
      ASSERT_LT(distance(X_WB[i], other.pose(static_cast<int>(i), p)), kSlack)
          << machine.name << ", frame " << i << ", from " << leg.from;
    }
  }
}

void compare(const test::FilmRun& run) {
  ReplayReader reader;
  for (const std::string& line : run.lines) reader.line(line);
  const Replay replay = reader.finish();
  SecondOpinion other(run.lines);
  other.follow(replay.until);
  ASSERT_EQ(replay.machines.size(), other.tracks.size());
  std::size_t steps = 0;
  for (std::size_t i = 0; i < replay.machines.size(); ++i) {
    const verify::Mechanism mechanism(other.trace.scene.robots[i]);
    const RobotTrack& track = replay.tracks[i];
    ASSERT_EQ(track.legs.size(), other.tracks[i].legs.size());
    for (std::size_t k = 0; k < track.legs.size(); ++k) {
      compare_leg(replay.machines[i], track.legs[k], mechanism, other.tracks[i].legs[k]);
      if (testing::Test::HasFatalFailure()) return;
      if (track.legs[k].moves()) ++steps;
    }
    ASSERT_EQ(track.loads.size(), other.tracks[i].loads.size());
    for (std::size_t k = 0; k < track.loads.size(); ++k) {
      EXPECT_EQ(track.loads[k].component, other.tracks[i].loads[k].component);
      EXPECT_LT(distance(track.loads[k].X_TO, other.tracks[i].loads[k].X_TO), kSlack);
    }
  }
  EXPECT_GT(steps, 10U);
  std::stable_sort(other.stays.begin(), other.stays.end(),
                   [](const auto& a, const auto& b) { return a.component < b.component; });
  ASSERT_EQ(replay.stays.size(), other.stays.size());
  for (std::size_t i = 0; i < replay.stays.size(); ++i) {
    EXPECT_EQ(replay.stays[i].component, other.stays[i].component);
    EXPECT_EQ(replay.stays[i].from, other.stays[i].from);
    EXPECT_EQ(replay.stays[i].to, other.stays[i].to);
    EXPECT_LT(distance(replay.stays[i].X_WO, other.stays[i].X_WO), kSlack);
  }
}

TEST(Replay, AgreesWithTheSecondOpinion) {
  for (const char* plan :
       {"taskplans/unit.plan", "taskplans/three_tow_motors.plan",
        "examples/05_level_bucket/site.plan", "robots/tower_crane/cases/trap/site.plan"}) {
    SCOPED_TRACE(plan);
    compare(test::run_for_film(plan));
  }
}

/// What a trace says when some text of its line is another.
std::string message_for(std::vector<std::string> lines, const std::string& from,
                        const std::string& to) {
  bool found = false;
  for (std::string& line : lines) {
    const std::size_t place = line.find(from);
    if (found || place == std::string::npos) continue;
    line.replace(place, from.size(), to);
    found = true;
  }
  EXPECT_TRUE(found) << from;
  try {
    ReplayReader reader;
    for (const std::string& line : lines) reader.line(line);
    reader.finish();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Replay, RefusesWhatItCannotFollow) {
  const auto lines = test::run_for_film("taskplans/unit.plan").lines;
  EXPECT_EQ(message_for(lines, "\"detail\":\"steps\"", "\"detail\":\"steps\""), "");
  EXPECT_NE(message_for(lines, "\"detail\":\"steps\"", "\"detail\":\"tasks\"").find("every step"),
            std::string::npos);
  EXPECT_NE(message_for(lines, "\"frame\":\"", "\"frame\":\"rotw(2) * ").find("rotx"),
            std::string::npos);
  EXPECT_NE(
      message_for(lines, "\"component\":\"floor_1\",\"pose\"", "\"component\":\"flour\",\"pose\"")
          .find("\"flour\""),
      std::string::npos);
}

}  // namespace
}  // namespace rubicon::replay
