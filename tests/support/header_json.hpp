#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace rubicon::test {

/// Adds the members of `more` that an object does not have.
inline void add_missing(nlohmann::ordered_json& object, const nlohmann::ordered_json& more) {
  for (const auto& [name, value] : more.items()) {
    if (!object.contains(name)) object[name] = value;
  }
}

/// The header of a trace made whole: what a test says nothing of is empty, 0 or nowhere.
inline nlohmann::ordered_json whole_header(nlohmann::ordered_json header) {
  using Json = nlohmann::ordered_json;
  const Json pose = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  const Json none = Json::array();
  add_missing(header, {{"type", "header"},    {"format", "rubicon-trace"},
                       {"version", 1},        {"plan", "p"},
                       {"path", "p.plan"},    {"form", "full"},
                       {"detail", "steps"},   {"contact", 0.001},
                       {"budget", 1000},      {"situations", none},
                       {"start_at", nullptr}, {"currency", ""},
                       {"calendars", none},   {"files", none},
                       {"site", none},        {"components", none},
                       {"robots", none},      {"carry", none},
                       {"crews", none},       {"tasks", none},
                       {"meshes", none}});
  for (Json& file : header["files"]) add_missing(file, {{"sha256", std::string(64, '0')}});
  for (Json& component : header["components"]) {
    add_missing(component, {{"pose", pose}, {"grip", pose}, {"mass", 0}, {"shapes", none}});
  }
  for (Json& crew : header["crews"]) {
    add_missing(crew, {{"size", 1}, {"cost_per_hour", nullptr}, {"calendar", ""}});
  }
  for (Json& task : header["tasks"]) {
    add_missing(
        task, {{"robot", ""}, {"crews", none}, {"priority", 0}, {"zones", none}, {"after", none}});
  }
  for (Json& robot : header["robots"]) {
    add_missing(robot, {{"type", "machine"},
                        {"path", "m.robot"},
                        {"pose", pose},
                        {"start", Json::object()},
                        {"cost_per_hour", nullptr},
                        {"calendar", ""},
                        {"park", nullptr},
                        {"time_step", 1},
                        {"sensor", 0},
                        {"parameters", none},
                        {"bodies", Json::array({{{"name", "base"}}})},
                        {"touching", none},
                        {"capacity", none}});
    for (Json& body : robot["bodies"]) {
      add_missing(body, {{"parent", nullptr}, {"frame", "trans(0, 0, 0)"}, {"shapes", none}});
    }
    const Json first = robot["bodies"][0]["name"];
    add_missing(robot, {{"tool", {{"body", first}, {"frame", "trans(0, 0, 0)"}}}});
    if (robot["parameters"].empty()) {
      for (const auto& [name, value] : robot["start"].items()) {
        robot["parameters"].push_back({{"name", name}});
      }
    }
    for (Json& parameter : robot["parameters"]) {
      add_missing(parameter, {{"body", first},
                              {"kind", "translation"},
                              {"cyclic", false},
                              {"lower", nullptr},
                              {"upper", nullptr},
                              {"step", 1},
                              {"speed", 1},
                              {"loaded_speed", 1},
                              {"start", 0},
                              {"prefer", 1},
                              {"rule", "0"}});
    }
  }
  return header;
}

}  // namespace rubicon::test
