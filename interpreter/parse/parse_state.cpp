#include "interpreter/parse/parse_state.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "interpreter/syntax/utf8_character.hpp"

namespace rubicon::interpreter {

namespace {

/// Mistakes of one file that are reported; who made more than these wants to see the first ones.
constexpr int kMaxErrors = 100;
/// How far back parentheses are looked for that a mistake left open: a statement's head.
constexpr std::ptrdiff_t kMaxParenthesisDistance = 4096;
/// Longer tokens are cut in messages.
constexpr std::size_t kMaxShown = 40;

bool is_loop(std::string_view structure) {
  return structure == "chain" || structure == "cycle" || structure == "first" ||
         structure == "each";
}

}  // namespace

ParseState::ParseState(const SourceMap& sources, FileId file, Diagnostics& diagnostics,
                       const char* code, std::vector<std::string_view> item_words)
    : file_(file),
      diagnostics_(diagnostics),
      code_(code),
      item_words_(std::move(item_words)),
      begin_(sources.file(file).text.data()),
      end_(begin_ + sources.file(file).text.size()) {
  last_end = begin_;
  item_begin_ = begin_;
}

Span ParseState::span(const char* from, const char* to) const {
  return {file_, static_cast<std::uint32_t>(from - begin_),
          static_cast<std::uint32_t>(std::max(from, to) - begin_)};
}

// Mistakes.
void ParseState::report(const char* code, const char* from, const char* to, std::string message,
                        std::string hint) {
  ++errors_;
  if (from == last_error_) return;
  last_error_ = from;
  if (std::any_of(braces_.begin(), braces_.end(),
                  [](const OpenBrace& brace) { return brace.unclosed; })) {
    return;
  }
  diagnostics_.error(code, span(from, to), std::move(message), std::move(hint));
  if (++reported_ >= kMaxErrors) {
    diagnostics_.note(code_, span(from, to),
                      fmt::format("{} mistakes: the rest of this file was not read", kMaxErrors));
    throw ParseAborted{};
  }
}

void ParseState::report_token(const char* code, const char* at, std::string message,
                              std::string hint) {
  const Token bad = token(at);
  report(code, bad.begin, bad.end, std::move(message), std::move(hint));
}

void ParseState::check_bytes() {
  const std::string_view text(begin_, static_cast<std::size_t>(end_ - begin_));
  const std::size_t bad = std::min(first_not_utf8(text), text.find('\0'));
  if (bad == std::string_view::npos) return;
  const char* const at = begin_ + bad;
  if (*at == '\0') {
    report(code_, at, at + 1, "unexpected character U+0000: this is not a text file");
  } else {
    report(code_, at, at + 1,
           fmt::format("not UTF-8: byte 0x{:02x}", static_cast<unsigned char>(*at)),
           "save the file as UTF-8");
  }
}

std::string ParseState::found(const char* at) const {
  const Token next = token(at);
  if (next.kind == Token::Kind::end) return "the end of the file";
  std::string_view text = next.text();
  if (text.size() <= kMaxShown) return fmt::format("'{}'", text);
  std::size_t cut = kMaxShown;
  while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xc0u) == 0x80u) --cut;
  return fmt::format("'{}...'", text.substr(0, cut));
}

// Going on.
void ParseState::roll_back(const Checkpoint& checkpoint) {
  abandoned_braces_ = static_cast<int>(braces_.size()) - static_cast<int>(checkpoint.braces);
  braces_.resize(checkpoint.braces);
  nesting_ = checkpoint.nesting;
  item_begin_ = checkpoint.item_begin;
  lost_braces_ = 0;
  indexed_.clear();
  dot_ = false;
}

void ParseState::enter(const char* at) {
  if (nesting_ >= kMaxNesting) {
    report_token(code_, at, fmt::format("nested more than {} deep", kMaxNesting));
    throw ParseFailure{at};
  }
  ++nesting_;
}

