#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <sstream>

#include "interpreter/functions/function_table.hpp"
#include "interpreter/parse/parse_state.hpp"
#include "interpreter/syntax/utf8_character.hpp"

/// What is said about a mistake: the part of ParseState that looks at the wrong text once more.
namespace rubicon::interpreter {

namespace {

using Kind = Token::Kind;

/// Words of a line that are looked at to tell a remark from a statement.
constexpr int kMaxRemarkTokens = 64;

const std::vector<std::string>& commands() {
  static const std::vector<std::string> names{"move_to", "move_dir", "together", "wait",
                                              "var",     "chain",    "cycle",    "first",
                                              "each",    "which",    "behaviour"};
  return names;
}

/// Whether a character is, as far as people who write plans are concerned, a letter of another
/// alphabet: Latin with marks, Greek, Cyrillic, Kana, Han, Hangul.
bool is_other_letter(char32_t code) {
  struct Range {
    char32_t from, to;
  };
  constexpr Range kLetters[] = {{0xC0, 0xD6},     {0xD8, 0xF6},     {0xF8, 0x24F},
                                {0x370, 0x52F},   {0x1E00, 0x1FFF}, {0x3040, 0x30FF},
                                {0x3400, 0x9FFF}, {0xAC00, 0xD7A3}};
  return std::any_of(std::begin(kLetters), std::end(kLetters),
                     [&](const Range& each) { return each.from <= code && code <= each.to; });
}

/// What to write here for a word that other languages have.
std::string other_languages_word(std::string_view word) {
  if (word == "if" || word == "else" || word == "switch" || word == "case") {
    return "a choice is written which { when (...): ... default: ... }";
  }
  if (word == "while" || word == "for" || word == "loop" || word == "repeat") {
    return "what repeats is a chain, cycle or first";
  }
  return {};
}

bool stands_in_names(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// A name with hyphens round `at`, a hyphen, as it would be written without; "" if there is none.
std::string without_hyphens(const char* begin, const char* at, const char* end) {
  const auto inside = [&](const char* c) {
    return c > begin && c + 1 < end && *c == '-' && stands_in_names(c[-1]) && stands_in_names(c[1]);
  };
  if (!inside(at)) return {};
  const char* from = at;
  while (from > begin && (stands_in_names(from[-1]) || inside(from - 1))) --from;
  const char* to = at;
  while (to < end && (stands_in_names(*to) || inside(to))) ++to;
  if (*from >= '0' && *from <= '9') return {};
  std::string name(from, to);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::vector<std::string> split(const char* words) {
  std::istringstream stream(words);
  std::vector<std::string> result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

bool is_light(const Token& token) {
  return token.is_symbol(',') || token.is_symbol('.') || token.is_symbol(':') ||
         token.is_symbol('-') || token.kind == Kind::invalid || token.kind == Kind::number;
}

}  // namespace

std::string ParseState::expand(const char* what) const {
  std::string text = what;
  const auto replace = [&text](std::string_view place, std::string_view by) {
    const std::size_t at = text.find(place);
    if (at != std::string::npos) text.replace(at, place.size(), by);
  };
  replace("{in}", braces_.empty() ? std::string_view("file") : braces_.back().structure);
  replace("{of}", announced_);
  return text;
}

void ParseState::fail(const char* at, const grammar::Expectation& expectation) {
  const Token bad = token(at);
  if (bad.begin != last_error_) {
    if (in_script() && is_remark(item_begin_, bad.begin)) fail_remark(item_begin_);
    if (bad.kind == Kind::invalid) {
      const std::size_t length = utf8_length(bad.begin, end_);
      const auto byte = static_cast<unsigned char>(*bad.begin);
      std::string hint;
      if (*bad.begin == '&') hint = "write and";
      if (*bad.begin == '|') hint = "write or";
      if (*bad.begin == '!') hint = "write not";
      if (length == 0) {
        report(code_, bad.begin, bad.end, fmt::format("not UTF-8: byte 0x{:02x}", byte),
               "save the file as UTF-8");
      } else if (length == 1 && (byte < 0x20 || byte == 0x7f)) {
        report(code_, bad.begin, bad.end,
               byte == 0 ? "unexpected character U+0000: this is not a text file"
                         : fmt::format("unexpected character U+{:04X}", byte));
      } else if (is_other_letter(utf8_character(bad.text()).code)) {
        report(
            code_, bad.begin, bad.end,
            fmt::format("'{}' cannot stand in a name: names have the letters a to z, digits and _",
                        bad.text()),
            "what a client calls it goes into name \"...\"; of a component or task");
      } else {
        report(code_, bad.begin, bad.end, fmt::format("unexpected character '{}'", bad.text()),
               hint);
      }
    } else if (std::string name = without_hyphens(begin_, bad.begin, end_);
               !in_script() && bad.is_symbol('-') && !name.empty()) {
      report(code_, bad.begin, bad.end,
             "'-' cannot stand in a name: names have the letters a to z, digits and _",
             fmt::format("write {}", name));
    } else if (expectation.explain == grammar::Explain::statement) {
      explain_statement(bad.begin, expectation);
    } else if (expectation.explain == grammar::Explain::item) {
      explain_item(bad.begin, expectation);
    } else {
      explain_expected(bad.begin, expectation);
    }
  } else {
    ++errors_;
  }
  const bool no_brace =
      expectation.what != nullptr && std::string_view(expectation.what).starts_with("'{'");
  throw ParseFailure{bad.begin, nullptr, no_brace};
}

// Remarks without '#'.
/// A statement that is a line of words. A word that is not reserved and has another behind it on
/// its line can begin nothing else; behind a reserved one the whole line must be words.
bool ParseState::is_remark(const char* at, const char* failure) const {
  const Token first = token(at);
  if (first.kind != Kind::name) return false;
  for (const char* c = at; c < failure && c != end_; ++c) {
    if (*c == '\n') return false;
  }
  const Token second = token(first.end);
  if (second.first_on_line) return false;
  const bool reserved = is_reserved(first.text());
  if (!reserved && second.kind == Kind::name) return true;
  int words = 1;
  bool adjacent = false;
  Token previous = first;
  for (int count = 0; count < kMaxRemarkTokens; ++count) {
    const Token next = token(previous.end);
    if (next.kind == Kind::end || next.first_on_line) break;
    if (next.kind == Kind::name) {
      ++words;
      adjacent = adjacent || previous.kind == Kind::name;
    } else if (!is_light(next)) {
      return false;
    }
    previous = next;
  }
  return adjacent && words >= 3;
}

void ParseState::fail_remark(const char* at) {
  const Token first = token(at);
  Token last = first;
  int words = 1;
  bool more = false;
  const char* line_end = std::find(at, end_, '\n');
  for (Token next = token(first.end); next.kind != Kind::end && next.begin < line_end;
       next = token(next.end)) {
    if (next.kind != Kind::name) continue;
    if (words == 2) {
      more = true;
      break;
    }
    last = next;
    ++words;
  }
  std::string shown(first.begin, last.end);
  if (shown.size() > 80) {
    shown = std::string(first.text().substr(0, 40));
    more = true;
  }
  report("S03", first.begin, last.end,
         fmt::format("'{}{}' is not a statement; if it is a remark put # in front of it", shown,
                     more ? " ..." : ""));
  // On with the next line.
  throw ParseFailure{at, token(line_end).begin};
}

// Statements.
void ParseState::explain_statement(const char* at, const grammar::Expectation& expectation) {
  const Token first = token(at);
  if (first.kind == Kind::name && explain_name(first, expectation)) return;
  if (first.is_symbol('}')) {
    report_token("S04", at, "this '}' closes nothing");
    return;
  }
  std::string hint;
  if (first.kind == Kind::string) hint = "a text in quotes stands only in robot and plan files";
  report_token("S04", at, fmt::format("expected {}, found {}", expand(expectation.what), found(at)),
               hint);
}

bool ParseState::explain_name(const Token& name, const grammar::Expectation& expectation) {
  const std::string text(name.text());
  const Token next = token(name.end);
  const bool in_list = expectation.what == std::string_view("a command or structure in this {in}");
  if (is_reserved(text)) {
    if (text == "behaviour" || text == "behavior") {
      report("S04", name.begin, name.end, "a behaviour is defined outside of all braces");
    } else if (text == "until") {
      report("S04", name.begin, name.end, "until stands behind the '}' of a chain, cycle or first");
    } else if (text == "default" || text == "when") {
      report("S13", name.begin, name.end,
             fmt::format("'{}' is a label, and labels stand only in a which", text));
    } else {
      return false;
    }
    return true;
  }
  const bool structure = next.is_symbol('{');
  if (next.is_symbol('(') || structure) {
    if (!structure && find_function(text) != nullptr) {
      report("S06", name.begin, name.end,
             fmt::format("'{}' is a function: it gives a value and cannot stand as a statement",
                         text));
      return true;
    }
    const std::string wanted = other_languages_word(text);
    const std::string near = wanted.empty() ? did_you_mean(text, commands()) : std::string();
    report("S05", name.begin, name.end,
           near.empty()
               ? fmt::format("unknown command {}", found(name.begin))
               : fmt::format("unknown command {}; did you mean {}?", found(name.begin), near),
           wanted);
    return true;
  }
  if (next.is_symbol('.')) {
    const Token member = token(next.end);
    const Token behind = token(member.end);
    if (member.kind == Kind::name && behind.is_symbol('=')) {
      report("S07", behind.begin, behind.end,
             fmt::format("only variables can be assigned: write var({}.{}) = ...", text,
                         member.text()));
      return true;
    }
    return false;
  }
  if (next.is_symbol('=')) {
    report("S07", next.begin, next.end,
           fmt::format("only variables can be assigned: write var({}) = ...", text));
    return true;
  }
  if (next.is_symbol(':') && token(next.end).is_symbol('=')) {
    report("S07", next.begin, next.end,
           fmt::format("only variables can be assigned: write var({}) = ...", text));
    return true;
  }
  if (next.is_symbol(':')) {
    if (token(next.end).first_on_line && !braces_.empty()) {
      report("S03", name.begin, next.end,
             fmt::format("'{}:' is not a statement; if it is a remark put # in front of it", text));
      throw ParseFailure{name.begin, token(next.end).begin};
    }
    report("S13", name.begin, name.end,
           fmt::format(
               "'{}:' is a label, and labels stand only in a which; if it is a remark put # in "
               "front of it",
               text));
    return true;
  }
  if (next.first_on_line && !in_list) {
    report("S03", name.begin, name.end,
           fmt::format("{} is not a statement; if it is a remark put # in front of it",
                       found(name.begin)),
           "if it names a behaviour end it with ';'");
    throw ParseFailure{name.begin, next.begin};
  }
  if (next.kind == Kind::invalid) {
    fail(next.begin, expectation);
  }
  report_token("S04", next.begin,
               in_list ? fmt::format("expected ',' or '}}' in this {}, found {}",
                                     braces_.back().structure, found(next.begin))
                       : fmt::format("expected ';' before {}", found(next.begin)));
  throw ParseFailure{next.begin};
}

// Items and the rest.
void ParseState::explain_item(const char* at, const grammar::Expectation& expectation) {
  const std::vector<std::string> words = split(expectation.words);
  const Token bad = token(at);
  const std::string list = fmt::format("{}", fmt::join(words, ", "));
  if (bad.kind == Kind::name && is_item_word(bad.text())) {
    report_token(code_, at,
                 fmt::format("{} does not belong into this {}; is a '}}' missing before it?",
                             found(at), expectation.what));
    if (!braces_.empty()) braces_.back().unclosed = true;
    return;
  }
  if (bad.kind == Kind::name) {
    const std::string near = did_you_mean(std::string(bad.text()), words);
    report_token(code_, at,
                 near.empty()
                     ? fmt::format("unknown item {} in this {}", found(at), expectation.what)
                     : fmt::format("unknown item {} in this {}; did you mean {}?", found(at),
                                   expectation.what, near),
                 near.empty() ? fmt::format("a {} has {}", expectation.what, list) : std::string());
    return;
  }
  report_token(
      code_, at,
      fmt::format("expected an item of this {} or '}}', found {}", expectation.what, found(at)),
      fmt::format("a {} has {}", expectation.what, list));
}

void ParseState::explain_expected(const char* at, const grammar::Expectation& expectation) {
  const Token bad = token(at);
  std::string hint;
  if (bad.kind == Kind::name) {
    const std::string near = did_you_mean(std::string(bad.text()), split(expectation.words));
    if (!near.empty()) hint = fmt::format("did you mean {}?", near);
    const std::string_view what = expectation.what == nullptr ? "" : expectation.what;
    const bool wants_name = what.find("name") != what.npos || what.find("parameter") != what.npos;
    if (hint.empty() && wants_name && is_reserved(bad.text()))
      hint = fmt::format("{} is a reserved word", bad.text());
    if (bad.is("until")) hint = "until stands behind the '}' of a chain, cycle or first";
  }
  if (bad.is_symbol('=') && expectation.words == std::string_view("==")) {
    hint = "a comparison is written ==";
  }
  const char* code = in_script() ? "S04" : code_;
  report_token(code, at,
               expectation.what != nullptr
                   ? fmt::format("expected {}, found {}", expand(expectation.what), found(at))
                   : fmt::format("unexpected {}", found(at)),
               std::move(hint));
}

}  // namespace rubicon::interpreter
