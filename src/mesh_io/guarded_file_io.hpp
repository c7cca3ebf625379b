#pragma once

#include <cstdint>
#include <string>
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

}  // namespace rubicon::mesh_io
