#pragma once

#include <string>

#include "interpreter/syntax/diagnostic.hpp"
#include "interpreter/syntax/syntax.hpp"

namespace rubicon::interpreter::expansion {

/// Makes the items of an imported plan, plain already, items of the plan that imports it as `name`
/// from `file` (as written there): what it declares is called `name.x`, also where it speaks of it;
/// files are found from its own folder. Other names are those of the importing plan. Settings and
/// the short form belong to no imported plan: P28.
void qualify(syntax::Plan& plan, const std::string& name, const std::string& file,
             Diagnostics& diagnostics);

}  // namespace rubicon::interpreter::expansion
