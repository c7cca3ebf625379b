#include "src/exchange/building_io/match_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "interpreter/check/check_number.hpp"
#include "interpreter/syntax/token.hpp"
#include "interpreter/syntax/utf8_character.hpp"

namespace rubicon::building_io {

namespace {

using interpreter::Span;
using interpreter::Token;
using Field = MatchRule::Condition::Field;

constexpr std::array<std::pair<std::string_view, Field>, 5> kFields = {{{"storey", Field::storey},
                                                                        {"type", Field::type},
                                                                        {"name", Field::name},
                                                                        {"guid", Field::guid},
                                                                        {"file", Field::file}}};

/// More elements on each other than this are a slip of the pen.
constexpr int kHighestStack = 100;
/// The farthest a stock area may reach (metres).
constexpr double kFarthest = 1e6;

/// Statements of a match file. After a mistake it goes on behind the next ';'.
class MatchReader {
 public:
  MatchReader(const interpreter::SourceMap& sources, interpreter::FileId file,
              interpreter::Diagnostics& diagnostics)
      : text_(sources.file(file).text), file_(file), diagnostics_(diagnostics) {
    at_ = text_.data();
    next();
  }

  MatchFile read() {
    if (!is_utf8()) return {};
    while (token_.kind != Token::Kind::end) {
      if (!statement()) recover();
    }
    return std::move(result_);
  }

 private:
  /// Whether the file is text as this reads it; says where not.
  bool is_utf8() {
    const std::size_t bad = std::min(interpreter::first_not_utf8(text_), text_.find('\0'));
    if (bad != std::string_view::npos) {
      const char* const at = text_.data() + bad;
      diagnostics_.error("I12", span_of(at, at + 1),
                         fmt::format("not UTF-8: byte 0x{:02x}", static_cast<unsigned char>(*at)),
                         "save the file as UTF-8");
      return false;
    }
    return true;
  }

  // ---- tokens

  void next() {
    last_end_ = token_.end;
    token_ = interpreter::next_token(at_, text_.data() + text_.size());
    at_ = token_.end;
  }

  bool is(std::string_view word) const { return token_.is(word); }

  Span span_of(const char* begin, const char* end) const {
    return {file_, static_cast<std::uint32_t>(begin - text_.data()),
            static_cast<std::uint32_t>(end - text_.data())};
  }

  bool expected(const std::string& what, const std::string& hint = {}) {
    const std::string found =
        token_.kind == Token::Kind::end ? "the end" : fmt::format("'{}'", token_.text());
    diagnostics_.error("I12", span_of(token_.begin, token_.end),
                       fmt::format("expected {}, found {}", what, found), hint);
    return false;
  }

  bool take(char symbol, const char* where) {
    if (!token_.is_symbol(symbol)) return expected(fmt::format("'{}' {}", symbol, where));
    next();
    return true;
  }

  /// Goes on behind the next ';' that stands in no brackets.
  void recover() {
    int depth = 0;
    while (token_.kind != Token::Kind::end) {
      if (token_.is_symbol('{')) ++depth;
      if (token_.is_symbol('}') && depth > 0) --depth;
      const bool done = token_.is_symbol(';') && depth == 0;
      next();
      if (done) return;
    }
  }

  // ---- statements

  bool statement() {
    if (token_.is_symbol(';')) {
      next();
      return true;
    }
    if (is("plan")) return plan_items();
    if (is("stock")) return stock();
    if (is_term()) return term(defaults_) && take(';', "after it");
    if (is_field() || token_.is_symbol('-')) return rule();
    return expected("a rule such as: type IfcSlab -> task \"Lay floor\";",
                    "rules begin with storey, type, name, guid, file or ->; others: plan, stock, "
                    "by, hook, adjust, release, grip, mass, density, priority");
  }

  /// plan { ... }: kept as it stands.
  bool plan_items() {
    next();
    if (!token_.is_symbol('{')) return expected("'{' after plan");
    const Span open = span_of(token_.begin, token_.end);
    const char* const begin = token_.end;
    int depth = 0;
    std::string_view before;
    do {
      if (token_.is_symbol('{')) ++depth;
      if (token_.is_symbol('}')) --depth;
      if (token_.kind == Token::Kind::end) {
        diagnostics_.error("I12", open, "this block is not closed", "write '}' behind it");
        return false;
      }
      if (depth == 1 && token_.kind == Token::Kind::name) {
        if (before == "robot" || before == "crew") result_.workers.emplace(token_.text());
        if (before == "calendar") result_.calendars.emplace(token_.text());
      }
      before = token_.text();
      if (depth > 0) next();
    } while (depth > 0);
    result_.plan_items += std::string(begin, token_.begin);
    result_.plan_places.push_back(span_of(begin, token_.begin));
    next();
    return true;
  }

