#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "src/exchange/mesh_io/mesh_repair.hpp"
#include "src/motion/geometry/shape.hpp"

namespace rubicon::mesh_io {

/// What to read, and how the numbers of the file become metres with z up.
struct MeshRequest {
  std::string path;    ///< absolute, or relative to the working directory
  std::string folder;  ///< the mesh must lie inside it, symbolic links resolved; empty: "."
  double metres_per_unit =
      0;              ///< 0: the unit the file declares; must be given for STL, OBJ and PLY
  double scale = 1;   ///< a further factor, > 0
  char up = 0;        ///< 'y' or 'z': this axis of the numbers in the file points up; 0: as the
                      ///< file declares (STL, OBJ and PLY declare nothing: z)
  std::string part;   ///< one named node with all below it, empty: the whole file; of IFC the
                      ///< GlobalId is enough
  bool hull = false;  ///< the convex hull of the corners instead of the mesh
};

/// Why a mesh could not be had. Lower case: what was found, what was expected, what to do.
struct MeshFailure {
  std::string message;
};

/// A mesh in metres, z up, and what was repaired on the way.
struct ReadMesh {
  std::shared_ptr<const geometry::TriangleMesh> mesh;  // shared: as geometry::Mesh wants it
  RepairReport report;
};

/// One node of a file with the meshes that hang directly on it.
struct NamedMesh {
  std::string name;      ///< of the node itself
  std::string path;      ///< names from the root down, joined by '/', ending with `name`; a path of
                         ///< more than 1000 bytes begins with "..." instead
  std::size_t node = 0;  ///< its number among the nodes of the file, the root's is 0
  std::string above;     ///< name of the node it hangs on; empty when that is the root, or it is
                         ///< the root itself
  bool has_nodes_below = false;  ///< with triangles of their own: as a part it comes with them
  bool name_is_unique = false;   ///< as `part` of a request, `name` means this node and no other
  bool id_is_unique = false;     ///< so does the GlobalId of IFC at the end of `name`; false: none
  geometry::TriangleMesh mesh;
  RepairReport report;
  std::string note = {};  ///< where the mesh differs from what the file says; empty: nowhere
};

/// A whole file as a list of nodes.
struct SceneRequest {
  std::string path;    ///< absolute, or relative to the working directory
  std::string folder;  ///< as in MeshRequest
};

/// Whether files of this name carry no unit of their own (STL, OBJ, PLY), so that one must be
/// given.
bool needs_unit(const std::string& path);

/// Reads meshes through the helper program, which parses each file in a process of its own under
/// limits of memory and time. Nothing the file contains can harm, stop or swell the caller. Equal
/// requests for equal content give the same mesh object while it is remembered (up to 256 MB).
/// Several threads may use one reader at once. The helper runs as long as the reader lives.
class MeshReader {
 public:
  /// `helper` is the path of the program `rubicon-mesh`; `cache_folder` remembers what was read
  /// from one run to the next, empty: nothing does.
  explicit MeshReader(std::string helper, std::string cache_folder = {});
  MeshReader(MeshReader&&) noexcept;
  MeshReader& operator=(MeshReader&&) noexcept;
  ~MeshReader();

  /// The helper in the folder of the running executable, or, if there is none, in ../bin or
  /// ../libexec/rubicon seen from there; the user's cache folder.
  static MeshReader beside_command();

  /// The mesh in metres, z up. At least one triangle, finite vertices, indices in range.
  std::variant<ReadMesh, MeshFailure> read(const MeshRequest& request) const;

  /// Every node that has triangles, in the order of the file. World coordinates of the file as
  /// declared there: metres for DAE, glTF and IFC (units of the file for the others), and Y up for
  /// DAE, glTF and IFC (axes of the file for the others).
  std::variant<std::vector<NamedMesh>, MeshFailure> read_scene(const SceneRequest& request) const;

  /// The same in metres, z up, as `request` says: what read() gives for each of them. `part` and
  /// `hull` of the request are passed over.
  std::variant<std::vector<NamedMesh>, MeshFailure> read_nodes(const MeshRequest& request) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace rubicon::mesh_io
