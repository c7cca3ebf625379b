#include "src/studies/study/run_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>
#include <unordered_map>

#include "src/simulation/schedule/ticks.hpp"
#include "src/simulation/taskplan/plan_cost.hpp"
#include "src/studies/statistics/mean.hpp"
#include "src/studies/statistics/quantile.hpp"

namespace rubicon::study {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kNotThere = std::numeric_limits<double>::quiet_NaN();

double waited(const taskplan::Schedule& schedule, const std::string& cause) {
  taskplan::Ticks sum = 0;
  for (const taskplan::TaskOutcome& task : schedule.tasks) {
    const taskplan::WaitTimes& waits = task.waits;
    if (cause.empty()) sum += waits.machine + waits.resource + waits.shift + waits.repair;
    if (cause == "machine") sum += waits.machine;
    if (cause == "resource") sum += waits.resource;
    if (cause == "shift") sum += waits.shift;
    if (cause == "repair") sum += waits.repair;
    if (cause == "predecessor") sum += waits.predecessor;
  }
  return schedule::seconds_from_ticks(sum);
}

double value_of(const Question& question, const taskplan::Schedule& schedule) {
  const auto of_task = [&](const auto& use) {
    for (const taskplan::TaskOutcome& task : schedule.tasks) {
      if (task.task == question.of && !task.parking) return schedule::seconds_from_ticks(use(task));
    }
    return kNotThere;
  };
  const auto of_dig = [&](const auto& use) {
    for (const taskplan::TaskOutcome& task : schedule.tasks) {
      if (task.task != question.of) continue;
      if (task.dig && task.dig->result.tipped > 0) {
        return use(task, task.dig->result.per_hour(), task.dig->result.tipped);
      }
      if (task.motion_dig && task.motion_dig->dug() > 0) {
        return use(task, task.motion_dig->per_hour(), task.motion_dig->dug());
      }
    }
    return kNotThere;
  };
  switch (question.asked) {
    case Asked::makespan:
    case Asked::finish:
      return schedule::seconds_from_ticks(schedule.process_time);
    case Asked::cost:
      return schedule.cost;
    case Asked::fuel:
      return schedule.burns_fuel ? schedule.fuel : kNotThere;
    case Asked::rejected:
      return 0;
    case Asked::utilisation:
      for (const taskplan::ResourceUse& each : schedule.resources) {
        if (each.name == question.of) return each.utilisation();
      }
      return kNotThere;
    case Asked::waiting:
      return waited(schedule, question.of);
    case Asked::task_start:
      return of_task([](const taskplan::TaskOutcome& task) { return task.start; });
    case Asked::task_finish:
      return of_task([](const taskplan::TaskOutcome& task) { return task.start + task.duration; });
    case Asked::production:
      return of_dig([](const taskplan::TaskOutcome&, double per_hour, hauling::CubicMillimetres) {
        return per_hour;
      });
    case Asked::unit_cost:
      return of_dig(
          [](const taskplan::TaskOutcome& task, double, hauling::CubicMillimetres volume) {
            return task.cost / (static_cast<double>(volume) / hauling::kPerCubicMetre);
          });
    case Asked::task_duration:
      break;
  }
  return of_task([](const taskplan::TaskOutcome& task) { return task.duration; });
}

std::vector<double> curve_of(const taskplan::Schedule& schedule) {
  std::vector<std::pair<taskplan::Ticks, double>> steps;
  double total = 0;
  for (const taskplan::TaskOutcome& task : schedule.tasks) total += task.cost;
  const bool by_cost = total > 0;
  for (const taskplan::TaskOutcome& task : schedule.tasks) {
    if (task.parking && !by_cost) continue;
    steps.emplace_back(task.start + task.duration, by_cost ? task.cost : 1.0);
  }
  std::stable_sort(steps.begin(), steps.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  if (!by_cost) total = static_cast<double>(steps.size());
  std::vector<double> curve(kCurvePoints, 0.0);
  double done = 0;
  std::size_t point = 1;
  for (const auto& [time, share] : steps) {
    done += share;
    while (point < kCurvePoints &&
           done >= total * static_cast<double>(point) / (kCurvePoints - 1) - 1e-6) {
      curve[point++] = schedule::seconds_from_ticks(time);
    }
  }
  while (point < kCurvePoints) curve[point++] = schedule::seconds_from_ticks(schedule.process_time);
  return curve;
}

/// The tasks of a plan by their names.
class TaskIndex {
 public:
  explicit TaskIndex(const interpreter::PlanModel& plan) {
    for (const interpreter::TaskSpec& each : plan.tasks) {
      index_.emplace(each.name, static_cast<int>(index_.size()));
    }
  }
  /// -1: none, such as what was done beside the plan.
  int operator()(const std::string& name) const {
    const auto found = index_.find(name);
    return found == index_.end() ? -1 : found->second;
  }

 private:
  std::unordered_map<std::string_view, int> index_;
};

// The log.
template <typename Values>
void write_list(std::string& line, const Values& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    fmt::format_to(std::back_inserter(line), "{}{}", i == 0 ? "" : " ", values[i]);
  }
  line += '\t';
}

std::string_view next_field(std::string_view& rest) {
  const std::size_t tab = rest.find('\t');
  const std::string_view field = rest.substr(0, tab);
  rest.remove_prefix(tab == std::string_view::npos ? rest.size() : tab + 1);
  return field;
}

template <typename Number>
bool read_number(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

template <typename Number>
bool read_list(std::string_view text, std::vector<Number>& values) {
  while (!text.empty()) {
    const std::size_t blank = text.find(' ');
    Number value{};
    if (!read_number(text.substr(0, blank), value)) return false;
    values.push_back(value);
    text.remove_prefix(blank == std::string_view::npos ? text.size() : blank + 1);
  }
  return true;
}

}  // namespace

RunRecord record_of(const StudyModel& study, const interpreter::PlanModel& plan,
                    const taskplan::Schedule& schedule, bool with_curve) {
  RunRecord result;
  const TaskIndex task_index(plan);
  for (const Question& each : study.questions) {
    if (schedule.feasible) {
      result.values.push_back(value_of(each, schedule));
    } else {
      result.values.push_back(each.asked == Asked::rejected ? 1 : kNever);
    }
  }
  if (schedule.feasible) {
    for (const taskplan::CriticalTask& each : schedule.critical) {
      const int task = task_index(each.task);
      if (task >= 0) result.critical.push_back(task);
    }
    std::sort(result.critical.begin(), result.critical.end());
    // The chain may lead through a task more than once: on its way it waited for another.
    result.critical.erase(std::unique(result.critical.begin(), result.critical.end()),
                          result.critical.end());
    if (with_curve) result.curve = curve_of(schedule);
    return result;
  }
  for (const taskplan::TaskOutcome& each : schedule.tasks) {
    if (each.parking || each.result == taskplan::TaskResult::done ||
        each.result == taskplan::TaskResult::not_reached) {
      continue;
    }
    const int task = task_index(each.task);
    if (task < 0) continue;
    if (result.rejected.empty() || task < result.rejected.front()) result.reason = each.reason;
    result.rejected.insert(std::upper_bound(result.rejected.begin(), result.rejected.end(), task),
                           task);
  }
  for (char& c : result.reason) {
    if (c == '\t' || c == '\n' || c == '\r') c = ' ';
  }
  return result;
}

void VariantRuns::resize(const StudyModel& study, std::int64_t runs) {
  critical.resize(tasks.size(), 0);
  values.resize(study.questions.size());
  for (auto& each : values) each.resize(static_cast<std::size_t>(runs), kNotThere);
  curves.resize(static_cast<std::size_t>(std::min(runs, kCurves)));
}

VariantFacts facts_of(const interpreter::PlanModel& plan) {
  VariantFacts facts;
  for (const interpreter::TaskSpec& each : plan.tasks) facts.tasks.push_back(each.name);
  for (const interpreter::UncertainDuration& each : uncertain_durations(plan)) {
    facts.uncertain.push_back({each.place, *each.law});
  }
  facts.start_at = plan.start_at;
  facts.currency = plan.currency;
  facts.costed = taskplan::is_costed(plan);
  return facts;
}

bool VariantRuns::fits(const RunRecord& record) const {
  const auto is_there = [&](int task) {
    return task >= 0 && static_cast<std::size_t>(task) < tasks.size();
  };
  return std::all_of(record.critical.begin(), record.critical.end(), is_there) &&
         std::all_of(record.rejected.begin(), record.rejected.end(), is_there);
}

void VariantRuns::take(std::int64_t run, const RunRecord& record) {
  const auto at = static_cast<std::size_t>(run);
  for (std::size_t i = 0; i < record.values.size(); ++i) values[i][at] = record.values[i];
  for (const int task : record.critical) ++critical[static_cast<std::size_t>(task)];
  if (at < curves.size()) curves[at] = record.curve;
  for (std::size_t i = 0; i < record.rejected.size(); ++i) {
    const auto [place, is_new] = rejections.try_emplace(record.rejected[i]);
    Rejection& each = place->second;
    ++each.runs;
    if (!is_new && each.first_run < run) continue;
    each.first_run = run;
    each.reason = i == 0 ? record.reason : std::string();
  }
}

std::optional<double> value_of(const Statistic& statistic, std::vector<double> values) {
  if (values.empty() ||
      std::any_of(values.begin(), values.end(), [](double value) { return std::isnan(value); })) {
    return std::nullopt;
  }
  if (statistic.quantile) {
    std::sort(values.begin(), values.end());
    return statistic.width ? statistics::quantile_interval(values, *statistic.quantile).width()
                           : statistics::quantile(values, *statistic.quantile);
  }
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  const statistics::Mean mean = statistics::mean_of(values);
  if (mean.count == 0 || (statistic.width && !mean.interval)) return std::nullopt;
  return statistic.width ? mean.interval->width() : mean.mean;
}

std::string write_line(const LoggedRun& run) {
  std::string line = fmt::format("run\t{}\t{}\t", run.variant, run.run);
  write_list(line, run.record.values);
  write_list(line, run.record.critical);
  write_list(line, run.record.curve);
  write_list(line, run.record.rejected);
  line += run.record.reason;
  line += "\t.";
  return line;
}

std::optional<LoggedRun> read_line(std::string_view line, std::size_t questions) {
  LoggedRun run;
  if (!line.ends_with("\t.") || next_field(line) != "run") return std::nullopt;
  if (!read_number(next_field(line), run.variant)) return std::nullopt;
  if (!read_number(next_field(line), run.run) || run.run < 0) return std::nullopt;
  RunRecord& record = run.record;
  if (!read_list(next_field(line), record.values) || record.values.size() != questions) {
    return std::nullopt;
  }
  if (!read_list(next_field(line), record.critical) || !read_list(next_field(line), record.curve) ||
      !read_list(next_field(line), record.rejected)) {
    return std::nullopt;
  }
  record.reason = next_field(line);
  return line == "." ? std::optional(std::move(run)) : std::nullopt;
}

}  // namespace rubicon::study
