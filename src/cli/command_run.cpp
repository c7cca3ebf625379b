#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/fail.hpp"
#include "src/cli/input_file.hpp"
#include "src/cli/load_runnable_plan.hpp"
#include "src/cli/progress_line.hpp"
#include "src/cli/report_file.hpp"
#include "src/cli/run_grid.hpp"
#include "src/cli/run_network.hpp"
#include "src/cli/set_option.hpp"
#include "src/exchange/encoding/gzip.hpp"
#include "src/exchange/files/atomic_file_io.hpp"
#include "src/exchange/files/result_folder_io.hpp"
#include "src/results/page/report_page.hpp"
#include "src/results/report/earthwork.hpp"
#include "src/results/report/schedule_text.hpp"
#include "src/simulation/taskplan/run_plan.hpp"

namespace rubicon::cli {

namespace {

using interpreter::SourceMap;

/// A run shorter than this shows no progress.
constexpr std::chrono::milliseconds kQuiet{1000};
constexpr std::chrono::milliseconds kBetweenProgress{100};

/// A file that a trace goes to, packed if it is to be.
class TraceFile {
 public:
  TraceFile(files::AtomicFile file, bool packed)
      : file_(std::make_unique<files::AtomicFile>(std::move(file))), packed_(packed) {
    begin();
  }

  void line(std::string_view text) {
    write(text);
    write("\n");
  }
  void restart() {
    file_->restart();
    begin();
  }
  std::optional<std::string> commit() {
    if (pack_) pack_->finish();
    return file_->commit();
  }

 private:
  void begin() {
    if (packed_)
      pack_.emplace([file = file_.get()](std::string_view bytes) { file->write(bytes); });
  }
  void write(std::string_view bytes) {
    if (pack_) {
      pack_->write(bytes);
    } else {
      file_->write(bytes);
    }
  }

  std::unique_ptr<files::AtomicFile> file_;  ///< its place is known to the packer
  bool packed_;
  std::optional<encoding::GzipWriter> pack_;
};

/// Hands each line of a trace to all files that want it, and to the film of the report.
class TraceFiles : public trace::TraceSink {
 public:
  void line(std::string_view text) override {
    film_line(text);
    for (TraceFile& file : files_) file.line(text);
  }
  void restart() override {
    for (TraceFile& file : files_) file.restart();
    if (report_) report_.emplace();
    film_failure_.clear();
  }

  /// Takes a file that was opened; its message where it could not be.
  std::optional<std::string> add(std::variant<files::AtomicFile, std::string> file, bool packed) {
    if (auto* message = std::get_if<std::string>(&file)) return *message;
    files_.emplace_back(std::get<files::AtomicFile>(std::move(file)), packed);
    return std::nullopt;
  }

  std::optional<std::string> commit() {
    std::optional<std::string> failure;
    for (TraceFile& file : files_) {
      auto message = file.commit();
      if (message && !failure) failure = message;
    }
    return failure;
  }

  bool wanted() const { return !files_.empty(); }

  void make_film() { report_.emplace(); }

  /// Writes the page of the report; a message if that fails, also if the film has no room for
  /// something in the trace.
  std::optional<std::string> write_page(const files::ResultFolder& folder,
                                        const std::string& schedule) {
    if (!film_failure_.empty()) return film_failure_;
    return folder.write("report.html", report_->page(schedule));
  }

 private:
  void film_line(std::string_view text) {
    if (!report_ || !film_failure_.empty()) return;
    try {
      report_->line(text);
    } catch (const std::invalid_argument& error) {
      film_failure_ = error.what();
    }
  }

