#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/expand/expand.hpp"
#include "interpreter/syntax/diagnostic.hpp"
#include "interpreter/syntax/study.hpp"
#include "src/simulation/schedule/civil_time.hpp"

namespace rubicon::study {

using interpreter::Span;

/// Most variants of a study, and most runs of one.
inline constexpr std::size_t kMostVariants = 100'000;
inline constexpr std::int64_t kMostRuns = 10'000'000;
/// A rule that ends the runs of a variant is looked at after so many runs each time.
inline constexpr std::int64_t kRunsBetweenLooks = 50;

/// A parameter of the plan that a study varies.
struct Variable {
  std::string name;
  std::vector<std::string> values;  ///< as texts of --set, in the order of the study
  /// Any number from `low` to `high`, in place of values: for `design latin` and `design search`.
  struct Range {
    double low = 0;
    double high = 0;
    std::string unit;
  };
  std::optional<Range> range;
  Span span;
};

enum class Design : std::uint8_t {
  full,           ///< every combination, the last variable fastest
  latin,          ///< Latin hypercube
  one_at_a_time,  ///< the first value of all; then each other value alone
  search,         ///< those that an optimiser asks for: see src/studies/search
};

/// What is looked at in a run.
enum class Asked : std::uint8_t {
  makespan,
  cost,
  rejected,
  finish,
  utilisation,
  waiting,
  task_start,
  task_finish,
  task_duration,
  production,  ///< m3 per h of a task that digs
  unit_cost,   ///< cost per m3 of such a task
  fuel         ///< l, of all
};

/// One number of a run. Times are in s after the beginning of the plan.
struct Question {
  Asked asked = Asked::makespan;
  std::string of;    ///< a robot or crew, a task, a cause of waiting
  std::string text;  ///< as asked: "utilisation(crane)"
  Span span;

  bool operator==(const Question& other) const { return asked == other.asked && of == other.of; }
};

/// How numbers of a kind are written.
enum class Unit : std::uint8_t { seconds, moment, money, share, number };
Unit unit_of(Asked asked);

/// One number of many runs.
struct Statistic {
  int question = 0;
  std::optional<double> quantile;  ///< nothing: the mean
  bool width = false;              ///< that of its 95 % interval
  std::string text;                ///< "p80(finish)"
  Span span;
};

/// A statistic within a limit.
struct Condition {
  Statistic statistic;
  enum class Comparison : std::uint8_t { less, less_equal, greater, greater_equal };
  Comparison comparison = Comparison::less_equal;
  double limit = 0;
  std::optional<schedule::CivilTime> date;  ///< the limit of a moment
  std::string text;

  bool holds(double value, double against) const;
};

struct Choice {
  bool least = true;
  Statistic statistic;
  std::vector<Condition> with;
};

/// A checked study.
struct StudyModel {
  std::string name;
  std::string plan;  ///< relative to the folder of the study
  Span plan_span;
  std::vector<Variable> variables;
  Design design = Design::full;
  std::int64_t latin = 0;      ///< variants of a Latin hypercube
  std::int64_t budget = 0;     ///< most variants of a search
  bool sampled = false;        ///< durations are drawn; else each stands for its mean, in one run
  std::int64_t most_runs = 1;  ///< of a variant
  std::optional<Condition> until;
  std::uint64_t seed = 1;
  std::vector<Question> questions;  ///< makespan, cost, rejected; then what is asked beside these
  std::vector<int> asked;           ///< indices of questions in the order asked; never empty
  std::optional<Choice> choice;

  /// The index of a question, which is added if it is not there.
  int question(const Question& question);
};

/// Reads a study. Errors (U00 to U10) go to `diagnostics`; null if there are any.
std::unique_ptr<StudyModel> check_study(const syntax::Study& study,
                                        interpreter::Diagnostics& diagnostics);

/// The settings of every variant, in order: texts for the parameters, in the order of the study.
/// Of a search the first alone, or every combination where these are no more than its budget.
std::vector<interpreter::ParameterTexts> variants_of(const StudyModel& study);
/// Whether a search has to choose what to try: there are more combinations than its budget.
bool must_search(const StudyModel& study);
/// The value so far along a range, 0 to 1, as people write it: to six digits of the range.
std::string value_at(const Variable::Range& range, double share);
/// How many there would be; of a search at most.
std::size_t count_variants(const StudyModel& study);

}  // namespace rubicon::study
