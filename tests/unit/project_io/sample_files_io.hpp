#pragma once

#include <optional>
#include <string>

namespace rubicon::test {

/// A file of tests/unit/project_io.
std::string sample(const std::string& name);

/// A file of the folder of real data beside the project; nothing if it is not there.
std::optional<std::string> shared_data(const std::string& path);

}  // namespace rubicon::test
