#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "src/studies/study/run_record.hpp"
#include "src/studies/study/study_model.hpp"

namespace rubicon::study {

/// The first questions of every study.
inline constexpr std::size_t kMakespan = 0;
inline constexpr std::size_t kCost = 1;

/// How a variant stands by a rule.
struct Judgement {
  std::string why_not;  ///< it may not be chosen; "" if it may
  double value = 0;     ///< of the rule's statistic, if it may be chosen
  /// If it may not, how far it is from that, to tell which of two is nearer: below 1 its limits are
  /// not met, below 2 tasks are rejected, then what is asked is not known; 3: it cannot run.
  double shortfall = 0;
};

/// Judges the runs of a variant. One with rejections is passed over unless a limit of the rule
/// speaks of them.
Judgement judge(const StudyModel& study, const Choice& rule, const VariantRuns& variant);

/// A statistic of a variant that has runs; nothing where the plan has no such thing, as a cost
/// where nothing costs.
std::optional<double> measured(const Statistic& statistic, const VariantRuns& variant);

}  // namespace rubicon::study
