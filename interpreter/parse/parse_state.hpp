#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/expectation.hpp"
#include "interpreter/parse/parse.hpp"
#include "interpreter/syntax/diagnostic.hpp"
#include "interpreter/syntax/syntax.hpp"
#include "interpreter/syntax/token.hpp"

namespace rubicon::interpreter {

/// A mistake was reported; the parse goes on at the nearest grammar::recover around it.
struct ParseFailure {
  const char* at = nullptr;      ///< where the mistake stands
  const char* resume = nullptr;  ///< where to go on, if that is known: behind a remark
  bool no_brace = false;         ///< the '{' of a block is missing: what follows may be its parts
};

/// Too many mistakes: the rest of the file is not read.
struct ParseAborted {};

/// What all parsers share: places, mistakes, how to go on after them, names, numbers and strings.
class ParseState {
 public:
  using Failure = ParseFailure;

  ParseState(const SourceMap& sources, FileId file, Diagnostics& diagnostics, const char* code,
             std::vector<std::string_view> item_words);

  // Places.
  const char* begin() const { return begin_; }
  const char* end() const { return end_; }
  Span span(const char* from, const char* to) const;
  /// From `from` to the end of the last token.
  Span span_from(const char* from) const { return span(from, last_end); }

  const char* last_end = nullptr;  ///< end of the last token, without the space behind it

  // Mistakes.
  /// Reports an error of [from, to); a second one at the same place is dropped.
  void report(const char* code, const char* from, const char* to, std::string message,
              std::string hint = {});
  /// The same for the token at `at`.
  void report_token(const char* code, const char* at, std::string message, std::string hint = {});
  /// Reports what was expected at `at` and throws ParseFailure.
  [[noreturn]] void fail(const char* at, const grammar::Expectation& expectation);
  /// Reports what the text holds that is not UTF-8 or not text at all.
  void check_bytes();

  int errors() const { return errors_; }
  /// "'move_to'", "the end of the file": what stands at `at`.
  std::string found(const char* at) const;

  // Grammar::recover, nested, ask.
  struct Checkpoint {
    std::size_t braces = 0;
    int nesting = 0;
    const char* item_begin = nullptr;
  };
  Checkpoint checkpoint() const { return {braces_.size(), nesting_, item_begin_}; }
  void roll_back(const Checkpoint& checkpoint);
  void begin_item(const char* at) { item_begin_ = at; }
  const char* skip(grammar::Resume resume, const char* begin, const ParseFailure& failure);
  bool ask(grammar::Query query, const char* at);
  void enter(const char* at);
  void leave() { --nesting_; }
  bool skipped_remark() const { return skipped_remark_; }

  // Braces.
  /// The structure whose '{' comes next: "chain", "body". Must outlive the parse.
  void announce(std::string_view structure) { announced_ = structure; }
  void open_brace(const char* at);
  void close_brace();
  /// The text ends before the '}': reported, unless an earlier mistake may be the reason.
  void missing_brace(const char* at);
  /// A ',' was forgotten at `at` (or the element before it is a remark: throws).
  void missing_comma(const char* at);
  void missing_semicolon(const char* at);
  /// A ',' ends a statement (or that of a remark: throws).
  void comma_for_semicolon(const char* at);

  // Tokens with a value.
  void set_name(const char* from, const char* to);
  void set_dot() { dot_ = true; }
  syntax::Name take_name();
  syntax::QualifiedName take_qualified_name();
  /// The '[' behind the last name, what stands behind it, the ']'.
  void open_indices();
  void add_index(syntax::ExpressionPtr index) {
    indexed_.back().indices.push_back(std::move(index));
  }
  void close_indices();
  bool has_open_indices() const { return !indexed_.empty(); }

  syntax::Number number;  ///< the last one
  syntax::String string;  ///< the last one
  const char* string_begin = nullptr;
  void set_number(const char* from, const char* to);
  void set_unit(const char* from, const char* to);
  void unknown_unit(const char* from, const char* to);

 protected:
  bool computes_numbers_ = false;  ///< expressions stand where numbers do, names have indices

 private:
  struct OpenBrace {
    std::string_view structure;
    const char* at;
    int errors;       ///< mistakes before it
    bool loop;        ///< its elements are separated by ','
    bool complained;  ///< a mistake between its elements was reported
    bool unclosed;    ///< its '}' was said to be missing: nothing more is said of what is in it
  };
  struct Brace {
    const char* at;
    int depth;    ///< braces open behind it, counted from the start of the file
    int minimum;  ///< the least depth from here to the end of the file
  };

  void join_body();
  std::string expand(const char* what) const;
  bool is_remark(const char* at, const char* failure) const;
  [[noreturn]] void fail_remark(const char* at);
  void explain_statement(const char* at, const grammar::Expectation& expectation);
  bool explain_name(const Token& name, const grammar::Expectation& expectation);
  void explain_item(const char* at, const grammar::Expectation& expectation);
  void explain_expected(const char* at, const grammar::Expectation& expectation);
  int closers_behind(const char* at);
  bool semicolon_ends_loop(const char* at);
  int open_parentheses_before(const char* begin, const char* at) const;
  bool is_item_word(std::string_view word) const;
  /// Inside a behaviour, where codes are those of scripts.
  bool in_script() const;
  Token token(const char* at) const { return next_token(at, end_); }

  FileId file_;
  Diagnostics& diagnostics_;
  const char* const code_;  ///< of plain syntax errors
  const std::vector<std::string_view> item_words_;
  const char* const begin_;
  const char* const end_;

  bool is_first_on_line(const char* at) const;
  std::ptrdiff_t column_of(const char* at) const;

  int errors_ = 0;
  int reported_ = 0;
  const char* last_error_ = nullptr;
  int nesting_ = 0;
  const char* item_begin_ = nullptr;
  std::string_view announced_;
  std::vector<OpenBrace> braces_;
  std::vector<Brace> brace_index_;
  bool brace_index_built_ = false;
  int lost_braces_ = 0;
  int abandoned_braces_ = 0;  ///< open where a mistake was raised, inside what is passed over
  const char* known_semicolon_ = nullptr;
  bool separator_waived_ = false;
  bool skipped_remark_ = false;
  syntax::QualifiedName name_;
  struct IndexedName {
    syntax::QualifiedName name;
    std::vector<syntax::ExpressionPtr> indices;
  };
  std::vector<IndexedName> indexed_;  ///< whose brackets are open
  bool dot_ = false;
};

}  // namespace rubicon::interpreter
