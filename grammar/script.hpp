#pragma once

#include "grammar/expression.hpp"

/// Behaviour scripts: statements, loops, choices, named behaviours.
namespace rubicon::grammar {

struct element;
struct statement;

// Simple statements.
struct command_open : open_parenthesis {};
struct command_parameter : qualified_name {};
struct command_comma : comma {};
struct command_value : expression {};
struct command_close : close_parenthesis {};
struct move_to_key : token<move_to_word> {};
struct move_dir_key : token<move_dir_word> {};
struct move_command : if_must<sor<move_to_key, move_dir_key>, command_open, command_parameter,
                              command_comma, command_value, command_close> {};

struct assigned_key : token<var_word> {};
struct assigned_open : open_parenthesis {};
struct assigned_name : qualified_name {};
struct assigned_close : close_parenthesis {};
struct assigned_equals : equals {};
struct assigned_value : expression {};
struct assignment : if_must<assigned_key, assigned_open, assigned_name, assigned_close,
                            assigned_equals, assigned_value> {};

struct wait_key : token<wait_word> {};

/// The only outcome that a script may name is `unreachable`. No reserved word: what counts is the
/// parenthesis behind it.
struct stop_word : word<exact<"stop">> {};
struct stop_ahead : at<stop_word, space, one<'('>> {};
struct stop_key : token<stop_word> {};
struct stop_open : open_parenthesis {};
struct stop_reason : name {};
struct stop_close : close_parenthesis {};
struct stop : if_must<seq<stop_ahead, stop_key>, stop_open, stop_reason, stop_close> {};

/// A name alone runs a named behaviour.
struct used_name : name {};
struct use_follows : sor<one<';', ',', '}'>, eof> {};
struct use : seq<at<name, use_follows>, used_name> {};

struct block_open : open_brace {};

struct together_key : token<together_word> {};
struct together_part : move_command {};
struct next_together_part : sor<at<close_brace>, must<together_part>> {};
struct together_parts : seq<must<together_part>, star<comma, next_together_part>> {};
struct together_close : close_brace {};
struct together : if_must<together_key, block_open, together_parts, together_close> {};

struct simple : sor<move_command, assignment, together, wait_key, stop, use> {};

// Loops and each.
/// Where a list of elements ends: '}', or where it should be.
struct list_end : sor<at<one<'}'>>, eof, ask<Query::brace_is_lost>> {};
struct element_follows : sor<at<one<',', ';'>>, list_end> {};

/// A ',' was forgotten before what starts another element; reported, and passed over.
struct command_start : sor<chain_word, cycle_word, first_word, together_word, each_word, which_word,
                           move_to_word, move_dir_word, var_word, wait_word> {};
struct missing_comma : at<sor<command_start, seq<ask<Query::on_new_line>, name_text>>> {};
/// A ';' where a ',' belongs, or at the end of a loop that lost its '}'; reported.
struct semicolon_in_loop : seq<at<one<';'>>, sor<ask<Query::semicolon_ends_loop>, semicolon>> {};

struct whole_element
    : seq<must<element>, sor<element_follows, missing_comma, must<element_follows>>> {};
struct element_separator : sor<ask<Query::separator_is_waived>, comma, list_end, semicolon_in_loop,
                               missing_comma, success> {};
struct elements : star<not_at<list_end>, recover<whole_element, element_end>, element_separator> {};

/// The text ends before the '}'; reported.
struct missing_brace : eof {};
struct block_close : sor<close_brace, missing_brace> {};
struct list_close : sor<ask<Query::take_lost_brace>, close_brace, missing_brace> {};

struct chain_key : token<chain_word> {};
struct cycle_key : token<cycle_word> {};
struct first_key : token<first_word> {};
struct until_key : token<until_word> {};
struct until_open : open_parenthesis {};
struct until_condition : expression {};
struct until_close : close_parenthesis {};
struct until_clause : if_must<until_key, until_open, until_condition, until_close> {};
struct element_list : nested<elements> {};
struct loop
    : seq<if_must<sor<chain_key, cycle_key, first_key>, block_open, element_list, list_close>,
          opt<until_clause>> {};

struct each_key : token<each_word> {};
struct each : if_must<each_key, block_open, element_list, list_close> {};

// Which.
struct statement_item;

struct label_ahead : at<sor<seq<name, one<':'>>, default_word, when_word>> {};
struct label_colon : colon {};
struct default_key : token<default_word> {};
struct when_key : token<when_word> {};
struct when_open : open_parenthesis {};
struct when_condition : expression {};
struct when_close : close_parenthesis {};
struct situation_name : name {};
struct label : sor<if_must<default_key, label_colon>,
                   if_must<when_key, when_open, when_condition, when_close, label_colon>,
                   if_must<situation_name, label_colon>> {};

struct block_end : sor<at<one<'}'>>, eof> {};
struct module_end : sor<label_ahead, block_end> {};
struct module_statement : seq<not_at<module_end>, statement_item> {};
struct module_label : seq<label_ahead, recover<label, statement_end>> {};
struct module_start : success {};
struct module : seq<at<label_ahead>, module_start, plus<module_label>, star<module_statement>> {};
/// Statements without a label; reported.
struct missing_label : success {};
struct unlabelled_module : seq<not_at<module_end>, missing_label, plus<module_statement>> {};
struct which_body : star<sor<module, unlabelled_module>> {};

struct which_key : token<which_word> {};
struct modules : nested<which_body> {};
struct which : if_must<which_key, block_open, modules, block_close> {};

// Statements.
struct structure : sor<loop, each, which> {};
struct element : sor<structure, simple> {};

/// A ',' where a statement ends; reported, and taken for ';'.
struct comma_for_semicolon : comma {};
/// A ';' was forgotten before what starts another statement or at the end of the text; reported.
struct missing_semicolon
    : sor<at<sor<command_start, seq<ask<Query::on_new_line>, name_text>, behaviour_word>>, eof> {};
struct simple_end : sor<semicolon, comma_for_semicolon, at<one<'}'>>, missing_semicolon> {};
struct structure_end : opt<sor<semicolon, comma_for_semicolon>> {};

struct finished_structure : structure {};
struct finished_simple : simple {};
struct statement
    : sor<seq<finished_structure, structure_end>, seq<finished_simple, must<simple_end>>> {};
struct whole_statement : must<statement> {};
struct statement_item : sor<semicolon, recover<whole_statement, statement_end>> {};

// Scripts.
struct behaviour_key : token<behaviour_word> {};
struct behaviour_name : name {};
struct behaviour_statements : nested<star<not_at<block_end>, statement_item>> {};
struct behaviour_definition : if_must<behaviour_key, behaviour_name, block_open,
                                      behaviour_statements, block_close, opt<semicolon>> {};
struct whole_behaviour : behaviour_definition {};
struct script_item
    : sor<seq<at<behaviour_word>, recover<whole_behaviour, statement_end>>, statement_item> {};

struct script : seq<space, star<not_at<eof>, script_item>> {};

/// A script in braces, inside a robot file.
struct inline_script : nested<star<not_at<block_end>, script_item>> {};

}  // namespace rubicon::grammar
