#include "src/exchange/building_io/building_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/check/plan_model.hpp"
#include "src/exchange/building_io/component_text.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/exchange/project_io/project_of.hpp"
#include "tests/support/ifc_sample.hpp"
#include "tests/unit/building_io/building_support.hpp"
#include "tests/unit/mesh_io/mesh_files_io.hpp"

namespace rubicon::building_io {
namespace {

using mesh_io::testing::TemporaryFolder;
using test::element_at;
using test::schedule_of;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

Elements three_elements() {
  Elements elements;
  elements.all = {element_at("Ground", "IfcSlab", "slab", {5, 1, 0}),
                  element_at("Ground", "IfcWall", "wall", {5, 1, 0.3}),
                  element_at("Ground", "IfcDoor", "door", {6, 1, 0.3})};
  elements.notes = {"a.ifc: IFC4, 3 elements"};
  return elements;
}

struct Written {
  BuildingPlan plan;
  std::vector<std::string> said;
};

Written write(const Elements& elements, const project_io::Project& project,
              const std::string& rules) {
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  const MatchFile match = read_match_file(sources, sources.add("a.match", rules), diagnostics);
  Written result;
  BuildingTasks tasks{&project, "a.xml", &match};
  result.plan = building_under_work(elements, tasks, {"house", "house_meshes"}, diagnostics);
  result.said = test::said(diagnostics, sources);
  return result;
}

constexpr const char* kRules =
    "plan { crew crane; }\n"
    "stock box(-20, -5, 0, -5, 5, 4);\nby crane; hook 3 min by crane; density 2400;\n"
    "type IfcSlab -> task \"Floor\";\ntype IfcWall -> task \"Walls\" { unlinked; };\n";

/// The text of one task of a plan.
std::string task_text(const std::string& plan, const std::string& name) {
  const std::size_t begin = plan.find("  task " + name + " {");
  if (begin == std::string::npos) return {};
  return plan.substr(begin, plan.find("\n  }\n", begin) - begin);
}

TEST(BuildingPlan, AStandingBuildingHasEveryElementWhereTheModelHasIt) {
  Elements elements = three_elements();
  elements.all[1].frame.turn_deg = 90;
  elements.origin = {5, 0, 0};
  const BuildingPlan plan = standing_building(elements, {"My house 2", "m"});
  EXPECT_THAT(plan.plan, HasSubstr("plan my_house_2 {\n  // a.ifc: IFC4, 3 elements\n"));
  EXPECT_THAT(plan.plan, HasSubstr("// The point 5, 0, 0 of the model is the origin of this plan"));
  EXPECT_THAT(plan.plan, HasSubstr("  component wall {\n"
                                   "    name \"wall\";\n"
                                   "    storey \"Ground\";\n"
                                   "    type \"IfcWall\";\n"
                                   "    guid \"0block$_00000000000000\";\n"
                                   "    shape mesh(\"a.ifc\", part \"0block$_00000000000000\") at "
                                   "rotz(-90) * trans(-5, -1, -0.3);\n"
                                   "    at trans(0, 1, 0.3) * rotz(90);\n"
                                   "    grip trans(0, 0, 2.5);\n  }\n"));
  EXPECT_THAT(
      plan.elements,
      HasSubstr("wall,Ground,IfcWall,wall,0block$_00000000000000,a.ifc,stands,,,,0,1,0.3,90"));
  EXPECT_THAT(plan.meshes, IsEmpty());
}

TEST(BuildingPlan, TasksPutTheElementsUpBetweenMilestones) {
  project_io::Project project = schedule_of({"Dig", "Floor", "Walls", "Roof"});
  // Floor after Dig, Walls 2 h behind the start of Floor and ending with it, Roof after Walls.
  const auto link = [&](std::size_t to, std::int64_t from, project_io::LinkType type,
                        std::int64_t lag) {
    project_io::Link made;
    made.predecessor = from;
    made.type = type;
    made.lag = lag;
    made.format.elapsed = true;
    project.tasks[to].after.push_back(made);
  };
  link(1, 1, project_io::LinkType::FS, 0);
  link(2, 2, project_io::LinkType::SS, 7200);
  link(2, 2, project_io::LinkType::FF, 0);
  link(3, 3, project_io::LinkType::FS, 0);
  const Written written = write(three_elements(), project, kRules);
  const std::string& plan = written.plan.plan;
  EXPECT_THAT(task_text(plan, "floor_begins"), HasSubstr("after dig;"));
  EXPECT_THAT(task_text(plan, "set_slab"),
              HasSubstr("by crane;\n    move slab to trans(5, 1, 0);\n    hook 3 min by crane;\n"
                        "    after floor_begins;"));
  EXPECT_THAT(task_text(plan, "floor_ends"), HasSubstr("after floor_begins, set_slab;"));
  EXPECT_THAT(task_text(plan, "walls_begins"), HasSubstr("after floor_begins FS + 2 h;"));
  // What is not linked is not waited for.
  EXPECT_THAT(task_text(plan, "walls_ends"), HasSubstr("after floor_ends FF, walls_begins;"));
  EXPECT_THAT(task_text(plan, "roof"), HasSubstr("after walls_ends;"));
  EXPECT_THAT(plan, Not(HasSubstr("task floor {")));
  EXPECT_THAT(plan, HasSubstr("// Floor (1 part; 8 h in the schedule)"));
  EXPECT_THAT(plan, HasSubstr("mass 2400;"));
  EXPECT_THAT(written.plan.elements,
              HasSubstr(",moved,floor,8,set_slab,5,1,0,0,2,0.2,2.5,1,2400\n"));
}

TEST(BuildingPlan, WhatFindsNoPartnerIsListedOnBothSides) {
  const Written written = write(three_elements(), schedule_of({"Dig", "Floor", "Walls"}), kRules);
  EXPECT_THAT(written.plan.plan,
              HasSubstr("// 1 task without an element; they keep their duration:\n"
                        "  //   dig\n"));
  EXPECT_THAT(written.plan.plan,
              HasSubstr("// 1 element that no rule is about; no part of the plan:\n"
                        "  //   'Ground', IfcDoor 'door', 0block$_00000000000000\n"));
  EXPECT_THAT(written.plan.plan, Not(HasSubstr("component door")));
  EXPECT_THAT(written.plan.elements, HasSubstr("door,Ground,IfcDoor,door,"));
  SCOPED_TRACE(::testing::PrintToString(written.said));
  EXPECT_TRUE(test::says(written.said, "I16 1 task of the schedule without an element"));
  EXPECT_TRUE(test::says(written.said,
                         "I15 1 element that no rule is about; no part of the plan: 1 "
                         "IfcDoor 'door' of 'Ground'"));
}

TEST(BuildingPlan, TooLittleRoomAndNoMassAreTold) {
  Elements elements = three_elements();
  elements.all[0].frame.volume = 0;
  const Written small = write(elements, schedule_of({"Floor", "Walls"}),
                              "stock yard box(0, 0, 0, 1, 1, 1);\nby a; density 1;\n"
                              "type IfcSlab -> task \"Floor\" { stock yard; }\n"
                              "type IfcWall -> task \"Walls\";");
  EXPECT_TRUE(
      test::says(small.said, "I17 1 of 2 elements without room in stock area 'yard': slab"));
  EXPECT_TRUE(test::says(small.said, "I17 1 of 2 elements without room in the stock areas: wall"));
  EXPECT_TRUE(test::says(small.said,
                         "I18 1 element without a mass, for the surface is not closed; taken as "
                         "the box around it, filled: slab"));
  EXPECT_THAT(small.plan.plan, HasSubstr("// the box around it, filled: 1 kg/m3"));
  const Written none =
      write(elements, schedule_of({"Floor"}), "by a; type IfcSlab -> task \"Floor\";");
  EXPECT_TRUE(test::says(none.said, "without room for there is no stock area: slab"));
  EXPECT_TRUE(test::says(none.said,
                         "I18 1 element without a mass or a density in its rule: taken "
                         "as reinforced concrete, 2500 kg/m3: slab"));
  EXPECT_THAT(none.plan.plan, HasSubstr("// the box around it, filled: 2500 kg/m3"));
}

TEST(BuildingPlan, RobotsAndTasksKeepTheirNamesBesideThoseOfTheSchedule) {
  project_io::Project project = schedule_of({"Floor", "set slab"});
  project_io::Resource resource;
  resource.uid = 1;
  resource.name = "Crane";
  project.resources.push_back(resource);
  const Written written = write(three_elements(), project, kRules);
  EXPECT_THAT(written.plan.plan, HasSubstr("crew crane;"));
  EXPECT_THAT(written.plan.plan, HasSubstr("crew crane_2"));
  EXPECT_THAT(written.plan.plan, HasSubstr("task set_slab_2 {"));
  EXPECT_THAT(task_text(written.plan.plan, "set_slab"), HasSubstr("move slab"));
}

/// Reads a plan with its models from the disk.
std::unique_ptr<interpreter::PlanModel> load(const std::string& path,
                                             interpreter::SourceMap& sources) {
  files::DiskFiles disk;
  interpreter::Diagnostics diagnostics;
  auto plan = load_plan(path, sources, disk, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors())
      << ::testing::PrintToString(test::said(diagnostics, sources));
  return plan;
}

TEST(BuildingPlan, TheScheduleComesBackFromAPlanThatIsPutUp) {
  project_io::Project project = schedule_of({"Dig", "Floor", "Walls"});
  project_io::Link link;
  link.predecessor = 1;
  project.tasks[1].after.push_back(link);
  link.predecessor = 2;
  project.tasks[2].after.push_back(link);
  project.start.text = "2026-03-02 07:00";
  project.tasks[1].actual_start.text = "2026-03-03 07:00";
  Elements elements = three_elements();
  // Without files: shapes of their own are not needed to come back.
  Written written =
      write(elements, project,
            "plan { robot crane \"crane.robot\"; }\nstock box(-20, -5, 0, -5, 5, 4);\n"
            "by crane;\ntype IfcSlab -> task \"Floor\";");
  // In parts a task that has begun is at least not earlier.
  EXPECT_THAT(written.plan.plan, HasSubstr("after dig, plan_begins FS + 24 h;"));
  const TemporaryFolder folder;
  folder.write(
      "crane.robot",
      "robot crane { body b { param x range(0, 9) step(1); frame trans(x, 0, 0); } tool b; "
      "behaviour { chain { move_to(x, goal(x)) }; } }");
  folder.write("a.ifc", [] {
    rubicon::testing::IfcSample sample;
    std::string text = rubicon::testing::ifc_text(sample);
    const std::string id = rubicon::testing::block_id(0);
    return text.replace(text.find(id), id.size(), "0block$_00000000000000");
  }());
  interpreter::SourceMap sources;
  const auto plan = load(folder.write("house.plan", written.plan.plan), sources);
  ASSERT_TRUE(plan);
  interpreter::Diagnostics diagnostics;
  const project_io::Project back = project_io::project_of(*plan, sources, diagnostics);
  EXPECT_EQ(back.tasks, project.tasks);
}

TEST(BuildingPlan, EveryShapeEndsWhereTheModelHasIt) {
  rubicon::testing::IfcSample sample;
  sample.schema = "IFC4";
  sample.site = {155000.1234, 463000.5678, 12};
  sample.blocks = {{"IFCWALL", "a", {0, 0, 0}, {4, 0.2, 2.5}, 0},
                   {"IFCWALL", "b", {0, 7, 0}, {0.2, 4, 2.5}, 0}};
  const std::string text = rubicon::testing::ifc_text(sample);
  const test::ReadModels read = test::read_models({{"a.ifc", text}});
  const TemporaryFolder folder;
  folder.write("a.ifc", text);
  const BuildingPlan written = standing_building(read.elements, {"house", "m"});
  interpreter::SourceMap sources;
  const auto plan = load(folder.write("house.plan", written.plan), sources);
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->components.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const interpreter::ComponentSpec& component = plan->components[i];
    ASSERT_EQ(component.shapes.size(), 1U);
    const auto& mesh = *std::get<geometry::Mesh>(component.shapes[0].solid).mesh;
    const math::Pose X = component.X_WO * component.shapes[0].X_BS;
    Vec3 low = Vec3::Constant(1e9);
    for (const Vec3& p : mesh.vertices) low = low.cwiseMin(X * p);
    const Vec3 place(sample.blocks[i].at[0], sample.blocks[i].at[1], sample.blocks[i].at[2]);
    const Vec3 expected = place + Vec3(0.1234, 0.5678, 12);
    EXPECT_LT((low - expected).norm(), 1e-6) << low.transpose();
  }
}

TEST(BuildingPlan, NumbersAndFramesAreShort) {
  EXPECT_EQ(number_text(1.5), "1.5");
  EXPECT_EQ(number_text(-0.000001), "0");
  EXPECT_EQ(number_text(155000.12345), "155000.12345");
  EXPECT_EQ(number_text(100), "100");
  EXPECT_EQ(frame_text({0, 0, 0}, 0), "");
  EXPECT_EQ(frame_text({0, 0, 0}, 90), "rotz(90)");
  EXPECT_EQ(frame_text({1, 0, -2}, 0), "trans(1, 0, -2)");
}

}  // namespace
}  // namespace rubicon::building_io
