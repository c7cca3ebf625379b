#pragma once

#include <array>
#include <optional>
#include <vector>

#include "src/results/verify/schedule/accounts.hpp"
#include "src/results/verify/schedule/schedule_row.hpp"

namespace rubicon::verify {

/// In the order of schedule.json.
inline constexpr std::array<const char*, 7> kCostKinds = {
    "use", "overtime", "rental", "mobilisation", "fuel", "material", "overhead"};

/// What a plan costs, not rounded.
struct Costs {
  std::vector<long double> of_run;       ///< use, overtime, fuel, material
  std::vector<long double> of_resource;  ///< use, overtime, rental, mobilisation, fuel
  std::array<long double, 7> of_kind = {};
  std::vector<long double> litres_of_run, litres_of_resource;
  long double total() const;
};

/// `rows`: of the schedule, which tell how much of the waits of scripts was motion; check_split
/// looks at that.
Costs costs_of(const Trace& trace, const std::vector<TaskRun>& runs,
               const std::vector<TaskAccount>& accounts, const std::vector<ScheduleRow>& rows);

/// How long, in ticks, all of a crew that trucks or those who serve them are together worked in a
/// run; nothing of others.
std::optional<long double> round_work(const Trace& trace, const TaskRun& run, int crew);

/// Whether a rounded amount may stand for the exact one.
bool is_rounded(double found, long double exact);

/// Compares what robots, crews and each task burnt with the litres that these give.
void check_fuel(const Trace& trace, const std::vector<TaskRun>& runs, const Costs& costs,
                const ScheduleJson& schedule, Faults& faults);

/// Compares each amount of schedule.json with the costs; and rows, kinds and total with each other:
/// they add up to the cent.
void check_costs(const Trace& trace, const Costs& costs, const ScheduleJson& schedule,
                 Faults& faults);

}  // namespace rubicon::verify
