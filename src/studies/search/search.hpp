#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "src/studies/study/run_record.hpp"
#include "src/studies/study/study_model.hpp"

namespace rubicon::study {

/// Where the optimiser looks: a share from 0 to 1 for each range, then the index of a value for
/// each list.
struct SearchSpace {
  std::size_t ranges = 0;
  std::vector<std::size_t> values;  ///< how many there are, by list: 2 or more
  std::size_t objectives = 1;
  std::size_t generation = 16;  ///< points asked at a time: 8 or more, a multiple of 4
};
/// The ranges first.
using SearchPoint = std::vector<double>;

/// An optimiser that is asked for points, a generation at a time, and told what each is worth.
class Optimiser {
 public:
  virtual ~Optimiser() = default;
  /// The next generation; nothing if the optimiser does not answer.
  virtual std::optional<std::vector<SearchPoint>> ask() = 0;
  /// To each point of the last generation its objectives, less is better. False as above.
  virtual bool tell(std::span<const std::vector<double>> worths) = 0;
  /// Why it does not answer.
  virtual std::string failure() const = 0;
};

struct SearchTools {
  /// An optimiser whose first generation holds `start`. The same seed gives the same points.
  std::function<std::unique_ptr<Optimiser>(const SearchSpace&, const SearchPoint& start,
                                           std::uint32_t seed)>
      open;
  /// Makes all runs of variants, which follow those of the calls before; nothing ends the search.
  std::function<std::optional<std::vector<VariantRuns>>(
      const std::vector<interpreter::ParameterTexts>&)>
      run;
};

struct SearchResult {
  std::optional<std::vector<VariantRuns>> variants;  ///< in the order in which they were tried
  std::string failure;                               ///< of the optimiser
};

/// Looks for the variant that the rule of a study chooses; without a rule, for those than which no
/// other is both faster and cheaper on average (faster alone where nothing costs). At most
/// `study.budget` variants are tried, the first values of all variables first; where there are no
/// more combinations than that, all. What is worth how much follows from the runs alone, so that
/// the result is the same whatever the number of threads.
SearchResult search_study(const StudyModel& study, bool costed, const SearchTools& tools);

}  // namespace rubicon::study
