#include "interpreter/parse/parse_script.hpp"

namespace rubicon::interpreter {

syntax::Script parse_script(const SourceMap& sources, FileId file, Diagnostics& diagnostics) {
  ScriptState state(sources, file, diagnostics, "S04", {});
  run_parser<grammar::script, ScriptAction>(state);
  return state.take_script(state.begin());
}

}  // namespace rubicon::interpreter
