#include "src/simulation/taskplan/plan_cost.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "src/motion/math/index.hpp"
#include "src/simulation/taskplan/plan_calendars.hpp"

namespace rubicon::taskplan {

namespace {

/// Money and times of all a plan may have, multiplied: 64 bits are too few.
__extension__ typedef __int128 Wide;

/// Money is counted in millionths, and shown in hundredths.
constexpr std::int64_t kMillionth = 1'000'000;
constexpr Wide kCent = kMillionth / 100;

Wide millionths(double amount) {
  return static_cast<Wide>(std::llround(amount * static_cast<double>(kMillionth)));
}

/// a / b, half of one up; for a >= 0.
Wide rounded_quotient(Wide a, Wide b) { return (2 * a + b) / (2 * b); }

using math::at;

/// What is spent on something.
struct Item {
  CostKind kind = CostKind::use;
  int task = -1;      ///< row of the schedule, -1: of none
  int resource = -1;  ///< -1: of none
  Wide amount = 0;    ///< millionths
};

/// What a robot or a crew burnt in a task.
struct Burnt {
  int task = -1;
  int resource = -1;
  Wide litres = 0;  ///< millionths
};

class CostCounter {
 public:
  CostCounter(const interpreter::PlanModel& plan, const Schedule& schedule)
      : plan_(plan), schedule_(schedule) {
    for (const interpreter::RobotSpec& robot : plan.robots) {
      add_payer(robot.cost_per_hour, robot.charges, 1);
    }
    for (const interpreter::CrewSpec& crew : plan.crews) {
      add_payer(crew.cost_per_hour, crew.charges, static_cast<int>(crew.size));
    }
  }

  std::vector<Item> items() {
    for (std::size_t row = 0; row < schedule_.tasks.size(); ++row) {
      for (const ResourceHold& hold : schedule_.tasks[row].holds) {
        add_hold(static_cast<int>(row), hold);
      }
    }
    add_materials();
    for (std::size_t i = 0; i < payers_.size(); ++i) add_charges(static_cast<int>(i));
    if (plan_.overhead_per_day && schedule_.process_time > 0) {
      items_.push_back({CostKind::overhead, -1, -1,
                        millionths(*plan_.overhead_per_day) * days(0, schedule_.process_time)});
    }
    return std::move(items_);
  }

  /// After `items`.
  const std::vector<Burnt>& burnt() const { return burnt_; }

 private:
  /// A robot or crew as it is paid.
  struct Payer {
    Wide rate = 0;   ///< millionths an hour
    Wide extra = 0;  ///< the same, for an hour of overtime besides
    int size = 1;
    const interpreter::Charges* charges = nullptr;
    bool used = false;
    Ticks first = 0, last = 0;
  };

  void add_payer(const std::optional<double>& rate, const interpreter::Charges& charges, int size) {
    Payer& payer = payers_.emplace_back();
    payer.rate = millionths(rate.value_or(0));
    payer.extra = rounded_quotient(payer.rate * millionths(charges.overtime - 1), kMillionth);
    payer.size = size;
    payer.charges = &charges;
  }

  /// A rate for the whole of it, a part of its people and a time.
  static Wide amount(Wide rate, Ticks time, int people, int size) {
    return amount(rate, static_cast<Wide>(time) * people, size);
  }
  static Wide amount(Wide rate, Wide part, int size) {
    const Wide hour = static_cast<Wide>(schedule::kHour) * size;
    return rate * (part / hour) + rounded_quotient(rate * (part % hour), hour);
  }

  void add_hold(int row, const ResourceHold& hold) {
    Payer& payer = payers_[at(hold.resource)];
    payer.first = payer.used ? std::min(payer.first, hold.from) : hold.from;
    payer.last = std::max(payer.last, hold.to);
    payer.used = true;
    items_.push_back({CostKind::use, row, hold.resource,
                      amount(payer.rate, hold.held, hold.people, payer.size)});
    if (hold.overtime > 0 && payer.extra > 0) {
      items_.push_back({CostKind::overtime, row, hold.resource,
                        amount(payer.extra, hold.overtime, hold.people, payer.size)});
    }
    if (payer.charges->fuel) add_fuel(row, hold, payer);
  }

