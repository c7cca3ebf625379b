#include "interpreter/format/format_tokens.hpp"

#include <algorithm>

#include "grammar/plan.hpp"

namespace rubicon::interpreter {

namespace {

namespace pegtl = tao::pegtl;

using Kind = Token::Kind;
using Input = pegtl::memory_input<pegtl::tracking_mode::lazy, pegtl::eol::lf_crlf, const char*>;

/// Where `Rule` ends if it matches at `at`, else null.
template <typename Rule>
const char* match_end(const char* at, const char* end) {
  Input in(at, end, "");
  return pegtl::parse<Rule>(in) ? in.current() : nullptr;
}

struct UnitBehind : pegtl::seq<pegtl::star<grammar::blank>, grammar::unit_text> {};

/// Cuts a text into what is printed as one piece: numbers with units, times and dates, comments.
class Cutter {
 public:
  Cutter(std::string_view text, TextKind kind)
      : at_(text.data()), end_(at_ + text.size()), kind_(kind) {}

  bool next(FormatToken& token) {
    const Token raw = next_token(at_, end_, Comments::keep);
    if (raw.kind == Kind::end) return false;
    const char* stop = raw.end;
    if (raw.kind == Kind::number) stop = number_end(raw);
    // `x<-1` is `x < -1` but for the arrow of a rule.
    if (raw.is("<-") && !(words_[0] == "rule")) stop = raw.begin + 1;
    token = {};
    token.kind = raw.kind;
    token.text.assign(raw.begin, stop);
    token.first_on_line = raw.first_on_line;
    token.blank_lines = raw.blank_lines;
    if (raw.kind == Kind::number) write_number(raw, stop, token.text);
    if (raw.kind == Kind::comment) clean_comment(token);
    at_ = stop;
    if (raw.kind != Kind::comment) {
      words_[0] = words_[1];
      words_[1] = token.text;
    }
    return true;
  }

 private:
  const char* number_end(const Token& raw) const {
    if (kind_ == TextKind::plan) {
      if (const char* stop = match_end<grammar::date_text>(raw.begin, end_)) return stop;
      if (const char* stop = match_end<grammar::time_text>(raw.begin, end_)) return stop;
    }
    const char* stop = match_end<UnitBehind>(raw.end, end_);
    return stop != nullptr ? stop : raw.end;
  }

  static void write_number(const Token& raw, const char* stop, std::string& text) {
    if (stop == raw.end || match_end<UnitBehind>(raw.end, stop) != stop) return;
    const char* unit = raw.end;
    while (*unit == ' ' || *unit == '\t') ++unit;
    text.assign(raw.begin, raw.end);
    text += ' ';
    for (const char* at = unit; at != stop; ++at) {
      const bool blank = *at == ' ' || *at == '\t';
      if (!blank) text += *at;
      if (blank && text.back() != ' ') text += ' ';
    }
  }

  static void clean_comment(FormatToken& token) {
    std::erase(token.text, '\r');
    while (token.text.back() == ' ' || token.text.back() == '\t') token.text.pop_back();
    token.multi_line = token.text.find('\n') != std::string::npos;
  }

  const char* at_;
  const char* const end_;
  const TextKind kind_;
  std::string words_[2];  ///< the last two tokens
};

/// Decides the blank between two tokens from them and from where they stand.
class Spacer {
 public:
  explicit Spacer(TextKind kind) : kind_(kind) {}

  bool space_between(const FormatToken& before, const FormatToken& token) {
    const bool space = decide(before, token);
    if (token.is("(") || token.is("[")) ++parentheses_;
    if (token.is(")") || token.is("]")) --parentheses_;
    if (token.is(";") || token.is("{") || token.is("}")) first_word_.clear();
    if (token.is("{")) calendars_.push_back(in_calendar());
    if (token.is("}") && !calendars_.empty()) calendars_.pop_back();
    if (token.is("{") && statement_ == "calendar") calendars_.back() = true;
    if (first_word_.empty() && token.kind == Kind::name) first_word_ = statement_ = token.text;
    if (token.is("after")) first_word_ = "after";
    if (token.is("-") || token.is("+")) sign_ = is_sign(before);
    note_value_name(before, token);
    return space;
  }

