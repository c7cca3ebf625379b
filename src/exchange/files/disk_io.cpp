#include "src/exchange/files/disk_io.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "interpreter/parse/parse.hpp"

namespace rubicon::files {

namespace {

std::string reason(int error) { return std::strerror(error); }

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

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

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::move(other.temporary_)),
      file_(std::exchange(other.file_, nullptr)),
      target_(std::exchange(other.target_, nullptr)),
      error_(other.error_) {}

AtomicFile::~AtomicFile() {
  if (target_ != nullptr && target_ != stdout) std::fclose(target_);
  if (file_ == nullptr) return;
  std::fclose(file_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

std::variant<AtomicFile, std::string> AtomicFile::open(const std::string& path) {
  AtomicFile result;
  result.path_ = path;
  struct stat status {};
  if (path == "-") {
    result.target_ = stdout;
    result.file_ = std::tmpfile();
  } else if (::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
    if (S_ISDIR(status.st_mode)) return fmt::format("cannot write '{}': it is a folder", path);
    result.target_ = std::fopen(path.c_str(), "wb");
    if (result.target_ != nullptr) result.file_ = std::tmpfile();
  } else {
    std::string pattern = path + ".XXXXXX";
    const int descriptor = ::mkostemp(pattern.data(), O_CLOEXEC);
    if (descriptor >= 0) {
      // mkstemp makes it private; a result is an ordinary file.
      const mode_t mask = ::umask(0);
      ::umask(mask);
      if (::fchmod(descriptor, 0666 & ~mask) == 0) result.file_ = ::fdopen(descriptor, "wb");
      result.temporary_ = pattern;
      if (result.file_ == nullptr) {
        ::close(descriptor);
        ::unlink(pattern.c_str());
      }
    }
  }
  if (result.file_ == nullptr) return fmt::format("cannot write '{}': {}", path, reason(errno));
  return result;
}

void AtomicFile::write(std::string_view bytes) {
  if (error_ == 0 && std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) {
    error_ = errno == 0 ? EIO : errno;
  }
}

void AtomicFile::restart() {
  if (std::fflush(file_) != 0 || std::fseek(file_, 0, SEEK_SET) != 0 ||
      ::ftruncate(::fileno(file_), 0) != 0) {
    if (error_ == 0) error_ = errno;
  }
}

/// Copies what was written to a target that cannot be renamed over.
void AtomicFile::copy_to_target() {
  std::array<char, 1 << 16> buffer{};
  if (std::fseek(file_, 0, SEEK_SET) != 0) error_ = errno;
  while (error_ == 0) {
    const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file_);
    if (count == 0) break;
    if (std::fwrite(buffer.data(), 1, count, target_) != count) error_ = errno == 0 ? EIO : errno;
  }
  if (std::fflush(target_) != 0 && error_ == 0) error_ = errno;
  if (target_ != stdout && std::fclose(target_) != 0 && error_ == 0) error_ = errno;
  target_ = nullptr;
}

std::optional<std::string> AtomicFile::commit() {
  if (error_ == 0 && std::fflush(file_) != 0) error_ = errno;
  if (target_ != nullptr) copy_to_target();
  std::FILE* file = std::exchange(file_, nullptr);
  if (!temporary_.empty() && ::fsync(::fileno(file)) != 0 && error_ == 0) error_ = errno;
  // A full device may only say so here.
  if (std::fclose(file) != 0 && error_ == 0) error_ = errno;
  if (error_ == 0 && !temporary_.empty()) {
    if (::rename(temporary_.c_str(), path_.c_str()) != 0) {
      error_ = errno;
    } else {
      const int folder = ::open(folder_of(path_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
      if (folder >= 0) {
        ::fsync(folder);
        ::close(folder);
      }
      return std::nullopt;
    }
  }
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  if (error_ == 0) return std::nullopt;
  return fmt::format("cannot write '{}': {}", path_, reason(error_));
}

std::optional<std::string> write_file(const std::string& path, std::string_view bytes) {
  auto opened = AtomicFile::open(path);
  if (auto* message = std::get_if<std::string>(&opened)) return *message;
  auto& file = std::get<AtomicFile>(opened);
  file.write(bytes);
  return file.commit();
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
