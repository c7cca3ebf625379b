#include "src/exchange/files/disk_io.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <vector>

#include "interpreter/parse/parse.hpp"
#include "interpreter/syntax/diagnostic.hpp"

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

/// Of a folder with more files than this no name is suggested.
constexpr int kMostSuggested = 1000;

/// The file beside it whose name is nearest, those of the same kind first; "" if none is near.
std::string nearest_file(const std::filesystem::path& path) {
  std::vector<std::string> same, others;
  std::error_code error;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  int count = 0;
  for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error)) {
    if (++count > kMostSuggested) return {};
    const std::filesystem::path& each = at->path();
    (each.extension() == path.extension() ? same : others).push_back(each.filename().string());
  }
  for (std::vector<std::string>* names : {&same, &others}) {
    std::sort(names->begin(), names->end());  // folders have no order
    std::string near = interpreter::did_you_mean(path.filename().string(), *names);
    if (!near.empty()) return near;
  }
  return {};
}

/// The first folder on the way to the file that is not there, and the one beside it whose name is
/// nearest; nothing where all of them are there.
std::optional<std::string> no_such_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::path there;
  for (const std::filesystem::path& part : path.parent_path()) {
    const std::filesystem::path next = there / part;
    if (std::filesystem::exists(next, error) || error) {
      there = next;
      continue;
    }
    std::vector<std::string> folders;
    const std::filesystem::path around = there.empty() ? "." : there;
    int count = 0;
    for (std::filesystem::directory_iterator at(around, error), end; !error && at != end;
         at.increment(error)) {
      if (++count > kMostSuggested) break;
      if (at->is_directory(error)) folders.push_back(at->path().filename().string());
    }
    std::sort(folders.begin(), folders.end());
    const std::string near = interpreter::did_you_mean(part.string(), folders);
    return fmt::format("there is no folder \"{}\"{}", part.string(),
                       near.empty() ? std::string() : fmt::format("; did you mean \"{}\"?", near));
  }
  return std::nullopt;
}

std::string no_such_file(const std::string& path) {
  if (auto folder = no_such_folder(path)) return *std::move(folder);
  const std::string near = nearest_file(path);
  return near.empty() ? "there is no such file"
                      : fmt::format("there is no such file; did you mean \"{}\"?", near);
}

}  // namespace

std::variant<std::string, interpreter::FileFailure> DiskFiles::read_text(const std::string& path) {
  read_.insert(path);
  // O_NONBLOCK: opening a pipe that nobody writes to must not hang.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) {
    const int error = errno;
    return interpreter::FileFailure{error == ENOENT ? no_such_file(path)
                                                    : "cannot be opened: " + reason(error)};
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
  read_.insert(request.path);
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
