#pragma once

#include <string>
#include <vector>

#include "interpreter/expand/expand.hpp"
#include "interpreter/syntax/file_provider.hpp"

namespace rubicon::interpreter {

/// How `import "file" as NAME;` finds its file.
struct ImportFiles {
  FileProvider& files;
  std::vector<std::string> open;  ///< the plan and those that import each other around it, it last
  int left = 100;                 ///< files that may still be read for one plan
};

/// expand_plan for a plan that may import others: their items stand where the import stands, with
/// names such as `NAME.x`. P28, F01.
void expand_plan(syntax::Plan& plan, const ParameterTexts& set, SourceMap& sources,
                 Diagnostics& diagnostics, ImportFiles& imports);

}  // namespace rubicon::interpreter
