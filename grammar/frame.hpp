#pragma once

#include "grammar/expression.hpp"

/// Frames (products of elementary transforms) and shapes.
namespace rubicon::grammar {

// Frames.
struct frame_word : token<sor<word<exact<"trans">>, word<exact<"rotx">>, word<exact<"roty">>,
                              word<exact<"rotz">>>> {};
struct frame_open : open_parenthesis {};
struct frame_argument : expression {};
struct frame_close : close_parenthesis {};
struct frame_element : if_must<frame_word, frame_open, frame_argument,
                               star<if_must<comma, frame_argument>>, frame_close> {};
/// Of a plan: the place of a node, such as yard.bay[7].
struct frame_node : seq<ask<Query::computes_numbers>, at<name, one<'.'>>, qualified_indexed_name> {
};
struct frame_factor : sor<frame_element, frame_node> {};
struct frame : seq<frame_factor, star<if_must<star_sign, frame_factor>>> {};

// Shapes.
struct at_key : token<word<exact<"at">>> {};
struct shape_frame : frame {};
struct shape_at : if_must<at_key, shape_frame> {};

struct shape_open : open_parenthesis {};
struct shape_close : close_parenthesis {};

/// In robots a number with a sign, in plans what is computed.
struct computed_number : seq<ask<Query::computes_numbers>, quantity> {};

struct mesh_name : token<word<exact<"mesh">>> {};
struct mesh_file : string_literal {};
struct scale_key : token<word<exact<"scale">>> {};
struct mesh_scale : sor<computed_number, signed_number> {};
struct up_key : token<word<exact<"up">>> {};
struct mesh_up : name {};
struct part_key : token<word<exact<"part">>> {};
struct mesh_part : string_literal {};
struct mesh_hull : token<word<exact<"hull">>> {};
struct mesh_unit : name {};
struct mesh_option : sor<if_must<scale_key, mesh_scale>, if_must<up_key, mesh_up>,
                         if_must<part_key, mesh_part>, mesh_hull, mesh_unit> {};
struct mesh
    : if_must<mesh_name, shape_open, mesh_file, star<if_must<comma, mesh_option>>, shape_close> {};

struct solid_name : name {};
struct shape_number : sor<computed_number, signed_number> {};
struct shape_numbers : opt<shape_number, star<if_must<comma, shape_number>>> {};
struct solid : if_must<solid_name, shape_open, shape_numbers, shape_close> {};

struct shape : seq<sor<mesh, solid>, opt<shape_at>> {};

}  // namespace rubicon::grammar