int ParseState::open_parentheses_before(const char* begin, const char* at) const {
  const char* const limit =
      at - begin > kMaxParenthesisDistance ? at - kMaxParenthesisDistance : begin;
  int open = 0;
  for (const char* c = at; c != limit;) {
    --c;
    if (*c == '{' || *c == '}' || *c == ';') break;
    if (*c == '(') ++open;
    if (*c == ')') --open;
  }
  return std::max(open, 0);
}

bool ParseState::is_item_word(std::string_view word) const {
  return std::find(item_words_.begin(), item_words_.end(), word) != item_words_.end();
}

bool ParseState::in_script() const {
  return code_ == std::string_view("S04") ||
         std::any_of(braces_.begin(), braces_.end(),
                     [](const OpenBrace& brace) { return brace.structure == "behaviour"; });
}

const char* ParseState::skip(grammar::Resume resume, const char* begin,
                             const ParseFailure& failure) {
  using grammar::Resume;
  separator_waived_ = resume == Resume::element;
  skipped_remark_ = failure.resume != nullptr;
  if (failure.resume != nullptr) return failure.resume;
  if (resume == Resume::nowhere) return end_;
  const char* at = failure.at;
  int parentheses = open_parentheses_before(begin, at);
  int braces = abandoned_braces_;
  const bool no_brace = failure.no_brace && resume == Resume::item && braces == 0;
  if (no_brace) ++braces;  // its parts are passed over, as far as it seems to reach
  const std::ptrdiff_t column = no_brace ? column_of(begin) : 0;
  while (true) {
    const Token next = token(at);
    if (next.kind == Token::Kind::end) return end_;
    const bool moved = next.begin != begin;
    if (no_brace && braces == 1 && moved && is_first_on_line(next.begin)) {
      const bool is_item = next.kind == Token::Kind::name && is_item_word(next.text());
      if (is_item && column_of(next.begin) <= column) return next.begin;
      if (next.is_symbol('}') && column_of(next.begin) < column) return next.begin;
    }
    if (braces == 0) {
      if (next.is_symbol('}') && !braces_.empty()) return next.begin;
      if (next.is_symbol(';')) {
        if (resume == Resume::element) separator_waived_ = false;
        return resume == Resume::element ? next.begin : token(next.end).begin;
      }
      if (resume == Resume::element && next.is_symbol(',') && !moved) return token(next.end).begin;
      if (resume == Resume::element && next.is_symbol(',') && moved &&
          (parentheses == 0 || starts_command(token(next.end).text()))) {
        separator_waived_ = false;
        return next.begin;
      }
      if (moved && next.kind == Token::Kind::name && is_first_on_line(next.begin) &&
          (resume == Resume::item ? is_item_word(next.text()) : starts_command(next.text()))) {
        return next.begin;
      }
    }
    at = next.end;
    if (next.is_symbol('(')) ++parentheses;
    if (next.is_symbol(')') && parentheses > 0) --parentheses;
    if (next.is_symbol('{')) ++braces;
    if (next.is_symbol('}') && --braces <= 0) {
      const Token behind = token(at);
      if (braces < 0) return behind.begin;
      if (resume != Resume::element && !behind.is("until")) {
        return behind.is_symbol(';') ? token(behind.end).begin : behind.begin;
      }
    }
  }
}

bool ParseState::is_first_on_line(const char* at) const {
  while (at != begin_ && (at[-1] == ' ' || at[-1] == '\t')) --at;
  return at == begin_ || at[-1] == '\n';
}

std::ptrdiff_t ParseState::column_of(const char* at) const {
  const char* line = at;
  while (line != begin_ && line[-1] != '\n') --line;
  return at - line;
}

bool ParseState::ask(grammar::Query query, const char* at) {
  using grammar::Query;
  switch (query) {
    case Query::brace_is_lost:
      return lost_braces_ > 0;
    case Query::take_lost_brace:
      if (lost_braces_ == 0) return false;
      --lost_braces_;
      braces_.pop_back();
      return true;
    case Query::separator_is_waived: {
      const bool waived = separator_waived_;
      separator_waived_ = false;
      return waived;
    }
    case Query::semicolon_ends_loop:
      return semicolon_ends_loop(at);
    case Query::on_new_line:
      return is_first_on_line(at);
    case Query::computes_numbers:
      return computes_numbers_;
  }
  return false;
}

