#pragma once

#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/syntax/source.hpp"

namespace rubicon::comparison {

/// What is drawn of a guide.
struct PictureQuery {
  std::string kind;               ///< "": that of the first guide of the task, or rrt_connect
  std::vector<std::string> axes;  ///< two parameters; none: the first two that it searches
};

/// The configurations that two parameters span, as SVG, where the first motion of the task begins:
/// where the robot may not stand, what was grown, the way; of `potential` the field and its minima.
/// All other parameters have the values that they begin with. Throws std::invalid_argument with a
/// message for the user.
std::string guide_picture(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
                          const std::string& task, const PictureQuery& query);

}  // namespace rubicon::comparison
