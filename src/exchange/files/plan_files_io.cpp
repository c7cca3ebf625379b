#include "src/exchange/files/plan_files_io.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

namespace rubicon::files {

namespace {

std::string real_name(const std::string& path) {
  std::error_code error;
  const std::filesystem::path file = std::filesystem::canonical(path, error);
  return error ? path.substr(path.rfind('/') + 1) : file.filename().string();
}

}  // namespace

PlanFiles::PlanFiles(std::string typed) : typed_(std::move(typed)), name_(real_name(typed_)) {}

std::string PlanFiles::typed(const std::string& path) const {
  return path == name_ ? typed_ : interpreter::resolve_path(typed_, path);
}

interpreter::SourceMap PlanFiles::typed(const interpreter::SourceMap& sources) const {
  interpreter::SourceMap result;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const interpreter::SourceFile& file = sources.file(static_cast<interpreter::FileId>(i));
    result.add(typed(file.path), file.text);
  }
  return result;
}

std::variant<std::string, interpreter::FileFailure> PlanFiles::read_text(const std::string& path) {
  return disk_.read_text(typed(path));
}

std::variant<std::shared_ptr<const geometry::TriangleMesh>, interpreter::FileFailure>
PlanFiles::read_mesh(const interpreter::MeshRequest& request) {
  interpreter::MeshRequest wanted = request;
  wanted.path = typed(request.path);
  wanted.folder = interpreter::resolve_path(typed_, request.folder);
  return disk_.read_mesh(wanted);
}

}  // namespace rubicon::files
