#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "src/exchange/mesh_io/bounded_cache.hpp"
#include "src/exchange/mesh_io/disk_cache_io.hpp"
#include "src/exchange/mesh_io/file_scene.hpp"
#include "src/exchange/mesh_io/guarded_file_io.hpp"
#include "src/exchange/mesh_io/helper_process_io.hpp"

namespace rubicon::mesh_io {

/// One mesh file.
struct FileQuery {
  std::string path;
  std::string folder;
  bool ignore_declared_up = false;
};

/// What a mesh file holds.
struct FileContent {
  std::shared_ptr<const FileScene> scene;  // shared: kept for the next part of the same file
  std::string key;  ///< equal for equal content; empty when the content is in several files
};

/// Why there is no scene: a reason for people, without the name of the file.
using SceneFailure = std::string;

/// Scenes out of files and hulls out of points, by the helper program or from what it said about
/// the same bytes before. What comes back is checked: indices in range, counts within SceneLimits.
/// Any number of threads may ask at once.
class SceneSource {
 public:
  /// `helper`: path of the program. `cache_folder`: of DiskCache, empty: none.
  SceneSource(std::string helper, std::string cache_folder);

  std::variant<FileContent, SceneFailure> read(const FileQuery& query);

  /// The hull as one node; not verified.
  std::variant<FileScene, SceneFailure> hull(const std::vector<math::Vec3>& points);

 private:
  struct Input {
    int file = -1;
    std::uint64_t size = 0;
    std::array<std::int64_t, 3> stamp{};  ///< of the file before it was hashed
  };

  std::optional<Digest> key_of(const HelperJob& job, int input, std::uint64_t size);
  std::variant<FileScene, SceneFailure> ask(HelperJob job, const Input& input,
                                            const std::optional<Digest>& key);
  const std::optional<Digest>& helper_digest();

  HelperProcess helper_;
  DiskCache disk_;
  BoundedCache<FileContent> scenes_;
  std::once_flag helper_hashed_;
  std::optional<Digest> helper_digest_;
};

}  // namespace rubicon::mesh_io
