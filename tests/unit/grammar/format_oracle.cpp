#include "tests/unit/grammar/format_oracle.hpp"

#include "tests/unit/grammar/tree_text.hpp"

namespace rubicon::grammar_test {

using interpreter::TextKind;

std::string parsed_tree(std::string_view text, TextKind kind) {
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  const interpreter::FileId file = sources.add("", std::string(text));
  std::string tree;
  switch (kind) {
    case TextKind::script:
      tree = tree_text(interpreter::parse_script(sources, file, diagnostics));
      break;
    case TextKind::robot:
      tree = tree_text(interpreter::parse_robot(sources, file, diagnostics));
      break;
    case TextKind::plan:
      tree = tree_text(interpreter::parse_plan(sources, file, diagnostics));
      break;
    case TextKind::study:
      tree = tree_text(interpreter::parse_study(sources, file, diagnostics));
      break;
  }
  return diagnostics.has_errors() ? std::string() : "tree" + tree;
}

std::string check_formatting(std::string_view text, TextKind kind) {
  const std::string tree = parsed_tree(text, kind);
  const std::string once = interpreter::format_text(text, kind);
  if (tree.empty()) return once == text ? "" : "a text with mistakes was changed";
  if (parsed_tree(once, kind) != tree) return "the meaning changed:\n" + once;
  const std::string twice = interpreter::format_text(once, kind);
  if (twice != once) return "formatting is not idempotent:\n" + once + "----\n" + twice;
  return "";
}

}  // namespace rubicon::grammar_test
