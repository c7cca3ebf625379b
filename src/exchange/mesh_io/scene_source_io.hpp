#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <map>
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
#include "src/exchange/mesh_io/scene_parts.hpp"
#include "src/exchange/mesh_io/scene_work.hpp"
#include "src/exchange/mesh_io/watchdog.hpp"

namespace rubicon::mesh_io {

/// One mesh file.
struct FileQuery {
  std::string path;
  std::string folder;
  bool ignore_declared_up = false;
};

/// What a mesh file holds.
struct FileContent {
  std::shared_ptr<const FileScene> scene;   // shared: kept for the next part of the same file
  std::shared_ptr<const SceneParts> parts;  ///< of the scene
  std::string key;  ///< equal for equal content; empty when the content is in several files
};

/// Why there is no scene: a reason for people, without the name of the file.
using SceneFailure = std::string;

/// What tells without looking into a file whether it is still the one it was: device, number, size,
/// times of the last change of its content and of itself (s, ns).
using FileStamp = std::array<std::int64_t, 7>;

/// Scenes out of files and hulls out of points, by the helper program or from what it said about
/// the same bytes before. What comes back is checked: indices in range, counts within SceneLimits.
/// A file is hashed and parsed once, however many of its parts are asked for, as long as its stamp
/// stays; so it is with one that cannot be read. Any number of threads may ask at once.
class SceneSource {
 public:
  /// `helper`: path of the program. `cache_folder`: of DiskCache, empty: none. The `watchdog` is
  /// for tests to shorten.
  SceneSource(std::string helper, std::string cache_folder, const Watchdog& watchdog = {});

  std::variant<FileContent, SceneFailure> read(const FileQuery& query);

  /// The hull as one node; not verified.
  std::variant<FileScene, SceneFailure> hull(const std::vector<math::Vec3>& points);

  SceneWork work() const { return {hashed_, parsed_, decoded_}; }

 private:
  struct Input {
    int file = -1;
    std::uint64_t size = 0;
    FileStamp stamp{};  ///< of the file before it was hashed
  };
  /// The digest of a file, and what the file was then.
  struct Hashed {
    FileStamp stamp{};
    Digest key{};
  };
  /// What is remembered of a file by its digest.
  struct Remembered {
    std::variant<FileContent, SceneFailure> content;
    std::map<std::string, FileStamp> beside;  ///< files beside it; all zero: not there
    std::int64_t begun = 0;                   ///< when it was read, ns of the wall clock
  };

  std::optional<Digest> known_key(const HelperJob& job, const Input& input);
  std::optional<std::variant<FileContent, SceneFailure>> remembered(const std::string& key,
                                                                    const std::string& folder);
  void remember(const std::string& key, const std::string& folder, Remembered what);

  std::optional<Digest> key_of(const HelperJob& job, int input, std::uint64_t size);
  std::variant<FileScene, SceneFailure> ask(HelperJob job, const Input& input,
                                            const std::optional<Digest>& key);
  const std::optional<Digest>& helper_digest();

  Watchdog watchdog_;
  HelperProcess helper_;
  DiskCache disk_;
  BoundedCache<Remembered> scenes_;
  std::mutex mutex_;                       // guards what follows
  std::map<std::string, Hashed> hashes_;   ///< by device, number and how the file is read
  std::atomic<bool> helper_works_ = true;  ///< it answered when it was last asked
  std::atomic<std::uint64_t> hashed_ = 0;
  std::atomic<std::uint64_t> parsed_ = 0;
  std::atomic<std::uint64_t> decoded_ = 0;
  std::once_flag helper_hashed_;
  std::optional<Digest> helper_digest_;
};

}  // namespace rubicon::mesh_io
