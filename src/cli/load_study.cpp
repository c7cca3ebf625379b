#include "src/cli/load_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <stdexcept>
#include <utility>

#include "interpreter/parse/parse.hpp"
#include "src/cli/load_runnable_plan.hpp"
#include "src/exchange/encoding/sha256.hpp"
#include "src/exchange/files/disk_io.hpp"

namespace rubicon::cli {

namespace {

/// The variable whose setting a message is about; null if it is about none.
const study::Variable* variable_of(const study::StudyModel& study, const std::string& message) {
  for (const study::Variable& each : study.variables) {
    if (message.starts_with("--set " + each.name + "=")) return &each;
  }
  return nullptr;
}

/// "file:line:column: " of what is said; "" where it has no place.
std::string place_text(const interpreter::SourceMap& sources, const interpreter::Span& span) {
  if (span.file >= sources.size()) return {};
  const auto at = sources.position(span);
  return fmt::format("{}:{}:{}: ", sources.file(span.file).path, at.line, at.column);
}

/// The files of a plan, and the meshes that were asked for.
class NotedFiles : public interpreter::FileProvider {
 public:
  explicit NotedFiles(files::CachedPlanFiles& files) : files_(files) {}

  std::variant<std::string, interpreter::FileFailure> read_text(const std::string& path) override {
    return files_.read_text(path);
  }

  std::variant<std::shared_ptr<const geometry::TriangleMesh>, interpreter::FileFailure> read_mesh(
      const interpreter::MeshRequest& request) override {
    digests_.insert(files_.mesh_digest(request));
    return files_.read_mesh(request);
  }

  /// Of all meshes, in one order whoever asked first.
  const std::set<std::string>& mesh_digests() const { return digests_; }

 private:
  files::CachedPlanFiles& files_;
  std::set<std::string> digests_;
};

std::string digest_of(const interpreter::SourceMap& sources, const NotedFiles& files) {
  std::string all;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto& file = sources.file(static_cast<interpreter::FileId>(i));
    all += fmt::format("{}\n{}\n", file.path, encoding::sha256_hex(file.text));
  }
  for (const std::string& mesh : files.mesh_digests()) all += mesh + '\n';
  return encoding::sha256_hex(all);
}

struct ReadVariant {
  study::LoadedVariant loaded;
  std::vector<interpreter::Diagnostic> errors;
};

ReadVariant read_variant(const LoadedStudy& study, const interpreter::ParameterTexts& set) {
  ReadVariant result;
  study::LoadedVariant& loaded = result.loaded;
  NotedFiles files(*study.files);
  try {
    ReadPlan read =
        read_runnable_plan(study.files->plan_files().plan(), files, loaded.sources, set);
    loaded.plan = std::move(read.plan);
    std::copy_if(read.found.begin(), read.found.end(), std::back_inserter(result.errors),
                 [](const interpreter::Diagnostic& each) {
                   return each.severity == interpreter::Severity::error;
                 });
    if (!result.errors.empty()) {
      const interpreter::Diagnostic& first = result.errors.front();
      loaded.fault = place_text(loaded.sources, first.span) + first.message;
    }
  } catch (const std::invalid_argument& error) {
    loaded.fault = error.what();
  }
  loaded.digest = digest_of(loaded.sources, files);
  return result;
}

/// So many variants are read until one can run: where none of these can it is the plan.
constexpr std::size_t kMostTriedFirst = 16;

/// Tells of a variant that cannot run at the study's `plan` clause: a place in the plan alone, with
/// values that nobody typed, would not be understood.
void tell_fault(const LoadedStudy& study, const ReadVariant& read,
                interpreter::Diagnostics& diagnostics) {
  if (read.errors.empty()) diagnostics.error("U12", study.model->plan_span, read.loaded.fault);
  const interpreter::SourceMap typed = study.files->plan_files().typed(read.loaded.sources);
  for (const interpreter::Diagnostic& each : read.errors) {
    if (const auto* variable = variable_of(*study.model, each.message)) {
      diagnostics.error("U04", variable->span, each.message.substr(each.message.find(": ") + 2));
      continue;
    }
    diagnostics.error("U12", study.model->plan_span,
                      fmt::format("the plan cannot run with the first values: {}{}",
                                  place_text(typed, each.span), each.message));
  }
}

/// Whether a variant cannot run because of a setting that the plan does not know: a slip of the
/// study.
bool has_wrong_setting(const LoadedStudy& study, const ReadVariant& read) {
  return std::any_of(read.errors.begin(), read.errors.end(),
                     [&](const interpreter::Diagnostic& each) {
                       return variable_of(*study.model, each.message) != nullptr;
                     });
}

/// Looks at the first variant that can run. Those before it are told with the others, when all
/// have run; where none can, what is wrong with the first.
void check_first_variant(LoadedStudy& study, interpreter::Diagnostics& diagnostics) {
  const std::size_t most = std::min(study.variants.size(), kMostTriedFirst);
  std::optional<ReadVariant> failed;
  for (std::size_t i = 0; i < most; ++i) {
    ReadVariant read = read_variant(study, study.variants[i]);
    if (read.loaded.plan) {
      check_names(*study.model, *read.loaded.plan, diagnostics);
      study.first = std::move(read.loaded);
      study.first_number = i;
      return;
    }
    const bool slip = has_wrong_setting(study, read);
    if (!failed) failed = std::move(read);
    if (slip) break;
  }
  tell_fault(study, *failed, diagnostics);
}

}  // namespace

std::set<std::string> LoadedStudy::read() const {
  std::set<std::string> result = {path};
  if (files) result.insert(files->plan_files().read().begin(), files->plan_files().read().end());
  return result;
}

LoadedStudy load_study(const std::string& path, interpreter::SourceMap& sources,
                       interpreter::Diagnostics& diagnostics, bool look_at_plan) {
  LoadedStudy result;
  result.path = path;
  files::DiskFiles disk;
  auto text = disk.read_text(path);
  if (const auto* failure = std::get_if<interpreter::FileFailure>(&text)) {
    diagnostics.error("F01", {}, fmt::format("'{}': {}", path, failure->message));
    return result;
  }
  result.text = std::get<std::string>(text);
  const interpreter::FileId file = sources.add(path, std::get<std::string>(std::move(text)));
  const int before = diagnostics.errors();
  result.model = study::check_study(parse_study(sources, file, diagnostics), diagnostics);
  if (!result.model) return result;
  result.variants = variants_of(*result.model);
  result.files =
      std::make_unique<files::CachedPlanFiles>(interpreter::resolve_path(path, result.model->plan));
  if (look_at_plan) check_first_variant(result, diagnostics);
  if (diagnostics.errors() != before) result.model.reset();
  return result;
}

study::LoadedVariant load_variant(LoadedStudy& study, std::size_t variant,
                                  const interpreter::ParameterTexts& set) {
  if (study.first && variant == study.first_number) {
    study::LoadedVariant first = *std::move(study.first);
    study.first.reset();
    return first;
  }
  return read_variant(study, set).loaded;
}

}  // namespace rubicon::cli
