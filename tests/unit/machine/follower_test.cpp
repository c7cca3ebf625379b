#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/random.hpp"
#include "src/motion/travel/travel.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/support/scripted_run.hpp"

/// The followers of robots/explorer beside the methods of src/motion/travel, which walk exactly.
namespace rubicon::test {
namespace {

using travel::Method;
using travel::Vec2;
using travel::Verdict;

constexpr double kStep = 0.25;

struct Box {
  double x0, y0, x1, y1;
};

/// A point among boxes in the plan view. Along a border it may go.
class BoxWorld : public PredicateWorld {
 public:
  explicit BoxWorld(std::vector<Box> boxes) : boxes_(std::move(boxes)) {}

  std::optional<interpreter::HitPair> propose(const interpreter::MotionStep& step) override {
    return refusal(step);
  }
  std::optional<interpreter::HitPair> refusal(const interpreter::MotionStep& step) const override {
    const Vec2 from(step.q_from[0], step.q_from[1]);
    const Vec2 way = Vec2(step.q_to[0], step.q_to[1]) - from;
    if (way.norm() == 0 || free_along(from, way, 1) >= 1) return std::nullopt;
    return interpreter::HitPair{"explorer.disc", "box"};
  }
  double free_distance(std::span<const double> q, double heading_deg, double range) const override {
    return free_along({q[0], q[1]}, {math::cos_deg(heading_deg), math::sin_deg(heading_deg)},
                      range);
  }
  std::optional<interpreter::HitPair> blocked_at(std::span<const double>) const override {
    return std::nullopt;
  }

 private:
  /// How much of `along`, at most `most` times, is free.
  double free_along(const Vec2& from, const Vec2& along, double most) const {
    constexpr double kBorder = 1e-9;
    double free = most;
    for (const Box& box : boxes_) {
      const double low[] = {box.x0 + kBorder, box.y0 + kBorder};
      const double high[] = {box.x1 - kBorder, box.y1 - kBorder};
      double in = 0;
      double out = most;
      for (int i = 0; i < 2; ++i) {
        if (along[i] == 0) {
          if (from[i] <= low[i] || from[i] >= high[i]) out = -1;
          continue;
        }
        const double a = (low[i] - from[i]) / along[i];
        const double b = (high[i] - from[i]) / along[i];
        in = std::max(in, std::min(a, b));
        out = std::min(out, std::max(a, b));
      }
      if (in < out) free = std::min(free, in);
    }
    return free;
  }

