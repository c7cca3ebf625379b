#include "tests/unit/check/memory_files.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/support/places.hpp"

namespace rubicon::test {

using interpreter::FileFailure;

std::variant<std::string, FileFailure> MemoryFiles::read_text(const std::string& path) {
  reads.push_back(path);
  const auto found = texts.find(path);
  if (found == texts.end()) return FileFailure{"there is no such file"};
  return found->second;
}

std::variant<std::shared_ptr<const geometry::TriangleMesh>, FileFailure> MemoryFiles::read_mesh(
    const interpreter::MeshRequest& request) {
  requests.push_back(request);
  if (std::find(meshes.begin(), meshes.end(), request.path) == meshes.end()) {
    return FileFailure{"mesh '" + request.path + "' cannot be used: there is no such file"};
  }
  if (request.path.find("bad") != std::string::npos)
    return FileFailure{"mesh '" + request.path + "' cannot be used: it has no triangles"};
  geometry::TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  return std::make_shared<const geometry::TriangleMesh>(mesh);
}

MemoryFiles case_files() {
  MemoryFiles files;
  const std::filesystem::path folder =
      std::filesystem::path(test::source_dir()) / "tests/unit/check/site";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    const std::string path = "site/" + entry.path().filename().string();
    if (extension == ".robot" || extension == ".motion") {
      std::ostringstream text;
      text << std::ifstream(entry.path()).rdbuf();
      files.texts[path] = text.str();
    } else {
      files.meshes.push_back(path);
    }
  }
  files.meshes.push_back("site/hall.glb");
  return files;
}

}  // namespace rubicon::test
