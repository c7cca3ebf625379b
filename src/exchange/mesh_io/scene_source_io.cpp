#include "src/exchange/mesh_io/scene_source_io.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <signal.h>
#include <sys/stat.h>

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
constexpr std::string_view kReaderVersion = "rubicon mesh reader 2";

/// A larger file is refused unread: parsed it would not fit the memory limit either.
constexpr std::uint64_t kLargestFile = 256'000'000;

/// Processor time a file may take: enough to find out that a small one is hostile within seconds,
/// and in proportion for honest large ones (measured: 25 MB/s for IFC, 80 to 300 for STL, OBJ and
/// PLY).
constexpr std::uint64_t kBaseSeconds = 1;
constexpr std::uint64_t kBytesPerSecond = 8'000'000;

/// Address space the helper may take: its libraries (80 MB), then in proportion to the file
/// (measured: 2 to 6 bytes for a byte of STL, OBJ and PLY), never more than a site computer can
/// spare.
constexpr std::uint64_t kBaseMemory = 320'000'000;
constexpr std::uint64_t kMemoryPerByte = 16;
constexpr std::uint64_t kMostMemory = 2'000'000'000;

/// Scenes kept for further parts of the same file.
constexpr std::size_t kSceneBytes = 64'000'000;

constexpr std::size_t kLongestNameShown = 80;

std::size_t bytes_of(const FileScene& scene) {
  std::size_t bytes = sizeof(FileScene);
  for (const FileNode& node : scene.nodes) {
    bytes += sizeof(FileNode) + node.name.size() + node.vertices.size() * sizeof(math::Vec3) +
             node.triangles.size() * sizeof(std::array<int, 3>);
  }
  return bytes;
}

/// Why a helper that ended this way gave no mesh; empty when it ended well.
std::string reason_of(const HelperResult& child, const std::string& helper, const HelperJob& job) {
  const std::string name = fmt::format("'{}'", printable(helper, kLongestNameShown));
  const std::string too_long =
      fmt::format("reading it takes more than {} s; it is damaged, or far too complex for its size",
                  job.seconds);
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
      return too_long;
    case HelperResult::End::kTooMuchOutput:
      return "it grows without end while it is read; it is damaged";
    case HelperResult::End::kSignalled:
      if (child.code == SIGXCPU || child.code == SIGKILL) return too_long;
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
bool add_file(ContentHash& hash, int fd, std::uint64_t size) {
  std::vector<char> piece(std::min<std::uint64_t>(size, std::uint64_t{1} << 18));
  for (std::uint64_t place = 0; place < size;) {
    const std::size_t wanted = std::min<std::uint64_t>(piece.size(), size - place);
    if (read_at(fd, place, piece.data(), wanted) != wanted) return false;
    hash.add({piece.data(), wanted});
    place += wanted;
  }
  return true;
}

/// What changes when a file is written to: size and time.
std::array<std::int64_t, 3> stamp_of(int fd) {
  struct stat status {};
  if (::fstat(fd, &status) != 0) return {};
  return {status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

/// Whether a scene may come from the disk cache: it is all there, and every number is one.
bool may_be_kept(const FileScene& scene) {
  if (scene.from_several_files || !std::isfinite(scene.declared_metres_per_unit) ||
      !scene.origin.allFinite()) {
    return false;
  }
  return std::all_of(scene.nodes.begin(), scene.nodes.end(), [](const FileNode& node) {
    return std::all_of(node.vertices.begin(), node.vertices.end(),
                       [](const math::Vec3& p) { return p.allFinite(); });
  });
}

}  // namespace

SceneSource::SceneSource(std::string helper, std::string cache_folder)
    : helper_(std::move(helper)), disk_(std::move(cache_folder)), scenes_(kSceneBytes) {}

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
  // Taken before the content is hashed: a file written to meanwhile is not remembered.
  const auto stamp = stamp_of(input);
  std::optional<Digest> key = key_of(job, input, file.size);
  if (key) {
    if (std::optional<FileContent> kept = scenes_.find(hex(*key))) return std::move(*kept);
  }
  std::variant<FileScene, SceneFailure> scene = ask(job, {input, file.size, stamp}, key);
  if (auto* reason = std::get_if<SceneFailure>(&scene)) return std::move(*reason);
  FileContent content;
  content.scene = std::make_shared<const FileScene>(std::move(std::get<FileScene>(scene)));
  if (key && !content.scene->from_several_files && stamp == stamp_of(input)) {
    content.key = hex(*key);
    scenes_.put(content.key, content, bytes_of(*content.scene));
  }
  return content;
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
        if (scene != nullptr && may_be_kept(*scene)) return std::move(*scene);
      }
    }
  }
  job.seconds = kBaseSeconds + input.size / kBytesPerSecond;
  job.bytes = std::min(kBaseMemory + kMemoryPerByte * input.size, kMostMemory);
  HelperQuery query;
  query.job = job;
  query.input = input.file;
  // The limit of processor time comes first; this one is for a child that sleeps.
  query.time_limit = std::chrono::seconds(2 * job.seconds + 1);
  query.output_limit = largest_message(limits);
  const HelperResult child = helper_.run(query);
  if (std::string reason = reason_of(child, helper_.program(), job); !reason.empty()) {
    return reason;
  }
  std::variant<SceneMessage, WireError> decoded = decode(child.output, limits);
  if (const auto* error = std::get_if<WireError>(&decoded)) {
    return "its reader broke down (" + error->message + "); export it again";
  }
  SceneMessage& message = std::get<SceneMessage>(decoded);
  if (auto* reason = std::get_if<std::string>(&message)) return std::move(*reason);
  FileScene& scene = std::get<FileScene>(message);
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
  ContentHash hash;
  hash.add(kReaderVersion);
  if (const std::optional<Digest>& helper = helper_digest()) hash.add(hex(*helper));
  hash.add(encode_job(named));
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
    ContentHash hash;
    if (add_file(hash, program.get(), static_cast<std::uint64_t>(status.st_size))) {
      helper_digest_ = hash.finish();
    }
  });
  return helper_digest_;
}

}  // namespace rubicon::mesh_io
