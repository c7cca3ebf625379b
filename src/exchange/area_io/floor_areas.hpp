#pragma once

#include <string>
#include <vector>

#include "src/motion/coverage/floor.hpp"
#include "src/motion/coverage/standing.hpp"

namespace rubicon::area_io {

using coverage::Place;
using coverage::Region;
using coverage::Ring;

/// A floor as the plan will have it.
struct ImportedArea {
  double height = 0;  ///< m
  coverage::FloorDescription floor;
  double slab = 0;  ///< m2; outline less shafts
};

/// How the text of the plan is to be.
struct AreaTerms {
  std::string name;                ///< of the plan and, with numbers behind it, of its areas
  std::vector<std::string> notes;  ///< remarks at its head
};

/// A plan of areas, as `rubicon fmt` writes it.
std::string area_text(const std::vector<ImportedArea>& areas, const AreaTerms& terms);

}  // namespace rubicon::area_io
