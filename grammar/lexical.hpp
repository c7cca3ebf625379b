#pragma once

#include <algorithm>
#include <cstddef>
#include <tao/pegtl.hpp>
#include <utility>

/// The tokens of scripts, robots and plans. Every token takes the white space and comments behind
/// it, so that a rule that fails after a token fails exactly where the next token stands.
namespace rubicon::grammar {

using namespace tao::pegtl;

/// A text as an argument of a template.
template <std::size_t Size>
struct Letters {
  constexpr Letters(const char (&text)[Size]) { std::copy_n(text, Size, each); }
  char each[Size] = {};
};

template <Letters Text, std::size_t... Places>
string<Text.each[Places]...> string_of(std::index_sequence<Places...>);
/// exact<"to"> is string<'t', 'o'>. PEGTL's macro for that compiles twenty times as long.
template <Letters Text>
using exact = decltype(string_of<Text>(std::make_index_sequence<sizeof(Text.each) - 1>()));

// White space.
struct line_comment : seq<sor<one<'#'>, two<'/'>>, until<at<eolf>>> {};

struct comment_open : string<'/', '*'> {};
/// A comment that is never closed takes the rest of the text; an action reports it.
struct unterminated_comment : seq<comment_open, until<eof>> {};
struct block_comment
    : sor<seq<at<comment_open>, comment_open, until<string<'*', '/'>>>, unterminated_comment> {};

struct blank : one<' ', '\t'> {};
struct space : star<sor<one<' ', '\t', '\r', '\n'>, line_comment, block_comment>> {};

/// Where a token ends, before the space behind it.
struct end_of_token : success {};

template <typename... Rules>
struct token : seq<Rules..., end_of_token, space> {};

template <char C>
struct symbol : token<one<C>> {};

// Names and reserved words.
struct letter_psi : utf8::one<0x3c8, 0x3a8> {};
struct letter_phi : utf8::one<0x3c6, 0x3a6, 0x3d5> {};
struct letter_theta : utf8::one<0x3b8, 0x398, 0x3d1, 0x3f4> {};
struct greek_letter : sor<letter_psi, letter_phi, letter_theta> {};

struct name_first : sor<ranges<'a', 'z', 'A', 'Z', '_'>, greek_letter> {};
struct name_other : sor<ranges<'a', 'z', 'A', 'Z', '0', '9', '_'>, greek_letter> {};
struct identifier_text : seq<name_first, star<name_other>> {};

/// A whole word: no letter follows. Consumes nothing of another word.
template <typename Word>
struct word : seq<at<Word, not_at<name_other>>, Word> {};

struct chain_word : word<exact<"chain">> {};
struct cycle_word : word<exact<"cycle">> {};
struct first_word : word<exact<"first">> {};
struct together_word : word<exact<"together">> {};
struct each_word : word<exact<"each">> {};
struct which_word : word<exact<"which">> {};
struct when_word : word<exact<"when">> {};
struct default_word : word<exact<"default">> {};
struct until_word : word<exact<"until">> {};
struct move_to_word : word<exact<"move_to">> {};
struct move_dir_word : word<exact<"move_dir">> {};
struct var_word : word<exact<"var">> {};
struct and_word : word<exact<"and">> {};
struct or_word : word<exact<"or">> {};
struct not_word : word<exact<"not">> {};
struct wait_word : word<exact<"wait">> {};
struct behaviour_word : word<sor<exact<"behaviour">, exact<"behavior">>> {};

struct reserved_word
    : seq<at<one<'a', 'b', 'c', 'd', 'e', 'f', 'm', 'n', 'o', 't', 'u', 'v', 'w'>>,
          sor<chain_word, cycle_word, first_word, together_word, each_word, which_word, when_word,
              default_word, until_word, move_to_word, move_dir_word, var_word, and_word, or_word,
              not_word, wait_word, behaviour_word>> {};

struct name_text : seq<not_at<reserved_word>, identifier_text> {};
struct name : token<name_text> {};

/// The part behind the dot of a qualified name.
struct member_name : name {};
struct dot : symbol<'.'> {};
struct qualified_name : seq<name, opt<if_must<dot, member_name>>> {};

// Symbols.
struct open_brace : symbol<'{'> {};
struct close_brace : symbol<'}'> {};
struct open_parenthesis : symbol<'('> {};
struct close_parenthesis : symbol<')'> {};
struct comma : symbol<','> {};
struct semicolon : symbol<';'> {};
struct colon : symbol<':'> {};
struct star_sign : symbol<'*'> {};
struct plus_sign : symbol<'+'> {};
struct minus_sign : symbol<'-'> {};
struct equals : token<not_at<two<'='>>, one<'='>> {};
struct arrow : token<sor<string<'<', '-'>, utf8::one<0x2190>>> {};

// Numbers and strings.
struct digits : plus<digit> {};
struct exponent : seq<one<'e', 'E'>, opt<one<'+', '-'>>, digits> {};
struct number_text
    : seq<sor<seq<digits, opt<one<'.'>, digits>>, seq<one<'.'>, digits>>, opt<exponent>> {};

/// m2 or m², m3 or m³.
struct squared : sor<one<'2'>, utf8::one<0xB2>> {};
struct cubed : sor<one<'3'>, utf8::one<0xB3>> {};
/// Longest first; `m/s` is one unit, without space inside.
struct simple_unit
    : sor<word<seq<exact<"mm/s">, squared>>, word<seq<exact<"deg/s">, squared>>,
          word<seq<exact<"rad/s">, squared>>, word<seq<exact<"m/s">, squared>>, word<exact<"mm/s">>,
          word<exact<"deg/s">>, word<exact<"rad/s">>, word<exact<"km/h">>, word<exact<"m/s">>,
          word<exact<"mm">>, word<exact<"cm">>, word<exact<"min">>, word<exact<"deg">>,
          word<exact<"rad">>, word<exact<"rpm">>, word<seq<exact<"kg/m">, cubed>>,
          word<seq<exact<"t/m">, cubed>>, word<exact<"kg">>, word<seq<one<'m'>, squared>>,
          word<seq<one<'m'>, cubed>>, word<one<'m'>>, word<one<'s'>>, word<one<'h'>>,
          word<one<'t'>>, word<one<'l'>>> {};
struct per_unit : seq<word<exact<"per">>, plus<blank>, simple_unit> {};
/// m, t per m3, per h.
struct unit_text : sor<seq<simple_unit, opt<seq<plus<blank>, per_unit>>>, per_unit> {};

/// Words that may follow a number without being its unit: what follows it in a plan or a condition,
/// and parameters (a comma was forgotten) or calls (an operator was).
struct follows_number
    : sor<reserved_word, word<exact<"by">>, word<exact<"at">>, word<exact<"as">>,
          word<exact<"after">>, word<exact<"to">>, word<exact<"of">>, word<exact<"outside">>,
          seq<word<exact<"per">>, plus<blank>, word<exact<"day">>>, word<one<'x', 'y', 'z'>>,
          word<exact<"psi">>, word<exact<"phi">>, word<exact<"theta">>, word<greek_letter>,
          seq<identifier_text, star<blank>, one<'(', '.', '{', ':', '='>>> {};
/// Any other word in a unit's place is a misspelt unit; an action reports it.
struct unknown_unit
    : seq<not_at<follows_number>,
          sor<seq<word<exact<"per">>, plus<blank>, identifier_text>, identifier_text>> {};

/// 30, 2.5 mm, 6 m/s, 180 per h; the unit on the same line, with or without a blank.
struct number : token<number_text, opt<seq<star<blank>, sor<unit_text, unknown_unit>>>> {};

/// A number that may carry a sign, where no expression can stand.
struct negative_number : seq<minus_sign, number> {};
struct signed_number : sor<negative_number, seq<opt<plus_sign>, number>> {};

struct string_open : one<'"'> {};
struct string_content : star<not_one<'"', '\n', '\r'>> {};
/// A string that is not closed on its line ends there; an action reports it.
struct unterminated_string : success {};
struct string_literal : token<string_open, string_content, sor<one<'"'>, unterminated_string>> {};

// Any token, for messages and for going on after a mistake.
struct long_symbol : sor<string<'=', '='>, string<'!', '='>, string<'<', '='>, string<'>', '='>,
                         string<'<', '-'>, utf8::one<0x2190>> {};
struct short_symbol
    : one<'{', '}', '(', ')', '[', ']', ',', ';', ':', '=', '.', '+', '-', '*', '/', '<', '>'> {};
struct any_symbol : sor<long_symbol, short_symbol> {};
struct any_name : identifier_text {};
struct any_number : number_text {};
struct any_string : seq<string_open, string_content, opt<one<'"'>>> {};
struct any_token_text : sor<any_name, any_number, any_string, any_symbol> {};

}  // namespace rubicon::grammar
