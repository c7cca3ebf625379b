#include "src/exchange/mesh_io/guarded_job_io.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "src/exchange/mesh_io/assimp_scene.hpp"
#include "src/exchange/mesh_io/assimp_text_file.hpp"
#include "src/exchange/mesh_io/convex_hull.hpp"
#include "src/exchange/mesh_io/guarded_assimp_files_io.hpp"
#include "src/exchange/mesh_io/guarded_file_io.hpp"
#include "src/exchange/mesh_io/ifc_scene.hpp"
#include "src/exchange/mesh_io/mesh_format.hpp"
#include "src/exchange/mesh_io/near_text.hpp"
#include "src/exchange/mesh_io/ply_head.hpp"
#include "src/exchange/mesh_io/scene_wire.hpp"
#include "src/exchange/mesh_io/system_call_filter_io.hpp"

namespace rubicon::mesh_io {

namespace {

/// With `kill` above `value` a signal that can be told from others comes first.
bool limit(int resource, rlim_t value, rlim_t kill) {
  const rlimit both{value, kill};
  return ::setrlimit(static_cast<__rlimit_resource>(resource), &both) == 0;
}

bool limit(int resource, rlim_t value) { return limit(resource, value, value); }

bool set_limits(const HelperJob& job) {
  constexpr rlim_t kOpenFiles = 16;
  // 1 byte, not 0: a core pattern that pipes into a program ignores 0, and 1 stops both kinds.
  constexpr rlim_t kCoreBytes = 1;
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && limit(RLIMIT_CORE, kCoreBytes) &&
         limit(RLIMIT_FSIZE, 0) && limit(RLIMIT_NOFILE, kOpenFiles) &&
         limit(RLIMIT_CPU, job.seconds, job.seconds + 1) && limit(RLIMIT_AS, job.bytes);
}

/// Signals as a program has them at its start.
void reset_signals() {
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

std::uint64_t size_of(int fd) {
  struct stat status {};
  return ::fstat(fd, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

std::string read_whole(int fd) {
  std::string bytes(size_of(fd), '\0');
  bytes.resize(read_at(fd, 0, bytes.data(), bytes.size()));
  return bytes;
}

/// Triangles that a binary STL file announces; 0 when it is none.
std::uint64_t announced_triangles(const HelperJob& job, int fd) {
  constexpr std::uint64_t kHead = 84;
  constexpr std::uint64_t kTriangle = 50;
  std::uint32_t count = 0;
  if (job.extension != "stl" || read_at(fd, kHead - sizeof count, reinterpret_cast<char*>(&count),
                                        sizeof count) != sizeof count) {
    return 0;
  }
  return size_of(fd) == kHead + kTriangle * count ? count : 0;
}

/// An OBJ or STL file as text, near its origin; nothing if it is there already or no such text.
std::optional<NearText> text_near_origin(const HelperJob& job, int input) {
  if (job.extension == "obj") return move_near(read_whole(input), "v");
  if (job.extension != "stl" || announced_triangles(job, input) > 0) return std::nullopt;
  return move_near(read_whole(input), "vertex");
}

SceneMessage read_mesh(const HelperJob& job, const MeshFormat& format, int input) {
  if (format.name == "IFC") {
    IfcQuery ifc;
    ifc.ignore_declared_up = job.ignore_declared_up;
    return read_ifc(read_whole(input), ifc);
  }
  AssimpQuery query;
  // A name of our own in the right folder: a symbolic link may lead to a file called otherwise.
  query.name =
      job.path.substr(0, job.path.rfind('/')) + "/rubicon-mesh." + std::string(format.extension);
  query.format = format;
  query.ignore_declared_up = job.ignore_declared_up;
  if (job.extension == "ply") {
    std::string head(std::min(size_of(input), kPlyHead), '\0');
    head.resize(read_at(input, 0, head.data(), head.size()));
    if (std::string fault = ply_fault(head, size_of(input)); !fault.empty()) return fault;
  }
  // A file of holes is large and costs nothing: it is not even looked into.
  if (announced_triangles(job, input) > query.limits.triangles)
    return too_many_triangles(query.limits);
  if (const auto moved = text_near_origin(job, input)) {
    SceneMessage message =
        read_with_assimp(query, std::make_unique<AssimpTextFile>(query.name, moved->text));
    if (auto* scene = std::get_if<FileScene>(&message)) scene->origin = moved->origin;
    return message;
  }
  GuardedFile mesh{FileDescriptor(input), job.path, size_of(input)};
  std::vector<std::string> asked_for;
  auto files = std::make_unique<GuardedAssimpFiles>(std::move(mesh), query.name, job.folder,
                                                    format.has_parts_beside, asked_for);
  SceneMessage message = read_with_assimp(query, std::move(files));
  if (auto* scene = std::get_if<FileScene>(&message)) scene->files_beside = std::move(asked_for);
  return message;
}

SceneMessage read(const HelperJob& job, int input) {
  const std::optional<MeshFormat> format = format_of("." + job.extension);
  const std::string too_much_memory =
      fmt::format("reading it needs more than {} MB of memory; simplify it", job.bytes / 1'000'000);
  try {
    if (job.kind == HelperJob::Kind::kHull) return hull_of_points(read_whole(input));
    if (!format) return fmt::format("its name does not end in {}", kKnownExtensions);
    SceneMessage message = read_mesh(job, *format, input);
    const auto* failure = std::get_if<std::string>(&message);
    const bool memory = failure != nullptr && failure->find("bad_alloc") != std::string::npos;
    return memory ? SceneMessage(too_much_memory) : message;
  } catch (const std::bad_alloc&) {
    return too_much_memory;
  } catch (const std::exception& error) {
    return fmt::format("it cannot be read as {}: {}", format ? format->name : "points",
                       error.what());
  }
}

/// Collects small pieces into large writes.
class Output {
 public:
  explicit Output(int fd) : fd_(fd) {}

  bool put(std::string_view bytes) {
    buffer_.append(bytes);
    return buffer_.size() < kPiece || flush();
  }

  bool flush() {
    if (!write_all(fd_, buffer_)) return false;
    buffer_.clear();
    return true;
  }

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 18;
  int fd_;
  std::string buffer_;
};

}  // namespace

JobDescriptors keep_only(int input, int output) {
  constexpr JobDescriptors kPlaces{3, 4};
  // Out of the way first: either may stand where the other is to go.
  const int far_input = ::fcntl(input, F_DUPFD, kPlaces.output + 1);
  const int far_output = ::fcntl(output, F_DUPFD, kPlaces.output + 1);
  ::dup2(far_input, kPlaces.input);
  ::dup2(far_output, kPlaces.output);
  ::dup2(STDERR_FILENO, STDIN_FILENO);
  ::close_range(static_cast<unsigned>(kPlaces.output) + 1, ~0U, 0);
  return kPlaces;
}

int run_guarded_job(const HelperJob& job, const JobDescriptors& files, pid_t helper) {
  reset_signals();
  // It may have ended before we asked to end with it.
  if (::prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || ::getppid() != helper) return kExitUsage;
  if (!set_limits(job)) return kExitUsage;
  const bool opens_others = format_of("." + job.extension).value_or(MeshFormat{}).has_parts_beside;
  filter_system_calls(opens_others ? FileAccess::kReadPaths : FileAccess::kOpenFilesOnly);
  const SceneMessage message = read(job, files.input);
  Output output(files.output);
  const bool sent =
      encode(message, [&](std::string_view bytes) { return output.put(bytes); }) && output.flush();
  return sent ? 0 : kExitOutput;
}

}  // namespace rubicon::mesh_io
