#pragma once

#include <string>
#include <vector>

namespace rubicon::golden {

/// All folders at or below `folder` that hold a site.plan, sorted by name; links are not followed.
std::vector<std::string> find_cases(const std::string& folder);

/// The text of a file, empty if there is none.
std::string read_if_there(const std::string& path);

}  // namespace rubicon::golden
