#include <charconv>

#include "grammar/study.hpp"
#include "interpreter/parse/parse_control.hpp"
#include "interpreter/parse/parse_script.hpp"
#include "interpreter/syntax/study.hpp"

namespace rubicon::interpreter {

namespace {

/// The items of a study under construction.
class StudyState : public ScriptState {
 public:
  StudyState(const SourceMap& sources, FileId file, Diagnostics& diagnostics)
      : ScriptState(sources, file, diagnostics, "U00",
                    {"plan", "vary", "design", "runs", "seed", "ask", "choose"}) {
    computes_numbers_ = true;
  }

  /// The last number as it stands from `from`.
  syntax::Literal take_literal(const char* from) const {
    syntax::Literal result{number, number.value, {}};
    const char* at = from;
    const bool negative = *at == '-';
    while (*at == '-' || *at == '+' || *at == ' ' || *at == '\t') ++at;
    const char* const end = std::from_chars(at, last_end, result.written).ptr;
    if (negative) result.written = -result.written;
    result.text = (negative ? "-" : "") + std::string(at, end);
    if (!number.unit_text.empty()) result.text += " " + number.unit_text;
    result.number.span = span_from(from);
    return result;
  }
  syntax::Measure take_measure() { return std::exchange(measure, {}); }

  syntax::Study study;
  syntax::VaryItem vary;
  syntax::VariedValue value;
  syntax::DesignItem design;
  syntax::Measure measure;
  syntax::Limit limit;
  syntax::RunsItem runs;
  syntax::ChooseItem choose;
};

template <typename Rule>
struct StudyAction : ScriptAction<Rule> {};

// what is varied
RUBICON_ACTION(StudyAction, StudyState, studied_plan) {
  st.study.plans.push_back({st.string, st.span_from(begin)});
}
RUBICON_ACTION(StudyAction, StudyState, varied_name) {
  st.vary = {};
  st.vary.name = st.take_qualified_name();
}
RUBICON_ACTION(StudyAction, StudyState, varied_text) {
  st.value = {};
  st.value.text = st.string;
}
RUBICON_ACTION(StudyAction, StudyState, varied_first) {
  st.value = {};
  st.value.first = st.take_literal(begin);
}
RUBICON_ACTION(StudyAction, StudyState, varied_last) { st.value.last = st.take_literal(begin); }
RUBICON_ACTION(StudyAction, StudyState, varied_step) { st.value.step = st.take_literal(begin); }
RUBICON_ACTION(StudyAction, StudyState, varied_value) {
  st.value.span = st.span_from(begin);
  st.vary.values.push_back(std::move(st.value));
}
RUBICON_ACTION(StudyAction, StudyState, vary_item) {
  st.vary.span = st.span_from(begin);
  st.study.vary.push_back(std::move(st.vary));
}
RUBICON_ACTION(StudyAction, StudyState, design_kind) {
  st.design = {};
  st.design.kind = st.take_name();
}
RUBICON_ACTION(StudyAction, StudyState, design_count) { st.design.count = st.number; }
RUBICON_ACTION(StudyAction, StudyState, design_item) {
  st.design.span = st.span_from(begin);
  st.study.designs.push_back(std::move(st.design));
}

// what is asked
RUBICON_ACTION(StudyAction, StudyState, measure_name) {
  st.measure.words.push_back(st.take_qualified_name());
  if (st.measure.words.size() == 1) st.measure.span = st.span_from(begin);
}
RUBICON_ACTION(StudyAction, StudyState, measure_close) {
  st.measure.span.end = st.span_from(begin).end;
}
RUBICON_ACTION(StudyAction, StudyState, asked) { st.study.asks.push_back(st.take_measure()); }
RUBICON_ACTION(StudyAction, StudyState, limited_measure) {
  st.limit = {};
  st.limit.measure = st.take_measure();
}
RUBICON_ACTION(StudyAction, StudyState, limit_operator) {
  st.limit.comparison = {std::string(begin, st.last_end), st.span_from(begin)};
}
RUBICON_ACTION(StudyAction, StudyState, limit_text) { st.limit.text = st.string; }
RUBICON_ACTION(StudyAction, StudyState, limit_number) { st.limit.number = st.take_literal(begin); }
RUBICON_ACTION(StudyAction, StudyState, required_limit) { st.limit.span = st.span_from(begin); }

// how often, what is chosen
RUBICON_ACTION(StudyAction, StudyState, runs_key) { st.runs = {}; }
RUBICON_ACTION(StudyAction, StudyState, runs_most) { st.runs.at_most = true; }
RUBICON_ACTION(StudyAction, StudyState, runs_count) { st.runs.count = st.number; }
RUBICON_ACTION(StudyAction, StudyState, runs_item) {
  st.runs.span = st.span_from(begin);
  if (!st.limit.measure.words.empty()) st.runs.until = std::exchange(st.limit, {});
  st.study.runs.push_back(std::move(st.runs));
}
RUBICON_ACTION(StudyAction, StudyState, seed_value) {
  st.study.seeds.push_back({st.number, st.span_from(begin)});
}
RUBICON_ACTION(StudyAction, StudyState, choose_direction) {
  st.choose = {};
  st.choose.direction = st.take_name();
}
RUBICON_ACTION(StudyAction, StudyState, chosen_measure) { st.choose.measure = st.take_measure(); }
RUBICON_ACTION(StudyAction, StudyState, choose_limit) {
  st.limit.span = st.span_from(begin);
  st.choose.with.push_back(std::exchange(st.limit, {}));
}
RUBICON_ACTION(StudyAction, StudyState, choose_best) {
  st.choose.span = st.span_from(begin);
  st.study.chooses.push_back(std::move(st.choose));
}
RUBICON_ACTION(StudyAction, StudyState, broken<grammar::whole_study_item>) {
  st.measure = {};
  st.limit = {};
}
RUBICON_ACTION(StudyAction, StudyState, study_file_key) { st.announce("study"); }
RUBICON_ACTION(StudyAction, StudyState, study_name) { st.study.name = st.take_name(); }

}  // namespace

syntax::Study parse_study(const SourceMap& sources, FileId file, Diagnostics& diagnostics) {
  StudyState state(sources, file, diagnostics);
  const bool finished = run_parser<grammar::study_file, StudyAction>(state);
  state.study.broken = !finished || state.errors() > 0;
  state.study.span = state.span_from(state.begin());
  return std::move(state.study);
}

}  // namespace rubicon::interpreter
