#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include "src/cli/check_import.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/fail.hpp"
#include "src/cli/import_schedule.hpp"
#include "src/cli/input_file.hpp"
#include "src/cli/length_option.hpp"
#include "src/exchange/area_io/storey_floor.hpp"
#include "src/exchange/building_io/building_plan.hpp"
#include "src/exchange/building_io/match_file.hpp"
#include "src/exchange/building_io/names.hpp"
#include "src/exchange/building_io/read_elements.hpp"
#include "src/exchange/files/atomic_file_io.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/exchange/files/temporaries_io.hpp"
#include "src/exchange/mesh_io/mesh_format.hpp"
#include "src/exchange/mesh_io/mesh_io.hpp"
#include "src/results/report/diagnostic_printer.hpp"

namespace rubicon::cli {

namespace {

namespace fs = std::filesystem;

/// One run of `rubicon import` on models.
class BuildingImport {
 public:
  explicit BuildingImport(const ImportOptions& options) : options_(options) {
    const fs::path out = options.out.empty() ? fs::path("building.plan") : fs::path(options.out);
    folder_ = out.parent_path().empty() ? "." : out.parent_path().string();
    // A floor names no model, so these may lie anywhere.
    if (options_.area) folder_ = "/";
    stem_ = building_io::clean(out.stem().string());
    std::replace(stem_.begin(), stem_.end(), '"', '_');  // the plan quotes it
  }

  int run() {
    if (options_.schedule.empty() != options_.match.empty()) {
      return fail("--schedule and --match go together: the match file joins elements to tasks");
    }
    constexpr double kMostTolerance = 1;  // m
    if (const auto wrong =
            take_length("--tolerance", options_.tolerance, 1e-4, kMostTolerance, tolerance_)) {
      return fail(*wrong);
    }
    std::vector<std::string> outputs = {options_.out};
    if (!options_.out.empty() && !options_.area) outputs.push_back(table());
    if (const auto mistake = overwriting(inputs(), outputs)) return fail(*mistake);
    const std::optional<building_io::BuildingPlan> plan = make_plan();
    const std::string messages =
        report::print_text(diagnostics_.sorted(), sources_, files::wants_colour(stderr));
    std::fwrite(messages.data(), 1, messages.size(), stderr);
    if (!plan || diagnostics_.has_errors()) return kWrongInput;
    const std::string path = options_.out.empty() ? "building.plan" : options_.out;
    if (refused({path, &*plan, match_ ? &*match_ : nullptr}, sources_, disk_)) {
      return kWrongInput;
    }
    return options_.out.empty() ? print(*plan) : write(*plan);
  }

 private:
  std::set<std::string> inputs() const {
    std::set<std::string> result(options_.files.begin(), options_.files.end());
    result.insert({options_.schedule, options_.match});
    return result;
  }
  /// The list of elements that goes beside the plan.
  std::string table() const { return folder_ + "/" + stem_ + "_elements.csv"; }

  std::optional<building_io::BuildingPlan> make_plan() {
    std::vector<building_io::ModelFile>& models = models_;
    for (const std::string& path : options_.files) {
      if (auto model = read_model(path)) models.push_back(std::move(*model));
    }
    if (diagnostics_.has_errors()) return std::nullopt;
    building_io::ModelTerms terms;
    terms.folder = folder_;
    terms.keep_meshes = options_.area.has_value();
    terms.unit = options_.unit;
    terms.up = options_.up.empty() ? '\0' : options_.up.front();
    const building_io::Elements elements =
        building_io::read_elements(models, terms, disk_.meshes(), diagnostics_);
    if (diagnostics_.has_errors()) return std::nullopt;
    if (options_.area) return make_floors(elements);
    building_io::PlanNames names{stem_, stem_ + "_meshes"};
    if (options_.match.empty()) return building_io::standing_building(elements, names);
    return make_work(elements, names);
  }

  /// The floors of a storey.
  std::optional<building_io::BuildingPlan> make_floors(const building_io::Elements& elements) {
    std::vector<std::string> made;
    const auto areas =
        area_io::floors_of_storey(elements, {*options_.area, tolerance_}, made, diagnostics_);
    if (diagnostics_.has_errors()) return std::nullopt;
    area_io::AreaTerms head;
    head.name = options_.out.empty() ? "floor " + *options_.area : stem_;
    for (const building_io::ModelFile& model : models_) {
      head.notes.push_back(fs::path(model.path).filename().string());
    }
    head.notes.insert(head.notes.end(), made.begin(), made.end());
    if (elements.origin != building_io::Vec3::Zero()) {
      head.notes.push_back(
          fmt::format("The point {}, {}, {} of the model is the origin of this plan",
                      elements.origin.x(), elements.origin.y(), elements.origin.z()));
    }
    building_io::BuildingPlan plan;
    plan.plan = area_io::area_text(areas, head);
    return plan;
  }

