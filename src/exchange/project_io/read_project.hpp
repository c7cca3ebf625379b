#pragma once

#include <optional>

#include "interpreter/syntax/diagnostic.hpp"
#include "src/exchange/project_io/project.hpp"

namespace rubicon::project_io {

// All readers take a source whose text is UTF-8 (see decode_text). Null with an error (I01: the
// text is broken; I02: it is something else) at its place if nothing can be read. What is there but
// was not understood is listed as warnings (I03 to I07), one a kind, at the first place.

/// Microsoft Project XML (MSPDI, schema http://schemas.microsoft.com/project): calendars, tasks
/// with their outline and links, resources, assignments. Values that a scheduler computes from the
/// rest (outline numbers, early and late dates, slack) are passed over.
std::optional<Project> read_mspdi(const interpreter::SourceMap& sources, interpreter::FileId file,
                                  interpreter::Diagnostics& diagnostics);

/// A Primavera P6 export (XER): the first project of it that was exported and has activities.
std::optional<Project> read_xer(const interpreter::SourceMap& sources, interpreter::FileId file,
                                interpreter::Diagnostics& diagnostics);

/// Either, told apart by how the text begins.
std::optional<Project> read_project(const interpreter::SourceMap& sources, interpreter::FileId file,
                                    interpreter::Diagnostics& diagnostics);

}  // namespace rubicon::project_io
