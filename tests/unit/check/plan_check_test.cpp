#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/syntax/attribute_text.hpp"
#include "tests/unit/check/check_cases.hpp"
#include "tests/unit/check/memory_files.hpp"

namespace rubicon::test {

namespace {

using interpreter::Diagnostics;
using interpreter::LinkType;
using interpreter::PlanModel;
using interpreter::SourceMap;

const std::string kPath = "site/site.plan";

/// A plan text, checked, with all that was said.
struct Loaded {
  explicit Loaded(const std::string& text, const std::map<std::string, std::string>& others = {},
                  const interpreter::ParameterTexts& set = {})
      : files(case_files()) {
    files.texts[kPath] = text;
    for (const auto& [path, other] : others) files.texts[path] = other;
    plan = interpreter::load_plan(kPath, sources, files, diagnostics, set);
  }
  std::string said() const { return listed(diagnostics, sources, kPath); }

  SourceMap sources;
  MemoryFiles files;
  Diagnostics diagnostics;
  std::unique_ptr<PlanModel> plan;
};

TEST(PlanCheck, SaysExactlyWhatEachCaseDeserves) {
  const std::vector<CheckCase> cases = read_check_cases("plan_cases.txt");
  ASSERT_GE(cases.size(), 70u);
  for (const CheckCase& given : cases) {
    const Loaded plan(given.text);
    EXPECT_EQ(plan.said(), listed(given.expected)) << given.title << "\n" << given.text;
    EXPECT_EQ(plan.plan == nullptr, plan.diagnostics.has_errors()) << given.title;
  }
}

TEST(PlanCheck, EveryCodeIsProvokedByACase) {
  std::string all;
  for (const CheckCase& given : read_check_cases("plan_cases.txt")) all += listed(given.expected);
  for (const char* code :
       {"P01", "P02", "P03", "P04", "P05", "P06", "P07", "P08", "P09", "P10", "P11", "P12",
        "P13", "P14", "P15", "P16", "P17", "P20", "P21", "P22", "P23", "P24", "P25", "P26",
        "P30", "P31", "P32", "P35", "F01", "F02", "F03", "F07", "F09", "W08"}) {
    EXPECT_NE(all.find(std::string(": ") + code + " "), std::string::npos) << code;
  }
}

TEST(PlanCheck, ImportsOtherPlans) {
  const std::string yard = R"(plan yard {
    parameter pallets = 1;
    parameter pitch = 2 m;
    robot truck "../crane.robot";
    crew loaders { calendar week; }
    calendar week { mon-fri 07:00-16:00; }
    for i from 1 to pallets {
      component pallet[i] { shape box(0, 0, 0, 1, 1, 1); grip trans(0, 0, 1); at trans(i * pitch, 0, 0); }
      task bring[i] { by truck; move pallet[i] to trans(5, 5, 0); hook 1 s by loaders; after u.t, begin; }
    }
    module unit { component part { shape sphere(0, 0, 0, 1); } task t { by loaders; takes 1 s; } task v { remove part; takes 1 s; after t; } }
    place unit at trans(9, 9, 9) as u;
  })";
  const std::string text = R"(plan p {
    import "parts/yard.plan" as yard;
    task begin { takes 1 s; }
    task end { by yard.loaders; takes yard.pitch / 1 m/s; after yard.bring[2], yard.bring_1; }
    place yard.unit at trans(20, 0, 0) as v;
  })";
  const Loaded loaded(text, {{"site/parts/yard.plan", yard}}, {{"yard.pallets", "2"}});
  ASSERT_EQ(loaded.said(), "");
  std::string names;
  for (const auto& each : loaded.plan->components) names += each.name + " ";
  for (const auto& each : loaded.plan->tasks) names += each.name + " ";
  EXPECT_EQ(names,
            "yard.pallet_1 yard.pallet_2 yard.u.part v.part yard.bring_1 yard.bring_2 yard.u.t "
            "yard.u.v begin end v.t v.v ");
  ASSERT_EQ(loaded.plan->tasks.size(), 8u);
  EXPECT_EQ(loaded.plan->tasks[0].after[0].task, 2);  // yard.u.t
  EXPECT_EQ(loaded.plan->tasks[0].after[1].task, 4);  // begin, of the plan that imports
  EXPECT_EQ(loaded.plan->tasks[5].takes[0].duration, 2);
  EXPECT_EQ(loaded.plan->tasks[5].after[0].task, 1);
}

