#include "src/cli/trace_source.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

#include "src/files/disk_io.hpp"

namespace rubicon::cli {

std::string trace_named(const std::string& source) {
  if (files::is_folder(source)) return source + "/trace.jsonl";
  return source.ends_with(".jsonl") ? source : std::string();
}

std::optional<std::string> read_trace(const std::string& path, trace::TraceSink& sink) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return fmt::format("cannot read '{}'", path);
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    try {
      sink.line(line);
    } catch (const std::invalid_argument& error) {
      return fmt::format("{}:{}: {}", path, number, error.what());
    }
  }
  if (number == 0) return fmt::format("'{}' is empty: this is no trace", path);
  return std::nullopt;
}

}  // namespace rubicon::cli
