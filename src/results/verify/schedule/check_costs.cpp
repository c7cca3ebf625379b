#include "src/results/verify/schedule/check_costs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "src/motion/math/index.hpp"
#include "src/results/verify/schedule/civil_date.hpp"

namespace rubicon::verify {

namespace {

/// A row is rounded up or down to a cent so that a list adds up, and the list itself may be a cent
/// off. Consequence: what is off by less is not seen in one row, but in the sum.
constexpr long double kRowSlack = 0.0201L;
/// Litres are rounded to the ml.
constexpr long double kLitreSlack = 0.00051L;
/// The total is rounded to the nearest cent, of items that are rounded to a millionth each.
constexpr long double kTotalSlack = 0.0052L;
/// Of large amounts doubles have no cents.
constexpr long double kRelativeSlack = 1e-12L;

enum Kind : std::size_t { kUse, kOvertime, kRental, kMobilisation, kFuel, kMaterial, kOverhead };

using math::at;

/// A double holds an amount to so much of it, so that sums of very large ones are off by as much.
constexpr long double kDoubleSlack = 0x1p-51L;

/// Whole; more than 64 bits hold where a currency has many zeros.
long double cents(double amount) { return std::round(static_cast<long double>(amount) * 100); }

/// The days that a time touches, by the calendar.
std::int64_t days_between(const Scene& scene, Ticks from, Ticks to) {
  const std::int64_t minute =
      scene.start_at.empty() ? 0 : minute_number(scene.start_at) % kMinutesOfDay;
  const Ticks offset = minute * 60 * kSecond;
  const Ticks last = std::max(from, to - 1);
  return (offset + last) / kDay - (offset + from) / kDay + 1;
}

void add_uses(const Trace& trace, const std::vector<TaskAccount>& accounts, Costs& costs) {
  for (std::size_t run = 0; run < accounts.size(); ++run) {
    for (const HeldTime& held : accounts[run].holds) {
      const long double rate = static_cast<long double>(rate_of(trace.scene, held.resource)) *
                               share_of(trace.scene, held);
      const long double hour = 3600.0L * static_cast<long double>(kSecond);
      const long double use = rate * static_cast<long double>(held.held) / hour;
      const long double factor = charges_of(trace.scene, held.resource).overtime - 1;
      const long double overtime = factor * rate * static_cast<long double>(held.overtime) / hour;
      costs.of_kind[kUse] += use;
      costs.of_kind[kOvertime] += overtime;
      costs.of_run[run] += use + overtime;
      costs.of_resource[at(held.resource)] += use + overtime;
    }
  }
}

/// At work: a crew as long as it works, a machine as long as it moves, or works of its task go on
/// that no crew does; trucks while they drive, and who serves them while they have one. All else of
/// the time in which it is held, and not under repair: idling.
void add_fuel(const Trace& trace, const std::vector<TaskRun>& runs,
              const std::vector<TaskAccount>& accounts, const std::vector<ScheduleRow>& rows,
              Costs& costs) {
  std::map<std::pair<std::string, Ticks>, Ticks> motions;  // by task and start
  for (const ScheduleRow& row : rows) motions[{row.task, row.start}] = row.split.motion;
  const auto robots = static_cast<int>(trace.scene.robots.size());
  const long double hour = 3600.0L * static_cast<long double>(kSecond);
  costs.litres_of_run.resize(runs.size());
  costs.litres_of_resource.resize(costs.of_resource.size());
  for (std::size_t run = 0; run < accounts.size(); ++run) {
    const TaskAccount& account = accounts[run];
    Ticks motion = account.steps;
    if (account.script_wait_count > 0) {
      const auto told = motions.find({trace.runs[at(runs[run].run)], runs[run].start});
      if (told != motions.end()) motion = told->second;
    }
    for (const HeldTime& held : account.holds) {
      const std::optional<SceneFuel>& fuel = charges_of(trace.scene, held.resource).fuel;
      if (!fuel) continue;
      const bool is_robot = held.resource < robots;
      const long double all = static_cast<long double>(held.held - held.off) * held.people;
      long double working =
          static_cast<long double>(held.work + (is_robot ? motion : 0)) * held.people;
      if (!is_robot) {
        working = round_work(trace, runs[run], held.resource - robots).value_or(working);
      }
      working = std::min(working, all);
      const long double litres = (fuel->working * working + fuel->idling * (all - working)) /
                                 size_of_resource(trace.scene, held.resource) / hour;
      costs.litres_of_run[run] += litres;
      costs.litres_of_resource[at(held.resource)] += litres;
      const long double cost = litres * fuel->price.value_or(0);
      costs.of_kind[kFuel] += cost;
      costs.of_run[run] += cost;
      costs.of_resource[at(held.resource)] += cost;
    }
  }
}

/// Of each component once, with the task that moved it first.
void add_materials(const Trace& trace, const std::vector<TaskRun>& runs, Costs& costs) {
  std::map<int, std::pair<std::pair<Ticks, int>, std::size_t>> first;  // by component
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const TaskRun& run = runs[i];
    if (!run.happened || run.task < 0 || run.result != TaskResult::done) continue;
    const int component = trace.scene.tasks[at(run.task)].move;
    if (component < 0) continue;
    const auto [known, is_new] = first.try_emplace(component, std::pair(run.start, run.task), i);
    if (!is_new && std::pair(run.start, run.task) < known->second.first) {
      known->second = {std::pair(run.start, run.task), i};
    }
  }
  for (const auto& [component, place] : first) {
    const double cost = trace.scene.components[at(component)].cost;
    costs.of_run[place.second] += cost;
    costs.of_kind[kMaterial] += cost;
  }
}

void add_charges(const Trace& trace, const std::vector<TaskAccount>& accounts, Costs& costs) {
  for (std::size_t resource = 0; resource < costs.of_resource.size(); ++resource) {
    bool used = false;
    Ticks first = 0;
    Ticks last = 0;
    for (const TaskAccount& account : accounts) {
      for (const HeldTime& held : account.holds) {
        if (held.resource != static_cast<int>(resource)) continue;
        first = used ? std::min(first, held.from) : held.from;
        last = used ? std::max(last, held.to) : held.to;
        used = true;
      }
    }
    const SceneCharges& charges = charges_of(trace.scene, static_cast<int>(resource));
    long double rental = 0;
    if (charges.rental_per_day && charges.rental_days) {
      const auto count =
          day_number(charges.rental_days->second) - day_number(charges.rental_days->first) + 1;
      rental = static_cast<long double>(*charges.rental_per_day) * static_cast<long double>(count);
    } else if (charges.rental_per_day && used) {
      rental = static_cast<long double>(*charges.rental_per_day) *
               static_cast<long double>(days_between(trace.scene, first, last));
    }
    const long double mobilisation = used ? charges.mobilisation : 0;
    costs.of_kind[kRental] += rental;
    costs.of_kind[kMobilisation] += mobilisation;
    costs.of_resource[resource] += rental + mobilisation;
  }
}

class CostCheck {
 public:
  CostCheck(const Costs& costs, const ScheduleJson& schedule, Faults& faults)
      : costs_(costs), schedule_(schedule), faults_(faults) {}

