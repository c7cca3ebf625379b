#pragma once

#include <string_view>

namespace rubicon::trace {

/// Takes a trace line by line, as it is written. A file, a pipe or a test stands behind it.
class TraceSink {
 public:
  virtual ~TraceSink() = default;
  /// One JSON object without a line end; valid only during the call.
  virtual void line(std::string_view text) = 0;
  /// Forgets all lines so far: the run begins anew.
  virtual void restart() = 0;
};

/// How much is written: every attempt; only tasks, loads and the ends of motions; only the header.
enum class TraceDetail { steps, tasks, none };

}  // namespace rubicon::trace
