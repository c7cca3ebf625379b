#include "src/cli/load_study.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "interpreter/parse/parse.hpp"
#include "src/cli/load_runnable_plan.hpp"
#include "src/exchange/files/disk_io.hpp"
#include "src/studies/study/runner.hpp"

namespace rubicon::cli {

namespace {

/// The variable whose setting a message is about; null if it is about none.
const study::Variable* variable_of(const study::StudyModel& study, const std::string& message) {
  for (const study::Variable& each : study.variables) {
    if (message.starts_with("--set " + each.name + "=")) return &each;
  }
  return nullptr;
}

/// What is wrong with the plan, told of the study's `plan` clause: with the first variant, which
/// nobody typed, a place in the plan alone would not be understood.
void check_first_variant(LoadedStudy& study, interpreter::Diagnostics& diagnostics) {
  interpreter::SourceMap sources;
  const files::PlanFiles& files = study.files->plan_files();
  ReadPlan read;
  try {
    read = read_runnable_plan(files.plan(), *study.files, sources, study.variants.front());
  } catch (const std::invalid_argument& error) {
    diagnostics.error("U12", study.model->plan_span, error.what());
    return;
  }
  if (read.plan) {
    check_names(*study.model, *read.plan, diagnostics);
    return;
  }
  const interpreter::SourceMap typed = files.typed(sources);
  for (const interpreter::Diagnostic& each : read.found) {
    if (each.severity != interpreter::Severity::error) continue;
    if (const auto* variable = variable_of(*study.model, each.message)) {
      diagnostics.error("U04", variable->span, each.message.substr(each.message.find(": ") + 2));
      continue;
    }
    std::string place;
    if (each.span.file < typed.size()) {
      const auto at = typed.position(each.span);
      place = fmt::format("{}:{}:{}: ", typed.file(each.span.file).path, at.line, at.column);
    }
    diagnostics.error(
        "U12", study.model->plan_span,
        fmt::format("the plan cannot run with the first values: {}{}", place, each.message));
  }
}

}  // namespace

LoadedStudy load_study(const std::string& path, interpreter::SourceMap& sources,
                       interpreter::Diagnostics& diagnostics) {
  LoadedStudy result;
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
  check_first_variant(result, diagnostics);
  if (diagnostics.errors() != before) result.model.reset();
  return result;
}

}  // namespace rubicon::cli
