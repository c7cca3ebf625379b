#pragma once

#include <functional>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace rubicon::cli {

/// What a command does when its arguments are read; gives the exit code of the process.
using Action = std::function<int()>;

/// A command: all that the call, the overview, the manual page and the completion of a shell know.
/// A new one is a row of the table, its page in help_pages.cpp and docs/commands, and a file
/// command_NAME.cpp that does the work.
struct Command {
  std::string_view name;
  std::string_view arguments;  ///< as the overview shows them
  std::string_view summary;    ///< one line of the overview
  std::string_view page;       ///< what `rubicon help NAME` prints
  Action (*declare)(CLI::App& app);
};

/// In the order in which people are shown them.
const std::vector<Command>& command_table();

/// The command of that name; null if there is none.
const Command* find_command(std::string_view name);

}  // namespace rubicon::cli
