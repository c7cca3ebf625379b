#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace rubicon::mesh_io {

/// A program to run for its output.
struct ChildQuery {
  std::string program;                 ///< path
  std::vector<std::string> arguments;  ///< without the program's name
  std::chrono::milliseconds time_limit{5000};
  std::size_t output_limit = 0;  ///< bytes; a child that writes more is stopped
};

/// How a child ended, and what it wrote until then.
struct ChildResult {
  enum class End { kExited, kSignalled, kTimedOut, kTooMuchOutput, kNotStarted };
  End end = End::kNotStarted;
  int code = 0;  ///< exit code, signal number, or errno, by `end`
  std::string output;
};

/// Runs a program with empty input, an empty environment, no other open files and no error output,
/// and collects what it writes. Returns within the time limit whatever the child does; nothing of
/// it is left behind.
ChildResult run_child(const ChildQuery& query);

}  // namespace rubicon::mesh_io