  void check() {
    const double total = schedule_.cost.value_or(0);
    const long double exact = costs_.total();
    if (std::fabs(total - exact) > kTotalSlack + kRelativeSlack * std::fabs(exact)) {
      fault(0, fmt::format("the whole costs {}, by the trace {:.4f}", total,
                           static_cast<double>(exact)));
    }
    for (std::size_t i = 0; i < schedule_.uses.size() && i < costs_.of_resource.size(); ++i) {
      const UseRow& row = schedule_.uses[i];
      const double cost = row.cost.value_or(0);
      if (is_rounded(cost, costs_.of_resource[i])) continue;
      fault(row.line, fmt::format("{}: the cost is {}, by the trace {:.4f}", row.name, cost,
                                  static_cast<double>(costs_.of_resource[i])));
    }
    check_kinds();
    check_sums(total);
  }

 private:
  void fault(int line, std::string text) {
    faults_.push_back(
        {FaultKind::schedule, ResultFile::schedule_json, line, "", -1, std::move(text)});
  }

  double kind(std::size_t index) const {
    const auto found = schedule_.cost_by_kind.find(kCostKinds[index]);
    return found == schedule_.cost_by_kind.end() ? 0 : found->second;
  }

  void check_kinds() {
    if (schedule_.cost_by_kind.empty()) {
      for (std::size_t i = kOvertime; i < kCostKinds.size(); ++i) {
        if (costs_.of_kind[i] <= kTotalSlack) continue;
        fault(0, fmt::format("the cost by kind is missing, and {} costs {:.4f}", kCostKinds[i],
                             static_cast<double>(costs_.of_kind[i])));
      }
      return;
    }
    for (std::size_t i = 0; i < kCostKinds.size(); ++i) {
      if (is_rounded(kind(i), costs_.of_kind[i])) continue;
      fault(0, fmt::format("{} costs {}, by the trace {:.4f}", kCostKinds[i], kind(i),
                           static_cast<double>(costs_.of_kind[i])));
    }
  }

  void check_sum(const char* what, long double found, long double expected) {
    if (std::fabs(found - expected) < 0.5L + kDoubleSlack * std::fabs(expected)) return;
    fault(0, fmt::format("the costs of {} add up to {:.2f}, expected {:.2f}", what,
                         static_cast<double>(found) / 100, static_cast<double>(expected) / 100));
  }

  void check_sums(double total) {
    long double tasks = 0;
    for (const ScheduleRow& row : schedule_.rows) tasks += cents(row.cost.value_or(0));
    long double resources = 0;
    for (const UseRow& row : schedule_.uses) resources += cents(row.cost.value_or(0));
    if (schedule_.cost_by_kind.empty()) {
      check_sum("all tasks", tasks, cents(total));
      check_sum("all robots and crews", resources, cents(total));
      return;
    }
    long double kinds = 0;
    for (std::size_t i = 0; i < kCostKinds.size(); ++i) kinds += cents(kind(i));
    const long double use = cents(kind(kUse)) + cents(kind(kOvertime)) + cents(kind(kFuel));
    check_sum("all kinds", kinds, cents(total));
    check_sum("all tasks", tasks, use + cents(kind(kMaterial)));
    check_sum("all robots and crews", resources,
              use + cents(kind(kRental)) + cents(kind(kMobilisation)));
  }

