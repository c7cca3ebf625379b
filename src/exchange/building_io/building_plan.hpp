#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/syntax/diagnostic.hpp"
#include "src/exchange/building_io/match_file.hpp"
#include "src/exchange/building_io/read_elements.hpp"
#include "src/exchange/project_io/plan_crews.hpp"
#include "src/exchange/project_io/plan_text.hpp"
#include "src/exchange/project_io/project.hpp"

namespace rubicon::building_io {

/// What is written for a building.
struct BuildingPlan {
  std::string plan;      ///< text of the plan
  std::string elements;  ///< text of the table of all elements (CSV)
  struct MeshFile {
    std::string name;                                    ///< relative to the plan
    std::string text;                                    ///< OBJ, metres
    std::shared_ptr<const geometry::TriangleMesh> mesh;  ///< the same; shared as a shape wants it
  };
  std::vector<MeshFile> meshes;  ///< of elements that the plan cannot name in their model
  std::map<std::string, std::size_t> rules;  ///< by components that are moved: their rules
};

/// The tasks that put a building up.
struct BuildingTasks {
  const project_io::Project* project = nullptr;
  std::string schedule;  ///< name of its file
  const MatchFile* match = nullptr;
  project_io::Levelling levelling = project_io::Levelling::none;
  project_io::Baselines baselines = project_io::Baselines::left_out;
};

/// How the plan is called, and its files.
struct PlanNames {
  std::string plan;         ///< what the plan says its name is; made a valid one
  std::string mesh_folder;  ///< for meshes of its own, relative to the plan
};

/// The building as it stands: every element a component at the place the model gives it.
BuildingPlan standing_building(const Elements& elements, const PlanNames& names);

/// The building as it is put up: elements wait in the stock, and the tasks of the schedule put them
/// where the model has them. Elements and tasks without partner are listed, in the plan as remarks
/// and as warnings (I15, I16); elements without room in the stock are an error (I17), those whose
/// mass is not known a warning (I18).
BuildingPlan building_under_work(const Elements& elements, const BuildingTasks& tasks,
                                 const PlanNames& names, interpreter::Diagnostics& diagnostics);

}  // namespace rubicon::building_io
