#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <optional>
#include <string>

#include "src/cli/commands.hpp"
#include "src/cli/fail.hpp"
#include "src/cli/trace_source.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/results/debug/command_words.hpp"
#include "src/results/debug/recording_reader.hpp"
#include "src/results/debug/session.hpp"

namespace rubicon::cli {

namespace {

/// A longer line of input (bytes) is no command, and may have no end.
constexpr std::size_t kLongestCommand = 65536;

/// False when nobody reads any more.
bool show(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
  return std::fflush(stdout) == 0;
}

/// The next line of standard input; nothing at its end. A line that is too long is cut.
std::optional<std::string> next_line() {
  std::string line;
  for (int c = std::fgetc(stdin); c != EOF && line.size() <= kLongestCommand;
       c = std::fgetc(stdin)) {
    if (c == '\n') return line;
    line += static_cast<char>(c);
  }
  if (line.empty()) return std::nullopt;
  return line;
}

/// Does the commands of a line; false when it is over.
bool execute_line(debug::Session& session, const std::string& line, bool echo) {
  for (const std::string& command : debug::commands_of(line)) {
    const std::string said = echo ? debug::prompt_of(command) : std::string();
    if (!show(said + session.execute(command)) || session.ended()) return false;
  }
  return true;
}

/// Commands of the call, then those of standard input.
int converse(debug::Session& session, const DebugOptions& options) {
  for (const std::string& line : options.commands) {
    if (!execute_line(session, line, true)) return kFine;
  }
  if (options.batch) return kFine;
  const bool terminal = ::isatty(STDIN_FILENO) != 0;
  while (!terminal || show("> ")) {
    const std::optional<std::string> line = next_line();
    if (!line) {
      if (terminal) show("\n");
      return kFine;
    }
    if (line->size() > kLongestCommand)
      return fail("no command is that long: the input is not read on");
    if (!execute_line(session, *line, !terminal)) return kFine;
  }
  return kFine;
}

}  // namespace

int run_debug(const DebugOptions& options) {
  debug::RecordingReader reader;
  if (!stream_trace(options.source, options.set, reader)) return kWrongInput;
  debug::Recording recording = reader.take();
  const std::string nothing = debug::Session::why_not(recording, options.task);
  if (!nothing.empty()) return fail(nothing);
  debug::Session session(std::move(recording), options.task,
                         debug::Paint{files::wants_colour(stdout)});
  return show(session.opening()) ? converse(session, options) : kFine;
}

}  // namespace rubicon::cli
