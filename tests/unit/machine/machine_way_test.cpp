#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/scripted_run.hpp"

/// Places on the way, and what is asked of them: here, back_at, turned, off_course, crossed,
/// circled, moving; and stop(unreachable).
namespace rubicon::test {
namespace {

using interpreter::MotionEnd;
using interpreter::MotionStatus;
using testing::HasSubstr;

const char* const kAgent = R"(robot agent {
  time_step 1;
  sensor 10;
  body truck {
    param x step(1) range(-100, 100);
    param y range(-100, 100);
    param theta cyclic step(90);
    rule theta <- theta + theta_s;
    rule x <- x + x_s * cos(theta) - y_s * sin(theta);
    rule y <- y + x_s * sin(theta) + y_s * cos(theta);
    frame trans(x, y, 0) * rotz(theta);
    shape box(-0.4, -0.4, 0, 0.4, 0.4, 1);
  }
  tool truck;
  behaviour "s.motion";
}
)";

/// Once round a square of 3 m, anticlockwise, from (0, 0); `body` is done before each step.
std::string square(const std::string& body, const std::string& turn = "1") {
  std::string script = "var(begin) = here(); var(n) = 0;\n";
  script += "chain { round } until (var(n) == 12);\n";
  script += "behaviour round {" + body + " move_dir(x, 1); var(n) = var(n) + 1;";
  script += "which { when (var(n) == 3 or var(n) == 6 or var(n) == 9 or var(n) == 12): ";
  script += "move_dir(theta, " + turn + "); default: var(n) = var(n) + 0; }; }\n";
  return script;
}

double variable(const MotionEnd& end, const std::string& name) {
  for (const auto& [variable, value] : end.variables) {
    if (variable == name) return value;
  }
  ADD_FAILURE() << "no variable " << name;
  return 0;
}

MotionEnd run_agent(const std::string& script, PredicateWorld& world, double x = 10, double y = 0) {
  const Scenario setup = set_up(kAgent, script);
  return run(setup, setup.task({}, {{"x", x}, {"y", y}}), world);
}

MotionEnd run_agent(const std::string& script, double x = 10, double y = 0) {
  PredicateWorld world;
  return run_agent(script, world, x, y);
}

std::string as_number(const std::string& condition) {
  return "which { when (" + condition + "): var(v) = 1; default: var(v) = 0; };";
}

TEST(Way, APlaceIsReachedAgainInPlaceAndHeading) {
  // Back after the last quarter turn, not before it, and not at the beginning.
  EXPECT_EQ(variable(run_agent(square("") + as_number("back_at(var(begin))")), "v"), 1);
  EXPECT_EQ(variable(run_agent("var(begin) = here();" + as_number("back_at(var(begin))")), "v"), 0);
  const std::string before = "var(begin) = here(); move_dir(x, 1); move_dir(x, -1);";
  EXPECT_EQ(
      variable(run_agent(before + "move_dir(theta, 1);" + as_number("back_at(var(begin))")), "v"),
      0);
  EXPECT_EQ(variable(run_agent(before + as_number("back_at(var(begin))")), "v"), 1);
}

TEST(Way, TurnsAddUpBeyondAWholeOne) {
  const MotionEnd left = run_agent(square("") + "var(v) = turned(theta, var(begin));");
  EXPECT_NEAR(variable(left, "v"), 360, 1e-9);
  const MotionEnd right = run_agent(square("", "-1") + "var(v) = turned(theta, var(begin));");
  EXPECT_NEAR(variable(right, "v"), -360, 1e-9);
}

TEST(Way, OffCourseKeepsItsWholeTurns) {
  // The goal is far ahead, so its bearing hardly changes while the agent goes round the square.
  const std::string off = "var(v) = off_course(theta, var(begin));";
  EXPECT_NEAR(variable(run_agent(square("") + off, 100, 0), "v"), 360, 1e-6);
  EXPECT_NEAR(variable(run_agent("var(begin) = here(); move_dir(theta, 1);" + off, 100, 0), "v"),
              90, 1e-6);
  // Round the goal: heading and bearing turn alike, and nothing is left.
  EXPECT_NEAR(variable(run_agent(square("") + off, 1.5, 1.5), "v"), -45, 1e-6);
}

TEST(Way, TheLineToTheGoalIsCrossedNearerOnly) {
  const std::string over =
      "var(line) = here(); move_dir(x, 1); move_dir(x, 1); move_dir(theta, 1); move_dir(x, 1);";
  const std::string asked = as_number("crossed(var(line))");
  // On from (2, 1) at 90 degrees: turned back it crosses the x axis at (2, 0) going down to -1.
  const std::string down = "move_dir(theta, 1); move_dir(theta, 1); move_dir(x, 1);";
  EXPECT_EQ(variable(run_agent(over + asked, 10, 0), "v"), 0) << "it only left the line";
  EXPECT_EQ(variable(run_agent(over + down + asked, 10, 0), "v"), 1) << "it ends on it";
  EXPECT_EQ(variable(run_agent(over + down + "move_dir(x, 1);" + asked, 10, 0), "v"), 0);
  EXPECT_EQ(variable(run_agent(over + down + "move_dir(theta, 1);" + asked, 10, 0), "v"), 1)
      << "a turn on the spot is no step away";
  EXPECT_EQ(variable(run_agent(over + down + asked, 1, 0), "v"), 0) << "beyond the goal";
}