// Braces.
void ParseState::open_brace(const char* at) {
  braces_.push_back({announced_, at, errors_, is_loop(announced_), false, false});
}

void ParseState::close_brace() {
  if (!braces_.empty()) braces_.pop_back();
}

void ParseState::missing_brace(const char* at) {
  if (braces_.empty()) return;
  const OpenBrace brace = braces_.back();
  braces_.pop_back();
  if (brace.errors == errors_) {
    ++errors_;
    if (at != last_error_) {
      last_error_ = at;
      diagnostics_.add(
          {Severity::error,
           code_,
           span(at, at),
           fmt::format("missing '}}' to close this {}", brace.structure),
           {{span(brace.at, brace.at + 1), fmt::format("this {} begins here", brace.structure)}},
           {}});
    }
  }
}

void ParseState::missing_comma(const char* at) {
  if (is_remark(item_begin_, at)) fail_remark(item_begin_);
  if (braces_.empty()) return;
  report_token("S04", at,
               fmt::format("expected ',' or '}}' in this {}, found {}", braces_.back().structure,
                           found(at)));
  braces_.back().complained = true;
}

void ParseState::missing_semicolon(const char* at) {
  if (is_remark(item_begin_, at)) fail_remark(item_begin_);
  if (at == end_) {
    report("S04", at, at, "expected ';' before the end of the file");
  } else {
    report_token("S04", at, fmt::format("expected ';' before {}", found(at)));
  }
}

void ParseState::comma_for_semicolon(const char* at) {
  if (is_remark(item_begin_, at)) fail_remark(item_begin_);
  if (token(at + 1).kind == Token::Kind::number) {
    report("S04", at, at + 1, "expected ';', found ','", "a decimal point is written '.'");
    throw ParseFailure{at};
  }
  report("S02", at, at + 1,
         "',' separates the elements of a chain, cycle or each; a statement ends with ';'");
}

int ParseState::closers_behind(const char* at) {
  if (!brace_index_built_) {
    brace_index_built_ = true;
    int depth = 0;
    for (Token next = token(begin_); next.kind != Token::Kind::end; next = token(next.end)) {
      if (next.is_symbol('{')) ++depth;
      if (next.is_symbol('}')) --depth;
      if (next.is_symbol('{') || next.is_symbol('}'))
        brace_index_.push_back({next.begin, depth, depth});
    }
    for (std::size_t i = brace_index_.size(); i-- > 1;) {
      brace_index_[i - 1].minimum = std::min(brace_index_[i - 1].depth, brace_index_[i].minimum);
    }
  }
  const auto behind =
      std::upper_bound(brace_index_.begin(), brace_index_.end(), at,
                       [](const char* place, const Brace& brace) { return place < brace.at; });
  if (behind == brace_index_.end()) return 0;
  const int depth = behind == brace_index_.begin() ? 0 : (behind - 1)->depth;
  return std::max(0, depth - behind->minimum);
}

/// A brace is lost if the rest of the file closes fewer than are open; then this loop ends here.
/// Otherwise the ';' was meant to be a ','.
bool ParseState::semicolon_ends_loop(const char* at) {
  if (at == known_semicolon_ || braces_.empty()) return false;
  known_semicolon_ = at;
  const int lost = std::max(0, static_cast<int>(braces_.size()) - closers_behind(at));
  if (lost == 0 || !braces_.back().complained) {
    report(
        "S01", at, at + 1,
        fmt::format("';' ends a statement, but this {} is still open: separate its elements with "
                    "',' or close it with '}}'",
                    braces_.back().structure));
  } else {
    ++errors_;
  }
  int loops = 0;
  while (static_cast<std::size_t>(loops) < braces_.size() &&
         braces_[braces_.size() - 1 - loops].loop)
    ++loops;
  lost_braces_ = std::min(lost, loops);
  return lost_braces_ > 0;
}

}  // namespace rubicon::interpreter