 private:
  bool in_calendar() const { return !calendars_.empty() && calendars_.back(); }

  static bool is_operand_end(const FormatToken& token) {
    return token.kind == Kind::number || token.kind == Kind::string || token.is(")") ||
           token.is("]") ||
           (token.kind == Kind::name && !token.is("and") && !token.is("or") && !token.is("not"));
  }

  /// Whether `token` names a parameter of a robot whose value comes next: `goal x 3, y -2`.
  void note_value_name(const FormatToken& before, const FormatToken& token) {
    if (token.is(".") || (before.is(".") && token.kind == Kind::name)) return;
    bool has_values = false;
    for (const char* word : {"start", "goal", "via", "park", "go", "within"}) {
      has_values = has_values || first_word_ == word;
    }
    names_value_ = has_values && token.kind == Kind::name && parentheses_ == 0 &&
                   (before.is(",") || before.is(first_word_));
  }

  /// Whether a number comes next behind the name `before` of a plan: mass -3, goal x -3, from -1.
  bool begins_number(const FormatToken& before) const {
    if (kind_ != TextKind::plan || parentheses_ > 0 || before.kind != Kind::name) return false;
    if (first_word_ == "after") return false;
    if (first_word_ == "for" && (before.is("from") || before.is("to"))) return true;
    return names_value_ || before.is(first_word_);
  }

  /// Whether '-' or '+' behind `before` is the sign of a number rather than an operator.
  bool is_sign(const FormatToken& before) const {
    if (!is_operand_end(before)) return true;
    if (parentheses_ > 0 || before.kind != Kind::name) return false;
    if (kind_ == TextKind::plan) return begins_number(before);
    if (kind_ == TextKind::study) return true;
    return before.text == first_word_ && kind_ == TextKind::robot;
  }

  bool decide(const FormatToken& before, const FormatToken& token) const {
    if (token.is_comment() || before.is_comment()) return true;
    if (token.is(";") && before.is(":")) return true;
    if (token.is(",") || token.is(";") || token.is(":") || token.is(")") || token.is("."))
      return false;
    if (before.is(".")) return token.kind == Kind::number;
    if (before.is("(") || before.is("[") || token.is("[") || token.is("]")) return false;
    if (before.is("{") && token.is("}")) return false;
    if (in_calendar() && (token.is("-") || before.is("-"))) return false;
    if ((before.is("-") || before.is("+")) && sign_) return false;
    if (token.is("(") && begins_number(before)) return true;
    if (token.is("(")) {
      return before.kind != Kind::name || before.is("and") || before.is("or") || before.is("not") ||
             before.is("until") || before.is("when") || before.is("capacity") || before.is("at") ||
             (kind_ != TextKind::script && (before.is("from") || before.is("to")));
    }
    return true;
  }

  const TextKind kind_;
  int parentheses_ = 0;
  bool sign_ = false;
  bool names_value_ = false;  ///< the last token is a parameter of a robot whose value comes next
  std::string first_word_;    ///< of this statement, or "after" behind it
  std::string statement_;     ///< the first word of the statement that opens the next brace
  std::vector<bool> calendars_;
};

}  // namespace

std::vector<FormatToken> format_tokens(std::string_view text, TextKind kind) {
  Cutter cutter(text, kind);
  Spacer spacer(kind);
  std::vector<FormatToken> tokens;
  FormatToken before;
  for (FormatToken token; cutter.next(token);) {
    if (token.is_comment()) {
      token.space_before = true;
    } else {
      token.space_before =
          spacer.space_between(before, token) || (!tokens.empty() && tokens.back().is_comment());
      before = token;
    }
    tokens.push_back(std::move(token));
  }
  return tokens;
}

}  // namespace rubicon::interpreter
