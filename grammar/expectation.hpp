#pragma once

/// What the grammar and the state of a parse say to each other. No PEGTL here, so that the state
/// can be compiled without it.
namespace rubicon::grammar {

/// Where to go on after a mistake (see ParseState::skip).
enum class Resume { statement, element, item, nowhere };
/// What the grammar asks the state of the parse where the text alone does not tell.
enum class Query {
  brace_is_lost,        ///< the '}' of this loop is missing here
  take_lost_brace,      ///< the same, and the loop ends now
  separator_is_waived,  ///< a mistake was passed over: no separator is due
  semicolon_ends_loop,  ///< the ';' here ends a loop whose '}' is lost; else it stands for a ','
  on_new_line,          ///< the next token is the first of its line
  computes_numbers      ///< an expression may stand where a number does
};

/// How a mistake is explained.
enum class Explain {
  expected,   ///< "expected WHAT, found ..."
  statement,  ///< a statement or element: misspelt commands, functions, remarks, assignments
  item        ///< an item of a robot or plan: WHAT names the thing, `words` the items it has
};

/// `what` may hold {in}, the innermost open structure ("chain"), and {of}, the structure whose
/// brace comes next.
struct Expectation {
  const char* what = nullptr;
  Explain explain = Explain::expected;
  const char* words = "";  ///< names to compare a misspelt one with, separated by blanks
};

}  // namespace rubicon::grammar
