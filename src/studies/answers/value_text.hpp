#pragma once

#include <string>

#include "src/studies/study/run_record.hpp"
#include "src/studies/study/study_model.hpp"

namespace rubicon::study {

/// A number as people write it: h:mm:ss, a date where the plan has dates, money to the cent, a
/// share in %; "never", "-" of what is not there.
std::string value_text(Unit unit, double value, const VariantRuns& variant);

/// A width or an interval of it: a moment's is a time.
std::string value_text(const StudyModel& study, const Statistic& statistic, double value,
                       const VariantRuns& variant);

/// "bays 4, crane tower_crane"; "as the plan says" of no settings.
std::string settings_text(const interpreter::ParameterTexts& set);

/// The command that makes one run of a variant again.
std::string run_command(const StudyModel& study, const VariantRuns& variant, std::int64_t run);

}  // namespace rubicon::study
