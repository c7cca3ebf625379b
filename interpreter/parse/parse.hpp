#pragma once

#include "interpreter/syntax/diagnostic.hpp"
#include "interpreter/syntax/study.hpp"
#include "interpreter/syntax/syntax.hpp"

namespace rubicon::interpreter {

/// Deepest nesting of braces and parentheses the parsers accept; deeper text is an error at its
/// place.
inline constexpr int kMaxNesting = 200;
/// Largest text the parsers take, in bytes; more is an error.
inline constexpr std::size_t kMaxTextBytes = 256u << 20;

/// Parse a whole file. Mistakes go to `diagnostics`; the parser goes on after an error where it
/// can, and what did not parse is left out or marked broken, so that later checks say nothing of
/// it. Linear in the length of the text; never throws, never overflows the stack.
syntax::Script parse_script(const SourceMap& sources, FileId file, Diagnostics& diagnostics);
syntax::Robot parse_robot(const SourceMap& sources, FileId file, Diagnostics& diagnostics);
syntax::Plan parse_plan(const SourceMap& sources, FileId file, Diagnostics& diagnostics);
syntax::Study parse_study(const SourceMap& sources, FileId file, Diagnostics& diagnostics);

/// One way to write it: the text of a script, robot, plan or study with canonical indentation,
/// spacing and line breaks, comments kept. Idempotent. Only for texts that parse without errors;
/// returns the text unchanged otherwise.
enum class TextKind { script, robot, plan, study };
std::string format_text(std::string_view text, TextKind kind);

}  // namespace rubicon::interpreter
