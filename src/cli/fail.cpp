#include "src/cli/fail.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "src/cli/commands.hpp"

namespace rubicon::cli {

int fail(const std::string& message) {
  fmt::print(stderr, "rubicon: error: {}\n", message);
  return kWrongInput;
}

}  // namespace rubicon::cli
