#pragma once

#include <string>
#include <vector>

#include "interpreter/syntax/file_provider.hpp"

namespace rubicon::golden {

/// Numbers of a golden agree to this (LANGUAGE, golden/README): absolute, relative above 1.
inline constexpr double kNumberTolerance = 1e-6;

struct CaseResult {
  std::string name;  ///< the folder, as found
  bool passed = false;
  bool wrong_input = false;   ///< the plan or the expectation could not be read
  std::string report;         ///< the difference or the errors, for people; empty if passed
  std::string expected_json;  ///< what --update writes
  std::string expected_trace;
};

/// Runs one case. `expected` is the text of expected.json, empty if there is none (then the case
/// fails, with the new expectation in the result). Reads only through `files`.
CaseResult run_case(const std::string& folder, const std::string& expected,
                    interpreter::FileProvider& files);

/// The results as JUnit XML.
std::string junit_xml(const std::vector<CaseResult>& results);

}  // namespace rubicon::golden