TEST(PlanCheck, ImportedPlansKnowTheParametersOfThoseThatImportThem) {
  const auto loaded = [](const std::string& text, const std::string& inner) {
    return Loaded("plan p { " + text + " }",
                  {{"site/o.plan", "plan o { parameter own = 1 s; import \"i.plan\" as i; }"},
                   {"site/i.plan", "plan i { " + inner + " }"}});
  };
  const std::string outer = "parameter extra = 3 s; parameter i = 5; parameter own = 9 s; ";
  const std::string import = "import \"o.plan\" as o; ";
  const Loaded fine = loaded(outer + import, R"(for i from 1 to 2 {
    task t[i] { name "{extra} s"; takes own + extra + i * 10 s; } })");
  ASSERT_EQ(fine.said(), "");
  EXPECT_EQ(fine.plan->tasks[1].takes[0].duration, 24);  // own: of the nearest
  const Loaded hidden = loaded(outer + import, "parameter extra = 1 s; task t { takes extra; }");
  ASSERT_EQ(hidden.said(), "");
  EXPECT_EQ(hidden.plan->tasks[0].takes[0].duration, 1);
  EXPECT_EQ(loaded(import + outer, "task t { takes extra; }").said().substr(0, 112),
            "  => site/i.plan:1:25: P23 error: parameter 'extra' is declared further down; "
            "an imported plan knows those above");
  EXPECT_EQ(
      loaded(outer + import, "task t { takes extr; }").said(),
      "  => site/i.plan:1:25: P23 error: there is no parameter 'extr'; did you mean extra?\n");
  EXPECT_NE(loaded(outer + import + "task t { takes o.extra; }", "").said(), "");
}

TEST(PlanCheck, NamesWhatImportedPlansPlaceAndImport) {
  const std::string yard = R"(plan yard {
    parameter n = 2;
    crew gang; crew porters { size 3; }
    robot left "crane.robot"; robot right "crane.robot" at trans(90, 0, 0);
    pool cranes { of left, right; }
    module bay {
      component frame[1] { shape sphere(0, 0, 0, 1); grip trans(0, 0, 1); }
      task set { by cranes; go x 30; }
      for k from 1 to 2 { task fix[k] { by gang; takes 1 s; after set; } }
    }
    for i from 1 to n { place bay at trans(i * 9, 30, 0) as b[i]; }
    task go { by cranes; go x 32; }
  })";
  const std::string middle = R"(plan middle {
    import "yard.plan" as deep;
    task between { by deep.gang; takes deep.n * 1 s; after deep.b[2].fix[deep.n - 1]; }
  })";
  const std::string text = R"(plan p {
    import "yard.plan" as near;
    import "middle.plan" as far;
    task a { by near.gang; takes 1 s; needs (far.deep.n - 1) far.deep.porters;
      after near.b[2].fix[1], near.b_1.set SS, far.deep.b[far.deep.n].fix_1 + 2 s, far.between; }
    task b { by same as far.deep.b[1].set; go x 31; after far.deep.b[1].set; }
    task d { by same as near.go; go x 33; after near.go; }
    task c { remove near.b[2].frame[1]; takes 1 s; needs 1 far.deep.porters; after a; }
    touching near.b[1].frame[1] far.deep.b[2].frame_1;
  })";
  const std::map<std::string, std::string> files = {{"site/yard.plan", yard},
                                                    {"site/middle.plan", middle}};
  const Loaded loaded(text, files, {{"far.deep.n", "3"}});
  ASSERT_EQ(loaded.said(), "");
  std::map<std::string, std::string> after;
  for (const auto& task : loaded.plan->tasks) {
    for (const auto& link : task.after) {
      after[task.name] += loaded.plan->tasks[static_cast<std::size_t>(link.task)].name + " ";
    }
  }
  EXPECT_EQ(after["far.between"], "far.deep.b_2.fix_2 ");
  EXPECT_EQ(after["a"], "near.b_2.fix_1 near.b_1.set far.deep.b_3.fix_1 far.between ");
  EXPECT_EQ(after["b"], "far.deep.b_1.set ");
  for (const auto& task : loaded.plan->tasks) {
    EXPECT_EQ(task.choices.size(), task.name == "b" || task.name == "d" ? 2u : task.choices.size())
        << task.name;
  }
}