  /// At work, and in the rest of the time in which the task has it idling, unless it is off.
  void add_fuel(int row, const ResourceHold& hold, const Payer& payer) {
    const interpreter::FuelUse& fuel = *payer.charges->fuel;
    const Wide all = static_cast<Wide>(hold.held - hold.off) * hold.people;
    const Wide working = std::min(time_at_work(schedule_.tasks[at(row)], hold), all);
    const Wide litres = amount(millionths(fuel.working), working, payer.size) +
                        amount(millionths(fuel.idling), all - working, payer.size);
    burnt_.push_back({row, hold.resource, litres});
    if (!fuel.price) return;
    items_.push_back({CostKind::fuel, row, hold.resource,
                      rounded_quotient(litres * millionths(*fuel.price), kMillionth)});
  }

  /// Of all machines or people of a hold together: as long as it moves or works. Of digs, trucks
  /// are at work while they are neither loaded nor in a queue, and diggers and those who serve a
  /// stage while they have a truck.
  Wide time_at_work(const TaskOutcome& task, const ResourceHold& hold) const {
    if (const auto rounds = time_in_rounds(plan_, task, hold.resource)) return *rounds;
    return static_cast<Wide>(hold.busy) * hold.people;
  }

  /// Of each component once: with the first task that moved it.
  void add_materials() {
    std::map<std::string, int> moved;
    for (const interpreter::TaskSpec& task : plan_.tasks) {
      if (task.move) moved.emplace(task.name, *task.move);
    }
    std::set<int> paid;
    for (std::size_t row = 0; row < schedule_.tasks.size(); ++row) {
      const TaskOutcome& task = schedule_.tasks[row];
      const auto component = moved.find(task.task);
      if (task.result != TaskResult::done || component == moved.end()) continue;
      const auto& cost = plan_.components[at(component->second)].cost;
      if (!cost || !paid.insert(component->second).second) continue;
      items_.push_back({CostKind::material, static_cast<int>(row), -1, millionths(*cost)});
    }
  }

  void add_charges(int resource) {
    const Payer& payer = payers_[at(resource)];
    const interpreter::Charges& charges = *payer.charges;
    if (charges.rental_per_day && (payer.used || charges.rental_days)) {
      const std::int64_t count = charges.rental_days
                                     ? schedule::days_from_date(charges.rental_days->second) -
                                           schedule::days_from_date(charges.rental_days->first) + 1
                                     : days(payer.first, payer.last);
      items_.push_back(
          {CostKind::rental, -1, resource, millionths(*charges.rental_per_day) * count});
    }
    if (charges.mobilisation && payer.used) {
      items_.push_back({CostKind::mobilisation, -1, resource, millionths(*charges.mobilisation)});
    }
  }

  /// The days of the calendar that a time touches.
  std::int64_t days(Ticks from, Ticks to) const {
    const auto day = [&](Ticks time) {
      const Ticks minute = start_of(plan_).minute_of_day * schedule::kMinute;
      return schedule::floor_division(minute + time, schedule::kDay);
    };
    return day(std::max(from, to - 1)) - day(from) + 1;
  }

  const interpreter::PlanModel& plan_;
  const Schedule& schedule_;
  std::vector<Payer> payers_;
  std::vector<Item> items_;
  std::vector<Burnt> burnt_;
};

/// Whole cents for amounts so that they add up to `total`: each is rounded down, and what is left
/// goes to the largest remainders, of equals to the first.
std::vector<Wide> cents_of(const std::vector<Wide>& amounts, Wide total) {
  std::vector<Wide> cents;
  for (const Wide amount : amounts) cents.push_back(amount / kCent);
  std::vector<std::size_t> order(amounts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return amounts[a] % kCent > amounts[b] % kCent;
  });
  Wide left = total - std::accumulate(cents.begin(), cents.end(), Wide{0});
  for (std::size_t i = 0; left > 0 && !order.empty(); i = (i + 1) % order.size(), --left) {
    ++cents[order[i]];
  }
  return cents;
}

double money(Wide cents) { return static_cast<double>(cents) / 100; }

bool says_more(const interpreter::Charges& charges) {
  return charges.rental_per_day || charges.mobilisation || charges.overtime != 1 ||
         (charges.fuel && charges.fuel->price);
}

template <typename Holds>
bool any_charges(const interpreter::PlanModel& plan, const Holds& holds) {
  const auto of_each = [&](const auto& each) -> bool { return bool(holds(each.charges)); };
  return std::any_of(plan.robots.begin(), plan.robots.end(), of_each) ||
         std::any_of(plan.crews.begin(), plan.crews.end(), of_each);
}

}  // namespace

