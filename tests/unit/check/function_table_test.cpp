// The table of functions is what docs/language.md says.

#include "interpreter/functions/function_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <string>

#include "tests/support/places.hpp"

namespace rubicon::interpreter {
namespace {

/// The functions of the reference: what stands as `name(...)` in the first column of its table.
std::set<std::string> documented_functions() {
  std::ifstream file(test::source_dir() + "/docs/language.md");
  std::set<std::string> found;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line == "| function | value |") inside = true;
    if (!inside) continue;
    if (line.empty()) break;
    std::string cell = line.substr(1, line.find('|', 1) - 1);
    for (std::size_t at = cell.find('`'); at != std::string::npos;) {
      const std::size_t end = cell.find('`', at + 1);
      const std::string name = cell.substr(at + 1, end - at - 1);
      if (name.find('(') != std::string::npos) found.insert(name);
      at = cell.find('`', end + 1);
    }
  }
  found.erase("var(name)");
  return found;
}

TEST(FunctionTable, IsTheOneOfTheReference) {
  std::set<std::string> known;
  for (const Function& function : functions()) {
    EXPECT_TRUE(known.insert(signature(function)).second) << signature(function) << " twice";
  }
  EXPECT_EQ(known, documented_functions());
}

TEST(FunctionTable, EachRowIsWhole) {
  for (const Function& function : functions()) {
    SCOPED_TRACE(signature(function));
    EXPECT_NE(function.evaluate, nullptr);
    ASSERT_FALSE(function.text.empty());
    EXPECT_LE(function.text.size(), 90u) << "one line of help";
    EXPECT_NE(function.text.back(), '.');
    EXPECT_EQ(find_function(function.name, function.argument_count()), &function);
    const bool of_parameter =
        std::any_of(function.arguments.begin(), function.arguments.end(), [](Argument argument) {
          return argument == Argument::value_of_parameter ||
                 argument == Argument::direction_of_parameter;
        });
    if (of_parameter || function.result == Result::of_parameter ||
        function.result == Result::direction) {
      EXPECT_TRUE(function.takes_parameter());
    }
  }
  EXPECT_EQ(find_function("abs", 2), nullptr);
  EXPECT_EQ(find_function("tan"), nullptr);
}

TEST(FunctionTable, RowsOfOneNameFollowEachOther) {
  std::set<std::string_view> seen;
  const Function* before = nullptr;
  for (const Function& function : functions()) {
    if (before != nullptr && before->name == function.name) {
      EXPECT_LT(before->argument_count(), function.argument_count()) << function.name;
    } else {
      EXPECT_TRUE(seen.insert(function.name).second) << function.name;
    }
    before = &function;
  }
  EXPECT_EQ(function_names().size(), seen.size());
}

}  // namespace
}  // namespace rubicon::interpreter
