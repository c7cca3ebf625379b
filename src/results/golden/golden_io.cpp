#include "src/results/golden/golden_io.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace rubicon::golden {

namespace fs = std::filesystem;

std::vector<std::string> find_cases(const std::string& folder) {
  std::vector<std::string> cases;
  std::error_code error;
  const auto is_case = [](const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path / "site.plan", ignored);
  };
  fs::path root(folder);
  if (!root.has_filename()) root = root.parent_path();  // "cases/" and "cases" are the same folder
  if (is_case(root)) cases.push_back(root.string());
  for (fs::recursive_directory_iterator
           it(root, fs::directory_options::skip_permission_denied, error),
       end;
       !error && it != end; it.increment(error)) {
    std::error_code ignored;
    if (it->is_directory(ignored) && is_case(it->path())) cases.push_back(it->path().string());
  }
  std::sort(cases.begin(), cases.end());
  return cases;
}

std::string read_if_there(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace rubicon::golden
