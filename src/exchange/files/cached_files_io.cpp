#include "src/exchange/files/cached_files_io.hpp"

#include <fmt/format.h>

namespace rubicon::files {

std::variant<std::string, interpreter::FileFailure> CachedPlanFiles::read_text(
    const std::string& path) {
  const std::lock_guard lock(mutex_);
  const auto known = texts_.find(path);
  if (known != texts_.end()) return known->second;
  return texts_.emplace(path, files_.read_text(path)).first->second;
}

std::variant<std::shared_ptr<const geometry::TriangleMesh>, interpreter::FileFailure>
CachedPlanFiles::read_mesh(const interpreter::MeshRequest& request) {
  const std::string key = fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}", request.path, request.folder,
                                      request.metres_per_unit, request.scale,
                                      static_cast<int>(request.up), request.part, request.hull);
  const std::lock_guard lock(mutex_);
  const auto known = meshes_.find(key);
  if (known != meshes_.end()) return known->second;
  return meshes_.emplace(key, files_.read_mesh(request)).first->second;
}

}  // namespace rubicon::files
