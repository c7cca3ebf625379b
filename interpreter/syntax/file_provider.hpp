#pragma once

#include <memory>
#include <string>
#include <variant>

#include "src/motion/geometry/shape.hpp"

namespace rubicon::interpreter {

/// Why a file could not be had: lower case, what was found and what to do.
struct FileFailure {
  std::string message;
};

struct MeshRequest {
  std::string path;    ///< as resolved: the naming file's folder joined with what was written
  std::string folder;  ///< the folder of the file that names it; the mesh must stay inside
  double metres_per_unit = 0;  ///< 0: the format's own unit
  double scale = 1;
  char up = 0;        ///< 'y', 'z', 0: the format's own
  std::string part;   ///< one named node, empty: all
  bool hull = false;  ///< the convex hull of its corners instead
};

/// The only way the interpreter reaches files; tests give texts from memory.
class FileProvider {
 public:
  virtual ~FileProvider() = default;
  /// The bytes of a text file (size cap, regular files only).
  virtual std::variant<std::string, FileFailure> read_text(const std::string& path) = 0;
  /// A mesh in metres, z up. The failure names the mesh: it is shown as it is.
  virtual std::variant<std::shared_ptr<const geometry::TriangleMesh>, FileFailure> read_mesh(
      const MeshRequest& request) = 0;
};

/// `written` relative to the folder of `naming_file`, "." and ".." resolved by text; absolute paths
/// stay.
std::string resolve_path(const std::string& naming_file, const std::string& written);

}  // namespace rubicon::interpreter
