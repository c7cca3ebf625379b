#include "src/mesh_io/mesh_io.hpp"

#include <fmt/core.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <climits>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>

#include "src/mesh_io/child_process_io.hpp"
#include "src/mesh_io/guarded_file_io.hpp"
#include "src/mesh_io/mesh_format.hpp"
#include "src/mesh_io/scene_wire.hpp"

namespace rubicon::mesh_io {

namespace {

using geometry::Vec3;

/// A larger file is refused unread: parsed it would not fit the memory limit either.
constexpr std::uint64_t kLargestFile = 256'000'000;

/// Processor time a file may take: enough to find out that a small one is hostile within seconds,
/// and in proportion for honest large ones (measured: 25 MB/s for IFC, 80 to 300 for STL, OBJ and
/// PLY).
constexpr std::uint64_t kBaseSeconds = 1;
constexpr std::uint64_t kBytesPerSecond = 8'000'000;

/// Address space the helper may take: its libraries (80 MB), then in proportion to the file
/// (measured: 2 to 6 bytes for a byte of STL, OBJ and PLY), never more than a site computer can
/// spare.
constexpr std::uint64_t kBaseMemory = 320'000'000;
constexpr std::uint64_t kMemoryPerByte = 16;
constexpr std::uint64_t kMostMemory = 2'000'000'000;

/// Beyond this distance from the origin (metres) a unit is wrong: national grids end below 1e7 m.
constexpr double kFarthest = 1e7;

constexpr std::size_t kLongestPath = 1000;  ///< bytes, of NamedMesh::path
constexpr std::size_t kLongestNameShown = 80;
constexpr std::size_t kNamesShown = 8;

/// One file for the helper.
struct FileQuery {
  std::string path;
  std::string folder;
  bool ignore_declared_up = false;
};

MeshFailure failure(const std::string& path, const std::string& reason) {
  return {fmt::format("mesh '{}' cannot be used: {}", printable(path, PATH_MAX), reason)};
}

std::string quoted(const std::string& name) {
  return fmt::format("'{}'", printable(name, kLongestNameShown));
}

struct Budget {
  std::uint64_t seconds = 0;
  std::uint64_t bytes = 0;
};

Budget budget_for(std::uint64_t file_size) {
  return {kBaseSeconds + file_size / kBytesPerSecond,
          std::min(kBaseMemory + kMemoryPerByte * file_size, kMostMemory)};
}

/// Why a helper that ended this way gave no mesh; empty when it ended well.
std::string reason_of(const ChildResult& child, const std::string& helper, const Budget& budget) {
  const std::string too_long =
      fmt::format("reading it takes more than {} s; it is damaged, or far too complex for its size",
                  budget.seconds);
  switch (child.end) {
    case ChildResult::End::kNotStarted:
      return fmt::format(
          "the program {} that reads meshes cannot be started ({}); it belongs "
          "beside the command",
          helper.empty() ? "rubicon-mesh" : quoted(helper), std::strerror(child.code));
    case ChildResult::End::kTimedOut:
      return too_long;
    case ChildResult::End::kTooMuchOutput:
      return "it grows without end while it is read; it is damaged";
    case ChildResult::End::kSignalled:
      if (child.code == SIGXCPU || child.code == SIGKILL) return too_long;
      return "it is so damaged that its reader broke down; export it again";
    case ChildResult::End::kExited:
      if (child.code == 0) return {};
      return fmt::format(
          "the program {} that reads meshes failed (exit {}); it does not belong to "
          "this version",
          quoted(helper), child.code);
  }
  return {};
}

std::variant<FileScene, MeshFailure> read_file(const std::string& helper, const FileQuery& query) {
  if (!format_of(query.path)) {
    return failure(query.path, fmt::format("its name does not end in {}", kKnownExtensions));
  }
  const std::variant<std::string, GuardedFailure> folder = resolve_folder(query.folder);
  if (const auto* wrong = std::get_if<GuardedFailure>(&folder)) {
    return failure(query.path, wrong->message);
  }
  const std::string& resolved_folder = std::get<std::string>(folder);
  std::uint64_t size = 0;
  {
    const std::variant<GuardedFile, GuardedFailure> file = open_inside(resolved_folder, query.path);
    if (const auto* wrong = std::get_if<GuardedFailure>(&file)) {
      return failure(query.path, wrong->message);
    }
    size = std::get<GuardedFile>(file).size;
  }
  if (size == 0) return failure(query.path, "it is empty");
  if (size > kLargestFile) {
    return failure(query.path, fmt::format("it has {} MB, at most {} MB are read; simplify it",
                                           size / 1'000'000, kLargestFile / 1'000'000));
  }

  const Budget budget = budget_for(size);
  const SceneLimits limits;
  ChildQuery child_query;
  child_query.program = helper;
  child_query.arguments = {resolved_folder, query.path,
                           query.ignore_declared_up ? "written" : "declared",
                           std::to_string(budget.seconds), std::to_string(budget.bytes)};
  // The limit of processor time comes first; this one is for a child that sleeps.
  child_query.time_limit = std::chrono::seconds(2 * budget.seconds + 1);
  child_query.output_limit = largest_message(limits);
  const ChildResult child = run_child(child_query);
  if (std::string reason = reason_of(child, helper, budget); !reason.empty()) {
    return failure(query.path, reason);
  }
  std::variant<SceneMessage, WireError> decoded = decode(child.output, limits);
  if (const auto* error = std::get_if<WireError>(&decoded)) {
    return failure(query.path, "its reader broke down (" + error->message + "); export it again");
  }
  SceneMessage& message = std::get<SceneMessage>(decoded);
  if (const auto* reason = std::get_if<std::string>(&message)) return failure(query.path, *reason);
  return std::move(std::get<FileScene>(message));
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

/// Which nodes belong to `part`: the node of that name and all below it. Or why that is not clear.
std::variant<std::vector<char>, std::string> select(const FileScene& scene,
                                                    const std::string& part) {
  std::vector<char> chosen(scene.nodes.size(), part.empty() ? 1 : 0);
  if (part.empty()) return chosen;
  int outermost = 0;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const FileNode& node = scene.nodes[i];
    const bool below = node.parent >= 0 && chosen[static_cast<std::size_t>(node.parent)] != 0;
    const bool named = node.name == part;
    chosen[i] = below || named ? 1 : 0;
    if (named && !below) ++outermost;
  }
  if (outermost == 0) return fmt::format("it has no part {}; {}", quoted(part), names_in(scene));
  if (outermost > 1) {
    return fmt::format("{} of its parts are called {}; give each its own name", outermost,
                       quoted(part));
  }
  return chosen;
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

/// Why these vertices cannot be used; empty when they can.
std::string wrong_vertices(const std::vector<Vec3>& vertices) {
  double farthest = 0;
  for (const Vec3& p : vertices) {
    if (!p.allFinite()) return "a corner is not a finite number; export it again";
    farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
  }
  if (farthest <= kFarthest) return {};
  return fmt::format("it reaches {:.3g} m from its origin; check the unit and the scale", farthest);
}

constexpr const char* kNoTriangles =
    "it has no triangle of any size; check the unit, and that surfaces were exported";

std::string path_of(const FileScene& scene, std::size_t index) {
  std::string path = scene.nodes[index].name;
  for (int i = scene.nodes[index].parent; i >= 0;) {
    const FileNode& node = scene.nodes[static_cast<std::size_t>(i)];
    if (path.size() + node.name.size() + 1 > kLongestPath) return ".../" + path;
    path.insert(0, node.name + "/");
    i = node.parent;
  }
  return path;
}

}  // namespace

bool needs_unit(const std::string& path) {
  const std::optional<MeshFormat> format = format_of(path);
  return format && !format->declares_unit;
}

MeshReader::MeshReader(std::string helper) : helper_(std::move(helper)) {}

MeshReader MeshReader::beside_command() {
  std::array<char, PATH_MAX> buffer{};
  const ssize_t length = ::readlink("/proc/self/exe", buffer.data(), buffer.size());
  if (length <= 0) return MeshReader({});
  const std::string command(buffer.data(), static_cast<std::size_t>(length));
  const std::string folder = command.substr(0, command.rfind('/'));
  const std::string beside = folder + "/rubicon-mesh";
  for (const std::string& candidate :
       {beside, folder + "/../bin/rubicon-mesh", folder + "/../libexec/rubicon/rubicon-mesh"}) {
    if (::access(candidate.c_str(), X_OK) == 0) return MeshReader(candidate);
  }
  return MeshReader(beside);
}

std::variant<ReadMesh, MeshFailure> MeshReader::read(const MeshRequest& request) const {
  FileQuery query{request.path, request.folder, request.up != 0};
  std::variant<FileScene, MeshFailure> file = read_file(helper_, query);
  if (auto* wrong = std::get_if<MeshFailure>(&file)) return std::move(*wrong);
  const FileScene& scene = std::get<FileScene>(file);

  const std::variant<double, std::string> factor = factor_for(scene, request);
  if (const auto* wrong = std::get_if<std::string>(&factor)) return failure(request.path, *wrong);
  const std::variant<std::vector<char>, std::string> chosen = select(scene, request.part);
  if (const auto* wrong = std::get_if<std::string>(&chosen)) return failure(request.path, *wrong);

  const bool turn = request.up == 'y' || (request.up == 0 && scene.y_up);
  std::vector<Vec3> vertices;
  std::vector<std::array<int, 3>> triangles;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (std::get<std::vector<char>>(chosen)[i] == 0) continue;
    const auto base = static_cast<int>(vertices.size());
    for (const Vec3& p : scene.nodes[i].vertices) {
      vertices.push_back((turn ? z_up(p) : p) * std::get<double>(factor));
    }
    for (const std::array<int, 3>& t : scene.nodes[i].triangles) {
      triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
    }
  }
  if (std::string wrong = wrong_vertices(vertices); !wrong.empty()) {
    return failure(request.path, wrong);
  }
  MendedMesh mended = mend(vertices, triangles);
  if (mended.mesh.triangles.empty()) return failure(request.path, kNoTriangles);
  return ReadMesh{std::make_shared<const geometry::TriangleMesh>(std::move(mended.mesh)),
                  mended.report};
}

std::variant<std::vector<NamedMesh>, MeshFailure> MeshReader::read_scene(
    const SceneRequest& request) const {
  std::variant<FileScene, MeshFailure> file =
      read_file(helper_, {request.path, request.folder, false});
  if (auto* wrong = std::get_if<MeshFailure>(&file)) return std::move(*wrong);
  const FileScene& scene = std::get<FileScene>(file);
  std::vector<NamedMesh> meshes;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const FileNode& node = scene.nodes[i];
    if (std::string wrong = wrong_vertices(node.vertices); !wrong.empty()) {
      return failure(request.path, fmt::format("part {}: {}", quoted(node.name), wrong));
    }
    MendedMesh mended = mend(node.vertices, node.triangles);
    if (mended.mesh.triangles.empty()) continue;
    meshes.push_back({node.name, path_of(scene, i), std::move(mended.mesh), mended.report});
  }
  if (meshes.empty()) return failure(request.path, kNoTriangles);
  return meshes;
}

std::variant<std::shared_ptr<const geometry::TriangleMesh>, MeshFailure> read_mesh(
    const MeshRequest& request) {
  std::variant<ReadMesh, MeshFailure> result = MeshReader::beside_command().read(request);
  if (auto* wrong = std::get_if<MeshFailure>(&result)) return std::move(*wrong);
  return std::get<ReadMesh>(result).mesh;
}

}  // namespace rubicon::mesh_io
