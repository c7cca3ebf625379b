#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/plan_model.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/load_runnable_plan.hpp"
#include "src/files/disk_io.hpp"
#include "src/report/schedule_text.hpp"
#include "src/taskplan/run_plan.hpp"

namespace rubicon::cli {

namespace {

using interpreter::SourceMap;

/// A run shorter than this shows no progress.
constexpr std::chrono::milliseconds kQuiet{1000};
constexpr std::chrono::milliseconds kBetweenProgress{100};

/// Writes each line of a trace to all files that want it.
class TraceFiles : public trace::TraceSink {
 public:
  void line(std::string_view text) override {
    for (files::AtomicFile& file : files_) {
      file.write(text);
      file.write("\n");
    }
  }
  void restart() override {
    for (files::AtomicFile& file : files_) file.restart();
  }

  std::optional<std::string> open(const std::string& path) {
    auto file = files::AtomicFile::open(path);
    if (auto* message = std::get_if<std::string>(&file)) return *message;
    files_.push_back(std::get<files::AtomicFile>(std::move(file)));
    return std::nullopt;
  }

  std::optional<std::string> commit() {
    std::optional<std::string> failure;
    for (files::AtomicFile& file : files_) {
      auto message = file.commit();
      if (message && !failure) failure = message;
    }
    return failure;
  }

  bool wanted() const { return !files_.empty(); }

 private:
  std::vector<files::AtomicFile> files_;
};

/// "12/36 set_floor_12" on one line of a terminal, once the work is long.
class Progress {
 public:
  void show(int done, int total, const std::string& task) {
    if (::isatty(STDERR_FILENO) == 0) return;
    const auto now = std::chrono::steady_clock::now();
    if (now - start_ < kQuiet || now - last_ < kBetweenProgress) return;
    last_ = now;
    shown_ = true;
    fmt::print(stderr, "\r\x1b[K{}/{} {}", done, total, task);
    std::fflush(stderr);
  }
  ~Progress() {
    if (shown_) fmt::print(stderr, "\r\x1b[K");
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_ = start_;
  bool shown_ = false;
};

int fail(const std::string& message) {
  fmt::print(stderr, "rubicon: error: {}\n", message);
  return kWrongInput;
}

trace::TraceDetail detail_of(const std::string& word) {
  if (word == "tasks") return trace::TraceDetail::tasks;
  return word == "none" ? trace::TraceDetail::none : trace::TraceDetail::steps;
}

}  // namespace

int run_plan_command(const RunOptions& options) {
  SourceMap sources;
  const auto plan = load_runnable_plan(options.plan, sources);
  if (!plan) return kWrongInput;

  TraceFiles trace_files;
  if (!options.trace.empty()) {
    if (const auto failure = trace_files.open(options.trace)) return fail(*failure);
  }
  if (!options.out.empty()) {
    if (const auto failure = files::make_folder(options.out)) return fail(*failure);
    if (const auto failure = trace_files.open(options.out + "/trace.jsonl")) return fail(*failure);
  }

  taskplan::Schedule schedule;
  {
    Progress progress;
    taskplan::RunOptions run;
    run.detail = detail_of(options.trace_detail);
    run.on_task = [&](int done, int total, const taskplan::TaskOutcome& last) {
      progress.show(done, total, last.task);
    };
    schedule = run_plan(*plan, sources, trace_files.wanted() ? &trace_files : nullptr, run);
  }
  if (const auto failure = trace_files.commit()) return fail(*failure);
  if (!options.out.empty()) {
    if (const auto failure =
            files::write_file(options.out + "/schedule.json", report::schedule_json(schedule))) {
      return fail(*failure);
    }
    if (const auto failure =
            files::write_file(options.out + "/schedule.csv", report::schedule_csv(schedule))) {
      return fail(*failure);
    }
  }
  const std::string text = options.format == "json"  ? report::schedule_json(schedule)
                           : options.format == "csv" ? report::schedule_csv(schedule)
                                                     : report::schedule_table(schedule);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return schedule.feasible ? kFine : kInfeasible;
}

}  // namespace rubicon::cli
