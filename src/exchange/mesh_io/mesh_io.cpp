#include "src/exchange/mesh_io/mesh_io.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include "src/exchange/mesh_io/bounded_cache.hpp"
#include "src/exchange/mesh_io/disk_cache_io.hpp"
#include "src/exchange/mesh_io/hull_check.hpp"
#include "src/exchange/mesh_io/mesh_format.hpp"
#include "src/exchange/mesh_io/scene_source_io.hpp"
#include "src/exchange/mesh_io/scene_wire.hpp"

namespace rubicon::mesh_io {

namespace {

using geometry::Vec3;

/// Meshes kept so that equal requests share one.
constexpr std::size_t kMeshBytes = 256'000'000;

/// Beyond this distance from the origin (metres) a unit is wrong: national grids end below 1e7 m.
constexpr double kFarthest = 1e7;

constexpr std::size_t kLongestNodePath = 1000;  ///< bytes, of NamedMesh::path
constexpr std::size_t kNamesShown = 8;

MeshFailure failure(const std::string& path, const std::string& reason) {
  return {fmt::format("mesh '{}' cannot be used: {}", printable(path, PATH_MAX), reason)};
}

std::string quoted(const std::string& name) {
  return fmt::format("'{}'", printable(name, kLongestNameShown));
}

/// Names of nodes with triangles, for a message.
std::string names_in(const FileScene& scene) {
  std::string names;
  std::size_t count = 0;
  for (const FileNode& node : scene.nodes) {
    if (node.triangles.empty() || node.name.empty()) continue;
    if (++count > kNamesShown) continue;
    names += (names.empty() ? "" : ", ") + quoted(node.name);
  }
  if (count == 0) return "its parts have no names";
  if (count > kNamesShown) names += fmt::format(" and {} more", count - kNamesShown);
  return "it has " + names;
}

/// The nodes that belong to `part`, in the order of the file: the node of that name and all below
/// it. Or why that is not clear.
std::variant<std::vector<std::size_t>, std::string> select(const FileContent& content,
                                                           const std::string& part) {
  if (part.empty()) {
    std::vector<std::size_t> all(content.scene->nodes.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
  }
  const std::vector<std::size_t> meant = content.parts->outermost(content.parts->meant_by(part));
  if (meant.empty()) {
    return fmt::format("it has no part {}; {}", quoted(part), names_in(*content.scene));
  }
  if (meant.size() > 1) {
    return fmt::format("{} of its parts are called {}; give each its own name", meant.size(),
                       quoted(part));
  }
  return content.parts->with_all_below(meant.front());
}

/// Y up to Z up.
Vec3 z_up(const Vec3& p) { return {p.x(), -p.z(), p.y()}; }

/// Metres for one unit of the vertices, or what is wrong.
std::variant<double, std::string> factor_for(const FileScene& scene, const MeshRequest& request) {
  if (!std::isfinite(request.scale) || request.scale <= 0) {
    return fmt::format("a scale must be a number above 0, not {}", request.scale);
  }
  if (!std::isfinite(request.metres_per_unit) || request.metres_per_unit < 0) {
    return fmt::format("a unit must be a length above 0, not {} m", request.metres_per_unit);
  }
  double factor = 1;
  if (scene.in_metres) {
    const double declared = scene.declared_metres_per_unit;
    if (!std::isfinite(declared) || declared <= 0) {
      return fmt::format("it declares a unit of {} m; export it again", declared);
    }
    if (request.metres_per_unit > 0) factor = request.metres_per_unit / declared;
  } else {
    if (request.metres_per_unit == 0) {
      return "files of this kind carry no unit; name one, such as mm or m";
    }
    factor = request.metres_per_unit;
  }
  return factor * request.scale;
}

/// Why these vertices, counted from `origin`, cannot be used; empty when they can.
std::string wrong_vertices(const std::vector<Vec3>& vertices, const Vec3& origin) {
  double farthest = 0;
  for (const Vec3& p : vertices) {
    if (!p.allFinite()) return "a corner is not a finite number; export it again";
    farthest = std::max(farthest, (p + origin).cwiseAbs().maxCoeff());
  }
  if (!origin.allFinite()) return "its origin is not a finite point; export it again";
  if (farthest <= kFarthest) return {};
  return fmt::format("it reaches {:.3g} m from its origin; check the unit and the scale", farthest);
}

constexpr const char* kNoTriangles =
    "it has no triangle of any size; check the unit, and that surfaces were exported";

std::string path_of(const FileScene& scene, std::size_t index) {
  std::string path = scene.nodes[index].name;
  for (int i = scene.nodes[index].parent; i >= 0;) {
    const FileNode& node = scene.nodes[static_cast<std::size_t>(i)];
    if (path.size() + node.name.size() + 1 > kLongestNodePath) return ".../" + path;
    path.insert(0, node.name + "/");
    i = node.parent;
  }
  return path;
}

/// A mesh, and the point that its vertices still count from.
struct LocalMesh {
  RepairedMesh repaired;
  Vec3 origin = Vec3::Zero();
};

/// Puts the vertices where they belong. Last of all: what is done before is exact to the size of
/// the mesh, not to its distance.
void move_to_world(std::vector<Vec3>& vertices, const Vec3& origin) {
  if (origin == Vec3::Zero()) return;
  for (Vec3& p : vertices) p += origin;
}

/// The mesh that is asked for, or what is wrong.
std::variant<LocalMesh, std::string> mesh_of(const FileContent& content,
                                             const MeshRequest& request) {
  const FileScene& scene = *content.scene;
  const std::variant<double, std::string> factor = factor_for(scene, request);
  if (const auto* wrong = std::get_if<std::string>(&factor)) return *wrong;
  const std::variant<std::vector<std::size_t>, std::string> chosen = select(content, request.part);
  if (const auto* wrong = std::get_if<std::string>(&chosen)) return *wrong;

  const bool turn = request.up == 'y' || (request.up == 0 && scene.y_up);
  const Vec3 origin = (turn ? z_up(scene.origin) : scene.origin) * std::get<double>(factor);
  std::vector<Vec3> vertices;
  std::vector<std::array<int, 3>> triangles;
  for (const std::size_t i : std::get<std::vector<std::size_t>>(chosen)) {
    const auto base = static_cast<int>(vertices.size());
    for (const Vec3& p : scene.nodes[i].vertices) {
      vertices.push_back((turn ? z_up(p) : p) * std::get<double>(factor));
    }
    for (const std::array<int, 3>& t : scene.nodes[i].triangles) {
      triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
    }
  }
  if (std::string wrong = wrong_vertices(vertices, origin); !wrong.empty()) return wrong;
  RepairedMesh repaired = repair(vertices, triangles);
  if (repaired.mesh.triangles.empty()) return kNoTriangles;
  return LocalMesh{std::move(repaired), origin};
}

/// The convex hull of a mesh, verified. What was repaired before stays in the report.
std::variant<LocalMesh, std::string> hull_of(SceneSource& source, const LocalMesh& mesh) {
  const std::vector<Vec3>& corners = mesh.repaired.mesh.vertices;
  std::variant<FileScene, SceneFailure> found = source.hull(corners);
  if (auto* wrong = std::get_if<SceneFailure>(&found)) return std::move(*wrong);
  const FileScene& scene = std::get<FileScene>(found);
  constexpr const char* kNoHull =
      "its hull cannot be found exactly enough; leave out 'hull', or simplify it";
  if (scene.nodes.size() != 1 || !wrong_vertices(scene.nodes[0].vertices, mesh.origin).empty()) {
    return kNoHull;
  }
  RepairedMesh hull = repair(scene.nodes[0].vertices, scene.nodes[0].triangles);
  hull.report = mesh.repaired.report;
  if (!hull.mesh.closed) return "its hull is as thin as a sheet; leave out 'hull'";
  switch (hull_contains(hull.mesh, corners)) {
    case HullCheck::kContains:
      return LocalMesh{std::move(hull), mesh.origin};
    case HullCheck::kTooMuchWork:
      return "its hull has too many corners; simplify it";
    case HullCheck::kSticksOut:
      return kNoHull;
  }
  return kNoHull;
}

/// What becomes of the numbers of a file.
struct NodeTerms {
  double factor = 1;
  bool turn = false;  ///< from Y up to Z up
};

/// Which nodes have triangles somewhere below them.
std::vector<char> with_triangles_below(const FileScene& scene) {
  std::vector<char> below(scene.nodes.size(), 0);
  for (std::size_t i = scene.nodes.size(); i-- > 0;) {
    const FileNode& node = scene.nodes[i];
    if (node.parent < 0 || (node.triangles.empty() && below[i] == 0)) continue;
    below[static_cast<std::size_t>(node.parent)] = 1;
  }
  return below;
}

/// All nodes with triangles.
std::variant<std::vector<NamedMesh>, MeshFailure> nodes_of(const FileContent& content,
                                                           const std::string& path,
                                                           const NodeTerms& terms) {
  const FileScene& scene = *content.scene;
  const auto put = [&](const Vec3& p) -> Vec3 { return (terms.turn ? z_up(p) : p) * terms.factor; };
  const Vec3 origin = put(scene.origin);
  const std::vector<char> below = with_triangles_below(scene);
  const auto is_unique = [&](std::string_view part) {
    return !part.empty() && content.parts->meant_by(part).size() == 1;
  };
  std::vector<NamedMesh> meshes;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const FileNode& node = scene.nodes[i];
    std::vector<Vec3> vertices;
    for (const Vec3& p : node.vertices) vertices.push_back(put(p));
    if (std::string wrong = wrong_vertices(vertices, origin); !wrong.empty()) {
      return failure(path, fmt::format("part {}: {}", quoted(node.name), wrong));
    }
    RepairedMesh repaired = repair(vertices, node.triangles);
    if (repaired.mesh.triangles.empty()) continue;
    move_to_world(repaired.mesh.vertices, origin);
    NamedMesh found;
    found.name = node.name;
    found.path = path_of(scene, i);
    found.node = i;
    if (node.parent > 0) found.above = scene.nodes[static_cast<std::size_t>(node.parent)].name;
    found.has_nodes_below = below[i] != 0;
    found.name_is_unique = is_unique(node.name);
    found.id_is_unique = is_unique(global_id(node.name));
    found.mesh = std::move(repaired.mesh);
    found.report = repaired.report;
    found.note = node.note;
    meshes.push_back(std::move(found));
  }
  if (meshes.empty()) return failure(path, kNoTriangles);
  return meshes;
}

std::size_t bytes_of(const geometry::TriangleMesh& mesh) {
  return sizeof mesh + mesh.vertices.size() * sizeof(Vec3) +
         mesh.triangles.size() * sizeof(std::array<int, 3>);
}

/// Equal for requests that give the same mesh; empty when that cannot be told.
std::string key_of(const FileContent& content, const MeshRequest& request) {
  if (content.key.empty()) return {};
  return fmt::format("{} {:a} {:a} {} {} {}", content.key, request.metres_per_unit, request.scale,
                     int{request.up}, request.hull, request.part);
}

}  // namespace

bool needs_unit(const std::string& path) {
  const std::optional<MeshFormat> format = format_of(path);
  return format && !format->declares_unit;
}

struct MeshReader::State {
  SceneSource source;
  BoundedCache<ReadMesh> meshes;
};

MeshReader::MeshReader(std::string helper, std::string cache_folder)
    : state_(new State{{std::move(helper), std::move(cache_folder)},
                       BoundedCache<ReadMesh>(kMeshBytes)}) {}
MeshReader::MeshReader(MeshReader&&) noexcept = default;
MeshReader& MeshReader::operator=(MeshReader&&) noexcept = default;
MeshReader::~MeshReader() = default;

MeshReader MeshReader::beside_command() {
  std::array<char, PATH_MAX> buffer{};
  const ssize_t length = ::readlink("/proc/self/exe", buffer.data(), buffer.size());
  if (length <= 0) return MeshReader({});
  const std::string cache = default_cache_folder();
  const std::string command(buffer.data(), static_cast<std::size_t>(length));
  const std::string folder = command.substr(0, command.rfind('/'));
  const std::string beside = folder + "/rubicon-mesh";
  for (const std::string& candidate :
       {beside, folder + "/../bin/rubicon-mesh", folder + "/../libexec/rubicon/rubicon-mesh"}) {
    if (::access(candidate.c_str(), X_OK) == 0) return MeshReader(candidate, cache);
  }
  return MeshReader(beside, cache);
}

std::variant<ReadMesh, MeshFailure> MeshReader::read(const MeshRequest& request) const {
  std::variant<FileContent, SceneFailure> file =
      state_->source.read({request.path, request.folder, request.up != 0});
  if (const auto* wrong = std::get_if<SceneFailure>(&file)) return failure(request.path, *wrong);
  const FileContent& content = std::get<FileContent>(file);
  const std::string key = key_of(content, request);
  if (!key.empty()) {
    if (std::optional<ReadMesh> kept = state_->meshes.find(key)) return std::move(*kept);
  }
  std::variant<LocalMesh, std::string> made = mesh_of(content, request);
  if (request.hull && std::holds_alternative<LocalMesh>(made)) {
    made = hull_of(state_->source, std::get<LocalMesh>(made));
  }
  if (const auto* wrong = std::get_if<std::string>(&made)) return failure(request.path, *wrong);
  RepairedMesh& repaired = std::get<LocalMesh>(made).repaired;
  move_to_world(repaired.mesh.vertices, std::get<LocalMesh>(made).origin);
  ReadMesh result{std::make_shared<const geometry::TriangleMesh>(std::move(repaired.mesh)),
                  repaired.report};
  if (!key.empty()) state_->meshes.put(key, result, bytes_of(*result.mesh));
  return result;
}

std::variant<std::vector<NamedMesh>, MeshFailure> MeshReader::read_scene(
    const SceneRequest& request) const {
  std::variant<FileContent, SceneFailure> file =
      state_->source.read({request.path, request.folder, false});
  if (const auto* wrong = std::get_if<SceneFailure>(&file)) return failure(request.path, *wrong);
  return nodes_of(std::get<FileContent>(file), request.path, {});
}

std::variant<std::vector<NamedMesh>, MeshFailure> MeshReader::read_nodes(
    const MeshRequest& request) const {
  std::variant<FileContent, SceneFailure> file =
      state_->source.read({request.path, request.folder, request.up != 0});
  if (const auto* wrong = std::get_if<SceneFailure>(&file)) return failure(request.path, *wrong);
  const FileScene& scene = *std::get<FileContent>(file).scene;
  const std::variant<double, std::string> factor = factor_for(scene, request);
  if (const auto* wrong = std::get_if<std::string>(&factor)) return failure(request.path, *wrong);
  NodeTerms terms;
  terms.factor = std::get<double>(factor);
  terms.turn = request.up == 'y' || (request.up == 0 && scene.y_up);
  return nodes_of(std::get<FileContent>(file), request.path, terms);
}

}  // namespace rubicon::mesh_io
