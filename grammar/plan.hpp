#pragma once

#include "grammar/guide.hpp"

/// Plans: the site, components, robots, crews, tasks, modules; and the short form of one motion.
namespace rubicon::grammar {

struct plan_semicolon : semicolon {};
struct to_word : token<word<exact<"to">>> {};

// Values, goals, links.
struct value_name : qualified_name {};
struct value_number : quantity {};
struct named_value : if_must<value_name, value_number> {};
struct values : seq<named_value, star<if_must<comma, named_value>>> {};

struct goal_frame : frame {};
struct goal_values : values {};
struct goal_with_values : values {};
struct goal : sor<if_must<at_key, goal_frame, opt<if_must<comma, goal_with_values>>>, goal_values> {
};

struct law_key
    : token<seq<sor<word<exact<"uniform">>, word<exact<"triangular">>, word<exact<"pert">>,
                    word<exact<"normal">>, word<exact<"lognormal">>, word<exact<"gamma">>,
                    word<exact<"exponential">>, word<exact<"sequence">>>,
                at<star<blank>, one<'('>>>> {};
struct law_open : open_parenthesis {};
struct law_value : quantity {};
struct law_close : close_parenthesis {};
/// A duration that is not certain.
struct duration_law
    : if_must<law_key, law_open, law_value, star<if_must<comma, law_value>>, law_close> {};
/// Times that were measured, from a file: measured("times.csv", min, column "hook").
struct measured_key : token<seq<word<exact<"measured">>, at<star<blank>, one<'('>>>> {};
struct measured_file : string_literal {};
struct measured_column_key : token<word<exact<"column">>> {};
struct measured_column_name : string_literal {};
struct measured_column_number : token<seq<digits, not_at<name_other>>> {};
struct measured_column : sor<measured_column_name, measured_column_number> {};
struct measured_unit : name {};
struct measured_option : sor<if_must<measured_column_key, measured_column>, measured_unit> {};
struct measured_law : if_must<measured_key, law_open, measured_file,
                              star<if_must<comma, measured_option>>, law_close> {};
struct certain_duration : quantity {};
struct duration : sor<duration_law, measured_law, certain_duration> {};
struct link_name : qualified_indexed_name {};
struct link_type : name {};
struct later : plus_sign {};
struct earlier : minus_sign {};
/// The sign before a lag is that of its first term.
struct lag_term : product {};
struct link_lag : seq<lag_term, star<sum_tail>> {};
struct link : seq<link_name, opt<link_type>, opt<if_must<sor<later, earlier>, link_lag>>> {};
struct links : seq<link, star<if_must<comma, link>>> {};
struct after_key : token<word<exact<"after">>> {};

struct listed_name : qualified_indexed_name {};
struct listed_names : seq<listed_name, star<if_must<comma, listed_name>>> {};

// What is repeated, and what is there on a condition.
struct for_key : token<word<exact<"for">>> {};
struct for_variable : name {};
struct for_from : token<word<exact<"from">>> {};
struct for_first : quantity {};
struct for_to : token<word<exact<"to">>> {};
struct for_last : quantity {};
struct for_head : if_must<for_key, for_variable, for_from, for_first, for_to, for_last> {};
struct given_key : token<when_word> {};
struct given_open : open_parenthesis {};
struct given_condition : expression {};
struct given_close : close_parenthesis {};
struct given_head : if_must<given_key, given_open, given_condition, given_close> {};

// Settings.
struct site_key : token<word<exact<"site">>> {};
struct site_item : if_must<site_key, shape, plan_semicolon> {};

struct storage_key : token<word<exact<"storage">>> {};
struct storage_name : name {};
struct storage_item : if_must<storage_key, storage_name, shape, plan_semicolon> {};

struct number_key : token<sor<word<exact<"contact">>, word<exact<"budget">>>> {};
struct number_value : quantity {};
struct number_item : if_must<number_key, number_value, plan_semicolon> {};

// Dates and times of day, which are read before numbers and differences.
struct time_parts : seq<digits, one<':'>, digits, not_at<name_other>> {};
struct time_text : seq<at<time_parts>, time_parts> {};
struct date_parts : seq<digits, one<'-'>, digits, one<'-'>, digits, not_at<name_other>> {};
struct date_text : seq<at<date_parts>, date_parts> {};
struct bare_date : token<date_text> {};
struct bare_time : token<time_text> {};
struct date_and_time : sor<string_literal, seq<bare_date, opt<bare_time>>> {};

struct text_key : token<sor<word<exact<"start_at">>, word<exact<"currency">>>> {};
struct text_value : date_and_time {};
struct text_item : if_must<text_key, text_value, plan_semicolon> {};

struct situation_key : token<word<exact<"situation">>> {};
struct situation_item : if_must<situation_key, listed_names, plan_semicolon> {};

struct whole_key : token<word<exact<"whole">>> {};
struct whole_value : name {};
struct whole_item : if_must<whole_key, opt<whole_value>, plan_semicolon> {};

// What must stand.
struct support_key : token<word<exact<"support">>> {};
struct support_gap_key : token<word<exact<"gap">>> {};
struct support_gap : quantity {};
struct support_mode : name {};
struct support_content : sor<if_must<support_gap_key, support_gap>, support_mode> {};
struct support_item : if_must<support_key, support_content, plan_semicolon> {};

struct within_key : token<word<exact<"within">>> {};
/// Names in a length are put in parentheses; else they are those of parameters of the robot.
struct within_length : seq<at<sor<digit, one<'.', '(', '+', '-'>>>, quantity> {};
struct within_values : values {};
struct within_limit : sor<within_length, within_values> {};
struct within_item : if_must<within_key, within_limit, plan_semicolon> {};

// Calendars.
struct shift_from : token<time_text> {};
struct shift_to : token<time_text> {};
struct shift_dash : minus_sign {};
struct shift_time : if_must<shift_from, shift_dash, shift_to> {};
struct off_date : token<date_text> {};
struct off_quoted_date : string_literal {};
struct off_day : sor<off_date, off_quoted_date> {};
struct off_key : token<word<exact<"off">>> {};
struct off_shift : if_must<off_key, off_day, star<if_must<comma, off_day>>, plan_semicolon> {};
struct carry_over_key : token<word<exact<"carry_over">>> {};
struct carry_over : if_must<carry_over_key, plan_semicolon> {};
struct month_word
    : sor<word<exact<"jan">>, word<exact<"feb">>, word<exact<"mar">>, word<exact<"apr">>,
          word<exact<"may">>, word<exact<"jun">>, word<exact<"jul">>, word<exact<"aug">>,
          word<exact<"sep">>, word<exact<"oct">>, word<exact<"nov">>, word<exact<"dec">>> {};
/// Months before a share; a name alone or in a sum is that of a parameter.
struct months_text
    : seq<month_word, space, opt<one<'-'>, space, identifier_text, space>,
          not_at<sor<one<';', '+', '-', '*', '/', '}'>, seq<one<'.'>, not_at<digit>>>>> {};
struct lost_first_month : token<month_word> {};
struct lost_last_month : token<month_word> {};
struct lost_months
    : seq<at<months_text>, lost_first_month, opt<if_must<minus_sign, lost_last_month>>> {};
struct lost_key : token<word<exact<"lost">>> {};
struct lost_share : quantity {};
struct lost_shift : if_must<lost_key, opt<lost_months>, lost_share, plan_semicolon> {};
/// Items of a plan (as messages.hpp lists them; what begins with another stands before it): before
/// one of these the '}' of the calendar is missing.
struct not_a_day
    : word<sor<exact<"component">, exact<"robot">, exact<"crew">, exact<"pool">, exact<"overhead">,
               exact<"task">, exact<"module">, exact<"place">, exact<"import">, exact<"site">,
               exact<"storage">, exact<"moving">, exact<"area">, exact<"earth">, exact<"network">,
               exact<"fleet">, exact<"contact">, exact<"budget">, exact<"start_at">,
               exact<"currency">, exact<"calendar">, exact<"situation">, exact<"start">,
               exact<"goal">, exact<"via">, exact<"carry">, exact<"within">, exact<"free">,
               exact<"near">, exact<"lock">, exact<"enter">, exact<"deviation">, exact<"touching">,
               exact<"guide">, exact<"parameter">, exact<"for">, exact<"when">, exact<"whole">,
               exact<"support">>> {};
struct first_day : seq<not_at<not_a_day>, name> {};
struct last_day : name {};
struct day_shift : if_must<first_day, opt<if_must<minus_sign, last_day>>, shift_time,
                           star<if_must<comma, shift_time>>, plan_semicolon> {};
struct shift : sor<off_shift, lost_shift, carry_over, day_shift> {};
struct whole_shift : must<shift> {};
struct shifts : nested<star<not_at<block_end>, recover<whole_shift, item_end>>> {};
struct calendar_key : token<word<exact<"calendar">>> {};
struct calendar_name : indexed_name {};
struct calendar_item : if_must<calendar_key, calendar_name, block_open, shifts, block_close> {};

// What a component or a task is to the client.
struct attribute_text : string_literal {};
struct component_attribute_key : token<sor<word<exact<"name">>, word<exact<"storey">>,
                                           word<exact<"type">>, word<exact<"guid">>>> {};
struct task_attribute_key : token<word<exact<"name">>> {};
struct free_attribute_key : token<word<exact<"attribute">>> {};
struct free_attribute_name : name {};
struct component_attribute : if_must<component_attribute_key, attribute_text, plan_semicolon> {};
struct task_attribute : if_must<task_attribute_key, attribute_text, plan_semicolon> {};
struct free_attribute
    : if_must<free_attribute_key, free_attribute_name, attribute_text, plan_semicolon> {};

// Headings of a task, from the widest to the nearest.
struct group_key : token<word<exact<"group">>> {};
struct group_heading : string_literal {};
struct group_item
    : if_must<group_key, group_heading, star<if_must<comma, group_heading>>, plan_semicolon> {};

// Components, robots, crews.
struct component_shape_key : token<word<exact<"shape">>> {};
struct component_shape : if_must<component_shape_key, shape, plan_semicolon> {};
struct component_at_frame : frame {};
struct component_at : if_must<at_key, component_at_frame, plan_semicolon> {};
struct grip_key : token<word<exact<"grip">>> {};
struct component_grip_frame : frame {};
struct component_grip : if_must<grip_key, component_grip_frame, plan_semicolon> {};
struct mass_key : token<word<exact<"mass">>> {};
struct mass_value : quantity {};
struct component_mass : if_must<mass_key, mass_value, plan_semicolon> {};
struct density_key : token<word<exact<"density">>> {};
struct density_value : quantity {};
struct component_density : if_must<density_key, density_value, plan_semicolon> {};
struct material_key : token<word<exact<"cost">>> {};
struct material_amount : quantity {};
struct component_cost : if_must<material_key, material_amount, plan_semicolon> {};
struct fixed_key : token<seq<word<exact<"fixed">>, plus<blank>, word<exact<"to">>>> {};
struct fixed_thing : qualified_indexed_name {};
struct fixed_after_key : token<word<exact<"after">>> {};
struct fixed_after : qualified_indexed_name {};
struct component_fixed
    : if_must<fixed_key, fixed_thing, opt<if_must<fixed_after_key, fixed_after>>, plan_semicolon> {
};
struct braced_key : token<seq<word<exact<"braced">>, plus<blank>, word<exact<"by">>>> {};
struct brace : qualified_indexed_name {};
struct component_braced : if_must<braced_key, brace, plan_semicolon> {};
struct people_key : token<word<exact<"people">>> {};
struct component_people : if_must<people_key, plan_semicolon> {};
struct component_part : sor<component_shape, component_at, component_grip, component_mass,
                            component_density, component_cost, component_fixed, component_braced,
                            component_people, component_attribute, free_attribute> {};
struct whole_component_part : must<component_part> {};
struct component_parts : nested<star<not_at<block_end>, recover<whole_component_part, item_end>>> {
};
struct component_key : token<word<exact<"component">>> {};
struct component_name : indexed_name {};
struct component_item
    : if_must<component_key, component_name, block_open, component_parts, block_close> {};

// What moves by itself and keeps a timetable.
struct moving_shape_key : token<word<exact<"shape">>> {};
struct moving_shape : if_must<moving_shape_key, shape, plan_semicolon> {};
struct path_key : token<word<exact<"path">>> {};
struct path_time : quantity {};
struct path_frame : frame {};
struct path_place : seq<path_time, path_frame> {};
struct moving_path
    : if_must<path_key, path_place, star<if_must<comma, path_place>>, plan_semicolon> {};
struct repeat_key : token<word<exact<"repeat">>> {};
struct moving_repeat : if_must<repeat_key, plan_semicolon> {};
struct moving_people_key : token<word<exact<"people">>> {};
struct moving_people : if_must<moving_people_key, plan_semicolon> {};
struct moving_part : sor<moving_shape, moving_path, moving_repeat, moving_people> {};
struct whole_moving_part : must<moving_part> {};
struct moving_parts : nested<star<not_at<block_end>, recover<whole_moving_part, item_end>>> {};
struct moving_key : token<word<exact<"moving">>> {};
struct moving_name : indexed_name {};
struct moving_item : if_must<moving_key, moving_name, block_open, moving_parts, block_close> {};

// A floor, and work over all of it.
struct place_open : open_parenthesis {};
struct place_x : quantity {};
struct place_comma : comma {};
struct place_y : quantity {};
struct place_close : close_parenthesis {};
struct floor_place : if_must<place_open, place_x, place_comma, place_y, place_close> {};
struct area_height_key : token<word<exact<"height">>> {};
struct area_height_value : quantity {};
struct area_height : if_must<area_height_key, area_height_value, plan_semicolon> {};
struct area_line_key
    : token<sor<word<exact<"outline">>, word<exact<"shaft">>, word<exact<"beam">>>> {};
struct area_line
    : if_must<area_line_key, floor_place, star<if_must<comma, floor_place>>, plan_semicolon> {};
struct area_column_key : token<sor<word<exact<"column">>, word<exact<"round_column">>>> {};
struct area_column_comma : comma {};
struct area_column_size : quantity {};
struct area_column
    : if_must<area_column_key, floor_place, area_column_comma, area_column_size, plan_semicolon> {};
struct area_obstacles_key : token<word<exact<"obstacles">>> {};
struct area_obstacles_from : token<word<exact<"from">>> {};
struct area_obstacles_components : token<word<exact<"components">>> {};
struct area_obstacles
    : if_must<area_obstacles_key, area_obstacles_from, area_obstacles_components, plan_semicolon> {
};
struct area_at_frame : frame {};
struct area_at : if_must<at_key, area_at_frame, plan_semicolon> {};
struct area_part : sor<area_height, area_at, area_line, area_column, area_obstacles> {};
struct whole_area_part : must<area_part> {};
struct area_parts : nested<star<not_at<block_end>, recover<whole_area_part, item_end>>> {};
struct area_key : token<word<exact<"area">>> {};
struct area_name : indexed_name {};
struct area_item : if_must<area_key, area_name, block_open, area_parts, block_close> {};

// The ground.
struct earth_grid_key : token<word<exact<"grid">>> {};
struct earth_columns : quantity {};
struct earth_comma : comma {};
struct earth_rows : quantity {};
struct earth_grid
    : if_must<earth_grid_key, earth_columns, earth_comma, earth_rows, plan_semicolon> {};
struct earth_height_key : token<word<exact<"height">>> {};
struct earth_from : token<word<exact<"from">>> {};
struct earth_file : string_literal {};
struct earth_height_value : quantity {};
struct earth_height
    : if_must<earth_height_key, sor<if_must<earth_from, earth_file>, earth_height_value>,
              plan_semicolon> {};
struct earth_number_key
    : token<sor<word<exact<"cell">>, word<exact<"stands">>, word<exact<"swell">>,
                word<exact<"density">>, word<exact<"repose">>>> {};
struct earth_number_value : quantity {};
struct earth_number : if_must<earth_number_key, earth_number_value, plan_semicolon> {};
struct earth_at_frame : frame {};
struct earth_at : if_must<at_key, earth_at_frame, plan_semicolon> {};
struct earth_part : sor<earth_grid, earth_height, earth_number, earth_at> {};
struct whole_earth_part : must<earth_part> {};
struct earth_parts : nested<star<not_at<block_end>, recover<whole_earth_part, item_end>>> {};
struct earth_key : token<word<exact<"earth">>> {};
struct earth_name : name {};
struct earth_item : if_must<earth_key, earth_name, block_open, earth_parts, block_close> {};

// The dynamic workspaces of machines: no two of them overlap.
struct workspaces_of_key : token<word<exact<"of">>> {};
struct workspaces_machine : qualified_indexed_name {};
struct workspaces_of : if_must<workspaces_of_key, workspaces_machine,
                               star<if_must<comma, workspaces_machine>>, plan_semicolon> {};
struct workspaces_number_key
    : token<sor<word<exact<"reaction">>, word<exact<"braking">>, word<exact<"turn_braking">>,
                word<exact<"look_ahead">>, word<exact<"risk">>>> {};
struct workspaces_number_value : quantity {};
struct workspaces_number : if_must<workspaces_number_key, workspaces_number_value, plan_semicolon> {
};
struct workspaces_watch_key : token<word<exact<"watch">>> {};
struct workspaces_watch : if_must<workspaces_watch_key, plan_semicolon> {};
struct workspaces_part : sor<workspaces_of, workspaces_number, workspaces_watch> {};
struct whole_workspaces_part : must<workspaces_part> {};
struct workspaces_parts
    : nested<star<not_at<block_end>, recover<whole_workspaces_part, item_end>>> {};
struct workspaces_key : token<word<exact<"workspaces">>> {};
struct workspaces_item : if_must<workspaces_key, block_open, workspaces_parts, block_close> {};

struct cover_number_key
    : token<sor<word<exact<"width">>, word<exact<"clearance">>, word<exact<"above">>,
                word<exact<"thickness">>, word<exact<"rate">>, word<exact<"turn_radius">>,
                word<exact<"depth">>, word<exact<"feed">>>> {};
struct cover_number_value : quantity {};
struct cover_number : if_must<cover_number_key, cover_number_value, plan_semicolon> {};
struct cover_place_key : token<sor<word<exact<"from">>, word<exact<"inlet">>>> {};
struct cover_place : if_must<cover_place_key, floor_place, plan_semicolon> {};
struct cover_word_key
    : token<sor<word<exact<"partition">>, word<exact<"order">>, word<exact<"lines">>>> {};
struct cover_word_value : name {};
struct cover_word : if_must<cover_word_key, cover_word_value, plan_semicolon> {};
struct cover_holes_key : token<word<exact<"holes">>> {};
struct cover_holes_x : quantity {};
struct cover_holes_comma : comma {};
struct cover_holes_y : quantity {};
struct cover_holes
    : if_must<cover_holes_key, cover_holes_x, cover_holes_comma, cover_holes_y, plan_semicolon> {};
struct cover_joint_key : token<word<exact<"cold_joint">>> {};
struct cover_joint_after : token<word<exact<"after">>> {};
struct cover_joint_limit : quantity {};
struct cover_joint
    : if_must<cover_joint_key, cover_joint_after, cover_joint_limit, plan_semicolon> {};
struct cover_guide_key : token<word<exact<"guide">>> {};
struct cover_guide_name : indexed_name {};
struct cover_guide : if_must<cover_guide_key, cover_guide_name,
                             star<if_must<comma, cover_guide_name>>, plan_semicolon> {};
struct cover_part
    : sor<cover_number, cover_place, cover_word, cover_holes, cover_joint, cover_guide> {};
struct whole_cover_part : must<cover_part> {};
struct cover_parts : nested<star<not_at<block_end>, recover<whole_cover_part, item_end>>> {};
struct cover_key : token<word<exact<"cover">>> {};
struct cover_area : qualified_indexed_name {};
struct cover_item : if_must<cover_key, cover_area, block_open, cover_parts, block_close> {};

struct start_key : token<word<exact<"start">>> {};
struct cost_key : token<word<exact<"cost">>> {};
struct cost_amount : quantity {};
/// Behind a calculation: of all of it. A number has taken its own as its unit.
struct cost_per_hour : token<seq<word<exact<"per">>, plus<blank>, word<one<'h'>>>> {};
struct cost_item : if_must<cost_key, cost_amount, opt<cost_per_hour>, plan_semicolon> {};

// A bare number before a word that is no unit of it; a computed one stands in parentheses.
struct computed_plain_number : seq<at<one<'('>>, quantity> {};
struct plain_number : sor<computed_plain_number, token<number_text>> {};
struct per_day : token<seq<word<exact<"per">>, plus<blank>, word<exact<"day">>>> {};
struct lone_number
    : seq<at<token<number_text>, not_at<one<'*', '/', '+', '-'>>>, token<number_text>> {};
struct computed_charge : seq<not_at<per_day>, quantity> {};
struct charge_number : sor<lone_number, computed_charge> {};
struct per_day_amount : charge_number {};
struct rental_key : token<word<exact<"rental">>> {};
struct rental_from_key : token<word<exact<"from">>> {};
struct rental_from : string_literal {};
struct rental_to_key : token<word<exact<"to">>> {};
struct rental_to : string_literal {};
struct rental_item : if_must<rental_key, per_day_amount, per_day,
                             opt<if_must<rental_from_key, rental_from, rental_to_key, rental_to>>,
                             plan_semicolon> {};
struct mobilisation_key : token<word<exact<"mobilisation">>> {};
struct mobilisation_amount : quantity {};
struct mobilisation_item : if_must<mobilisation_key, mobilisation_amount, plan_semicolon> {};
struct overtime_key : token<word<exact<"overtime">>> {};
struct overtime_factor : charge_number {};
struct outside_key : token<word<exact<"outside">>> {};
struct outside_calendar : qualified_indexed_name {};
struct overtime_item : if_must<overtime_key, overtime_factor,
                               opt<if_must<outside_key, outside_calendar>>, plan_semicolon> {};
struct fuel_key : token<word<exact<"fuel">>> {};
struct fuel_working : quantity {};
struct fuel_idling_key : token<word<exact<"idling">>> {};
struct fuel_idling : quantity {};
struct fuel_price_key : token<word<exact<"price">>> {};
struct fuel_price : quantity {};
struct fuel_item : if_must<fuel_key, fuel_working, opt<if_must<fuel_idling_key, fuel_idling>>,
                           opt<if_must<fuel_price_key, fuel_price>>, plan_semicolon> {};
struct charge_item : sor<cost_item, rental_item, mobilisation_item, overtime_item, fuel_item> {};
struct overhead_key : token<word<exact<"overhead">>> {};
struct overhead_item : if_must<overhead_key, per_day_amount, per_day, plan_semicolon> {};

struct uses_calendar_key : token<word<exact<"calendar">>> {};
struct used_calendar : qualified_indexed_name {};
struct uses_calendar : if_must<uses_calendar_key, used_calendar, plan_semicolon> {};

// When a machine breaks down, and for how long.
struct breakdown_key : token<word<exact<"breakdown">>> {};
struct breakdown_every : token<word<exact<"every">>> {};
struct breakdown_between : duration {};
struct breakdown_takes : token<word<exact<"takes">>> {};
struct breakdown_repair : duration {};
struct breakdown_item : if_must<breakdown_key, breakdown_every, breakdown_between, breakdown_takes,
                                breakdown_repair, plan_semicolon> {};

struct robot_start_values : values {};
struct robot_start : if_must<start_key, robot_start_values, plan_semicolon> {};
struct park_key : token<word<exact<"park">>> {};
struct park_values : values {};
struct robot_park : if_must<park_key, park_values, plan_semicolon> {};
struct robot_behaviour_key : token<behaviour_word> {};
struct robot_behaviour_file : string_literal {};
struct robot_behaviour : if_must<robot_behaviour_key, robot_behaviour_file, plan_semicolon> {};
struct robot_use_part
    : sor<robot_start, charge_item, uses_calendar, breakdown_item, robot_park, robot_behaviour> {};
struct whole_robot_use_part : must<robot_use_part> {};
struct robot_use_parts : nested<star<not_at<block_end>, recover<whole_robot_use_part, item_end>>> {
};
struct robot_use_key : token<word<exact<"robot">>> {};
struct robot_file_name : string_literal {};
struct robot_use_name : indexed_name {};
struct robot_frame : frame {};
struct robot_at : opt<if_must<at_key, robot_frame>> {};
struct robot_use_block : if_must<block_open, robot_use_parts, block_close> {};
struct robot_use_end : sor<semicolon, robot_use_block> {};
struct named_robot : if_must<robot_use_name, robot_file_name, robot_at, robot_use_end> {};
struct short_robot : if_must<robot_file_name, robot_at, plan_semicolon> {};
struct robot_use_form : sor<short_robot, named_robot> {};
struct robot_use : if_must<robot_use_key, robot_use_form> {};

struct size_key : token<word<exact<"size">>> {};
struct size_value : quantity {};
struct crew_size : if_must<size_key, size_value, plan_semicolon> {};
struct crew_part : sor<crew_size, charge_item, uses_calendar> {};
struct whole_crew_part : must<crew_part> {};
struct crew_parts : nested<star<not_at<block_end>, recover<whole_crew_part, item_end>>> {};
struct crew_block : if_must<block_open, crew_parts, block_close> {};
struct crew_end : sor<semicolon, crew_block> {};
struct crew_key : token<word<exact<"crew">>> {};
struct crew_name : indexed_name {};
struct crew_item : if_must<crew_key, crew_name, crew_end> {};

// Pools: robots or crews of which a task has one.
struct of_key : token<word<exact<"of">>> {};
struct pool_members : if_must<of_key, listed_names, plan_semicolon> {};
struct choose_key : token<word<exact<"choose">>> {};
struct choice_rule : token<identifier_text> {};  // also `first`, which is reserved elsewhere
struct pool_choice : if_must<choose_key, choice_rule, plan_semicolon> {};
struct pool_part : sor<pool_members, pool_choice> {};
struct whole_pool_part : must<pool_part> {};
struct pool_parts : nested<star<not_at<block_end>, recover<whole_pool_part, item_end>>> {};
struct pool_key : token<word<exact<"pool">>> {};
struct pool_name : indexed_name {};
struct pool_item : if_must<pool_key, pool_name, block_open, pool_parts, block_close> {};

// Networks: nodes and lanes between them.
struct policy_key : token<word<exact<"policy">>> {};
struct policy_name : name {};
struct policy_number_key : name {};
struct policy_number_value : quantity {};
struct policy_number : seq<policy_number_key, must<policy_number_value, plan_semicolon>> {};
struct minimise_key : token<word<exact<"minimise">>> {};
struct minimise_what : name {};
struct policy_minimise : if_must<minimise_key, minimise_what, plan_semicolon> {};
struct policy_part : sor<policy_minimise, policy_number> {};
struct whole_policy_part : must<policy_part> {};
struct policy_parts : nested<star<not_at<block_end>, recover<whole_policy_part, item_end>>> {};
struct policy_block : if_must<block_open, policy_parts, block_close> {};
struct policy_end : sor<semicolon, policy_block> {};
struct network_policy : if_must<policy_key, policy_name, policy_end> {};
// Of a network of cells: its map, and who goes from where to where.
struct grid_file_key : token<sor<word<exact<"map">>, word<exact<"scenario">>>> {};
struct grid_file_name : string_literal {};
struct grid_file : if_must<grid_file_key, grid_file_name, plan_semicolon> {};
struct grid_count_key : token<sor<word<exact<"agents">>, word<exact<"jobs">>>> {};
struct grid_count_value : quantity {};
struct grid_count : if_must<grid_count_key, grid_count_value, plan_semicolon> {};
struct grid_agent_key : token<word<exact<"agent">>> {};
struct grid_agent_name : name {};
struct grid_from_key : token<word<exact<"from">>> {};
struct grid_from : seq<floor_place> {};
struct grid_to_key : to_word {};
struct grid_to : seq<floor_place> {};
struct grid_agent : if_must<grid_agent_key, grid_agent_name, grid_from_key, grid_from, grid_to_key,
                            grid_to, plan_semicolon> {};
struct grid_job_key : token<word<exact<"job">>> {};
struct grid_job_name : name {};
struct grid_job_arrives : quantity {};
struct grid_job_at : if_must<at_key, grid_job_arrives> {};
struct grid_job : if_must<grid_job_key, grid_job_name, grid_from_key, grid_from, grid_to_key,
                          grid_to, opt<grid_job_at>, plan_semicolon> {};
struct grid_part : sor<grid_file, grid_count, grid_agent, grid_job> {};
struct class_speed_key : token<word<exact<"speed">>> {};
struct class_speed_value : quantity {};
struct class_speed : if_must<class_speed_key, class_speed_value, plan_semicolon> {};
struct class_width_key : token<word<exact<"width">>> {};
struct class_width_value : quantity {};
struct class_width : if_must<class_width_key, class_width_value, plan_semicolon> {};
struct class_cost_key : token<word<exact<"cost">>> {};
struct class_cost_value : quantity {};
struct class_cost : if_must<class_cost_key, class_cost_value, plan_semicolon> {};
struct class_part : sor<class_speed, class_width, class_cost> {};
struct whole_class_part : must<class_part> {};
struct class_parts : nested<star<not_at<block_end>, recover<whole_class_part, item_end>>> {};
struct class_key : token<word<exact<"class">>> {};
struct class_name : name {};
struct lane_class : if_must<class_key, class_name, block_open, class_parts, block_close> {};
struct node_key : token<word<exact<"node">>> {};
struct node_name : indexed_name {};
struct node_frame : frame {};
struct node_at : at_key {};
struct network_node : if_must<node_key, node_name, node_at, node_frame, plan_semicolon> {};
struct lane_key : token<word<exact<"lane">>> {};
struct lane_from : indexed_name {};
struct lane_end : indexed_name {};
struct beside_from : indexed_name {};
struct beside_end : indexed_name {};
struct lane_to_key : to_word {};
struct beside_to_key : to_word {};
struct lane_both : token<word<exact<"both">>> {};
struct beside_key : token<word<exact<"beside">>> {};
struct lane_beside : if_must<beside_key, beside_from, beside_to_key, beside_end> {};
struct length_key : token<word<exact<"length">>> {};
struct lane_length_value : quantity {};
struct lane_length : if_must<length_key, lane_length_value> {};
struct lane_class_name : name {};
struct lane_option : sor<lane_both, lane_beside, lane_length, lane_class_name> {};
struct network_lane
    : if_must<lane_key, lane_from, lane_to_key, lane_end, star<lane_option>, plan_semicolon> {};
// Of a network with charts: which robot goes where and when, and what robots tell the centre.
struct errand_key : token<word<exact<"errand">>> {};
struct errand_name : indexed_name {};
struct errand_from_key : token<word<exact<"from">>> {};
struct errand_from : indexed_name {};
struct errand_to_key : to_word {};
struct errand_to : indexed_name {};
struct errand_at : at_key {};
struct errand_start : quantity {};
struct errand_number_key
    : token<sor<word<exact<"priority">>, word<exact<"speed">>, word<exact<"width">>>> {};
struct errand_number_value : quantity {};
struct errand_number : if_must<errand_number_key, errand_number_value, plan_semicolon> {};
struct errand_part : sor<errand_number> {};
struct whole_errand_part : must<errand_part> {};
struct errand_parts : nested<star<not_at<block_end>, recover<whole_errand_part, item_end>>> {};
struct errand_block : if_must<block_open, errand_parts, block_close> {};
struct errand_end : sor<semicolon, errand_block> {};
struct network_errand : if_must<errand_key, errand_name, errand_from_key, errand_from,
                                errand_to_key, errand_to, errand_at, errand_start, errand_end> {};
struct report_key : token<word<exact<"report">>> {};
struct report_lane_key : token<word<exact<"lane">>> {};
struct report_from : indexed_name {};
struct report_to_key : to_word {};
struct report_to : indexed_name {};
struct report_word : token<sor<word<exact<"blocked">>, word<exact<"reopened">>>> {};
struct report_obstacle_word : token<word<exact<"obstacle">>> {};
struct report_edge : quantity {};
struct report_edges_to : to_word {};
struct report_obstacle : if_must<report_obstacle_word, report_edge, report_edges_to, report_edge> {
};
struct report_what : sor<report_word, report_obstacle> {};
struct report_at : at_key {};
struct report_time : quantity {};
struct report_by : token<word<exact<"by">>> {};
struct report_robot : indexed_name {};
struct network_report
    : if_must<report_key, report_lane_key, report_from, report_to_key, report_to, report_what,
              report_at, report_time, report_by, report_robot, plan_semicolon> {};
struct barrier_key : token<word<exact<"barrier">>> {};
struct barrier_lane_key : token<word<exact<"lane">>> {};
struct barrier_from : indexed_name {};
struct barrier_to_key : to_word {};
struct barrier_to : indexed_name {};
struct barrier_since_key : token<word<exact<"from">>> {};
struct barrier_since : quantity {};
struct barrier_until_key : to_word {};
struct barrier_until : quantity {};
struct network_barrier : if_must<barrier_key, barrier_lane_key, barrier_from, barrier_to_key,
                                 barrier_to, barrier_since_key, barrier_since,
                                 opt<if_must<barrier_until_key, barrier_until>>, plan_semicolon> {};
// Of a network that is explored: who begins where.
struct explore_key : token<word<exact<"explore">>> {};
struct explore_name : indexed_name {};
struct explore_from_key : token<word<exact<"from">>> {};
struct explore_from : indexed_name {};
struct network_explore
    : if_must<explore_key, explore_name, explore_from_key, explore_from, errand_end> {};
struct network_parts;
struct network_repetition : if_must<for_head, block_open, network_parts, block_close> {};
struct network_choice : if_must<given_head, block_open, network_parts, block_close> {};
struct network_block : sor<network_repetition, network_choice> {};
struct network_part
    : sor<network_block, network_policy, lane_class, network_node, network_lane, network_errand,
          network_report, network_barrier, network_explore, grid_part> {};
struct whole_network_part : must<network_part> {};
struct network_parts : nested<star<not_at<block_end>, recover<whole_network_part, item_end>>> {};
struct network_key : token<word<exact<"network">>> {};
struct network_name : name {};
struct network_item : if_must<network_key, network_name, block_open, network_parts, block_close> {};

// Fleets: machines alike on a network, of which a task has one.
struct fleet_robot_key : token<word<exact<"robot">>> {};
struct fleet_file : string_literal {};
struct fleet_robot : if_must<fleet_robot_key, fleet_file, plan_semicolon> {};
struct fleet_size_value : quantity {};
struct fleet_size : if_must<size_key, fleet_size_value, plan_semicolon> {};
struct fleet_on_key : token<word<exact<"on">>> {};
struct fleet_network : name {};
struct fleet_on : if_must<fleet_on_key, fleet_network, plan_semicolon> {};
struct fleet_places_key : token<word<exact<"at">>> {};
struct fleet_place : indexed_name {};
struct fleet_places
    : if_must<fleet_places_key, fleet_place, star<if_must<comma, fleet_place>>, plan_semicolon> {};
struct fleet_rule : token<identifier_text> {};
struct fleet_choice : if_must<choose_key, fleet_rule, plan_semicolon> {};
struct fleet_part : sor<fleet_robot, fleet_size, fleet_on, fleet_places, fleet_choice, charge_item,
                        uses_calendar, breakdown_item> {};
struct whole_fleet_part : must<fleet_part> {};
struct fleet_parts : nested<star<not_at<block_end>, recover<whole_fleet_part, item_end>>> {};
struct fleet_key : token<word<exact<"fleet">>> {};
struct fleet_name : name {};
struct fleet_item : if_must<fleet_key, fleet_name, block_open, fleet_parts, block_close> {};

// Tasks.
struct by_key : token<word<exact<"by">>> {};
struct same_as_key : token<seq<word<exact<"same">>, plus<blank>, word<exact<"as">>>> {};
struct same_as_task : qualified_indexed_name {};
struct all_of_key : token<seq<word<exact<"all">>, plus<blank>, word<exact<"of">>>> {};
struct all_of_pool : qualified_indexed_name {};
struct by_whom
    : sor<if_must<same_as_key, same_as_task>, if_must<all_of_key, all_of_pool>, listed_name> {};
struct by_item : if_must<by_key, by_whom, star<if_must<comma, by_whom>>, plan_semicolon> {};
struct needs_key : token<word<exact<"needs">>> {};
struct needed_units : plain_number {};
struct needed_crew : qualified_indexed_name {};
struct need : if_must<needed_units, needed_crew> {};
struct needs_item : if_must<needs_key, need, star<if_must<comma, need>>, plan_semicolon> {};
struct move_key : token<word<exact<"move">>> {};
struct moved_component : qualified_indexed_name {};
struct to_key : to_word {};
struct move_item : if_must<move_key, moved_component, to_key, frame, plan_semicolon> {};
struct go_key : token<word<exact<"go">>> {};
struct go_item : if_must<go_key, goal, plan_semicolon> {};
struct remove_key : token<word<exact<"remove">>> {};
struct removed_component : qualified_indexed_name {};
struct remove_item : if_must<remove_key, removed_component, plan_semicolon> {};
struct crew_work_key
    : token<sor<word<exact<"hook">>, word<exact<"adjust">>, word<exact<"release">>>> {};
struct work_crew : qualified_indexed_name {};
struct turning_key : token<word<exact<"turning">>> {};
struct turned_parameter : name {};
struct crew_work_item : if_must<crew_work_key, duration, opt<if_must<by_key, work_crew>>,
                                opt<if_must<turning_key, turned_parameter>>, plan_semicolon> {};
struct takes_key : token<word<exact<"takes">>> {};
struct takes_item : if_must<takes_key, duration, plan_semicolon> {};

// Soil: diggers load trucks, whose rounds have stages.
struct dig_volume : quantity {};
struct dig_number_key
    : token<sor<word<exact<"swell">>, word<exact<"density">>, word<exact<"bed">>,
                word<exact<"payload">>, word<exact<"bucket">>, word<exact<"fill_factor">>,
                word<exact<"efficiency">>, word<exact<"loaded">>, word<exact<"limit">>,
                word<exact<"layer">>, word<exact<"tolerance">>, word<exact<"clearance">>>> {};
struct dig_number_value : quantity {};
struct dig_number : if_must<dig_number_key, dig_number_value, plan_semicolon> {};
struct dig_load_key : token<word<exact<"load">>> {};
struct dig_trucks : qualified_indexed_name {};
struct dig_load_takes : token<word<exact<"takes">>> {};
struct dig_load
    : if_must<dig_load_key, dig_trucks, opt<if_must<dig_load_takes, duration>>, plan_semicolon> {};
/// A stage has a name of its own, which is followed by takes.
struct dig_stage_key : token<seq<name_text, at<space, word<exact<"takes">>>>> {};
struct dig_stage_takes : token<word<exact<"takes">>> {};
struct dig_server : qualified_indexed_name {};
struct dig_stage : if_must<dig_stage_key, dig_stage_takes, duration,
                           opt<if_must<by_key, dig_server>>, plan_semicolon> {};
/// How a machine that digs holds its tool, and where it empties it.
struct dig_attitude_key
    : token<sor<word<exact<"cut">>, word<exact<"carry">>, word<exact<"open">>>> {};
struct dig_attitude_frame : frame {};
struct dig_attitude : if_must<dig_attitude_key, dig_attitude_frame, plan_semicolon> {};
struct dig_dump_key : token<seq<word<exact<"dump">>, at<space, word<exact<"at">>>>> {};
struct dig_dump_at : token<word<exact<"at">>> {};
struct dig_dump_frame : frame {};
struct dig_dump : if_must<dig_dump_key, dig_dump_at, dig_dump_frame, plan_semicolon> {};
/// Where trucks with bodies are loaded, and where they wait for that.
struct dig_place_key
    : token<seq<sor<word<exact<"load">>, word<exact<"queue">>>, at<space, word<exact<"at">>>>> {};
struct dig_place_at : token<word<exact<"at">>> {};
struct dig_place_frame : frame {};
struct dig_place : if_must<dig_place_key, dig_place_at, dig_place_frame,
                           star<if_must<comma, dig_place_frame>>, plan_semicolon> {};
struct dig_part : sor<dig_place, dig_load, dig_dump, dig_number, dig_stage, dig_attitude> {};
struct whole_dig_part : must<dig_part> {};
struct dig_parts : nested<star<not_at<block_end>, recover<whole_dig_part, item_end>>> {};
struct dig_key : token<word<exact<"dig">>> {};
/// An earth is followed by to; all else is a volume.
struct dig_earth : token<seq<name_text, at<space, word<exact<"to">>>>> {};
struct dig_shape : shape {};
struct dig_pit : if_must<dig_earth, to_word, dig_shape> {};
struct dig_item : if_must<dig_key, sor<dig_pit, dig_volume>, block_open, dig_parts, block_close> {};
// A truck with a body goes between those who dig and where it tips.
struct haul_number_key : token<sor<word<exact<"bed">>, word<exact<"payload">>>> {};
struct haul_number_value : quantity {};
struct haul_number : if_must<haul_number_key, haul_number_value, plan_semicolon> {};
struct haul_place_key : token<seq<sor<word<exact<"out">>, word<exact<"tip">>, word<exact<"back">>>,
                                  at<space, word<exact<"at">>>>> {};
struct haul_place_at : token<word<exact<"at">>> {};
struct haul_place_frame : frame {};
struct haul_place : if_must<haul_place_key, haul_place_at, haul_place_frame,
                            star<if_must<comma, haul_place_frame>>, plan_semicolon> {};
struct haul_tip_key : token<word<exact<"tip">>> {};
struct haul_tip_takes : token<word<exact<"takes">>> {};
struct haul_tip : if_must<haul_tip_key, haul_tip_takes, duration, plan_semicolon> {};
struct haul_heap_key : token<word<exact<"heap">>> {};
struct haul_heap_earth : name {};
struct haul_heap_at : token<word<exact<"at">>> {};
struct haul_heap_frame : frame {};
struct haul_heap
    : if_must<haul_heap_key, haul_heap_earth, haul_heap_at, haul_heap_frame, plan_semicolon> {};
struct haul_raise_key : token<word<exact<"raise">>> {};
struct haul_raise_values : values {};
struct haul_raise : if_must<haul_raise_key, haul_raise_values, plan_semicolon> {};
struct haul_part : sor<haul_place, haul_tip, haul_number, haul_heap, haul_raise> {};
struct whole_haul_part : must<haul_part> {};
struct haul_parts : nested<star<not_at<block_end>, recover<whole_haul_part, item_end>>> {};
struct haul_key : token<word<exact<"haul">>> {};
struct haul_dig : qualified_indexed_name {};
struct haul_item : if_must<haul_key, haul_dig, star<if_must<comma, haul_dig>>, block_open,
                           haul_parts, block_close> {};
struct via_key : token<word<exact<"via">>> {};
struct via_item : if_must<via_key, goal, plan_semicolon> {};
// What a motion asks beside its goals.
struct free_key : token<word<exact<"free">>> {};
struct free_turn : name {};
struct near_key : token<word<exact<"near">>> {};
struct near_values : values {};
struct lock_key : token<word<exact<"lock">>> {};
struct locked_parameter : qualified_name {};
struct deviation_quantity : quantity {};
struct enter_key : token<word<exact<"enter">>> {};
struct entering_body : name {};
struct entered_component : qualified_indexed_name {};
struct enter_clause : if_must<enter_key, entering_body, entered_component> {};
struct free_clause : if_must<free_key, free_turn, star<if_must<comma, free_turn>>> {};
struct near_clause : if_must<near_key, near_values> {};
struct lock_clause : if_must<lock_key, locked_parameter, star<if_must<comma, locked_parameter>>> {};
struct deviation_clause
    : if_must<deviation_key, deviation_quantity, opt<if_must<comma, deviation_quantity>>> {};
struct motion_clause
    : seq<sor<free_clause, near_clause, lock_clause, deviation_clause, enter_clause>,
          must<plan_semicolon>> {};
struct task_number_key : token<sor<word<exact<"budget">>, word<exact<"priority">>>> {};
struct task_number_item : if_must<task_number_key, number_value, plan_semicolon> {};
struct moment_date : date_and_time {};
struct moment_after_start : quantity {};
struct moment : sor<moment_date, moment_after_start> {};
struct date_key : token<sor<word<exact<"not_before">>, word<exact<"due">>>> {};
struct baseline_key : token<word<exact<"baseline">>> {};
struct baseline_to : to_key {};
struct date_item : sor<if_must<date_key, moment, plan_semicolon>,
                       if_must<baseline_key, moment, baseline_to, moment, plan_semicolon>> {};
struct zone_key : token<word<exact<"zone">>> {};
struct up_to_key : token<word<exact<"up_to">>> {};
struct up_to_height : quantity {};
struct zone_item : if_must<zone_key, shape, opt<if_must<up_to_key, up_to_height>>, plan_semicolon> {
};
struct after_item : if_must<after_key, links, plan_semicolon> {};
struct task_parts;
struct task_repetition : if_must<for_head, block_open, task_parts, block_close> {};
struct task_choice : if_must<given_head, block_open, task_parts, block_close> {};
struct task_block : sor<task_repetition, task_choice> {};
struct task_part
    : sor<task_block, by_item, needs_item, move_item, cover_item, go_item, remove_item,
          crew_work_item, takes_item, dig_item, haul_item, via_item, guide_use, situation_item,
          within_item, motion_clause, task_number_item, date_item, zone_item, after_item,
          task_attribute, group_item, free_attribute, whole_item> {};
struct whole_task_part : must<task_part> {};
struct task_parts : nested<star<not_at<block_end>, recover<whole_task_part, item_end>>> {};
struct task_key : token<word<exact<"task">>> {};
struct task_name : indexed_name {};
struct task_item : if_must<task_key, task_name, block_open, task_parts, block_close> {};

// What may overlap at the beginning; `within x 1;` of the short form is something else, and so is
// `within x tolerance;`.
struct control_parameter : seq<opt<identifier_text, one<'.'>>,
                               sor<word<one<'x', 'y', 'z'>>, word<exact<"psi">>, word<exact<"phi">>,
                                   word<exact<"theta">>, word<greek_letter>>> {};
struct waived_first : qualified_indexed_name {};
struct waived_second : qualified_indexed_name {};
struct touching_things_key : token<word<exact<"touching">>> {};
struct touching_things : if_must<touching_things_key, waived_first, waived_second, plan_semicolon> {
};
struct embedded_key : token<word<exact<"within">>> {};
struct embedded_thing : if_must<seq<at<embedded_key, not_at<control_parameter>,
                                       qualified_indexed_name, qualified_indexed_name>,
                                    embedded_key>,
                                waived_first, waived_second, plan_semicolon> {};
struct waiver : sor<touching_things, embedded_thing> {};

// Modules, imports.
struct module_parts;
struct module_repetition : if_must<for_head, block_open, module_parts, block_close> {};
struct module_choice : if_must<given_head, block_open, module_parts, block_close> {};
struct module_block : sor<module_repetition, module_choice> {};
struct module_part : sor<module_block, component_item, task_item, waiver> {};
struct whole_module_part : must<module_part> {};
struct module_parts : nested<star<not_at<block_end>, recover<whole_module_part, item_end>>> {};
struct module_key : token<word<exact<"module">>> {};
struct module_name : indexed_name {};
struct module_item : if_must<module_key, module_name, block_open, module_parts, block_close> {};

struct place_key : token<word<exact<"place">>> {};
struct placed_module : qualified_indexed_name {};
struct placed_at : at_key {};
struct placed_frame : frame {};
struct from_key : token<word<exact<"from">>> {};
struct stock_frame : frame {};
struct placed_from : opt<if_must<from_key, stock_frame>> {};
struct as_key : token<word<exact<"as">>> {};
struct placed_as : indexed_name {};
struct place_item : if_must<place_key, placed_module, placed_at, placed_frame, placed_from, as_key,
                            placed_as, opt<if_must<after_key, links>>, plan_semicolon> {};

struct import_block;
struct import_text : seq<not_at<one<'{', '}'>>, token<any_token_text>> {};
struct import_content : nested<star<sor<import_text, import_block>>> {};
struct import_block : if_must<block_open, import_content, block_close> {};
struct import_key : token<word<exact<"import">>> {};
struct import_file : string_literal {};
struct import_name : name {};
struct import_end : sor<semicolon, import_block> {};
struct import_item
    : if_must<import_key, import_file, opt<if_must<as_key, import_name>>, import_end> {};

// The short form, the plan.
struct short_start_values : values {};
struct short_start : if_must<start_key, short_start_values, plan_semicolon> {};
struct goal_key : token<word<exact<"goal">>> {};
struct short_goal : if_must<goal_key, goal, plan_semicolon> {};
struct carry_key : token<word<exact<"carry">>> {};
struct carry_item : if_must<carry_key, shape, plan_semicolon> {};

struct parameter_key : token<word<exact<"parameter">>> {};
struct parameter_name : indexed_name {};
struct parameter_equals : equals {};
struct parameter_text : string_literal {};
struct parameter_value : expression {};
struct parameter_content : sor<parameter_text, parameter_value> {};
struct parameter_item
    : if_must<parameter_key, parameter_name, parameter_equals, parameter_content, plan_semicolon> {
};

struct plan_items;
struct plan_repetition : if_must<for_head, block_open, plan_items, block_close> {};
struct plan_choice : if_must<given_head, block_open, plan_items, block_close> {};
struct plan_block : sor<plan_repetition, plan_choice> {};
// Of a plan: a declaration, or in the short form the guides of its motion.
struct guides_of_motion : seq<star<if_must<comma, next_guide>>, clause_semicolon> {};
struct plan_guide_end : sor<guides_of_motion, guide_declared> {};
struct plan_guide : if_must<guide_key, guide_name, plan_guide_end> {};

struct plan_item
    : sor<plan_block, parameter_item, component_item, robot_use, crew_item, pool_item,
          workspaces_item, overhead_item, task_item, module_item, place_item, import_item, waiver,
          site_item, storage_item, moving_item, area_item, earth_item, network_item, fleet_item,
          number_item, text_item, calendar_item, situation_item, short_start, short_goal, via_item,
          carry_item, within_item, motion_clause, whole_item, support_item, plan_guide> {};
struct whole_plan_item : must<plan_item> {};
struct plan_items : nested<star<not_at<block_end>, recover<whole_plan_item, item_end>>> {};
struct plan_file_key : token<word<exact<"plan">>> {};
struct plan_name : name {};
struct plan_finished : eof {};
struct plan : must<plan_file_key, plan_name, block_open, plan_items, block_close, plan_finished> {};
struct plan_file : seq<space, recover<plan, text_end>> {};

}  // namespace rubicon::grammar