TEST(PlanCheck, SaysWhatIsWrongWithAnImport) {
  const auto said = [](const std::string& text, const std::string& other) {
    return Loaded("plan p { task t { takes 1 s; } " + text + " }", {{"site/o.plan", other}}).said();
  };
  EXPECT_EQ(said("import \"n.plan\" as n;", ""),
            "  => 1:39: F01 error: plan 'n.plan': there is no such file\n");
  EXPECT_EQ(said("import \"o.plan\" as o;", "plan o { import \"o.plan\" as p; }"),
            "  => site/o.plan:1:17: P28 error: 'o.plan' imports itself\n");
  EXPECT_EQ(
      said("import \"o.plan\" as o;", "plan o { contact 1 mm; }"),
      "  => site/o.plan:1:10: P28 error: contact belongs into the plan that imports this one\n");
  EXPECT_EQ(said("when (1 < 2) { import \"o.plan\" as o; }", "plan o { }"),
            "  => 1:47: P28 error: an import stands in the plan itself, not in a for or when\n");
  EXPECT_EQ(said("import \"o.plan\";", "plan o { }"),
            "  => 1:32: P00 error: a plan is imported under a name: import \"FILE\" as NAME;\n");
  EXPECT_EQ(said("import \"o.plan\" as o; task u { takes 1 s; after o.b; }",
                 "plan o { task a { takes 1 s; } task c { takes 1 s; after t, d; } }"),
            "  => 1:80: P01 error: unknown task 'o.b'; did you mean o.a?\n"
            "  => site/o.plan:1:61: P01 error: unknown task 'd'\n");
  const auto said_of_place = [&](const std::string& name) {
    return said("import \"o.plan\" as o; task u { takes 1 s; after " + name + "; }",
                "plan o { module m { task a { takes 1 s; } } place m at rotz(0) as b[1]; }");
  };
  EXPECT_EQ(said_of_place("o.b[1].a"), "");
  EXPECT_EQ(said_of_place("o.b[2].a"),
            "  => 1:80: P01 error: unknown place 'o.b_2'; did you mean o.b_1?\n");
  EXPECT_EQ(said_of_place("o.b[1].aa"),
            "  => 1:87: P01 error: unknown task 'aa' of module 'o.m'\n");
  EXPECT_EQ(said_of_place("o[1].b[1].a"),
            "  => 1:80: P00 error: brackets stand behind the last two parts of a name only: "
            "NAME.x[i].y[j]\n");
  EXPECT_EQ(said_of_place("o.b[1].a.c"), said_of_place("o[1].b[1].a"));
}

