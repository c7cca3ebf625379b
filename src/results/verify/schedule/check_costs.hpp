#pragma once

#include <array>
#include <vector>

#include "src/results/verify/schedule/accounts.hpp"
#include "src/results/verify/schedule/schedule_row.hpp"

namespace rubicon::verify {

/// In the order of schedule.json.
inline constexpr std::array<const char*, 6> kCostKinds = {"use",          "overtime", "rental",
                                                          "mobilisation", "material", "overhead"};

/// What a plan costs, not rounded.
struct Costs {
  std::vector<long double> of_run;       ///< use, overtime, material
  std::vector<long double> of_resource;  ///< use, overtime, rental, mobilisation
  std::array<long double, 6> of_kind = {};
  long double total() const;
};

Costs costs_of(const Trace& trace, const std::vector<TaskRun>& runs,
               const std::vector<TaskAccount>& accounts);

/// Whether a rounded amount may stand for the exact one.
bool is_rounded(double found, long double exact);

/// Compares each amount of schedule.json with the costs; and rows, kinds and total with each other:
/// they add up to the cent.
void check_costs(const Trace& trace, const Costs& costs, const ScheduleJson& schedule,
                 Faults& faults);

}  // namespace rubicon::verify