  std::optional<ReportWriter> report_;
  std::string film_failure_;
  std::vector<TraceFile> files_;
};

/// What --out asks for.
files::ResultTerms result_terms(const RunOptions& options, const interpreter::PlanModel& plan,
                                const std::set<std::string>& inputs) {
  files::ResultTerms terms{
      {options.compress ? "trace.jsonl.gz" : "trace.jsonl", "schedule.json", "schedule.csv"},
      inputs};
  const bool digs = std::any_of(plan.tasks.begin(), plan.tasks.end(), [](const auto& task) {
    return task.dig || task.motion_dig || task.haul;
  });
  if (digs) terms.names.emplace_back("loads.csv");
  if (!page::viewer_page().empty()) terms.names.emplace_back("report.html");
  return terms;
}

/// What --out asks for, beside the trace, and all of it to its place. A message on failure.
std::optional<std::string> write_result(files::ResultFolder& folder,
                                        const interpreter::PlanModel& plan,
                                        const taskplan::Schedule& schedule,
                                        TraceFiles& trace_files) {
  const std::string json = report::schedule_json(schedule);
  if (auto failure = folder.write("schedule.json", json)) return failure;
  if (auto failure = folder.write("schedule.csv", report::schedule_csv(schedule))) return failure;
  const std::string loads = report::loads_csv(plan, schedule);
  if (!loads.empty()) {
    if (auto failure = folder.write("loads.csv", loads)) return failure;
  }
  if (page::viewer_page().empty()) {
    fmt::print(stderr, "rubicon: note: there is no report.html: {}\n", page::kNoViewerPage);
  } else if (auto failure = trace_files.write_page(folder, json)) {
    return "report.html: " + *failure;
  }
  return folder.commit();
}

trace::TraceDetail detail_of(const std::string& word) {
  if (word == "tasks") return trace::TraceDetail::tasks;
  return word == "none" ? trace::TraceDetail::none : trace::TraceDetail::steps;
}

}  // namespace

int run_plan_command(const RunOptions& options) {
  if (options.compress && options.out.empty()) {
    return fail("--compress goes with --out; a --trace is packed if its name ends in .gz");
  }
  if (const auto code = run_grid(options)) return *code;
  if (const auto code = run_network(options)) return *code;
  SourceMap sources;
  std::set<std::string> inputs;
  const auto plan =
      load_runnable_plan(options.plan, sources, parameter_texts(options.set), false, &inputs);
  if (!plan) return kWrongInput;
  if (const auto mistake = overwriting(inputs, {options.trace})) return fail(*mistake);
  if (const auto sample = sample_spec(options.sample)) draw_durations(*plan, *sample);

  TraceFiles trace_files;
  if (!options.trace.empty()) {
    if (const auto failure = trace_files.add(files::AtomicFile::open(options.trace),
                                             options.trace.ends_with(".gz"))) {
      return fail(*failure);
    }
  }
  std::optional<files::ResultFolder> folder;
  if (!options.out.empty()) {
    auto opened = files::ResultFolder::open(options.out, result_terms(options, *plan, inputs));
    if (auto* message = std::get_if<std::string>(&opened)) return fail(*message);
    folder.emplace(std::get<files::ResultFolder>(std::move(opened)));
    if (const auto failure =
            trace_files.add(folder->create(options.compress ? "trace.jsonl.gz" : "trace.jsonl"),
                            options.compress)) {
      return fail(*failure);
    }
    if (!page::viewer_page().empty()) trace_files.make_film();
  }

  taskplan::Schedule schedule;
  {
    ProgressLine progress(kQuiet, kBetweenProgress);
    taskplan::RunOptions run;
    run.detail = detail_of(options.trace_detail);
    run.traces_graphs = options.trace_detail == "full";
    run.on_task = [&](int done, int total, const taskplan::TaskOutcome& last) {
      if (progress.is_due()) progress.show(fmt::format("{}/{} {}", done, total, last.task));
    };
    schedule = run_plan(*plan, sources, trace_files.wanted() ? &trace_files : nullptr, run);
  }
  if (const auto failure = trace_files.commit()) return fail(*failure);
  if (folder) {
    if (const auto failure = write_result(*folder, *plan, schedule, trace_files))
      return fail(*failure);
  }
  if (!options.prints) return schedule.feasible ? kFine : kInfeasible;
  const std::string text = options.format == "json"  ? report::schedule_json(schedule)
                           : options.format == "csv" ? report::schedule_csv(schedule)
                                                     : report::schedule_table(schedule);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return schedule.feasible ? kFine : kInfeasible;
}

}  // namespace rubicon::cli