  std::vector<Box> boxes_;
};

std::string text_of(const std::string& path) {
  std::ifstream file(source_dir() + "/" + path);
  EXPECT_TRUE(file) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

Scenario follower(const std::string& method) {
  std::string robot = text_of("robots/explorer/explorer_" + method + ".robot");
  const std::string file = "\"" + method + ".motion\"";
  robot.replace(robot.find(file), file.size(), "\"s.motion\"");
  return set_up(robot, text_of("robots/explorer/" + method + ".motion"));
}

struct Case {
  std::vector<Box> boxes;
  Vec2 start;
  Vec2 goal;
};

bool is_free(const std::vector<Box>& boxes, const Vec2& p) {
  return std::none_of(boxes.begin(), boxes.end(), [&](const Box& box) {
    return p.x() >= box.x0 && p.x() <= box.x1 && p.y() >= box.y0 && p.y() <= box.y1;
  });
}

/// Boxes on whole metres, touching, overlapping and aligned; each third world has a trap before the
/// goal, each seventh a goal that is shut in. Start and goal lie on no multiple of a step.
Case random_case(std::uint64_t seed) {
  math::Random random(seed);
  const auto whole = [&](int low, int high) {
    return low + static_cast<int>(random.uniform() * (high - low + 1));
  };
  Case made;
  made.start = {-3.37, whole(2, 17) + 0.41};
  made.goal = {whole(21, 24) + 0.43, whole(3, 16) + 0.59};
  const auto add = [&](double x, double y, double width, double height) {
    made.boxes.push_back({x, y, x + width, y + height});
  };
  for (int i = whole(3, 9); i > 0; --i) {  // one draw a line: arguments have no order
    const int x = whole(0, 16);
    const int y = whole(0, 16);
    const int width = whole(1, 5);
    const int height = whole(1, 5);
    add(x, y, width, height);
  }
  const double x = std::floor(made.goal.x());
  const double y = std::floor(made.goal.y());
  if (seed % 3 == 0) {  // open towards the start
    add(x - 9, y - 4, 7, 1);
    add(x - 9, y + 4, 7, 1);
    add(x - 3, y - 4, 1, 9);
  }
  if (seed % 7 == 0) {
    add(x - 2, y - 2, 1, 5);
    add(x + 2, y - 2, 1, 5);
    add(x - 2, y - 2, 5, 1);
    add(x - 2, y + 2, 5, 1);
  }
  return is_free(made.boxes, made.goal) ? made : random_case(seed + 100'003);
}

struct Followed {
  std::string verdict;  ///< as of the native method: reached, unreachable, limit
  double length = 0;
  std::vector<Vec2> legs;  ///< where it set out for the goal
  interpreter::MotionEnd end;
};

class WayTaken : public EventLog {
 public:
  explicit WayTaken(const Vec2& start) : place(start) {}

  Vec2 place;
  double metres = 0;
  std::vector<Vec2> legs;
  void attempt(const interpreter::Attempt& attempt) override {
    const Vec2 before = std::exchange(place, Vec2(attempt.q[0], attempt.q[1]));
    metres += (place - before).norm();
  }
  void set(const std::string& variable, double value, interpreter::Span) override {
    if (variable == "mode" && value == 0) legs.push_back(place);
  }
};

Followed follow_with(const Scenario& scenario, const Case& made) {
  BoxWorld world(made.boxes);
  interpreter::MotionTask task = scenario.task({{"x", made.start.x()}, {"y", made.start.y()}},
                                               {{"x", made.goal.x()}, {"y", made.goal.y()}});
  WayTaken way(made.start);
  Followed ran;
  ran.end = run(scenario, task, world, &way);
  ran.length = way.metres;
  ran.legs = std::move(way.legs);
  ran.verdict = ran.end.reached                                            ? "reached"
                : ran.end.message.find("unreachable") != std::string::npos ? "unreachable"
                                                                           : "limit";
  return ran;
}

travel::TravelResult walk(Method method, const Case& made) {
  travel::TravelQuery query;
  for (const Box& b : made.boxes) {
    query.obstacles.push_back(
        {"box", {{{b.x0, b.y0}, {b.x1, b.y0}, {b.x1, b.y1}, {b.x0, b.y1}}}, {}});
  }
  query.start = made.start;
  query.destination = made.goal;
  travel::TravelSettings settings;
  settings.most_length = 5000;
  return travel::travel(method, query, settings);
}

/// 200 worlds where RUBICON_FOLLOWER_CASES does not say how many.
std::vector<std::uint64_t> worlds() {
  const char* text = std::getenv("RUBICON_FOLLOWER_CASES");
  std::vector<std::uint64_t> seeds(text ? std::strtoull(text, nullptr, 10) : cases(200));
  std::iota(seeds.begin(), seeds.end(), 1);
  return seeds;
}

/// Whether the exact walker ends as the follower did when it sets out from one of the places from
/// which the follower did: up to a step beside its own.
bool is_by_stepping(Method method, Case made, const Followed& ran) {
  return std::any_of(ran.legs.begin(), ran.legs.end(), [&](const Vec2& place) {
    made.start = place;
    return name_of(walk(method, made).verdict) == ran.verdict;
  });
}

struct Comparison {
  int agree = 0;
  int by_stepping = 0;
  int reached = 0;
  int unreachable = 0;
  int limit = 0;
  double native = 0;    ///< m, where both reach
  double scripted = 0;  ///< likewise
  double most = 0;      ///< scripted to native
  std::string differ;
};

Comparison compare(const std::string& name, Method method,
                   const std::vector<std::uint64_t>& seeds = worlds()) {
  const Scenario scenario = follower(name);
  Comparison result;
  for (const std::uint64_t seed : seeds) {
    const Case made = random_case(seed);
    const travel::TravelResult native = walk(method, made);
    const Followed ran = follow_with(scenario, made);
    const std::string verdict(name_of(native.verdict));
    // The way of simple decides whether it ends; of all others the verdict does not hang on the
    // way.
    if (ran.verdict != verdict && method == Method::kSimple && is_by_stepping(method, made, ran)) {
      ++result.by_stepping;
      continue;
    }
    if (ran.verdict != verdict) {
      result.differ +=
          fmt::format("world {}: native {}, script {} ({}: {})\n", seed, verdict, ran.verdict,
                      interpreter::name_of(ran.end.status), ran.end.message);
      continue;
    }
    ++result.agree;
    if (native.verdict == Verdict::kUnreachable) ++result.unreachable;
    if (native.verdict == Verdict::kLimit) ++result.limit;
    if (native.verdict != Verdict::kReached) continue;
    ++result.reached;
    result.native += native.length;
    result.scripted += ran.length;
    result.most = std::max(result.most, ran.length / native.length);
  }
  testing::Test::RecordProperty("agree", result.agree);
  testing::Test::RecordProperty("by_stepping", result.by_stepping);
  testing::Test::RecordProperty("reached", result.reached);
  testing::Test::RecordProperty("unreachable", result.unreachable);
  testing::Test::RecordProperty("limit", result.limit);
  if (result.reached == 0) return result;
  testing::Test::RecordProperty("length", fmt::format("{:.4f}", result.scripted / result.native));
  testing::Test::RecordProperty("most", fmt::format("{:.4f}", result.most));
  return result;
}

TEST(Follower, Bug2AgreesWithTheExactWalker) {
  const Comparison result = compare("bug2", Method::kBug2);
  EXPECT_EQ(result.differ, "");
}

TEST(Follower, TangentAgreesWithTheExactWalker) {
  const Comparison result = compare("tangent", Method::kTangent);
  EXPECT_EQ(result.differ, "");
}

TEST(Follower, AceAgreesWithTheExactWalker) {
  const Comparison result = compare("ace", Method::kAce);
  EXPECT_EQ(result.differ, "");
}

TEST(Follower, SimpleAgreesWithTheExactWalker) {
  const Comparison result = compare("simple", Method::kSimple);
  EXPECT_EQ(result.differ, "");
  EXPECT_LE(100 * result.by_stepping, result.agree);
}

/// Beside the line that it left, a follower meets what the line passes by 3 cm.
TEST(Follower, Bug2BeginsANewLineWhereItLeaves) {
  EXPECT_EQ(compare("bug2", Method::kBug2, {128, 1174, 1733, 2059}).differ, "");
}

/// The goal is shut in, and the robot always comes back to where it was stopped before.
TEST(Follower, TangentAndAceEndWhereTheyGoInCircles) {
  EXPECT_EQ(compare("tangent", Method::kTangent, {1603}).unreachable, 1);
  EXPECT_EQ(compare("ace", Method::kAce, {1603}).unreachable, 1);
}

/// The exact walker passes the corner of a box by 7 mm, the follower meets that box.
TEST(Follower, SimpleGoesInCirclesFromWhereItLeft) {
  EXPECT_EQ(compare("simple", Method::kSimple, {1111}).by_stepping, 1);
}

/// Pledge seeks no place: where the native one gets out, the script ends, short of its goal.
TEST(Follower, PledgeAgreesWithTheExactWalker) {
  const Scenario scenario = follower("pledge");
  int out = 0;
  for (const std::uint64_t seed : worlds()) {
    Case made = random_case(seed);
    if (seed % 7 == 0) std::swap(made.start, made.goal);  // begins shut in
    const travel::TravelResult native = walk(Method::kPledge, made);
    const Followed ran = follow_with(scenario, made);
    const bool escapes = native.verdict == Verdict::kReached;
    out += escapes;
    EXPECT_EQ(ran.end.status == interpreter::MotionStatus::done, escapes)
        << "world " << seed << ": " << ran.end.message;
  }
  RecordProperty("out", out);
}

/// Round a box of 20 m by 10 m: its perimeter and at most a step a corner more.
TEST(Follower, TheWallIsFollowedOnceRound) {
  const Scenario scenario = follower("follow_wall");
  const Followed ran = follow_with(scenario, {{{5, -10, 25, 0}}, {0, -4.1}, {40, -4.1}});
  EXPECT_EQ(ran.end.status, interpreter::MotionStatus::done);
  EXPECT_NEAR(ran.length, 5 + 60, 4 * 2 * kStep + kStep);
}

}  // namespace
}  // namespace rubicon::test
