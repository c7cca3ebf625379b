#pragma once

#include <string>

#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter::plan_check {

/// Warns of a bare number of seconds, unless it is 0: hours or minutes may be meant (P22).
void warn_of_bare_seconds(Subject& subject, const syntax::Number& number, const std::string& what,
                          double seconds);

}  // namespace rubicon::interpreter::plan_check
