#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "interpreter/syntax/diagnostic.hpp"
#include "src/exchange/building_io/building_plan.hpp"
#include "src/exchange/building_io/match_file.hpp"

namespace rubicon::building_io {

/// Takes what is said of a plan that was made with a match file to where the match file says it.
class MatchPlaces {
 public:
  /// `file` is the plan among the sources, which hold the match file too. All are to outlive this.
  MatchPlaces(const MatchFile& match, const BuildingPlan& plan, interpreter::FileId file,
              const interpreter::SourceMap& sources);
  ~MatchPlaces();

  /// The same mistakes at their places in the match file, each once, however many elements it is
  /// about. What comes from elsewhere (the schedule, the model) has no place; what stands in other
  /// files stays.
  std::vector<interpreter::Diagnostic> moved(
      const std::vector<interpreter::Diagnostic>& mistakes) const;

 private:
  class Finder;
  std::unique_ptr<const Finder> finder_;
};

}  // namespace rubicon::building_io
