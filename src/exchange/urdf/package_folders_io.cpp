#include "src/exchange/urdf/package_folders_io.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <system_error>
#include <utility>

#include "src/exchange/urdf/limits.hpp"

namespace rubicon::urdf {

namespace {

namespace fs = std::filesystem;

std::string resolved(const fs::path& path) {
  std::error_code error;
  const fs::path result = fs::canonical(path, error);
  return error ? std::string() : result.string();
}

bool lies_in(const std::string& path, const std::string& folder) {
  if (folder.empty()) return false;
  return path.starts_with(folder.ends_with('/') ? folder : folder + "/");
}

bool is_file(const std::string& path) {
  std::error_code error;
  return !path.empty() && fs::is_regular_file(path, error) && !error;
}

}  // namespace

PackageFolders::PackageFolders(const std::string& machine,
                               const std::map<std::string, std::string>& packages) {
  const std::string path = resolved(machine);
  folder_ = path.empty() ? std::string() : fs::path(path).parent_path().string();
  for (const auto& [name, folder] : packages) {
    const std::string place = resolved(folder);
    std::error_code error;
    if (place.empty() || !fs::is_directory(place, error)) {
      missing_ = folder;
    } else {
      packages_[name] = {place, false};
    }
  }
}

std::string PackageFolders::folder_above(const std::string& name, const std::string& rest) const {
  fs::path folder = folder_;
  for (; folder.has_relative_path(); folder = folder.parent_path()) {
    for (const fs::path& place : {folder, folder / name}) {
      if (is_file(resolved(place / rest))) return resolved(place);
    }
  }
  return {};
}

std::variant<FoundFile, PackageFailure> PackageFolders::find_in_package(
    const std::string& reference, const std::string& name, const std::string& rest) {
  auto package = packages_.find(name);
  std::string note;
  if (package == packages_.end()) {
    const std::string folder = folder_above(name, rest);
    if (folder.empty()) {
      return PackageFailure{
          fmt::format("'{}': expected '{}' in '{}' or a folder above it, found none", reference,
                      rest, folder_),
          fmt::format("say where the package is: --package {}=FOLDER", name)};
    }
    note = fmt::format("package '{}' is taken to be the folder '{}'", name, folder);
    package = packages_.emplace(name, Folder{folder, true}).first;
  }
  const Folder& folder = package->second;
  const std::string path = resolved(fs::path(folder.path) / rest);
  if (!is_file(path)) {
    return PackageFailure{fmt::format("'{}': expected the file '{}' in the folder '{}', found none",
                                      reference, rest, folder.path),
                          folder.guessed
                              ? fmt::format("say where the package is: --package {}=FOLDER", name)
                              : std::string()};
  }
  if (!lies_in(path, folder.path)) {
    return PackageFailure{
        fmt::format("'{}' lies outside of its package '{}'", reference, folder.path),
        "files must lie in the folder of the machine or of a package"};
  }
  return FoundFile{path, folder.path, std::move(note)};
}

std::variant<FoundFile, PackageFailure> PackageFolders::find(const std::string& reference,
                                                             const std::string& from) {
  // $(find NAME) of xacro stands for package://NAME.
  if (reference.starts_with("file://package://")) return find(reference.substr(7), from);
  std::string written = reference;
  for (const char* scheme : {"package://", "model://"}) {
    if (!reference.starts_with(scheme)) continue;
    written.erase(0, std::string(scheme).size());
    const std::size_t slash = written.find('/');
    if (slash == std::string::npos || slash == 0 || slash + 1 == written.size() ||
        written.starts_with(".")) {
      return PackageFailure{fmt::format("expected {}NAME/FILE, found '{}'", scheme, reference), ""};
    }
    return find_in_package(reference, written.substr(0, slash), written.substr(slash + 1));
  }
  if (written.starts_with("file://")) written.erase(0, 7);
  if (written.empty() || written.find("://") != std::string::npos) {
    return PackageFailure{
        fmt::format("expected package://NAME/FILE or a path, found '{}'", reference),
        "nothing is read over the network: copy the file beside the machine"};
  }
  const std::string path = resolved(fs::path(from).parent_path() / written);
  std::optional<std::string> folder;
  if (lies_in(path, folder_)) folder = folder_;
  for (const auto& [name, package] : packages_) {
    if (!folder && lies_in(path, package.path)) folder = package.path;
  }
  if (!folder && !path.empty()) {
    return PackageFailure{fmt::format("'{}' lies outside of '{}'", reference, folder_),
                          "give the folder that holds both: --package NAME=FOLDER"};
  }
  if (!folder || !is_file(path)) {
    return PackageFailure{fmt::format("there is no file '{}' in '{}'", reference, folder_), ""};
  }
  return FoundFile{path, *folder, ""};
}

std::variant<std::string, PackageFailure> PackageFolders::read_text(const std::string& path) {
  std::error_code error;
  if (!is_file(path)) return PackageFailure{fmt::format("there is no file '{}'", path), ""};
  const auto size = fs::file_size(path, error);
  if (error || size > kMaxFileBytes) {
    return PackageFailure{
        fmt::format("'{}' {}", path,
                    error ? "cannot be read: " + error.message()
                          : fmt::format("is larger than {} MB", kMaxFileBytes >> 20)),
        ""};
  }
  std::string text(size, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(text.data(), static_cast<std::streamsize>(size));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return text;
}

}  // namespace rubicon::urdf
