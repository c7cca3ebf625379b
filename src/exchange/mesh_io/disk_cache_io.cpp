#include "src/exchange/mesh_io/disk_cache_io.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include "src/exchange/mesh_io/guarded_file_io.hpp"

namespace rubicon::mesh_io {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kCacheMagic = "rubicon mesh cache 1\n";
constexpr std::string_view kSuffix = ".mesh";
constexpr std::string_view kTemporary = ".tmp-";

/// A temporary file this old belongs to a program that was ended while it wrote.
constexpr std::chrono::hours kAbandoned{1};

/// What stands before the payload: magic, key, digest of the payload.
std::string head(const Digest& key, std::string_view payload) {
  encoding::Sha256 hash;
  hash.add(payload);
  const Digest check = hash.finish();
  std::string text(kCacheMagic);
  text.append(reinterpret_cast<const char*>(key.data()), key.size());
  text.append(reinterpret_cast<const char*>(check.data()), check.size());
  return text;
}
constexpr std::size_t kHeadSize = kCacheMagic.size() + 2 * sizeof(Digest);

/// Makes a folder and those above it, for the user alone.
bool make_folders(const std::string& folder) {
  for (std::size_t i = 1; i <= folder.size(); ++i) {
    if (i < folder.size() && folder[i] != '/') continue;
    if (::mkdir(folder.substr(0, i).c_str(), 0700) != 0 && errno != EEXIST && errno != EROFS &&
        errno != EACCES) {
      return false;
    }
  }
  struct stat status {};
  return ::stat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

}  // namespace

std::string default_cache_folder() {
  const char* const wish = std::getenv("RUBICON_CACHE");
  if (wish != nullptr && std::string_view(wish) == "off") return {};
  // Relative paths are to be ignored (XDG Base Directory Specification).
  const char* const cache = std::getenv("XDG_CACHE_HOME");
  if (cache != nullptr && cache[0] == '/') return std::string(cache) + "/rubicon/meshes";
  const char* const home = std::getenv("HOME");
  if (home != nullptr && home[0] == '/') return std::string(home) + "/.cache/rubicon/meshes";
  return {};
}

DiskCache::DiskCache(std::string folder, std::uint64_t most_bytes)
    : folder_(std::move(folder)), most_bytes_(most_bytes) {}

std::string DiskCache::path_of(const Digest& key) const {
  return folder_ + "/" + encoding::hex(key) + std::string(kSuffix);
}

std::optional<std::string> DiskCache::find(const Digest& key) {
  if (!is_on()) return std::nullopt;
  const FileDescriptor file(
      ::open(path_of(key).c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY | O_NOFOLLOW));
  struct stat status {};
  if (file.get() < 0 || ::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode) ||
      status.st_uid != ::geteuid()) {
    return std::nullopt;
  }
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size < kHeadSize || size > kHeadSize + kLargestEntry) return std::nullopt;
  std::string bytes(size, '\0');
  if (read_at(file.get(), 0, bytes.data(), bytes.size()) != bytes.size()) return std::nullopt;
  std::string found = bytes.substr(0, kHeadSize);
  bytes.erase(0, kHeadSize);
  if (found != head(key, bytes)) return std::nullopt;
  ::futimens(file.get(), nullptr);  // used now; where that is not permitted it only looks older
  return bytes;
}

void DiskCache::put(const Digest& key, std::string_view payload) {
  if (!is_on() || payload.size() > kLargestEntry || !make_folders(folder_)) return;
  if (!make_room(payload.size() + kHeadSize)) return;
  std::string temporary = folder_ + "/" + std::string(kTemporary) + "XXXXXX";
  FileDescriptor file(::mkostemp(temporary.data(), O_CLOEXEC));
  if (file.get() < 0) return;
  const bool written = write_all(file.get(), head(key, payload)) && write_all(file.get(), payload);
  file.close();
  if (!written || ::rename(temporary.c_str(), path_of(key).c_str()) != 0) {
    ::unlink(temporary.c_str());
  }
}

bool DiskCache::make_room(std::uint64_t bytes) {
  const std::scoped_lock lock(mutex_);
  if (bytes > most_bytes_) return false;
  if (!used_ || *used_ + bytes > most_bytes_) {
    used_ = trim(std::min(most_bytes_ - bytes, most_bytes_ / 8 * 7));
  }
  if (*used_ + bytes > most_bytes_) return false;  // others' files that we may not remove
  *used_ += bytes;
  return true;
}

/// Counts the folder, and removes abandoned files and, if it holds too much, the oldest entries.
/// The bytes that are left.
std::uint64_t DiskCache::trim(std::uint64_t down_to) {
  struct Entry {
    fs::file_time_type used;
    fs::path path;
    std::uint64_t bytes;
  };
  std::vector<Entry> entries;
  std::uint64_t total = 0;
  std::error_code error;
  const auto now = fs::file_time_type::clock::now();
  for (fs::directory_iterator each(folder_, error), end; !error && each != end;
       each.increment(error)) {
    std::error_code gone;
    if (!each->is_regular_file(gone) || each->is_symlink(gone)) continue;
    Entry entry{each->last_write_time(gone), each->path(), each->file_size(gone)};
    if (gone) continue;
    const std::string name = entry.path.filename().string();
    if (name.starts_with(kTemporary) && now - entry.used > kAbandoned) {
      fs::remove(entry.path, gone);
      continue;
    }
    total += entry.bytes;
    if (name.ends_with(kSuffix)) entries.push_back(std::move(entry));
  }
  if (total <= down_to) return total;
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.used, a.path) < std::tie(b.used, b.path);
  });
  for (const Entry& entry : entries) {
    if (total <= down_to) break;
    std::error_code refused;
    if (fs::remove(entry.path, refused)) total -= entry.bytes;
  }
  return total;
}

}  // namespace rubicon::mesh_io
