#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/simulation/trace/trace_sink.hpp"

namespace rubicon::cli {

/// The trace that a user names: of a result folder its trace.jsonl or trace.jsonl.gz, a .jsonl file
/// or one that begins as a trace itself; empty for all else, which is a plan.
std::string trace_named(const std::string& source);

/// Hands the lines of a trace to `sink`; a message if the file cannot be read, is empty or the sink
/// refuses a line (std::invalid_argument).
std::optional<std::string> read_trace(const std::string& path, trace::TraceSink& sink);

/// Hands `sink` the trace of what a user names: of a result or a trace its lines, of a plan those
/// of its run. False when there is none; what is wrong is on the screen then.
/// `set`: NAME=VALUE for parameters of the plan.
bool stream_trace(const std::string& source, const std::vector<std::string>& set,
                  trace::TraceSink& sink);

}  // namespace rubicon::cli