bool burns_fuel(const interpreter::PlanModel& plan) {
  return any_charges(plan, [](const auto& charges) { return charges.fuel.has_value(); });
}

namespace {

/// Litres, to the ml.
double litres_of(Wide millionths_of_litre) {
  return static_cast<double>(rounded_quotient(millionths_of_litre, 1000)) / 1000;
}

void add_litres(const interpreter::PlanModel& plan, const std::vector<Burnt>& burnt,
                Schedule& schedule) {
  std::vector<Wide> tasks(schedule.tasks.size()), resources(schedule.resources.size());
  Wide total = 0;
  for (const Burnt& each : burnt) {
    total += each.litres;
    tasks[at(each.task)] += each.litres;
    resources[at(each.resource)] += each.litres;
  }
  schedule.fuel = litres_of(total);
  for (std::size_t i = 0; i < tasks.size(); ++i) schedule.tasks[i].fuel = litres_of(tasks[i]);
  for (std::size_t i = 0; i < resources.size(); ++i) {
    const auto& charges = i < plan.robots.size() ? plan.robots[i].charges
                                                 : plan.crews[i - plan.robots.size()].charges;
    if (charges.fuel) schedule.resources[i].fuel = litres_of(resources[i]);
  }
}

/// Whether the plan says more than rates for use.
bool has_cost_kinds(const interpreter::PlanModel& plan) {
  return plan.overhead_per_day || any_charges(plan, says_more) ||
         std::any_of(plan.components.begin(), plan.components.end(),
                     [](const interpreter::ComponentSpec& component) { return component.cost; });
}

}  // namespace

bool is_costed(const interpreter::PlanModel& plan) {
  const auto has_rate = [](const auto& each) { return each.cost_per_hour.has_value(); };
  return has_cost_kinds(plan) || std::any_of(plan.robots.begin(), plan.robots.end(), has_rate) ||
         std::any_of(plan.crews.begin(), plan.crews.end(), has_rate);
}

void add_costs(const interpreter::PlanModel& plan, Schedule& schedule) {
  schedule.has_kinds = has_cost_kinds(plan);
  schedule.costed = is_costed(plan);
  schedule.burns_fuel = burns_fuel(plan);
  schedule.pays_fuel =
      any_charges(plan, [](const auto& charges) { return charges.fuel && charges.fuel->price; });
  if (!schedule.costed && !schedule.burns_fuel) return;

  std::vector<Wide> kinds(kCostKinds), tasks(schedule.tasks.size()),
      resources(schedule.resources.size());
  Wide total = 0;
  CostCounter counter(plan, schedule);
  const std::vector<Item> items = counter.items();
  if (schedule.burns_fuel) add_litres(plan, counter.burnt(), schedule);
  if (!schedule.costed) return;
  for (const Item& item : items) {
    total += item.amount;
    kinds[static_cast<std::size_t>(item.kind)] += item.amount;
    if (item.task >= 0) tasks[at(item.task)] += item.amount;
    if (item.resource >= 0) resources[at(item.resource)] += item.amount;
  }
  const Wide whole = rounded_quotient(total, kCent);
  const std::vector<Wide> by_kind = cents_of(kinds, whole);
  const auto sum_of = [&](std::initializer_list<CostKind> some) {
    return std::accumulate(some.begin(), some.end(), Wide{0}, [&](Wide sum, CostKind kind) {
      return sum + by_kind[static_cast<std::size_t>(kind)];
    });
  };
  schedule.cost = money(whole);
  for (std::size_t i = 0; i < kCostKinds; ++i) schedule.cost_by_kind[i] = money(by_kind[i]);
  const std::vector<Wide> by_task = cents_of(
      tasks, sum_of({CostKind::use, CostKind::overtime, CostKind::fuel, CostKind::material}));
  for (std::size_t i = 0; i < by_task.size(); ++i) schedule.tasks[i].cost = money(by_task[i]);
  const std::vector<Wide> by_resource =
      cents_of(resources, sum_of({CostKind::use, CostKind::overtime, CostKind::rental,
                                  CostKind::mobilisation, CostKind::fuel}));
  for (std::size_t i = 0; i < by_resource.size(); ++i) {
    schedule.resources[i].cost = money(by_resource[i]);
  }
}

}  // namespace rubicon::taskplan
