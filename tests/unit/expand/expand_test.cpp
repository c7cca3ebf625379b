#include "interpreter/expand/expand.hpp"

#include <gtest/gtest.h>

#include "interpreter/expand/evaluate.hpp"
#include "interpreter/parse/parse.hpp"
#include "tests/support/growth.hpp"

namespace rubicon::test {

namespace {

using interpreter::Diagnostics;
using interpreter::SourceMap;

struct Plain {
  explicit Plain(const std::string& text, const interpreter::ParameterTexts& set = {}) {
    const interpreter::FileId file = sources.add("p.plan", "plan p {\n" + text + "\n}");
    plan = parse_plan(sources, file, diagnostics);
    expand_plan(plan, set, sources, diagnostics);
    diagnostics.name_copies(0, sources);
  }
  std::string said() const {
    std::string text;
    for (const auto& each : diagnostics.sorted()) {
      text += each.code + " " + each.message + "\n";
      for (const auto& note : each.notes) text += "  note: " + note.message + "\n";
    }
    return text;
  }
  /// "crew a_1; task t (takes 60)".
  std::string items() const {
    std::string text;
    for (const auto& item : plan.items) text += one(item) + "; ";
    return text;
  }
  static std::string one(const syntax::PlanItem& item) {
    if (const auto* crew = std::get_if<syntax::CrewItem>(&item)) return "crew " + crew->name.text;
    if (const auto* robot = std::get_if<syntax::RobotUse>(&item)) {
      return "robot " + robot->name->text + " " + robot->file.text;
    }
    if (const auto* component = std::get_if<syntax::ComponentItem>(&item)) {
      std::string text = "component " + component->name.text;
      for (const auto& each : component->attributes) text += " '" + each.text.text + "'";
      return text;
    }
    const auto* task = std::get_if<syntax::TaskItem>(&item);
    if (task == nullptr) return "?";
    std::string text = "task " + task->name.text;
    for (const auto& part : task->parts) {
      if (const auto* work = std::get_if<syntax::WorkItem>(&part)) {
        text += " takes " + interpreter::expansion::number_text(work->duration.value);
      } else if (const auto* after = std::get_if<syntax::AfterItem>(&part)) {
        for (const auto& link : after->links) {
          text += " after " + link.name.text();
          if (link.lag) text += "+" + interpreter::expansion::number_text(link.lag->value);
        }
      }
    }
    return text;
  }

