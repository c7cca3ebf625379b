#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/syntax/source.hpp"

namespace rubicon::comparison {

/// What is drawn of a guide.
struct PictureQuery {
  std::string kind;               ///< "": that of the first guide of the task, or rrt_connect
  std::vector<std::string> axes;  ///< two parameters; none: the first two that it searches
  /// A third may follow them. Its value in the picture; none: as it is when the motion begins.
  std::optional<double> at = {};
};

/// The configurations that two parameters span, as SVG, where the first motion of the task begins:
/// where the robot may not stand, what was grown, the way; of `potential` the field and its minima.
/// All other parameters have the values that they begin with. Throws std::invalid_argument with a
/// message for the user.
std::string guide_picture(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
                          const std::string& task, const PictureQuery& query);

/// The same for values of a third parameter all over its range, as a page with a slider (HTML). A
/// ring is where the way has that value. Throws as `guide_picture` does.
std::string guide_picture_page(const interpreter::PlanModel& plan,
                               const interpreter::SourceMap& sources, const std::string& task,
                               const PictureQuery& query);

}  // namespace rubicon::comparison
