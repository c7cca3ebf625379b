#include "src/cli/trace_source.hpp"

#include "src/cli/input_file.hpp"
#include "src/files/disk_io.hpp"

namespace rubicon::cli {

std::string trace_named(const std::string& source) {
  if (files::is_folder(source)) return source + "/trace.jsonl";
  return source.ends_with(".jsonl") ? source : std::string();
}

std::optional<std::string> read_trace(const std::string& path, trace::TraceSink& sink) {
  try {
    each_trace_line(path, [&](const std::string& line) { sink.line(line); });
  } catch (const WrongInput& wrong) {
    return wrong.what();
  }
  return std::nullopt;
}

}  // namespace rubicon::cli
