#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "interpreter/check/resolve_shape.hpp"

namespace rubicon::interpreter {

namespace {

/// Text with ASCII letters in lower case.
std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

bool has_no_unit_of_its_own(const std::string& file) {
  const std::string name = lower_case(file);
  const auto ends_with = [&](std::string_view end) { return name.ends_with(end); };
  return ends_with(".stl") || ends_with(".obj") || ends_with(".ply");
}

struct LengthUnit {
  std::string_view name;
  double metres;
};
constexpr std::array<LengthUnit, 3> kLengthUnits = {{{"mm", 0.001}, {"cm", 0.01}, {"m", 1}}};

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

}  // namespace

std::optional<geometry::Solid> ShapeResolver::resolve_mesh(const syntax::Shape& shape) {
  const std::optional<MeshRequest> request = mesh_request(shape);
  if (!request) return std::nullopt;
  const MeshResult& result = read(*request);
  if (const auto* failure = std::get_if<FileFailure>(&result)) {
    diagnostics_.error("F02", shape.file.span, failure->message);
    return std::nullopt;
  }
  const auto& mesh = std::get<std::shared_ptr<const geometry::TriangleMesh>>(result);
  // Where something is wrong its options may be meant otherwise. What comes into the body of a
  // robot crosses its surface.
  const bool of_robot = naming_file_.ends_with(".robot");
  if (!mesh->closed && !of_robot && !diagnostics_.has_errors() &&
      open_meshes_.insert(request->path).second) {
    diagnostics_.warning(
        "F15", shape.file.span,
        fmt::format(
            "the surface of mesh '{}'{} is not closed: only the surface itself is in the way, "
            "not what it encloses",
            shape.file.text,
            request->part.empty() ? "" : fmt::format(", part '{}',", request->part)),
        "close it, or add hull for the solid around it");
  }
  return geometry::Mesh{shape.file.text, mesh};
}

std::optional<MeshRequest> ShapeResolver::mesh_request(const syntax::Shape& shape) {
  const std::string& written = shape.file.text;
  MeshRequest request;
  bool fine = check_options(shape, request);
  if (written.empty()) {
    diagnostics_.error("F03", shape.file.span, "expected the name of a mesh file");
    return std::nullopt;
  }
  const std::string inside = resolve_path("", written);
  if (written.front() == '/' || inside == ".." || inside.starts_with("../")) {
    diagnostics_.error(
        "F03", shape.file.span,
        fmt::format("mesh '{}' lies outside the folder of this file", written),
        "the meshes of a file stay inside its folder: put it there and name it relative to it");
    return std::nullopt;
  }
  if (!shape.unit && has_no_unit_of_its_own(written)) {
    diagnostics_.error(
        "F04", shape.file.span,
        fmt::format("mesh '{}' needs a unit: STL, OBJ and PLY files do not say theirs", written),
        fmt::format("write mesh(\"{}\", mm) or m or cm", written));
    fine = false;
  }
  if (!fine) return std::nullopt;
  request.hull = shape.hull.has_value();
  request.path = resolve_path(naming_file_, written);
  request.folder = folder_of(naming_file_);
  return request;
}

bool ShapeResolver::check_options(const syntax::Shape& shape, MeshRequest& request) {
  bool fine = true;
  if (shape.unit) {
    const auto unit = std::find_if(kLengthUnits.begin(), kLengthUnits.end(),
                                   [&](const auto& each) { return each.name == shape.unit->text; });
    if (unit != kLengthUnits.end()) {
      request.metres_per_unit = unit->metres;
    } else {
      fine = false;
      diagnostics_.error(
          "F04", shape.unit->span,
          fmt::format("expected a unit of length (mm, cm or m), found '{}'", shape.unit->text));
    }
  }
  if (shape.scale) {
    request.scale = shape.scale->value;
    if (shape.scale->unit != syntax::UnitKind::none) {
      fine = false;
      diagnostics_.error("F04", shape.scale->span, "scale is a plain number, without a unit");
    } else if (!(request.scale >= kMinScale && request.scale <= kMaxScale)) {
      fine = false;
      diagnostics_.error("F04", shape.scale->span,
                         fmt::format("scale must be between {} and {}, found {}", kMinScale,
                                     kMaxScale, request.scale));
    }
  }
  if (shape.up) {
    if (shape.up->text == "y" || shape.up->text == "z") {
      request.up = shape.up->text[0];
    } else {
      fine = false;
      diagnostics_.error("F04", shape.up->span,
                         fmt::format("expected up y or up z, found '{}'", shape.up->text));
    }
  }
  if (shape.part) {
    request.part = shape.part->text;
    if (request.part.empty()) {
      fine = false;
      diagnostics_.error("F04", shape.part->span, "expected the name of a part, found nothing");
    }
  }
  return fine;
}

const ShapeResolver::MeshResult& ShapeResolver::read(const MeshRequest& request) {
  const std::string key =
      fmt::format("{}\n{}\n{}\n{}\n{}\n{}", request.path, request.metres_per_unit, request.scale,
                  int{request.up}, request.hull, request.part);
  const auto found = meshes_.find(key);
  if (found != meshes_.end()) return found->second;
  return meshes_.emplace(key, files_.read_mesh(request)).first->second;
}

}  // namespace rubicon::interpreter
