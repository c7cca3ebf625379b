#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rubicon::debug {

/// A command of the debugger.
struct CommandWord {
  const char* name;
  const char* letter;   ///< one letter for it; "" if it has none
  const char* usage;    ///< what follows the name
  const char* summary;  ///< one line
  const char* more;     ///< further lines of its help page; "" if there is no more to say
};

/// All commands, in the order of the help page.
const std::vector<CommandWord>& command_words();

struct CommandMatch {
  const CommandWord* command = nullptr;  ///< null if there is none
  std::string message;                   ///< why not
};

/// The command that `word` names: in full, by its letter or by a beginning that no other has.
CommandMatch find_command(const std::string& word);

/// A command as a transcript shows it: "> step", a line.
std::string prompt_of(std::string_view command);

/// The words of a line; "..." keeps blanks.
std::vector<std::string> words_of(std::string_view line);
/// The commands of a line, which ';' separates; blanks around them are dropped.
std::vector<std::string> commands_of(std::string_view line);

}  // namespace rubicon::debug
