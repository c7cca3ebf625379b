#include "src/results/gantt/svg_chart.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <string>

namespace rubicon::gantt {
namespace {

using schedule::kMinute;
using taskplan::Schedule;

Schedule schedule_of(const std::vector<std::string>& names) {
  Schedule schedule;
  schedule.resources.resize(1);
  schedule.resources[0].name = "crane <1>";
  schedule.resources[0].robot = true;
  for (const std::string& name : names) {
    taskplan::TaskOutcome task;
    task.task = name;
    task.robot = "crane <1>";
    task.start = schedule.process_time;
    task.duration = 5 * kMinute;
    schedule.process_time += task.duration;
    schedule.tasks.push_back(task);
    schedule.critical.push_back({name, true, ""});
  }
  return schedule;
}

std::string all_text(const pugi::xml_node& node) {
  std::string text;
  for (const pugi::xml_node& child : node.children()) text += child.value() + all_text(child);
  return text;
}

TEST(SvgChart, ShowsHostileNamesAsText) {
  const std::string longest(10'000, 'x');
  const std::vector<std::string> names = {"<script>alert(1)</script>", "\"'&]]><!--", longest,
                                          std::string("a\0b\x1b", 4), "\U0001F3D7 \u202E"};
  Schedule schedule = schedule_of(names);
  schedule.tasks.push_back(schedule.tasks.front());
  schedule.tasks.back().result = taskplan::TaskResult::rejected;
  schedule.tasks.back().reason = "<b>" + longest;
  const std::string svg = svg_chart(make_chart(schedule, nullptr, "<title> & more"));
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(svg.c_str(), pugi::parse_full)) << svg;
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  EXPECT_EQ(svg.find("<b>"), std::string::npos);
  const std::string shown = all_text(document);
  EXPECT_NE(shown.find(names[0]), std::string::npos);
  EXPECT_NE(shown.find(names[1]), std::string::npos);
  EXPECT_NE(shown.find(longest), std::string::npos);  // as a title
  for (const char byte : svg) {
    ASSERT_TRUE(static_cast<unsigned char>(byte) >= 0x20 || byte == '\n');
  }
}

TEST(SvgChart, StaysSmallWithManyTasks) {
  std::vector<std::string> names;
  for (int i = 0; i < 5000; ++i) names.push_back(fmt::format("unit_{}.set_panel_{}", i / 20, i));
  EXPECT_LT(svg_chart(make_chart(schedule_of(names), nullptr, "big")).size(), 2'000'000U);
}

TEST(SvgChart, DrawsManyCrewsInLowLanes) {
  Schedule schedule = schedule_of({"a"});
  const auto height = [&](std::size_t crews) {
    schedule.resources.resize(crews);
    pugi::xml_document document;
    document.load_string(svg_chart(make_chart(schedule, nullptr, "")).c_str());
    return document.child("svg").attribute("height").as_double();
  };
  EXPECT_NEAR(height(20) - height(10), 10 * 46, 1e-9);
  EXPECT_NEAR(height(90) - height(40), 50 * 17, 1e-9);
}

TEST(SvgChart, DrawsAnEmptyPlan) {
  const std::string svg = svg_chart(make_chart(Schedule{}, nullptr, "nothing"));
  pugi::xml_document document;
  EXPECT_TRUE(document.load_string(svg.c_str()));
  EXPECT_NE(svg.find("Nothing was planned."), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

/// Bars stand where their times are: the axis runs from x = 252 to x = 1576.
TEST(SvgChart, PutsBarsAtTheirTimes) {
  const std::string svg = svg_chart(make_chart(schedule_of({"a", "b", "c", "d"}), nullptr, ""));
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(svg.c_str()));
  const pugi::xpath_node_set bars = document.select_nodes("//rect[starts-with(title, 'c')]");
  ASSERT_EQ(bars.size(), 2U);  // in the lane and in its row
  EXPECT_EQ(bars[0].node().attribute("x").as_double(), 252 + 1324 / 2.0);
  EXPECT_EQ(bars[0].node().attribute("width").as_double(), 1324 / 4.0);
}

}  // namespace
}  // namespace rubicon::gantt
