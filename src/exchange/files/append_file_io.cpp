#include "src/exchange/files/append_file_io.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "src/exchange/files/disk_io.hpp"

namespace rubicon::files {

namespace {

std::string failure_of(const std::string& path, int error) {
  return fmt::format("'{}': {}", path, std::strerror(error));
}

/// All bytes of an open file; false if it cannot be read.
bool read_all(int file, std::string& text) {
  std::array<char, 65536> buffer{};
  while (true) {
    const ssize_t count = ::read(file, buffer.data(), buffer.size());
    if (count == 0) return true;
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

std::variant<AppendFile, std::string> AppendFile::open(const std::string& path, bool keep) {
  const std::size_t slash = path.rfind('/');
  if (slash != std::string::npos && slash > 0) {
    if (const auto failure = make_folder(path.substr(0, slash))) return *failure;
  }
  AppendFile result;
  result.path_ = path;
  result.file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (result.file_ < 0) return failure_of(path, errno);
  if (::flock(result.file_, LOCK_EX | LOCK_NB) != 0) {
    return fmt::format("'{}': another program writes it; wait for it, or use another folder", path);
  }
  if (!keep) {
    if (::ftruncate(result.file_, 0) != 0) return failure_of(path, errno);
    return result;
  }
  std::string text;
  if (!read_all(result.file_, text)) return failure_of(path, errno);
  std::size_t begin = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    result.lines_.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  // What was cut off goes, so that the next line stands on a line of its own.
  if (begin != text.size() && ::ftruncate(result.file_, static_cast<off_t>(begin)) != 0) {
    return failure_of(path, errno);
  }
  return result;
}

AppendFile::AppendFile(AppendFile&& other) noexcept
    : path_(std::move(other.path_)),
      file_(std::exchange(other.file_, -1)),
      lines_(std::move(other.lines_)) {}

AppendFile::~AppendFile() {
  if (file_ >= 0) ::close(file_);
}

std::optional<std::string> AppendFile::append(std::string_view line) {
  std::string text(line);
  text += '\n';
  std::string_view rest = text;
  while (!rest.empty()) {
    const ssize_t count = ::write(file_, rest.data(), rest.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return failure_of(path_, errno);
    rest.remove_prefix(static_cast<std::size_t>(count));
  }
  return std::nullopt;
}

void AppendFile::remove() { ::unlink(path_.c_str()); }

}  // namespace rubicon::files
