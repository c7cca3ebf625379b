#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>

#include "src/cli/commands.hpp"
#include "src/cli/input_file.hpp"
#include "src/results/verify/input/trace_reader.hpp"
#include "src/results/verify/verdict_text.hpp"

namespace rubicon::cli {

namespace {

using verify::UnreadableInput;

int fail(const std::string& message) {
  fmt::print(stderr, "rubicon: error: {}\n", message);
  return kWrongInput;
}

verify::Trace read_trace(const std::string& path) {
  verify::TraceReader reader;
  each_trace_line(path, [&](const std::string& line) { reader.line(line); });
  try {
    return reader.finish();
  } catch (const UnreadableInput& error) {
    throw UnreadableInput(fmt::format("{}:{}", path, error.what()));
  }
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
  result.schedule_json = read_input(names.schedule_json);
  result.schedule_csv = read_input(names.schedule_csv);
  return result;
}

}  // namespace

int run_verify(const VerifyOptions& options) {
  verify::ResultNames names;
  verify::Verdict verdict;
  try {
    verdict = verify::verify(read_result(options.result, names));
  } catch (const UnreadableInput& error) {
    return fail(error.what());
  } catch (const WrongInput& error) {
    return fail(error.what());
  }
  const std::string text = options.format == "json" ? verify::verdict_json(verdict, names)
                                                    : verify::verdict_text(verdict, names);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return verdict.faults.empty() ? kFine : kInfeasible;
}

}  // namespace rubicon::cli
