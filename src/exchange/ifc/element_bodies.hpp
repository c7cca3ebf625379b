#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "src/exchange/ifc/ifc_model.hpp"
#include "src/exchange/ifc/solid.hpp"
#include "src/exchange/ifc/step_file.hpp"
#include "src/exchange/ifc/work_budget.hpp"

namespace rubicon::ifc {

/// The body of an element with its openings cut out.
struct ElementBody {
  Solid solid;  ///< metres, in the frame of the element
  /// Where it differs from the model: lower case, for people. It is larger there, never smaller.
  std::vector<std::string> notes;
};

/// Steps that the shapes of a file may take, and more for each of its records. Real models take 0.7
/// to 13 steps for each byte (2.2 million at most for 166 KB of stairs), so that one of 61 MB and
/// of the most laborious kind still has enough. Where it is not enough the file is refused.
inline constexpr std::uint64_t kShapeSteps = 1'000'000'000;
inline constexpr std::uint64_t kShapeStepsPerRecord = 2'000;

WorkBudget shape_budget(const StepFile& file);

/// By element of the model: its body; nothing where something of it cannot be read. Ends before the
/// last element when the budget is spent: the last one is then that which could not be paid for.
std::vector<std::optional<ElementBody>> element_bodies(const StepFile& file, const IfcModel& model,
                                                       WorkBudget& budget);

}  // namespace rubicon::ifc
