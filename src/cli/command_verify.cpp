#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

#include "src/cli/commands.hpp"
#include "src/cli/fail.hpp"
#include "src/cli/input_file.hpp"
#include "src/exchange/encoding/sha256.hpp"
#include "src/exchange/files/result_folder_io.hpp"
#include "src/results/verify/charts/check_charts.hpp"
#include "src/results/verify/charts/check_walk.hpp"
#include "src/results/verify/grid/check_jobs.hpp"
#include "src/results/verify/grid/check_ways.hpp"
#include "src/results/verify/input/trace_reader.hpp"
#include "src/results/verify/schedule/check_report.hpp"
#include "src/results/verify/verdict_text.hpp"

namespace rubicon::cli {

namespace {

using verify::UnreadableInput;

/// Reads the trace of `result`, and what identifies it.
void read_trace(const std::string& path, verify::Result& result) {
  verify::TraceReader reader;
  encoding::Sha256 digest;
  each_trace_line(path, [&](const std::string& line) {
    digest.add(line);
    digest.add("\n");
    reader.line(line);
  });
  result.trace_digest = encoding::hex(digest.finish());
  try {
    result.trace = reader.finish();
  } catch (const UnreadableInput& error) {
    throw UnreadableInput(fmt::format("{}:{}", path, error.what()));
  }
}

verify::Result read_result(const std::string& path, verify::ResultNames& names) {
  std::error_code error;
  verify::Result result;
  if (!std::filesystem::is_directory(path, error)) {
    names.trace = path;
    read_trace(path, result);
    return result;
  }
  const auto name = [&](const char* file) { return files::result_path(path, file); };
  names = {files::result_trace(path), name("schedule.json"), name("schedule.csv"),
           name("loads.csv"), name("report.html")};
  read_trace(names.trace, result);
  result.schedule_json = read_input(names.schedule_json);
  result.schedule_csv = read_input(names.schedule_csv);
  if (std::filesystem::exists(names.loads_csv, error)) {
    result.loads_csv = read_input(names.loads_csv);
  }
  if (std::filesystem::exists(names.report, error)) {
    result.report = read_input(names.report);
    if (!verify::says_its_origin(*result.report)) {
      fmt::print(stderr,
                 "rubicon: note: {} does not say which trace it was made of, and is not checked; "
                 "'rubicon report {}' makes it again\n",
                 names.report, path);
    }
  }
  return result;
}

/// The file of a result without tasks, by its name in a result folder, and its text; nothing where
/// it is no such result.
std::optional<std::string> result_of(const std::string& result, const char* name,
                                     bool (*is_result)(const std::string&), std::string& text) {
  std::error_code error;
  const std::string path =
      std::filesystem::is_directory(result, error) ? files::result_path(result, name) : result;
  if (!path.ends_with(".json") || !std::filesystem::is_regular_file(path, error)) {
    return std::nullopt;
  }
  text = read_input(path);
  return is_result(text) ? std::optional(path) : std::nullopt;
}

/// Prints a verdict; the exit code.
int tell(const std::string& said, bool is_good) {
  std::fwrite(said.data(), 1, said.size(), stdout);
  return is_good ? kFine : kInfeasible;
}

int verify_walk(const std::string& path, const std::string& text, const std::string& format) {
  const verify::WalkVerdict verdict = verify::check_walk(text);
  return tell(format == "json" ? verify::walk_verdict_json(verdict)
                               : verify::walk_verdict_text(verdict, path),
              verdict.faults.empty());
}

int verify_charts(const std::string& path, const std::string& text, const std::string& format) {
  const verify::ChartsVerdict verdict = verify::check_charts(text);
  return tell(format == "json" ? verify::charts_verdict_json(verdict)
                               : verify::charts_verdict_text(verdict, path),
              verdict.faults.empty());
}

int verify_grid(const std::string& path, const std::string& text, const std::string& format) {
  const verify::WaysVerdict verdict = verify::check_ways(text);
  return tell(format == "json" ? verify::ways_json(verdict) : verify::ways_text(verdict, path),
              verdict.faults.empty());
}

int verify_jobs(const std::string& path, const std::string& text, const std::string& format) {
  const verify::JobsVerdict verdict = verify::check_jobs(text);
  return tell(format == "json" ? verify::jobs_verdict_json(verdict)
                               : verify::jobs_verdict_text(verdict, path),
              verdict.faults.empty());
}

}  // namespace

int run_verify(const VerifyOptions& options) {
  verify::ResultNames names;
  verify::Verdict verdict;
  try {
    std::string text;
    if (const auto path = result_of(options.result, "ways.json", verify::is_grid_result, text)) {
      return verify_grid(*path, text, options.format);
    }
    if (const auto path = result_of(options.result, "jobs.json", verify::is_jobs_result, text)) {
      return verify_jobs(*path, text, options.format);
    }
    if (const auto path =
            result_of(options.result, "charts.json", verify::is_charts_result, text)) {
      return verify_charts(*path, text, options.format);
    }
    if (const auto path = result_of(options.result, "walk.json", verify::is_walk_result, text)) {
      return verify_walk(*path, text, options.format);
    }
    verdict = verify::verify(read_result(options.result, names));
  } catch (const UnreadableInput& error) {
    return fail(error.what());
  } catch (const WrongInput& error) {
    return fail(error.what());
  }
  return tell(options.format == "json" ? verify::verdict_json(verdict, names)
                                       : verify::verdict_text(verdict, names),
              verdict.faults.empty());
}

}  // namespace rubicon::cli
