#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace rubicon::cli {

/// A result that cannot be used, in a message for the user.
class WrongResult : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The files that `rubicon run --out` wrote into a folder. All throw WrongResult where the file is
/// not there or is none.
class ResultFiles {
 public:
  explicit ResultFiles(std::string folder) : folder_(std::move(folder)) {}

  std::string schedule_path() const { return folder_ + "/schedule.json"; }
  std::string trace_path() const { return folder_ + "/trace.jsonl"; }

  bool has_trace() const;
  std::string schedule_json() const;
  /// The first line of the trace: its header.
  std::string trace_header() const;
  /// Gives each line of the trace to `take`; what it throws as std::invalid_argument or
  /// verify::UnreadableInput becomes a WrongResult with the line.
  void each_trace_line(const std::function<void(const std::string&)>& take) const;

 private:
  std::string folder_;
};

}  // namespace rubicon::cli
