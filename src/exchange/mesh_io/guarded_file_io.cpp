#include "src/exchange/mesh_io/guarded_file_io.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>

namespace rubicon::mesh_io {

namespace {

/// An absolute path without symbolic links, or errno.
std::variant<std::string, int> real_path(const std::string& path) {
  if (path.find('\0') != std::string::npos) return ENOENT;
  const std::unique_ptr<char, decltype(&std::free)> resolved(::realpath(path.c_str(), nullptr),
                                                             &std::free);
  if (!resolved) return errno;
  return std::string(resolved.get());
}

bool lies_inside(const std::string& folder, const std::string& path) {
  if (folder == "/") return true;
  return path.size() > folder.size() && path.compare(0, folder.size(), folder) == 0 &&
         path[folder.size()] == '/';
}

std::string reason(int error) {
  switch (error) {
    case ENOENT:
    case ENOTDIR:
      return "there is no such file";
    case EACCES:
    case EPERM:
      return "reading it is not permitted";
    case ELOOP:
      return "its symbolic links lead in a circle";
    case ENAMETOOLONG:
      return "its name is too long";
    default:
      return "it cannot be opened (error " + std::to_string(error) + ")";
  }
}

/// What stands there instead of a regular file; nothing when it is one.
std::optional<std::string> not_a_file(const struct stat& status) {
  if (S_ISREG(status.st_mode)) return std::nullopt;
  if (S_ISDIR(status.st_mode)) return "it is a folder, not a file";
  if (S_ISFIFO(status.st_mode)) return "it is a pipe, not a file";
  return "it is a device or socket, not a file";
}

}  // namespace

FileDescriptor::FileDescriptor(FileDescriptor&& other) noexcept
    : fd_(std::exchange(other.fd_, -1)) {}

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
  if (this != &other) {
    close();
    fd_ = std::exchange(other.fd_, -1);
  }
  return *this;
}

FileDescriptor::~FileDescriptor() { close(); }

void FileDescriptor::close() {
  if (fd_ >= 0) ::close(fd_);
  fd_ = -1;
}

std::variant<std::string, GuardedFailure> resolve_folder(const std::string& folder) {
  std::variant<std::string, int> resolved = real_path(folder.empty() ? "." : folder);
  if (const int* error = std::get_if<int>(&resolved)) {
    return GuardedFailure{"its folder cannot be used: " + reason(*error)};
  }
  return std::move(std::get<std::string>(resolved));
}

std::variant<GuardedFile, GuardedFailure> open_inside(const std::string& resolved_folder,
                                                      const std::string& path) {
  std::variant<std::string, int> resolved = real_path(path);
  if (const int* error = std::get_if<int>(&resolved)) return GuardedFailure{reason(*error)};
  GuardedFile file;
  file.path = std::move(std::get<std::string>(resolved));
  if (!lies_inside(resolved_folder, file.path)) {
    return GuardedFailure{"it lies outside the folder " + resolved_folder +
                          " of the file that names it; move it there"};
  }

  struct stat status {};
  // Asked before opening too: opening a device can already do something.
  if (::stat(file.path.c_str(), &status) != 0) return GuardedFailure{reason(errno)};
  if (std::optional<std::string> wrong = not_a_file(status)) return GuardedFailure{*wrong};
  file.descriptor = FileDescriptor(
      ::open(file.path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY | O_NOFOLLOW));
  const int fd = file.descriptor.get();
  if (fd < 0) return GuardedFailure{reason(errno)};
  if (::fstat(fd, &status) != 0) return GuardedFailure{reason(errno)};
  if (std::optional<std::string> wrong = not_a_file(status)) return GuardedFailure{*wrong};

  // The path may have been exchanged since it was resolved: what counts is where the open file is.
  std::array<char, PATH_MAX> where{};
  const std::string link = "/proc/self/fd/" + std::to_string(fd);
  const ssize_t length = ::readlink(link.c_str(), where.data(), where.size());
  if (length < 0 || !lies_inside(resolved_folder, {where.data(), static_cast<size_t>(length)})) {
    return GuardedFailure{"it was moved while it was opened"};
  }
  file.size = static_cast<std::uint64_t>(status.st_size);
  return file;
}

std::size_t read_at(int fd, std::uint64_t offset, char* bytes, std::size_t size) {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t got = ::pread(fd, bytes + done, size - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

FileDescriptor file_in_memory(std::string_view bytes) {
  FileDescriptor file(::memfd_create("rubicon", MFD_CLOEXEC));
  if (file.get() >= 0 && !write_all(file.get(), bytes)) file.close();
  return file;
}

bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::write(fd, bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(done));
  }
  return true;
}

}  // namespace rubicon::mesh_io
