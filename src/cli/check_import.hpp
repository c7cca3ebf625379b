#pragma once

#include <string>

#include "src/exchange/building_io/building_plan.hpp"
#include "src/exchange/files/disk_io.hpp"

namespace rubicon::cli {

/// A plan before it is written: what `rubicon check` will read.
struct PlanToCheck {
  std::string path;                               ///< where the plan will be; never read
  const building_io::BuildingPlan* building;      ///< the plan, and the meshes that go beside it
  const building_io::MatchFile* match = nullptr;  ///< what it was made with; none: no match file
};

/// Whether `rubicon check` would refuse this plan; says on stderr why, at the places of the match
/// file among the sources that are at fault. An import writes no such plan, whatever the files it
/// was made of hold.
bool refused(const PlanToCheck& plan, interpreter::SourceMap& sources, files::DiskFiles& disk);
/// Without a match file.
bool refused(const PlanToCheck& plan, files::DiskFiles& disk);

}  // namespace rubicon::cli
