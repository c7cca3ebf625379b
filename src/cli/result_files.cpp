#include "src/cli/result_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "src/verify/fault.hpp"

namespace rubicon::cli {

namespace {

std::ifstream open_file(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    throw WrongResult(fmt::format(
        "{}: there is no such file; 'rubicon run PLAN --out DIR' makes the folder of a result",
        path));
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw WrongResult(fmt::format("{}: this is not a file", path));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw WrongResult(fmt::format("{}: the file cannot be read", path));
  return file;
}

}  // namespace

bool ResultFiles::has_trace() const {
  std::error_code error;
  return std::filesystem::exists(trace_path(), error);
}

std::string ResultFiles::schedule_json() const {
  const std::ifstream file = open_file(schedule_path());
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string ResultFiles::trace_header() const {
  std::ifstream file = open_file(trace_path());
  std::string line;
  if (!std::getline(file, line)) {
    throw WrongResult(
        fmt::format("{}: expected the header of a trace, found nothing", trace_path()));
  }
  return line;
}

void ResultFiles::each_trace_line(const std::function<void(const std::string&)>& take) const {
  std::ifstream file = open_file(trace_path());
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    try {
      take(line);
    } catch (const std::invalid_argument& error) {
      throw WrongResult(fmt::format("{}:{}: {}", trace_path(), number, error.what()));
    } catch (const verify::UnreadableInput& error) {  // it names the line itself
      throw WrongResult(fmt::format("{}:{}", trace_path(), error.what()));
    }
  }
  if (file.bad())
    throw WrongResult(fmt::format("{}: the file cannot be read to its end", trace_path()));
  if (number == 0) {
    throw WrongResult(
        fmt::format("{}: expected the header of a trace, found nothing", trace_path()));
  }
}

}  // namespace rubicon::cli
