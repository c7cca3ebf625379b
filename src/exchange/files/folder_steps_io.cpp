#include "src/exchange/files/folder_steps_io.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "src/exchange/files/result_folder_io.hpp"

namespace rubicon::files {

namespace {

/// More files of others than this are not linked one by one.
constexpr std::size_t kMostLinks = 1000;
/// How often, and how long apart, another program is waited for that puts its result in place: for
/// 20 s, which it does in milliseconds.
constexpr int kPatience = 2000;
constexpr std::chrono::milliseconds kPause{10};
constexpr std::size_t kRandomLetters = 6;

bool is_same(const struct stat& one, const struct stat& other) {
  return one.st_dev == other.st_dev && one.st_ino == other.st_ino;
}

/// An open folder, reached by no link.
class Folder {
 public:
  explicit Folder(const std::string& path)
      : descriptor_(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC)) {}
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  int descriptor() const { return descriptor_; }
  bool is_open() const { return descriptor_ >= 0; }
  /// Whether nobody has it, and it still has its name: then it is ours for as long as this stands.
  bool take(const std::string& path) const {
    struct stat own {};
    struct stat named {};
    return is_open() && lock_folder(descriptor_) && ::fstat(descriptor_, &own) == 0 &&
           ::lstat(path.c_str(), &named) == 0 && is_same(own, named);
  }

