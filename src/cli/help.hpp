#pragma once

#include <string>

namespace CLI {
class App;
}

namespace rubicon::cli {

/// What `rubicon` and `rubicon help` print: the commands and what they are for.
std::string overview();

/// The functions of behaviours, from their table: what `rubicon help functions` prints.
std::string function_list();

/// The manual page, in roff: the overview's texts and the page of every command.
/// docs/man/rubicon.1 carries the same text; a test compares them.
std::string manual_page();

/// A script for bash that completes commands, options and names of files. `app` has the commands.
std::string bash_completion(const CLI::App& app);

}  // namespace rubicon::cli
