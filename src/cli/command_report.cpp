#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>

#include "src/cli/commands.hpp"
#include "src/cli/fail.hpp"
#include "src/cli/input_file.hpp"
#include "src/cli/report_file.hpp"
#include "src/cli/result_files.hpp"
#include "src/exchange/files/atomic_file_io.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/exchange/files/result_owner_io.hpp"
#include "src/results/page/report_page.hpp"
#include "src/results/report/schedule_reader.hpp"

namespace rubicon::cli {

namespace {

/// The text of schedule.json, "" where there is none.
std::string checked_schedule_text(const ResultFiles& result) {
  if (!result.has_schedule()) return {};
  std::string text = result.schedule_json();
  // The page relies on what stands in it.
  report::schedule_from_json(text);
  return text;
}

/// Reads the files of a result and writes its page; a message if the page cannot be written.
std::optional<std::string> make_page(const ReportOptions& options, bool folder,
                                     const std::string& out) {
  const ResultFiles result(options.result);
  const std::string trace = folder ? result.trace_path() : options.result;
  if (auto mistake = overwriting({trace, result.schedule_path()}, {out})) return mistake;
  ReportWriter writer;
  each_trace_line(trace, [&](const std::string& line) { writer.line(line); });
  try {
    return files::write_file(out,
                             writer.page(folder ? checked_schedule_text(result) : std::string()));
  } catch (const std::invalid_argument& error) {
    throw WrongInput(fmt::format("{}: {}", result.schedule_path(), error.what()));
  }
}

}  // namespace

int run_report(const ReportOptions& options) {
  if (page::viewer_page().empty()) return fail(std::string(page::kNoViewerPage));
  const bool folder = files::is_folder(options.result);
  if (!folder && options.out.empty()) {
    return fail(
        fmt::format("'{}' is no folder: name the page to write with --out FILE", options.result));
  }
  const std::string out = options.out.empty() ? options.result + "/report.html" : options.out;
  std::error_code error;
  if (options.out.empty() && std::filesystem::exists(out, error) &&
      !files::is_own_page(std::filesystem::canonical(out, error).string())) {
    return fail(fmt::format(
        "'{}' is not a page of rubicon, and the new one would replace it: move it away, or name "
        "another file with --out",
        out));
  }
  try {
    if (const auto failure = make_page(options, folder, out)) return fail(*failure);
  } catch (const WrongInput& wrong) {
    return fail(wrong.what());
  }
  if (out != "-") fmt::print("{}\n", out);
  return kFine;
}

}  // namespace rubicon::cli
