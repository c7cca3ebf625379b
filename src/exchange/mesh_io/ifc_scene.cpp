#include "src/exchange/mesh_io/ifc_scene.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/exchange/ifc/element_bodies.hpp"
#include "src/exchange/ifc/ifc_model.hpp"
#include "src/exchange/ifc/plain_ifc.hpp"
#include "src/exchange/ifc/step_file.hpp"
#include "src/exchange/mesh_io/assimp_scene.hpp"
#include "src/exchange/mesh_io/assimp_text_file.hpp"
#include "src/exchange/mesh_io/mesh_format.hpp"

namespace rubicon::mesh_io {

namespace {

using math::Vec3;

/// Farther from its origin (metres) a scene gets an origin of its own: nearer, the numbers of a
/// file are as good as those of the library.
constexpr double kFarFromOrigin = 1000;
/// Such an origin lies on a grid of this size (metres), so that people can read it.
constexpr double kOriginGrid = 100;

/// What is said of elements that the library makes triangles of.
constexpr const char* kRough =
    "its shape is read roughly: holes of its profile are filled, and cuts may be missing";

/// Which element the triangles of a node belong to: the node's own or that of one above it.
std::optional<std::size_t> element_at(const FileScene& plain, std::size_t node) {
  for (int at = static_cast<int>(node); at >= 0;
       at = plain.nodes[static_cast<std::size_t>(at)].parent) {
    const auto element = ifc::element_of(plain.nodes[static_cast<std::size_t>(at)].name);
    if (element) return element;
  }
  return std::nullopt;
}

/// A round point near the first element, if that is far out; else the origin of the file.
Vec3 scene_origin(const ifc::IfcModel& model, const ifc::PlainIfc& plain) {
  for (std::size_t i = 0; i < model.elements.size(); ++i) {
    const ifc::IfcElement& element = model.elements[i];
    if (!element.X_WE) continue;
    const Vec3 p = *element.X_WE * (plain.offsets[i] * model.metres_per_unit);
    if (!p.allFinite() || p.cwiseAbs().maxCoeff() <= kFarFromOrigin) return Vec3::Zero();
    return (p / kOriginGrid).array().round().matrix() * kOriginGrid;
  }
  return Vec3::Zero();
}

class SceneBuilder {
 public:
  SceneBuilder(const ifc::IfcModel& model, const ifc::PlainIfc& plain, const IfcQuery& query)
      : model_(model),
        plain_(plain),
        turn_(!query.ignore_declared_up),
        origin_(scene_origin(model, plain)) {
    scene_.declared_metres_per_unit = model.metres_per_unit;
    scene_.in_metres = true;
    scene_.y_up = turn_;
    scene_.origin = turned(origin_);
    for (const ifc::IfcNode& node : model.tree) {
      scene_.nodes.push_back({node.name, node.parent, {}, {}});
    }
  }

  /// Adds what was made of an element here. Its points are exact far out too.
  void add_body(std::size_t index, const ifc::ElementBody& body) {
    const ifc::IfcElement& element = model_.elements[index];
    math::Pose X_SE = *element.X_WE;
    X_SE.translation() -= origin_;
    append(body.solid.points, body.solid.triangles, X_SE, 1, element.node);
    std::string& note = scene_.nodes[static_cast<std::size_t>(element.node)].note;
    for (const std::string& each : body.notes) note += (note.empty() ? "" : "; ") + each;
  }

  std::uint64_t triangles() const { return triangles_; }

  /// Adds what the library made of the plain file.
  void add_plain(const FileScene& plain) {
    for (std::size_t i = 0; i < plain.nodes.size(); ++i) {
      if (plain.nodes[i].triangles.empty()) continue;
      const std::optional<std::size_t> element = element_at(plain, i);
      if (element && *element < model_.elements.size()) {
        add(plain.nodes[i], *element);
      }
    }
  }

  FileScene finish() { return std::move(scene_); }

 private:
  Vec3 turned(const Vec3& p) const { return turn_ ? Vec3(p.x(), p.z(), -p.y()) : p; }

