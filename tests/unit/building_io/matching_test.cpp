#include "src/exchange/building_io/matching.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/building_io/building_support.hpp"

namespace rubicon::building_io {
namespace {

using test::element_at;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Joined {
  Matching matching;
  std::vector<std::string> said;
};

Joined join(const std::vector<Element>& elements, const std::string& rules,
            const std::vector<std::string>& tasks) {
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  const MatchFile match = read_match_file(sources, sources.add("a.match", rules), diagnostics);
  Joined result;
  result.matching = match_elements(elements, match, test::schedule_of(tasks), diagnostics);
  result.said = test::said(diagnostics, sources);
  return result;
}

/// The names of the elements of an activity in their order.
std::vector<std::string> order(const std::vector<Element>& elements, const Activity& activity) {
  std::vector<std::string> names;
  for (const Activity::Move& move : activity.moves) names.push_back(elements[move.element].name);
  return names;
}

TEST(Matching, TheFirstRuleThatFitsCounts) {
  const std::vector<Element> elements = {
      element_at("Ground", "IfcSlab", "joint", {0, 0, 0}),
      element_at("Ground", "IfcSlab", "slab", {1, 0, 0}),
      element_at("First", "IfcSlab", "slab", {2, 0, 3}),
      element_at("Ground", "IfcWallStandardCase", "wall", {3, 0, 0}),
      element_at("Ground", "IfcDoor", "door", {4, 0, 0})};
  const Joined joined = join(elements,
                             "name \"joint\" -> leave out;\n"
                             "storey \"ground\" type IfcSlab -> task \"Floor\";\n"
                             "type IfcSlab -> task \"Floor 1\";\n"
                             "type IfcWall* -> stands;\n",
                             {"Dig", "Floor", "Floor 1"});
  EXPECT_THAT(joined.said, IsEmpty());
  const Matching& matching = joined.matching;
  ASSERT_EQ(matching.activities.size(), 2U);
  EXPECT_EQ(matching.activities[0].plan_name, "floor");
  EXPECT_EQ(matching.activities[0].moves[0].element, 1U);
  EXPECT_EQ(matching.activities[1].plan_name, "floor_1");
  EXPECT_EQ(matching.activities[1].moves[0].element, 2U);
  EXPECT_THAT(matching.left_out, ElementsAre(0U));
  EXPECT_THAT(matching.standing, ElementsAre(3U));
  EXPECT_THAT(matching.unmatched, ElementsAre(4U));
  EXPECT_THAT(matching.idle_tasks, ElementsAre(0U));
}

TEST(Matching, LowerOnesComeFirstThenAlongTheLongerSide) {
  const std::vector<Element> elements = {
      element_at("", "IfcWall", "high", {0, 0, 3}), element_at("", "IfcWall", "far", {0, 20, 0}),
      element_at("", "IfcWall", "near", {5, 1, 0}),
      element_at("", "IfcWall", "near, nearly as low", {1, 1, 0.02}),
      element_at("", "IfcBeam", "beam", {0, 0, -5})};
  const Joined joined = join(elements, "type IfcWall -> task a; -> task a;", {"a"});
  ASSERT_EQ(joined.matching.activities.size(), 1U);
  // The rule of the walls stands first, so they come before the beam.
  EXPECT_THAT(order(elements, joined.matching.activities[0]),
              ElementsAre("near, nearly as low", "near", "far", "high", "beam"));
}

TEST(Matching, GuidFileAndStoreyAreConditionsToo) {
  std::vector<Element> elements = {element_at("A", "T", "n", {0, 0, 0}),
                                   element_at("A", "T", "n", {0, 0, 0})};
  elements[1].guid = "3N$0aQqvnCVgLMGYDxwc9U";
  elements[1].model = "roof.ifc";
  const auto matched = [&](const std::string& condition) {
    return join(elements, condition + " -> task a;", {"a"}).matching.unmatched;
  };
  EXPECT_THAT(matched("guid \"3N$0aQqvnCVgLMGYDxwc9U\""), ElementsAre(0U));
  EXPECT_THAT(matched("guid \"3n$0aQqvnCVgLMGYDxwc9U\""), ElementsAre(0U, 1U));
  EXPECT_THAT(matched("file \"roof*\""), ElementsAre(0U));
  EXPECT_THAT(matched("storey \"B\""), ElementsAre(0U, 1U));
}

TEST(Matching, ATaskThatIsNotThereOrOneOfSeveralIsAMistake) {
  const std::vector<Element> elements = {element_at("", "IfcWall", "w", {0, 0, 0})};
  const std::vector<std::string> tasks = {"Walls", "Walls", "Roof", " Stairs "};
  EXPECT_THAT(
      join(elements, "-> task \"Rooof\";", tasks).said,
      ElementsAre(HasSubstr("I13 1:9 the schedule has no task 'Rooof' | did you mean Roof?")));
  EXPECT_THAT(
      join(elements, "-> task \"Walls\";", tasks).said,
      ElementsAre(HasSubstr("2 tasks of the schedule are called 'Walls' | name one as it is "
                            "in the plan, without marks: walls, walls_2")));
  EXPECT_THAT(join(elements, "-> task walls_2;", tasks).said, IsEmpty());
  EXPECT_THAT(join(elements, "-> task \"Stairs\";", tasks).said, IsEmpty());
}

}  // namespace
}  // namespace rubicon::building_io
