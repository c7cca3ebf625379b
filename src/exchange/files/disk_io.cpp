#include "src/exchange/files/disk_io.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "interpreter/parse/parse.hpp"

namespace rubicon::files {

namespace {

std::string reason(int error) { return std::strerror(error); }

std::variant<std::string, interpreter::FileFailure> read_all(std::FILE* file) {
  std::string text;
  char buffer[1 << 16];
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, file)) {
    text.append(buffer, count);
    if (text.size() > interpreter::kMaxTextBytes) {
      return interpreter::FileFailure{
          fmt::format("the text is larger than {} MB", interpreter::kMaxTextBytes >> 20)};
    }
  }
  if (std::ferror(file)) return interpreter::FileFailure{"cannot be read: " + reason(errno)};
  return text;
}

}  // namespace

std::variant<std::string, interpreter::FileFailure> DiskFiles::read_text(const std::string& path) {
  // O_NONBLOCK: opening a pipe that nobody writes to must not hang.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) {
    return interpreter::FileFailure{errno == ENOENT ? "there is no such file"
                                                    : "cannot be opened: " + reason(errno)};
  }
  struct stat status {};
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
    ::close(descriptor);
    return interpreter::FileFailure{S_ISDIR(status.st_mode) ? "this is a folder; expected a file"
                                                            : "this is not a regular file"};
  }
  std::FILE* file = ::fdopen(descriptor, "rb");
  if (file == nullptr) {
    ::close(descriptor);
    return interpreter::FileFailure{"cannot be opened: " + reason(errno)};
  }
  auto text = read_all(file);
  std::fclose(file);
  return text;
}

std::variant<std::shared_ptr<const geometry::TriangleMesh>, interpreter::FileFailure>
DiskFiles::read_mesh(const interpreter::MeshRequest& request) {
  mesh_io::MeshRequest wanted;
  wanted.path = request.path;
  wanted.folder = request.folder;
  wanted.metres_per_unit = request.metres_per_unit;
  wanted.scale = request.scale;
  wanted.up = request.up;
  wanted.part = request.part;
  wanted.hull = request.hull;
  auto result = meshes_.read(wanted);
  if (auto* failure = std::get_if<mesh_io::MeshFailure>(&result)) {
    return interpreter::FileFailure{failure->message};
  }
  return std::get<mesh_io::ReadMesh>(std::move(result)).mesh;
}

std::variant<std::string, interpreter::FileFailure> read_standard_input() {
  return read_all(stdin);
}

std::optional<std::string> make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) return fmt::format("cannot make the folder '{}': {}", path, error.message());
  return std::nullopt;
}

bool is_folder(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_directory(path, error);
}

bool wants_colour(std::FILE* stream) {
  const char* refused = std::getenv("NO_COLOR");
  return ::isatty(::fileno(stream)) != 0 && (refused == nullptr || *refused == '\0');
}

}  // namespace rubicon::files
