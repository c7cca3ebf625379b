#include "src/exchange/files/atomic_file_io.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "src/exchange/files/folder_steps_io.hpp"

namespace rubicon::files {

namespace {

/// The only way to an open file without a name.
std::string link_to(int descriptor) { return fmt::format("/proc/self/fd/{}", descriptor); }

std::string message_of(const std::string& path, int error) {
  return fmt::format("cannot write '{}': {}", path, std::strerror(error));
}

/// No system follows more.
constexpr int kMostFollowed = 40;

/// Where a chain of links leads; the path itself where it is none, or leads nowhere.
std::string followed(const std::string& path) {
  std::error_code error;
  std::filesystem::path at = path;
  for (int i = 0; i < kMostFollowed; ++i) {
    const std::filesystem::path next = std::filesystem::read_symlink(at, error);
    if (error) return at.string();
    at = at.parent_path() / next;
  }
  return path;
}

constexpr const char* kAccessList = "system.posix_acl_access";

/// False where there is a list and it could not be set.
bool copy_access_list(const std::string& from, int to) {
  std::vector<char> list(4096);
  const ssize_t size = ::getxattr(from.c_str(), kAccessList, list.data(), list.size());
  if (size < 0) return errno != ERANGE;
  return ::fsetxattr(to, kAccessList, list.data(), static_cast<std::size_t>(size), 0) == 0;
}

/// Room for all bytes, before the first is written over; an error number, 0 for none.
int make_room(std::FILE* file, std::FILE* from) {
  const long size = std::fseek(from, 0, SEEK_END) == 0 ? std::ftell(from) : 0;
  if (size <= 0 || ::fallocate(::fileno(file), FALLOC_FL_KEEP_SIZE, 0, size) == 0) return 0;
  return errno == ENOSPC || errno == EFBIG || errno == EDQUOT ? errno : 0;
}

bool is_regular(std::FILE* file) {
  struct stat status {};
  return ::fstat(::fileno(file), &status) == 0 && S_ISREG(status.st_mode);
}

}  // namespace

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      shown_(std::move(other.shown_)),
      place_(other.place_),
      temporary_(std::move(other.temporary_)),
      guard_(std::move(other.guard_)),
      file_(std::exchange(other.file_, nullptr)),
      target_(std::exchange(other.target_, nullptr)),
      error_(other.error_) {}

AtomicFile::~AtomicFile() {
  if (target_ != nullptr && target_ != stdout) std::fclose(target_);
  if (file_ == nullptr) return;
  std::fclose(file_);
  guard_.remove();
}

/// Not every file system has files without a name, and not every machine shows /proc.
void AtomicFile::open_unnamed() {
  const int descriptor = ::open(folder_of(path_).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  if (descriptor < 0) return;
  if (::access(link_to(descriptor).c_str(), F_OK) == 0) file_ = ::fdopen(descriptor, "wb");
  if (file_ == nullptr) ::close(descriptor);
  place_ = Place::unnamed;
}

void AtomicFile::open_named() {
  const SignalHold hold;
  std::string pattern = path_ + ".XXXXXX";
  const int descriptor = ::mkostemp(pattern.data(), O_CLOEXEC);
  if (descriptor < 0) return;
  // mkstemp makes it private; a result is an ordinary file.
  const mode_t mask = ::umask(0);
  ::umask(mask);
  if (::fchmod(descriptor, 0666 & ~mask) == 0) file_ = ::fdopen(descriptor, "wb");
  if (file_ == nullptr) {
    const int error = errno;
    ::close(descriptor);
    ::unlink(pattern.c_str());
    errno = error;
    return;
  }
  place_ = Place::named;
  temporary_ = pattern;
  guard_ = Temporaries({pattern}, {});
}

void AtomicFile::take_rights(const std::string& old) {
  struct stat status {};
  struct stat own {};
  const int descriptor = ::fileno(file_);
  if (::stat(old.c_str(), &status) != 0 || ::fstat(descriptor, &own) != 0) return;
  const uid_t owner = own.st_uid == status.st_uid ? static_cast<uid_t>(-1) : status.st_uid;
  const gid_t group = own.st_gid == status.st_gid ? static_cast<gid_t>(-1) : status.st_gid;
  bool same_group = ::fchown(descriptor, owner, group) == 0;
  if (!same_group) same_group = ::fchown(descriptor, static_cast<uid_t>(-1), group) == 0;
  mode_t mode = status.st_mode & 0777;
  const auto for_all = [&] { return (mode & ~mode_t{0070}) | ((mode & 07U) << 3U); };
  // Another group must not get the rights that were meant for this one.
  if (!same_group) mode = for_all();
  bool done = ::fchmod(descriptor, mode) == 0;
  if (!copy_access_list(old, descriptor)) done = ::fchmod(descriptor, mode = for_all()) == 0;
  if (!done && error_ == 0) error_ = errno;
}

std::variant<AtomicFile, std::string> AtomicFile::open_for_change(const std::string& path) {
  const std::string file = followed(path);
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode) || status.st_nlink < 2) {
    return open(path);
  }
  AtomicFile result;
  result.path_ = file;
  result.shown_ = path;
  result.place_ = Place::stream;
  result.target_ = std::fopen(file.c_str(), "r+b");
  if (result.target_ != nullptr) result.file_ = std::tmpfile();
  if (result.file_ == nullptr) return message_of(path, errno);
  return result;
}

