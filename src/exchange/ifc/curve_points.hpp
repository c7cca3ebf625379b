#pragma once

#include <cstdint>
#include <optional>

#include "src/exchange/ifc/ifc_curve.hpp"
#include "src/exchange/ifc/step_file.hpp"
#include "src/exchange/ifc/work_budget.hpp"

namespace rubicon::ifc {

/// What shapes of a file are read with.
struct ShapeTerms {
  const StepFile& file;
  double metres_per_unit = 1;
  double radians_per_unit = 1;
  WorkBudget& budget;
};

/// The points of a bounded curve in the units of the file, ends included: lines and polylines,
/// circles and ellipses and what is trimmed from them (as chords), and curves composed of such. A
/// whole circle ends where it begins. Nothing for other curves, and for such as end nowhere.
std::optional<PointLine> curve_points(const ShapeTerms& terms, std::uint64_t id);

/// Curves composed of composed curves: real files have one level.
inline constexpr int kDeepestCurve = 8;

}  // namespace rubicon::ifc
