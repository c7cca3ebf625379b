#pragma once

#include <string>
#include <utility>
#include <vector>

#include "interpreter/syntax/diagnostic.hpp"
#include "interpreter/syntax/syntax.hpp"

namespace rubicon::interpreter {

/// Most passes of all `for` of a file whose bodies hold more than another `for`.
inline constexpr std::int64_t kMaxCopies = 100000;

/// What `--set NAME=TEXT` gives, in that order.
using ParameterTexts = std::vector<std::pair<std::string, std::string>>;

/// Makes `plan` plain: see README.md. What is wrong goes to `diagnostics` (P23 to P27, and F06,
/// F09, F10, F11 of expressions); what cannot be made is left out and `plan.broken` set. Linear in
/// what is made; nothing is made of a `for` beyond kMaxCopies.
void expand_plan(syntax::Plan& plan, const ParameterTexts& set, SourceMap& sources,
                 Diagnostics& diagnostics);

}  // namespace rubicon::interpreter
