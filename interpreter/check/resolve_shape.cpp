#include "interpreter/check/resolve_shape.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "interpreter/check/check_number.hpp"
#include "interpreter/check/resolve_frame.hpp"
#include "interpreter/check/simple_polygon.hpp"
#include "interpreter/check/solid_box.hpp"

namespace rubicon::interpreter {

using geometry::Solid;
using math::Vec3;

namespace {

/// m: a larger thing on a site is more likely drawn in millimetres.
constexpr double kLargestBelieved = 1000;

}  // namespace

ShapeResolver::ShapeResolver(std::string naming_file, FileProvider& files, FormulaNames& names,
                             Diagnostics& diagnostics)
    : naming_file_(std::move(naming_file)),
      files_(files),
      names_(names),
      diagnostics_(diagnostics) {}

std::optional<geometry::Shape> ShapeResolver::resolve(const syntax::Shape& shape) {
  std::optional<Solid> solid = resolve_solid(shape);
  geometry::Shape result;
  if (shape.at) {
    const std::optional<math::Pose> X_BS = resolve_constant_frame(*shape.at, names_, diagnostics_);
    if (!X_BS) return std::nullopt;
    result.X_BS = *X_BS;
  }
  if (!solid) return std::nullopt;
  const Eigen::AlignedBox3d box = box_around(*solid);
  const double size = box.isEmpty() ? 0 : box.sizes().maxCoeff();
  if (size > kLargestBelieved) {
    diagnostics_.warning(
        "F14", shape.span,
        fmt::format("this {} measures {:g} m: are millimetres meant?", shape.kind.text, size),
        shape.kind.text == "mesh" ? "give the mesh its unit: mesh(\"file\", mm)"
                                  : "lengths are metres; millimetres have a unit: 250 mm");
  }
  result.solid = *std::move(solid);
  return result;
}

std::optional<Solid> ShapeResolver::resolve_solid(const syntax::Shape& shape) {
  const std::string& kind = shape.kind.text;
  if (kind == "mesh") return resolve_mesh(shape);
  if (kind == "box") return resolve_box(shape);
  if (kind == "cylinder") return resolve_cylinder(shape);
  if (kind == "sphere") return resolve_sphere(shape);
  if (kind == "capsule") return resolve_capsule(shape);
  if (kind == "prism") return resolve_prism(shape);
  if (kind == "rope") {
    diagnostics_.error("F05", shape.kind.span,
                       "a rope goes from one body to another and is no shape of a body",
                       "write it after the bodies: rope(20 mm) from trolley to hook at (0, 0, 1);");
    return std::nullopt;
  }
  const std::string nearest =
      did_you_mean(kind, {"box", "cylinder", "sphere", "capsule", "prism", "mesh"});
  diagnostics_.error(
      "F05", shape.kind.span,
      fmt::format("unknown shape '{}'{}", kind,
                  nearest.empty() ? "; expected box, cylinder, sphere, capsule, prism or mesh"
                                  : "; did you mean " + nearest + "?"));
  return std::nullopt;
}

std::optional<Solid> ShapeResolver::resolve_box(const syntax::Shape& shape) {
  if (!check_count(shape, 6, "two corners: x0, y0, z0, x1, y1, z1")) return std::nullopt;
  const auto& n = shape.numbers;
  bool fine = check_lengths(shape);
  static constexpr const char* kExtents[] = {"the box has no extent along x",
                                             "the box has no extent along y",
                                             "the box has no extent along z"};
  for (std::size_t i = 0; i < 3; ++i) fine = check_ascending(n[i], n[i + 3], kExtents[i]) && fine;
  if (!fine) return std::nullopt;
  return geometry::Box{Vec3(n[0].value, n[1].value, n[2].value),
                       Vec3(n[3].value, n[4].value, n[5].value)};
}

std::optional<Solid> ShapeResolver::resolve_cylinder(const syntax::Shape& shape) {
  if (!check_count(shape, 3, "radius, z0, z1")) return std::nullopt;
  const auto& n = shape.numbers;
  bool fine = check_lengths(shape);
  fine = check_positive(n[0], "the radius of the cylinder") && fine;
  fine = check_ascending(n[1], n[2], "the cylinder has no height") && fine;
  if (!fine) return std::nullopt;
  return geometry::Cylinder{n[0].value, n[1].value, n[2].value};
}

std::optional<Solid> ShapeResolver::resolve_sphere(const syntax::Shape& shape) {
  if (!check_count(shape, 4, "centre and radius: x, y, z, r")) return std::nullopt;
  const auto& n = shape.numbers;
  bool fine = check_lengths(shape);
  fine = check_positive(n[3], "the radius of the sphere") && fine;
  if (!fine) return std::nullopt;
  return geometry::Sphere{Vec3(n[0].value, n[1].value, n[2].value), n[3].value};
}

std::optional<Solid> ShapeResolver::resolve_capsule(const syntax::Shape& shape) {
  if (!check_count(shape, 7, "two ends and a radius: x0, y0, z0, x1, y1, z1, r")) {
    return std::nullopt;
  }
  const auto& n = shape.numbers;
  bool fine = check_lengths(shape);
  fine = check_positive(n[6], "the radius of the capsule") && fine;
  if (!fine) return std::nullopt;
  return geometry::Capsule{Vec3(n[0].value, n[1].value, n[2].value),
                           Vec3(n[3].value, n[4].value, n[5].value), n[6].value};
}

std::optional<Solid> ShapeResolver::resolve_prism(const syntax::Shape& shape) {
  const auto& n = shape.numbers;
  if (n.size() < 8 || n.size() % 2 != 0) {
    diagnostics_.error(
        "F06", shape.span,
        fmt::format("prism takes z0, z1 and at least 3 corners (x, y), found {} numbers",
                    n.size()));
    return std::nullopt;
  }
  bool fine = check_lengths(shape);
  fine = check_ascending(n[0], n[1], "the prism has no height") && fine;
  geometry::Prism prism;
  prism.z0 = n[0].value;
  prism.z1 = n[1].value;
  for (std::size_t i = 2; i < n.size(); i += 2) {
    prism.polygon.emplace_back(n[i].value, n[i + 1].value);
  }
  if (prism.polygon.size() > kMaxPolygonCorners) {
    diagnostics_.error("F08", shape.span,
                       fmt::format("the polygon of this prism has {} corners; expected at most {}",
                                   prism.polygon.size(), kMaxPolygonCorners),
                       "read it from a mesh file");
    return std::nullopt;
  }
  if (!fine) return std::nullopt;
  if (const std::optional<std::string> fault = polygon_fault(prism.polygon)) {
    diagnostics_.error("F08", shape.span,
                       fmt::format("the polygon of this prism is not simple: {}", *fault));
    return std::nullopt;
  }
  return prism;
}

bool ShapeResolver::check_lengths(const syntax::Shape& shape) {
  bool fine = true;
  for (const syntax::Number& number : shape.numbers) {
    if (!check_unit(number, syntax::UnitKind::length, shape.kind.text, diagnostics_)) {
      fine = false;
    } else if (!(std::fabs(number.value) <= kMaxLength)) {
      diagnostics_.error(
          "F07", number.span,
          fmt::format("{} m is too large; expected at most {} m", number.value, kMaxLength));
      fine = false;
    }
  }
  return fine;
}

bool ShapeResolver::check_count(const syntax::Shape& shape, std::size_t wanted, const char* form) {
  if (shape.numbers.size() == wanted) return true;
  diagnostics_.error("F06", shape.span,
                     fmt::format("{} takes {} numbers ({}), found {}", shape.kind.text, wanted,
                                 form, shape.numbers.size()));
  return false;
}

bool ShapeResolver::check_positive(const syntax::Number& number, const char* what) {
  if (number.value > 0) return true;
  diagnostics_.error("F07", number.span,
                     fmt::format("{} must be greater than 0, found {}", what, number.value));
  return false;
}

bool ShapeResolver::check_ascending(const syntax::Number& low, const syntax::Number& high,
                                    const char* what) {
  if (low.value < high.value) return true;
  diagnostics_.error("F07", high.span,
                     fmt::format("{}: it goes from {} to {}; expected the smaller value first",
                                 what, low.value, high.value));
  return false;
}

}  // namespace rubicon::interpreter
