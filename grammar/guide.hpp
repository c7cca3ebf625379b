#pragma once

#include "grammar/frame.hpp"
#include "grammar/recovery.hpp"
#include "grammar/script.hpp"

/// Guides, in robot files and in plans: where the waypoints of a motion come from.
namespace rubicon::grammar {

struct guide_key : token<word<exact<"guide">>> {};
struct guide_name : indexed_name {};
struct guide_kind : name {};

// A planner of OMPL, by its name there.
struct guide_planner : string_literal {};

struct clause_semicolon : semicolon {};
struct clause_key : name {};
struct clause_number : sor<computed_number, signed_number> {};
struct clause_parameter : qualified_name {};
struct clause_value : if_must<clause_parameter, clause_number> {};
/// Names in a number are put in parentheses; else they are those of parameters of the robot.
struct clause_values : seq<clause_value, star<if_must<comma, clause_value>>> {};
/// Words alone: those of a choice, or parameters.
struct clause_word : qualified_name {};
struct words_end : one<';'> {};
struct clause_words : seq<at<list<qualified_name, comma>, words_end>, list<clause_word, comma>> {};
struct clause_content : sor<clause_words, clause_values, clause_number> {};
struct keep_key : token<word<exact<"keep">>> {};
struct keep_open : open_parenthesis {};
struct keep_condition : expression {};
struct keep_close : close_parenthesis {};
struct keep_clause : if_must<keep_key, keep_open, keep_condition, keep_close, clause_semicolon> {};
// thinks 20 us per check;
struct thinks_key : token<word<exact<"thinks">>> {};
struct thinks_number : token<number_text> {};
struct thinks_unit : token<sor<word<exact<"us">>, word<exact<"ms">>, word<one<'s'>>>> {};
struct thinks_per : token<word<exact<"per">>> {};
struct thinks_check : token<word<exact<"check">>> {};
struct thinks_clause
    : if_must<thinks_key, thinks_number, thinks_unit, thinks_per, thinks_check, clause_semicolon> {
};
// set "goal_bias" 0.1;
struct set_key : token<word<exact<"set">>> {};
struct set_name : string_literal {};
struct set_number : sor<computed_number, signed_number> {};
struct set_clause : if_must<set_key, set_name, set_number, clause_semicolon> {};
struct number_clause : if_must<clause_key, clause_content, clause_semicolon> {};
struct guide_clause : sor<keep_clause, thinks_clause, set_clause, number_clause> {};
struct whole_guide_clause : must<guide_clause> {};
struct guide_clauses : nested<star<not_at<block_end>, recover<whole_guide_clause, item_end>>> {};
struct guide_block : if_must<block_open, guide_clauses, block_close> {};
struct guide_end : sor<clause_semicolon, guide_block> {};
struct guide_declared : if_must<guide_kind, opt<guide_planner>, guide_end> {};
struct guide_declaration : if_must<guide_key, guide_name, guide_declared> {};

// How far the tool may be beside a straight way: of a robot, and of a motion.
struct deviation_key : token<word<exact<"deviation">>> {};

// The guides of a task: a list of their names.
struct used_guide : indexed_name {};
struct next_guide : indexed_name {};
struct guide_use
    : if_must<guide_key, used_guide, star<if_must<comma, next_guide>>, clause_semicolon> {};

}  // namespace rubicon::grammar
