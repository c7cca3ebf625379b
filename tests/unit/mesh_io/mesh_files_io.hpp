#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "src/exchange/mesh_io/mesh_io.hpp"

namespace rubicon::mesh_io::testing {

/// A folder that is gone after the test.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Writes a file and gives its path.
  std::string write(const std::string& name, const std::string& bytes) const;

 private:
  std::filesystem::path path_;
};

/// The reader with the helper of this build.
MeshReader reader();

/// Reads `path` in its own folder, numbers in metres where the format has no unit.
std::variant<ReadMesh, MeshFailure> read_in_own_folder(const std::string& path,
                                                       MeshRequest request = {});

using Soup = std::vector<std::array<geometry::Vec3, 3>>;

/// The twelve outward triangles of a box.
Soup box_soup(const geometry::Vec3& lower, const geometry::Vec3& upper);
inline Soup unit_box() { return box_soup({0, 0, 0}, {1, 1, 1}); }

/// The soup in a format.
std::string as_stl_text(const Soup& soup);
std::string as_stl_binary(const Soup& soup);
std::string as_obj(const Soup& soup);
std::string as_ply(const Soup& soup);
/// With `up_axis` such as "Z_UP", `unit` in metres and the node moved by (10, 0, 0).
std::string as_dae(const Soup& soup, const std::string& up_axis, const std::string& unit);
/// One buffer, `uri` as given (empty: embedded).
std::string as_gltf(const Soup& soup, const std::string& uri);
/// What that buffer holds.
std::string gltf_buffer(const Soup& soup);

/// An OBJ of one polygon of 2 * `turns` corners, a narrow spiral in along one side and out along
/// the other: almost no corner is an ear, so that cutting it into triangles takes long.
std::string spiral_obj(int turns);

/// Smallest and largest coordinates.
geometry::Box extent(const geometry::TriangleMesh& mesh);

/// Signed volume, m3.
double volume(const geometry::TriangleMesh& mesh);

}  // namespace rubicon::mesh_io::testing
