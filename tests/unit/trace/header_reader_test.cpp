#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "src/simulation/trace/header.hpp"
#include "src/simulation/trace/trace_reader.hpp"
#include "tests/support/header_json.hpp"
#include "tests/unit/trace/written_records.hpp"

namespace rubicon::trace {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;

/// What a header is answered with; "" if it is read.
std::string answer_to_header(const std::string& line) {
  try {
    read_header(line);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(HeaderReader, ReadsWhatIsWritten) {
  const interpreter::PlanModel plan = test::rich_plan();
  const TraceHeader header = read_header(test::written_header(plan));
  EXPECT_EQ(header.plan, plan.name);
  EXPECT_EQ(header.detail, "steps");
  EXPECT_EQ(header.start_at, "2026-11-23 07:00");
  EXPECT_EQ(header.files.at(0).path, "crane.motion");
  EXPECT_EQ(header.files.at(0).sha256.size(), 64u);
  EXPECT_EQ(header.calendars.at(0).shifts.at(0).minutes.at(1), (std::pair{780, 960}));
  EXPECT_TRUE(header.calendars.at(0).carry_over);
  ASSERT_EQ(header.components.size(), plan.components.size());
  const HeaderComponent& slab = header.components.back();
  const interpreter::ComponentSpec& spec = plan.components.back();
  EXPECT_EQ(slab.X_WO.matrix(), spec.X_WO.matrix());
  EXPECT_EQ(slab.mass, spec.mass);
  ASSERT_EQ(slab.shapes.size(), spec.shapes.size());
  for (std::size_t i = 0; i < slab.shapes.size(); ++i) {
    EXPECT_EQ(slab.shapes[i].solid.index(), spec.shapes[i].solid.index());
    EXPECT_EQ(slab.shapes[i].X_BS.matrix(), spec.shapes[i].X_BS.matrix());
  }
  EXPECT_EQ(std::get<geometry::Mesh>(slab.shapes[1].solid).mesh->vertices.size(), 3u);
  EXPECT_EQ(std::get<geometry::Capsule>(slab.shapes[4].solid).b, math::Vec3(4, 5, 6));
  EXPECT_EQ(std::get<geometry::Prism>(slab.shapes[5].solid).polygon.at(2).y(), 1);
  EXPECT_EQ(slab.attributes.at(0), (std::pair<std::string, std::string>{"storey", "2"}));
  EXPECT_EQ(header.tasks.back().attributes.at(0).second, "60 min");
  const HeaderRobot& robot = header.robots.at(0);
  EXPECT_EQ(robot.start, plan.robots[0].start);
  EXPECT_EQ(robot.parameters.at(1).formula, "x + x_s");
  EXPECT_EQ(robot.parameters.at(3).upper, std::nullopt);
  EXPECT_EQ(robot.bodies.at(2).parent, "jib");
  EXPECT_EQ(robot.bodies.at(2).frame, "trans(x, 0, z) * rotz(hook.theta)");
  const HeaderTask& task = header.tasks.back();
  EXPECT_EQ(task.move, "slab");
  EXPECT_EQ(task.hook.value().duration, 240);
  EXPECT_EQ(task.within.at(0), (std::pair<std::string, double>{"length", 0.01}));
  EXPECT_EQ(task.via.at(0).values.at(0).second, 5);
  EXPECT_EQ(task.zones.size(), 1u);
}

TEST(HeaderReader, RefusesOtherFormatsAndVersions) {
  const auto changed = [](const char* name, const ordered_json& value) {
    ordered_json header = test::whole_header({});
    header[name] = value;
    return answer_to_header(header.dump());
  };
  EXPECT_EQ(answer_to_header(test::whole_header({}).dump()), "");
  EXPECT_THAT(changed("format", "other"), HasSubstr("this is no trace"));
  EXPECT_THAT(changed("format", "other"), HasSubstr("expected \"rubicon-trace\""));
  EXPECT_THAT(changed("type", "try"), HasSubstr("this is no trace"));
  EXPECT_THAT(changed("version", 2),
              HasSubstr("the trace has version 2; this rubicon reads 1: read it with"));
  EXPECT_THAT(changed("version", "x"), HasSubstr("'version'"));
  for (const char* text : {"", "x", "[]", "7", "null", "{}", "\xff", "{\"type\":\"header\"}"}) {
    EXPECT_THAT(answer_to_header(text), HasSubstr("this is no trace")) << text;
  }
}

/// Every member, at every depth: missing, doubled or of another kind, it is refused.
TEST(HeaderReader, WantsEveryMemberOnceAndOfItsKind) {
  const auto whole = ordered_json::parse(test::written_header(test::rich_plan()));
  // What need not be there: of tasks, and of a short plan.
  const std::set<std::string> optional = {
      "go",      "via",   "within", "situations", "hook",       "adjust",         "goal",
      "release", "takes", "remove", "move",       "attributes", "zones_overhead", "overhead"};
  for (const auto& [name, value] : whole.items()) {
    if (name == "support") continue;  // only verify reads it
    ordered_json header = whole;
    header.erase(name);
    EXPECT_EQ(answer_to_header(header.dump()).empty(), name == "movings") << name;
    header = whole;
    header[name] = ordered_json::object({{"a", true}});
    EXPECT_NE(answer_to_header(header.dump()), "") << name;
    const std::string text = whole.dump();
    EXPECT_THAT(answer_to_header(text.substr(0, text.size() - 1) + ",\"" + name + "\":1}"),
                HasSubstr("has two '" + name + "'"));
  }
  for (const char* list :
       {"calendars", "files", "movings", "components", "robots", "tasks", "meshes"}) {
    for (const auto& [name, value] : whole.at(list).back().items()) {
      ordered_json header = whole;
      header[list].back().erase(name);
      EXPECT_TRUE(optional.contains(name) || !answer_to_header(header.dump()).empty())
          << list << " " << name;
      header[list].back()[name] = true;
      EXPECT_TRUE(value.is_boolean() || !answer_to_header(header.dump()).empty())
          << list << " " << name;
    }
  }
}

TEST(HeaderReader, RefersOnlyToWhatIsThere) {
  const auto whole = ordered_json::parse(test::written_header(test::rich_plan()));
  const auto changed = [&](const char* place, const ordered_json& value) {
    ordered_json header = whole;
    header[ordered_json::json_pointer(place)] = value;
    return answer_to_header(header.dump());
  };
  EXPECT_THAT(changed("/components/0/shapes/1/mesh", 1), HasSubstr("a mesh of the header"));
  EXPECT_THAT(changed("/meshes/0/triangles", {0, 1, 3}), HasSubstr("triangle at number 3"));
  EXPECT_THAT(changed("/meshes/0/triangles", {0, 1}), HasSubstr("three corners"));
  EXPECT_THAT(changed("/meshes/0/vertices", {0, 1}), HasSubstr("three numbers"));
  EXPECT_THAT(changed("/robots/0/bodies/1/parent", "roof"), HasSubstr("a body before this one"));
  EXPECT_THAT(changed("/robots/0/tool/body", "roof"), HasSubstr("a body of the robot"));
  EXPECT_THAT(changed("/robots/0/start", ordered_json::object()), HasSubstr("it has no"));
  EXPECT_THAT(changed("/robots/0/pose/0", 2), HasSubstr("a rotation and a translation"));
  EXPECT_THAT(changed("/calendars/0/shifts/0/days", {0, 7}), HasSubstr("from 0 to 6"));
}

}  // namespace
}  // namespace rubicon::trace