TEST(PlanCheck, ReadsTheShortForm) {
  const Loaded short_plan(R"(plan p {
    contact 1e-6;
    budget 500;
    robot "crane.robot" at trans(1, 2, 0);
    component wall { shape box(0, 0, 0, 1, 1, 1); at trans(5, 0, 0) * rotz(90); }
    site box(-50, -50, -1, 50, 50, 0);
    carry box(-2, -2, -4, 2, 2, 0);
    start theta 10, x 25;
    via x 30; via at trans(3, 4, 5);
    goal theta 32 deg, x 2250 cm, z 3;
    within z 30; within 1 mm;
    situation transport, night;
  })");
  ASSERT_EQ(short_plan.said(), "");
  const PlanModel& plan = *short_plan.plan;
  EXPECT_TRUE(plan.short_form);
  EXPECT_EQ(plan.name, "p");
  EXPECT_EQ(plan.contact, 1e-6);
  EXPECT_EQ(plan.budget, 500);
  ASSERT_EQ(plan.robots.size(), 1u);
  EXPECT_EQ(plan.robots[0].name, "crane");
  EXPECT_EQ(plan.robots[0].X_WM.translation().y(), 2);
  EXPECT_EQ(plan.robots[0].start, (std::vector<double>{10, 25, 10}));
  ASSERT_TRUE(plan.goal.has_value());
  EXPECT_EQ(plan.goal->values, (std::vector<std::pair<int, double>>{{0, 32}, {1, 22.5}, {2, 3}}));
  ASSERT_EQ(plan.via.size(), 2u);
  EXPECT_EQ(plan.via[1].X_WG->translation().z(), 5);
  EXPECT_EQ(plan.within.length, 0.001);
  EXPECT_EQ(plan.within.values, (std::vector<std::pair<int, double>>{{2, 30}}));
  EXPECT_EQ(plan.carry.size(), 1u);
  EXPECT_EQ(plan.site.size(), 1u);
  ASSERT_EQ(plan.components.size(), 1u);
  EXPECT_EQ(plan.components[0].X_WO.translation().x(), 5);
  EXPECT_EQ(plan.situations, (std::vector<std::string>{"transport", "night"}));
  EXPECT_TRUE(plan.uses.empty());
}

TEST(PlanCheck, ComputesChargesFromCalculations) {
  const Loaded loaded(R"(plan p {
  parameter n = 2; parameter rate = 30 per h;
  overhead 100 * n + 50 per day;
  crew a { cost 50 * n per h; rental n * 40 per day; mobilisation 2 * n; overtime 1 + n / 4; }
  crew b { cost 50 + n per h; rental (n) per day from "2026-03-02" to "2026-03-04"; overtime n * 1.5 outside day; }
  crew c { cost n per h; rental n per day; } crew d { cost (n + 1) * 2 per h; }
  crew e { cost n * 50 per h; } crew f { cost rate * n; } crew g { cost 7 per h; }
  calendar day { mon 07:00-12:00; }
  task t { by a, b, c, d, e, f, g; takes 1 h; }
})");
  ASSERT_EQ(loaded.said(), "");
  const PlanModel& plan = *loaded.plan;
  EXPECT_EQ(plan.overhead_per_day, 250);
  const std::vector<double> costs = {100, 52, 2, 6, 100, 60, 7};
  for (std::size_t i = 0; i < costs.size(); ++i) {
    EXPECT_DOUBLE_EQ(plan.crews.at(i).cost_per_hour.value(), costs[i]) << plan.crews[i].name;
  }
  EXPECT_EQ(plan.crews[0].charges.rental_per_day, 80);
  EXPECT_EQ(plan.crews[0].charges.mobilisation, 4);
  EXPECT_EQ(plan.crews[0].charges.overtime, 1.5);
  EXPECT_EQ(plan.crews[1].charges.rental_per_day, 2);
  EXPECT_TRUE(plan.crews[1].charges.rental_days);
  EXPECT_EQ(plan.crews[1].charges.overtime, 3);
  EXPECT_EQ(plan.crews[1].charges.normal, "day");
  EXPECT_EQ(plan.crews[2].charges.rental_per_day, 2);
}

