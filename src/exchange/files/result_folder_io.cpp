#include "src/exchange/files/result_folder_io.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "src/exchange/files/folder_steps_io.hpp"
#include "src/exchange/files/result_owner_io.hpp"

namespace rubicon::files {

namespace fs = std::filesystem;

namespace {

/// How often another name is tried where somebody takes the folder for one that was left over.
constexpr int kMostNames = 100;

/// A path without slashes at its end.
std::string trimmed(std::string path) {
  while (path.size() > 1 && path.ends_with('/')) path.pop_back();
  return path;
}

/// Makes the folders on the way to `path`; those that were not there, deepest first.
std::error_code make_parents(const fs::path& path, std::vector<std::string>& made) {
  std::error_code error;
  std::vector<fs::path> missing;
  for (fs::path at = path; !at.empty() && !fs::exists(at, error); at = at.parent_path()) {
    missing.push_back(at);
  }
  for (auto at = missing.rbegin(); at != missing.rend(); ++at) {
    if (fs::create_directory(*at, error)) made.insert(made.begin(), at->string());
    if (error) return error;
  }
  return {};
}

/// What ResultFolder::obstacle says, of a folder in which nothing was left over.
std::optional<std::string> obstacle_in(const std::string& path, const ResultTerms& terms,
                                       const std::string& shown) {
  std::error_code error;
  std::vector<std::string> there;
  // Looked for first: what another program puts there now, or takes away, is no obstacle.
  for (const std::string& name : terms.names) {
    if (fs::exists(fs::symlink_status(fs::path(path) / name, error))) there.push_back(name);
  }
  const std::set<std::string> old = own_names(path, terms.read);
  std::vector<std::string> others;
  for (const std::string& name : there) {
    const fs::path file = fs::path(path) / name;
    const fs::file_status status = fs::symlink_status(file, error);
    if (!fs::exists(status) || old.count(name) != 0) continue;
    const std::string typed = fmt::format("{}/{}", shown, name);
    if (fs::is_directory(status)) return fmt::format("cannot write '{}': it is a folder", typed);
    for (const std::string& input : terms.read) {
      if (fs::equivalent(input, file, error)) {
        return fmt::format("'{}' is read here: write to another folder", typed);
      }
    }
    others.push_back(typed);
  }
  if (others.empty()) return std::nullopt;
  const bool one = others.size() == 1;
  return fmt::format(
      "'{}' {} not from an earlier result, and the new one would replace {}: move {} away, or "
      "write "
      "to another folder",
      fmt::join(others, "', '"), one ? "is" : "are", one ? "it" : "them", one ? "it" : "them");
}

}  // namespace

std::string result_path(const std::string& folder, std::string_view name) {
  const std::string staged = fmt::format("{}/{}/{}", folder, kStagedName, name);
  std::error_code error;
  return fs::exists(staged, error) ? staged : fmt::format("{}/{}", folder, name);
}

std::string result_trace(const std::string& folder) {
  std::error_code error;
  std::string plain = result_path(folder, "trace.jsonl");
  if (fs::exists(plain, error)) return plain;
  std::string packed = result_path(folder, "trace.jsonl.gz");
  return fs::exists(packed, error) ? packed : plain;
}

std::optional<std::string> ResultFolder::obstacle(const std::string& path,
                                                  const ResultTerms& terms) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(fs::absolute(trimmed(path), error), error);
  if (error || !fs::is_directory(real, error)) return std::nullopt;
  clear_left_over(real.string());
  return obstacle_in(real.string(), terms, trimmed(path));
}

std::variant<ResultFolder, std::string> ResultFolder::open(const std::string& path,
                                                           ResultTerms terms) {
  const auto fail = [&](const std::string& why) {
    return fmt::format("cannot make the folder '{}': {}", path, why);
  };
  // Until the temporary folder is known to Temporaries.
  const SignalHold hold;
  ResultFolder result;
  result.shown_ = trimmed(path);
  result.terms_ = std::move(terms);
  std::error_code error;
  const fs::path wanted = fs::absolute(result.shown_, error);
  const bool is_there = fs::exists(wanted, error);
  if (!is_there && fs::is_symlink(wanted, error)) return fail("it is a link that leads nowhere");
  if (is_there && !fs::is_directory(wanted, error)) return fail(std::strerror(ENOTDIR));
  fs::path real = fs::weakly_canonical(wanted, error);
  if (error) return fail(error.message());
  if (!real.has_filename() && real.has_relative_path()) real = real.parent_path();
  result.target_ = real.string();
  if (!is_there) {
    if (const auto failure = make_parents(real.parent_path(), result.made_)) {
      return fail(failure.message());
    }
  }
  if (is_there) {
    if (::faccessat(AT_FDCWD, real.c_str(), W_OK | X_OK, AT_EACCESS) != 0) {
      return fmt::format("cannot write '{}': {}", path, std::strerror(errno));
    }
  }
  clear_left_over(result.target_);
  if (auto message = obstacle_in(result.target_, result.terms_, result.shown_)) return *message;
  result.beside_ = !is_there || may_be_exchanged(result.target_);
  const std::string pattern =
      result.beside_
          ? fmt::format("{}/.{}.rubicon-XXXXXX", folder_of(result.target_), name_of(result.target_))
          : fmt::format("{}/{}XXXXXX", result.target_, kInsideStem);
  if (const int failure = result.make_temporary(pattern)) return fail(std::strerror(failure));
  return result;
}

