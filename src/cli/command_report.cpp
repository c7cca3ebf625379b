#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

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

/// Opens a file to read; a message if it cannot. A pipe that nobody writes to must not hang.
std::optional<std::string> open(const std::string& path, std::ifstream& file) {
  std::error_code error;
  const bool regular = std::filesystem::is_regular_file(path, error);
  if (regular) file.open(path, std::ios::binary);
  if (regular && file) return std::nullopt;
  return fmt::format("cannot read '{}'{}", path, regular ? "" : ": there is no such file");
}

/// Reads a trace; a message if it cannot.
std::optional<std::string> read_trace(const std::string& path, film::FilmWriter& writer) {
  std::ifstream file;
  if (auto failure = open(path, file)) return failure;
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

/// Reads schedule.json, where there is one; a message if it cannot.
std::optional<std::string> read_schedule(const std::string& path, std::string& text) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return std::nullopt;
  std::ifstream file;
  if (auto failure = open(path, file)) return failure;
  std::ostringstream all;
  all << file.rdbuf();
  text = all.str();
  if (text.empty()) return fmt::format("'{}' is empty", path);
  return std::nullopt;
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
  const std::string schedule = options.result + "/schedule.json";
  std::string schedule_text;
  if (folder) {
    if (const auto failure = read_schedule(schedule, schedule_text)) return fail(*failure);
  }
  const std::string out = options.out.empty() ? options.result + "/report.html" : options.out;
  try {
    if (const auto failure = write_report(out, writer, schedule_text)) return fail(*failure);
  } catch (const std::invalid_argument& error) {
    return fail(fmt::format("{}: {}", schedule, error.what()));
  }
  if (out != "-") fmt::print("{}\n", out);
  return kFine;
}

}  // namespace rubicon::cli
