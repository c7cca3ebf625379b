// How the words of a user become commands.

#include "src/results/debug/command_words.hpp"

#include <gmock/gmock.h>

#include <set>

namespace rubicon::debug {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string meant(const std::string& word) {
  const CommandMatch match = find_command(word);
  return match.command == nullptr ? match.message : match.command->name;
}

TEST(CommandWords, NoTwoCommandsHaveTheSameNameOrLetter) {
  std::set<std::string> names;
  for (const CommandWord& word : command_words()) {
    EXPECT_TRUE(names.insert(word.name).second) << word.name;
    if (*word.letter != 0) {
      EXPECT_TRUE(names.insert(word.letter).second) << word.letter;
    }
  }
}

TEST(CommandWords, EachIsFoundByItsNameItsLetterAndItsBeginnings) {
  for (const CommandWord& word : command_words()) {
    EXPECT_EQ(meant(word.name), word.name);
    if (*word.letter != 0) {
      EXPECT_EQ(meant(word.letter), word.name);
    }
  }
  EXPECT_EQ(meant("st"), "step");
  EXPECT_EQ(meant("ba"), "back");
  EXPECT_EQ(meant("brea"), "break");
  EXPECT_EQ(meant("breaks"), "breaks");
  EXPECT_EQ(meant("tas"), "task");
  EXPECT_EQ(meant("rc"), "reverse");
}

TEST(CommandWords, WhatMayBeSeveralIsAskedBack) {
  EXPECT_EQ(meant("re"), "'re' may be record, reverse");
  EXPECT_EQ(meant("stpe"), "there is no command 'stpe'; did you mean step?");
  EXPECT_EQ(meant("xyzzy"), "there is no command 'xyzzy'; help tells what there is");
  EXPECT_EQ(meant(""), "there is no command ''; help tells what there is");
}

TEST(CommandWords, LinesFallIntoCommandsAndWords) {
  EXPECT_THAT(commands_of("break hit; continue ;where"),
              ElementsAre("break hit", "continue", "where"));
  EXPECT_THAT(commands_of(""), ElementsAre(""));
  EXPECT_THAT(commands_of("task \"a;b\" ;"), ElementsAre("task \"a;b\"", ""));
  EXPECT_THAT(words_of("break  pair \"site 1\"\ta"), ElementsAre("break", "pair", "site 1", "a"));
  EXPECT_THAT(words_of("  "), IsEmpty());
  EXPECT_THAT(words_of("p \"\" \"open"), ElementsAre("p", "", "open"));
}

}  // namespace

}  // namespace rubicon::debug
