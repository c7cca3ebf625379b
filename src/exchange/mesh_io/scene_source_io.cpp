#include "src/exchange/mesh_io/scene_source_io.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <signal.h>
#include <sys/stat.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

#include "src/exchange/mesh_io/convex_hull.hpp"
#include "src/exchange/mesh_io/mesh_format.hpp"
#include "src/exchange/mesh_io/scene_wire.hpp"

namespace rubicon::mesh_io {

namespace {

/// To be raised when the same file would give another scene than before.
constexpr std::string_view kReaderVersion = "rubicon mesh reader 9";

/// A larger file is refused unread: parsed it would not fit the memory limit either.
constexpr std::uint64_t kLargestFile = 256'000'000;

/// Address space the helper may take: its libraries (80 MB), then in proportion to the file
/// (measured: 2 to 6 bytes for a byte of STL, OBJ and PLY), never more than a site computer can
/// spare.
constexpr std::uint64_t kBaseMemory = 320'000'000;
constexpr std::uint64_t kMemoryPerByte = 16;
constexpr std::uint64_t kMostMemory = 2'000'000'000;

/// Scenes kept for further parts of the same file: three of the largest that SceneLimits let
/// through. A model of 61 MB was parsed again for each of its parts when it did not fit.
constexpr std::size_t kSceneBytes = 512'000'000;

/// A file that was changed so short a time ago (ns) may be changed again without another stamp: the
/// clock of file systems ticks every 1 to 10 ms, network drives may lag behind.
constexpr std::int64_t kSettled = 100'000'000;

std::size_t bytes_of(const FileScene& scene) {
  std::size_t bytes = sizeof(FileScene);
  for (const FileNode& node : scene.nodes) {
    bytes += sizeof(FileNode) + node.name.size() + node.vertices.size() * sizeof(math::Vec3) +
             node.triangles.size() * sizeof(std::array<int, 3>);
  }
  return bytes;
}

/// Why a helper that ended this way gave no mesh; empty when it ended well.
std::string reason_of(const HelperResult& child, const std::string& helper,
                      const HelperQuery& query) {
  const std::string name = fmt::format("'{}'", printable(helper, kLongestNameShown));
  switch (child.end) {
    case HelperResult::End::kNotStarted:
      return fmt::format(
          "the program {} that reads meshes cannot be started ({}); it belongs beside the command",
          helper.empty() ? "rubicon-mesh" : name, std::strerror(child.code));
    case HelperResult::End::kNoAnswer:
      return fmt::format(
          "the program {} that reads meshes failed ({}); it does not belong to this version", name,
          child.code < 0 ? "it was ended" : fmt::format("exit {}", child.code));
    case HelperResult::End::kTimedOut:
      return fmt::format(
          "the program that reads it gave no answer for {} s and was ended: it hangs, or this "
          "machine "
          "does; try again",
          std::chrono::duration_cast<std::chrono::seconds>(query.time_limit).count());
    case HelperResult::End::kTooMuchOutput:
      return "it grows without end while it is read; it is damaged";
    case HelperResult::End::kSignalled:
      if (child.code == SIGXCPU) {
        return fmt::format(
            "the program that reads it hung: it was ended after {} s of processor time, many times "
            "what a file of this size takes; the file is damaged, export it again",
            query.job.seconds);
      }
      if (child.code == SIGKILL) {
        return "the program that reads it was killed from outside; where memory is short, close "
               "other programs and try again";
      }
      return "it is so damaged that its reader broke down; export it again";
    case HelperResult::End::kExited:
      if (child.code == 0) return {};
      return fmt::format(
          "the program {} that reads meshes failed (exit {}); it does not belong to this version",
          name, child.code);
  }
  return {};
}

/// Digest of what an open file holds; nothing if it is shorter than `size`.
bool add_file(encoding::Sha256& hash, int fd, std::uint64_t size) {
  std::vector<char> piece(std::min<std::uint64_t>(size, std::uint64_t{1} << 18));
  for (std::uint64_t place = 0; place < size;) {
    const std::size_t wanted = std::min<std::uint64_t>(piece.size(), size - place);
    if (read_at(fd, place, piece.data(), wanted) != wanted) return false;
    hash.add({piece.data(), wanted});
    place += wanted;
  }
  return true;
}

FileStamp stamp_of(int fd) {
  struct stat status {};
  if (::fstat(fd, &status) != 0) return {};
  return {static_cast<std::int64_t>(status.st_dev),
          static_cast<std::int64_t>(status.st_ino),
          status.st_size,
          status.st_mtim.tv_sec,
          status.st_mtim.tv_nsec,
          status.st_ctim.tv_sec,
          status.st_ctim.tv_nsec};
}

/// Of a file in the folder; all zero when there is none that may be read.
FileStamp stamp_inside(const std::string& folder, const std::string& path) {
  const std::variant<GuardedFile, GuardedFailure> file = open_inside(folder, path);
  const auto* open = std::get_if<GuardedFile>(&file);
  return open == nullptr ? FileStamp{} : stamp_of(open->descriptor.get());
}

/// Now, by the clock of file systems, ns.
std::int64_t wall_clock() {
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  return now.tv_sec * 1'000'000'000 + now.tv_nsec;
}

/// Whether a change of the file at `time` (ns) or later would have given another stamp.
bool is_settled(const FileStamp& stamp, std::int64_t time) {
  return stamp[5] * 1'000'000'000 + stamp[6] + kSettled < time;
}

/// Whether a scene may come from the disk cache: it is all there, and every number is one.
bool may_be_kept(const FileScene& scene) {
  if (!scene.files_beside.empty() || !std::isfinite(scene.declared_metres_per_unit) ||
      !scene.origin.allFinite()) {
    return false;
  }
  return std::all_of(scene.nodes.begin(), scene.nodes.end(), [](const FileNode& node) {
    return std::all_of(node.vertices.begin(), node.vertices.end(),
                       [](const math::Vec3& p) { return p.allFinite(); });
  });
}

}  // namespace

SceneSource::SceneSource(std::string helper, std::string cache_folder, const Watchdog& watchdog)
    : watchdog_(watchdog),
      helper_(std::move(helper)),
      disk_(std::move(cache_folder)),
      scenes_(kSceneBytes) {}

std::variant<FileContent, SceneFailure> SceneSource::read(const FileQuery& query) {
  const std::optional<MeshFormat> format = format_of(query.path);
  if (!format) return fmt::format("its name does not end in {}", kKnownExtensions);
  const std::variant<std::string, GuardedFailure> folder = resolve_folder(query.folder);
  if (const auto* wrong = std::get_if<GuardedFailure>(&folder)) return wrong->message;
  const std::variant<GuardedFile, GuardedFailure> opened =
      open_inside(std::get<std::string>(folder), query.path);
  if (const auto* wrong = std::get_if<GuardedFailure>(&opened)) return wrong->message;
  const GuardedFile& file = std::get<GuardedFile>(opened);
  if (file.size == 0) return "it is empty";
  if (file.size > kLargestFile) {
    return fmt::format("it has {} MB, at most {} MB are read; simplify it", file.size / 1'000'000,
                       kLargestFile / 1'000'000);
  }

  HelperJob job;
  job.kind = HelperJob::Kind::kMesh;
  job.extension = format->extension;
  job.ignore_declared_up = query.ignore_declared_up;
  job.folder = std::get<std::string>(folder);
  job.path = file.path;
  const int input = file.descriptor.get();
  const std::int64_t begun = wall_clock();
  // Taken before the content is hashed: a file written to meanwhile is not remembered.
  const FileStamp stamp = stamp_of(input);
  const std::optional<Digest> key = known_key(job, {input, file.size, stamp});
  if (key) {
    if (auto kept = remembered(encoding::hex(*key), job.folder)) return std::move(*kept);
  }
  std::variant<FileScene, SceneFailure> scene = ask(job, {input, file.size, stamp}, key);
  const bool is_same = key && stamp == stamp_of(input);
  if (auto* reason = std::get_if<SceneFailure>(&scene)) {
    if (is_same && helper_works_) remember(encoding::hex(*key), job.folder, {*reason, {}, begun});
    return std::move(*reason);
  }
  FileContent content;
  content.scene = std::make_shared<const FileScene>(std::move(std::get<FileScene>(scene)));
  content.parts = std::make_shared<const SceneParts>(*content.scene);
  if (!is_same) return content;
  Remembered what;
  what.begun = begun;
  for (const std::string& beside : content.scene->files_beside) what.beside[beside] = {};
  if (what.beside.empty()) content.key = encoding::hex(*key);
  what.content = content;
  remember(encoding::hex(*key), job.folder, std::move(what));
  return content;
}

/// The digest of a file, read only if it is not the file it was when it was hashed.
std::optional<Digest> SceneSource::known_key(const HelperJob& job, const Input& input) {
  const std::string name = fmt::format("{} {} {} {}", input.stamp[0], input.stamp[1], job.extension,
                                       job.ignore_declared_up);
  {
    const std::scoped_lock lock(mutex_);
    const auto found = hashes_.find(name);
    if (found != hashes_.end() && found->second.stamp == input.stamp) return found->second.key;
  }
  const bool settled = is_settled(input.stamp, wall_clock());
  const std::optional<Digest> key = key_of(job, input.file, input.size);
  if (key && settled && input.stamp == stamp_of(input.file)) {
    const std::scoped_lock lock(mutex_);
    hashes_[name] = {input.stamp, *key};
  }
  return key;
}

/// What a file of this digest held, if the files beside it are what they were.
std::optional<std::variant<FileContent, SceneFailure>> SceneSource::remembered(
    const std::string& key, const std::string& folder) {
  std::optional<Remembered> kept = scenes_.find(key);
  if (!kept) return std::nullopt;
  for (const auto& [path, stamp] : kept->beside) {
    if (stamp_inside(folder, path) != stamp) {
      scenes_.drop(key);
      return std::nullopt;
    }
  }
  return std::move(kept->content);
}

/// Remembers it if the files beside it have been as they are since before they were read.
void SceneSource::remember(const std::string& key, const std::string& folder, Remembered what) {
  std::size_t bytes = sizeof what;
  if (const auto* content = std::get_if<FileContent>(&what.content)) {
    bytes += bytes_of(*content->scene);
  }
  for (auto& [path, stamp] : what.beside) {
    if (path.empty()) return;  // not all of them are known
    stamp = stamp_inside(folder, path);
    if (!is_settled(stamp, what.begun)) return;
  }
  scenes_.put(key, std::move(what), bytes);
}

std::variant<FileScene, SceneFailure> SceneSource::hull(const std::vector<math::Vec3>& points) {
  const std::string bytes = encode_points(points);
  const FileDescriptor input = file_in_memory(bytes);
  if (input.get() < 0) return "there is no memory for its hull";
  HelperJob job;
  job.kind = HelperJob::Kind::kHull;
  return ask(job, {input.get(), bytes.size(), stamp_of(input.get())},
             key_of(job, input.get(), bytes.size()));
}

/// What the helper says about this input, now or at an earlier time.
std::variant<FileScene, SceneFailure> SceneSource::ask(HelperJob job, const Input& input,
                                                       const std::optional<Digest>& key) {
  const SceneLimits limits;
  if (key && disk_.is_on() && helper_digest()) {
    if (const std::optional<std::string> kept = disk_.find(*key)) {
      std::variant<SceneMessage, WireError> decoded = decode(*kept, limits);
      if (auto* message = std::get_if<SceneMessage>(&decoded)) {
        auto* scene = std::get_if<FileScene>(message);
        if (scene != nullptr && may_be_kept(*scene)) {
          ++decoded_;
          return std::move(*scene);
        }
      }
    }
  }
  job.seconds = watchdog_.processor_seconds + input.size / watchdog_.bytes_per_second;
  job.bytes = std::min(kBaseMemory + kMemoryPerByte * input.size, kMostMemory);
  HelperQuery query;
  query.job = job;
  query.input = input.file;
  query.time_limit =
      std::chrono::seconds(watchdog_.wall_per_processor * job.seconds + watchdog_.wall_seconds);
  query.output_limit = largest_message(limits);
  ++parsed_;
  const HelperResult child = helper_.run(query);
  helper_works_ =
      child.end != HelperResult::End::kNotStarted && child.end != HelperResult::End::kNoAnswer;
  if (std::string reason = reason_of(child, helper_.program(), query); !reason.empty()) {
    return reason;
  }
  std::variant<SceneMessage, WireError> decoded = decode(child.output, limits);
  if (const auto* error = std::get_if<WireError>(&decoded)) {
    return "its reader broke down (" + error->message + "); export it again";
  }
  SceneMessage& message = std::get<SceneMessage>(decoded);
  if (auto* reason = std::get_if<std::string>(&message)) return std::move(*reason);
  FileScene& scene = std::get<FileScene>(message);
  ++decoded_;
  if (key && helper_digest() && may_be_kept(scene) && input.stamp == stamp_of(input.file)) {
    disk_.put(*key, child.output);
  }
  return std::move(scene);
}

/// Names everything that the answer of the helper depends on.
std::optional<Digest> SceneSource::key_of(const HelperJob& job, int input, std::uint64_t size) {
  HelperJob named;
  named.kind = job.kind;
  named.extension = job.extension;
  named.ignore_declared_up = job.ignore_declared_up;
  named.seconds = 1;  // the limits follow from the size
  named.bytes = 1;
  encoding::Sha256 hash;
  hash.add(kReaderVersion);
  if (const std::optional<Digest>& helper = helper_digest()) hash.add(encoding::hex(*helper));
  hash.add(encode_job(named));
  ++hashed_;
  if (!add_file(hash, input, size)) return std::nullopt;
  return hash.finish();
}

/// Of the helper program itself: another build of it may read the same file otherwise.
const std::optional<Digest>& SceneSource::helper_digest() {
  std::call_once(helper_hashed_, [this] {
    if (!disk_.is_on()) return;
    const FileDescriptor program(::open(helper_.program().c_str(), O_RDONLY | O_CLOEXEC));
    struct stat status {};
    if (program.get() < 0 || ::fstat(program.get(), &status) != 0 || !S_ISREG(status.st_mode)) {
      return;
    }
    encoding::Sha256 hash;
    if (add_file(hash, program.get(), static_cast<std::uint64_t>(status.st_size))) {
      helper_digest_ = hash.finish();
    }
  });
  return helper_digest_;
}

}  // namespace rubicon::mesh_io
