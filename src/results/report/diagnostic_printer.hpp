#pragma once

#include <string>
#include <vector>

#include "interpreter/syntax/diagnostic.hpp"

namespace rubicon::report {

/// `file:line:col: error: ...` with the line and a caret under the place, one after the other, and
/// a last line that counts errors and warnings.
std::string print_text(const std::vector<interpreter::Diagnostic>& diagnostics,
                       const interpreter::SourceMap& sources, bool colour);

/// One line: `line:col: level: message`, as goldens keep it.
std::string print_brief(const interpreter::Diagnostic& diagnostic,
                        const interpreter::SourceMap& sources);

/// A JSON array in the shape of the Language Server Protocol's publishDiagnostics: one object a
/// file with `uri` and `diagnostics` (`range` with 0-based lines and UTF-16 columns, `severity` 1
/// error, 2 warning, 3 information, `code`, `source`, `message`, `relatedInformation`).
std::string print_json(const std::vector<interpreter::Diagnostic>& diagnostics,
                       const interpreter::SourceMap& sources);

}  // namespace rubicon::report
