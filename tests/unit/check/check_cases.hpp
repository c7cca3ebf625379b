#pragma once

#include <string>
#include <vector>

#include "interpreter/syntax/diagnostic.hpp"
#include "interpreter/syntax/source.hpp"

namespace rubicon::test {

/// A text and the diagnostics it deserves, as they stand in robot_cases.txt and plan_cases.txt.
struct CheckCase {
  std::string title;
  std::string text;
  std::vector<std::string> expected;  ///< [file:]line:column: code level: message
};

/// Reads cases: `--- title`; then the text, indented by four; then `  => ...` for each diagnostic.
/// Lines beginning with # are for people.
std::vector<CheckCase> read_check_cases(const std::string& file_name);

/// The diagnostics as they stand in the cases, one line each; the file is named where it is not
/// `main_path`.
std::string listed(const interpreter::Diagnostics& diagnostics,
                   const interpreter::SourceMap& sources, const std::string& main_path);
std::string listed(const std::vector<std::string>& expected);

}  // namespace rubicon::test