std::variant<AtomicFile, std::string> AtomicFile::open(const std::string& path) {
  AtomicFile result;
  result.path_ = path == "-" ? path : followed(path);
  result.shown_ = path;
  struct stat status {};
  if (path == "-") {
    result.place_ = Place::stream;
    result.target_ = stdout;
    result.file_ = std::tmpfile();
  } else if (::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
    if (S_ISDIR(status.st_mode)) return fmt::format("cannot write '{}': it is a folder", path);
    result.place_ = Place::stream;
    result.target_ = std::fopen(path.c_str(), "wb");
    if (result.target_ != nullptr) result.file_ = std::tmpfile();
  } else {
    result.open_unnamed();
    if (result.file_ == nullptr) result.open_named();
    if (result.file_ != nullptr) result.take_rights(result.path_);
  }
  if (result.file_ == nullptr) return message_of(path, errno);
  return result;
}

std::variant<AtomicFile, std::string> AtomicFile::create(const std::string& path,
                                                         std::string shown) {
  AtomicFile result;
  result.path_ = path;
  result.shown_ = std::move(shown);
  const int descriptor = ::open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
  if (descriptor >= 0) result.file_ = ::fdopen(descriptor, "wb");
  if (result.file_ == nullptr) return message_of(result.shown_, errno);
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
int AtomicFile::copy_to_target() {
  std::array<char, 1 << 16> buffer{};
  const bool in_place = target_ != stdout && is_regular(target_);
  int error = in_place ? make_room(target_, file_) : 0;
  if (error == 0 && std::fseek(file_, 0, SEEK_SET) != 0) error = errno;
  while (error == 0) {
    const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file_);
    if (count == 0) break;
    if (std::fwrite(buffer.data(), 1, count, target_) != count) error = errno == 0 ? EIO : errno;
  }
  if (std::fflush(target_) != 0 && error == 0) error = errno;
  if (in_place && error == 0) {
    const int descriptor = ::fileno(target_);
    if (::ftruncate(descriptor, std::ftell(target_)) != 0 || ::fsync(descriptor) != 0) {
      error = errno;
    }
  }
  if (target_ != stdout && std::fclose(target_) != 0 && error == 0) error = errno;
  target_ = nullptr;
  return error;
}

int AtomicFile::sync() { return ::fsync(::fileno(file_)) == 0 ? 0 : errno; }

int AtomicFile::put_in_place() {
  // From here on a file without a name may have one for a moment.
  const SignalHold hold;
  if (place_ == Place::unnamed) {
    const std::string self = link_to(::fileno(file_));
    if (::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, path_.c_str(), AT_SYMLINK_FOLLOW) == 0) return 0;
    if (errno != EEXIST) return errno;
    // A link is not made over a file that is there: it takes a name and a rename.
    for (unsigned attempt = 0;; ++attempt) {
      temporary_ = fmt::format("{}.{:06x}", path_,
                               (static_cast<unsigned>(::getpid()) + attempt) & 0xffffffU);
      if (::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, temporary_.c_str(), AT_SYMLINK_FOLLOW) == 0) {
        break;
      }
      if (errno != EEXIST || attempt == 1000) return errno;
    }
    guard_ = Temporaries({temporary_}, {});
  }
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) return errno;
  guard_.release();
  return 0;
}

std::optional<std::string> AtomicFile::commit() {
  if (error_ == 0 && std::fflush(file_) != 0) error_ = errno;
  if (place_ == Place::stream) {
    const int error = copy_to_target();
    if (error_ == 0) error_ = error;
  } else if (error_ == 0) {
    error_ = sync();
    if (error_ == 0 && place_ != Place::target) error_ = put_in_place();
  }
  // A full device may only say so here.
  if (std::fclose(std::exchange(file_, nullptr)) != 0 && error_ == 0) error_ = errno;
  guard_.remove();
  if (error_ != 0) return message_of(shown_, error_);
  if (place_ == Place::named || place_ == Place::unnamed) sync_folder(folder_of(path_));
  return std::nullopt;
}

namespace {

std::optional<std::string> write_to(std::variant<AtomicFile, std::string> opened,
                                    std::string_view bytes) {
  if (auto* message = std::get_if<std::string>(&opened)) return *message;
  auto& file = std::get<AtomicFile>(opened);
  file.write(bytes);
  return file.commit();
}

}  // namespace

std::optional<std::string> write_file(const std::string& path, std::string_view bytes) {
  return write_to(AtomicFile::open(path), bytes);
}

std::optional<std::string> change_file(const std::string& path, std::string_view bytes) {
  return write_to(AtomicFile::open_for_change(path), bytes);
}

}  // namespace rubicon::files
