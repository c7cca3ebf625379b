#include "tests/unit/check/check_cases.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/places.hpp"

namespace rubicon::test {

using interpreter::Severity;

std::vector<CheckCase> read_check_cases(const std::string& file_name) {
  std::ifstream file(test::source_dir() + "/tests/unit/check/" + file_name);
  std::vector<CheckCase> cases;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("--- ", 0) == 0) {
      cases.push_back({line.substr(4), {}, {}});
    } else if (line.rfind("  => ", 0) == 0) {
      cases.back().expected.push_back(line.substr(5));
    } else if (!cases.empty() && !line.empty() && line[0] != '#') {
      EXPECT_EQ(line.substr(0, 4), "    ") << "in " << file_name << ": " << line;
      cases.back().text += (line.size() > 4 ? line.substr(4) : "") + "\n";
    }
  }
  return cases;
}

std::string listed(const interpreter::Diagnostics& diagnostics,
                   const interpreter::SourceMap& sources, const std::string& main_path) {
  std::string text;
  for (const interpreter::Diagnostic& each : diagnostics.sorted()) {
    const char* level = each.severity == Severity::error     ? "error"
                        : each.severity == Severity::warning ? "warning"
                                                             : "note";
    std::string place = "nowhere: ";
    if (each.span.file != interpreter::kNoFile) {
      const std::string& path = sources.file(each.span.file).path;
      const interpreter::Position at = sources.position(each.span);
      place = fmt::format("{}{}:{}: ", path == main_path ? "" : path + ":", at.line, at.column);
    }
    text += fmt::format("  => {}{} {}: {}\n", place, each.code, level, each.message);
  }
  return text;
}

std::string listed(const std::vector<std::string>& expected) {
  std::string text;
  for (const std::string& line : expected) text += "  => " + line + "\n";
  return text;
}

}  // namespace rubicon::test
