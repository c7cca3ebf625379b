#pragma once

#include <map>
#include <optional>
#include <string>

#include "src/results/verify/input/record.hpp"

namespace rubicon::verify {

class JsonFields;

/// Reads a trace line by line. What is no trace throws UnreadableInput, with the line.
class TraceReader {
 public:
  void line(const std::string& text);
  /// What was read; throws if there was no header.
  Trace finish();

 private:
  int run_of(const std::string& task);
  BreakdownRecord read_breakdown(const JsonFields& fields) const;
  MovingRecord read_moving(const JsonFields& fields) const;

  Trace trace_;
  std::map<std::string, int> run_index_;
  std::map<int, Ticks> last_time_;  ///< by run: when its last record is over
};

}  // namespace rubicon::verify
