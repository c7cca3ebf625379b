#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

namespace rubicon::mesh_io {

/// An open file descriptor that closes itself.
class FileDescriptor {
 public:
  FileDescriptor() = default;
  explicit FileDescriptor(int fd) : fd_(fd) {}
  FileDescriptor(FileDescriptor&& other) noexcept;
  FileDescriptor& operator=(FileDescriptor&& other) noexcept;
  ~FileDescriptor();

  int get() const { return fd_; }
  void close();

 private:
  int fd_ = -1;
};

/// A regular file open for reading.
struct GuardedFile {
  FileDescriptor descriptor;
  std::string path;        ///< absolute, without symbolic links
  std::uint64_t size = 0;  ///< bytes
};

/// Why a file was not opened: lower case, for people.
struct GuardedFailure {
  std::string message;
};

/// `folder` as an absolute path without symbolic links; empty stands for ".".
std::variant<std::string, GuardedFailure> resolve_folder(const std::string& folder);

/// Opens `path` for reading if, all symbolic links resolved, it is a regular file inside
/// `resolved_folder` (from resolve_folder) or below. Never waits (pipes), never touches a device.
std::variant<GuardedFile, GuardedFailure> open_inside(const std::string& resolved_folder,
                                                      const std::string& path);

/// Up to `size` bytes of an open file from `offset` on; how many there were before its end or an
/// error. Does not move the file's own place.
std::size_t read_at(int fd, std::uint64_t offset, char* bytes, std::size_t size);

/// A file without a name that holds these bytes; descriptor -1 when there is no room.
FileDescriptor file_in_memory(std::string_view bytes);

/// Writes all of `bytes`; false when that failed.
bool write_all(int fd, std::string_view bytes);

}  // namespace rubicon::mesh_io