TEST(Way, ALoopIsClosedWithItsSense) {
  EXPECT_EQ(variable(run_agent(square("") + "var(v) = circled(var(begin));"), "v"), 0)
      << "the place itself is no part of the way since";
  const std::string from_before = "move_dir(x, 1); move_dir(x, -1);";
  EXPECT_EQ(variable(run_agent("var(b) = here();" + from_before + square("") +
                               "var(v) = circled(var(b));"),
                     "v"),
            1);
  EXPECT_EQ(variable(run_agent("var(b) = here();" + from_before + square("", "-1") +
                               "var(v) = circled(var(b));"),
                     "v"),
            -1);
  EXPECT_EQ(variable(run_agent("var(b) = here(); move_dir(x, 1);" + from_before +
                               "var(v) = circled(var(b));"),
                     "v"),
            0)
      << "there and back encloses nothing";
}

TEST(Way, StopEndsTheMotionAsUnreachable) {
  const MotionEnd end = run_agent(
      "chain { move_dir(x, 1), stop(unreachable) } until (x >= 4); stop(unreachable); "
      "move_dir(x, 1);");
  EXPECT_EQ(end.status, MotionStatus::no_way);
  EXPECT_FALSE(end.reached);
  EXPECT_THAT(end.message, HasSubstr("unreachable"));
  EXPECT_EQ(end.q[0], 4) << "nothing after it is done";

  PredicateWorld wall;
  wall.blocked = [](std::span<const double> q) { return q[0] > 2.5; };
  const MotionEnd stopped =
      run_agent("chain { move_dir(x, 1), stop(unreachable), move_dir(theta, 1) };", wall);
  EXPECT_EQ(stopped.status, MotionStatus::no_way) << "as an element: where control passes it";
  EXPECT_EQ(stopped.q[0], 2);
}

TEST(Way, PlacesBelongToTheStateOfALivelock) {
  // Each round marks anew: the same place, the same way since. That is the state it had.
  const MotionEnd anew = run_agent(
      "var(p) = here(); chain { round } until (x > 50);"
      "behaviour round { var(p) = here(); move_dir(x, 1); move_dir(x, -1); }");
  EXPECT_EQ(anew.status, MotionStatus::livelock);
  EXPECT_EQ(anew.period, 2);
  // Marked once, the way since it grows, and with it what may be asked of it.
  const MotionEnd circling = run_agent(
      "var(p) = here(); chain { round } until (turned(theta, var(p)) > 10);"
      "behaviour round { move_dir(x, 1); move_dir(x, -1); }");
  EXPECT_EQ(circling.status, MotionStatus::circling);
}

TEST(Way, TheStateHasThePlaceAndTheWaySince) {
  const Scenario setup = set_up(
      kAgent, "var(p) = here(); chain { move_dir(x, 1) } until (x >= 6 or back_at(var(p)));");
  PredicateWorld world;
  interpreter::Machine whole(*setup.program, setup.task({}, {{"x", 10}}));
  std::vector<interpreter::Machine> copies;
  do {
    copies.push_back(whole);
  } while (whole.advance(world, nullptr));
  for (interpreter::Machine& copy : copies) {
    const interpreter::Machine twin = copy;
    EXPECT_EQ(twin.state_hash(world), copy.state_hash(world));
    while (copy.advance(world, nullptr)) {
    }
    EXPECT_EQ(copy.end().q, whole.end().q);
    EXPECT_EQ(copy.end().tries, whole.end().tries);
  }
}

TEST(Way, AnythingElseThanAPlaceIsAnError) {
  // The checker does not know what a variable of two kinds holds.
  const MotionEnd end = run_agent(
      "var(p) = here(); var(p) = 1; which { when (back_at(var(p))): wait; default: wait; };");
  EXPECT_EQ(end.status, MotionStatus::error);
}

class MovingWorld : public PredicateWorld {
 public:
  bool is_met_moving(std::span<const double>, double heading_deg, double range) const override {
    return heading_deg == -90 && range == 10;
  }
};

TEST(Way, MovingAsksWhatIsMetAlongTheHeading) {
  MovingWorld world;
  EXPECT_EQ(variable(run_agent(as_number("moving(theta - 90)"), world), "v"), 1);
  EXPECT_EQ(variable(run_agent(as_number("moving(theta)"), world), "v"), 0);
}

}  // namespace
}  // namespace rubicon::test
