#include "grammar/robot.hpp"
#include "interpreter/parse/parse_guide.hpp"

namespace rubicon::interpreter {

namespace {

/// The items of a robot under construction; they do not nest but for those of a body in its body.
class RobotState : public GuideState {
 public:
  using GuideState::GuideState;

  template <typename Item>
  void add(Item item, const char* from) {
    item.span = span_from(from);
    robot.items.emplace_back(std::move(item));
  }

  syntax::Robot robot;
  syntax::BodyItem body;
  syntax::ParameterItem parameter;
  syntax::RuleItem rule;
  syntax::SettingItem setting;
  syntax::ToolItem tool;
  syntax::ConstItem constant;
  syntax::CapacityItem capacity;
  syntax::Number radius;
  syntax::RopeItem rope;
  syntax::BufferItem buffer;
  std::vector<syntax::RopeItem::End> rope_ends;
  std::vector<syntax::Name> names;
  syntax::MotionClause deviation;
  syntax::BehaviourItem behaviour;
};

template <typename Rule>
struct RobotAction : GuideAction<Rule> {};

// bodies
RUBICON_ACTION(RobotAction, RobotState, attribute_name) {
  st.parameter.attributes.emplace_back();
  st.parameter.attributes.back().name = st.take_name();
}
RUBICON_ACTION(RobotAction, RobotState, attribute_number) {
  st.parameter.attributes.back().numbers.push_back(st.number);
}
RUBICON_ACTION(RobotAction, RobotState, attribute) {
  st.parameter.attributes.back().span = st.span_from(begin);
}
RUBICON_ACTION(RobotAction, RobotState, param_name) {
  st.parameter = {};
  st.parameter.name = st.take_name();
}
RUBICON_ACTION(RobotAction, RobotState, derived_value) {
  st.parameter.derived = st.take_expression();
}
RUBICON_ACTION(RobotAction, RobotState, param_item) {
  st.parameter.span = st.span_from(begin);
  st.body.parameters.push_back(std::move(st.parameter));
}
RUBICON_ACTION(RobotAction, RobotState, rule_parameter) { st.rule.parameter = st.take_name(); }
RUBICON_ACTION(RobotAction, RobotState, rule_value) { st.rule.value = st.take_expression(); }
RUBICON_ACTION(RobotAction, RobotState, rule_item) {
  st.rule.span = st.span_from(begin);
  st.body.rules.push_back(std::move(st.rule));
}
RUBICON_ACTION(RobotAction, RobotState, frame_item) {
  st.body.frames.push_back({st.take_frame(), st.span_from(begin)});
}
RUBICON_ACTION(RobotAction, RobotState, shape_item) {
  st.body.shapes.push_back({st.take_shape(), st.span_from(begin)});
}
RUBICON_ACTION(RobotAction, RobotState, body_key) {
  st.body = {};
  st.announce("body");
}
RUBICON_ACTION(RobotAction, RobotState, body_name) { st.body.name = st.take_name(); }
RUBICON_ACTION(RobotAction, RobotState, body_parent) { st.body.on = st.take_name(); }
RUBICON_ACTION(RobotAction, RobotState, body) { st.add(std::move(st.body), begin); }

// behaviours
RUBICON_ACTION(RobotAction, RobotState, behaviour_item_key) {
  st.behaviour = {};
  st.announce("behaviour");
}
RUBICON_ACTION(RobotAction, RobotState, behaviour_file) { st.behaviour.file = st.string; }
RUBICON_ACTION(RobotAction, RobotState, inline_script) {
  st.behaviour.script = st.take_script(begin);
}
RUBICON_ACTION(RobotAction, RobotState, behaviour_item) { st.add(std::move(st.behaviour), begin); }
RUBICON_ACTION(RobotAction, RobotState, body_behaviour_item) {
  st.behaviour.span = st.span_from(begin);
  for (const syntax::BehaviourDefinition& definition : st.behaviour.script.behaviours) {
    const char* const at = st.begin() + definition.span.begin;
    st.report_token("S04", at,
                    "a behaviour is defined in the robot's own script, not in that of a body");
  }
  st.body.behaviours.push_back(std::move(st.behaviour));
}

// the robot
RUBICON_ACTION(RobotAction, RobotState, setting_key) {
  st.setting = {};
  st.setting.name = {std::string(begin, st.last_end), st.span_from(begin)};
}
RUBICON_ACTION(RobotAction, RobotState, setting_value) { st.setting.value = st.number; }
RUBICON_ACTION(RobotAction, RobotState, setting_item) { st.add(std::move(st.setting), begin); }
RUBICON_ACTION(RobotAction, RobotState, tool_body) {
  st.tool = {};
  st.tool.body = st.take_name();
}
RUBICON_ACTION(RobotAction, RobotState, tool_frame) { st.tool.at = st.take_frame(); }
RUBICON_ACTION(RobotAction, RobotState, tool_item) { st.add(std::move(st.tool), begin); }
RUBICON_ACTION(RobotAction, RobotState, const_name) { st.constant.name = st.take_name(); }
RUBICON_ACTION(RobotAction, RobotState, const_value) { st.constant.value = st.take_expression(); }
RUBICON_ACTION(RobotAction, RobotState, const_item) { st.add(std::move(st.constant), begin); }
RUBICON_ACTION(RobotAction, RobotState, touching_key) { st.names.clear(); }
RUBICON_ACTION(RobotAction, RobotState, touching_name) { st.names.push_back(st.take_name()); }
RUBICON_ACTION(RobotAction, RobotState, touching_item) {
  st.add(syntax::TouchingItem{st.names[0], st.names[1], {}}, begin);
}
RUBICON_ACTION(RobotAction, RobotState, capacity_key) { st.capacity = {}; }
RUBICON_ACTION(RobotAction, RobotState, capacity_comma) { st.radius = st.number; }
RUBICON_ACTION(RobotAction, RobotState, capacity_point) {
  st.capacity.points.emplace_back(st.radius, st.number);
}
RUBICON_ACTION(RobotAction, RobotState, capacity_item) { st.add(std::move(st.capacity), begin); }
RUBICON_ACTION(RobotAction, RobotState, rope_key) {
  st.rope = {};
  st.rope_ends.clear();
}
RUBICON_ACTION(RobotAction, RobotState, rope_name) { st.rope.name = st.take_name(); }
RUBICON_ACTION(RobotAction, RobotState, rope_radius) { st.rope.radius = st.number; }
RUBICON_ACTION(RobotAction, RobotState, rope_body) { st.rope_ends.push_back({st.take_name(), {}}); }
RUBICON_ACTION(RobotAction, RobotState, rope_number) {
  st.rope_ends.back().point.push_back(st.number);
}
RUBICON_ACTION(RobotAction, RobotState, rope_item) {
  st.rope.from = std::move(st.rope_ends[0]);
  st.rope.to = std::move(st.rope_ends[1]);
  st.add(std::move(st.rope), begin);
}
RUBICON_ACTION(RobotAction, RobotState, buffer_key) { st.buffer = {}; }
RUBICON_ACTION(RobotAction, RobotState, buffer_distance) { st.buffer.distance = st.number; }
RUBICON_ACTION(RobotAction, RobotState, buffer_body) { st.buffer.bodies.push_back(st.take_name()); }
RUBICON_ACTION(RobotAction, RobotState, buffer_item) { st.add(std::move(st.buffer), begin); }
RUBICON_ACTION(RobotAction, RobotState, deviation_key) {
  st.deviation = {};
  st.deviation.key = {std::string(begin, st.last_end), st.span_from(begin)};
}
RUBICON_ACTION(RobotAction, RobotState, deviation_number) {
  st.deviation.numbers.push_back(st.number);
}
RUBICON_ACTION(RobotAction, RobotState, deviation_item) { st.add(std::move(st.deviation), begin); }
RUBICON_ACTION(RobotAction, RobotState, guide_declaration) { st.add(std::move(st.guide), begin); }
RUBICON_ACTION(RobotAction, RobotState, robot_key) { st.announce("robot"); }
RUBICON_ACTION(RobotAction, RobotState, robot_name) { st.robot.name = st.take_name(); }

}  // namespace

syntax::Robot parse_robot(const SourceMap& sources, FileId file, Diagnostics& diagnostics) {
  RobotState state(
      sources, file, diagnostics, "R00",
      {"param", "rule", "frame", "shape", "behaviour", "behavior", "time_step", "sensor", "body",
       "tool", "const", "touching", "capacity", "rope", "buffer", "deviation", "guide"});
  const bool finished = run_parser<grammar::robot_file, RobotAction>(state);
  state.robot.broken = !finished || state.errors() > 0;
  state.robot.span = state.span_from(state.begin());
  return std::move(state.robot);
}

}  // namespace rubicon::interpreter
