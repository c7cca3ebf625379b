#pragma once

#include "grammar/plan.hpp"

/// Studies: many runs of one plan, what is varied in it, what is asked, what is chosen.
namespace rubicon::grammar {

struct study_semicolon : semicolon {};

struct studied_plan_key : token<word<exact<"plan">>> {};
struct studied_plan : string_literal {};
struct studied_plan_item : if_must<studied_plan_key, studied_plan, study_semicolon> {};

// What is varied.
struct vary_key : token<word<exact<"vary">>> {};
struct varied_name : qualified_indexed_name {};
struct varied_text : string_literal {};
struct varied_first : signed_number {};
struct varied_to : to_word {};
struct varied_last : signed_number {};
struct varied_by : token<word<exact<"by">>> {};
struct varied_step : signed_number {};
struct varied_range
    : seq<varied_first,
          opt<if_must<varied_to, varied_last, opt<if_must<varied_by, varied_step>>>>> {};
struct varied_value : sor<varied_text, varied_range> {};
struct vary_item : if_must<vary_key, varied_name, varied_value, star<if_must<comma, varied_value>>,
                           study_semicolon> {};

struct design_key : token<word<exact<"design">>> {};
struct design_kind : name {};
struct design_count : number {};
struct design_item : if_must<design_key, design_kind, opt<design_count>, study_semicolon> {};

// What is asked: p80(finish), width(p80(finish)), start(storey_1.slab).
struct measure;
struct measure_name : qualified_indexed_name {};
struct measure_open : open_parenthesis {};
struct measure_argument : nested<measure> {};
struct measure_close : close_parenthesis {};
struct measure : seq<measure_name, opt<if_must<measure_open, measure_argument, measure_close>>> {};

struct ask_key : token<word<exact<"ask">>> {};
struct asked : measure {};
struct ask_item : if_must<ask_key, asked, star<if_must<comma, asked>>, study_semicolon> {};

// A measure within a limit.
struct limited_measure : measure {};
struct limit_operator
    : sor<less_equal_operator, greater_equal_operator, less_operator, greater_operator> {};
struct limit_text : string_literal {};
struct limit_number : signed_number {};
struct limit_value : sor<limit_text, limit_number> {};
struct required_limit : seq<limited_measure, must<limit_operator, limit_value>> {};

struct runs_key : token<word<exact<"runs">>> {};
struct runs_at : token<word<exact<"at">>> {};
struct runs_most : token<word<exact<"most">>> {};
struct runs_count : number {};
struct runs_until : token<until_word> {};
struct runs_item : if_must<runs_key, opt<if_must<runs_at, runs_most>>, runs_count,
                           opt<if_must<runs_until, required_limit>>, study_semicolon> {};

struct seed_key : token<word<exact<"seed">>> {};
struct seed_value : number {};
struct seed_item : if_must<seed_key, seed_value, study_semicolon> {};

struct choose_best_key : token<word<exact<"choose">>> {};
struct choose_direction : name {};
struct chosen_measure : measure {};
struct choose_with : token<word<exact<"with">>> {};
struct choose_limit : required_limit {};
struct choose_best
    : if_must<choose_best_key, choose_direction, chosen_measure,
              opt<if_must<choose_with, choose_limit, star<if_must<comma, choose_limit>>>>,
              study_semicolon> {};

struct study_item
    : sor<studied_plan_item, vary_item, design_item, ask_item, runs_item, seed_item, choose_best> {
};
struct whole_study_item : must<study_item> {};
struct study_items : nested<star<not_at<block_end>, recover<whole_study_item, item_end>>> {};
struct study_file_key : token<word<exact<"study">>> {};
struct study_name : name {};
struct study_finished : eof {};
struct study
    : must<study_file_key, study_name, block_open, study_items, block_close, study_finished> {};
struct study_file : seq<space, recover<study, text_end>> {};

}  // namespace rubicon::grammar