  std::optional<building_io::BuildingPlan> make_work(const building_io::Elements& elements,
                                                     const building_io::PlanNames& names) {
    const auto project = read_schedule(options_.schedule, disk_, sources_, diagnostics_);
    const auto text = disk_.read_text(options_.match);
    if (const auto* failure = std::get_if<interpreter::FileFailure>(&text)) {
      diagnostics_.error("F01", {}, fmt::format("'{}': {}", options_.match, failure->message));
      return std::nullopt;
    }
    match_ = building_io::read_match_file(
        sources_, sources_.add(options_.match, std::get<std::string>(text)), diagnostics_);
    if (!project || diagnostics_.has_errors()) return std::nullopt;
    building_io::BuildingTasks tasks;
    tasks.project = &*project;
    tasks.schedule = building_io::clean(fs::path(options_.schedule).filename().string());
    tasks.match = &*match_;
    if (options_.baseline) tasks.baselines = project_io::Baselines::written;
    if (options_.level) {
      tasks.levelling = project_io::Levelling::resources;
      tell_levelling(*project);
    }
    return building_io::building_under_work(elements, tasks, names, diagnostics_);
  }

  /// A model with the name that the plan will give it.
  std::optional<building_io::ModelFile> read_model(const std::string& path) {
    const auto wrong = [&](const std::string& message, const std::string& hint) {
      diagnostics_.error("I11", {}, fmt::format("model '{}' {}", path, message), hint);
      return std::nullopt;
    };
    std::error_code error;
    const fs::path file = fs::canonical(path, error);
    if (error) return wrong("cannot be read: " + error.message(), "");
    const fs::path folder = fs::canonical(folder_, error);
    if (error) return wrong(fmt::format("has no folder '{}' to go with", folder_), "");
    building_io::ModelFile model;
    model.path = path;
    model.reference = file.lexically_relative(folder).string();
    if (model.reference.empty() || model.reference.starts_with("..")) {
      return wrong("lies outside the folder of the plan",
                   "write the plan (--out) into the folder of its models, or copy them there");
    }
    const auto format = mesh_io::format_of(model.reference);
    if (!format || format->name != mesh_io::format_of(path)->name) {
      return wrong(
          fmt::format("is a link to '{}', whose name says another format", model.reference),
          "name the file itself");
    }
    if (!building_io::can_be_quoted(model.reference)) {
      return wrong("has a name that a plan cannot hold", "rename it");
    }
    if (mesh_io::format_of(path)->name == "IFC") {
      auto text = disk_.read_text(path);
      if (const auto* failure = std::get_if<interpreter::FileFailure>(&text)) {
        return wrong("cannot be read: " + failure->message, "");
      }
      model.text = std::get<std::string>(std::move(text));
    }
    if (mesh_io::needs_unit(path) && options_.unit.empty()) {
      return wrong("says no unit", "give --unit mm, cm or m");
    }
    return model;
  }

  static int print(const building_io::BuildingPlan& plan) {
    if (!plan.meshes.empty()) {
      return fail(
          fmt::format("{} elements need mesh files of their own beside the plan; give --out",
                      plan.meshes.size()));
    }
    std::fwrite(plan.plan.data(), 1, plan.plan.size(), stdout);
    return kFine;
  }

  /// The plan last: when it is there, all it needs is.
  int write(const building_io::BuildingPlan& plan) const {
    const files::SignalHold hold;  // all of them or none
    const std::string base = folder_ + "/";
    std::vector<std::string> outputs;
    for (const auto& mesh : plan.meshes) outputs.push_back(base + mesh.name);
    if (const auto mistake = overwriting(inputs(), outputs)) return fail(*mistake);
    if (!plan.meshes.empty()) {
      if (const auto failure = files::make_folder(base + stem_ + "_meshes")) return fail(*failure);
    }
    for (const auto& mesh : plan.meshes) {
      if (const auto failure = files::write_file(base + mesh.name, mesh.text)) {
        return fail(*failure);
      }
    }
    if (options_.area) return finish(plan);
    if (const auto failure = files::write_file(table(), plan.elements)) return fail(*failure);
    return finish(plan);
  }
  int finish(const building_io::BuildingPlan& plan) const {
    if (const auto failure = files::write_file(options_.out, plan.plan)) return fail(*failure);
    return kFine;
  }

  const ImportOptions& options_;
  double tolerance_ = area_io::StoreyTerms{}.tolerance;  ///< m, of floors
  std::vector<building_io::ModelFile> models_;
  std::optional<building_io::MatchFile> match_;
  std::string folder_;  ///< of the plan
  std::string stem_;    ///< its name without ending
  files::DiskFiles disk_;
  interpreter::SourceMap sources_;
  interpreter::Diagnostics diagnostics_;
};

}  // namespace

int import_building(const ImportOptions& options) { return BuildingImport(options).run(); }

}  // namespace rubicon::cli
