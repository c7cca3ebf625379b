#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include "interpreter/check/plan_model.hpp"
#include "src/exchange/building_io/building_plan.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "tests/support/ifc_sample.hpp"
#include "tests/unit/building_io/building_support.hpp"
#include "tests/unit/mesh_io/mesh_files_io.hpp"

// Elements that no honest program writes, and names made to break out of where they stand: whatever
// an import makes of them, the checker takes it.

namespace rubicon::building_io {
namespace {

using mesh_io::testing::TemporaryFolder;

/// Random choices that are the same everywhere.
class Choice {
 public:
  explicit Choice(unsigned seed) : random_(seed) {}
  std::size_t below(std::size_t count) { return random_() % count; }
  template <typename List>
  auto of(const List& list) {
    return list[below(list.size())];
  }

 private:
  std::mt19937 random_;
};

const std::vector<std::string> kNames = {"",
                                         "a",
                                         "a",
                                         "-0",
                                         "7",
                                         "component",
                                         "task",
                                         "plan",
                                         "at",
                                         "grip",
                                         "a\"; } task x { takes 1 h; }",
                                         "a\" b",
                                         "x // y",
                                         "/* x",
                                         "*/ }",
                                         "set_a",
                                         "\xC3\xA9\xE2\x80\xA8\xF0\x9F\x8F\x97",
                                         "\xFF\xFE",
                                         "a\tb",
                                         "CON",
                                         std::string(300, 'n')};

const std::vector<double> kSizes = {0, -0.0, 1e-9, 4e-7, 1e-6, 6e-6, 1e-3, 1, 60, 1e4, 9e6, 3e7};
const std::vector<double> kPlaces = {0, -0.0, 1e-6, -0.000004, 12.345678901, 155000.1234, -9.9e6};

/// Flat elements, lines, points and huge ones: a box whose sides may be 0.
struct HostileBox {
  geometry::Vec3 at;
  geometry::Vec3 size;
};

HostileBox hostile_box(Choice& choice) {
  HostileBox box;
  for (int k = 0; k < 3; ++k) {
    box.at[k] = choice.below(3) == 0 ? choice.of(kPlaces) : 1;
    box.size[k] = choice.below(3) == 0 ? choice.of(kSizes) : 2;
  }
  return box;
}

mesh_io::testing::Soup hostile_soup(Choice& choice) {
  const HostileBox box = hostile_box(choice);
  auto soup = mesh_io::testing::box_soup(box.at, box.at + box.size);
  if (choice.below(30) == 0) soup[1][1].x() = std::nan("");
  if (choice.below(30) == 0) soup[1][1].y() = HUGE_VAL;
  if (choice.below(4) == 0) soup.resize(2);  // a sheet
  return soup;
}

/// OBJ text of several objects.
std::string hostile_obj(Choice& choice) {
  std::string text;
  int base = 1;
  for (std::size_t i = 0; i <= choice.below(3); ++i) {
    std::string name = choice.of(kNames);
    std::replace(name.begin(), name.end(), '\n', ' ');
    text += "o " + name + "\n";
    const auto soup = hostile_soup(choice);
    for (const auto& triangle : soup) {
      for (const auto& p : triangle) text += fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
    }
    for (std::size_t t = 0; t < soup.size(); ++t, base += 3) {
      text += fmt::format("f {} {} {}\n", base, base + 1, base + 2);
    }
  }
  return text;
}

/// As it stands in a STEP file.
std::string step_text(const std::string& name) {
  std::string text;
  for (const char c : name) text += c == '\'' ? std::string("''") : std::string(1, c);
  return text;
}

std::string hostile_ifc(Choice& choice) {
  rubicon::testing::IfcSample sample;
  sample.schema = choice.below(2) == 0 ? "IFC2X3" : "IFC4";
  sample.shape = choice.of(std::vector<std::string>{"extrusion", "brep", "triangles"});
  sample.unit = choice.of(std::vector<std::string>{"mm", "m"});
  sample.storeys = {step_text(choice.of(kNames)), "Ground floor"};
  if (choice.below(5) == 0) sample.site = {choice.of(kPlaces), choice.of(kPlaces), 0};
  sample.blocks.clear();
  for (std::size_t i = 0; i <= choice.below(3); ++i) {
    const HostileBox box = hostile_box(choice);
    sample.blocks.push_back({"IFCWALL",
                             step_text(choice.of(kNames)),
                             {box.at.x(), box.at.y(), box.at.z()},
                             {box.size.x(), box.size.y(), box.size.z()},
                             static_cast<int>(choice.below(2))});
  }
  std::string text = ifc_text(sample);
  // A GlobalId that another element has, that is none, or that would end a text.
  const std::string id = rubicon::testing::block_id(0);
  const std::vector<std::string> ids = {rubicon::testing::block_id(1), "", "\"", "x"};
  if (choice.below(3) == 0) text.replace(text.find(id), id.size(), choice.of(ids));
  return text;
}

struct Outcome {
  bool written = false;
  std::size_t components = 0;
};

/// Imports a model, alone or with a schedule, writes what is to be written, and checks the plan.
Outcome import_and_check(const std::string& name, const std::string& bytes, bool with_tasks) {
  Outcome outcome;
  const TemporaryFolder folder;
  files::DiskFiles disk;
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  ModelTerms terms;
  terms.folder = folder.path().string();
  if (!name.ends_with(".ifc")) terms.unit = "m";
  const Elements elements =
      read_elements({{folder.write(name, bytes), name, bytes}}, terms, disk.meshes(), diagnostics);
  if (diagnostics.has_errors()) return outcome;
  const project_io::Project project = test::schedule_of({"Put up", "a", "task"});
  BuildingPlan plan;
  if (with_tasks) {
    const MatchFile match =
        read_match_file(sources,
                        sources.add("a.match",
                                    "plan { robot r \"r.robot\"; }\n"
                                    "stock box(-9e5, -9e5, 0, -100, 9e5, 9e5);\nby r;\n"
                                    "grip trans(0, 0, 1.5);\n-> task \"Put up\";"),
                        diagnostics);
    const BuildingTasks tasks{&project, "a.xml", &match};
    plan = building_under_work(elements, tasks, {"house", "house_meshes"}, diagnostics);
  } else {
    plan = standing_building(elements, {"house", "house_meshes"});
  }
  if (diagnostics.has_errors()) return outcome;
  outcome.written = true;
  std::filesystem::create_directory(folder.path() / "house_meshes");
  for (const auto& mesh : plan.meshes) folder.write(mesh.name, mesh.text);
  folder.write("r.robot",
               "robot r { body b { param x range(0, 9) step(1); frame trans(x, 0, 0); } tool b; "
               "behaviour { chain { move_to(x, goal(x)) }; } }");
  interpreter::Diagnostics check;
  const auto model = load_plan(folder.write("house.plan", plan.plan), sources, disk, check);
  EXPECT_TRUE(model) << ::testing::PrintToString(test::said(check, sources)) << plan.plan;
  if (model) outcome.components = model->components.size();
  return outcome;
}

void import_many(const std::string& name, std::string (*make)(Choice&), unsigned count) {
  std::size_t written = 0;
  std::size_t components = 0;
  for (unsigned seed = 0; seed < count && !::testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(fmt::format("{} of seed {}", name, seed));
    Choice choice(seed);
    const std::string bytes = make(choice);
    const Outcome outcome = import_and_check(name, bytes, seed % 2 == 1);
    written += outcome.written ? 1 : 0;
    components += outcome.components;
  }
  // Otherwise the test would show nothing.
  EXPECT_GT(written, count / 3);
  EXPECT_GT(components, count / 2);
}

TEST(HostileElements, OfIfcMakePlansThatPassTheCheck) { import_many("a.ifc", hostile_ifc, 60); }
TEST(HostileElements, OfObjMakePlansThatPassTheCheck) { import_many("a.obj", hostile_obj, 60); }

TEST(HostileElements, AFlatOneHasAGrip) {
  const std::string sheet = "o sheet\nv 0 0 1\nv 2 0 1\nv 2 1 1\nv 0 1 1\nf 1 2 3\nf 1 3 4\n";
  for (const bool with_tasks : {false, true}) {
    const Outcome outcome = import_and_check("a.obj", sheet, with_tasks);
    EXPECT_TRUE(outcome.written);
    EXPECT_EQ(outcome.components, 1U);
  }
}

TEST(HostileElements, ANameThatAGroupHasTooIsNoPart) {
  // The group 'a' holds the node 'a' and another one: part "a" would be both.
  const std::string buffer =
      mesh_io::testing::as_gltf(mesh_io::testing::box_soup({0, 0, 0}, {1, 1, 1}), "");
  std::string text = buffer;
  const std::string node = "{\"mesh\":0,\"name\":\"body\"}";
  text.replace(text.find(node), node.size(),
               "{\"name\":\"a\",\"children\":[1,2]},{\"mesh\":0,\"name\":\"a\"},"
               "{\"mesh\":0,\"name\":\"b\",\"translation\":[5,0,0]}");
  const Outcome outcome = import_and_check("a.gltf", text, false);
  EXPECT_TRUE(outcome.written);
  EXPECT_EQ(outcome.components, 2U);
}

}  // namespace
}  // namespace rubicon::building_io
