#include <gtest/gtest.h>

#include "interpreter/parse/parse.hpp"

namespace rubicon {
namespace {

using interpreter::Diagnostics;
using interpreter::FileId;
using interpreter::SourceMap;

struct ParsedPlan {
  SourceMap sources;
  Diagnostics diagnostics;
  syntax::Plan plan;

  explicit ParsedPlan(std::string text) {
    const FileId file = sources.add("a.plan", std::move(text));
    plan = interpreter::parse_plan(sources, file, diagnostics);
  }
};

TEST(ParsePlan, ShortForm) {
  const ParsedPlan parsed(
      "plan golden {\n"
      "  contact 1e-6;\n"
      "  robot \"machine.robot\" at rotz(90);\n"
      "  carry box(-2,-2,-4,2,2,0);\n"
      "  start theta -10, base.x 20 mm;\n"
      "  via x 0, y -8; via at trans(1, 2, 3);\n"
      "  goal at trans(4.4,-0.5,17) * rotz(90);\n"
      "  situation transport, safety; budget 250; within z 30;\n"
      "}\n");
  ASSERT_TRUE(parsed.diagnostics.all().empty()) << parsed.diagnostics.all()[0].message;
  const auto& items = parsed.plan.items;
  ASSERT_EQ(items.size(), 10u);
  EXPECT_EQ(std::get<syntax::NumberItem>(items[0]).value.value, 1e-6);
  EXPECT_FALSE(std::get<syntax::RobotUse>(items[1]).name);
  EXPECT_TRUE(std::get<syntax::RobotUse>(items[1]).at);
  EXPECT_EQ(std::get<syntax::CarryItem>(items[2]).shape.numbers.size(), 6u);
  const syntax::Values& start = std::get<syntax::StartItem>(items[3]).values;
  ASSERT_EQ(start.values.size(), 2u);
  EXPECT_EQ(start.values[0].value.value, -10);
  EXPECT_EQ(start.values[1].name.text(), "base.x");
  EXPECT_EQ(start.values[1].value.value, 0.02);
  EXPECT_EQ(std::get<syntax::ViaItem>(items[4]).goal.values.values.size(), 2u);
  EXPECT_TRUE(std::get<syntax::ViaItem>(items[5]).goal.at);
  EXPECT_EQ(std::get<syntax::GoalItem>(items[6]).goal.at->elements.size(), 2u);
  EXPECT_EQ(std::get<syntax::SituationItem>(items[7]).names.size(), 2u);
  EXPECT_EQ(std::get<syntax::WithinItem>(items[9]).values.values.size(), 1u);
}

TEST(ParsePlan, WordsOfAttributesStayNames) {
  const ParsedPlan parsed(
      "plan name {\n"
      "  robot type \"c.robot\"; crew storey;\n"
      "  component name { name \"a\"; shape sphere(0,0,0,1); attribute attribute \"b\"; }\n"
      "  component guid { shape sphere(0,0,0,1); storey \"0\"; guid \"g\"; }\n"
      "  task attribute { by type, storey; move name to trans(0,0,0); after guid; name \"c\"; }\n"
      "  task guid { takes 1; attribute cost_centre \"7\"; }\n"
      "}\n");
  ASSERT_TRUE(parsed.diagnostics.all().empty()) << parsed.diagnostics.all()[0].message;
  const auto& component = std::get<syntax::ComponentItem>(parsed.plan.items[2]);
  EXPECT_EQ(component.name.text, "name");
  ASSERT_EQ(component.attributes.size(), 2u);
  EXPECT_EQ(component.attributes[1].key.text, "attribute");
  const auto& task = std::get<syntax::TaskItem>(parsed.plan.items[4]);
  EXPECT_EQ(std::get<syntax::AttributeItem>(task.parts[3]).text.text, "c");
}

TEST(ParsePlan, FullForm) {
  const ParsedPlan parsed(
      "plan unit_2 {\n"
      "  start_at \"2026-03-02 07:00\"; currency \"EUR\"; site box(0,0,0,1,1,1);\n"
      "  calendar site { mon-fri 07:00-12:00, 12:30-16:00; off 2026-12-25, \"2026-12-26\"; "
      "carry_over; }\n"
      "  component move { shape sphere(0,0,0,1); shape box(0,0,0,1,1,1) at rotx(3); at "
      "trans(0,0,0);\n"
      "                   grip trans(0,0,2); mass 4.1 t; name \"Wall 1\"; type \"IfcWall\";\n"
      "                   attribute name_of_maker \"Hinz & Kunz\"; }\n"
      "  robot crane \"c.robot\" at trans(0,0,0) { start x 20; cost 180 per h; calendar site; park "
      "x 3; }\n"
      "  crew riggers { size 3; cost 165 per h; calendar site; }\n"
      "  crew others;\n"
      "  task set { by crane, riggers; move u.move to trans(22, 14, 3) * rotz(90);\n"
      "    hook 4 min by riggers; adjust 6; release 2 min; takes 1 h; within 5 mm; guide g;\n"
      "    budget 3; priority 2; zone sphere(0,0,0,1); situation night; via x 3; name \"Set\";\n"
      "    after a, u.b SS + 2 h, c FF - 30 min; }\n"
      "  module unit { component c { shape sphere(0,0,0,1); } task t { by crane; go x 3; remove c; "
      "} }\n"
      "  place unit at trans(0,0,3) as u1 after set, a;\n"
      "  place unit at trans(0,0,6) from trans(9,0,0) * rotz(90) as u2;\n"
      "  import \"x.ifc\" as h { layer { a b: 3; } \"foo\" }\n"
      "}\n");
  ASSERT_TRUE(parsed.diagnostics.all().empty()) << parsed.diagnostics.all()[0].message;
  const auto& items = parsed.plan.items;
  ASSERT_EQ(items.size(), 13u);
  EXPECT_EQ(std::get<syntax::StringItem>(items[0]).value.text, "2026-03-02 07:00");

  const auto& calendar = std::get<syntax::CalendarItem>(items[3]);
  ASSERT_EQ(calendar.shifts.size(), 3u);
  EXPECT_EQ(calendar.shifts[0].last_day->text, "fri");
  ASSERT_EQ(calendar.shifts[0].times.size(), 2u);
  EXPECT_EQ(calendar.shifts[0].times[1].first.text, "12:30");
  ASSERT_EQ(calendar.shifts[1].off.size(), 2u);
  EXPECT_EQ(calendar.shifts[1].off[0].text, "2026-12-25");
  EXPECT_EQ(calendar.shifts[1].off[1].text, "2026-12-26");
  EXPECT_TRUE(calendar.shifts[2].carry_over);

  const auto& component = std::get<syntax::ComponentItem>(items[4]);
  EXPECT_EQ(component.name.text, "move");
  EXPECT_EQ(component.shapes.size(), 2u);
  EXPECT_EQ(component.mass[0].value, 4100);
  ASSERT_EQ(component.attributes.size(), 3u);
  EXPECT_EQ(component.attributes[0].key.text, "name");
  EXPECT_EQ(component.attributes[0].text.text, "Wall 1");
  EXPECT_EQ(component.attributes[2].key.text, "name_of_maker");
  EXPECT_EQ(component.attributes[2].text.text, "Hinz & Kunz");
  const auto& robot = std::get<syntax::RobotUse>(items[5]);
  EXPECT_EQ(robot.name->text, "crane");
  EXPECT_DOUBLE_EQ(robot.cost[0].amount.value, 0.05);
  EXPECT_EQ(robot.calendar[0].text, "site");
  EXPECT_EQ(robot.park.size(), 1u);
  EXPECT_EQ(std::get<syntax::CrewItem>(items[6]).size[0].value, 3);

  const auto& task = std::get<syntax::TaskItem>(items[8]);
  ASSERT_EQ(task.parts.size(), 15u);
  EXPECT_EQ(std::get<syntax::MoveItem>(task.parts[1]).component.text(), "u.move");
  EXPECT_EQ(std::get<syntax::WorkItem>(task.parts[2]).duration.value, 240);
  EXPECT_EQ(std::get<syntax::WorkItem>(task.parts[2]).by->text, "riggers");
  EXPECT_FALSE(std::get<syntax::WorkItem>(task.parts[3]).by);
  EXPECT_EQ(std::get<syntax::WorkItem>(task.parts[5]).name.text, "takes");
  EXPECT_EQ(std::get<syntax::WithinItem>(task.parts[6]).length->value, 0.005);
  const auto& after = std::get<syntax::AfterItem>(task.parts[14]);
  ASSERT_EQ(after.links.size(), 3u);
  EXPECT_FALSE(after.links[0].type);
  EXPECT_EQ(after.links[1].name.text(), "u.b");
  EXPECT_EQ(after.links[1].type->text, "SS");
  EXPECT_EQ(after.links[1].lag->value, 7200);
  EXPECT_EQ(after.links[2].lag->value, -1800);

  EXPECT_EQ(std::get<syntax::ModuleItem>(items[9]).items.size(), 2u);
  const auto& place = std::get<syntax::PlaceItem>(items[10]);
  EXPECT_EQ(place.as.text, "u1");
  EXPECT_EQ(place.at.elements.size(), 1u);
  EXPECT_FALSE(place.from);
  EXPECT_EQ(place.after.size(), 2u);
  const auto& from_stock = std::get<syntax::PlaceItem>(items[11]);
  EXPECT_EQ(from_stock.as.text, "u2");
  EXPECT_EQ(from_stock.at.elements.size(), 1u);
  ASSERT_TRUE(from_stock.from);
  EXPECT_EQ(from_stock.from->elements.size(), 2u);
  EXPECT_TRUE(from_stock.after.empty());
  EXPECT_EQ(std::get<syntax::ImportItem>(items[12]).as->text, "h");
}

}  // namespace
}  // namespace rubicon
