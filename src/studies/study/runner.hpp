#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/syntax/source.hpp"
#include "src/studies/study/run_record.hpp"
#include "src/studies/study/study_model.hpp"

namespace rubicon::study {

/// A plan with the settings of a variant, ready to run.
struct LoadedVariant {
  std::unique_ptr<interpreter::PlanModel> plan;  ///< null if it cannot run
  interpreter::SourceMap sources;
  std::string fault;   ///< why it cannot run, for people
  std::string digest;  ///< of all that was read for it
};

struct RunnerOptions {
  int threads = 1;
  /// The number in the study of the first of these variants: all below counts from it.
  std::size_t first_variant = 0;
  /// Reads the plan with these settings. Called once for each variant, from several threads at a
  /// time.
  std::function<LoadedVariant(std::size_t variant)> load;
  /// Runs that are known already; they are not made again.
  std::vector<LoggedRun> known;
  /// Called for each new run, in no order, one call at a time; false ends the study.
  std::function<bool(const LoggedRun&)> on_run;
  /// Called when a variant has been read, one call at a time; false ends the study: what was known
  /// of it is of other files.
  std::function<bool(std::size_t variant, const LoadedVariant&)> on_load;
  /// How far it is: one call at a time.
  std::function<void(std::int64_t done, std::int64_t planned)> on_progress;
};

/// Makes all runs of a study. The result is the same whatever the number of threads and whatever
/// is known already. A variant that cannot run has a fault, and the others go on. Throws what a run
/// throws that is no fault of a plan (std::bad_alloc); nothing if
/// `on_load` or `on_run` ended it.
std::optional<std::vector<VariantRuns>> run_study(
    const StudyModel& study, const std::vector<interpreter::ParameterTexts>& variants,
    const RunnerOptions& options);

/// What the study asks for and this plan does not have, as errors (U11) at their places.
void check_names(const StudyModel& study, const interpreter::PlanModel& plan,
                 interpreter::Diagnostics& diagnostics);

}  // namespace rubicon::study
