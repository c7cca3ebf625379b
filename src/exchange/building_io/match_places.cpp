#include "src/exchange/building_io/match_places.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "interpreter/syntax/token.hpp"
#include "src/exchange/building_io/names.hpp"

namespace rubicon::building_io {

namespace {

using interpreter::Diagnostic;
using interpreter::FileId;
using interpreter::Span;
using interpreter::Token;

void add_tokens(std::string_view text, std::vector<Token>& tokens) {
  const char* const end = text.data() + text.size();
  for (const char* at = text.data();;) {
    const Token token = interpreter::next_token(at, end);
    if (token.kind == Token::Kind::end) return;
    tokens.push_back(token);
    at = token.end;
  }
}

/// The tokens of the plan and of the match file. The plan is in canonical form, which changes no
/// token.
class Finder {
 public:
  Finder(const MatchFile& match, const BuildingPlan& plan, FileId file,
         const interpreter::SourceMap& sources)
      : match_(match), plan_(plan), sources_(sources) {
    text_ = sources.file(file).text;
    add_tokens(text_, tokens_);
    for (const Span& span : match.plan_places) add_tokens(sources.text(span), items_);
    const auto same = [](const Token& a, const Token& b) { return a.text() == b.text(); };
    first_item_ = static_cast<std::size_t>(
        std::search(tokens_.begin(), tokens_.end(), items_.begin(), items_.end(), same) -
        tokens_.begin());
  }

  /// Where the match file says what stands at this place of the plan.
  std::optional<Span> place_of(const Span& span) const {
    const auto at = static_cast<std::size_t>(
        std::partition_point(tokens_.begin(), tokens_.end(),
                             [&](const Token& token) { return offset(token.end) <= span.begin; }) -
        tokens_.begin());
    if (at >= first_item_ && at - first_item_ < items_.size()) {
      return span_of(items_[at - first_item_], match_.plan_places.front().file);
    }
    return at < tokens_.size() ? place_of_rule(at) : std::nullopt;
  }

 private:
  std::uint32_t offset(const char* at) const {
    return static_cast<std::uint32_t>(at - text_.data());
  }

  Span span_of(const Token& token, FileId file) const {
    const char* const begin = sources_.file(file).text.data();
    return {file, static_cast<std::uint32_t>(token.begin - begin),
            static_cast<std::uint32_t>(token.end - begin)};
  }

  /// In a component or task that a rule made: what the rule says, or the rule itself.
  std::optional<Span> place_of_rule(std::size_t at) const {
    std::size_t item = 0;       // where the item of the plan begins that token `at` is in
    std::size_t statement = 0;  // and the statement of that item
    int depth = 0;
    for (std::size_t i = 0; i < at; ++i) {
      if (tokens_[i].is_symbol('{')) ++depth;
      if (tokens_[i].is_symbol('}')) --depth;
      const bool ends =
          tokens_[i].is_symbol('{') || tokens_[i].is_symbol('}') || tokens_[i].is_symbol(';');
      if (ends && depth <= 1) item = i + 1;
      if (ends && depth <= 2) statement = i + 1;
    }
    const MatchRule* const rule = rule_of(item);
    if (rule == nullptr) return std::nullopt;
    const auto said = rule->terms.places.find(tokens_[statement].text());
    if (said == rule->terms.places.end()) return rule->span;
    // The statement ends with the words of the match file: so counted from its end.
    std::size_t after = 0;
    for (std::size_t i = at; i < tokens_.size() && !tokens_[i].is_symbol(';'); ++i) ++after;
    std::vector<Token> words;
    add_tokens(sources_.text(said->second), words);
    if (after == 0 || after > words.size()) return said->second;
    return span_of(words[words.size() - after], said->second.file);
  }

  const MatchRule* rule_of(std::size_t item) const {
    if (item + 1 >= tokens_.size()) return nullptr;
    std::string name(tokens_[item + 1].text());
    if (tokens_[item].is("task") && name.starts_with(kPartPrefix)) {
      name.erase(0, kPartPrefix.size());
    } else if (!tokens_[item].is("component")) {
      return nullptr;
    }
    const auto rule = plan_.rules.find(name);
    return rule == plan_.rules.end() ? nullptr : &match_.rules[rule->second];
  }

  const MatchFile& match_;
  const BuildingPlan& plan_;
  const interpreter::SourceMap& sources_;
  std::string_view text_;
  std::vector<Token> tokens_;
  std::vector<Token> items_;  ///< of `plan { ... }` in the match file
  std::size_t first_item_ = 0;
};

}  // namespace

std::vector<Diagnostic> at_match_places(const std::vector<Diagnostic>& mistakes,
                                        const MatchFile& match, const BuildingPlan& plan,
                                        FileId file, const interpreter::SourceMap& sources) {
  const Finder finder(match, plan, file, sources);
  std::vector<Diagnostic> result;
  std::set<std::tuple<std::string, FileId, std::uint32_t>> told;
  for (Diagnostic each : mistakes) {
    if (each.span.file == file) {
      each.span = finder.place_of(each.span).value_or(Span{});
      const bool placed = each.span.file != interpreter::kNoFile;
      if (placed && !told.emplace(each.code, each.span.file, each.span.begin).second) continue;
    }
    std::vector<Diagnostic::Related> notes;
    for (Diagnostic::Related note : each.notes) {
      if (note.span.file == file) {
        const auto place = finder.place_of(note.span);
        if (!place) continue;
        note.span = *place;
      }
      notes.push_back(std::move(note));
    }
    each.notes = std::move(notes);
    result.push_back(std::move(each));
  }
  return result;
}

}  // namespace rubicon::building_io
