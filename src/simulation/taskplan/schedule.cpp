#include "src/simulation/taskplan/schedule.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace rubicon::taskplan {

const char* name_of(TaskResult result) {
  switch (result) {
    case TaskResult::done:
      return "done";
    case TaskResult::ended_short:
      return "short";
    case TaskResult::rejected:
      return "rejected";
    case TaskResult::not_reached:
      return "not reached";
  }
  return "";
}

const char* name_of(CostKind kind) {
  switch (kind) {
    case CostKind::use:
      return "use";
    case CostKind::overtime:
      return "overtime";
    case CostKind::rental:
      return "rental";
    case CostKind::mobilisation:
      return "mobilisation";
    case CostKind::fuel:
      return "fuel";
    case CostKind::material:
      return "material";
    case CostKind::overhead:
      return "overhead";
  }
  return "";
}

std::vector<CostKind> told_kinds(const Schedule& schedule) {
  std::vector<CostKind> kinds;
  for (std::size_t i = 0; i < kCostKinds; ++i) {
    const auto kind = static_cast<CostKind>(i);
    if (kind != CostKind::fuel || schedule.pays_fuel) kinds.push_back(kind);
  }
  return kinds;
}

std::optional<TruckWork> truck_work(const interpreter::PlanModel& plan, const TaskOutcome& task) {
  TruckWork work;
  if (task.motion_dig && task.motion_dig->truck_count > 0) {
    const MotionDigOutcome& dig = *task.motion_dig;
    work.trucks = dig.trucks;
    work.driving = dig.hauling.driving;
    for (std::size_t i = 0; i < dig.queues.size() && i < dig.hauling.serving.size(); ++i) {
      work.serving.emplace_back(dig.queues[i].by, dig.hauling.serving[i]);
    }
    return work;
  }
  if (!task.dig || task.dig->trucks < 0) return std::nullopt;
  work.trucks = plan.crews[static_cast<std::size_t>(task.dig->trucks)].name;
  work.driving = task.dig->result.driving;
  for (const hauling::Queue& queue : task.dig->result.queues) {
    work.serving.emplace_back(queue.by, static_cast<double>(queue.busy) / hauling::kPerSecond);
  }
  return work;
}

std::optional<Ticks> time_in_rounds(const interpreter::PlanModel& plan, const TaskOutcome& task,
                                    int resource) {
  const int crew = resource - static_cast<int>(plan.robots.size());
  const auto rounds = truck_work(plan, task);
  if (crew < 0 || !rounds) return std::nullopt;
  const auto in_ticks = [](double seconds) {
    return static_cast<Ticks>(std::max(std::round(seconds * hauling::kPerSecond), 0.0));
  };
  const std::string& name = plan.crews[static_cast<std::size_t>(crew)].name;
  if (name == rounds->trucks) return in_ticks(rounds->driving);
  std::optional<double> serving;
  for (const auto& [who, seconds] : rounds->serving) {
    if (who == name) serving = serving.value_or(0) + seconds;
  }
  if (!serving) return std::nullopt;
  return in_ticks(*serving);
}

std::vector<std::string> crew_names(const interpreter::PlanModel& plan,
                                    const interpreter::TaskSpec& task) {
  std::vector<std::string> names;
  const auto add = [&](int crew) {
    if (crew < 0) return;
    const std::string& name = plan.crews[static_cast<std::size_t>(crew)].name;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const int crew : task.crews) add(crew);
  for (const auto& work : {task.hook, task.adjust, task.release}) {
    if (work) add(work->crew);
  }
  for (const interpreter::WorkSpec& work : task.takes) add(work.crew);
  return names;
}

std::optional<Ticks> TaskOutcome::late() const {
  if (!due || result != TaskResult::done) return std::nullopt;
  return std::max<Ticks>(start + duration - *due, 0);
}

std::string client_name(const interpreter::Attributes& attributes) {
  const std::string* name = interpreter::find_attribute(attributes, "name");
  return name == nullptr ? std::string() : *name;
}

void add_attributes(const interpreter::PlanModel& plan, Schedule& schedule) {
  std::unordered_map<std::string, const interpreter::TaskSpec*> specs;
  for (const interpreter::TaskSpec& spec : plan.tasks) specs.emplace(spec.name, &spec);
  for (TaskOutcome& task : schedule.tasks) {
    const auto found = specs.find(task.task);
    if (task.parking || found == specs.end()) continue;
    const interpreter::TaskSpec& spec = *found->second;
    task.attributes = spec.attributes;
    task.due = spec.due;
    task.baseline = spec.baseline;
    const interpreter::TaskSpec& way = spec.choices.empty() ? spec : spec.choices.front();
    if (way.cover) {
      task.cover = way.cover;
      task.area = plan.areas[static_cast<std::size_t>(way.cover->area)].name;
    }
    if (spec.move) task.component = plan.components[static_cast<std::size_t>(*spec.move)].name;
  }
  for (const interpreter::ComponentSpec& component : plan.components) {
    if (component.attributes.empty()) continue;
    schedule.components.push_back({component.name, component.attributes});
  }
}

soil::CubicMillimetres MotionDigOutcome::dug() const {
  soil::CubicMillimetres sum = 0;
  for (const BucketOutcome& each : buckets) sum += each.volume;
  return sum;
}

soil::CubicMillimetres HaulOutcome::hauled() const {
  soil::CubicMillimetres sum = 0;
  for (const HauledLoad& each : loads) sum += each.volume;
  return sum;
}

namespace {

/// s, over the buckets of a dig.
template <typename Time>
double mean_seconds(const std::vector<BucketOutcome>& buckets, Time time) {
  if (buckets.empty()) return 0;
  Ticks sum = 0;
  for (const BucketOutcome& each : buckets) sum += time(each);
  return interpreter::seconds_from_ticks(sum) / static_cast<double>(buckets.size());
}

}  // namespace

double MotionDigOutcome::mean_cycle() const {
  return mean_seconds(buckets, [](const BucketOutcome& each) { return each.empty - each.begin; });
}

double MotionDigOutcome::mean_dig() const {
  return mean_seconds(buckets, [](const BucketOutcome& each) { return each.raised - each.at_cut; });
}

double MotionDigOutcome::mean_swing() const {
  return mean_seconds(buckets,
                      [](const BucketOutcome& each) { return each.at_truck - each.raised; });
}

double MotionDigOutcome::mean_dump() const {
  return mean_seconds(buckets,
                      [](const BucketOutcome& each) { return each.empty - each.at_truck; });
}

double MotionDigOutcome::mean_return() const {
  return mean_seconds(buckets, [](const BucketOutcome& each) { return each.at_cut - each.begin; });
}

double MotionDigOutcome::per_hour() const {
  if (time == 0) return 0;
  return static_cast<double>(dug()) * 1e-9 / (interpreter::seconds_from_ticks(time) / 3600);
}

}  // namespace rubicon::taskplan