  void add(const FileNode& source, std::size_t index) {
    const ifc::IfcElement& element = model_.elements[index];
    math::Pose X_SE = *element.X_WE;
    X_SE.translation() = *element.X_WE * (plain_.offsets[index] * model_.metres_per_unit) - origin_;
    append(source.vertices, source.triangles, X_SE, model_.metres_per_unit, element.node);
    std::string& note = scene_.nodes[static_cast<std::size_t>(element.node)].note;
    note = kRough;
    const bool projects = std::any_of(model_.projections.begin(), model_.projections.end(),
                                      [&](const auto& each) { return each.element == element.id; });
    if (projects) note += "; what projects from it is missing";
  }

  void append(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
              const math::Pose& X_SE, double metres_per_unit, int to) {
    FileNode& node = scene_.nodes[static_cast<std::size_t>(to)];
    const auto base = static_cast<int>(node.vertices.size());
    for (const Vec3& p : points) {
      node.vertices.push_back(turned(X_SE * (p * metres_per_unit)));
    }
    for (const std::array<int, 3>& t : triangles) {
      node.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
    }
    triangles_ += triangles.size();
  }

  const ifc::IfcModel& model_;
  const ifc::PlainIfc& plain_;
  bool turn_;
  Vec3 origin_;
  FileScene scene_;
  std::uint64_t triangles_ = 0;
};

/// What is wrong where no element stands anywhere; empty: one does, or there is none.
std::string nothing_placed(const ifc::IfcModel& model) {
  const auto& all = model.elements;
  const bool any =
      std::any_of(all.begin(), all.end(), [](const auto& each) { return each.X_WE.has_value(); });
  if (any || all.empty()) return {};
  const ifc::IfcElement& first = all.front();
  return fmt::format("no element stands anywhere: {} '{}' ({}): {}", first.type, first.name,
                     first.guid, first.no_place);
}

std::string too_much_work(const ifc::IfcElement& element, const ifc::WorkBudget& budget) {
  return fmt::format(
      "the shapes up to {} '{}' ({}) take more than {} million steps of work (a corner, a side or "
      "a "
      "plane looked at once); simplify them, or split the file",
      element.type, element.name, element.guid, budget.steps() / 1'000'000);
}

}  // namespace

SceneMessage read_ifc(std::string_view text, const IfcQuery& query) {
  const auto file = ifc::StepFile::read(text);
  if (const auto* error = std::get_if<ifc::StepError>(&file)) {
    return "it cannot be read as IFC: line " + std::to_string(error->line) + ": " + error->message;
  }
  const auto model = ifc::read_model(std::get<ifc::StepFile>(file));
  if (const auto* failure = std::get_if<ifc::IfcFailure>(&model)) return failure->message;
  const auto& building = std::get<ifc::IfcModel>(model);
  if (building.tree.size() > query.limits.nodes) return too_many_nodes(query.limits);
  if (std::string wrong = nothing_placed(building); !wrong.empty()) return wrong;
  ifc::WorkBudget budget = ifc::shape_budget(std::get<ifc::StepFile>(file));
  const auto bodies = ifc::element_bodies(std::get<ifc::StepFile>(file), building, budget);
  if (budget.is_spent()) return too_much_work(building.elements[bodies.size() - 1], budget);
  std::vector<char> done;
  for (const auto& body : bodies) done.push_back(body ? 1 : 0);
  const ifc::PlainIfc plain = ifc::plain_ifc(std::get<ifc::StepFile>(file), building, done);
  SceneBuilder builder(building, plain, query);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i]) builder.add_body(i, *bodies[i]);
    if (builder.triangles() > query.limits.triangles) return too_many_triangles(query.limits);
  }
  if (plain.elements > 0) {
    AssimpQuery plain_query;
    plain_query.name = "plain.ifc";
    plain_query.format = *format_of(plain_query.name);
    plain_query.ignore_root = true;
    plain_query.limits = query.limits;
    plain_query.limits.triangles -= builder.triangles();
    SceneMessage message = read_with_assimp(
        plain_query, std::make_unique<AssimpTextFile>(plain_query.name, plain.text));
    const auto* scene = std::get_if<FileScene>(&message);
    if (scene == nullptr) return message;
    builder.add_plain(*scene);
  }
  return builder.finish();
}

}  // namespace rubicon::mesh_io
