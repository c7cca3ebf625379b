#include "tests/unit/trace/written_records.hpp"

#include "src/simulation/trace/trace_header.hpp"
#include "src/simulation/trace/trace_writer.hpp"
#include "tests/unit/taskplan/crane_plan.hpp"

namespace rubicon::test {

namespace {

constexpr interpreter::Ticks kSecond = 1'000'000'000;
const interpreter::Span kLine3{0, 22, 25};

void write_attempts(trace::TraceWriter& writer) {
  const std::vector<double> q = {5, 10, 20.5, -0.0};
  const std::vector<std::string> both = {"x", "z"};
  const interpreter::HitPair pair{"crane.hook", "wall"};
  interpreter::Attempt attempt;
  attempt.n = 12;
  attempt.command = "together";
  attempt.parameters = both;
  attempt.span = kLine3;
  attempt.refusal = interpreter::Refusal::hit;
  attempt.hit = &pair;
  const std::vector<double> steps = {5, -0.5};
  attempt.steps = steps;
  attempt.time = 333'333'333;
  attempt.q = q;
  writer.attempt(attempt);
  attempt.command = "move_to";
  attempt.parameters = std::span(both).first(1);
  attempt.accepted = true;
  attempt.refusal = interpreter::Refusal::none;
  attempt.hit = nullptr;
  attempt.steps = {};
  writer.attempt(attempt);
}

void write_ends(trace::TraceWriter& writer) {
  interpreter::MotionEnd end;
  end.missed = {{1, 0.25}};
  end.status = interpreter::MotionStatus::livelock;
  end.period = 2;
  end.tries = 9;
  end.accepted = 5;
  end.rejected.at_goal = 1;
  end.rejected.hit = 3;
  end.residual = {{1, 2.5}};
  end.position_error = 0.25;
  end.orientation_error = 1.5;
  end.q = {0, 10, 20, 0};
  end.variables = {{"height", 8}};
  end.time = 5 * kSecond;
  end.message = "livelock: again";
  end.span = kLine3;
  writer.motion_end(end);
  end = {};
  end.reached = true;
  end.q = {0, 10, 20, 0};
  writer.motion_end(end);
}

}  // namespace

interpreter::PlanModel rich_plan() {
  interpreter::PlanModel plan = crane_plan();
  auto mesh = std::make_shared<geometry::TriangleMesh>();
  mesh->vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh->triangles = {{0, 1, 2}};
  plan.components.push_back(box_component("slab", {2, 1, 3}, math::translation(1, 2, 3)));
  auto& shapes = plan.components.back().shapes;
  shapes.push_back({geometry::Mesh{"slab.stl", mesh}, math::Pose::Identity()});
  shapes.push_back({geometry::Cylinder{1, 2, 3}, math::rotation_z_deg(30)});
  shapes.push_back({geometry::Sphere{{1, 2, 3}, 4}, math::Pose::Identity()});
  shapes.push_back({geometry::Capsule{{1, 2, 3}, {4, 5, 6}, 7}, math::Pose::Identity()});
  shapes.push_back({geometry::Prism{1, 2, {{0, 0}, {1, 0}, {0, 1}}}, math::Pose::Identity()});
  plan.tasks.push_back(move_task("set_slab", 0, math::translation(4, 5, 6)));
  interpreter::TaskSpec& task = plan.tasks.back();
  task.hook = interpreter::WorkSpec{240, -1, {}};
  task.adjust = interpreter::WorkSpec{60, -1, {}, true};
  task.takes = {{60, -1, {}}};
  task.within.length = 0.01;
  task.within.values = {{1, 0.5}};
  task.remove = {0};
  task.zones = {shapes.front()};
  task.situations = {"safety"};
  task.via = {{{{0, 5.0}}, {}, {}}};
  plan.start_at = schedule::CivilTime{{2026, 11, 23}, 7 * 60};
  plan.calendars.push_back(
      {{"site", {{0, 4, {{420, 720}, {780, 960}}}}, {{2026, 12, 25}}, true}, {}});
  plan.components.back().attributes = {{"storey", "2"}};
  task.attributes = {{"fire", "60 min"}};
  plan.site = {shapes.front()};
  interpreter::MovingSpec& gate = plan.movings.emplace_back();
  gate.name = "gate";
  gate.shapes = gate.overhead = {shapes.front()};
  gate.timetable.repeat = true;
  gate.timetable.places.push_back({0, math::Pose::Identity()});
  gate.timetable.places.push_back({kSecond, math::translation(1, 0, 0)});
  return plan;
}

std::string written_header(const interpreter::PlanModel& plan) {
  return trace::header_line(plan, numbered_lines(), trace::TraceDetail::steps);
}

std::vector<std::string> written_records() {
  Lines lines;
  const interpreter::PlanModel plan = rich_plan();
  const interpreter::SourceMap sources = numbered_lines();
  trace::TraceWriter writer(lines, plan, sources, trace::TraceDetail::steps);
  writer.set_task("set_slab", 0);
  writer.task_start(0);
  writer.task_start(0, "the crane is free", "set_wall", "crane", {{0, 20}, {1, 8.5}});
  writer.goal(1, 2);
  writer.set("height", 2.5, kLine3);
  writer.enter(interpreter::LoopKind::cycle, kLine3);
  writer.exit(interpreter::LoopKind::chain, kLine3, true, 4);
  writer.which("when", kLine3);
  write_attempts(writer);
  writer.wait(7, kSecond, kLine3);
  writer.work("hook", "riggers", kSecond, 3 * kSecond, kSecond + 1);
  writer.pause("crew", "riggers", kSecond, 9 * kSecond);
  writer.attach("slab", math::translation(1, 2, 3), kSecond);
  writer.detach("slab", math::rotation_z_deg(90), 2 * kSecond, kSecond);
  writer.remove("slab", 3 * kSecond);
  writer.soil("slab", 1500, {{3, -20}, {7, 0}}, kSecond, 3 * kSecond);
  write_ends(writer);
  writer.task_end(2'500'000'000, "not reached", "a \"b\"", trace::TruckTimes{1.5, {2, 0.25}});
  writer.stop(2 * kSecond);
  writer.think({321, 3 * kSecond});
  writer.foreseen({"digger", 2.3, {1, 2}, {{0, 0, 1, 0, 1, 1.5}, {2, 2, 3, 2, 3, 3, 2, 3}}},
                  kSecond);
  guides::PlanReport report;
  report.way = {{1, 2}, {3, 4.5}};
  report.metrics = {0.5, 2.5, 12};
  report.events = {"hit at (1.00, 2.00) by wall"};
  report.tree = {{{0, 0, 0, 0}, {0, 10, 0, 0}}};
  interpreter::GuidePlan guide;
  guide.name = "way";
  guide.kind = "rrt";
  guide.seed = 7;
  guide.report = &report;
  guide.forbidden = [] {
    guides::ForbiddenGrid grid;
    grid.parameters = {0, 2, 1};
    grid.low = {0, -1.5};
    grid.high = {10, 1.5};
    grid.cells = {2, 1};
    grid.layers = {0, 90};
    grid.q = {5, 10, 20, 0};
    grid.blocked = {true, false, false, true};
    return std::optional(grid);
  };
  writer.guide(guide);
  guide.forbidden = nullptr;
  report = {};
  report.outcome = guides::PlanReport::Outcome::out_of_nodes;
  guide.cause = "no way found";
  writer.guide(guide);
  writer.way_point(1, 2);
  writer.turn("slab", -90, math::translation(1, 2, 3), kSecond, 2 * kSecond,
              interpreter::HitPair{"slab", "wall"});
  writer.cold_joint({{0, 1.5}, {4, 1.5}, 95 * 60 * kSecond, kSecond, 5701 * kSecond},
                    6000 * kSecond);
  writer.set_task("", -1);
  writer.moving("gate", "crane.hook", kSecond, 3 * kSecond);
  writer.breakdown({"crane", "set", kSecond, 2 * kSecond, 3 * kSecond, 4 * kSecond, 7 * kSecond});
  writer.lost_days("site", 5, {"2026-03-04", "2026-03-09"}, 9 * kSecond);
  return lines.lines;
}

}  // namespace rubicon::test