const char* const kFullPlan = R"(plan unit {
  start_at "2026-03-02 07:00";
  currency "EUR";
  guide rrt rrt_plus { seed 3; }
  calendar site { mon-fri 07:00-12:00, 12:30-16:00; off 2026-12-25; carry_over; }
  component slab { shape mesh("cube.stl", mm); at trans(0, 0, 0); }
  component panel { shape box(-3, -0.1, 0, 3, 0.1, 2.8); at trans(30, -6, 0); grip trans(0, 0, 2.8);
                    mass 4.1 t; }
  robot crane "crane.robot" at trans(0, 0, 0) { start theta 5, x 20, z 10; cost 180 per h;
                                                calendar site; park x 4; }
  crew riggers { size 3; cost 165 per h; calendar site; }
  task set { by crane, riggers; move panel to trans(22, 14, 3) * rotz(90); hook 4 min by riggers;
             adjust 6 min by riggers; release 2 min; via x 30; situation night; within z 3 cm;
             budget 100; priority 2; guide rrt; zone box(0, 0, 0, 1, 1, 1); zone box(2, 0, 0, 3, 1, 1) up_to 5; }
  task home { by crane; go theta 0, x 20; after set, cure SS + 2 h; }
  task cure { takes 30 min; takes 1 h; after set FS - 10 min; remove slab; }
})";

TEST(PlanCheck, ReadsTheFullForm) {
  const Loaded full(kFullPlan);
  ASSERT_EQ(
      full.said(),
      "  => 5:12: P36 warning: calendar 'site' says carry_over: the load of task 'set' may hang "
      "on the hook beyond the end of a shift\n"
      "  => 6:31: F15 warning: the surface of mesh 'cube.stl' is not closed: only the surface "
      "itself is in the way, not what it encloses\n");
  const PlanModel& plan = *full.plan;
  EXPECT_FALSE(plan.short_form);
  EXPECT_EQ(plan.start_at, (schedule::CivilTime{{2026, 3, 2}, 7 * 60}));
  EXPECT_EQ(plan.currency, "EUR");
  ASSERT_EQ(plan.calendars.size(), 1u);
  EXPECT_EQ(plan.calendars[0].shifts[0].last_day, 4);
  EXPECT_EQ(plan.calendars[0].shifts[0].minutes,
            (std::vector<std::pair<int, int>>{{420, 720}, {750, 960}}));
  EXPECT_EQ(plan.calendars[0].off, (std::vector<schedule::Date>{{2026, 12, 25}}));
  EXPECT_TRUE(plan.calendars[0].carry_over);
  ASSERT_EQ(plan.components.size(), 2u);
  EXPECT_EQ(plan.components[1].mass, 4100);
  EXPECT_EQ(plan.components[1].X_OG.translation().z(), 2.8);
  EXPECT_EQ(plan.robots[0].start, (std::vector<double>{5, 20, 10}));
  EXPECT_DOUBLE_EQ(plan.robots[0].cost_per_hour.value(), 180);
  EXPECT_EQ(plan.robots[0].calendar, "site");
  EXPECT_EQ(plan.crews[0].size, 3);
  ASSERT_EQ(plan.tasks.size(), 3u);
  const interpreter::TaskSpec& set = plan.tasks[0];
  EXPECT_EQ(set.robot, 0);
  EXPECT_EQ(set.crews, (std::vector<int>{0}));
  EXPECT_EQ(set.move, 1);
  EXPECT_EQ(set.X_WO_goal.translation().x(), 22);
  EXPECT_EQ(set.hook->duration, 240);
  EXPECT_EQ(set.hook->crew, 0);
  EXPECT_EQ(set.release->crew, -1);
  EXPECT_EQ(set.within.values, (std::vector<std::pair<int, double>>{{2, 0.03}}));
  EXPECT_EQ(set.budget, 100);
  ASSERT_EQ(set.zones.size(), 2u);
  ASSERT_EQ(set.zones_overhead.size(), 2u);
  EXPECT_EQ(std::get<geometry::Box>(set.zones_overhead[0].solid).upper.z(), 1001);
  EXPECT_EQ(std::get<geometry::Box>(set.zones_overhead[1].solid).upper.z(), 5);
  const interpreter::TaskSpec& home = plan.tasks[1];
  ASSERT_TRUE(home.go.has_value());
  ASSERT_EQ(home.after.size(), 2u);
  EXPECT_EQ(home.after[0].task, 0);
  EXPECT_EQ(home.after[1].task, 2);
  EXPECT_EQ(home.after[1].type, LinkType::SS);
  EXPECT_EQ(home.after[1].lag, 2 * schedule::kHour);
  EXPECT_EQ(plan.tasks[2].after[0].lag, -10 * schedule::kMinute);
  EXPECT_EQ(plan.tasks[2].takes.size(), 2u);
  EXPECT_EQ(plan.tasks[2].remove, (std::vector<int>{0}));
}

