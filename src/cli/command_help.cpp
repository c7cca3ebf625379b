#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/syntax/diagnostic.hpp"
#include "src/cli/command_table.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/help.hpp"

namespace rubicon::cli {

namespace {

void print(std::FILE* stream, std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stream);
}

}  // namespace

int run_help(const HelpOptions& options, const CLI::App& app) {
  if (options.manual) {
    print(stdout, manual_page());
  } else if (!options.shell.empty()) {
    print(stdout, bash_completion(app));
  } else if (options.command.empty()) {
    print(stdout, overview());
  } else if (options.command == "functions") {
    print(stdout, function_list());
  } else if (const Command* command = find_command(options.command)) {
    print(stdout, command->page);
  } else {
    std::vector<std::string> names = {"functions"};
    for (const Command& each : command_table()) names.emplace_back(each.name);
    const std::string near = interpreter::did_you_mean(options.command, names);
    print(stderr, fmt::format("rubicon: error: there is no command '{}'{}\n"
                              "  hint: see 'rubicon help'\n",
                              options.command,
                              near.empty() ? "" : fmt::format("; did you mean {}?", near)));
    return kWrongInput;
  }
  return kFine;
}

}  // namespace rubicon::cli
