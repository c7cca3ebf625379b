#include "tests/unit/mesh_io/processes_io.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>
#include <thread>

namespace rubicon::mesh_io::testing {

namespace {

namespace fs = std::filesystem;

fs::path folder_of(pid_t process) { return fs::path("/proc") / std::to_string(process); }

}  // namespace

std::vector<pid_t> children_of(pid_t parent) {
  std::vector<pid_t> result;
  std::error_code gone;
  for (const auto& thread : fs::directory_iterator(folder_of(parent) / "task", gone)) {
    std::ifstream file(thread.path() / "children");
    for (pid_t child = 0; file >> child;) result.push_back(child);
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::string status_of(pid_t process, const std::string& name) {
  std::ifstream file(folder_of(process) / "status");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(name + ":")) continue;
    const std::size_t begin = line.find_first_not_of(" \t", name.size() + 1);
    return begin == std::string::npos ? "" : line.substr(begin);
  }
  return {};
}

std::vector<std::string> open_files_of(pid_t process) {
  std::vector<std::string> result;
  std::error_code gone;
  for (const auto& file : fs::directory_iterator(folder_of(process) / "fd", gone)) {
    const std::string target = fs::read_symlink(file.path(), gone).string();
    result.push_back(file.path().filename().string() + " " + target.substr(0, target.find(':')));
  }
  std::sort(result.begin(), result.end());
  return result;
}

bool comes_true(const std::function<bool()>& what, std::chrono::seconds patience) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (!what()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

}  // namespace rubicon::mesh_io::testing
