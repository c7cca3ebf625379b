#pragma once

#include <tao/pegtl.hpp>

/// The tokens of scripts, robots and plans. Every token takes the white space and comments behind
/// it, so that a rule that fails after a token fails exactly where the next token stands.
namespace rubicon::grammar {

using namespace tao::pegtl;

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

struct chain_word : word<TAO_PEGTL_STRING("chain")> {};
struct cycle_word : word<TAO_PEGTL_STRING("cycle")> {};
struct first_word : word<TAO_PEGTL_STRING("first")> {};
struct together_word : word<TAO_PEGTL_STRING("together")> {};
struct each_word : word<TAO_PEGTL_STRING("each")> {};
struct which_word : word<TAO_PEGTL_STRING("which")> {};
struct when_word : word<TAO_PEGTL_STRING("when")> {};
struct default_word : word<TAO_PEGTL_STRING("default")> {};
struct until_word : word<TAO_PEGTL_STRING("until")> {};
struct move_to_word : word<TAO_PEGTL_STRING("move_to")> {};
struct move_dir_word : word<TAO_PEGTL_STRING("move_dir")> {};
struct var_word : word<TAO_PEGTL_STRING("var")> {};
struct and_word : word<TAO_PEGTL_STRING("and")> {};
struct or_word : word<TAO_PEGTL_STRING("or")> {};
struct not_word : word<TAO_PEGTL_STRING("not")> {};
struct wait_word : word<TAO_PEGTL_STRING("wait")> {};
struct behaviour_word : word<sor<TAO_PEGTL_STRING("behaviour"), TAO_PEGTL_STRING("behavior")>> {};

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

/// Longest first; `m/s` is one unit, without space inside.
struct simple_unit
    : sor<word<TAO_PEGTL_STRING("mm/s2")>, word<TAO_PEGTL_STRING("deg/s2")>,
          word<TAO_PEGTL_STRING("rad/s2")>, word<TAO_PEGTL_STRING("m/s2")>,
          word<TAO_PEGTL_STRING("mm/s")>, word<TAO_PEGTL_STRING("deg/s")>,
          word<TAO_PEGTL_STRING("rad/s")>, word<TAO_PEGTL_STRING("km/h")>,
          word<TAO_PEGTL_STRING("m/s")>, word<TAO_PEGTL_STRING("mm")>, word<TAO_PEGTL_STRING("cm")>,
          word<TAO_PEGTL_STRING("min")>, word<TAO_PEGTL_STRING("deg")>,
          word<TAO_PEGTL_STRING("rad")>, word<TAO_PEGTL_STRING("rpm")>,
          word<TAO_PEGTL_STRING("kg/m3")>, word<TAO_PEGTL_STRING("t/m3")>,
          word<TAO_PEGTL_STRING("kg")>, word<TAO_PEGTL_STRING("m2")>, word<TAO_PEGTL_STRING("m3")>,
          word<one<'m'>>, word<one<'s'>>, word<one<'h'>>, word<one<'t'>>, word<one<'l'>>> {};
struct per_unit : seq<word<TAO_PEGTL_STRING("per")>, plus<blank>, simple_unit> {};
/// m, t per m3, per h.
struct unit_text : sor<seq<simple_unit, opt<seq<plus<blank>, per_unit>>>, per_unit> {};

/// Words that may follow a number without being its unit: what follows it in a plan or a condition,
/// and parameters (a comma was forgotten) or calls (an operator was).
struct follows_number
    : sor<reserved_word, word<TAO_PEGTL_STRING("by")>, word<TAO_PEGTL_STRING("at")>,
          word<TAO_PEGTL_STRING("as")>, word<TAO_PEGTL_STRING("after")>,
          word<TAO_PEGTL_STRING("to")>, word<TAO_PEGTL_STRING("of")>,
          word<TAO_PEGTL_STRING("outside")>,
          seq<word<TAO_PEGTL_STRING("per")>, plus<blank>, word<TAO_PEGTL_STRING("day")>>,
          word<one<'x', 'y', 'z'>>, word<TAO_PEGTL_STRING("psi")>, word<TAO_PEGTL_STRING("phi")>,
          word<TAO_PEGTL_STRING("theta")>, word<greek_letter>,
          seq<identifier_text, star<blank>, one<'(', '.', '{', ':', '='>>> {};
/// Any other word in a unit's place is a misspelt unit; an action reports it.
struct unknown_unit : seq<not_at<follows_number>, identifier_text> {};

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
