#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/simulation/taskplan/schedule.hpp"
#include "src/studies/study/study_model.hpp"

namespace rubicon::study {

/// Points of a progress curve: when 0, 5, ... 100 % of the cost is spent (of the tasks are done,
/// where nothing costs).
inline constexpr std::size_t kCurvePoints = 21;
/// Of so many runs of a variant the curves are kept.
inline constexpr std::int64_t kCurves = 200;

/// What is kept of one run.
struct RunRecord {
  std::vector<double> values;  ///< by question; infinite: never; NaN: the plan has no such thing
  std::vector<int> critical;   ///< tasks of the plan on the critical path, ascending
  std::vector<double> curve;   ///< kCurvePoints times (s); empty if anything was rejected
  std::vector<int> rejected;   ///< tasks of the plan that were rejected, ascending
  std::string reason;          ///< of the first of these

  bool operator==(const RunRecord&) const = default;
};

/// A run in which anything is rejected or not reached never finishes: it has no value but of
/// `rejected`, which is 1, and else 0.
RunRecord record_of(const StudyModel& study, const interpreter::PlanModel& plan,
                    const taskplan::Schedule& schedule, bool with_curve);

/// A duration of the plan that is drawn.
struct UncertainPlace {
  std::string place;  ///< "set_3.hook"
  sampling::DurationLaw law;
};

/// What is known of a variant before its first run.
struct VariantFacts {
  std::vector<std::string> tasks;  ///< of the plan, as in the file
  std::vector<UncertainPlace> uncertain;
  std::optional<schedule::CivilTime> start_at;
  std::string currency;
  bool costed = false;
};
VariantFacts facts_of(const interpreter::PlanModel& plan);

/// The runs of one variant so far. What is taken may come in any order: the result is the same.
struct VariantRuns : VariantFacts {
  interpreter::ParameterTexts set;
  std::string fault;                        ///< why it cannot run; "" if it can
  std::vector<std::vector<double>> values;  ///< by question, then by run
  std::vector<std::int64_t> critical;       ///< by task: runs in which it was on the critical path
  struct Rejection {
    std::int64_t runs = 0;
    std::int64_t first_run = 0;
    std::string reason;  ///< in the first run; "" where another task was rejected before it
  };
  std::map<int, Rejection> rejections;      ///< by task
  std::vector<std::vector<double>> curves;  ///< of the first runs; empty ones are not there

  std::int64_t runs() const {
    return values.empty() ? 0 : static_cast<std::int64_t>(values.front().size());
  }
  /// Makes room for so many runs.
  void resize(const StudyModel& study, std::int64_t runs);
  /// Whether all tasks of a record are there: not so in a log that was damaged.
  bool fits(const RunRecord& record) const;
  void take(std::int64_t run, const RunRecord& record);
};

/// A statistic of the values of one question: infinite where it is never, nothing where the plan
/// has no such thing or there are too few runs.
std::optional<double> value_of(const Statistic& statistic, std::vector<double> values);

/// One line of the log of a study, without its end: read_line(write_line(x)) is x.
struct LoggedRun {
  std::size_t variant = 0;
  std::int64_t run = 0;
  RunRecord record;
};
std::string write_line(const LoggedRun& run);
/// Nothing for a line that is damaged or cut off.
std::optional<LoggedRun> read_line(std::string_view line, std::size_t questions);

}  // namespace rubicon::study
