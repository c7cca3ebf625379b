#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "src/studies/statistics/interval.hpp"
#include "src/studies/statistics/mean.hpp"
#include "src/studies/study/run_record.hpp"
#include "src/studies/study/study_model.hpp"

namespace rubicon::study {

/// The quantiles of every answer.
inline constexpr double kQuantiles[] = {0.1, 0.5, 0.8, 0.95};
/// What drives the time is looked for in so many of the first runs.
inline constexpr std::size_t kRunsForDrivers = 2000;

struct QuantileAnswer {
  double p = 0;
  double value = 0;  ///< infinite: never
  statistics::Interval interval;
  std::int64_t run = 0;  ///< the first with this value
};

/// One question, answered by the runs of one variant.
struct Answer {
  bool there = false;     ///< the plan has what is asked for
  statistics::Mean mean;  ///< of the runs that finished
  double least = 0;       ///< of these
  double most = 0;
  std::vector<QuantileAnswer> quantiles;  ///< of all runs, by kQuantiles
  /// This less the first variant that runs, run by run, over the runs that finished in both; of no
  /// count of that variant itself.
  statistics::Mean difference;
};

/// A task and the share of the finished runs in which it was on the critical path.
struct TaskShare {
  std::string task;
  std::int64_t runs = 0;
  double share = 0;
};

/// How a duration drives the process time.
struct Driver {
  std::string place;       ///< "set_3.hook"
  double correlation = 0;  ///< Spearman's, with the process time
  /// Mean process time (s) of the tenth of the runs in which it was least, and greatest; equal
  /// where there are fewer than 20 runs.
  double low = 0;
  double high = 0;
};

struct TaskRejection {
  std::string task;
  std::int64_t runs = 0;
  std::int64_t first_run = 0;
  std::string reason;
};

/// When which share of the work is done, by its quantiles over the runs (s).
struct ProgressBand {
  std::vector<double> p10, p50, p90;
};

struct VariantAnswers {
  std::int64_t runs = 0;
  std::int64_t unfinished = 0;      ///< runs in which something was rejected
  std::vector<Answer> answers;      ///< by question
  std::vector<TaskShare> critical;  ///< most often first
  /// The strongest first; without those whose correlation is no more than chance (3 standard
  /// deviations).
  std::vector<Driver> drivers;
  std::vector<TaskRejection> rejections;
  std::optional<ProgressBand> progress;
  /// Process times in bins of equal width from the least to the greatest; empty if all are equal.
  std::vector<std::int64_t> histogram;

  double rejected_share() const {
    return runs == 0 ? 0 : static_cast<double>(unfinished) / static_cast<double>(runs);
  }
};

/// What a rule chose.
struct ChoiceAnswer {
  std::optional<std::size_t> chosen;  ///< the first of those that are as good as the best
  std::vector<std::size_t> equal;     ///< these, the chosen one among them
  struct Passed {
    std::size_t variant = 0;
    std::string why;
  };
  std::vector<Passed> passed;  ///< over
  struct Difference {
    std::size_t variant = 0;
    double value = 0;                              ///< of the statistic
    std::optional<statistics::Interval> interval;  ///< of its difference to the best
  };
  std::vector<Difference> judged;
};

/// A run whose result, with its animation, is kept.
struct KeptRun {
  std::size_t variant = 0;
  std::int64_t run = 0;
  std::string folder;  ///< in that of the study
};

struct StudyAnswers {
  std::vector<VariantAnswers> variants;
  std::vector<std::size_t> pareto;  ///< of mean process time and cost, by time
  std::optional<ChoiceAnswer> choice;
  std::vector<KeptRun> kept;  ///< whoever keeps runs fills it
};

/// What the runs of a study say. `variants` as run_study gives them.
StudyAnswers answers_of(const StudyModel& study, const std::vector<VariantRuns>& variants);

/// The runs that are worth looking at, each once: of the chosen variant those at the quantiles of
/// the process time, of the others of the Pareto front that at the median; where nothing is drawn
/// the one run of each. Of no choice and no front, of the first variant that runs.
std::vector<KeptRun> runs_to_keep(const StudyModel& study, const std::vector<VariantRuns>& variants,
                                  const StudyAnswers& answers);

}  // namespace rubicon::study
