#include "src/results/report/header_files.hpp"

#include <memory>
#include <utility>

#include "src/simulation/trace/header.hpp"
#include "src/simulation/trace/trace_reader.hpp"

namespace rubicon::report {

using interpreter::FileFailure;

HeaderFiles::HeaderFiles(const std::string& header) {
  trace::TraceHeader read = trace::read_header(header);
  plan_path_ = std::move(read.path);
  set_ = std::move(read.set);
  for (trace::HeaderFile& file : read.files) {
    texts_.emplace(std::move(file.path), std::move(file.text));
  }
}

std::variant<std::string, FileFailure> HeaderFiles::read_text(const std::string& path) {
  const auto found = texts_.find(path);
  if (found == texts_.end()) return FileFailure{"the trace does not carry this file"};
  return found->second;
}

std::variant<std::shared_ptr<const geometry::TriangleMesh>, FileFailure> HeaderFiles::read_mesh(
    const interpreter::MeshRequest&) {
  auto mesh = std::make_shared<geometry::TriangleMesh>();
  mesh->vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh->triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  mesh->closed = true;
  return mesh;
}

}  // namespace rubicon::report
