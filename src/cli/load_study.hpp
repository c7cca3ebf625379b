#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "interpreter/syntax/diagnostic.hpp"
#include "interpreter/syntax/source.hpp"
#include "src/exchange/files/cached_files_io.hpp"
#include "src/studies/study/runner.hpp"
#include "src/studies/study/study_model.hpp"

namespace rubicon::cli {

/// A study that was read, with the files of its plan.
struct LoadedStudy {
  std::unique_ptr<study::StudyModel> model;
  std::vector<interpreter::ParameterTexts> variants;
  std::unique_ptr<files::CachedPlanFiles> files;
  std::string path;
  std::string text;                           ///< of the study itself
  std::optional<study::LoadedVariant> first;  ///< read to check the study: the first that can run
  std::size_t first_number = 0;               ///< of the variant that it is

  /// The files that were read so far, those of the plan by the paths that the user would type.
  std::set<std::string> read() const;
};

/// Reads a study, and with `look_at_plan` its plan with the settings of the first variant that can
/// run, which must have all that the study names. What is wrong goes to `diagnostics`; the model is
/// null then.
LoadedStudy load_study(const std::string& path, interpreter::SourceMap& sources,
                       interpreter::Diagnostics& diagnostics, bool look_at_plan = true);

/// The plan of a study with the settings of a variant; of each in one thread at a time.
study::LoadedVariant load_variant(LoadedStudy& study, std::size_t variant,
                                  const interpreter::ParameterTexts& set);

}  // namespace rubicon::cli
