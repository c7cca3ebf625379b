#pragma once

#include <chrono>
#include <string_view>

namespace rubicon::cli {

/// One line of a terminal that is written again and again while the work goes on, and is gone
/// afterwards; nothing where standard error is no terminal.
class ProgressLine {
 public:
  /// Nothing is shown in the first `quiet`, and then once in `between`.
  ProgressLine(std::chrono::milliseconds quiet, std::chrono::milliseconds between)
      : quiet_(quiet), between_(between) {}
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  /// Whether `show` is to be called now.
  bool is_due() const;
  void show(std::string_view text);
  /// Since it was made.
  double seconds() const;

 private:
  using Clock = std::chrono::steady_clock;

  const std::chrono::milliseconds quiet_;
  const std::chrono::milliseconds between_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
  bool shown_ = false;
};

}  // namespace rubicon::cli
