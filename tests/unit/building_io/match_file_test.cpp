#include "src/exchange/building_io/match_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/unit/building_io/building_support.hpp"

namespace rubicon::building_io {
namespace {

using test::read_match;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kWhole = R"(# a remark
plan {
  site box(-9, -9, -1, 9, 9, 0);
  calendar site { mon-fri 07:00-16:00; }
  robot crane "crane.robot" at trans(1, 2, 0) { start theta 0; calendar site; }
  crew riggers { size 2; }
  crew erectors;
}
stock yard box(-30, -10, 0, -10, 10 m, 4) stack 6 gap 40 cm;
stock box(0, 20, 0, 10, 40, 4);
by crane;
hook 3 min by riggers;
type IfcSlab storey "Ground*" -> task "Lay floor" { density 1500; stock yard; unlinked; priority 2; }
adjust 4 min by erectors;
guid "3n$0aQqvnCVgLMGYDxwc9U" -> stands;
name "*joint*" file "a.ifc" -> leave out;
type IfcWall* -> task walls_2 { adjust 9 min by erectors; mass 1.2 t; grip trans(0, 0, 1.5); };
-> task "The rest";
)";

TEST(MatchFile, EverythingThatCanBeSaid) {
  const test::ReadMatch read = read_match(kWhole);
  EXPECT_THAT(read.said, IsEmpty());
  const MatchFile& match = read.match;
  EXPECT_THAT(match.plan_items, HasSubstr("robot crane \"crane.robot\""));
  EXPECT_THAT(match.workers, ElementsAre("crane", "erectors", "riggers"));
  EXPECT_THAT(match.calendars, ElementsAre("site"));
  ASSERT_EQ(match.stocks.size(), 2U);
  EXPECT_EQ(match.stocks[0].name, "yard");
  EXPECT_EQ(match.stocks[0].stack, 6);
  EXPECT_DOUBLE_EQ(match.stocks[0].gap, 0.4);
  EXPECT_EQ(match.stocks[0].box.lower, geometry::Vec3(-30, -10, 0));
  EXPECT_EQ(match.stocks[0].box.upper, geometry::Vec3(-10, 10, 4));
  EXPECT_EQ(match.stocks[1].name, "");
  ASSERT_EQ(match.rules.size(), 5U);
  const MatchRule& floor = match.rules[0];
  ASSERT_EQ(floor.conditions.size(), 2U);
  EXPECT_EQ(floor.conditions[0].field, MatchRule::Condition::Field::type);
  EXPECT_EQ(floor.conditions[0].pattern, "IfcSlab");
  EXPECT_EQ(floor.task, "Lay floor");
  EXPECT_FALSE(floor.in_plan);
  EXPECT_EQ(floor.terms.by, "crane");
  EXPECT_EQ(floor.terms.hook, "3 min by riggers");
  EXPECT_EQ(floor.terms.adjust, "");  // said behind it
  EXPECT_EQ(floor.terms.density, 1500);
  EXPECT_EQ(floor.terms.stock, "yard");
  EXPECT_EQ(floor.terms.priority, "2");
  EXPECT_TRUE(floor.terms.unlinked);
  EXPECT_EQ(match.rules[1].action, MatchRule::Action::stands);
  EXPECT_EQ(match.rules[2].action, MatchRule::Action::leave_out);
  const MatchRule& walls = match.rules[3];
  EXPECT_EQ(walls.conditions[0].pattern, "IfcWall*");
  EXPECT_EQ(walls.task, "walls_2");
  EXPECT_TRUE(walls.in_plan);
  EXPECT_EQ(walls.terms.adjust, "9 min by erectors");
  EXPECT_EQ(walls.terms.mass, "1.2 t");
  EXPECT_EQ(walls.terms.grip, "trans(0, 0, 1.5)");
  EXPECT_FALSE(walls.terms.unlinked);
  EXPECT_THAT(match.rules[4].conditions, IsEmpty());
  EXPECT_EQ(match.rules[4].terms.adjust, "4 min by erectors");
}

void expect_mistake(const std::string& text, const std::string& words) {
  const test::ReadMatch read = read_match(text);
  EXPECT_FALSE(read.said.empty()) << text;
  if (!read.said.empty()) {
    EXPECT_THAT(read.said.front(), HasSubstr(words)) << text;
  }
}

TEST(MatchFile, MistakesAreToldAtTheirPlace) {
  expect_mistake("hello;", "I12 1:1 expected a rule such as");
  expect_mistake("type -> task a;", "I12 1:6 expected a pattern");
  expect_mistake("name IfcWall -> task a;", "I12 1:6 expected a pattern");
  expect_mistake("name \"a\" task a;", "I12 1:10 expected ->, found 'task'");
  expect_mistake("name \"a\" -> walk;", "I12 1:13 expected task, stands or leave out");
  expect_mistake("name \"a\" -> leave;", "expected 'out' after leave");
  expect_mistake("name \"a\" -> task;", "expected the name of a task");
  expect_mistake("name \"a\" -> task b", "expected ';' after a rule, found the end");
  expect_mistake("name \"a\" -> task b { colour red; }", "expected by, hook, adjust");
  expect_mistake("name \"a\" -> task b { stock 7; }", "expected the name of a stock area");
  expect_mistake("name \"a\n-> task b;", "expected '\"' at the end of this text");
  expect_mistake("density -5;", "expected a density above 0");
  expect_mistake("by ;", "expected something before ';'");
  expect_mistake("by crane", "expected ';' after by, found the end");
  expect_mistake("plan { robot a;", "I12 1:6 this block is not closed");
  expect_mistake("plan robot;", "expected '{' after plan");
  expect_mistake("stock sphere(1);", "expected box(");
  expect_mistake("stock box(1, 2, 3);", "expected ',' between numbers");
  expect_mistake("stock box(1, 2, 3, x);", "expected a number");
  expect_mistake("stock box(1, 2, 3, 0, 5, 6);", "this box has no extent");
  expect_mistake("stock box(0, 0, 0, 1e9, 5, 6);", "expected a length below 1000 km");
  expect_mistake("stock box(0, 0, 0, 1, 5, 6) stack 0;", "expected a count from 1 to 100");
  expect_mistake("stock box(0, 0, 0, 1, 5, 6) gap -1;", "expected a gap of 0 or more");
  expect_mistake("stock box(0, 0, 0, 9, 9, 9); stock box(8, 8, 8, 20, 20, 20);",
                 "I12 1:36 this stock area lies in another one");
}

TEST(MatchFile, AfterAMistakeTheRestIsRead) {
  const test::ReadMatch read = read_match(
      "name a -> task b { hook 1 min; };\nby crane;\nname \"x\" -> nothing;\n"
      "name \"y\" -> task c;\n");
  EXPECT_EQ(read.said.size(), 2U);
  ASSERT_EQ(read.match.rules.size(), 1U);
  EXPECT_EQ(read.match.rules[0].terms.by, "crane");
}

TEST(MatchFile, SmokeOfAnyText) {
  std::mt19937 random(11);
  const std::string whole = kWhole;
  for (int round = 0; round < 3000; ++round) {
    std::string text = whole;
    for (unsigned k = 0; k < 1 + random() % 4; ++k) {
      const std::size_t at = random() % text.size();
      switch (random() % 3) {
        case 0:
          text[at] = "{}();\"->,#\n\xC3x7"[random() % 14];
          break;
        case 1:
          text.erase(at, random() % 30);
          break;
        default:
          text.insert(at, text.substr(random() % text.size(), random() % 30));
          break;
      }
    }
    read_match(text);
  }
  read_match(whole.substr(0, whole.size() / 2));
  read_match("");
  read_match(std::string(100000, '{'));
}

}  // namespace
}  // namespace rubicon::building_io
