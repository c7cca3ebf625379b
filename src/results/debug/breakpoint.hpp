#pragma once

#include <string>
#include <variant>
#include <vector>

#include "src/results/debug/recording.hpp"

namespace rubicon::debug {

/// Where `continue` and `reverse` stop.
struct Breakpoint {
  enum class Kind { line, refused, hit, pair, task };
  int number = 0;
  Kind kind = Kind::refused;
  std::size_t file = 0;  ///< line: in Recording::files
  int line = 0;
  std::string one;    ///< pair: one of the two; task: its name
  std::string other;  ///< pair: the other one, "" for any
};

/// Whether an event of a run is what a breakpoint waits for. `task` never is: it waits for a run to
/// begin.
bool matches(const Breakpoint& breakpoint, const Recording& recording, const Event& event);

/// "refused", "crane.motion:14", "pair low.hook wall_2".
std::string breakpoint_text(const Breakpoint& breakpoint, const Recording& recording);

/// A line of a script as a user names it: LINE or FILE:LINE.
struct NamedLine {
  std::size_t file = 0;
  int line = 0;
};
/// `here` is the file without a name, `recording.files.size()` if there is none. A message if it
/// names no line.
std::variant<NamedLine, std::string> line_named(const std::string& text, const Recording& recording,
                                                std::size_t here);

/// The breakpoint that the words after `break` ask for, without a number; a message if they make
/// no sense.
std::variant<Breakpoint, std::string> breakpoint_of(const std::vector<std::string>& words,
                                                    const Recording& recording, std::size_t here);

/// The lines of a file at which something is tried or begins, in order.
std::vector<int> lines_with_records(const Recording& recording, std::size_t file);

}  // namespace rubicon::debug
