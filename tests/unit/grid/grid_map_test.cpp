#include "src/fleets/grid/grid_map.hpp"

#include <gtest/gtest.h>

#include "src/fleets/grid/grid_problem.hpp"

namespace rubicon::grid {
namespace {

const char* const kMap = "type octile\nheight 2\nwidth 3\nmap\n.@.\n...\n";

GridMap map_of(const std::string& text) { return std::get<GridMap>(read_map(text)); }

std::string map_fault(const std::string& text) {
  const auto map = read_map(text);
  const auto* fault = std::get_if<TextFault>(&map);
  if (fault == nullptr) return "";
  EXPECT_LE(fault->begin, fault->end);
  EXPECT_LE(fault->end, text.size());
  return fault->message;
}

std::string scenario_fault(const std::string& text) {
  const auto trips = read_scenario(text, map_of(kMap), 100);
  const auto* fault = std::get_if<TextFault>(&trips);
  return fault == nullptr ? "" : fault->message;
}

TEST(GridMap, ReadsRowsFromTheTop) {
  const GridMap map = map_of(kMap);
  EXPECT_EQ(map.columns, 3);
  EXPECT_EQ(map.rows, 2);
  EXPECT_FALSE(map.is_open({1, 0}));
  EXPECT_TRUE(map.is_open({1, 1}));
  EXPECT_FALSE(map.is_open({3, 0}));
  EXPECT_FALSE(map.is_open({0, -1}));
}

TEST(GridMap, ReadsWindowsLineEnds) {
  EXPECT_EQ(map_of("type octile\r\nheight 1\r\nwidth 2\r\nmap\r\n.T\r\n").open,
            (std::vector<std::uint8_t>{1, 0}));
}

TEST(GridMap, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(map_fault(""), "the map ends before its rows");
  EXPECT_EQ(map_fault("type octile\nheight 2\nwidth 3\nmap\n...\n"),
            "the map ends after 1 of 2 rows");
  EXPECT_EQ(map_fault("type octile\nheight 2\nwidth 3\nmap\n...\n..\n"),
            "row 1 has 2 cells; expected 3");
  EXPECT_EQ(map_fault("type octile\nheight 1\nwidth 3\nmap\n.x.\n"), "unknown terrain 'x'");
  EXPECT_EQ(map_fault("type octile\nheight 1000000000\nwidth 1000000000\nmap\n"),
            "the height of a map is a whole number of 1 to 4000000, found '1000000000'");
  EXPECT_EQ(map_fault("type octile\nheight 4000000\nwidth 4000000\nmap\n"),
            "a map of 4000000 x 4000000 cells; expected up to 4000000 cells");
  EXPECT_EQ(map_fault("type octile\nmap\n"), "map comes after height and width");
  EXPECT_EQ(map_fault("type octile\nheight -3\n"),
            "the height of a map is a whole number of 1 to 4000000, found '-3'");
  EXPECT_EQ(map_fault("hello"), "expected 'type octile', found 'hello'");
  EXPECT_EQ(map_fault(std::string(kMap) + "...\n"), "the map has 2 rows, and more follow");
}

TEST(GridMap, EveryBeginningOfAMapIsRefused) {
  const std::string text = "type octile\nheight 2\nwidth 3\nmap\n.@.\n...";
  for (std::size_t size = 0; size < text.size(); ++size) {
    EXPECT_NE(map_fault(text.substr(0, size)), "") << size;
  }
  EXPECT_EQ(map_fault(text), "");
}

TEST(Scenario, ReadsTripsUpToTheNumberAsked) {
  const std::string text = "version 1\n0\tm.map\t3\t2\t0\t0\t2\t0\t4\n\n0 m.map 3 2 2 0 0 0 4.5\n";
  const auto trips = std::get<std::vector<Trip>>(read_scenario(text, map_of(kMap), 100));
  ASSERT_EQ(trips.size(), 2U);
  EXPECT_EQ(trips[1].from, (Cell{2, 0}));
  EXPECT_EQ(trips[1].to, (Cell{0, 0}));
  EXPECT_EQ(text.substr(trips[1].begin, trips[1].end - trips[1].begin), "0 m.map 3 2 2 0 0 0 4.5");
  EXPECT_EQ(std::get<0>(read_scenario(text, map_of(kMap), 1)).size(), 1U);
}

TEST(Scenario, SaysWhatIsWrong) {
  EXPECT_EQ(scenario_fault(""), "expected 'version 1', found ''");
  EXPECT_EQ(scenario_fault("version 1\n0 m.map 3 2 0 0"), "expected the goal x, found ''");
  EXPECT_EQ(scenario_fault("version 1\n0 m.map 3 2 0 0 1e9 0 4"),
            "expected the goal x, found '1e9'");
  EXPECT_EQ(scenario_fault("version 1\n0 m.map 5 5 0 0 1 0 4"),
            "a trip on a map of 5 x 5 cells; this one has 3 x 2");
  EXPECT_EQ(scenario_fault("version 1\n0 m.map 3 2 0 0 1 99999999999999999999 4"),
            "expected the goal y, found '99999999999999999999'");
}

TEST(GridProblem, SaysWhatIsWrongWithAgents) {
  GridProblem problem{map_of("type octile\nheight 3\nwidth 3\nmap\n...\n@@@\n...\n"), {}};
  problem.agents = {{"a", {0, 0}, {2, 0}}, {"b", {0, 1}, {2, 2}}, {"c", {1, 0}, {2, 0}},
                    {"d", {2, 2}, {3, 2}}, {"e", {2, 0}, {0, 2}}, {"f", {0, 0}, {1, 0}}};
  std::vector<std::string> messages;
  for (const GridFault& fault : faults_of(problem)) messages.push_back(fault.message);
  EXPECT_EQ(messages, (std::vector<std::string>{
                          "the start (0, 1) of agent 'b' is on a wall",
                          "agents 'a' and 'c' have the same goal (2, 0)",
                          "the goal (3, 2) of agent 'd' is outside of the map of 3 x 3",
                          "agent 'e' cannot reach (0, 2) from (2, 0): walls lie between",
                          "agents 'a' and 'f' have the same start (0, 0)"}));
}

}  // namespace
}  // namespace rubicon::grid
