#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "src/results/film/column.hpp"

namespace rubicon::trace {
struct TraceHeader;
}

namespace rubicon::film {

struct SceneParameter {
  std::string name;  ///< as the records write it
  bool cyclic = false;
  double start = 0;  ///< m or degrees
};

struct SceneRobot {
  std::string name;
  std::vector<SceneParameter> parameters;
};

struct SceneMesh {
  Column vertices = Column(kMillionth, true);
  Column triangles = Column(1, true);
};

/// What a film needs of the header of a trace.
struct Scene {
  std::string plan;
  bool short_form = false;
  std::string json;  ///< the header as the head of a film has it
  std::vector<SceneRobot> robots;
  std::map<std::string, int, std::less<>> robot_numbers;
  std::map<std::string, int, std::less<>> component_numbers;
  std::vector<SceneMesh> meshes;
};

/// Of the header of a trace; `line` is its text. Throws std::invalid_argument, with a message for
/// the user, for what a film has no room for.
Scene read_scene(const trace::TraceHeader& header, std::string_view line);

/// JSON without white space; throws std::invalid_argument for what is no JSON.
std::string tidy_json(std::string_view text);

}  // namespace rubicon::film