ResultFolder::ResultFolder(ResultFolder&& other) noexcept
    : terms_(std::move(other.terms_)),
      shown_(std::move(other.shown_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      made_(std::exchange(other.made_, {})),
      lock_(std::exchange(other.lock_, -1)),
      beside_(other.beside_),
      guard_(std::move(other.guard_)) {}

ResultFolder::~ResultFolder() {
  if (!temporary_.empty()) discard(temporary_, target_, {kResultNames.begin(), kResultNames.end()});
  guard_.release();
  for (const std::string& folder : made_) ::rmdir(folder.c_str());
  if (lock_ >= 0) ::close(lock_);
}

/// An error number, 0 for none.
int ResultFolder::make_temporary(const std::string& pattern) {
  for (int attempt = 0; attempt < kMostNames; ++attempt) {
    std::string name = pattern;
    if (::mkdtemp(name.data()) == nullptr) return errno;
    const int descriptor = ::open(name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0) continue;  // taken for one that was left over, and removed
    struct stat opened {};
    struct stat named {};
    const bool locked = ::flock(descriptor, LOCK_EX) == 0 || errno != EINTR;
    if (locked && ::fstat(descriptor, &opened) == 0 && ::stat(name.c_str(), &named) == 0 &&
        opened.st_ino == named.st_ino) {
      lock_ = descriptor;
      temporary_ = name;
      protect();
      return 0;
    }
    ::close(descriptor);
  }
  return EBUSY;
}

/// From now on a signal removes the temporary folder.
void ResultFolder::protect() {
  std::vector<std::string> files;
  for (const std::string_view name : kResultNames) {
    files.push_back(fmt::format("{}/{}", temporary_, name));
  }
  std::vector<std::string> folders = {temporary_};
  folders.insert(folders.end(), made_.begin(), made_.end());
  guard_ = Temporaries(std::move(files), std::move(folders));
}

std::variant<AtomicFile, std::string> ResultFolder::create(std::string_view name) const {
  return AtomicFile::create(fmt::format("{}/{}", temporary_, name),
                            fmt::format("{}/{}", shown_, name));
}

std::optional<std::string> ResultFolder::write(std::string_view name,
                                               std::string_view bytes) const {
  auto created = create(name);
  if (auto* message = std::get_if<std::string>(&created)) return *message;
  auto& file = std::get<AtomicFile>(created);
  file.write(bytes);
  return file.commit();
}

/// The old folder for the new one in one step; an error number where that cannot be.
int ResultFolder::exchange(const std::set<std::string>& old) {
  int error = take_over(target_, temporary_, old);
  if (error == 0) {
    sync_folder(temporary_);
    if (::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) !=
        0) {
      error = errno;
    }
  }
  if (error != 0) {
    drop_links(target_, temporary_);
    return error;
  }
  sync_folder(folder_of(target_));
  discard(temporary_, target_, old);
  return 0;
}

std::optional<std::string> ResultFolder::replace() {
  const auto failure = [&](int error) {
    return fmt::format("cannot write '{}': {}", shown_, std::strerror(error));
  };
  // mkdtemp makes it private; a result is an ordinary folder.
  const mode_t mask = ::umask(0);
  ::umask(mask);
  if (::fchmod(lock_, 0777 & ~mask) != 0) return failure(errno);
  sync_folder(temporary_);
  struct stat status {};
  if (beside_ && ::lstat(target_.c_str(), &status) != 0 && errno == ENOENT) {
    // Should another program make it at this moment, it is replaced only if nothing is in it.
    if (::rename(temporary_.c_str(), target_.c_str()) == 0) {
      sync_folder(folder_of(target_));
      return std::nullopt;
    }
    if (errno != EEXIST && errno != ENOTEMPTY) return failure(errno);
  }
  const FolderLock lock(target_);
  // Looked at again: while it was computed another result, or a file of somebody, came there.
  terms_.names = written();
  if (auto message = obstacle_in(target_, terms_, shown_)) return message;
  const std::set<std::string> old = own_names(target_, terms_.read);
  keep_modes(old);
  if (beside_ && may_be_exchanged(target_) && exchange(old) == 0) return std::nullopt;
  if (const int error = move_in(temporary_, target_, old)) return failure(error);
  return std::nullopt;
}

/// A file that takes the place of an old one has its mode.
void ResultFolder::keep_modes(const std::set<std::string>& old) const {
  for (const std::string& name : terms_.names) {
    struct stat status {};
    if (old.count(name) == 0 || ::stat(fmt::format("{}/{}", target_, name).c_str(), &status) != 0) {
      continue;
    }
    ::chmod(fmt::format("{}/{}", temporary_, name).c_str(), status.st_mode & 0777);
  }
}

/// The files that this result has.
std::vector<std::string> ResultFolder::written() const {
  std::vector<std::string> names;
  std::error_code error;
  for (const std::string_view name : kResultNames) {
    if (fs::exists(fs::path(temporary_) / name, error)) names.emplace_back(name);
  }
  return names;
}

std::optional<std::string> ResultFolder::commit() {
  const SignalHold hold;
  if (auto message = replace()) return message;
  guard_.release();
  temporary_.clear();
  made_.clear();
  ::close(std::exchange(lock_, -1));
  return std::nullopt;
}

}  // namespace rubicon::files
