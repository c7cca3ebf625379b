#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <variant>
#include <vector>

#include "interpreter/check/check.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/fail.hpp"
#include "src/cli/input_file.hpp"
#include "src/exchange/files/atomic_file_io.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/exchange/files/temporaries_io.hpp"
#include "src/exchange/mesh_io/mesh_io.hpp"
#include "src/exchange/project_io/decode_text.hpp"
#include "src/exchange/urdf/guarded_import_io.hpp"
#include "src/exchange/urdf/package_folders_io.hpp"
#include "src/exchange/urdf/scaled_mesh.hpp"
#include "src/results/report/diagnostic_printer.hpp"

namespace rubicon::cli {

namespace {

namespace fs = std::filesystem;
using interpreter::FileFailure;

/// NAME=VALUE of several options; the message of the first that is wrong.
std::variant<std::map<std::string, std::string>, std::string> pairs(
    const std::vector<std::string>& options, const char* form) {
  std::map<std::string, std::string> result;
  for (const std::string& each : options) {
    const std::size_t sign = each.find('=');
    if (sign == std::string::npos || sign == 0) {
      return fmt::format("expected {}, found '{}'", form, each);
    }
    result[each.substr(0, sign)] = each.substr(sign + 1);
  }
  return result;
}

/// The disk as it will be: the robot file comes from memory, its meshes from where they are copied.
class MachineFilesToBe : public interpreter::FileProvider {
 public:
  MachineFilesToBe(std::string path, const urdf::MachineImport& machine, files::DiskFiles& disk)
      : path_(std::move(path)), machine_(machine), disk_(disk) {
    for (const urdf::MeshCopy& each : machine.meshes) {
      meshes_[interpreter::resolve_path(path_, each.target)] = &each;
    }
  }

  std::variant<std::string, FileFailure> read_text(const std::string& path) override {
    return path == path_ ? machine_.robot : disk_.read_text(path);
  }

  std::variant<std::shared_ptr<const geometry::TriangleMesh>, FileFailure> read_mesh(
      const interpreter::MeshRequest& request) override {
    const auto found = meshes_.find(request.path);
    if (found == meshes_.end()) return disk_.read_mesh(request);
    const urdf::MeshCopy& copy = *found->second;
    interpreter::MeshRequest there = request;
    there.path = copy.source;
    there.folder = copy.folder;
    // A mesh that will be scaled is read as its own file says.
    if (copy.scale) {
      there.metres_per_unit = mesh_io::needs_unit(copy.source) ? 1 : 0;
      there.up = 'z';
    }
    return disk_.read_mesh(there);
  }

 private:
  std::string path_;
  const urdf::MachineImport& machine_;
  files::DiskFiles& disk_;
  std::map<std::string, const urdf::MeshCopy*> meshes_;
};

/// One run of `rubicon import` on a machine.
class MachineFiles {
 public:
  explicit MachineFiles(const ImportOptions& options)
      : options_(options), out_(options.out.empty() ? "machine.robot" : options.out) {}

  int run() {
    const auto packages = pairs(options_.packages, "--package NAME=FOLDER");
    const auto arguments = pairs(options_.arguments, "--arg NAME=VALUE");
    for (const auto* each : {&packages, &arguments}) {
      if (const auto* message = std::get_if<std::string>(each)) return fail(*message);
    }
    const std::set<std::string> inputs(options_.files.begin(), options_.files.end());
    if (const auto mistake = overwriting(inputs, {options_.out})) return fail(*mistake);
    // A description includes others, which only its reader knows.
    for (const char* ending : {".urdf", ".xacro"}) {
      if (options_.out.ends_with(ending)) {
        return fail(
            fmt::format("--out takes the robot file to write, such as machine.robot, found '{}'",
                        options_.out));
      }
    }
    const auto machine = read(std::get<0>(packages), std::get<0>(arguments));
    if (!machine || refused(*machine)) return kWrongInput;
    if (!options_.out.empty()) return write(*machine);
    if (!machine->meshes.empty()) {
      return fail(fmt::format("{} meshes are to lie beside the robot file; give --out",
                              machine->meshes.size()));
    }
    std::fwrite(machine->robot.data(), 1, machine->robot.size(), stdout);
    return kFine;
  }

