#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/studies/study/run_record.hpp"
#include "src/studies/study/study_model.hpp"
#include "src/studies/study/work.hpp"

namespace rubicon::study {

struct RunnerOptions {
  int threads = 1;
  /// Others that work too; null: there are none.
  RemoteWorkers* remote = nullptr;
  /// The number in the study of the first of these variants: all below counts from it.
  std::size_t first_variant = 0;
  VariantReader read;
  /// Runs that are known already; they are not made again.
  std::vector<LoggedRun> known;
  /// Called for each new run, in no order, one call at a time; false ends the study.
  std::function<bool(const LoggedRun&)> on_run;
  /// Called with the digest of what was read for a variant, one call at a time; false ends the
  /// study: what was known of it is of other files.
  std::function<bool(std::size_t variant, const std::string& digest)> on_load;
  /// How far it is: one call at a time.
  std::function<void(std::int64_t done, std::int64_t planned)> on_progress;
};

/// Makes all runs of a study. The result is the same whoever makes them and whatever
/// is known already. A variant that cannot run has a fault, and the others go on. Throws what a run
/// throws that is no fault of a plan (std::bad_alloc); nothing if
/// `on_load` or `on_run` ended it, or remote workers could not go on.
std::optional<std::vector<VariantRuns>> run_study(
    const StudyModel& study, const std::vector<interpreter::ParameterTexts>& variants,
    const RunnerOptions& options);

/// What the study asks for and this plan does not have, as errors (U11) at their places.
void check_names(const StudyModel& study, const interpreter::PlanModel& plan,
                 interpreter::Diagnostics& diagnostics);

}  // namespace rubicon::study
