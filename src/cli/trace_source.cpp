#include "src/cli/trace_source.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <system_error>

#include "src/cli/input_file.hpp"
#include "src/cli/load_runnable_plan.hpp"
#include "src/cli/set_option.hpp"
#include "src/exchange/encoding/gzip.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/exchange/files/result_folder_io.hpp"
#include "src/simulation/taskplan/run_plan.hpp"

namespace rubicon::cli {

namespace {

/// A plan begins with a word or a comment, a trace with the brace of its header, or packed.
bool begins_as_trace(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::string begin(2, ' ');
  std::ifstream(path, std::ios::binary).read(begin.data(), 2);
  return begin.front() == '{' || encoding::is_gzip(begin);
}

}  // namespace

std::string trace_named(const std::string& source) {
  if (files::is_folder(source)) return files::result_trace(source);
  return source.ends_with(".jsonl") || begins_as_trace(source) ? source : std::string();
}

std::optional<std::string> read_trace(const std::string& path, trace::TraceSink& sink) {
  try {
    each_trace_line(path, [&](const std::string& line) { sink.line(line); });
  } catch (const WrongInput& wrong) {
    return wrong.what();
  }
  return std::nullopt;
}

bool stream_trace(const std::string& source, const std::vector<std::string>& set,
                  trace::TraceSink& sink) {
  const std::string trace = trace_named(source);
  if (trace.empty()) {
    interpreter::SourceMap sources;
    const auto plan = load_runnable_plan(source, sources, parameter_texts(set));
    if (plan) taskplan::run_plan(*plan, sources, &sink, {});
    return plan != nullptr;
  }
  if (!set.empty()) {
    fmt::print(stderr,
               "rubicon: error: --set goes with a plan; {} is what a run left, and keeps what that "
               "was given\n",
               source);
    return false;
  }
  const auto failure = read_trace(trace, sink);
  if (failure) fmt::print(stderr, "rubicon: error: {}\n", *failure);
  return !failure;
}

}  // namespace rubicon::cli
