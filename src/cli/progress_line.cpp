#include "src/cli/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace rubicon::cli {

bool ProgressLine::is_due() const {
  if (::isatty(STDERR_FILENO) == 0) return false;
  const auto now = Clock::now();
  return now - start_ >= quiet_ && now - last_ >= between_;
}

void ProgressLine::show(std::string_view text) {
  last_ = Clock::now();
  shown_ = true;
  fmt::print(stderr, "\r\x1b[K{}", text);
  std::fflush(stderr);
}

double ProgressLine::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

ProgressLine::~ProgressLine() {
  if (shown_) fmt::print(stderr, "\r\x1b[K");
}

}  // namespace rubicon::cli