  /// stock NAME box(x0, y0, z0, x1, y1, z1) stack 5 gap 0.5 m;
  bool stock() {
    StockArea area;
    next();
    if (token_.kind == Token::Kind::name && !is("box")) {
      area.name = token_.text();
      next();
    }
    if (!is("box")) return expected("box(x0, y0, z0, x1, y1, z1)");
    const Token word = token_;
    next();
    if (!take('(', "after box")) return false;
    std::array<double, 6> corners{};
    for (std::size_t k = 0; k < corners.size(); ++k) {
      if (k > 0 && !take(',', "between numbers")) return false;
      if (!length(corners[k])) return false;
    }
    if (!take(')', "after six numbers")) return false;
    area.box.lower = {corners[0], corners[1], corners[2]};
    area.box.upper = {corners[3], corners[4], corners[5]};
    if (!((area.box.upper - area.box.lower).minCoeff() > 0)) {
      diagnostics_.error("I12", span_of(word.begin, last_end_),
                         "this box has no extent; expected the smaller values first");
      return false;
    }
    while (is("stack") || is("gap")) {
      if (is("stack") ? !stack(area.stack) : (next(), !length(area.gap))) return false;
    }
    if (area.gap < 0) return expected("a gap of 0 or more");
    const Span span = span_of(word.begin, last_end_);
    if (!take(';', "after a stock area")) return false;
    for (const StockArea& other : result_.stocks) {
      const auto& a = area.box;
      const auto& b = other.box;
      if ((a.lower.array() < b.upper.array()).all() && (b.lower.array() < a.upper.array()).all()) {
        diagnostics_.error("I12", span, "this stock area lies in another one",
                           "what waits in both would stand in each other");
      }
    }
    result_.stocks.push_back(std::move(area));
    return true;
  }

  bool stack(int& count) {
    next();
    const std::string_view digits = token_.text();
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
    if (error != std::errc() || end != digits.data() + digits.size() || count < 1 ||
        count > kHighestStack) {
      return expected(fmt::format("a count from 1 to {}", kHighestStack));
    }
    next();
    return true;
  }

  /// A number with a unit of length, metres without.
  bool length(double& metres) {
    if (!number(metres)) return false;
    if (is("mm") || is("cm") || is("m")) {
      metres *= is("mm") ? 1e-3 : is("cm") ? 1e-2 : 1;
      next();
    }
    if (std::abs(metres) <= kFarthest) return true;
    return expected("a length below 1000 km");
  }

  bool number(double& value) {
    const bool negative = token_.is_symbol('-');
    if (negative) next();
    if (token_.kind != Token::Kind::number) return expected("a number");
    const std::string_view digits = token_.text();
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return expected("a number");
    if (negative) value = -value;
    next();
    return true;
  }

  // ---- how elements are moved

  bool is_term() const {
    for (const std::string_view word :
         {"by", "hook", "adjust", "release", "grip", "mass", "density", "priority", "unlinked"}) {
      if (is(word)) return true;
    }
    return false;
  }

  /// One of them, up to its ';'.
  bool term(MoveTerms& terms) {
    const std::string_view word = token_.text();
    next();
    if (word == "unlinked") {
      terms.unlinked = true;
      return true;
    }
    const char* const begin = token_.begin;
    if (word == "density") {
      double density = 0;
      if (!number(density)) return false;
      const bool tons = is("t");
      const bool bare = !tons && !is("kg");
      if (!bare) {
        next();
        if (!token_.is_symbol('/')) return expected("a density in kg/m3 or t/m3");
        next();
        if (!is("m3")) return expected("a density in kg/m3 or t/m3");
        next();
        if (tons) density *= 1000;
      }
      if (!(density > 0)) return expected("a density above 0, in kg for each cubic metre");
      if (bare && density <= interpreter::kLightestDensity) {
        diagnostics_.warning(
            "P22", span_of(begin, last_end_),
            fmt::format("density {0:g} has no unit and is taken as {0:g} kg/m3: are tons meant?",
                        density),
            fmt::format("write {0:g} t/m3 or {0:g} kg/m3", density));
      }
      terms.density = density;
      terms.mass.clear();
      terms.places.insert_or_assign("mass", span_of(begin, last_end_));
      return true;
    }
    std::string& text = word == "by"         ? terms.by
                        : word == "hook"     ? terms.hook
                        : word == "adjust"   ? terms.adjust
                        : word == "grip"     ? terms.grip
                        : word == "mass"     ? terms.mass
                        : word == "priority" ? terms.priority
                                             : terms.release;
    if (!words(word, text)) return false;
    terms.places.insert_or_assign(std::string(word), span_of(begin, last_end_));
    return true;
  }