  std::vector<std::string> names() const {
    std::vector<std::string> result;
    const int copy = ::openat(descriptor_, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR* stream = copy < 0 ? nullptr : ::fdopendir(copy);
    if (stream == nullptr) {
      if (copy >= 0) ::close(copy);
      return result;
    }
    while (const dirent* entry = ::readdir(stream)) {
      const std::string_view name = entry->d_name;
      if (name != "." && name != "..") result.emplace_back(name);
    }
    ::closedir(stream);
    return result;
  }

  /// Its own state where there is no name; false if there is none.
  bool look(const std::string& name, struct stat& status) const {
    return (name.empty() ? ::fstat(descriptor_, &status)
                         : ::fstatat(descriptor_, name.c_str(), &status, AT_SYMLINK_NOFOLLOW)) == 0;
  }

 private:
  int descriptor_;
};

/// Extended attributes other than the label that every file of some systems has: access lists,
/// notes.
bool has_attributes(int descriptor) {
  std::vector<char> names(4096);
  const ssize_t size = ::flistxattr(descriptor, names.data(), names.size());
  if (size < 0) return errno != ENOTSUP;
  const std::string_view all(names.data(), static_cast<std::size_t>(size));
  for (std::size_t at = 0; at < all.size(); at = all.find('\0', at) + 1) {
    if (all.substr(at, all.find('\0', at) - at) != "security.selinux") return true;
  }
  return false;
}

bool is_mount(const std::string& folder) {
  struct statx status {};
  return ::statx(AT_FDCWD, folder.c_str(), AT_SYMLINK_NOFOLLOW, STATX_BASIC_STATS, &status) == 0 &&
         (status.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0;
}

/// Whether we, and so the shell that started us, are in this folder: it would be in a removed one.
bool is_where_we_are(const struct stat& folder) {
  std::error_code error;
  for (std::filesystem::path at = std::filesystem::current_path(error); !error;
       at = at.parent_path()) {
    struct stat here {};
    if (::stat(at.c_str(), &here) == 0 && is_same(here, folder)) return true;
    if (at == at.parent_path()) break;
  }
  return false;
}

bool holds_plain_files_only(const Folder& folder) {
  std::size_t links = 0;
  for (const std::string& name : folder.names()) {
    struct stat status {};
    if (!folder.look(name, status)) continue;
    if (!S_ISREG(status.st_mode) && !S_ISLNK(status.st_mode)) return false;
    if (++links > kMostLinks) return false;
  }
  return true;
}

bool is_temporary_name(std::string_view name, std::string_view stem) {
  return name.starts_with(stem) && name.size() == stem.size() + kRandomLetters;
}

/// Completes a result whose program was ended while it moved in. It must be locked.
int complete(const Folder& staged, const std::string& path, const std::string& folder) {
  for (const std::string_view name : kResultNames) {
    struct stat status {};
    const std::string there = folder + "/" + std::string(name);
    if (staged.look(std::string(name), status)) {
      if (::rename((path + "/" + std::string(name)).c_str(), there.c_str()) != 0) return errno;
    }
  }
  if (::rmdir(path.c_str()) != 0) return errno;
  sync_folder(folder);
  return 0;
}

void clear_one(const std::string& path, const std::string& home) {
  const Folder left(path);
  struct stat status {};
  if (!left.is_open() || !left.look("", status) || status.st_uid != ::geteuid()) return;
  // In a folder of ours the names tell: what is not ours and has such a name is a second link.
  if (left.take(path)) discard(path, home, {kResultNames.begin(), kResultNames.end()});
}

}  // namespace

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

std::string name_of(const std::string& path) { return path.substr(path.rfind('/') + 1); }

void sync_folder(const std::string& path) {
  const int folder = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  ::fsync(folder);
  ::close(folder);
}

bool lock_folder(int descriptor) { return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0; }

FolderLock::FolderLock(const std::string& path) {
  for (int attempt = 0; attempt < kPatience; ++attempt) {
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    struct stat own {};
    struct stat named {};
    if (descriptor_ < 0) return;
    const bool locked = lock_folder(descriptor_);
    if (!locked && errno != EWOULDBLOCK) return;
    if (locked && ::fstat(descriptor_, &own) == 0 && ::stat(path.c_str(), &named) == 0 &&
        is_same(own, named)) {
      return;
    }
    ::close(std::exchange(descriptor_, -1));
    std::this_thread::sleep_for(kPause);
  }
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

bool may_be_exchanged(const std::string& path) {
  const Folder folder(path);
  struct stat status {};
  struct stat parent {};
  if (!folder.is_open() || !folder.look("", status)) return false;
  if (::stat(folder_of(path).c_str(), &parent) != 0 || parent.st_dev != status.st_dev) return false;
  if (::faccessat(AT_FDCWD, folder_of(path).c_str(), W_OK | X_OK, AT_EACCESS) != 0) return false;
  if (status.st_uid != ::geteuid() || is_mount(path)) return false;
  return !is_where_we_are(status) && !has_attributes(folder.descriptor()) &&
         holds_plain_files_only(folder);
}

int take_over(const std::string& from, const std::string& to,
              const std::set<std::string>& old_names) {
  const Folder old(from);
  const Folder fresh(to);
  struct stat status {};
  struct stat own {};
  if (!old.is_open() || !fresh.is_open() || !old.look("", status) || !fresh.look("", own)) {
    return errno;
  }
  if (own.st_gid != status.st_gid &&
      ::fchown(fresh.descriptor(), static_cast<uid_t>(-1), status.st_gid) != 0) {
    return errno;
  }
  if (::fchmod(fresh.descriptor(), status.st_mode & 07777) != 0) return errno;
  for (const std::string& name : old.names()) {
    if (old_names.count(name) != 0) continue;
    if (::linkat(old.descriptor(), name.c_str(), fresh.descriptor(), name.c_str(), 0) != 0) {
      return errno;
    }
  }
  return 0;
}

void drop_links(const std::string& from, const std::string& to) {
  const Folder home(from);
  const Folder folder(to);
  if (!home.is_open() || !folder.is_open()) return;
  for (const std::string& name : folder.names()) {
    struct stat first {};
    struct stat second {};
    if (home.look(name, first) && folder.look(name, second) && is_same(first, second)) {
      ::unlinkat(folder.descriptor(), name.c_str(), 0);
    }
  }
}

void discard(const std::string& path, const std::string& home,
             const std::set<std::string>& result) {
  const Folder folder(path);
  const Folder keeper(home);
  if (!folder.is_open()) return;
  for (const std::string& name : folder.names()) {
    struct stat status {};
    struct stat kept {};
    if (!folder.look(name, status)) continue;
    if (result.count(name) != 0 ||
        (keeper.is_open() && keeper.look(name, kept) && is_same(status, kept))) {
      ::unlinkat(folder.descriptor(), name.c_str(), 0);
    } else if (keeper.is_open()) {
      ::renameat2(folder.descriptor(), name.c_str(), keeper.descriptor(), name.c_str(),
                  RENAME_NOREPLACE);
    }
  }
  ::rmdir(path.c_str());
}

int move_in(const std::string& from, const std::string& folder, const std::set<std::string>& old) {
  const std::string staged = folder + "/" + std::string(kStagedName);
  for (int attempt = 0; ::rename(from.c_str(), staged.c_str()) != 0; ++attempt) {
    if ((errno != EEXIST && errno != ENOTEMPTY) || attempt == kPatience) return errno;
    // Another program moves in, or was ended while it did.
    const Folder other(staged);
    if (other.take(staged)) {
      if (const int error = complete(other, staged, folder)) return error;
    } else {
      std::this_thread::sleep_for(kPause);
    }
  }
  const Folder fresh(staged);
  // The last first, as own_names knows the others by those that come before them.
  for (auto name = kResultNames.rbegin(); name != kResultNames.rend(); ++name) {
    const std::string each(*name);
    struct stat status {};
    if (old.count(each) != 0 && !fresh.look(each, status)) ::unlink((folder + "/" + each).c_str());
  }
  return complete(fresh, staged, folder);
}

void clear_left_over(const std::string& path) {
  const std::string parent = folder_of(path);
  const std::string beside = "." + name_of(path) + ".rubicon-";
  const Folder around(parent);
  if (around.is_open()) {
    for (const std::string& name : around.names()) {
      if (is_temporary_name(name, beside)) clear_one(parent + "/" + name, path);
    }
  }
  const Folder folder(path);
  if (!folder.is_open()) return;
  for (const std::string& name : folder.names()) {
    const std::string inside = path + "/" + name;
    if (name == kStagedName) {
      const Folder staged(inside);
      if (staged.take(inside)) complete(staged, inside, path);
    } else if (is_temporary_name(name, kInsideStem)) {
      clear_one(inside, path);
    }
  }
}

}  // namespace rubicon::files
