#pragma once

#include <optional>

#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter::plan_check {

/// As resolve_cover, over another floor than that of the area.
std::optional<CoverWay> resolve_cover_over(Subject& subject, const syntax::CoverItem& item,
                                           const coverage::FloorDescription& floor);

/// The ways of tasks over areas with `obstacles from components`, now that all tasks and their
/// links are known: P54 where it is not certain what stands there, or too little is left.
void finish_covers(Subject& subject);

}  // namespace rubicon::interpreter::plan_check
