#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "interpreter/syntax/diagnostic.hpp"
#include "src/cli/command_table.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/help.hpp"

namespace {

using namespace rubicon::cli;

void print(std::FILE* stream, std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stream);
}

/// The page of the command that was chosen, or the overview.
std::string help_of(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  const Command* command = chosen.empty() ? nullptr : find_command(chosen.front()->get_name());
  return command != nullptr ? std::string(command->page) : overview();
}

/// The word of a command line that nothing expects, with what may have been meant; "" if there is
/// none.
std::string unknown_word(const CLI::App& app, int argc, char** argv) {
  using rubicon::interpreter::did_you_mean;
  const auto meant = [](const std::string& near) {
    return near.empty() ? std::string() : "; did you mean " + near + "?";
  };
  if (app.get_subcommands().empty()) {
    const std::string word = argc > 1 ? argv[1] : "";
    if (word.empty() || word.starts_with('-')) return {};
    std::vector<std::string> commands;
    for (const Command& command : command_table()) commands.emplace_back(command.name);
    return fmt::format("unknown command '{}'{}", word, meant(did_you_mean(word, commands)));
  }
  const CLI::App& chosen = *app.get_subcommands().front();
  std::vector<std::string> options = {"--help"};
  for (const CLI::Option* option : chosen.get_options()) {
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  }
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--") break;
    if (!word.starts_with("--")) continue;
    const std::string name = word.substr(0, word.find('='));
    if (std::find(options.begin(), options.end(), name) != options.end()) continue;
    return fmt::format("unknown option '{}' of {}{}", name, chosen.get_name(),
                       meant(did_you_mean(name, options)));
  }
  return {};
}

int dispatch(int argc, char** argv) {
  CLI::App app("", "rubicon");
  app.set_version_flag("--version", "rubicon " RUBICON_VERSION);
  app.require_subcommand(0, 1);
  app.allow_extras(false);
  std::vector<std::pair<const CLI::App*, Action>> actions;
  for (const Command& command : command_table()) {
    CLI::App* const declared = app.add_subcommand(std::string(command.name));
    actions.emplace_back(declared, command.declare(*declared));
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    print(stdout, help_of(app));
    return kFine;
  } catch (const CLI::CallForVersion&) {
    print(stdout, "rubicon " RUBICON_VERSION "\n");
    return kFine;
  } catch (const CLI::ParseError& error) {
    const auto chosen = app.get_subcommands();
    const std::string topic = chosen.empty() ? std::string() : " " + chosen.front()->get_name();
    const bool unexpected = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
    const std::string unknown = unexpected ? unknown_word(app, argc, argv) : std::string();
    print(stderr, fmt::format("rubicon: error: {}\n  hint: see 'rubicon help{}'\n",
                              unknown.empty() ? error.what() : unknown, topic));
    return kWrongInput;
  }
  for (const auto& [declared, action] : actions) {
    if (declared->parsed()) return action();
  }
  print(stdout, overview());
  return kFine;
}

}  // namespace

int main(int argc, char** argv) {
  // A file that may not grow (ulimit -f) is a full disk, with a message, not the end.
  std::signal(SIGXFSZ, SIG_IGN);
  int code = kInternalFault;
  try {
    code = dispatch(argc, argv);
  } catch (const std::exception& error) {
    print(stderr, fmt::format("rubicon: internal fault: {}\n", error.what()));
    return kInternalFault;
  }
  // What was printed must have arrived: a full disk behind a redirection is an error, not a short
  // file.
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    print(stderr, "rubicon: error: standard output cannot be written\n");
    return kWrongInput;
  }
  return code;
}
