#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "src/cli/commands.hpp"
#include "src/verify/trace_reader.hpp"
#include "src/verify/verdict_text.hpp"

namespace rubicon::cli {

namespace {

using verify::UnreadableInput;

std::ifstream open_file(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    throw UnreadableInput(fmt::format("{}: expected a file, found a folder", path));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw UnreadableInput(fmt::format("{}: there is no such file", path));
  return file;
}

verify::Trace read_trace(const std::string& path) {
  std::ifstream file = open_file(path);
  verify::TraceReader reader;
  try {
    std::string line;
    while (std::getline(file, line)) reader.line(line);
    if (file.bad()) throw UnreadableInput("0: the file cannot be read to its end");
    return reader.finish();
  } catch (const UnreadableInput& error) {
    throw UnreadableInput(fmt::format("{}:{}", path, error.what()));
  }
}

std::string read_whole(const std::string& path) {
  const std::ifstream file = open_file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

verify::Result read_result(const std::string& path, verify::ResultNames& names) {
  std::error_code error;
  verify::Result result;
  if (!std::filesystem::is_directory(path, error)) {
    names.trace = path;
    result.trace = read_trace(path);
    return result;
  }
  names = {path + "/trace.jsonl", path + "/schedule.json", path + "/schedule.csv"};
  result.trace = read_trace(names.trace);
  result.schedule_json = read_whole(names.schedule_json);
  result.schedule_csv = read_whole(names.schedule_csv);
  return result;
}

}  // namespace

int run_verify(const VerifyOptions& options) {
  verify::ResultNames names;
  verify::Verdict verdict;
  try {
    verdict = verify::verify(read_result(options.result, names));
  } catch (const UnreadableInput& error) {
    fmt::print(stderr, "rubicon: error: {}\n", error.what());
    return kWrongInput;
  }
  const std::string text = options.format == "json" ? verify::verdict_json(verdict, names)
                                                    : verify::verdict_text(verdict, names);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return verdict.faults.empty() ? kFine : kInfeasible;
}

}  // namespace rubicon::cli
