#pragma once

#include "grammar/frame.hpp"
#include "interpreter/parse/parse_expression.hpp"

/// Actions of frames and shapes. Only for the parse_*.cpp files.
namespace rubicon::interpreter {

/// The frame and the shape under construction; neither nests.
class FrameState : public ExpressionState {
 public:
  using ExpressionState::ExpressionState;

  void roll_back(const Checkpoint& checkpoint) {
    ExpressionState::roll_back(checkpoint);
    frame_ = {};
  }

  void begin_frame_element(const char* from) {
    using Kind = syntax::FrameElement::Kind;
    element_ = {};
    const std::string_view word(from, static_cast<std::size_t>(last_end - from));
    element_.kind = word == "trans"  ? Kind::trans
                    : word == "rotx" ? Kind::rotx
                    : word == "roty" ? Kind::roty
                                     : Kind::rotz;
  }
  /// The node whose name was read last.
  void add_frame_node(const char* from) {
    element_ = {};
    element_.kind = syntax::FrameElement::Kind::node;
    element_.node = take_qualified_name();
    end_frame_element(from);
  }
  void add_frame_argument() { element_.arguments.push_back(take_expression()); }
  void end_frame_element(const char* from) {
    element_.span = span_from(from);
    if (frame_.elements.empty()) frame_.span = element_.span;
    frame_.span.end = element_.span.end;
    frame_.elements.push_back(std::move(element_));
  }
  syntax::Frame take_frame() { return std::exchange(frame_, {}); }

  void begin_shape(syntax::Name kind) {
    shape = {};
    shape.kind = std::move(kind);
  }
  syntax::Shape take_shape() {
    shape.span = shape.kind.span;
    shape.span.end = span_from(last_end).begin;
    return std::move(shape);
  }
  void set_mesh_unit(syntax::Name unit) {
    if (shape.unit) {
      const std::string near = did_you_mean(unit.text, {"scale", "up", "part", "hull"});
      report_token("S04", begin() + unit.span.begin,
                   "unknown option '" + unit.text + "' of a mesh" +
                       (near.empty() ? std::string() : "; did you mean " + near + "?"),
                   "a mesh has a unit, scale, up, part and hull");
      return;
    }
    shape.unit = std::move(unit);
  }
  void set_mesh_hull(const char* from) {
    if (shape.hull) report_token("S04", from, "hull stands twice in this mesh", "once is enough");
    shape.hull = syntax::Name{"hull", span_from(from)};
  }

  syntax::Shape shape;

 private:
  syntax::Frame frame_;
  syntax::FrameElement element_;
};

template <typename Rule>
struct FrameAction : ExpressionAction<Rule> {};

RUBICON_ACTION(FrameAction, FrameState, frame_word) { st.begin_frame_element(begin); }
RUBICON_ACTION(FrameAction, FrameState, frame_argument) { st.add_frame_argument(); }
RUBICON_ACTION(FrameAction, FrameState, frame_node) { st.add_frame_node(begin); }
RUBICON_ACTION(FrameAction, FrameState, frame_element) { st.end_frame_element(begin); }

RUBICON_ACTION(FrameAction, FrameState, mesh_name) {
  st.begin_shape({"mesh", st.span_from(begin)});
}
RUBICON_ACTION(FrameAction, FrameState, solid_name) { st.begin_shape(st.take_name()); }
RUBICON_ACTION(FrameAction, FrameState, computed_number) { st.number = st.take_quantity(); }
RUBICON_ACTION(FrameAction, FrameState, shape_number) {
  st.shape.numbers.push_back(std::move(st.number));
}
RUBICON_ACTION(FrameAction, FrameState, shape_frame) { st.shape.at = st.take_frame(); }
RUBICON_ACTION(FrameAction, FrameState, mesh_file) { st.shape.file = st.string; }
RUBICON_ACTION(FrameAction, FrameState, mesh_scale) { st.shape.scale = st.number; }
RUBICON_ACTION(FrameAction, FrameState, mesh_up) { st.shape.up = st.take_name(); }
RUBICON_ACTION(FrameAction, FrameState, mesh_part) { st.shape.part = st.string; }
RUBICON_ACTION(FrameAction, FrameState, mesh_hull) { st.set_mesh_hull(begin); }
RUBICON_ACTION(FrameAction, FrameState, mesh_unit) { st.set_mesh_unit(st.take_name()); }

}  // namespace rubicon::interpreter
