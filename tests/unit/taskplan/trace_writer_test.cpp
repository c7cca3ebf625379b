#include "src/simulation/trace/trace_writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/unit/taskplan/crane_plan.hpp"

namespace rubicon::trace {
namespace {

using interpreter::Span;

class TraceWriterTest : public testing::Test {
 protected:
  TraceWriterTest() { writer_.set_task("set_1", 0); }
  const std::string& last() const { return lines_.lines.back(); }

  test::Lines lines_;
  interpreter::PlanModel plan_ = test::crane_plan();
  interpreter::SourceMap sources_ = test::numbered_lines();
  TraceWriter writer_{lines_, plan_, sources_, TraceDetail::steps};
  const Span line_3_{0, 22, 25};
};

TEST_F(TraceWriterTest, WritesTheStructureOfARun) {
  writer_.task_start(0);
  EXPECT_EQ(last(), R"({"type":"task_start","task":"set_1","robot":"crane","t":0})");
  writer_.goal(1, 2);
  EXPECT_EQ(last(), R"({"type":"goal","task":"set_1","robot":"crane","k":1,"n":2})");
  writer_.set("height", -0.0, line_3_);
  EXPECT_EQ(last(), R"({"type":"set","task":"set_1","robot":"crane","var":"height","value":0})");
  writer_.enter(interpreter::LoopKind::cycle, line_3_);
  EXPECT_EQ(last(), R"({"type":"enter","task":"set_1","robot":"crane","kind":"cycle",)"
                    R"("file":"crane.motion","line":3,"column":3})");
  writer_.exit(interpreter::LoopKind::chain, line_3_, true, 4);
  EXPECT_EQ(last(), R"({"type":"exit","task":"set_1","robot":"crane","kind":"chain",)"
                    R"("file":"crane.motion","line":3,"column":3,"reached":true,"successes":4})");
  writer_.which("when", line_3_);
  EXPECT_EQ(last(), R"({"type":"which","task":"set_1","robot":"crane","label":"when",)"
                    R"("file":"crane.motion","line":3,"column":3})");
  writer_.wait(7, 1'000'000'000, line_3_);
  EXPECT_EQ(last(), R"({"type":"wait","task":"set_1","robot":"crane","n":7,"t":1})");
  writer_.task_end(2'500'000'000, "not reached", "a \"b\"");
  EXPECT_EQ(last(), R"({"type":"task_end","task":"set_1","robot":"crane","t":2.5,)"
                    R"("result":"not reached","reason":"a \"b\""})");
}

TEST_F(TraceWriterTest, WritesAttempts) {
  const std::vector<double> q = {5, 10, 20.5, -0.0};
  const std::vector<std::string> names = {"x"};
  interpreter::Attempt attempt;
  attempt.n = 12;
  attempt.command = "move_to";
  attempt.parameters = names;
  attempt.span = line_3_;
  attempt.accepted = true;
  attempt.time = 333'333'333;
  attempt.q = q;
  writer_.attempt(attempt);
  EXPECT_EQ(last(), R"({"type":"try","task":"set_1","robot":"crane","n":12,"command":"move_to",)"
                    R"("parameter":"x","file":"crane.motion","line":3,"column":3,"ok":true,)"
                    R"("reason":"","t":0.333333333,)"
                    R"("q":{"jib.theta":5,"x":10,"z":20.5,"hook.theta":0}})");
  const interpreter::HitPair pair{"crane.hook", "wall"};
  attempt.accepted = false;
  attempt.refusal = interpreter::Refusal::hit;
  attempt.hit = &pair;
  const std::vector<double> steps = {-0.5};
  attempt.steps = steps;
  writer_.attempt(attempt);
  EXPECT_THAT(last(),
              testing::HasSubstr(
                  R"("ok":false,"reason":"hit","hit":["crane.hook","wall"],"step":[-0.5],"t")"));
  attempt.steps = {};
  const std::vector<std::string> both = {"x", "z"};
  attempt.command = "together";
  attempt.parameters = both;
  attempt.refusal = interpreter::Refusal::limit;
  attempt.limit = "z";
  attempt.hit = nullptr;
  writer_.attempt(attempt);
  EXPECT_THAT(last(), testing::HasSubstr(R"("command":"together","parameter":["x","z"],)"));
  EXPECT_THAT(last(), testing::HasSubstr(R"("reason":"limit z","t")"));
}

TEST_F(TraceWriterTest, WritesTheEndOfAMotion) {
  interpreter::MotionEnd end;
  end.status = interpreter::MotionStatus::livelock;
  end.period = 2;
  end.tries = 9;
  end.accepted = 5;
  end.rejected.at_goal = 1;
  end.rejected.hit = 3;
  end.residual = {{1, 2.5}};
  end.q = {0, 10, 20, 0};
  end.variables = {{"height", 8}};
  end.time = 5'000'000'000;
  end.message = "livelock: again";
  end.span = line_3_;
  writer_.motion_end(end);
  const auto record = nlohmann::ordered_json::parse(last());
  EXPECT_EQ(record.at("status"), "livelock");
  EXPECT_EQ(record.at("reached"), false);
  EXPECT_EQ(record.at("period"), 2);
  EXPECT_EQ(record.at("rejected").dump(), R"({"at goal":1,"no direction":0,"limit":0,"hit":3})");
  EXPECT_EQ(record.at("residual").dump(), R"({"x":2.5})");
  EXPECT_EQ(record.at("vars").dump(), R"({"height":8})");
  EXPECT_EQ(record.at("t"), 5);
  EXPECT_EQ(record.at("line"), 3);
  EXPECT_EQ(record.at("message"), "livelock: again");

  end = {};
  end.reached = true;
  end.q = {0, 10, 20, 0};
  writer_.motion_end(end);
  const auto reached = nlohmann::ordered_json::parse(last());
  EXPECT_TRUE(reached.at("period").is_null());
  EXPECT_FALSE(reached.contains("message"));
  EXPECT_FALSE(reached.contains("line"));
}

TEST_F(TraceWriterTest, DetailSetsHowMuch) {
  const auto count = [&](TraceDetail detail) {
    test::Lines lines;
    TraceWriter writer(lines, plan_, sources_, detail);
    writer.header();
    writer.set_task("a", 0);
    writer.task_start(0);
    writer.goal(1, 1);
    writer.wait(1, 0, line_3_);
    writer.attach("panel", math::Pose::Identity(), 0);
    interpreter::MotionEnd end;
    end.q = {0, 0, 0, 0};
    writer.motion_end(end);
    writer.task_end(0, "done", "");
    return lines.lines.size();
  };
  EXPECT_EQ(count(TraceDetail::steps), 7u);
  EXPECT_EQ(count(TraceDetail::tasks), 5u);
  EXPECT_EQ(count(TraceDetail::none), 1u);
}

TEST_F(TraceWriterTest, HeaderCarriesTheScene) {
  auto mesh = std::make_shared<geometry::TriangleMesh>();
  mesh->vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh->triangles = {{0, 1, 2}};
  for (const char* name : {"slab", "slab_2"}) {
    plan_.components.push_back(test::box_component(name, {2, 1, 3}, math::translation(1, 2, 3)));
    plan_.components.back().shapes.push_back(
        {geometry::Mesh{"slab.stl", mesh}, math::Pose::Identity()});
  }
  plan_.tasks.push_back(test::move_task("set_slab", 0, math::translation(4, 5, 6)));
  plan_.tasks.back().hook = interpreter::WorkSpec{240, 0, {}};
  writer_.header();
  const auto header = nlohmann::ordered_json::parse(last());
  EXPECT_EQ(header.at("type"), "header");
  EXPECT_EQ(header.at("format"), "rubicon-trace");
  EXPECT_EQ(header.at("version"), 1);
  EXPECT_EQ(header.at("plan"), "site");
  EXPECT_EQ(header.at("files").at(0).at("path"), "crane.motion");
  EXPECT_EQ(header.at("files").at(0).at("sha256").get<std::string>().size(), 64u);
  EXPECT_EQ(header.at("components").at(0).at("pose").dump(), "[1,0,0,1,0,1,0,2,0,0,1,3]");
  EXPECT_EQ(header.at("components").at(1).at("shapes").at(1).at("mesh"), 0);
  EXPECT_EQ(header.at("meshes").size(), 1u);
  const auto& robot = header.at("robots").at(0);
  EXPECT_EQ(robot.at("bodies").at(2).at("frame"), "trans(x, 0, z) * rotz(hook.theta)");
  EXPECT_EQ(robot.at("bodies").at(2).at("parent"), "jib");
  EXPECT_EQ(robot.at("parameters").at(1).at("rule"), "x + x_s");
  EXPECT_TRUE(robot.at("parameters").at(3).at("upper").is_null());
  EXPECT_EQ(robot.at("start").dump(), R"({"jib.theta":0,"x":10,"z":20,"hook.theta":0})");
  EXPECT_EQ(header.at("tasks").at(0).at("move"), "slab");
  EXPECT_EQ(header.at("tasks").at(0).at("hook").dump(), R"({"duration":240,"crew":"riggers"})");
}

}  // namespace
}  // namespace rubicon::trace
