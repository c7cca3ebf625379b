#include "src/cli/levelling_delay.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <variant>

#include "interpreter/check/plan_model.hpp"
#include "src/exchange/project_io/plan_text.hpp"
#include "src/simulation/taskplan/preflight_errors.hpp"
#include "src/simulation/taskplan/run_plan.hpp"

namespace rubicon::cli {

namespace {

constexpr const char* kPlan = "schedule.plan";

/// One text and nothing else: a schedule names no files.
class OneText : public interpreter::FileProvider {
 public:
  explicit OneText(std::string text) : text_(std::move(text)) {}

  std::variant<std::string, interpreter::FileFailure> read_text(const std::string& path) override {
    if (path == kPlan) return text_;
    return interpreter::FileFailure{"there is no such file"};
  }
  std::variant<std::shared_ptr<const geometry::TriangleMesh>, interpreter::FileFailure> read_mesh(
      const interpreter::MeshRequest&) override {
    return interpreter::FileFailure{"there is no such file"};
  }

 private:
  std::string text_;
};

/// When each task starts, ns; nothing if the plan cannot be run.
std::optional<std::map<std::string, std::int64_t>> starts_of(const project_io::Project& project,
                                                             project_io::Levelling levelling) {
  interpreter::Diagnostics doubts;
  OneText files(project_io::plan_text(project, "schedule", doubts, {}, levelling));
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  const auto plan = interpreter::load_plan(kPlan, sources, files, diagnostics);
  if (!plan) return std::nullopt;
  for (auto& mistake : taskplan::preflight_errors(*plan)) diagnostics.add(std::move(mistake));
  if (diagnostics.has_errors()) return std::nullopt;
  taskplan::RunOptions options;
  options.detail = trace::TraceDetail::none;
  std::map<std::string, std::int64_t> starts;
  for (const auto& task : taskplan::run_plan(*plan, sources, nullptr, options).tasks) {
    if (task.result == taskplan::TaskResult::done) starts.emplace(task.task, task.start);
  }
  return starts;
}

}  // namespace

std::optional<LevellingDelay> levelling_delay(const project_io::Project& project) {
  const auto free = starts_of(project, project_io::Levelling::none);
  const auto levelled = starts_of(project, project_io::Levelling::resources);
  if (!free || !levelled) return std::nullopt;
  LevellingDelay delay;
  constexpr std::int64_t kSecond = 1'000'000'000;
  for (const auto& [task, start] : *free) {
    ++delay.tasks;
    const auto found = levelled->find(task);
    if (found == levelled->end() || found->second <= start) continue;
    ++delay.delayed;
    const std::int64_t seconds = (found->second - start) / kSecond;
    if (seconds <= delay.longest) continue;
    delay.longest = seconds;
    delay.task = task;
  }
  return delay;
}

std::string delay_text(const LevellingDelay& delay) {
  if (delay.delayed == 0) return fmt::format("levelled: none of {} tasks waits", delay.tasks);
  const std::int64_t minutes = delay.longest / 60;
  return fmt::format(
      "levelled: {} of {} tasks start later than their links and calendars let them, '{}' most: "
      "{} d {} h {} min",
      delay.delayed, delay.tasks, delay.task, minutes / 1440, minutes / 60 % 24, minutes % 60);
}

}  // namespace rubicon::cli
