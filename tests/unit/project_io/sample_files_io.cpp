#include "tests/unit/project_io/sample_files_io.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/support/places.hpp"

namespace rubicon::test {

namespace {

std::optional<std::string> bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

std::string sample(const std::string& name) {
  const auto text = bytes_of(test::source_dir() + "/tests/unit/project_io/" + name);
  EXPECT_TRUE(text) << name;
  return text.value_or("");
}

std::optional<std::string> shared_data(const std::string& path) {
  return bytes_of(test::source_dir() + "/../shared/data/" + path);
}

}  // namespace rubicon::test