  /// The text up to the next ';', as it stands.
  bool words(std::string_view word, std::string& text) {
    const char* const begin = token_.begin;
    while (!token_.is_symbol(';')) {
      if (token_.kind == Token::Kind::end || token_.is_symbol('{') || token_.is_symbol('}') ||
          begins_statement(word)) {
        return expected(fmt::format("';' after {}", word));
      }
      next();
    }
    if (begin == token_.begin) return expected("something before ';'");
    text = std::string(begin, last_end_);
    return true;
  }

  /// Whether the next statement begins here, so that the ';' of the last one is missing.
  bool begins_statement(std::string_view of) const {
    if (!token_.first_on_line) return false;
    if (is("by")) return of != "hook" && of != "adjust" && of != "release";
    return is_term() || is_field() || is("stock") || is("plan");
  }

  // ---- rules

  bool is_field() const {
    for (const auto& [word, field] : kFields) {
      if (is(word)) return true;
    }
    return false;
  }

  bool rule() {
    MatchRule rule;
    const char* const begin = token_.begin;
    while (is_field()) {
      if (!condition(rule)) return false;
    }
    if (!token_.is_symbol('-')) return expected("->", "conditions -> task \"NAME\";");
    next();
    if (!token_.is_symbol('>')) return expected("->");
    next();
    rule.terms = defaults_;
    if (!action(rule)) return false;
    rule.span = span_of(begin, last_end_);
    const bool closed = *(last_end_ - 1) == '}';
    if (token_.is_symbol(';')) {
      next();
    } else if (!closed) {
      return take(';', "after a rule");
    }
    result_.rules.push_back(std::move(rule));
    return true;
  }

  bool condition(MatchRule& rule) {
    MatchRule::Condition condition;
    for (const auto& [word, field] : kFields) {
      if (is(word)) condition.field = field;
    }
    next();
    if (token_.kind == Token::Kind::string) {
      if (!string(condition.pattern)) return false;
    } else if (token_.kind == Token::Kind::name && condition.field == Field::type) {
      condition.pattern = token_.text();
      next();
      if (token_.is_symbol('*') && token_.begin == last_end_) {  // IfcWall*
        condition.pattern += '*';
        next();
      }
    } else {
      return expected("a pattern such as \"*floor*\"");
    }
    rule.conditions.push_back(std::move(condition));
    return true;
  }

  /// The string at hand without its marks.
  bool string(std::string& text) {
    const std::string_view whole = token_.text();
    if (whole.size() < 2 || whole.back() != '"') return expected("'\"' at the end of this text");
    text = whole.substr(1, whole.size() - 2);
    next();
    return true;
  }

  bool action(MatchRule& rule) {
    if (is("stands")) {
      rule.action = MatchRule::Action::stands;
      next();
      return true;
    }
    if (is("leave")) {
      next();
      if (!is("out")) return expected("'out' after leave");
      rule.action = MatchRule::Action::leave_out;
      next();
      return true;
    }
    if (!is("task")) return expected("task, stands or leave out");
    next();
    rule.task_span = span_of(token_.begin, token_.end);
    if (token_.kind == Token::Kind::string) {
      if (!string(rule.task)) return false;
    } else if (token_.kind == Token::Kind::name) {
      rule.task = token_.text();
      rule.in_plan = true;
      next();
    } else {
      return expected("the name of a task");
    }
    return !token_.is_symbol('{') || own_terms(rule.terms);
  }

  /// { hook 4 min by riggers; density 2400; }
  bool own_terms(MoveTerms& terms) {
    next();
    while (!token_.is_symbol('}')) {
      if (is("stock")) {
        next();
        if (token_.kind != Token::Kind::name) return expected("the name of a stock area");
        terms.stock = token_.text();
        next();
      } else if (!is_term()) {
        return expected(
            "by, hook, adjust, release, grip, mass, density, priority, stock, unlinked or '}'");
      } else if (!term(terms)) {
        return false;
      }
      if (!take(';', "after it")) return false;
    }
    next();
    return true;
  }

  const std::string& text_;
  interpreter::FileId file_;
  interpreter::Diagnostics& diagnostics_;
  const char* at_ = nullptr;
  const char* last_end_ = nullptr;
  Token token_;
  MoveTerms defaults_;
  MatchFile result_;
};

}  // namespace

MatchFile read_match_file(const interpreter::SourceMap& sources, interpreter::FileId file,
                          interpreter::Diagnostics& diagnostics) {
  return MatchReader(sources, file, diagnostics).read();
}

}  // namespace rubicon::building_io
