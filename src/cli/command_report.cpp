#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

#include "src/cli/commands.hpp"
#include "src/cli/report_file.hpp"
#include "src/files/disk_io.hpp"
#include "src/film/film_writer.hpp"
#include "src/page/report_page.hpp"

namespace rubicon::cli {

namespace {

int fail(const std::string& message) {
  fmt::print(stderr, "rubicon: error: {}\n", message);
  return kWrongInput;
}

/// Reads a trace; a message if it cannot.
std::optional<std::string> read_trace(const std::string& path, film::FilmWriter& writer) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return fmt::format("cannot read '{}'", path);
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    try {
      writer.line(line);
    } catch (const std::invalid_argument& error) {
      return fmt::format("{}:{}: {}", path, number, error.what());
    }
  }
  if (file.bad()) return fmt::format("cannot read '{}'", path);
  if (!writer.has_header()) return fmt::format("'{}' is empty: this is no trace", path);
  return std::nullopt;
}

/// The text of the file; "" where there is none.
std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file) text << file.rdbuf();
  return text.str();
}

}  // namespace

int run_report(const ReportOptions& options) {
  if (page::viewer_page().empty()) return fail(std::string(page::kNoViewerPage));
  const bool folder = files::is_folder(options.result);
  if (!folder && options.out.empty()) {
    return fail(
        fmt::format("'{}' is no folder: name the page to write with --out FILE", options.result));
  }
  film::FilmWriter writer;
  const std::string trace = folder ? options.result + "/trace.jsonl" : options.result;
  if (const auto failure = read_trace(trace, writer)) return fail(*failure);
  const std::string schedule = folder ? options.result + "/schedule.json" : "";
  const std::string out = options.out.empty() ? options.result + "/report.html" : options.out;
  try {
    if (const auto failure = write_report(out, writer, text_of(schedule))) return fail(*failure);
  } catch (const std::invalid_argument& error) {
    return fail(fmt::format("{}: {}", schedule, error.what()));
  }
  if (out != "-") fmt::print("{}\n", out);
  return kFine;
}

}  // namespace rubicon::cli
