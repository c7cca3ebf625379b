// The program `rubicon-mesh`: parses one mesh file under limits and writes it to standard output.
// It is started by MeshReader and may die at any moment; nothing depends on how.

#include <fmt/core.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "src/mesh_io/assimp_scene.hpp"
#include "src/mesh_io/guarded_assimp_files_io.hpp"
#include "src/mesh_io/guarded_file_io.hpp"
#include "src/mesh_io/mesh_format.hpp"
#include "src/mesh_io/scene_wire.hpp"

namespace rubicon::mesh_io {

namespace {

constexpr int kExitUsage = 2;
constexpr int kExitOutput = 3;

struct Call {
  std::string folder;
  std::string file;
  bool ignore_declared_up = false;
  rlim_t seconds = 0;
  rlim_t bytes = 0;
};

std::optional<rlim_t> number(std::string_view text) {
  rlim_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value == 0) return std::nullopt;
  return value;
}

std::optional<Call> parse_call(int argc, char** argv) {
  if (argc != 6) return std::nullopt;
  Call call;
  call.folder = argv[1];
  call.file = argv[2];
  const std::string_view up = argv[3];
  const std::optional<rlim_t> seconds = number(argv[4]);
  const std::optional<rlim_t> bytes = number(argv[5]);
  if ((up != "declared" && up != "written") || !seconds || !bytes) return std::nullopt;
  call.ignore_declared_up = up == "written";
  call.seconds = *seconds;
  call.bytes = *bytes;
  return call;
}

bool limit(int resource, rlim_t value) {
  const rlimit both{value, value};
  return ::setrlimit(static_cast<__rlimit_resource>(resource), &both) == 0;
}

bool set_limits(const Call& call) {
  constexpr rlim_t kOpenFiles = 16;
  // 1 byte, not 0: a core pattern that pipes into a program ignores 0, and 1 stops both kinds.
  constexpr rlim_t kCoreBytes = 1;
  return ::prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 && ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         limit(RLIMIT_CORE, kCoreBytes) && limit(RLIMIT_FSIZE, 0) &&
         limit(RLIMIT_NOFILE, kOpenFiles) && limit(RLIMIT_CPU, call.seconds) &&
         limit(RLIMIT_AS, call.bytes);
}

std::string too_much_memory(const Call& call) {
  return fmt::format("reading it needs more than {} MB of memory; simplify it",
                     call.bytes / 1'000'000);
}

SceneMessage read(const Call& call) {
  const std::optional<MeshFormat> format = format_of(call.file);
  if (!format) return fmt::format("its name does not end in {}", kKnownExtensions);
  std::variant<GuardedFile, GuardedFailure> opened = open_inside(call.folder, call.file);
  if (const auto* failure = std::get_if<GuardedFailure>(&opened)) return failure->message;
  GuardedFile& mesh = std::get<GuardedFile>(opened);

  AssimpQuery query;
  // A name of our own in the right folder: a symbolic link may lead to a file called otherwise.
  query.name =
      mesh.path.substr(0, mesh.path.rfind('/')) + "/rubicon-mesh." + std::string(format->extension);
  query.format = *format;
  query.ignore_declared_up = call.ignore_declared_up;
  auto files = std::make_unique<GuardedAssimpFiles>(std::move(mesh), query.name, call.folder,
                                                    format->has_parts_beside);
  try {
    SceneMessage message = read_with_assimp(query, std::move(files));
    const auto* failure = std::get_if<std::string>(&message);
    const bool memory = failure != nullptr && failure->find("bad_alloc") != std::string::npos;
    return memory ? SceneMessage(too_much_memory(call)) : message;
  } catch (const std::bad_alloc&) {
    return too_much_memory(call);
  } catch (const std::exception& error) {
    return fmt::format("it cannot be read as {}: {}", format->name, error.what());
  }
}

/// Collects small pieces into large writes.
class Output {
 public:
  bool put(std::string_view bytes) {
    buffer_.append(bytes);
    return buffer_.size() < kPiece || flush();
  }

  bool flush() {
    std::size_t done = 0;
    while (done < buffer_.size()) {
      const ssize_t sent = ::write(STDOUT_FILENO, buffer_.data() + done, buffer_.size() - done);
      if (sent < 0 && errno == EINTR) continue;
      if (sent <= 0) return false;
      done += static_cast<std::size_t>(sent);
    }
    buffer_.clear();
    return true;
  }

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 18;
  std::string buffer_;
};

int run(const Call& call) {
  const SceneMessage message = read(call);
  Output output;
  const bool sent =
      encode(message, [&](std::string_view bytes) { return output.put(bytes); }) && output.flush();
  return sent ? 0 : kExitOutput;
}

}  // namespace

}  // namespace rubicon::mesh_io

int main(int argc, char** argv) {
  using namespace rubicon::mesh_io;
  const std::optional<Call> call = parse_call(argc, argv);
  if (!call || !set_limits(*call)) {
    fmt::print(stderr,
               "usage: rubicon-mesh FOLDER FILE declared|written CPU_SECONDS MEMORY_BYTES\n"
               "reads one mesh for the command rubicon; not meant to be called by hand\n");
    return kExitUsage;
  }
  return run(*call);
}