TEST(PlanCheck, HandsAttributesOn) {
  const Loaded loaded(R"(plan p {
    component c { shape sphere(0, 0, 0, 1); attribute fire "60 min"; name "3/4&quot; & more &amp;quot;";
                  storey "0"; }
    module m { component d { shape sphere(0, 0, 0, 1); type "IfcSlab"; } task t { takes 0; name "T"; } }
    place m at trans(0, 0, 3) as one;
  })");
  ASSERT_EQ(loaded.said(), "");
  const PlanModel& plan = *loaded.plan;
  EXPECT_EQ(plan.components[0].attributes,
            (interpreter::Attributes{
                {"fire", "60 min"}, {"name", "3/4\" & more &quot;"}, {"storey", "0"}}));
  EXPECT_EQ(plan.components[1].attributes, (interpreter::Attributes{{"type", "IfcSlab"}}));
  EXPECT_EQ(plan.tasks[0].attributes, (interpreter::Attributes{{"name", "T"}}));
  EXPECT_EQ(*interpreter::find_attribute(plan.components[0].attributes, "fire"), "60 min");
  EXPECT_EQ(interpreter::find_attribute(plan.components[0].attributes, "type"), nullptr);
}

TEST(PlanCheck, BoundsAttributes) {
  const auto said = [](const std::string& items) {
    return Loaded("plan p { component c { shape sphere(0, 0, 0, 1); " + items +
                  " } task t { takes 0; } }")
        .said();
  };
  EXPECT_EQ(said("name \"" + std::string(1000, 'x') + "\";"), "");
  EXPECT_THAT(
      said("name \"" + std::string(1001, 'x') + "\";"),
      testing::HasSubstr("the name of component 'c' has 1001 characters; expected at most"));
  std::string many;
  for (int i = 0; i < 64; ++i) many += "attribute a" + std::to_string(i) + " \"x\"; ";
  EXPECT_EQ(said(many), "");
  const std::string more = said(many + "attribute b \"x\"; attribute c \"x\";");
  EXPECT_THAT(more, testing::HasSubstr("component 'c' has more than 64 attributes"));
  EXPECT_EQ(more.find("P19"), more.rfind("P19"));  // once
}

/// What is written of a text says that text again, whatever it is.
TEST(PlanCheck, WritesAttributesThatReadAsTheyWere) {
  for (const char* text :
       {"a", "\"", "&", "&quot;", "&amp;quot;", "&\"amp;", "3/4\" \xC3\xA4 & {b}"}) {
    const std::string written = interpreter::written_attribute(text);
    EXPECT_EQ(written.find('"'), std::string::npos) << text;
    EXPECT_EQ(interpreter::plain_attribute(written), text);
    EXPECT_EQ(interpreter::attribute_mistake(interpreter::plain_attribute(written)), "") << text;
  }
  EXPECT_EQ(interpreter::written_attribute(" \t\n"), "");
  EXPECT_EQ(interpreter::written_attribute("a\tb\xE2\x80\xA8"
                                           "c\xC2\x85\xFF"),
            "a b c  ");
  EXPECT_EQ(interpreter::written_attribute(std::string(2000, 'x')), std::string(1000, 'x'));
}

