#pragma once

#include "grammar/expectation.hpp"
#include "grammar/plan.hpp"
#include "grammar/robot.hpp"
#include "grammar/study.hpp"

/// What is said where a rule that must match does not. Only commit points have an entry.
namespace rubicon::grammar {

template <typename Rule>
inline constexpr Expectation expectation{};

#define RUBICON_EXPECT(rule, ...)                  \
  template <>                                      \
  inline constexpr Expectation expectation<rule> { \
    __VA_ARGS__                                    \
  }

// names and expressions
RUBICON_EXPECT(member_name, "a name after '.'");
RUBICON_EXPECT(call_close, "',' or ')'");
RUBICON_EXPECT(arguments, "a value or ')'");
RUBICON_EXPECT(next_argument, "a value");
RUBICON_EXPECT(variable_open, "'(' after var");
RUBICON_EXPECT(variable_name, "the name of a variable");
RUBICON_EXPECT(variable_close, "')'");
RUBICON_EXPECT(grouped, "a value");
RUBICON_EXPECT(group_close, "')'", Explain::expected, "==");
RUBICON_EXPECT(signed_operand, "a value");
RUBICON_EXPECT(factor, "a value");
RUBICON_EXPECT(term, "a value");
RUBICON_EXPECT(compared, "a value");
RUBICON_EXPECT(comparison_end, "one comparison at a time (a < b and b < c)");
RUBICON_EXPECT(inverted, "a condition");
RUBICON_EXPECT(conjunct, "a condition");
RUBICON_EXPECT(disjunct, "a condition");

// frames and shapes
inline constexpr const char* kFrameWords = "trans rotx roty rotz";
inline constexpr const char* kFrame = "a frame such as trans(x, y, z) or rotz(theta)";
RUBICON_EXPECT(frame, kFrame, Explain::expected, kFrameWords);
RUBICON_EXPECT(frame_factor, kFrame, Explain::expected, kFrameWords);
RUBICON_EXPECT(frame_open, "'('");
RUBICON_EXPECT(frame_argument, "a value");
RUBICON_EXPECT(frame_close, "',' or ')'");
RUBICON_EXPECT(shape_frame, kFrame, Explain::expected, kFrameWords);
RUBICON_EXPECT(shape, "a shape such as box(...)");
RUBICON_EXPECT(shape_open, "'('");
RUBICON_EXPECT(shape_number, "a number");
RUBICON_EXPECT(shape_close, "',' or ')'");
RUBICON_EXPECT(mesh_file, "the name of a mesh file in quotes");
RUBICON_EXPECT(mesh_option, "a unit, scale, up, part or hull", Explain::expected,
               "scale up part hull");
RUBICON_EXPECT(mesh_scale, "a number");
RUBICON_EXPECT(mesh_up, "y or z");
RUBICON_EXPECT(mesh_part, "the name of a part in quotes");

// statements
RUBICON_EXPECT(stop_open, "'(' after stop");
RUBICON_EXPECT(stop_reason, "unreachable");
RUBICON_EXPECT(stop_close, "')'");
RUBICON_EXPECT(block_open, "'{' after {of}");
RUBICON_EXPECT(command_open, "'(' after the command");
RUBICON_EXPECT(command_parameter, "a control parameter");
RUBICON_EXPECT(command_comma, "',' and a value");
RUBICON_EXPECT(command_value, "a value");
RUBICON_EXPECT(command_close, "')'");
RUBICON_EXPECT(assigned_open, "'(' after var");
RUBICON_EXPECT(assigned_name, "the name of a variable");
RUBICON_EXPECT(assigned_close, "')'");
RUBICON_EXPECT(assigned_equals, "'=' and a value");
RUBICON_EXPECT(assigned_value, "a value");
RUBICON_EXPECT(together_part, "move_to or move_dir in this together");
RUBICON_EXPECT(together_close, "',' or '}' in this together");
RUBICON_EXPECT(element, "a command or structure in this {in}", Explain::statement);
RUBICON_EXPECT(element_follows, "',' or '}' in this {in}");
RUBICON_EXPECT(until_open, "'(' after until");
RUBICON_EXPECT(until_condition, "a condition");
RUBICON_EXPECT(until_close, "')'", Explain::expected, "==");
RUBICON_EXPECT(label_colon, "':' after the label");
RUBICON_EXPECT(when_open, "'(' after when");
RUBICON_EXPECT(when_condition, "a condition");
RUBICON_EXPECT(when_close, "')'", Explain::expected, "==");
RUBICON_EXPECT(statement, "a statement", Explain::statement);
RUBICON_EXPECT(simple_end, "';'");
RUBICON_EXPECT(behaviour_name, "a name after behaviour");

// robots
RUBICON_EXPECT(item_semicolon, "';'");
RUBICON_EXPECT(param_name, "the name of a control parameter");
RUBICON_EXPECT(derived_value, "a value");
RUBICON_EXPECT(attribute_number, "a number");
RUBICON_EXPECT(attribute_close, "',' or ')'");
RUBICON_EXPECT(rule_parameter, "a control parameter");
RUBICON_EXPECT(rule_arrow, "'<-'");
RUBICON_EXPECT(rule_value, "a value");
RUBICON_EXPECT(body_item, "body", Explain::item, "param rule frame shape behaviour");
RUBICON_EXPECT(body_name, "a name after body");
RUBICON_EXPECT(body_parent, "the name of a body after on");
RUBICON_EXPECT(setting_value, "a number");
RUBICON_EXPECT(tool_body, "the name of a body");
RUBICON_EXPECT(tool_frame, kFrame, Explain::expected, kFrameWords);
RUBICON_EXPECT(const_name, "a name after const");
RUBICON_EXPECT(const_equals, "'=' and a value");
RUBICON_EXPECT(const_value, "a value");
RUBICON_EXPECT(touching_name, "the name of a body");
RUBICON_EXPECT(capacity_point, "'(', a radius and a mass");
RUBICON_EXPECT(capacity_number, "a number");
RUBICON_EXPECT(capacity_comma, "',' and a mass");
RUBICON_EXPECT(capacity_close, "')'");
RUBICON_EXPECT(buffer_distance, "a distance");
RUBICON_EXPECT(buffer_body, "the name of a body");
RUBICON_EXPECT(rope_open, "'('");
RUBICON_EXPECT(rope_radius, "the radius of the rope");
RUBICON_EXPECT(rope_close, "')'");
RUBICON_EXPECT(rope_from_key, "'from' and the body that the rope comes from");
RUBICON_EXPECT(rope_to_key, "'to' and the body that the rope goes to");
RUBICON_EXPECT(rope_end, "the name of a body");
RUBICON_EXPECT(rope_number, "a number");
RUBICON_EXPECT(rope_comma, "',' and a number");
RUBICON_EXPECT(deviation_number, "a length, then an angle if you like");
RUBICON_EXPECT(behaviour_source, "the name of a file in quotes or '{' after behaviour");
RUBICON_EXPECT(guide_name, "a name after guide");
RUBICON_EXPECT(guide_declared, "the kind of the guide, such as rrt_connect");
RUBICON_EXPECT(guide_end, "';' or '{'");
RUBICON_EXPECT(
    guide_clause, "guide", Explain::item,
    "seed nodes checks step goal_bias uniform_nodes rejections greed concentration "
    "smooth improve replans safety nearest neighbours heuristic over weight keep attraction "
    "repulsion influence turn_radius thinks hand vision set");
RUBICON_EXPECT(keep_open, "'(' after keep");
RUBICON_EXPECT(keep_condition, "a condition");
RUBICON_EXPECT(keep_close, "')'", Explain::expected, "==");
RUBICON_EXPECT(thinks_number, "a number after thinks");
RUBICON_EXPECT(thinks_unit, "us, ms or s: thinks 20 us per check");
RUBICON_EXPECT(thinks_per, "'per' check: thinks 20 us per check");
RUBICON_EXPECT(thinks_check, "'check': thinks 20 us per check");
RUBICON_EXPECT(set_name, "the name of a parameter of the planner in quotes");
RUBICON_EXPECT(set_number, "a number");
RUBICON_EXPECT(clause_content, "a number, a word, or a parameter and a number");
RUBICON_EXPECT(clause_value, "a parameter and a number");
RUBICON_EXPECT(clause_number, "a number");
RUBICON_EXPECT(clause_semicolon, "';'");
RUBICON_EXPECT(used_guide, "the name of a guide");
RUBICON_EXPECT(next_guide, "the name of a guide");
RUBICON_EXPECT(plan_guide_end, "the kind of the guide, such as rrt_connect, or ';'");
RUBICON_EXPECT(
    robot_item, "robot", Explain::item,
    "time_step sensor body tool const touching capacity rope buffer deviation guide behaviour");
RUBICON_EXPECT(robot_key, "'robot' at the start of a robot file");
RUBICON_EXPECT(robot_name, "a name after robot");
RUBICON_EXPECT(text_finished, "the end of the file after the '}' of the robot");

// plans
RUBICON_EXPECT(plan_semicolon, "';'");
RUBICON_EXPECT(index_value, "a number in the brackets of a name");
RUBICON_EXPECT(index_close, "',' or ']'");
RUBICON_EXPECT(for_variable, "a name after for");
RUBICON_EXPECT(for_from, "'from' and a number");
RUBICON_EXPECT(for_first, "a number");
RUBICON_EXPECT(for_to, "'to' and a number");
RUBICON_EXPECT(for_last, "a number");
RUBICON_EXPECT(given_open, "'(' after when");
RUBICON_EXPECT(given_condition, "a condition");
RUBICON_EXPECT(given_close, "')'", Explain::expected, "==");
RUBICON_EXPECT(parameter_name, "a name after parameter");
RUBICON_EXPECT(parameter_equals, "'=' and a value");
RUBICON_EXPECT(parameter_content, "a value or a text in quotes");
RUBICON_EXPECT(value_number, "a number");
RUBICON_EXPECT(named_value, "a parameter and its value");
RUBICON_EXPECT(goal_frame, kFrame, Explain::expected, kFrameWords);
RUBICON_EXPECT(goal, "'at' and a frame, or a parameter and its value");
RUBICON_EXPECT(duration, "a duration");
RUBICON_EXPECT(law_open, "'('");
RUBICON_EXPECT(law_value, "a duration");
RUBICON_EXPECT(law_close, "',' or ')'");
RUBICON_EXPECT(measured_file, "the name of a file of measured times in quotes");
RUBICON_EXPECT(measured_option, "the unit of the times (s, min or h), or column", Explain::expected,
               "s min h column");
RUBICON_EXPECT(measured_column, "the name of a column in quotes, or its number");
RUBICON_EXPECT(link_lag, "a duration");
RUBICON_EXPECT(link, "the name of a task");
RUBICON_EXPECT(links, "the name of a task");
RUBICON_EXPECT(listed_name, "a name");
RUBICON_EXPECT(listed_names, "a name");
RUBICON_EXPECT(number_value, "a number");
RUBICON_EXPECT(text_value, "a text in quotes");
RUBICON_EXPECT(support_content, "on, warn, off, equilibrium, or gap and a length");
RUBICON_EXPECT(support_gap, "a length");
RUBICON_EXPECT(within_limit, "a length, or a parameter and its value");
RUBICON_EXPECT(shift_dash, "'-' and the end of the shift");
RUBICON_EXPECT(shift_to, "a time such as 16:30");
RUBICON_EXPECT(shift_time, "a time such as 07:00");
RUBICON_EXPECT(off_day, "a date such as 2026-12-24");
RUBICON_EXPECT(last_day, "a day such as fri");
RUBICON_EXPECT(lost_last_month, "a month such as feb");
RUBICON_EXPECT(lost_share, "the share of days that are lost, such as 0.1");
RUBICON_EXPECT(shift, "calendar", Explain::item, "mon tue wed thu fri sat sun off lost carry_over");
RUBICON_EXPECT(calendar_name, "a name after calendar");
RUBICON_EXPECT(component_at_frame, kFrame, Explain::expected, kFrameWords);
RUBICON_EXPECT(component_grip_frame, kFrame, Explain::expected, kFrameWords);
RUBICON_EXPECT(mass_value, "a number");
RUBICON_EXPECT(density_value, "a number");
RUBICON_EXPECT(waived_first, "the name of a component, a robot, or site");
RUBICON_EXPECT(waived_second, "the name of a second component or robot, or site");
RUBICON_EXPECT(attribute_text, "a text in quotes");
RUBICON_EXPECT(group_heading, "a heading in quotes");
RUBICON_EXPECT(free_attribute_name, "a name after attribute");
RUBICON_EXPECT(component_part, "component", Explain::item,
               "shape at grip mass density cost fixed braced people name storey type guid "
               "attribute");
RUBICON_EXPECT(fixed_thing, "the name of a component, or site");
RUBICON_EXPECT(fixed_after, "the name of a task after 'after'");
RUBICON_EXPECT(brace, "the name of a component or a crew");
RUBICON_EXPECT(component_name, "a name after component");
RUBICON_EXPECT(cost_amount, "an amount per h");
RUBICON_EXPECT(material_amount, "an amount of money");
RUBICON_EXPECT(per_day_amount, "an amount per day");
RUBICON_EXPECT(per_day, "'per day'");
RUBICON_EXPECT(rental_from, "a date in quotes");
RUBICON_EXPECT(rental_to_key, "'to' and a date in quotes");
RUBICON_EXPECT(rental_to, "a date in quotes");
RUBICON_EXPECT(mobilisation_amount, "an amount of money");
RUBICON_EXPECT(overtime_factor, "a factor such as 1.5");
RUBICON_EXPECT(fuel_working, "what it burns at work, such as 18 l per h");
RUBICON_EXPECT(fuel_idling, "what it burns while it stands, such as 4 l per h");
RUBICON_EXPECT(fuel_price, "what a litre costs, such as 1.70 per l");
RUBICON_EXPECT(outside_calendar, "the name of a calendar");
RUBICON_EXPECT(used_calendar, "the name of a calendar");
RUBICON_EXPECT(breakdown_every, "every and the hours of work between two breakdowns");
RUBICON_EXPECT(breakdown_between, "a duration");
RUBICON_EXPECT(breakdown_takes, "takes and how long a repair takes");
RUBICON_EXPECT(breakdown_repair, "a duration");
RUBICON_EXPECT(robot_start_values, "a parameter and its value");
RUBICON_EXPECT(park_values, "a parameter and its value");
RUBICON_EXPECT(robot_use_part, "robot", Explain::item,
               "start cost rental mobilisation overtime fuel calendar breakdown park behaviour");
RUBICON_EXPECT(robot_behaviour_file, "the script's file in quotes");
RUBICON_EXPECT(robot_file_name, "the robot's file in quotes");
RUBICON_EXPECT(robot_frame, kFrame, Explain::expected, kFrameWords);
RUBICON_EXPECT(robot_use_end, "';' or '{'");
RUBICON_EXPECT(robot_use_form, "a name or a file in quotes after robot");
RUBICON_EXPECT(size_value, "a number");
RUBICON_EXPECT(crew_part, "crew", Explain::item,
               "size cost rental mobilisation overtime fuel calendar");
RUBICON_EXPECT(crew_end, "';' or '{'");
RUBICON_EXPECT(crew_name, "a name after crew");
RUBICON_EXPECT(pool_part, "pool", Explain::item, "of choose");
RUBICON_EXPECT(pool_name, "a name after pool");
RUBICON_EXPECT(storage_name, "a name after storage");
RUBICON_EXPECT(floor_place, "a place in parentheses, such as (4, 2.5)");
RUBICON_EXPECT(place_x, "a number");
RUBICON_EXPECT(place_comma, "',' and y");
RUBICON_EXPECT(place_y, "a number");
RUBICON_EXPECT(place_close, "')'");
RUBICON_EXPECT(area_height_value, "a length");
RUBICON_EXPECT(area_column_comma, "',' and the size of the column");
RUBICON_EXPECT(area_column_size, "a length");
RUBICON_EXPECT(area_name, "a name after area");
RUBICON_EXPECT(area_part, "area", Explain::item,
               "height at outline shaft column round_column beam obstacles");
RUBICON_EXPECT(area_at_frame, "a frame");
RUBICON_EXPECT(area_obstacles_from, "from components after obstacles");
RUBICON_EXPECT(area_obstacles_components, "components after obstacles from");
RUBICON_EXPECT(dig_volume, "the volume of soil to dig, such as 10000 m3");
RUBICON_EXPECT(dig_shape,
               "the shape of the pit, such as prism(-3.2, 0, 4, -1.3, 9, -1.3, 9, 1.3, 4, 1.3)");
RUBICON_EXPECT(earth_columns, "how many columns of cells");
RUBICON_EXPECT(earth_comma, "',' and how many rows of cells");
RUBICON_EXPECT(earth_rows, "how many rows of cells");
RUBICON_EXPECT(earth_file, "the file of heights in quotes");
RUBICON_EXPECT(earth_height_value, "a height, or from and a file in quotes");
RUBICON_EXPECT(earth_number_value, "a number");
RUBICON_EXPECT(earth_at_frame, "a frame");
RUBICON_EXPECT(earth_name, "a name after earth");
RUBICON_EXPECT(earth_part, "earth", Explain::item,
               "grid cell height at stands swell density repose");
RUBICON_EXPECT(dig_number_value, "a number");
RUBICON_EXPECT(dig_trucks, "the name of the crew of trucks after load");
RUBICON_EXPECT(dig_stage_takes, "takes");
RUBICON_EXPECT(dig_server, "a name after by");
RUBICON_EXPECT(dig_part, "dig", Explain::item,
               "load swell density bed payload bucket fill_factor efficiency loaded limit layer "
               "tolerance clearance cut carry open dump queue");
RUBICON_EXPECT(dig_place_at, "at and a place");
RUBICON_EXPECT(dig_place_frame, "a place, such as trans(2, 6, 0) * rotz(90)");
RUBICON_EXPECT(workspaces_machine, "the name of a robot or a fleet after of");
RUBICON_EXPECT(workspaces_number_value, "a number");
RUBICON_EXPECT(workspaces_part, "workspaces", Explain::item,
               "of reaction braking turn_braking look_ahead risk watch");
RUBICON_EXPECT(haul_number_value, "a number");
RUBICON_EXPECT(haul_place_at, "at and a place");
RUBICON_EXPECT(haul_place_frame, "a place, such as trans(2, 6, 0) * rotz(90)");
RUBICON_EXPECT(haul_tip_takes, "at and a place, or takes and a duration");
RUBICON_EXPECT(haul_heap_earth, "the name of an earth after heap");
RUBICON_EXPECT(haul_heap_at, "at and where it falls, as seen from the truck");
RUBICON_EXPECT(haul_heap_frame, "a place as seen from the truck, such as trans(-5, 0, 0)");
RUBICON_EXPECT(haul_raise_values, "a parameter and its value");
RUBICON_EXPECT(haul_part, "haul", Explain::item, "bed payload out tip back heap raise");
RUBICON_EXPECT(haul_dig, "the name of a task that digs after haul");
RUBICON_EXPECT(dig_attitude_frame, "a frame, such as roty(90)");
RUBICON_EXPECT(dig_dump_at, "at after dump");
RUBICON_EXPECT(dig_dump_frame, "a place, such as trans(2, 6, 3.5)");
RUBICON_EXPECT(cover_number_value, "a number");
RUBICON_EXPECT(cover_word_value, "a word");
RUBICON_EXPECT(cover_holes_x, "how far holes are apart along x");
RUBICON_EXPECT(cover_holes_comma, "',' and how far holes are apart along y");
RUBICON_EXPECT(cover_holes_y, "a length");
RUBICON_EXPECT(cover_joint_after, "after");
RUBICON_EXPECT(cover_joint_limit, "a duration such as 90 min");
RUBICON_EXPECT(cover_guide_name, "the name of a guide");
RUBICON_EXPECT(cover_area, "the name of an area after cover");
RUBICON_EXPECT(cover_part, "cover", Explain::item,
               "width clearance above thickness rate partition order lines from inlet cold_joint "
               "guide turn_radius holes depth feed");
RUBICON_EXPECT(moving_name, "a name after moving");
RUBICON_EXPECT(moving_part, "moving", Explain::item, "shape path repeat people");
RUBICON_EXPECT(path_place, "a time and a frame such as 20 s trans(25, 2, 0)");
RUBICON_EXPECT(choice_rule, "first, nearest or least_used");
RUBICON_EXPECT(network_name, "a name after network");
RUBICON_EXPECT(network_part, "network", Explain::item,
               "policy class node lane errand report barrier explore map scenario agents agent "
               "jobs job for when");
RUBICON_EXPECT(policy_name, "order, charts, tarry, fraenkel or grid");
RUBICON_EXPECT(policy_end, "';' or '{' after the policy");
RUBICON_EXPECT(
    policy_part, "policy", Explain::item,
    "tolerance delay clearance minimise expansions seed window interval tick late late_ticks");
RUBICON_EXPECT(minimise_what, "time, distance or cost");
RUBICON_EXPECT(policy_number_value, "a number");
RUBICON_EXPECT(grid_file_name, "the name of a file in quotes");
RUBICON_EXPECT(grid_count_value, "how many");
RUBICON_EXPECT(grid_job_name, "a name after job");
RUBICON_EXPECT(grid_job_arrives, "the tick from which the job may be taken");
RUBICON_EXPECT(grid_agent_name, "a name after agent");
RUBICON_EXPECT(grid_from_key, "'from' and a cell such as (4, 2)");
RUBICON_EXPECT(grid_from, "a cell: its column and its row in parentheses, such as (4, 2)");
RUBICON_EXPECT(grid_to_key, "'to' and a cell such as (4, 2)");
RUBICON_EXPECT(grid_to, "a cell: its column and its row in parentheses, such as (4, 2)");
RUBICON_EXPECT(class_name, "a name after class");
RUBICON_EXPECT(class_part, "class", Explain::item, "speed width cost");
RUBICON_EXPECT(class_speed_value, "a speed such as 2 m/s");
RUBICON_EXPECT(class_width_value, "a width such as 3 m");
RUBICON_EXPECT(class_cost_value, "what a metre costs, such as 0.5 per m");
RUBICON_EXPECT(errand_name, "a name after errand: that of the robot");
RUBICON_EXPECT(errand_from_key, "'from' and a node");
RUBICON_EXPECT(errand_from, "the node where the errand begins");
RUBICON_EXPECT(errand_to_key, "'to' and a node");
RUBICON_EXPECT(errand_to, "the node where the errand ends");
RUBICON_EXPECT(errand_at, "'at' and when it starts, such as at 20 s");
RUBICON_EXPECT(errand_start, "a time such as 20 s");
RUBICON_EXPECT(errand_number_value, "a number");
RUBICON_EXPECT(errand_end, "';' or '{' after the errand");
RUBICON_EXPECT(errand_part, "errand", Explain::item, "priority speed width");
RUBICON_EXPECT(report_lane_key, "'lane' and the two nodes of a lane");
RUBICON_EXPECT(report_from, "the node where the lane begins");
RUBICON_EXPECT(report_to_key, "'to' and a node");
RUBICON_EXPECT(report_to, "the node where the lane ends");
RUBICON_EXPECT(report_what, "blocked, reopened or obstacle", Explain::expected,
               "blocked reopened obstacle");
RUBICON_EXPECT(report_edge, "a length from the right-hand wall, such as 0.5 m");
RUBICON_EXPECT(report_edges_to, "'to' and the other edge of the obstacle");
RUBICON_EXPECT(report_at, "'at' and the time of the report, such as at 20 s");
RUBICON_EXPECT(report_time, "a time such as 20 s");
RUBICON_EXPECT(report_by, "'by' and the robot that reports");
RUBICON_EXPECT(report_robot, "the robot that reports");
RUBICON_EXPECT(barrier_lane_key, "'lane' and the two nodes of a lane");
RUBICON_EXPECT(barrier_from, "the node where the lane begins");
RUBICON_EXPECT(barrier_to_key, "'to' and a node");
RUBICON_EXPECT(barrier_to, "the node where the lane ends");
RUBICON_EXPECT(barrier_since_key, "'from' and when the barrier comes, such as from 20 s");
RUBICON_EXPECT(barrier_since, "a time such as 20 s");
RUBICON_EXPECT(barrier_until, "when the barrier goes, such as 60 s");
RUBICON_EXPECT(explore_name, "a name after explore: that of the robot");
RUBICON_EXPECT(explore_from_key, "'from' and a node");
RUBICON_EXPECT(explore_from, "the node where it begins");
RUBICON_EXPECT(node_name, "a name after node");
RUBICON_EXPECT(node_at, "'at' and a frame");
RUBICON_EXPECT(node_frame, kFrame, Explain::expected, kFrameWords);
RUBICON_EXPECT(lane_from, "the node where the lane begins");
RUBICON_EXPECT(lane_to_key, "'to' and a node");
RUBICON_EXPECT(lane_end, "the node where the lane ends");
RUBICON_EXPECT(beside_from, "the node where the lane beside begins");
RUBICON_EXPECT(beside_to_key, "'to' and a node");
RUBICON_EXPECT(beside_end, "the node where the lane beside ends");
RUBICON_EXPECT(lane_length_value, "a length such as 40 m");
RUBICON_EXPECT(fleet_name, "a name after fleet");
RUBICON_EXPECT(fleet_part, "fleet", Explain::item,
               "robot size on at choose cost rental mobilisation overtime fuel calendar breakdown");
RUBICON_EXPECT(fleet_file, "the robot's file in quotes");
RUBICON_EXPECT(fleet_size_value, "a number");
RUBICON_EXPECT(fleet_network, "the name of a network");
RUBICON_EXPECT(fleet_place, "the name of a node");
RUBICON_EXPECT(fleet_rule, "first, nearest or least_used");
RUBICON_EXPECT(by_whom, "the name of a robot, a crew or a pool");
RUBICON_EXPECT(same_as_task, "the name of a task");
RUBICON_EXPECT(all_of_pool, "the name of a pool");
RUBICON_EXPECT(need, "a number of people and a crew such as 2 masons");
RUBICON_EXPECT(needed_crew, "the name of a crew");
RUBICON_EXPECT(moved_component, "the name of a component");
RUBICON_EXPECT(to_key, "'to' and a frame");
RUBICON_EXPECT(removed_component, "the name of a component");
RUBICON_EXPECT(work_crew, "the name of a crew");
RUBICON_EXPECT(turned_parameter, "'theta', the turn about the vertical");
RUBICON_EXPECT(goal_with_values, "a parameter and its value");
RUBICON_EXPECT(free_turn, "rotx, roty or rotz");
RUBICON_EXPECT(near_values, "a parameter and its value");
RUBICON_EXPECT(entering_body, "the body of the tool");
RUBICON_EXPECT(entered_component, "the name of a component");
RUBICON_EXPECT(locked_parameter, "the name of a control parameter");
RUBICON_EXPECT(deviation_quantity, "a length, then an angle if you like");
RUBICON_EXPECT(moment,
               "a date and time such as 2026-03-02 07:00, or a duration after the plan begins");
RUBICON_EXPECT(up_to_height, "the height that it reaches");
RUBICON_EXPECT(baseline_to, "'to' and the end of the baseline");
RUBICON_EXPECT(
    task_part, "task", Explain::item,
    "by needs move go remove hook adjust release takes dig haul via guide situation within free "
    "near lock enter deviation budget "
    "priority not_before due baseline zone after name group attribute for when whole");
RUBICON_EXPECT(task_name, "a name after task");
RUBICON_EXPECT(module_part, "module", Explain::item, "component task touching within for when");
RUBICON_EXPECT(module_name, "a name after module");
RUBICON_EXPECT(placed_module, "the name of a module");
RUBICON_EXPECT(placed_at, "'at' and a frame");
RUBICON_EXPECT(placed_frame, kFrame, Explain::expected, kFrameWords);
RUBICON_EXPECT(stock_frame, kFrame, Explain::expected, kFrameWords);
RUBICON_EXPECT(as_key, "'from' and a frame, or 'as' and a name");
RUBICON_EXPECT(placed_as, "a name after as");
RUBICON_EXPECT(import_file, "the name of a file in quotes");
RUBICON_EXPECT(import_name, "a name after as");
RUBICON_EXPECT(import_block, "'{' after import");
RUBICON_EXPECT(import_end, "';' or '{' after import");
RUBICON_EXPECT(short_start_values, "a parameter and its value");
RUBICON_EXPECT(
    plan_item, "plan", Explain::item,
    "component robot crew pool overhead task module place import site storage moving area earth "
    "network "
    "fleet "
    "contact "
    "budget "
    "start_at "
    "currency calendar situation start goal via carry within free near lock enter deviation "
    "touching "
    "guide "
    "parameter for when whole support");
RUBICON_EXPECT(plan_file_key, "'plan' at the start of a plan");
RUBICON_EXPECT(plan_name, "a name after plan");
RUBICON_EXPECT(plan_finished, "the end of the file after the '}' of the plan");

// studies
RUBICON_EXPECT(study_semicolon, "';'");
RUBICON_EXPECT(studied_plan, "the name of a plan in quotes");
RUBICON_EXPECT(varied_name, "the name of a parameter of the plan");
RUBICON_EXPECT(varied_value, "a value such as 4, 3.6 m or \"a text\"");
RUBICON_EXPECT(varied_last, "the last value of the range");
RUBICON_EXPECT(varied_step, "the step of the range");
RUBICON_EXPECT(design_kind, "full, latin, one_at_a_time or search", Explain::expected,
               "full latin one_at_a_time search");
inline constexpr const char* kMeasure = "what is asked, such as makespan or p80(finish)";
RUBICON_EXPECT(asked, kMeasure);
RUBICON_EXPECT(measure_argument, "a name");
RUBICON_EXPECT(measure_close, "')'");
RUBICON_EXPECT(chosen_measure, kMeasure);
RUBICON_EXPECT(required_limit, kMeasure);
RUBICON_EXPECT(choose_limit, kMeasure);
RUBICON_EXPECT(limit_operator, "<=, >=, < or >");
RUBICON_EXPECT(limit_value, "a number or a date in quotes");
RUBICON_EXPECT(runs_most, "most (runs at most 500)", Explain::expected, "most");
RUBICON_EXPECT(runs_count, "the number of runs");
RUBICON_EXPECT(seed_value, "a whole number");
RUBICON_EXPECT(choose_direction, "least or most", Explain::expected, "least most");
RUBICON_EXPECT(study_item, "study", Explain::item, "plan vary design runs seed ask choose");
RUBICON_EXPECT(study_file_key, "'study' at the start of a study");
RUBICON_EXPECT(study_name, "a name after study");
RUBICON_EXPECT(study_finished, "the end of the file after the '}' of the study");

#undef RUBICON_EXPECT

}  // namespace rubicon::grammar