 private:
  /// Says what there is to say; nothing after an error.
  std::optional<urdf::MachineImport> read(const std::map<std::string, std::string>& packages,
                                          const std::map<std::string, std::string>& arguments) {
    const std::string& path = options_.files.front();
    urdf::PackageFolders folders(path, packages);
    if (!folders.missing_package().empty()) {
      fail(fmt::format("expected a folder behind --package NAME=, found '{}'",
                       folders.missing_package()));
      return std::nullopt;
    }
    const auto bytes = folders.read_text(path);
    if (const auto* failure = std::get_if<urdf::PackageFailure>(&bytes)) {
      fail(failure->message);
      return std::nullopt;
    }
    urdf::MachineTerms terms;
    terms.path = path;
    terms.arguments = arguments;
    terms.tool = options_.tool;
    terms.meshes = fs::path(out_).stem().string() + "_meshes";
    const bool colour = files::wants_colour(stderr);
    auto import = urdf::import_guarded(
        terms, project_io::decode_text(std::get<std::string>(bytes)).text, folders,
        [colour](const interpreter::Diagnostics& diagnostics,
                 const interpreter::SourceMap& sources) {
          return report::print_text(diagnostics.sorted(), sources, colour);
        });
    if (const auto* message = std::get_if<std::string>(&import)) {
      fail(fmt::format("'{}': {}", path, *message));
      return std::nullopt;
    }
    auto& result = std::get<urdf::GuardedImport>(import);
    std::fwrite(result.messages.data(), 1, result.messages.size(), stderr);
    return std::move(result.machine);
  }

  /// Whether `rubicon check` would refuse the robot file; says why.
  bool refused(const urdf::MachineImport& machine) {
    MachineFilesToBe files(out_, machine, disk_);
    interpreter::SourceMap sources;
    interpreter::Diagnostics diagnostics;
    interpreter::load_robot(out_, sources, files, nullptr, diagnostics);
    if (!diagnostics.has_errors()) return false;
    std::vector<interpreter::Diagnostic> errors;
    for (const interpreter::Diagnostic& each : diagnostics.sorted()) {
      if (each.severity == interpreter::Severity::error) errors.push_back(each);
    }
    fmt::print(stderr, "{}rubicon: error: the robot is not written: 'rubicon check' refuses it\n",
               report::print_text(errors, sources, files::wants_colour(stderr)));
    return true;
  }

  /// Whether a mesh lies where it is to be copied, and as it is to be.
  static bool is_there(const urdf::MeshCopy& mesh, const std::string& base) {
    std::error_code error;
    return !mesh.scale && fs::equivalent(mesh.source, base + mesh.target, error);
  }

  /// The robot file last: when it is there, all it needs is.
  int write(const urdf::MachineImport& machine) {
    const std::string folder = fs::path(out_).parent_path().string();
    const std::string base = folder.empty() ? "" : folder + "/";
    std::set<std::string> inputs(options_.files.begin(), options_.files.end());
    std::vector<std::string> outputs = {out_};
    for (const urdf::MeshCopy& each : machine.meshes) {
      if (is_there(each, base)) continue;
      inputs.insert(each.source);
      outputs.push_back(base + each.target);
    }
    if (const auto mistake = overwriting(inputs, outputs)) return fail(*mistake);
    const files::SignalHold hold;  // all of them or none
    if (!machine.meshes.empty()) {
      const std::string first = machine.meshes.front().target;
      if (const auto failure = files::make_folder(base + first.substr(0, first.find('/')))) {
        return fail(*failure);
      }
    }
    for (const urdf::MeshCopy& each : machine.meshes) {
      if (is_there(each, base)) continue;
      const auto bytes = bytes_of(each);
      if (const auto* failure = std::get_if<FileFailure>(&bytes)) {
        return fail(fmt::format("mesh '{}': {}", each.source, failure->message));
      }
      if (const auto failure =
              files::write_file(base + each.target, std::get<std::string>(bytes))) {
        return fail(*failure);
      }
    }
    if (const auto failure = files::write_file(out_, machine.robot)) return fail(*failure);
    return kFine;
  }

  std::variant<std::string, FileFailure> bytes_of(const urdf::MeshCopy& copy) {
    if (!copy.scale) return disk_.read_text(copy.source);
    interpreter::MeshRequest request;
    request.path = copy.source;
    request.folder = copy.folder;
    request.metres_per_unit = mesh_io::needs_unit(copy.source) ? 1 : 0;
    request.up = 'z';
    const auto mesh = disk_.read_mesh(request);
    if (const auto* failure = std::get_if<FileFailure>(&mesh)) return *failure;
    return urdf::scaled_mesh_text(*std::get<0>(mesh), *copy.scale);
  }

  const ImportOptions& options_;
  std::string out_;  ///< the robot file
  files::DiskFiles disk_;
};

}  // namespace

int import_machine(const ImportOptions& options) { return MachineFiles(options).run(); }

}  // namespace rubicon::cli
