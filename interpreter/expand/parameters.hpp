#pragma once

#include <functional>

#include "interpreter/expand/expand.hpp"
#include "interpreter/expand/scope.hpp"

namespace rubicon::interpreter::expansion {

/// Gives the parameters of a plan their values, in the order of the file, `set` before what the
/// file says. P02, P23, P27 and the codes of expressions. An imported plan gives its own when
/// `on_import` is called with it and with what `set` says of them.
using OnImport = std::function<void(const syntax::ImportItem&, const ParameterTexts&)>;
void evaluate_parameters(const syntax::Plan& plan, const ParameterTexts& set, Scope& scope,
                         Diagnostics& diagnostics, const OnImport& on_import);

}  // namespace rubicon::interpreter::expansion
