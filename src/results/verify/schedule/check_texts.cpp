#include "src/results/verify/schedule/check_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/results/verify/schedule/task_clock.hpp"

namespace rubicon::verify {

namespace {

using math::at;

/// Attributes that have a column of their own.
constexpr std::array kOwnColumns = {"name", "storey", "type", "guid"};

const SceneTask* scene_task_of(const Scene& scene, const ScheduleRow& row) {
  const auto known = scene.task_index.find(row.task);
  return known == scene.task_index.end() || scene.short_form ? nullptr
                                                             : &scene.tasks[at(known->second)];
}

std::string attribute_of(const SceneAttributes& attributes, const char* key) {
  const auto found = attributes.find(key);
  return found == attributes.end() ? std::string() : found->second;
}

/// Whether a text is these in some order with "; " between them.
bool is_list_of(const std::string& text, const std::vector<std::string>& parts) {
  std::size_t length = parts.empty() ? 0 : 2 * (parts.size() - 1);
  for (const std::string& part : parts) {
    if (text.find(part) == std::string::npos) return false;
    length += part.size();
  }
  return text.size() == length;
}

/// The name of the first of the columns that is not as the trace says; "" if all are.
std::string wrong_column(const RowTexts& texts, const SceneAttributes& own,
                         const SceneComponent* component) {
  static const SceneAttributes kNone;
  const SceneAttributes& its = component == nullptr ? kNone : component->attributes;
  const auto either = [&](const char* key) {
    return own.contains(key) ? attribute_of(own, key) : attribute_of(its, key);
  };
  if (texts.name != attribute_of(own, "name")) return "name";
  if (texts.component != (component == nullptr ? "" : component->name)) return "component";
  if (texts.component_name != attribute_of(its, "name")) return "component_name";
  if (texts.storey != either("storey")) return "storey";
  if (texts.type != either("type")) return "type";
  if (texts.guid != either("guid")) return "guid";
  std::vector<std::string> parts;
  for (const SceneAttributes* attributes : {&own, &its}) {
    for (const auto& [key, text] : *attributes) {
      if (std::find(kOwnColumns.begin(), kOwnColumns.end(), key) != kOwnColumns.end()) continue;
      parts.push_back(fmt::format("{}={}", key, text));
    }
  }
  return is_list_of(texts.attributes, parts) ? "" : "attributes";
}

bool is_figure(const std::optional<double>& found, double expected) {
  return !found || std::fabs(*found - expected) <= 1e-6 + 1e-9 * std::fabs(expected);
}

/// The name of the first figure that is not what the trace gives; "" if all are.
std::string wrong_figure(const RowCover& row, const SceneCover& cover) {
  if (row.area != cover.area) return "area";
  if (!is_figure(row.covered, cover.covered)) return "covered";
  if (!is_figure(row.covered_area, cover.covered_area)) return "covered_area";
  if (!is_figure(row.volume, cover.covered_area * cover.thickness)) return "volume";
  if (!is_figure(row.length, cover.length)) return "length";
  if (!is_figure(row.depth, cover.depth)) return "depth";
  if (row.turns.value_or(cover.turns) != cover.turns) return "turns";
  return row.holes.value_or(cover.holes) != cover.holes ? "holes" : "";
}

}  // namespace

void check_texts(const Scene& scene, const ScheduleJson& schedule, Faults& faults) {
  for (const ScheduleRow& row : schedule.rows) {
    const auto fault = [&](std::string text) {
      faults.push_back({FaultKind::schedule, ResultFile::schedule_json, row.line, row.task,
                        row.start, std::move(text)});
    };
    const SceneTask* const task = scene_task_of(scene, row);
    if (row.attributes != (task == nullptr ? SceneAttributes() : task->attributes)) {
      fault("its name or another attribute is not that of the trace");
    }
    const bool is_known = scene.short_form || scene.task_index.contains(row.task);
    if (row.parking == is_known) fault("'parking' is not what the trace says");
    if (task != nullptr) {
      const std::string moved = task->move < 0 ? "" : scene.components[at(task->move)].name;
      if (row.component != moved) fault("'component' is not what the trace says");
      // By pools: "low of cranes: the first that is free".
      const std::string members = task->members.substr(0, task->members.find(','));
      if (row.result == "done" && !row.choice.starts_with(members)) {
        fault("'choice' does not name whom the trace says it had");
      }
    }
    // Of a choice of machines each may have a way of its own.
    if (task == nullptr || !task->choices.empty()) continue;
    if (row.cover.has_value() != task->cover.has_value()) {
      fault("what it covers is not told, or the trace has nothing of it");
    } else if (row.cover) {
      const std::string wrong = wrong_figure(*row.cover, *task->cover);
      if (!wrong.empty())
        fault(fmt::format("'{}' of what it covers is not that of the trace", wrong));
    }
  }
  for (const UseRow& use : schedule.uses) {
    const auto is_robot = [&](const auto& robot) { return robot.name == use.name; };
    const bool robot = std::any_of(scene.robots.begin(), scene.robots.end(), is_robot);
    if (use.kind == (robot ? "robot" : "crew")) continue;
    faults.push_back({FaultKind::schedule, ResultFile::schedule_json, use.line, use.name, -1,
                      "its kind is not that of the trace"});
  }
  std::map<std::string, SceneAttributes> told;
  for (const SceneComponent& component : scene.components) {
    if (!component.attributes.empty()) told[component.name] = component.attributes;
  }
  if (schedule.components == told) return;
  const auto [here, there] = std::mismatch(schedule.components.begin(), schedule.components.end(),
                                           told.begin(), told.end());
  const std::string& name = here == schedule.components.end() ? there->first : here->first;
  faults.push_back(
      {FaultKind::schedule, ResultFile::schedule_json, 0, "", -1,
       fmt::format("the attributes of component {} are not those of the trace", name)});
}

void check_texts(const Scene& scene, const std::vector<ScheduleRow>& rows_of_csv, Faults& faults) {
  static const SceneAttributes kNone;
  for (const ScheduleRow& row : rows_of_csv) {
    if (!row.texts) continue;
    const SceneTask* const task = scene_task_of(scene, row);
    const SceneComponent* const component =
        task == nullptr || task->move < 0 ? nullptr : &scene.components[at(task->move)];
    const std::string wrong =
        wrong_column(*row.texts, task == nullptr ? kNone : task->attributes, component);
    if (wrong.empty()) continue;
    faults.push_back({FaultKind::schedule, ResultFile::schedule_csv, row.line, row.task, row.start,
                      fmt::format("'{}' is not what the trace says", wrong)});
  }
}

void check_same_floats(const std::vector<ScheduleRow>& json, const std::vector<ScheduleRow>& csv,
                       Faults& faults) {
  // That both have a row for each task is seen from the trace.
  if (json.size() != csv.size()) return;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    const auto& a = json[i].floats;
    const auto& b = csv[i].floats;
    const auto differ = [](Ticks one, Ticks other) { return std::llabs(one - other) > kTimeSlack; };
    const bool same = a.has_value() == b.has_value() && json[i].task == csv[i].task &&
                      (!a || (!differ(a->total, b->total) && !differ(a->free, b->free)));
    if (same) continue;
    faults.push_back({FaultKind::schedule, ResultFile::schedule_csv, csv[i].line, csv[i].task,
                      csv[i].start, "its float is not that of schedule.json"});
  }
}

}  // namespace rubicon::verify
