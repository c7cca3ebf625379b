#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"

namespace rubicon::test {

/// A plan of this repository that was run, and the lines of its trace.
struct FilmRun {
  std::unique_ptr<interpreter::PlanModel> plan;
  interpreter::SourceMap sources;
  std::vector<std::string> lines;
  std::vector<nlohmann::json> records;  ///< but for the header
};

FilmRun run_for_film(const std::string& path);

/// The film of a run as a .glb.
std::string film_of(const FilmRun& run, double speed_up);

}  // namespace rubicon::test
