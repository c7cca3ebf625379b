#include "src/exchange/files/cached_files_io.hpp"

#include <fmt/format.h>

#include <span>

#include "src/exchange/encoding/sha256.hpp"

namespace rubicon::files {

namespace {

std::string key_of(const interpreter::MeshRequest& request) {
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}", request.path, request.folder,
                     request.metres_per_unit, request.scale, static_cast<int>(request.up),
                     request.part, request.hull);
}

template <typename T>
std::string_view bytes_of(const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

std::variant<std::string, interpreter::FileFailure> CachedPlanFiles::read_text(
    const std::string& path) {
  const std::lock_guard lock(mutex_);
  const auto known = texts_.find(path);
  if (known != texts_.end()) return known->second;
  return texts_.emplace(path, files_.read_text(path)).first->second;
}

std::variant<std::shared_ptr<const geometry::TriangleMesh>, interpreter::FileFailure>
CachedPlanFiles::read_mesh(const interpreter::MeshRequest& request) {
  const std::string key = key_of(request);
  const std::lock_guard lock(mutex_);
  const auto known = meshes_.find(key);
  if (known != meshes_.end()) return known->second;
  return meshes_.emplace(key, files_.read_mesh(request)).first->second;
}

std::string CachedPlanFiles::mesh_digest(const interpreter::MeshRequest& request) {
  const Mesh mesh = read_mesh(request);
  const std::string key = key_of(request);
  const std::lock_guard lock(mutex_);
  const auto known = digests_.find(key);
  if (known != digests_.end()) return known->second;
  encoding::Sha256 digest;
  digest.add(key + '\n');
  if (const auto* const read = std::get_if<std::shared_ptr<const geometry::TriangleMesh>>(&mesh)) {
    digest.add(bytes_of((*read)->vertices));
    digest.add(bytes_of((*read)->triangles));
  } else {
    digest.add(std::get<interpreter::FileFailure>(mesh).message);
  }
  return digests_.emplace(key, encoding::hex(digest.finish())).first->second;
}

}  // namespace rubicon::files
