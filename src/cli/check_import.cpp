#include "src/cli/check_import.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <unordered_map>
#include <variant>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/parse/parse.hpp"
#include "src/exchange/building_io/match_places.hpp"
#include "src/results/report/diagnostic_printer.hpp"

namespace rubicon::cli {

namespace {

using interpreter::FileFailure;

/// The disk as it will be: the plan and its own meshes come from memory.
class PlanFilesToBe : public interpreter::FileProvider {
 public:
  PlanFilesToBe(const PlanToCheck& plan, files::DiskFiles& disk) : plan_(plan), disk_(disk) {
    for (const auto& mesh : plan.building->meshes) {
      meshes_.emplace(interpreter::resolve_path(plan.path, mesh.name), mesh.mesh);
    }
  }

  std::variant<std::string, FileFailure> read_text(const std::string& path) override {
    if (path != plan_.path) return disk_.read_text(path);
    if (plan_.building->plan.size() > interpreter::kMaxTextBytes) {
      return FileFailure{
          fmt::format("the text is larger than {} MB", interpreter::kMaxTextBytes >> 20)};
    }
    return plan_.building->plan;
  }

  std::variant<std::shared_ptr<const geometry::TriangleMesh>, FileFailure> read_mesh(
      const interpreter::MeshRequest& request) override {
    const auto found = meshes_.find(request.path);
    if (found != meshes_.end()) return found->second;
    return disk_.read_mesh(request);
  }

 private:
  const PlanToCheck& plan_;
  files::DiskFiles& disk_;
  std::unordered_map<std::string, std::shared_ptr<const geometry::TriangleMesh>> meshes_;
};

}  // namespace

bool refused(const PlanToCheck& plan, interpreter::SourceMap& sources, files::DiskFiles& disk) {
  PlanFilesToBe files(plan, disk);
  const auto file = static_cast<interpreter::FileId>(sources.size());  // of the plan
  interpreter::Diagnostics diagnostics;
  interpreter::load_plan(plan.path, sources, files, diagnostics);
  if (!diagnostics.has_errors()) return false;
  std::vector<interpreter::Diagnostic> errors;
  for (const interpreter::Diagnostic& each : diagnostics.sorted()) {
    if (each.severity == interpreter::Severity::error) errors.push_back(each);
  }
  if (plan.match != nullptr && sources.size() > file) {
    errors = building_io::at_match_places(errors, *plan.match, *plan.building, file, sources);
  }
  fmt::print(stderr, "{}rubicon: error: the plan is not written: 'rubicon check' refuses it\n",
             report::print_text(errors, sources, files::wants_colour(stderr)));
  return true;
}

bool refused(const PlanToCheck& plan, files::DiskFiles& disk) {
  interpreter::SourceMap sources;
  return refused(plan, sources, disk);
}

}  // namespace rubicon::cli
