#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "interpreter/parse/parse.hpp"

namespace rubicon::grammar_test {

/// "LINE:COLUMN: LEVEL: MESSAGE" of every diagnostic of the parser, in order of place.
std::vector<std::string> mistakes(std::string_view text, interpreter::TextKind kind);

/// A text that was parsed, with what its spans refer to.
struct ParsedScript {
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  syntax::Script script;

  explicit ParsedScript(std::string_view text);
  std::string text(const syntax::Span& span) const { return std::string(sources.text(span)); }
};

/// The tree of the one statement `text`, see tree_text.
std::string statement_tree(std::string_view text);

}  // namespace rubicon::grammar_test
