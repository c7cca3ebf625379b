#pragma once

#include <vector>

#include "interpreter/check/check.hpp"
#include "src/motion/guides/guide_spec.hpp"

namespace rubicon::interpreter {

/// The bounds that a condition sets on sums of parameters: comparisons by <=, >=, < and > of sums,
/// differences, multiples and abs(...) of them, joined by and. G03 for anything else.
void resolve_keep(const syntax::Expression& condition, const robot::RobotModel& robot,
                  std::vector<guides::KeptBound>& bounds, Diagnostics& diagnostics);

}  // namespace rubicon::interpreter