TEST(PlanCheck, RecordsWhatItUses) {
  const Loaded full(kFullPlan);
  std::vector<std::string> uses;
  for (const auto& use : full.plan->uses) {
    uses.push_back(use.what);
    EXPECT_EQ(use.span.file, 0);
    EXPECT_LT(use.span.begin, use.span.end) << use.what;
  }
  std::sort(uses.begin(), uses.end());
  uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
  EXPECT_EQ(uses, (std::vector<std::string>{"SS", "calendar", "cost", "currency", "lag", "park",
                                            "priority", "size", "start_at", "zone"}));
  const Loaded imported(
      "plan p { import \"house.ifc\" as house { } component a { shape sphere(0, 0, 0, 1); } "
      "task t { remove house.wall; } }");
  ASSERT_EQ(imported.said(), "");
  ASSERT_EQ(imported.plan->uses.size(), 1u);
  EXPECT_EQ(imported.plan->uses[0].what, "import");
}

TEST(PlanCheck, PlacesModules) {
  const Loaded placed(R"(plan p {
    robot crane "crane.robot";
    component base { shape box(0, 0, -1, 1, 1, 0); }
    task ground { takes 1 h; }
    place unit at trans(10, 0, 0) as u1 after ground;
    module unit {
      component wall { shape box(0, 0, 0, 1, 1, 1); at trans(1, 0, 0); grip trans(0, 0, 1); }
      task set { by crane; move wall to trans(2, 0, 3); }
      task seal { takes 5 min; after set; }
      task tidy { by crane; go at trans(1, 2, 3); after ground; }
    }
    place unit at rotz(90) as u2 after u1.seal;
    task last { takes 1 min; remove u2.wall; after u1.set, u2.seal; }
  })");
  ASSERT_EQ(placed.said(), "");
  const PlanModel& plan = *placed.plan;
  std::vector<std::string> names;
  for (const auto& task : plan.tasks) names.push_back(task.name);
  EXPECT_EQ(names, (std::vector<std::string>{"ground", "u1.set", "u1.seal", "u1.tidy", "u2.set",
                                             "u2.seal", "u2.tidy", "last"}));
  ASSERT_EQ(plan.components.size(), 3u);
  EXPECT_EQ(plan.components[2].name, "u2.wall");
  EXPECT_NEAR((plan.components[2].X_WO.translation() - math::Vec3(0, 1, 0)).norm(), 0, 1e-12);
  EXPECT_EQ(plan.tasks[1].move, 1);
  EXPECT_EQ(plan.tasks[4].move, 2);
  EXPECT_NEAR((plan.tasks[1].X_WO_goal.translation() - math::Vec3(12, 0, 3)).norm(), 0, 1e-12);
  EXPECT_NEAR((plan.tasks[6].go->X_WG->translation() - math::Vec3(-2, 1, 3)).norm(), 0, 1e-12);
  ASSERT_EQ(plan.tasks[1].after.size(), 1u);  // of the place
  EXPECT_EQ(plan.tasks[1].after[0].task, 0);
  ASSERT_EQ(plan.tasks[2].after.size(), 1u);  // inside the module only
  EXPECT_EQ(plan.tasks[2].after[0].task, 1);
  ASSERT_EQ(plan.tasks[6].after.size(), 2u);  // its own outside the module, and of the place
  EXPECT_EQ(plan.tasks[6].after[1].task, 2);
  EXPECT_EQ(plan.tasks[7].remove, (std::vector<int>{2}));
  EXPECT_EQ(plan.tasks[7].after[1].task, 5);
}

