#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "src/motion/geometry/timetable.hpp"
#include "src/simulation/trace/record.hpp"

namespace rubicon::trace {

/// When something with a timetable stopped (or, with `goes_on`, went on), as its records tell.
struct MovingStop {
  Ticks t = 0;
  bool goes_on = false;
};

/// A time in which it is on the site: between two places of its path, or where it was stopped.
struct MovingStretch {
  enum class Kind {
    goes,    ///< from X_from to X_to
    stays,   ///< as its path says
    stopped  ///< before something
  };
  Kind kind = Kind::goes;
  Ticks from = 0;
  Ticks to = 0;
  math::Pose X_from = math::Pose::Identity();
  math::Pose X_to = math::Pose::Identity();
};

/// What it does up to `until`, without gaps while it is there; `stops` in their order. It ends
/// where there would be more than `most` stretches: of what repeats its path for months.
std::vector<MovingStretch> moving_stretches(const geometry::Timetable& timetable,
                                            std::span<const MovingStop> stops, Ticks until,
                                            std::size_t most);

}  // namespace rubicon::trace
