#include "src/exchange/urdf/mesh_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "src/exchange/urdf/fault.hpp"
#include "src/exchange/urdf/number_text.hpp"

namespace rubicon::urdf {

namespace {

std::string lower(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

bool may_stay(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-';
}

/// The last part of a path without ending, of characters that every file system takes.
std::string plain_stem(const std::string& path) {
  std::string name = path.substr(path.rfind('/') + 1);
  name.erase(std::min(name.rfind('.'), name.size()));
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !may_stay(c); }, '_');
  return name.empty() ? "mesh" : name.substr(0, 100);
}

}  // namespace

bool MeshShapes::says_z_up(const FoundFile& file, const std::string& extension) {
  if (extension == "glb") return false;
  const auto known = z_up_.find(file.path);
  if (known != z_up_.end()) return known->second;
  const auto text = files_.read_text(file.path);
  const auto* content = std::get_if<std::string>(&text);
  // What is broken or too large is refused when it is read as a mesh.
  const bool result = content == nullptr || content->find("<up_axis>Z_UP") != std::string::npos;
  return z_up_.emplace(file.path, result).first->second;
}

const MeshCopy& MeshShapes::copy_of(const FoundFile& file, const std::string& extension,
                                    const std::optional<Triple>& scale, interpreter::Span span) {
  const auto [place, is_new] = known_.emplace(std::make_pair(file.path, scale), copies_.size());
  if (!is_new) return copies_[place->second];
  const std::string stem = plain_stem(file.path) + (scale ? "_scaled" : "");
  const std::string ending = scale ? "obj" : extension;
  std::string target = fmt::format("{}/{}.{}", folder_, stem, ending);
  for (int i = 2; !targets_.insert(lower(target)).second; ++i) {
    target = fmt::format("{}/{}_{}.{}", folder_, stem, i, ending);
  }
  copies_.push_back({file.path, file.folder, target, scale, span});
  return copies_.back();
}

std::string MeshShapes::shape(const Geometry& geometry) {
  auto found = files_.find(geometry.mesh, machine_);
  if (const auto* failure = std::get_if<PackageFailure>(&found)) {
    fail("I23", geometry.span, "this mesh cannot be had: " + failure->message, failure->hint);
  }
  const FoundFile& file = std::get<FoundFile>(found);
  if (!file.note.empty()) findings_.note("I29", file.note, geometry.span, file.note);
  const std::size_t dot = file.path.rfind('.');
  const std::string extension = dot == std::string::npos ? "" : lower(file.path.substr(dot + 1));
  const bool bare = extension == "stl" || extension == "obj" || extension == "ply";
  if (!bare && extension != "dae" && extension != "glb") {
    findings_.warn("I25", "mesh " + file.path, geometry.span,
                   fmt::format("expected an STL, DAE, OBJ, PLY or GLB file, found '{}': the link "
                               "goes without it",
                               geometry.mesh),
                   "convert it, and name the new file");
    return {};
  }
  const Triple& scale = geometry.scale;
  const bool even = scale[0] == scale[1] && scale[0] == scale[2] && scale[0] > 0;
  if (!even) {
    return fmt::format("mesh(\"{}\", m)", copy_of(file, extension, scale, geometry.span).target);
  }
  std::string text =
      fmt::format("mesh(\"{}\"", copy_of(file, extension, std::nullopt, geometry.span).target);
  if (bare) text += ", m";
  if (scale[0] != 1) text += ", scale " + text_of(scale[0]);
  // Robot programs take the numbers of a file as they are, whatever it says of its upward axis.
  if (!bare && !says_z_up(file, extension)) text += ", up z";
  return text + ")";
}

}  // namespace rubicon::urdf