TEST(PlanCheck, PlacesModulesFromTheirStock) {
  const Loaded placed(R"(plan p {
    robot crane "crane.robot";
    module unit {
      component wall { shape box(0, 0, 0, 1, 1, 1); at trans(1, 0, 0); grip trans(0, 0, 1); }
      task set { by crane; move wall to trans(2, 0, 3); zone box(0, 0, 0, 1, 1, 1); }
      task back { by crane; go at trans(1, 0, 0); via at trans(0, 1, 0); after set; }
    }
    place unit at trans(10, 0, 0) from trans(0, 20, 0) * rotz(90) as u1;
    place unit at trans(10, 5, 0) as u2;
  })");
  ASSERT_EQ(placed.said(), "");
  const PlanModel& plan = *placed.plan;
  const auto at = [](const math::Pose& X, double x, double y, double z) {
    return (X.translation() - math::Vec3(x, y, z)).norm() < 1e-12;
  };
  // The components stand in the stock, turned as it is ...
  EXPECT_TRUE(at(plan.components[0].X_WO, 0, 21, 0));
  EXPECT_NEAR(plan.components[0].X_WO.linear()(1, 0), 1, 1e-12);
  // ... and all that the tasks say is meant where the module is built.
  EXPECT_TRUE(at(plan.tasks[0].X_WO_goal, 12, 0, 3));
  EXPECT_NEAR(plan.tasks[0].X_WO_goal.linear()(1, 0), 0, 1e-12);
  EXPECT_TRUE(at(plan.tasks[0].zones[0].X_BS, 10, 0, 0));
  EXPECT_TRUE(at(*plan.tasks[1].go->X_WG, 11, 0, 0));
  EXPECT_TRUE(at(*plan.tasks[1].via[0].X_WG, 10, 1, 0));
  // Without a stock of its own a module stands where it is built.
  EXPECT_TRUE(at(plan.components[1].X_WO, 11, 5, 0));
}

TEST(PlanCheck, LoadsARobotFileOnce) {
  const Loaded plan(R"(plan p {
    robot a "crane.robot"; robot b "./crane.robot" { start x 30; }
    task t { by a; go x 5; } task u { by b; go x 5; after t; }
  })");
  ASSERT_EQ(plan.said(), "");
  EXPECT_EQ(plan.plan->robots[0].robot, plan.plan->robots[1].robot);
  EXPECT_EQ(std::count(plan.files.reads.begin(), plan.files.reads.end(), "site/crane.robot"), 1);
  EXPECT_EQ(plan.plan->robots[1].start[1], 30);
}

TEST(PlanCheck, StartsOfDerivedParametersAreComputed) {
  const Loaded plan("plan p { robot \"arm.robot\"; start boom.phi 10; goal boom.phi 20; }");
  ASSERT_EQ(plan.said(), "");
  EXPECT_EQ(plan.plan->robots[0].start, (std::vector<double>{10, 25}));
}

TEST(PlanCheck, FinishesHugePlansQuickly) {
  std::string text = "plan p { module m {";
  for (int i = 0; i < 2000; ++i) text += " task t" + std::to_string(i) + " { takes 0; }";
  text += " }";
  for (int i = 0; i < 600; ++i) text += " place m at rotz(0) as u" + std::to_string(i) + ";";
  const Loaded many(text + " }");
  EXPECT_NE(many.said().find("P18 error"), std::string::npos);

  std::string chain = "plan p { task t0 { takes 0; after t99999; }";
  for (int i = 1; i < 100000; ++i) {
    chain += " task t" + std::to_string(i) + " { takes 0; after t" + std::to_string(i - 1) + "; }";
  }
  const Loaded cycle(chain + " }");
  EXPECT_NE(cycle.said().find("P08 error: these tasks wait for each other"), std::string::npos);

  std::string wrong = "plan p {";
  for (int i = 0; i < 20000; ++i) {
    wrong += " task task_number_" + std::to_string(i) + " { takes 0; after task_nubmer_" +
             std::to_string(i) + "; }";
  }
  const Loaded unknown(wrong + " }");
  EXPECT_EQ(unknown.diagnostics.errors(), 20000);
}

}  // namespace

}  // namespace rubicon::test
