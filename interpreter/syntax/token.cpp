#include "interpreter/syntax/token.hpp"

#include "grammar/lexical.hpp"
#include "grammar/script.hpp"
#include "interpreter/syntax/utf8_character.hpp"

namespace rubicon::interpreter {

namespace {

namespace pegtl = tao::pegtl;

using Input = pegtl::memory_input<pegtl::tracking_mode::lazy, pegtl::eol::lf_crlf, const char*>;

template <typename Rule>
bool matches(Input& in) {
  return pegtl::parse<Rule>(in);
}

template <typename Rule>
bool is_whole(std::string_view word) {
  Input in(word.data(), word.data() + word.size(), "");
  return matches<pegtl::seq<Rule, pegtl::eof>>(in);
}

Token::Kind match_token(Input& in) {
  using Kind = Token::Kind;
  if (in.empty()) return Kind::end;
  if (matches<grammar::any_name>(in)) return Kind::name;
  if (matches<grammar::any_symbol>(in)) {
    // ".5" is a number; a lone "." is not.
    if (in.current()[-1] != '.' || in.empty() || in.peek_char() < '0' || in.peek_char() > '9') {
      return Kind::symbol;
    }
    --in.iterator();
  }
  if (matches<grammar::any_number>(in)) return Kind::number;
  if (matches<grammar::any_string>(in)) return Kind::string;
  const std::size_t length = utf8_length(in.current(), in.end());
  in.bump(length > 0 ? length : 1);
  return Kind::invalid;
}

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

}  // namespace

Token next_token(const char* at, const char* end, Comments comments) {
  Token token;
  int newlines = 0;
  while (true) {
    while (at != end && is_space(*at)) {
      if (*at == '\n') ++newlines;
      ++at;
    }
    Input in(at, end, "");
    if (at == end || !matches<pegtl::sor<grammar::line_comment, grammar::block_comment>>(in)) break;
    if (comments == Comments::keep) {
      token.kind = Token::Kind::comment;
      token.begin = at;
      token.end = in.current();
      token.first_on_line = newlines > 0;
      token.blank_lines = newlines > 1 ? newlines - 1 : 0;
      return token;
    }
    for (const char* c = at; c != in.current(); ++c) {
      if (*c == '\n') ++newlines;
    }
    at = in.current();
  }
  Input in(at, end, "");
  token.kind = match_token(in);
  token.begin = at;
  token.end = in.current();
  token.first_on_line = newlines > 0;
  token.blank_lines = newlines > 1 ? newlines - 1 : 0;
  return token;
}

bool is_reserved(std::string_view word) { return is_whole<grammar::reserved_word>(word); }

bool starts_command(std::string_view word) { return is_whole<grammar::command_start>(word); }

std::size_t utf8_length(const char* at, const char* end) {
  return utf8_character({at, static_cast<std::size_t>(end - at)}).length;
}

}  // namespace rubicon::interpreter
