#pragma once

#include <string>

#include "src/motion/collision/swept_query.hpp"

namespace rubicon::site {

/// What hangs on a robot's tool.
struct Load {
  std::string name;  ///< the component's, or "load"
  collision::BodyPtr body;
  math::Pose X_TO = math::Pose::Identity();
  double mass = 0;     ///< kg
  int component = -1;  ///< index, -1: the `carry` of a short plan
};

}  // namespace rubicon::site
