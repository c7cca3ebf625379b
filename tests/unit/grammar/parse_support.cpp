#include "tests/unit/grammar/parse_support.hpp"

#include <fmt/format.h>

#include "tests/unit/grammar/format_oracle.hpp"

namespace rubicon::grammar_test {

using interpreter::TextKind;

std::vector<std::string> mistakes(std::string_view text, TextKind kind) {
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  const interpreter::FileId file = sources.add("text", std::string(text));
  switch (kind) {
    case TextKind::script:
      interpreter::parse_script(sources, file, diagnostics);
      break;
    case TextKind::robot:
      interpreter::parse_robot(sources, file, diagnostics);
      break;
    case TextKind::plan:
      interpreter::parse_plan(sources, file, diagnostics);
      break;
    case TextKind::study:
      interpreter::parse_study(sources, file, diagnostics);
      break;
  }
  std::vector<std::string> lines;
  for (const interpreter::Diagnostic& diagnostic : diagnostics.sorted()) {
    const interpreter::Position at = sources.position(diagnostic.span);
    lines.push_back(
        fmt::format("{}:{}: {}: {}", at.line, at.column,
                    diagnostic.severity == interpreter::Severity::error ? "error" : "note",
                    diagnostic.message));
  }
  return lines;
}

ParsedScript::ParsedScript(std::string_view text) {
  const interpreter::FileId file = sources.add("text", std::string(text));
  script = interpreter::parse_script(sources, file, diagnostics);
}

std::string statement_tree(std::string_view text) { return parsed_tree(text, TextKind::script); }

}  // namespace rubicon::grammar_test
