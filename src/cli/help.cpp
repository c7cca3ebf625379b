#include "src/cli/help.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string_view>

#include "interpreter/functions/function_table.hpp"
#include "src/cli/command_table.hpp"
#include "src/cli/help_pages.hpp"

namespace rubicon::cli {

namespace {

/// Columns of a command with its arguments in the overview.
constexpr std::size_t kUsageWidth = 31;

/// Columns of a function with its arguments.
constexpr std::size_t kSignatureWidth = 13;

/// Lines as they stand, for roff.
std::string verbatim(std::string_view text) {
  std::string out = ".nf\n";
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) out += "\\&";
    if (c == '-' || c == '\\') out += '\\';
    out += c == '\\' ? 'e' : c;
    line_begins = c == '\n';
  }
  return out + ".fi\n";
}

/// The text behind the first line and the blank line under it.
std::string_view body_of(std::string_view page) { return page.substr(page.find("\n\n") + 2); }

}  // namespace

std::string overview() {
  std::string text(pages::kOverviewBegin);
  for (const Command& command : command_table()) {
    text += fmt::format("  {:<{}}{}\n", fmt::format("{} {}", command.name, command.arguments),
                        kUsageWidth, command.summary);
  }
  return text += pages::kOverviewEnd;
}

std::string function_list() {
  std::string text = "rubicon help functions - the functions of behaviours (.motion)\n\n";
  for (const interpreter::Function& function : interpreter::functions()) {
    text += fmt::format("  {:<{}}{}\n", signature(function), kSignatureWidth, function.text);
  }
  return text +
         "\np is a control parameter such as theta, v a value, d a direction (1, -1 or 0), a an "
         "angle "
         "in degrees.\ndocs/language.md says more of each.\n";
}

std::string manual_page() {
  std::string text = ".TH RUBICON 1 \"\" \"RUBICON " RUBICON_VERSION
                     "\" \"User Commands\"\n"
                     ".SH NAME\nrubicon \\- simulate construction machines and task plans\n"
                     ".SH SYNOPSIS\n.B rubicon\n.I COMMAND\n.RI [ OPTIONS ]\n.SH DESCRIPTION\n";
  text += verbatim(body_of(overview()));
  text += ".SH COMMANDS\n";
  for (const Command& command : command_table()) {
    text += fmt::format(".SS {}\n", command.name) + verbatim(body_of(command.page));
  }
  return text;
}

std::string bash_completion(const CLI::App& app) {
  std::string commands, cases;
  for (const Command& command : command_table()) {
    commands += fmt::format("{}{}", commands.empty() ? "" : " ", command.name);
    std::string options;
    for (const CLI::Option* option : app.get_subcommand(std::string(command.name))->get_options()) {
      for (const std::string& name : option->get_lnames()) options += " --" + name;
    }
    cases += fmt::format("    {}) words=\"{}\" ;;\n", command.name, options.substr(1));
  }
  return "_rubicon() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} words=\n"
         "  if ((COMP_CWORD == 1)); then\n"
         "    COMPREPLY=($(compgen -W \"" +
         commands +
         "\" -- \"$word\"))\n"
         "    return\n"
         "  fi\n"
         "  case ${COMP_WORDS[1]} in\n" +
         cases +
         "  esac\n"
         "  if [[ $word == -* ]]; then\n"
         "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
         "  elif [[ ${COMP_WORDS[1]} == help ]]; then\n"
         "    COMPREPLY=($(compgen -W \"" +
         commands +
         " functions\" -- \"$word\"))\n"
         "  else\n"
         "    mapfile -t COMPREPLY < <(compgen -f -- \"$word\")\n"
         "  fi\n"
         "}\n"
         "complete -o filenames -o default -F _rubicon rubicon\n";
}

}  // namespace rubicon::cli
