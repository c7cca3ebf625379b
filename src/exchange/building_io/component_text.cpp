#include "src/exchange/building_io/component_text.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>
#include <vector>

#include "interpreter/syntax/attribute_text.hpp"
#include "src/exchange/building_io/element_frame.hpp"
#include "src/exchange/building_io/names.hpp"
#include "src/exchange/mesh_io/mesh_repair.hpp"
#include "src/motion/math/pose.hpp"

namespace rubicon::building_io {

namespace {

/// Of the numbers in mesh_text(): 0.001 mm.
constexpr double kMeshPlacesPerMetre = 1e6;

/// Where the shape lies in {O}: the model's own coordinates, taken back. Written so that `at` and
/// this together are the identity, up to the rounding of doubles.
std::string shape_frame(const ElementFrame& frame) {
  std::string text;
  if (frame.turn_deg != 0) text = fmt::format("rotz({})", number_text(-frame.turn_deg));
  const Vec3 back = -frame.origin;
  if (back != Vec3::Zero()) {
    if (!text.empty()) text += " * ";
    text += fmt::format("trans({}, {}, {})", number_text(back.x()), number_text(back.y()),
                        number_text(back.z()));
  }
  return text;
}

std::string shape_text(const Element& element) {
  if (!element.mesh_file.empty()) return fmt::format("mesh(\"{}\", m)", element.mesh_file);
  std::string text = fmt::format("mesh(\"{}\"", element.model);
  if (!element.unit.empty()) text += ", " + element.unit;
  if (element.up != 0) text += fmt::format(", up {}", element.up);
  if (!element.part.empty()) text += fmt::format(", part \"{}\"", element.part);
  text += ")";
  const std::string frame = shape_frame(element.frame);
  return frame.empty() ? text : text + " at " + frame;
}

}  // namespace

std::string number_text(double value) {
  std::string text = fmt::format("{:.5f}", value + 0.0);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string frame_text(const Vec3& p, double turn_deg) {
  std::string text;
  if (p != Vec3::Zero()) {
    text = fmt::format("trans({}, {}, {})", number_text(p.x()), number_text(p.y()),
                       number_text(p.z()));
  }
  if (turn_deg != 0) {
    text += fmt::format("{}rotz({})", text.empty() ? "" : " * ", number_text(turn_deg));
  }
  return text;
}

std::string frame_or_identity(const Vec3& p, double turn_deg) {
  const std::string text = frame_text(p, turn_deg);
  return text.empty() ? "trans(0, 0, 0)" : text;
}

std::string element_remark(const Element& element) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (!element.storey.empty()) add(remark_name(element.storey));
  add(element.type.empty() ? remark_name(element.name)
                           : element.type + " " + remark_name(element.name));
  if (!element.guid.empty()) add(element.guid);
  return text;
}

std::string component_text(const Element& element, const ComponentTerms& terms) {
  std::string text = fmt::format("component {} {{\n", element.component);
  for (const auto& [key, value] : {std::pair("name", &element.name),
                                   {"storey", &element.storey},
                                   {"type", &element.type},
                                   {"guid", &element.guid}}) {
    const std::string written = interpreter::written_attribute(*value);
    if (!written.empty()) text += fmt::format("{} \"{}\";\n", key, written);
  }
  text += fmt::format("shape {};\n", shape_text(element));
  if (const std::string at = frame_text(terms.at, terms.turn_deg); !at.empty()) {
    text += fmt::format("at {};\n", at);
  }
  const std::string top = frame_or_identity({0, 0, element.frame.size.z()}, 0);
  text += fmt::format("grip {}{}{};\n", top, terms.grip.empty() ? "" : " * ", terms.grip);
  if (!terms.mass.empty()) {
    text += fmt::format("mass {};{}{}\n", terms.mass, terms.mass_source.empty() ? "" : "  // ",
                        terms.mass_source);
  }
  return text + "}\n";
}

std::string mesh_text(const Element& element) {
  std::string text = fmt::format("# {}\no {}\n", element_remark(element), element.component);
  for (const Vec3& p : element.mesh->vertices) {
    text += fmt::format("v {:.6f} {:.6f} {:.6f}\n", p.x() + 0.0, p.y() + 0.0, p.z() + 0.0);
  }
  for (const std::array<int, 3>& t : element.mesh->triangles) {
    text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  }
  return text;
}

bool is_nothing_when_written(const geometry::TriangleMesh& mesh) {
  std::vector<Vec3> points;
  for (const Vec3& p : mesh.vertices) {
    points.push_back((p * kMeshPlacesPerMetre).array().round().matrix() / kMeshPlacesPerMetre);
  }
  return mesh_io::repair(points, mesh.triangles).mesh.triangles.empty();
}

}  // namespace rubicon::building_io
