#pragma once

#include "grammar/recovery.hpp"

/// Values and conditions: or, and, not, comparisons, sums, products, signs.
namespace rubicon::grammar {

struct expression;
struct unary;
struct quantity;

// Names with indices, in plans: column[i], unit[0, 2].slab.
struct index_open : symbol<'['> {};
struct index_value : nested<quantity> {};
struct index_close : symbol<']'> {};
struct indices : if_must<index_open, index_value, star<if_must<comma, index_value>>, index_close> {
};
struct indexed_name : seq<name, opt<indices>> {};
/// More than one dot: of what an imported plan places or imports, yard.unit[2].slab.
struct qualified_indexed_name : seq<indexed_name, star<if_must<dot, member_name, opt<indices>>>> {};

// Operands.
struct call_open : open_parenthesis {};
struct call_close : close_parenthesis {};
struct argument : nested<expression> {};
struct next_argument : argument {};
struct arguments : opt<argument, star<if_must<comma, next_argument>>> {};
struct call : if_must<call_open, arguments, call_close> {};

struct plan_operand_name : seq<ask<Query::computes_numbers>, qualified_indexed_name> {};
struct operand_name : sor<plan_operand_name, qualified_name> {};
struct name_operand : seq<operand_name, opt<call>> {};

/// A command where a value is wanted: parsed, for the check to speak of it.
struct command_operand_word : token<sor<move_to_word, move_dir_word, wait_word>> {};
struct command_operand : seq<command_operand_word, opt<call>> {};

struct variable_open : open_parenthesis {};
struct variable_name : qualified_name {};
struct variable_close : close_parenthesis {};
struct var_key : token<var_word> {};
struct variable_operand : if_must<var_key, variable_open, variable_name, variable_close> {};

struct group_open : open_parenthesis {};
struct grouped : nested<expression> {};
struct group_close : close_parenthesis {};
struct group : if_must<group_open, grouped, group_close> {};

struct number_operand : number {};
struct operand : sor<number_operand, group, variable_operand, command_operand, name_operand> {};

// Operators.
struct negation_sign : minus_sign {};
struct affirmation_sign : plus_sign {};
struct signed_operand : nested<unary> {};
struct negation : if_must<negation_sign, signed_operand> {};
struct affirmation : if_must<affirmation_sign, signed_operand> {};
struct unary : sor<operand, negation, affirmation> {};

struct multiply_operator : symbol<'*'> {};
struct divide_operator : symbol<'/'> {};
struct factor : unary {};
struct product_tail : if_must<sor<multiply_operator, divide_operator>, factor> {};
struct product : seq<unary, star<product_tail>> {};

struct add_operator : symbol<'+'> {};
struct subtract_operator : symbol<'-'> {};
struct term : product {};
struct sum_tail : if_must<sor<add_operator, subtract_operator>, term> {};
struct sum : seq<product, star<sum_tail>> {};

struct equal_operator : token<string<'=', '='>> {};
struct not_equal_operator : token<string<'!', '='>> {};
struct less_equal_operator : token<string<'<', '='>> {};
struct greater_equal_operator : token<string<'>', '='>> {};
struct less_operator : symbol<'<'> {};
struct greater_operator : symbol<'>'> {};
struct comparison_operator : sor<equal_operator, not_equal_operator, less_equal_operator,
                                 greater_equal_operator, less_operator, greater_operator> {};
struct compared : sum {};
struct comparison_end : not_at<comparison_operator> {};
struct comparison_tail : if_must<comparison_operator, compared> {};
struct comparison : seq<sum, opt<comparison_tail, must<comparison_end>>> {};

struct not_operator : token<not_word> {};
struct negated_condition;
struct inverted : nested<negated_condition> {};
struct inversion : if_must<not_operator, inverted> {};
struct negated_condition : sor<inversion, comparison> {};

struct and_operator : token<and_word> {};
struct conjunct : negated_condition {};
struct and_tail : if_must<and_operator, conjunct> {};
struct conjunction : seq<negated_condition, star<and_tail>> {};

struct or_operator : token<or_word> {};
struct disjunct : conjunction {};
struct or_tail : if_must<or_operator, disjunct> {};
struct expression : seq<conjunction, star<or_tail>> {};

/// A number where no condition can stand; in plans it may be computed.
struct quantity : sum {};

}  // namespace rubicon::grammar
