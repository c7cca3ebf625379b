#pragma once

#include <map>
#include <mutex>
#include <string>

#include "src/exchange/files/plan_files_io.hpp"

namespace rubicon::files {

/// The files of one plan for many readings, also by several threads: each file is read once, so
/// that all readings see the same bytes and share the meshes.
class CachedPlanFiles : public interpreter::FileProvider {
 public:
  explicit CachedPlanFiles(std::string typed) : files_(std::move(typed)) {}

  const PlanFiles& plan_files() const { return files_; }

  std::variant<std::string, interpreter::FileFailure> read_text(const std::string& path) override;
  std::variant<std::shared_ptr<const geometry::TriangleMesh>, interpreter::FileFailure> read_mesh(
      const interpreter::MeshRequest& request) override;
  /// Of what is asked for and what was read: equal ones stand for equal meshes. 64 hexadecimal
  /// digits.
  std::string mesh_digest(const interpreter::MeshRequest& request);

 private:
  using Text = std::variant<std::string, interpreter::FileFailure>;
  using Mesh =
      std::variant<std::shared_ptr<const geometry::TriangleMesh>, interpreter::FileFailure>;

  std::mutex mutex_;
  PlanFiles files_;
  std::map<std::string, Text> texts_;
  std::map<std::string, Mesh> meshes_;
  std::map<std::string, std::string> digests_;  ///< of meshes
};

}  // namespace rubicon::files