  SourceMap sources;
  Diagnostics diagnostics;
  syntax::Plan plan;
};

TEST(Expand, LeavesAPlainPlanAsItIs) {
  const Plain plan(
      "crew a; task t { takes 2 min; } task u { takes 1; after t - 3, t SS + 2 min; }");
  EXPECT_EQ(plan.said(), "");
  EXPECT_EQ(plan.items(), "crew a; task t takes 120; task u takes 1 after t+-3 after t+120; ");
}

TEST(Expand, RepeatsItemsOfPlansAndTasks) {
  const Plain plan(R"(
    parameter bays = 3;
    for i from 1 to bays {
      crew c[i];
      task set[i] { takes i * 10 min; when (i > 1) { after set[i - 1]; } }
    }
    task slab { takes 1; for i from 1 to bays { after set[i] + i * 1 s; } }
    when (bays > 3) { crew more; }
    for j from 5 to 4 { crew none[j]; })");
  EXPECT_EQ(plan.said(), "");
  EXPECT_EQ(
      plan.items(),
      "crew c_1; task set_1 takes 600; crew c_2; task set_2 takes 1200 after set_1; crew c_3; "
      "task set_3 takes 1800 after set_2; task slab takes 1 after set_1+1 after set_2+2 "
      "after set_3+3; ");
}

TEST(Expand, NamesAnyPartOfAQualifiedName) {
  const Plain plan("task t { takes 1; after unit[0, 1 + 1].slab[3], a[0]; }");
  EXPECT_EQ(plan.said(), "");
  EXPECT_EQ(plan.items(), "task t takes 1 after unit_0_2.slab_3 after a_0; ");
}

TEST(Expand, PutsNamesIntoTexts) {
  const Plain plan(R"(
    parameter crane = "tower"; parameter pitch = 3600 mm;
    robot r "{crane}.robot";
    for i from 8 to 8 { component c[i] { name "Wall {i}: {pitch} m {} {1} { i } &lbrace;i}"; } })");
  EXPECT_EQ(plan.said(), "");
  EXPECT_EQ(plan.items(),
            "robot r tower.robot; component c_8 'Wall 8: 3.6 m {} {1} { i } &lbrace;i}'; ");
}

TEST(Expand, TakesParametersFromOutside) {
  EXPECT_EQ(Plain("parameter n = 1; for i from 1 to n { crew c[i]; }", {{"n", "3"}}).items(),
            "crew c_1; crew c_2; crew c_3; ");
}

TEST(Expand, CountsBaysOfALength) {
  EXPECT_EQ(Plain("for i from 1.6 / 4.8 * 3 to 4.8 m / 1.6 m { crew c[i * 1.6 / 4.8 * 3]; } "
                  "when (mod(4.8, 1.6) == 0) { crew all; }")
                .items(),
            "crew c_1; crew c_2; crew c_3; crew all; ");
  EXPECT_EQ(Plain("for i from 1 to 2.99999 { crew c; }").said(),
            "P24 the last number of a for needs a whole number of at most 1000000000, found "
            "2.99999\n");
}

TEST(Expand, SaysWhichCopyIsWrong) {
  const Plain plan("for i from 0 to 2 {\n  crew c[i - 1];\n}");
  EXPECT_EQ(plan.said(),
            "P24 the brackets of a name take numbers from 0 on, found -1 (line 3, i = 0)\n");
  EXPECT_EQ(plan.items(), "crew c_0; crew c_1; ");
  EXPECT_TRUE(plan.plan.broken);
  const Plain nested("for i from 1 to 2 { for j from 3 to 4 { crew c[i / 4]; } }");
  EXPECT_EQ(nested.said(),
            "P24 a number in the brackets of a name needs a whole number of at most 1000000000, "
            "found 0.25 (line "
            "2, i = 1, j = 3)\n  note: the same in 3 more of its copies\n");
}

TEST(Expand, RefusesNamesThatAreTaken) {
  EXPECT_EQ(Plain("parameter i = 1; for i from 1 to 2 { crew c[i]; }").said(),
            "P26 'i' is a name already; this for needs another\n  note: first given here\n");
  EXPECT_EQ(Plain("for i from 1 to 2 { for i from 1 to 2 { crew c[i]; } }").said(),
            "P26 'i' is a name already; this for needs another (line 2, i = 1)\n"
            "  note: first given here\n  note: the same in 1 more of its copies\n");
  EXPECT_EQ(Plain("when (1 < 2) { parameter a = 1; }").said(),
            "P26 parameter 'a' stands in a for or when; parameters stand in the plan itself\n");
  EXPECT_EQ(Plain("when (1) { crew a; }").said(),
            "F09 expected a condition, found a plain number\n");
  EXPECT_EQ(Plain("for i from 1 m to 2 { crew a; }").said(),
            "F09 the first number of a for needs a plain number, but the value is a length\n");
}

TEST(Expand, CountsCopiesBeforeItMakesThem) {
  EXPECT_EQ(Plain("for i from 1 to 100000 { crew c[i]; }").plan.items.size(), 100000u);
  EXPECT_EQ(
      Plain("for i from 1 to 400 { for j from 1 to 250 { crew c[i, j]; } }").plan.items.size(),
      100000u);
  const auto refused = [](const std::string& text) {
    return Plain(text).said().substr(0, 4) == "P25 ";
  };
  EXPECT_TRUE(refused("for i from 1 to 100001 { crew c[i]; }"));
  EXPECT_TRUE(refused("for i from -1000000000 to 1000000000 { }"));
  EXPECT_TRUE(refused("for i from 1 to 100000 { crew c[i]; } for i from 1 to 1 { crew d; }"));
  EXPECT_TRUE(refused("for i from 1 to 90000 { for j from 1 to 90000 { for k from 1 to 0 { } } }"));
  EXPECT_TRUE(
      refused("for i from 1 to 90000 { for j from 1 to 90000 { for k from 1 to 90000 { crew "
              "c; } } }"));
  EXPECT_TRUE(refused("for i from 1 to 100000 { crew c[i] { " + std::string(5000, ' ') + " } }"));
  EXPECT_EQ(Plain("for i from 1 to 1e10 { crew c; }").said(),
            "P24 the last number of a for needs a whole number of at most 1000000000, found "
            "10000000000\n");
}

TEST(Expand, TakesTimeInProportionToTheCopies) {
  const auto work = [](int copies) {
    const Plain plan(
        "for i from 1 to " + std::to_string(copies) +
        " { task t[i] { takes i; when (i > 1) { after t[i - 1]; } name \"T {i}\"; } }");
    EXPECT_EQ(plan.said(), "");
  };
  // 16 is linear, 256 quadratic.
  EXPECT_TRUE(grows_at_most(
      64, [&] { work(2500); }, [&] { work(40000); }));
}

TEST(Expand, IsBoundedInDepth) {
  std::string text;
  for (int i = 0; i < 300; ++i) text += "when (1 < 2) { ";
  EXPECT_NE(Plain(text).said().find("nested more than 200 deep"), std::string::npos);
}

}  // namespace

}  // namespace rubicon::test
