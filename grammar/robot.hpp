#pragma once

#include "grammar/guide.hpp"

/// Robot files: bodies, their parameters, rules, frames and shapes, the tool, the behaviour.
namespace rubicon::grammar {

struct item_semicolon : semicolon {};

// Bodies.
/// A word of the next item: the ';' before it is missing.
struct body_item_word
    : sor<word<exact<"param">>, word<exact<"rule">>, word<exact<"frame">>, word<exact<"shape">>> {};
struct attribute_name : seq<not_at<body_item_word>, name> {};
struct attribute_open : open_parenthesis {};
struct attribute_number : signed_number {};
struct attribute_close : close_parenthesis {};
struct attribute
    : seq<attribute_name, opt<if_must<attribute_open, attribute_number,
                                      star<if_must<comma, attribute_number>>, attribute_close>>> {};
struct param_key : token<word<exact<"param">>> {};
struct param_name : name {};
struct derived_value : expression {};
struct param_item : if_must<param_key, param_name,
                            sor<if_must<equals, derived_value>, star<attribute>>, item_semicolon> {
};

struct rule_key : token<word<exact<"rule">>> {};
struct rule_parameter : name {};
struct rule_arrow : arrow {};
struct rule_value : expression {};
struct rule_item : if_must<rule_key, rule_parameter, rule_arrow, rule_value, item_semicolon> {};

struct frame_key : token<word<exact<"frame">>> {};
struct frame_item : if_must<frame_key, frame, item_semicolon> {};

struct shape_key : token<word<exact<"shape">>> {};
struct shape_item : if_must<shape_key, shape, item_semicolon> {};

struct behaviour_item_key : token<behaviour_word> {};
struct body_behaviour_item
    : if_must<behaviour_item_key, block_open, inline_script, block_close, opt<semicolon>> {};

struct body_item : sor<param_item, rule_item, frame_item, shape_item, body_behaviour_item> {};
struct whole_body_item : must<body_item> {};
struct body_items : nested<star<not_at<block_end>, recover<whole_body_item, item_end>>> {};

struct body_key : token<word<exact<"body">>> {};
struct body_name : name {};
struct on_key : token<word<exact<"on">>> {};
struct body_parent : name {};
struct body : if_must<body_key, body_name, opt<if_must<on_key, body_parent>>, block_open,
                      body_items, block_close> {};

// The robot.
struct setting_key : token<sor<word<exact<"time_step">>, word<exact<"sensor">>>> {};
struct setting_value : signed_number {};
struct setting_item : if_must<setting_key, setting_value, item_semicolon> {};

struct tool_key : token<word<exact<"tool">>> {};
struct tool_body : name {};
struct tool_frame : frame {};
struct tool_item : if_must<tool_key, tool_body, opt<if_must<at_key, tool_frame>>, item_semicolon> {
};

struct const_key : token<word<exact<"const">>> {};
struct const_name : name {};
struct const_equals : equals {};
struct const_value : expression {};
struct const_item : if_must<const_key, const_name, const_equals, const_value, item_semicolon> {};

struct touching_key : token<word<exact<"touching">>> {};
struct touching_name : name {};
struct touching_item : if_must<touching_key, touching_name, touching_name, item_semicolon> {};

struct capacity_key : token<word<exact<"capacity">>> {};
struct capacity_open : open_parenthesis {};
struct capacity_number : signed_number {};
struct capacity_comma : comma {};
struct capacity_close : close_parenthesis {};
struct capacity_point
    : seq<capacity_open, must<capacity_number, capacity_comma, capacity_number, capacity_close>> {};
struct capacity_item
    : if_must<capacity_key, capacity_point, star<if_must<comma, capacity_point>>, item_semicolon> {
};

struct rope_key : token<word<exact<"rope">>> {};
struct rope_name : name {};
struct rope_open : open_parenthesis {};
struct rope_radius : signed_number {};
struct rope_close : close_parenthesis {};
struct rope_from_key : token<word<exact<"from">>> {};
struct rope_to_key : token<word<exact<"to">>> {};
struct rope_body : name {};
struct rope_number : signed_number {};
struct rope_comma : comma {};
struct rope_point : if_must<at_key, rope_open, rope_number, rope_comma, rope_number, rope_comma,
                            rope_number, rope_close> {};
struct rope_end : seq<rope_body, opt<rope_point>> {};
struct rope_item : if_must<rope_key, opt<rope_name>, rope_open, rope_radius, rope_close,
                           rope_from_key, rope_end, rope_to_key, rope_end, item_semicolon> {};

struct buffer_key : token<word<exact<"buffer">>> {};
struct buffer_distance : signed_number {};
struct buffer_of_key : token<word<exact<"of">>> {};
struct buffer_body : name {};
struct buffer_item
    : if_must<buffer_key, buffer_distance,
              opt<if_must<buffer_of_key, buffer_body, star<if_must<comma, buffer_body>>>>,
              item_semicolon> {};

struct deviation_number : signed_number {};
struct deviation_item : if_must<deviation_key, deviation_number,
                                opt<if_must<comma, deviation_number>>, item_semicolon> {};

struct behaviour_file : string_literal {};
struct behaviour_in_file : if_must<behaviour_file, item_semicolon> {};
struct behaviour_in_place : if_must<block_open, inline_script, block_close, opt<semicolon>> {};
struct behaviour_source : sor<behaviour_in_file, behaviour_in_place> {};
struct behaviour_item : if_must<behaviour_item_key, behaviour_source> {};

struct robot_item : sor<setting_item, body, tool_item, const_item, touching_item, capacity_item,
                        rope_item, buffer_item, deviation_item, guide_declaration, behaviour_item> {
};
struct whole_robot_item : must<robot_item> {};
struct robot_items : nested<star<not_at<block_end>, recover<whole_robot_item, item_end>>> {};

struct robot_key : token<word<exact<"robot">>> {};
struct robot_name : name {};
struct text_finished : eof {};
struct robot : must<robot_key, robot_name, block_open, robot_items, block_close, text_finished> {};
struct robot_file : seq<space, recover<robot, text_end>> {};

}  // namespace rubicon::grammar
