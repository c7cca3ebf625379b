#include "src/exchange/mesh_io/assimp_scene.hpp"

#include <assimp/BaseImporter.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/core.h>

#include <Eigen/Geometry>
#include <assimp/Importer.hpp>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace rubicon::mesh_io {

namespace {

/// Any affine transform: nodes may scale and mirror.
using Affine = Eigen::Transform<double, 3, Eigen::Affine>;

Affine affine(const aiMatrix4x4& m) {
  Affine X = Affine::Identity();
  X.matrix() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, 0, 0, 0, 1;
  return X;
}

/// Takes out every importer that is not for this extension: assimp otherwise guesses by content
/// and lets any of its forty parsers loose on a file.
void keep_only_importer(Assimp::Importer& importer, std::string_view extension) {
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
    std::set<std::string> known;
    Assimp::BaseImporter* const candidate = importer.GetImporter(i);
    candidate->GetExtensionList(known);
    if (known.count(std::string(extension)) == 0) importer.UnregisterLoader(candidate);
  }
}

/// The triangles of one mesh, behind those already in the node.
void append(const aiMesh& mesh, const Affine& X, bool mirrored, FileNode& node) {
  const auto base = static_cast<int>(node.vertices.size());
  std::vector<int> place(mesh.mNumVertices, -1);
  int next = base;
  for (unsigned int f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices != 3) continue;
    std::array<int, 3> triangle{};
    for (unsigned int k = 0; k < 3; ++k) {
      const unsigned int index = face.mIndices[k];
      if (index >= mesh.mNumVertices) {
        throw std::runtime_error("a face names a corner that is not there");
      }
      int& corner = place[index];
      if (corner < 0) {
        corner = next++;
        const aiVector3D& p = mesh.mVertices[index];
        node.vertices.emplace_back(X * math::Vec3(p.x, p.y, p.z));
      }
      triangle[k] = corner;
    }
    if (mirrored) std::swap(triangle[1], triangle[2]);
    node.triangles.push_back(triangle);
  }
}

/// Most work of cutting polygons into triangles, as the sum of the squares of their corners: an ear
/// is looked for among all corners, again for each triangle. A polygon of 14,000 corners in a
/// spiral takes 5 s; 20,000 polygons of 100 corners each are still read.
constexpr std::uint64_t kPolygonWork = 200'000'000;

std::uint64_t polygon_work(const aiScene& scene) {
  std::uint64_t work = 0;
  for (unsigned int i = 0; i < scene.mNumMeshes; ++i) {
    const aiMesh& mesh = *scene.mMeshes[i];
    for (unsigned int f = 0; f < mesh.mNumFaces; ++f) {
      const std::uint64_t corners = mesh.mFaces[f].mNumIndices;
      if (corners > 4) work += corners * corners;
    }
  }
  return work;
}

std::uint64_t triangle_count(const aiScene& scene, const aiNode& node) {
  std::uint64_t count = 0;
  for (unsigned int i = 0; i < node.mNumMeshes; ++i) {
    count += scene.mMeshes[node.mMeshes[i]]->mNumFaces;
  }
  return count;
}

/// `X_root` places the root, in place of its own transform.
SceneMessage flatten(const aiScene& scene, const Affine& X_root, const SceneLimits& limits,
                     FileScene result) {
  struct Pending {
    const aiNode* node;
    int parent;
    Affine X;
  };
  // An explicit stack: the depth of the tree is the file's choice.
  std::vector<Pending> stack{{scene.mRootNode, -1, X_root}};
  std::uint64_t triangles = 0;
  while (!stack.empty()) {
    const Pending current = stack.back();
    stack.pop_back();
    const aiNode& source = *current.node;
    const Affine& X = current.X;
    const auto index = static_cast<int>(result.nodes.size());
    FileNode node;
    node.name = source.mName.C_Str();
    node.parent = current.parent;
    triangles += triangle_count(scene, source);
    if (triangles > limits.triangles) {
      return too_many_triangles(limits);
    }
    if (result.nodes.size() >= limits.nodes) {
      return too_many_nodes(limits);
    }
    const bool mirrored = X.linear().determinant() < 0;
    for (unsigned int i = 0; i < source.mNumMeshes; ++i) {
      append(*scene.mMeshes[source.mMeshes[i]], X, mirrored, node);
    }
    result.nodes.push_back(std::move(node));
    for (unsigned int i = source.mNumChildren; i-- > 0;) {
      const aiNode& child = *source.mChildren[i];
      stack.push_back({&child, index, X * affine(child.mTransformation)});
    }
  }
  return result;
}

}  // namespace

std::string too_many_triangles(const SceneLimits& limits) {
  return fmt::format("it has more than {} triangles; simplify it, or split it into several files",
                     limits.triangles);
}

std::string too_many_nodes(const SceneLimits& limits) {
  return fmt::format("it has more than {} nodes; split it into several files", limits.nodes);
}

SceneMessage read_with_assimp(const AssimpQuery& query, std::unique_ptr<Assimp::IOSystem> files) {
  Assimp::Importer importer;
  importer.SetIOHandler(files.release());
  keep_only_importer(importer, query.format.extension);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, query.ignore_declared_up);
  // Corners are welded by ourselves: assimp's joining takes most of the memory and keeps apart
  // what differs in normals only.
  const aiScene* scene = importer.ReadFile(query.name, aiProcess_ValidateDataStructure);
  if (scene != nullptr && polygon_work(*scene) > kPolygonWork) {
    return fmt::format(
        "its polygons have too many corners: their squares add up to more than {}; cut them into "
        "triangles",
        kPolygonWork);
  }
  if (scene != nullptr) {
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_SortByPType);
  }
  if (scene == nullptr || scene->mRootNode == nullptr) {
    return fmt::format("it cannot be read as {}: {}", query.format.name, importer.GetErrorString());
  }

  FileScene result;
  const Affine X_root = affine(scene->mRootNode->mTransformation);
  if (query.format.declares_unit) {
    // The importer of Collada puts unit and axes into the root; glTF is in metres, Y up.
    const bool gltf = query.format.name == "glTF";
    result.declared_metres_per_unit = gltf ? 1.0 : X_root.linear().col(0).norm();
    result.in_metres = true;
    result.y_up = !query.ignore_declared_up;
  }
  return flatten(*scene, query.ignore_root ? Affine::Identity() : X_root, query.limits,
                 std::move(result));
}

}  // namespace rubicon::mesh_io