  const Costs& costs_;
  const ScheduleJson& schedule_;
  Faults& faults_;
};

}  // namespace

long double Costs::total() const { return std::accumulate(of_kind.begin(), of_kind.end(), 0.0L); }

bool is_rounded(double found, long double exact) {
  return std::fabs(found - exact) <= kRowSlack + kRelativeSlack * std::fabs(exact);
}

std::optional<long double> round_work(const Trace& trace, const TaskRun& run, int crew) {
  if (run.task < 0 || run.records.empty() || crew < 0) return std::nullopt;
  const SceneTask& task = trace.scene.tasks[at(run.task)];
  const auto* end = std::get_if<TaskEnd>(&trace.records[at(run.records.back())].what);
  if (end == nullptr || !end->driving) return std::nullopt;
  int hauled_by = -1;
  std::vector<int> servers;
  const auto add_stages = [&](const auto& dig) {
    hauled_by = dig.hauled_by;
    for (const SceneStage& stage : dig.stages) {
      if (stage.servers > 0) servers.push_back(stage.crew);
    }
  };
  if (task.dig) {
    servers = task.dig->digger_crews;
    add_stages(*task.dig);
  } else if (task.motion_dig && task.motion_dig->trucks > 0) {
    add_stages(*task.motion_dig);
  }
  const long double second = static_cast<long double>(kSecond);
  if (crew == hauled_by) return *end->driving * second;
  if (std::find(servers.begin(), servers.end(), crew) == servers.end()) return std::nullopt;
  long double sum = 0;
  for (std::size_t i = 0; i < servers.size() && i < end->serving.size(); ++i) {
    if (servers[i] == crew) sum += end->serving[i] * second;
  }
  return sum;
}

Costs costs_of(const Trace& trace, const std::vector<TaskRun>& runs,
               const std::vector<TaskAccount>& accounts, const std::vector<ScheduleRow>& rows) {
  Costs costs;
  costs.of_run.resize(runs.size());
  costs.of_resource.resize(trace.scene.robots.size() + trace.scene.crews.size());
  add_uses(trace, accounts, costs);
  add_fuel(trace, runs, accounts, rows, costs);
  add_materials(trace, runs, costs);
  add_charges(trace, accounts, costs);
  Ticks end = 0;
  for (const TaskRun& run : runs) {
    if (run.happened && run.task >= 0) end = std::max(end, run.end);
  }
  if (end > 0) {
    costs.of_kind[kOverhead] = static_cast<long double>(trace.scene.overhead_per_day) *
                               static_cast<long double>(days_between(trace.scene, 0, end));
  }
  return costs;
}

void check_fuel(const Trace& trace, const std::vector<TaskRun>& runs, const Costs& costs,
                const ScheduleJson& schedule, Faults& faults) {
  if (trace.scene.short_form) return;
  const auto compare = [&](int line, const std::string& who, const std::optional<double>& found,
                           bool burns, long double exact) {
    if (!burns && !found) return;
    if (found && burns && std::fabs(*found - exact) <= kLitreSlack + 1e-9L * exact) return;
    faults.push_back({FaultKind::schedule, ResultFile::schedule_json, line, "", -1,
                      found ? fmt::format("{} burnt {} l, by the trace {:.4f}", who, *found,
                                          static_cast<double>(exact))
                            : fmt::format("what {} burnt is missing, by the trace {:.4f} l", who,
                                          static_cast<double>(exact))});
  };
  bool any = false;
  for (std::size_t i = 0; i < costs.litres_of_resource.size(); ++i) {
    const bool burns = charges_of(trace.scene, static_cast<int>(i)).fuel.has_value();
    any = any || burns;
    if (i >= schedule.uses.size()) continue;
    const UseRow& row = schedule.uses[i];
    compare(row.line, row.name, row.fuel, burns, costs.litres_of_resource[i]);
  }
  std::map<std::pair<std::string, Ticks>, long double> burnt;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    if (runs[run].happened) {
      burnt[{trace.runs[at(runs[run].run)], runs[run].start}] = costs.litres_of_run[run];
    }
  }
  for (const ScheduleRow& row : schedule.rows) {
    const auto found = burnt.find({row.task, row.start});
    compare(row.line, row.task, row.fuel, any, found == burnt.end() ? 0 : found->second);
  }
  compare(0, "the whole", schedule.fuel, any,
          std::accumulate(costs.litres_of_resource.begin(), costs.litres_of_resource.end(), 0.0L));
}

void check_costs(const Trace& trace, const Costs& costs, const ScheduleJson& schedule,
                 Faults& faults) {
  if (trace.scene.short_form) return;
  CostCheck(costs, schedule, faults).check();
}

}  // namespace rubicon::verify
