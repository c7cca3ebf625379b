#pragma once

#include <string>
#include <vector>

#include "src/studies/answers/study_answers.hpp"

namespace rubicon::study {

/// For people: what was asked, by variant; what drives the time; what was rejected; the choice.
std::string study_table(const StudyModel& study, const std::vector<VariantRuns>& variants,
                        const StudyAnswers& answers);

/// A row a variant: its settings, then mean, deviation and quantiles of each question (times in s).
std::string variants_csv(const StudyModel& study, const std::vector<VariantRuns>& variants,
                         const StudyAnswers& answers);
/// A row for each variant and each duration that drives its time (times in s).
std::string drivers_csv(const std::vector<VariantRuns>& variants, const StudyAnswers& answers);
/// A row for each variant and each share of its work: when it is done (s).
std::string progress_csv(const std::vector<VariantRuns>& variants, const StudyAnswers& answers);
/// A row a run: variant, settings, seed, run, then each question (times in s; "never" of a run in
/// which something was rejected).
std::string runs_csv(const StudyModel& study, const std::vector<VariantRuns>& variants);

/// Everything (docs/studies.md).
std::string study_json(const StudyModel& study, const std::vector<VariantRuns>& variants,
                       const StudyAnswers& answers);

}  // namespace rubicon::study
