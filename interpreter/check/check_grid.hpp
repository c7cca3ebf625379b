#pragma once

#include <optional>
#include <string>

#include "interpreter/syntax/diagnostic.hpp"
#include "interpreter/syntax/file_provider.hpp"
#include "interpreter/syntax/grid.hpp"
#include "src/fleets/grid/job_traffic.hpp"
#include "src/fleets/grid/solve_grid.hpp"

namespace rubicon::interpreter {

/// A checked network of cells: who goes where, and how much work may be spent on it.
struct GridSpec {
  std::string name;
  std::string map;       ///< the files, as the plan names them
  std::string scenario;  ///< empty: all agents stand in the plan
  grid::GridProblem problem;
  grid::GridQuery query;
  std::vector<grid::GridJob> jobs;  ///< empty: each agent goes to its goal, and that is all
  grid::JobQuery job_query;
  double tick = 1;  ///< seconds; of one cell to the next
};

/// Checks what a plan says of a network of cells, and reads its map and its scenario; nothing after
/// reporting P57, F01, P02, P09.
std::optional<GridSpec> check_grid(const syntax::GridItem& item, const std::string& plan_path,
                                   SourceMap& sources, FileProvider& files,
                                   Diagnostics& diagnostics);

/// The network of cells of a plan; nothing if it has none. Mistakes go to `diagnostics`, those of
/// the rest of the plan do not.
std::optional<GridSpec> load_grid(const std::string& path, SourceMap& sources, FileProvider& files,
                                  Diagnostics& diagnostics);

}  // namespace rubicon::interpreter
