#pragma once

#include <map>
#include <string>
#include <utility>

#include "interpreter/syntax/file_provider.hpp"

namespace rubicon::test {

/// Files that exist only in a test.
class MemoryFiles : public interpreter::FileProvider {
 public:
  MemoryFiles() = default;
  explicit MemoryFiles(std::map<std::string, std::string> texts) : texts_(std::move(texts)) {}

  std::map<std::string, std::string>& texts() { return texts_; }

  std::variant<std::string, interpreter::FileFailure> read_text(const std::string& path) override {
    const auto found = texts_.find(path);
    if (found == texts_.end()) return interpreter::FileFailure{"there is no such file"};
    return found->second;
  }
  std::variant<std::shared_ptr<const geometry::TriangleMesh>, interpreter::FileFailure> read_mesh(
      const interpreter::MeshRequest&) override {
    return interpreter::FileFailure{"there are no meshes in this test"};
  }

 private:
  std::map<std::string, std::string> texts_;
};

}  // namespace rubicon::test
