#include "src/results/report/header_files.hpp"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace rubicon::report {

using interpreter::FileFailure;

HeaderFiles::HeaderFiles(const std::string& header) {
  try {
    const nlohmann::json json = nlohmann::json::parse(header);
    if (json.at("type") != "header") throw std::invalid_argument("this is no header of a trace");
    plan_path_ = json.at("path").get<std::string>();
    for (const nlohmann::json& file : json.at("files")) {
      texts_.emplace(file.at("path").get<std::string>(), file.at("text").get<std::string>());
    }
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(fmt::format("this is no header of a trace: {}", error.what()));
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
