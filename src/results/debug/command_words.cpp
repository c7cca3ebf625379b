#include "src/results/debug/command_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "interpreter/syntax/diagnostic.hpp"
#include "src/results/debug/clean_text.hpp"

namespace rubicon::debug {

namespace {

/// Commands that debuggers of programs have under other names.
struct Alias {
  const char* word;
  const char* name;
};
constexpr Alias kAliases[] = {{"rs", "back"},        {"rc", "reverse"}, {"bt", "where"},
                              {"finish", "out"},     {"exit", "quit"},  {"?", "help"},
                              {"backtrace", "where"}};

const CommandWord* by_name(std::string_view name) {
  const auto& all = command_words();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const CommandWord& each) { return name == each.name; });
  return found == all.end() ? nullptr : &*found;
}

CommandMatch unknown(const std::string& word) {
  std::vector<std::string> names;
  for (const CommandWord& each : command_words()) names.emplace_back(each.name);
  const std::string near = interpreter::did_you_mean(word, names);
  return {nullptr,
          fmt::format("there is no command '{}'; {}", word,
                      near.empty() ? "help tells what there is" : "did you mean " + near + "?")};
}

}  // namespace

CommandMatch find_command(const std::string& word) {
  if (word.empty()) return unknown(word);
  for (const CommandWord& each : command_words()) {
    if (word == each.name || word == each.letter) return {&each, {}};
  }
  for (const Alias& each : kAliases) {
    if (word == each.word) return {by_name(each.name), {}};
  }
  std::vector<const CommandWord*> begun;
  for (const CommandWord& each : command_words()) {
    if (std::string_view(each.name).starts_with(word)) begun.push_back(&each);
  }
  if (begun.empty()) return unknown(word);
  // break and breaks, task and tasks: the shorter one is meant.
  const CommandWord* shortest =
      *std::min_element(begun.begin(), begun.end(), [](const CommandWord* a, const CommandWord* b) {
        return std::string_view(a->name).size() < std::string_view(b->name).size();
      });
  if (std::all_of(begun.begin(), begun.end(), [&](const CommandWord* each) {
        return std::string_view(each->name).starts_with(shortest->name);
      })) {
    return {shortest, {}};
  }
  std::string names;
  for (const CommandWord* each : begun)
    names += fmt::format("{}{}", names.empty() ? "" : ", ", each->name);
  return {nullptr, fmt::format("'{}' may be {}", word, names)};
}

std::string prompt_of(std::string_view command) {
  const std::string shown = clean_text(command);
  return shown.empty() ? ">\n" : "> " + shown + "\n";
}

std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  bool quoted = false;
  bool in_word = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
      if (!in_word) words.emplace_back();
      in_word = true;
    } else if ((c == ' ' || c == '\t') && !quoted) {
      in_word = false;
    } else {
      if (!in_word) words.emplace_back();
      in_word = true;
      words.back() += c;
    }
  }
  return words;
}

std::vector<std::string> commands_of(std::string_view line) {
  std::vector<std::string> commands;
  std::string text;
  const auto finish = [&] {
    const std::size_t begin = text.find_first_not_of(" \t\r");
    const std::size_t end = text.find_last_not_of(" \t\r");
    commands.push_back(begin == std::string::npos ? std::string()
                                                  : text.substr(begin, end - begin + 1));
    text.clear();
  };
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == ';' && !quoted) {
      finish();
    } else {
      text += c;
    }
  }
  finish();
  return commands;
}

}  // namespace rubicon::debug
