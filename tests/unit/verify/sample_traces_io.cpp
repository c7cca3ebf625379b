#include "tests/unit/verify/sample_traces_io.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/places.hpp"

namespace rubicon::test {

std::vector<std::string> sample_trace(const std::string& name) {
  std::ifstream file(test::source_dir() + "/tests/unit/verify/" + name);
  EXPECT_TRUE(file) << name;
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

}  // namespace rubicon::test
