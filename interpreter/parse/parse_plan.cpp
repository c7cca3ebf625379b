#include "interpreter/parse/parse_plan.hpp"

#include <algorithm>

#include "interpreter/parse/parse_grid.hpp"

namespace rubicon::interpreter {

void PlanState::set_cost(const char* from) {
  if (!quantity.expression && quantity.unit != syntax::UnitKind::per_hour) {
    report_token("P00", begin() + quantity.span.begin,
                 "expected an amount per h, such as 180 per h");
    return;
  }
  syntax::Cost cost{std::move(quantity), span_from(from)};
  (in_crew ? crew.cost : robot.cost).push_back(std::move(cost));
}

void PlanState::divide_by_hour(const char* from) {
  // Behind a number it is the unit of that, and stands on its line.
  Span last = quantity.span;
  bool is_number = !quantity.expression;
  for (const syntax::Expression* at = quantity.expression.get(); at != nullptr;) {
    last = at->span;
    is_number = at->kind == syntax::Expression::Kind::number;
    const bool goes_on = !at->operands.empty() && at->kind != syntax::Expression::Kind::call;
    at = goes_on ? at->operands.back().get() : nullptr;
  }
  if (is_number && std::find(begin() + last.end, from, ')') == from) {
    report_token("P00", from, "expected 'per h' on the line of its number");
  }
  const auto number_of = [](syntax::Number written) {
    auto literal = std::make_unique<syntax::Expression>();
    literal->span = written.span;
    literal->number = std::move(written);
    return literal;
  };
  auto rate = std::make_unique<syntax::Expression>();
  rate->kind = syntax::Expression::Kind::binary;
  rate->op = syntax::Expression::Operator::divide;
  rate->op_span = span_from(from);
  rate->span = quantity.span;
  rate->span.end = rate->op_span.end;
  syntax::ExpressionPtr amount = std::move(quantity.expression);
  if (!amount) amount = number_of(std::move(quantity));
  number = {};
  number.value = 1;
  number.span = rate->op_span;
  set_unit(last_end - 1, last_end);  // the h
  rate->operands.push_back(std::move(amount));
  rate->operands.push_back(number_of(std::move(number)));
  quantity = {};
  quantity.span = rate->span;
  quantity.expression = std::move(rate);
}

syntax::Name PlanState::take_dotted_name() {
  syntax::QualifiedName written = take_qualified_name();
  if (!written.body) return std::move(written.name);
  if (!written.body->indices.empty()) {
    report_token("P00", begin() + written.span.begin,
                 "the name of an import takes no brackets: NAME.x[i]");
  }
  written.name.text = written.body->text + "." + written.name.text;
  written.name.span = written.span;
  return std::move(written.name);
}

void PlanState::add_import(const char* from) {
  if (!import.as && *(last_end - 1) == ';') {
    report_token("P00", from, "a plan is imported under a name: import \"FILE\" as NAME;");
  }
  add(std::move(import), from);
}

void PlanState::add_heading() {
  if (headings.text.empty()) {
    headings = string;
  } else {
    headings.text += " / " + string.text;
    headings.span.end = string.span.end;
  }
}

void PlanState::open_block(std::string_view word) {
  if (in_task) {
    task_blocks.push_back({std::move(head), {}, {}});
  } else if (in_network) {
    network_blocks.push_back({std::move(head), {}, {}});
  } else if (in_module) {
    module_blocks.push_back({std::move(head), {}, {}});
  } else {
    plan_blocks.push_back({std::move(head), {}, {}});
  }
  announce(word);
}

void PlanState::close_task_block(const char* from) {
  auto block = std::make_shared<syntax::TaskBlock>(std::move(task_blocks.back()));
  task_blocks.pop_back();
  block->span = span_from(from);
  task_parts().emplace_back(std::move(block));
}

void PlanState::close_module_block(const char* from) {
  auto block = std::make_shared<syntax::ModuleBlock>(std::move(module_blocks.back()));
  module_blocks.pop_back();
  block->span = span_from(from);
  module_items().emplace_back(std::move(block));
}

void PlanState::close_network_block(const char* from) {
  auto block = std::make_shared<syntax::NetworkBlock>(std::move(network_blocks.back()));
  network_blocks.pop_back();
  block->span = span_from(from);
  network_parts().emplace_back(std::move(block));
}

void PlanState::close_plan_block(const char* from) {
  auto block = std::make_shared<syntax::PlanBlock>(std::move(plan_blocks.back()));
  plan_blocks.pop_back();
  block->span = span_from(from);
  plan_items().emplace_back(std::move(block));
}

void PlanState::roll_back(const Checkpoint& checkpoint) {
  ScriptState::roll_back(checkpoint);
  in_task = checkpoint.in_task;
  in_module = checkpoint.in_module;
  in_network = checkpoint.in_network;
  network_blocks.resize(checkpoint.network_blocks);
  task_blocks.resize(checkpoint.task_blocks);
  module_blocks.resize(checkpoint.module_blocks);
  plan_blocks.resize(checkpoint.plan_blocks);
}

void PlanState::add_attribute(const char* from) {
  syntax::AttributeItem item{std::move(key), std::move(string), span_from(from)};
  if (in_task) {
    task_parts().emplace_back(std::move(item));
  } else {
    component.attributes.push_back(std::move(item));
  }
}

namespace {

template <typename Rule>
struct PlanAction : GuideAction<Rule> {};

syntax::String token_string(const PlanState& st, const char* begin) {
  return {std::string(begin, st.last_end), st.span_from(begin)};
}

RUBICON_ACTION(PlanAction, PlanState, bare_date) { st.string = token_string(st, begin); }
RUBICON_ACTION(PlanAction, PlanState, bare_time) {
  const syntax::String time = token_string(st, begin);
  st.string.text += " " + time.text;
  st.string.span.end = time.span.end;
}

// values, goals, links
RUBICON_ACTION(PlanAction, PlanState, value_name) { st.value_name = st.take_qualified_name(); }
RUBICON_ACTION(PlanAction, PlanState, value_number) {
  st.values.values.push_back({std::move(st.value_name), st.take_quantity()});
}
RUBICON_ACTION(PlanAction, PlanState, goal_frame) {
  st.goal = {st.take_frame(), {}, st.span_from(begin)};
}
RUBICON_ACTION(PlanAction, PlanState, goal_values) {
  st.goal = {std::nullopt, st.take_values(), st.span_from(begin)};
}
RUBICON_ACTION(PlanAction, PlanState, goal_with_values) {
  st.goal.values = st.take_values();
  st.goal.span.end = st.goal.values.span.end;
}
RUBICON_ACTION(PlanAction, PlanState, law_key) {
  st.law.emplace();
  st.law->name = st.word(begin);
  st.law->name.text.erase(st.law->name.text.find_last_not_of(" \t") + 1);
}
RUBICON_ACTION(PlanAction, PlanState, law_value) { st.law->values.push_back(st.take_quantity()); }
RUBICON_ACTION(PlanAction, PlanState, duration_law) {
  st.law->span = st.span_from(begin);
  st.duration = {};
  st.duration.span = st.law->span;
}
RUBICON_ACTION(PlanAction, PlanState, measured_key) {
  st.law.emplace();
  st.law->name = st.word(begin);
  st.law->name.text.erase(st.law->name.text.find_last_not_of(" \t") + 1);
}
RUBICON_ACTION(PlanAction, PlanState, measured_file) { st.law->file = st.string; }
RUBICON_ACTION(PlanAction, PlanState, measured_unit) { st.law->units.push_back(st.take_name()); }
RUBICON_ACTION(PlanAction, PlanState, measured_column_name) {
  st.law->columns.push_back(st.string);
}
RUBICON_ACTION(PlanAction, PlanState, measured_column_number) {
  st.law->columns.push_back(token_string(st, begin));
  st.law->by_number = true;
}
RUBICON_ACTION(PlanAction, PlanState, measured_law) {
  st.law->span = st.span_from(begin);
  st.duration = {};
  st.duration.span = st.law->span;
}
RUBICON_ACTION(PlanAction, PlanState, certain_duration) {
  st.law.reset();
  st.duration = st.take_quantity();
}
RUBICON_ACTION(PlanAction, PlanState, duration) {
  st.crew_of_work.reset();
  st.turned.reset();
}
RUBICON_ACTION(PlanAction, PlanState, link_name) {
  st.links.push_back({st.take_qualified_name(), {}, {}, st.span_from(begin)});
}
RUBICON_ACTION(PlanAction, PlanState, link_type) { st.links.back().type = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, later) { st.lag_is_negative = false; }
RUBICON_ACTION(PlanAction, PlanState, earlier) { st.lag_is_negative = true; }
RUBICON_ACTION(PlanAction, PlanState, lag_term) {
  if (st.lag_is_negative) st.apply_sign(syntax::Expression::Kind::negate, begin, 0);
}
RUBICON_ACTION(PlanAction, PlanState, link_lag) { st.links.back().lag = st.take_quantity(); }
RUBICON_ACTION(PlanAction, PlanState, link) { st.links.back().span = st.span_from(begin); }
RUBICON_ACTION(PlanAction, PlanState, after_key) { st.links.clear(); }
RUBICON_ACTION(PlanAction, PlanState, listed_name) { st.names.push_back(st.take_dotted_name()); }

// what is repeated, and what is there on a condition
RUBICON_ACTION(PlanAction, PlanState, for_key) {
  st.head = {};
  st.head.keyword = st.span_from(begin);
}
RUBICON_ACTION(PlanAction, PlanState, for_variable) { st.head.variable = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, for_first) { st.head.first = st.take_quantity(); }
RUBICON_ACTION(PlanAction, PlanState, for_last) { st.head.last = st.take_quantity(); }
RUBICON_ACTION(PlanAction, PlanState, for_head) { st.open_block("for"); }
RUBICON_ACTION(PlanAction, PlanState, given_key) {
  st.head = {};
  st.head.keyword = st.span_from(begin);
}
RUBICON_ACTION(PlanAction, PlanState, given_condition) { st.head.condition = st.take_expression(); }
RUBICON_ACTION(PlanAction, PlanState, given_head) { st.open_block("when"); }
RUBICON_ACTION(PlanAction, PlanState, task_block) { st.close_task_block(begin); }
RUBICON_ACTION(PlanAction, PlanState, module_block) { st.close_module_block(begin); }
RUBICON_ACTION(PlanAction, PlanState, network_block) { st.close_network_block(begin); }
RUBICON_ACTION(PlanAction, PlanState, plan_block) { st.close_plan_block(begin); }

// parameters
RUBICON_ACTION(PlanAction, PlanState, parameter_name) {
  st.parameter = {};
  st.parameter.name = st.take_name();
}
RUBICON_ACTION(PlanAction, PlanState, parameter_text) { st.parameter.text = st.string; }
RUBICON_ACTION(PlanAction, PlanState, parameter_value) {
  st.parameter.value = st.take_expression();
}
RUBICON_ACTION(PlanAction, PlanState, parameter_item) { st.add(std::move(st.parameter), begin); }

// settings
RUBICON_ACTION(PlanAction, PlanState, site_item) {
  st.add(syntax::SiteItem{st.take_shape(), {}}, begin);
}
RUBICON_ACTION(PlanAction, PlanState, storage_name) { st.storage = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, storage_item) {
  st.add(syntax::StorageItem{std::move(st.storage), st.take_shape(), {}}, begin);
}
RUBICON_ACTION(PlanAction, PlanState, number_key) { st.key = st.word(begin); }
RUBICON_ACTION(PlanAction, PlanState, task_number_key) { st.key = st.word(begin); }
RUBICON_ACTION(PlanAction, PlanState, number_value) { st.quantity = st.take_quantity(); }
RUBICON_ACTION(PlanAction, PlanState, number_item) {
  st.add(syntax::NumberItem{st.key, st.quantity, {}}, begin);
}
RUBICON_ACTION(PlanAction, PlanState, task_number_item) {
  st.add_to_task(syntax::NumberItem{st.key, st.quantity, {}}, begin);
}
RUBICON_ACTION(PlanAction, PlanState, text_key) { st.key = st.word(begin); }
RUBICON_ACTION(PlanAction, PlanState, text_item) {
  st.add(syntax::StringItem{st.key, st.string, {}}, begin);
}
RUBICON_ACTION(PlanAction, PlanState, situation_key) { st.names.clear(); }
RUBICON_ACTION(PlanAction, PlanState, situation_item) {
  st.add_to_task(syntax::SituationItem{std::move(st.names), {}}, begin);
}
RUBICON_ACTION(PlanAction, PlanState, whole_key) { st.whole = {}; }
RUBICON_ACTION(PlanAction, PlanState, whole_value) { st.whole.value = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, whole_item) { st.add_to_task(std::move(st.whole), begin); }
RUBICON_ACTION(PlanAction, PlanState, within_key) {
  st.within = {};
  st.values = {};
}
RUBICON_ACTION(PlanAction, PlanState, support_key) { st.support = {}; }
RUBICON_ACTION(PlanAction, PlanState, support_gap) { st.support.gap = st.take_quantity(); }
RUBICON_ACTION(PlanAction, PlanState, support_mode) { st.support.mode = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, support_item) { st.add(std::move(st.support), begin); }
RUBICON_ACTION(PlanAction, PlanState, within_length) { st.within.length = st.take_quantity(); }
RUBICON_ACTION(PlanAction, PlanState, within_values) { st.within.values = st.take_values(); }
RUBICON_ACTION(PlanAction, PlanState, within_item) { st.add_to_task(std::move(st.within), begin); }

// calendars
RUBICON_ACTION(PlanAction, PlanState, calendar_key) {
  st.calendar = {};
  st.announce("calendar");
}
RUBICON_ACTION(PlanAction, PlanState, calendar_name) { st.calendar.name = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, first_day) {
  st.shift = {};
  st.shift.first_day = st.take_name();
}
RUBICON_ACTION(PlanAction, PlanState, last_day) { st.shift.last_day = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, shift_from) { st.shift_from = token_string(st, begin); }
RUBICON_ACTION(PlanAction, PlanState, shift_to) {
  st.shift.times.emplace_back(st.shift_from, token_string(st, begin));
}
RUBICON_ACTION(PlanAction, PlanState, off_key) { st.shift = {}; }
RUBICON_ACTION(PlanAction, PlanState, off_date) { st.shift.off.push_back(token_string(st, begin)); }
RUBICON_ACTION(PlanAction, PlanState, off_quoted_date) { st.shift.off.push_back(st.string); }
RUBICON_ACTION(PlanAction, PlanState, lost_key) { st.shift = {}; }
RUBICON_ACTION(PlanAction, PlanState, lost_first_month) { st.shift.first_month = st.word(begin); }
RUBICON_ACTION(PlanAction, PlanState, lost_last_month) { st.shift.last_month = st.word(begin); }
RUBICON_ACTION(PlanAction, PlanState, lost_share) { st.shift.lost = st.take_quantity(); }
RUBICON_ACTION(PlanAction, PlanState, carry_over_key) {
  st.shift = {};
  st.shift.carry_over = true;
}
RUBICON_ACTION(PlanAction, PlanState, shift) {
  st.shift.span = st.span_from(begin);
  st.calendar.shifts.push_back(std::move(st.shift));
}
RUBICON_ACTION(PlanAction, PlanState, calendar_item) { st.add(std::move(st.calendar), begin); }

// attributes
RUBICON_ACTION(PlanAction, PlanState, component_attribute_key) { st.key = st.word(begin); }
RUBICON_ACTION(PlanAction, PlanState, task_attribute_key) { st.key = st.word(begin); }
RUBICON_ACTION(PlanAction, PlanState, free_attribute_name) { st.key = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, component_attribute) { st.add_attribute(begin); }
RUBICON_ACTION(PlanAction, PlanState, task_attribute) { st.add_attribute(begin); }
RUBICON_ACTION(PlanAction, PlanState, free_attribute) { st.add_attribute(begin); }

RUBICON_ACTION(PlanAction, PlanState, group_key) { st.key = st.word(begin); }
RUBICON_ACTION(PlanAction, PlanState, group_heading) { st.add_heading(); }
RUBICON_ACTION(PlanAction, PlanState, group_item) {
  st.string = std::exchange(st.headings, {});
  st.add_attribute(begin);
}

// components, robots, crews
RUBICON_ACTION(PlanAction, PlanState, component_key) {
  st.component = {};
  st.announce("component");
}
RUBICON_ACTION(PlanAction, PlanState, component_name) { st.component.name = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, component_shape) {
  st.component.shapes.push_back(st.take_shape());
}
RUBICON_ACTION(PlanAction, PlanState, component_at_frame) {
  st.component.at.push_back(st.take_frame());
}
RUBICON_ACTION(PlanAction, PlanState, component_grip_frame) {
  st.component.grip.push_back(st.take_frame());
}
RUBICON_ACTION(PlanAction, PlanState, mass_value) {
  st.component.mass.push_back(st.take_quantity());
}
RUBICON_ACTION(PlanAction, PlanState, density_value) {
  st.component.density.push_back(st.take_quantity());
}
RUBICON_ACTION(PlanAction, PlanState, material_amount) {
  st.component.cost.push_back(st.take_quantity());
}
RUBICON_ACTION(PlanAction, PlanState, fixed_thing) {
  st.component.fixed_to.push_back({st.take_qualified_name(), {}});
}
RUBICON_ACTION(PlanAction, PlanState, fixed_after) {
  st.component.fixed_to.back().after = st.take_qualified_name();
}
RUBICON_ACTION(PlanAction, PlanState, brace) {
  st.component.braced_by.push_back(st.take_qualified_name());
}
RUBICON_ACTION(PlanAction, PlanState, component_people) { st.component.people = true; }
RUBICON_ACTION(PlanAction, PlanState, component_item) {
  st.add_to_module(std::move(st.component), begin);
}
RUBICON_ACTION(PlanAction, PlanState, moving_key) {
  st.moving = {};
  st.announce("moving");
}
RUBICON_ACTION(PlanAction, PlanState, moving_name) { st.moving.name = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, moving_shape) { st.moving.shapes.push_back(st.take_shape()); }
RUBICON_ACTION(PlanAction, PlanState, path_key) { st.path.clear(); }
RUBICON_ACTION(PlanAction, PlanState, path_time) { st.path_time = st.take_quantity(); }
RUBICON_ACTION(PlanAction, PlanState, path_frame) {
  st.path.push_back({std::move(st.path_time), st.take_frame()});
}
RUBICON_ACTION(PlanAction, PlanState, moving_path) { st.moving.paths.push_back(st.path); }
RUBICON_ACTION(PlanAction, PlanState, moving_repeat) { st.moving.repeat = true; }
RUBICON_ACTION(PlanAction, PlanState, moving_people) { st.moving.people = true; }
RUBICON_ACTION(PlanAction, PlanState, moving_item) { st.add(std::move(st.moving), begin); }

// a floor, and work over all of it
RUBICON_ACTION(PlanAction, PlanState, place_x) { st.place_x = st.take_quantity(); }
RUBICON_ACTION(PlanAction, PlanState, place_y) {
  st.places.push_back({std::move(st.place_x), st.take_quantity()});
}
RUBICON_ACTION(PlanAction, PlanState, area_key) {
  st.area = {};
  st.announce("area");
}
RUBICON_ACTION(PlanAction, PlanState, area_name) { st.area.name = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, area_height_value) {
  st.area.height.push_back(st.take_quantity());
}
RUBICON_ACTION(PlanAction, PlanState, area_at_frame) { st.area.at.push_back(st.take_frame()); }
RUBICON_ACTION(PlanAction, PlanState, area_line_key) { st.begin_area_part(begin); }
RUBICON_ACTION(PlanAction, PlanState, area_line) { st.add_area_part(begin); }
RUBICON_ACTION(PlanAction, PlanState, area_column_key) { st.begin_area_part(begin); }
RUBICON_ACTION(PlanAction, PlanState, area_column_size) { st.area_part.size = st.take_quantity(); }
RUBICON_ACTION(PlanAction, PlanState, area_column) { st.add_area_part(begin); }
RUBICON_ACTION(PlanAction, PlanState, area_obstacles_key) { st.begin_area_part(begin); }
RUBICON_ACTION(PlanAction, PlanState, area_obstacles) { st.add_area_part(begin); }
RUBICON_ACTION(PlanAction, PlanState, area_item) { st.add(std::move(st.area), begin); }
RUBICON_ACTION(PlanAction, PlanState, cover_key) {
  st.cover = {};
  st.announce("cover");
}
RUBICON_ACTION(PlanAction, PlanState, cover_area) { st.cover.area = st.take_dotted_name(); }
RUBICON_ACTION(PlanAction, PlanState, cover_number_key) { st.begin_cover_clause(begin); }
RUBICON_ACTION(PlanAction, PlanState, cover_number_value) {
  st.cover_clause.number = st.take_quantity();
}
RUBICON_ACTION(PlanAction, PlanState, cover_number) { st.add_cover_clause(); }
RUBICON_ACTION(PlanAction, PlanState, cover_place_key) { st.begin_cover_clause(begin); }
RUBICON_ACTION(PlanAction, PlanState, cover_place) {
  st.cover_clause.place = std::move(st.places.back());
  st.add_cover_clause();
}
RUBICON_ACTION(PlanAction, PlanState, cover_word_key) { st.begin_cover_clause(begin); }
RUBICON_ACTION(PlanAction, PlanState, cover_word_value) { st.cover_clause.word = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, cover_word) { st.add_cover_clause(); }
RUBICON_ACTION(PlanAction, PlanState, cover_holes_key) { st.begin_cover_clause(begin); }
RUBICON_ACTION(PlanAction, PlanState, cover_holes_x) {
  st.cover_clause.number = st.take_quantity();
}
RUBICON_ACTION(PlanAction, PlanState, cover_holes_y) {
  st.cover_clause.second = st.take_quantity();
}
RUBICON_ACTION(PlanAction, PlanState, cover_holes) { st.add_cover_clause(); }
RUBICON_ACTION(PlanAction, PlanState, cover_joint_key) { st.begin_cover_clause(begin); }
RUBICON_ACTION(PlanAction, PlanState, cover_joint_limit) {
  st.cover_clause.number = st.take_quantity();
}
RUBICON_ACTION(PlanAction, PlanState, cover_joint) { st.add_cover_clause(); }
RUBICON_ACTION(PlanAction, PlanState, cover_guide_key) { st.begin_cover_clause(begin); }
RUBICON_ACTION(PlanAction, PlanState, cover_guide_name) {
  st.cover_clause.guides.push_back(st.take_name());
}
RUBICON_ACTION(PlanAction, PlanState, cover_guide) { st.add_cover_clause(); }
RUBICON_ACTION(PlanAction, PlanState, cover_item) { st.add_to_task(std::move(st.cover), begin); }
RUBICON_ACTION(PlanAction, PlanState, start_key) { st.values = {}; }
RUBICON_ACTION(PlanAction, PlanState, park_key) { st.values = {}; }
RUBICON_ACTION(PlanAction, PlanState, cost_item) { st.set_cost(begin); }
RUBICON_ACTION(PlanAction, PlanState, computed_charge) { st.number = st.take_quantity(); }
RUBICON_ACTION(PlanAction, PlanState, per_day_amount) { st.per_day = std::move(st.number); }
RUBICON_ACTION(PlanAction, PlanState, rental_key) { st.rental = {}; }
RUBICON_ACTION(PlanAction, PlanState, rental_from) { st.rental.from = st.string; }
RUBICON_ACTION(PlanAction, PlanState, rental_to) { st.rental.to = st.string; }
RUBICON_ACTION(PlanAction, PlanState, rental_item) {
  st.rental.amount = st.per_day;
  st.rental.span = st.span_from(begin);
  st.charges().rental.push_back(std::move(st.rental));
}
RUBICON_ACTION(PlanAction, PlanState, mobilisation_amount) {
  st.charges().mobilisation.push_back(st.take_quantity());
}
RUBICON_ACTION(PlanAction, PlanState, overtime_factor) {
  st.overtime = {};
  st.overtime.factor = std::move(st.number);
}
RUBICON_ACTION(PlanAction, PlanState, outside_calendar) {
  st.overtime.outside = st.take_dotted_name();
}
RUBICON_ACTION(PlanAction, PlanState, overtime_item) {
  st.overtime.span = st.span_from(begin);
  st.charges().overtime.push_back(std::move(st.overtime));
}
RUBICON_ACTION(PlanAction, PlanState, fuel_working) {
  st.fuel = {};
  st.fuel.working = st.take_quantity();
}
RUBICON_ACTION(PlanAction, PlanState, fuel_idling) { st.fuel.idling = st.take_quantity(); }
RUBICON_ACTION(PlanAction, PlanState, fuel_price) { st.fuel.price = st.take_quantity(); }
RUBICON_ACTION(PlanAction, PlanState, fuel_item) {
  st.fuel.span = st.span_from(begin);
  st.charges().fuel.push_back(std::move(st.fuel));
}
RUBICON_ACTION(PlanAction, PlanState, overhead_item) {
  st.add(syntax::OverheadItem{st.per_day, {}}, begin);
}
RUBICON_ACTION(PlanAction, PlanState, used_calendar) {
  (st.in_crew ? st.crew.calendar : st.robot.calendar).push_back(st.take_dotted_name());
}
RUBICON_ACTION(PlanAction, PlanState, breakdown_between) {
  st.breakdown = {};
  st.breakdown.every = st.duration;
  st.breakdown.every_law = st.law;
}
RUBICON_ACTION(PlanAction, PlanState, breakdown_repair) {
  st.breakdown.takes = st.duration;
  st.breakdown.takes_law = st.law;
}
RUBICON_ACTION(PlanAction, PlanState, breakdown_item) {
  st.breakdown.span = st.span_from(begin);
  st.robot.breakdowns.push_back(std::move(st.breakdown));
}
RUBICON_ACTION(PlanAction, PlanState, robot_use_key) {
  st.robot = {};
  st.in_crew = false;
  st.announce("robot");
}
RUBICON_ACTION(PlanAction, PlanState, robot_use_name) { st.robot.name = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, robot_file_name) { st.robot.file = st.string; }
RUBICON_ACTION(PlanAction, PlanState, robot_behaviour_file) {
  st.robot.behaviour.push_back(st.string);
}
RUBICON_ACTION(PlanAction, PlanState, robot_frame) { st.robot.at = st.take_frame(); }
RUBICON_ACTION(PlanAction, PlanState, robot_start_values) {
  st.robot.start.push_back(st.take_values());
}
RUBICON_ACTION(PlanAction, PlanState, park_values) { st.robot.park.push_back(st.take_values()); }
RUBICON_ACTION(PlanAction, PlanState, robot_use) { st.add(std::move(st.robot), begin); }
RUBICON_ACTION(PlanAction, PlanState, crew_key) {
  st.crew = {};
  st.in_crew = true;
  st.announce("crew");
}
RUBICON_ACTION(PlanAction, PlanState, crew_name) { st.crew.name = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, size_value) { st.crew.size.push_back(st.take_quantity()); }
RUBICON_ACTION(PlanAction, PlanState, cost_amount) { st.quantity = st.take_quantity(); }
RUBICON_ACTION(PlanAction, PlanState, cost_per_hour) { st.divide_by_hour(begin); }
RUBICON_ACTION(PlanAction, PlanState, crew_item) { st.add(std::move(st.crew), begin); }

RUBICON_ACTION(PlanAction, PlanState, workspaces_key) {
  st.workspaces = {};
  st.workspaces.keyword = st.span_from(begin);
  st.announce("workspaces");
}
RUBICON_ACTION(PlanAction, PlanState, workspaces_machine) {
  st.workspaces.of.push_back(st.take_dotted_name());
}
RUBICON_ACTION(PlanAction, PlanState, workspaces_number_key) { st.key = st.word(begin); }
RUBICON_ACTION(PlanAction, PlanState, workspaces_number) {
  st.workspaces.numbers.push_back({st.key, st.take_quantity(), st.span_from(begin)});
}
RUBICON_ACTION(PlanAction, PlanState, workspaces_watch_key) {
  st.workspaces.watch.push_back(st.span_from(begin));
}
RUBICON_ACTION(PlanAction, PlanState, workspaces_item) { st.add(std::move(st.workspaces), begin); }
RUBICON_ACTION(PlanAction, PlanState, pool_key) {
  st.pool = {};
  st.announce("pool");
}
RUBICON_ACTION(PlanAction, PlanState, pool_name) { st.pool.name = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, of_key) { st.names.clear(); }
RUBICON_ACTION(PlanAction, PlanState, pool_members) {
  st.pool.of.insert(st.pool.of.end(), st.names.begin(), st.names.end());
}
RUBICON_ACTION(PlanAction, PlanState, choice_rule) { st.pool.choose.push_back(st.word(begin)); }
RUBICON_ACTION(PlanAction, PlanState, pool_item) { st.add(std::move(st.pool), begin); }

// networks and fleets
RUBICON_ACTION(PlanAction, PlanState, network_key) {
  st.network = {};
  st.grid = {};
  st.in_network = true;
  st.announce("network");
}
RUBICON_ACTION(PlanAction, PlanState, network_name) { st.network.name = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, policy_name) {
  st.policy = {};
  st.policy.name = st.take_name();
  st.announce("policy");
}
RUBICON_ACTION(PlanAction, PlanState, policy_number_key) { st.key = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, policy_number) {
  st.policy.numbers.push_back({st.key, st.take_quantity(), st.span_from(begin)});
  if (st.policy.name.text == "grid")
    st.add_to_grid(begin).numbers.push_back(st.policy.numbers.back());
}
RUBICON_ACTION(PlanAction, PlanState, minimise_what) {
  st.policy.minimise.push_back(st.take_name());
}
RUBICON_ACTION(PlanAction, PlanState, network_policy) {
  st.grid.policies.push_back(st.policy.name);
  st.add_to_network(std::move(st.policy), begin);
}
RUBICON_ACTION(PlanAction, PlanState, grid_file_key) { st.key = st.word(begin); }
RUBICON_ACTION(PlanAction, PlanState, grid_file) {
  st.add_to_grid(begin).files.push_back({st.key, st.string});
}
RUBICON_ACTION(PlanAction, PlanState, grid_count_key) { st.key = st.word(begin); }
RUBICON_ACTION(PlanAction, PlanState, grid_count) {
  syntax::GridItem& grid = st.add_to_grid(begin);
  (st.key.text == "jobs" ? grid.jobs : grid.agents).push_back(st.take_quantity());
}
RUBICON_ACTION(PlanAction, PlanState, grid_job_key) {
  st.places.clear();
  st.grid_job = {};
}
RUBICON_ACTION(PlanAction, PlanState, grid_job_name) { st.grid_job.name = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, grid_job_arrives) {
  st.grid_job.arrives.push_back(st.take_quantity());
}
RUBICON_ACTION(PlanAction, PlanState, grid_job) {
  st.grid_job.span = st.span_from(begin);
  if (st.places.size() == 2) {
    st.grid_job.from = st.places[0];
    st.grid_job.to = st.places[1];
    st.add_to_grid(begin).named_jobs.push_back(st.grid_job);
  }
  st.places.clear();
}
RUBICON_ACTION(PlanAction, PlanState, grid_agent_key) { st.places.clear(); }
RUBICON_ACTION(PlanAction, PlanState, grid_agent_name) { st.grid_agent.name = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, grid_agent) {
  st.grid_agent.span = st.span_from(begin);
  if (st.places.size() == 2) {
    st.grid_agent.from = st.places[0];
    st.grid_agent.to = st.places[1];
    st.add_to_grid(begin).named.push_back(st.grid_agent);
  }
  st.places.clear();
}
RUBICON_ACTION(PlanAction, PlanState, class_key) {
  st.lane_class = {};
  st.announce("class");
}
RUBICON_ACTION(PlanAction, PlanState, class_name) { st.lane_class.name = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, class_speed_value) {
  st.lane_class.speed.push_back(st.take_quantity());
}
RUBICON_ACTION(PlanAction, PlanState, class_width_value) {
  st.lane_class.width.push_back(st.take_quantity());
}
RUBICON_ACTION(PlanAction, PlanState, class_cost_value) {
  st.lane_class.cost.push_back(st.take_quantity());
}
RUBICON_ACTION(PlanAction, PlanState, lane_class) {
  st.add_to_network(std::move(st.lane_class), begin);
}
RUBICON_ACTION(PlanAction, PlanState, node_name) { st.node.name = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, node_frame) { st.node.at = st.take_frame(); }
RUBICON_ACTION(PlanAction, PlanState, network_node) {
  st.add_to_network(std::move(st.node), begin);
}
RUBICON_ACTION(PlanAction, PlanState, lane_key) { st.lane = {}; }
RUBICON_ACTION(PlanAction, PlanState, lane_from) { st.lane.from = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, lane_end) { st.lane.to = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, lane_both) { st.lane.both.push_back(st.word(begin)); }
RUBICON_ACTION(PlanAction, PlanState, beside_from) {
  st.lane.beside.push_back({st.take_name(), {}});
}
RUBICON_ACTION(PlanAction, PlanState, beside_end) { st.lane.beside.back().second = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, lane_length_value) {
  st.lane.length.push_back(st.take_quantity());
}
RUBICON_ACTION(PlanAction, PlanState, lane_class_name) {
  st.lane.lane_class.push_back(st.take_name());
}
RUBICON_ACTION(PlanAction, PlanState, network_lane) {
  st.add_to_network(std::move(st.lane), begin);
}
RUBICON_ACTION(PlanAction, PlanState, errand_key) {
  st.errand = {};
  st.announce("errand");
}
RUBICON_ACTION(PlanAction, PlanState, errand_name) { st.errand.name = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, errand_from) { st.errand.from = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, errand_to) { st.errand.to = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, errand_start) { st.errand.start = st.take_quantity(); }
RUBICON_ACTION(PlanAction, PlanState, errand_number_key) { st.key = st.word(begin); }
RUBICON_ACTION(PlanAction, PlanState, errand_number) {
  st.errand.numbers.push_back({st.key, st.take_quantity(), st.span_from(begin)});
}
RUBICON_ACTION(PlanAction, PlanState, network_errand) {
  st.add_to_network(std::move(st.errand), begin);
}
RUBICON_ACTION(PlanAction, PlanState, report_key) { st.lane_report = {}; }
RUBICON_ACTION(PlanAction, PlanState, report_from) { st.lane_report.from = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, report_to) { st.lane_report.to = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, report_word) { st.lane_report.what = st.word(begin); }
RUBICON_ACTION(PlanAction, PlanState, report_obstacle_word) {
  st.lane_report.what = st.word(begin);
}
RUBICON_ACTION(PlanAction, PlanState, report_edge) {
  st.lane_report.edges.push_back(st.take_quantity());
}
RUBICON_ACTION(PlanAction, PlanState, report_time) { st.lane_report.time = st.take_quantity(); }
RUBICON_ACTION(PlanAction, PlanState, report_robot) { st.lane_report.by = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, network_report) {
  st.add_to_network(std::move(st.lane_report), begin);
}
RUBICON_ACTION(PlanAction, PlanState, barrier_key) { st.barrier = {}; }
RUBICON_ACTION(PlanAction, PlanState, barrier_from) { st.barrier.from = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, barrier_to) { st.barrier.to = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, barrier_since) { st.barrier.since = st.take_quantity(); }
RUBICON_ACTION(PlanAction, PlanState, barrier_until) { st.barrier.until = st.take_quantity(); }
RUBICON_ACTION(PlanAction, PlanState, network_barrier) {
  st.add_to_network(std::move(st.barrier), begin);
}
RUBICON_ACTION(PlanAction, PlanState, explore_key) {
  st.errand = {};
  st.announce("explore");
}
RUBICON_ACTION(PlanAction, PlanState, explore_name) { st.errand.name = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, explore_from) { st.errand.from = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, network_explore) {
  st.add_to_network(
      syntax::ExploreItem{
          std::move(st.errand.name), std::move(st.errand.from), std::move(st.errand.numbers), {}},
      begin);
}
RUBICON_ACTION(PlanAction, PlanState, network_item) {
  st.in_network = false;
  st.grid.network = st.network.name;
  st.grids.push_back(std::move(st.grid));
  st.add(std::move(st.network), begin);
}
RUBICON_ACTION(PlanAction, PlanState, fleet_key) {
  st.fleet = {};
  st.robot = {};
  st.in_crew = false;
  st.announce("fleet");
}
RUBICON_ACTION(PlanAction, PlanState, fleet_name) { st.fleet.name = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, fleet_file) { st.fleet.file.push_back(st.string); }
RUBICON_ACTION(PlanAction, PlanState, fleet_size_value) {
  st.fleet.size.push_back(st.take_quantity());
}
RUBICON_ACTION(PlanAction, PlanState, fleet_network) { st.fleet.on.push_back(st.take_name()); }
RUBICON_ACTION(PlanAction, PlanState, fleet_place) { st.fleet.at.push_back(st.take_name()); }
RUBICON_ACTION(PlanAction, PlanState, fleet_rule) { st.fleet.choose.push_back(st.word(begin)); }
RUBICON_ACTION(PlanAction, PlanState, fleet_item) {
  st.fleet.member = std::move(st.robot);
  st.add(std::move(st.fleet), begin);
}

// tasks
RUBICON_ACTION(PlanAction, PlanState, task_key) {
  st.task = {};
  st.in_task = true;
  st.announce("task");
}
RUBICON_ACTION(PlanAction, PlanState, task_name) { st.task.name = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, task_item) {
  st.in_task = false;
  st.add_to_module(std::move(st.task), begin);
}
RUBICON_ACTION(PlanAction, PlanState, by_key) {
  st.names.clear();
  st.by = {};
}
RUBICON_ACTION(PlanAction, PlanState, same_as_task) {
  st.by.same_as.push_back(st.take_qualified_name());
}
RUBICON_ACTION(PlanAction, PlanState, all_of_pool) {
  st.by.all_of.push_back(st.take_dotted_name());
}
RUBICON_ACTION(PlanAction, PlanState, by_item) {
  st.by.names = std::move(st.names);
  st.add_to_task(std::move(st.by), begin);
}
RUBICON_ACTION(PlanAction, PlanState, needs_key) { st.needs = {}; }
RUBICON_ACTION(PlanAction, PlanState, needed_units) {
  st.needs.needs.push_back({st.take_plain_number(begin), {}});
}
RUBICON_ACTION(PlanAction, PlanState, needed_crew) {
  st.needs.needs.back().crew = st.take_dotted_name();
}
RUBICON_ACTION(PlanAction, PlanState, needs_item) { st.add_to_task(std::move(st.needs), begin); }
RUBICON_ACTION(PlanAction, PlanState, moved_component) {
  st.component_name = st.take_qualified_name();
}
RUBICON_ACTION(PlanAction, PlanState, move_item) {
  st.add_to_task(syntax::MoveItem{std::move(st.component_name), st.take_frame(), {}}, begin);
}
RUBICON_ACTION(PlanAction, PlanState, go_key) { st.values = {}; }
RUBICON_ACTION(PlanAction, PlanState, go_item) {
  st.add_to_task(syntax::GoItem{std::move(st.goal), {}}, begin);
}
RUBICON_ACTION(PlanAction, PlanState, removed_component) {
  st.component_name = st.take_qualified_name();
}
RUBICON_ACTION(PlanAction, PlanState, remove_item) {
  st.add_to_task(syntax::RemoveItem{std::move(st.component_name), {}}, begin);
}
RUBICON_ACTION(PlanAction, PlanState, crew_work_key) { st.key = st.word(begin); }
RUBICON_ACTION(PlanAction, PlanState, takes_key) { st.key = st.word(begin); }
RUBICON_ACTION(PlanAction, PlanState, work_crew) { st.crew_of_work = st.take_dotted_name(); }
RUBICON_ACTION(PlanAction, PlanState, turned_parameter) { st.turned = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, crew_work_item) {
  st.add_to_task(syntax::WorkItem{st.key, st.duration, st.crew_of_work, st.turned, {}, st.law},
                 begin);
}
RUBICON_ACTION(PlanAction, PlanState, takes_item) {
  st.add_to_task(syntax::WorkItem{st.key, st.duration, {}, {}, {}, st.law}, begin);
}

// soil
RUBICON_ACTION(PlanAction, PlanState, earth_key) {
  st.earth = {};
  st.announce("earth");
}
RUBICON_ACTION(PlanAction, PlanState, earth_name) { st.earth.name = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, earth_grid_key) { st.begin_earth_clause(begin); }
RUBICON_ACTION(PlanAction, PlanState, earth_columns) {
  st.earth_clause.numbers.push_back(st.take_quantity());
}
RUBICON_ACTION(PlanAction, PlanState, earth_rows) {
  st.earth_clause.numbers.push_back(st.take_quantity());
}
RUBICON_ACTION(PlanAction, PlanState, earth_grid) { st.add_earth_clause(); }
RUBICON_ACTION(PlanAction, PlanState, earth_height_key) { st.begin_earth_clause(begin); }
RUBICON_ACTION(PlanAction, PlanState, earth_file) { st.earth_clause.file = st.string; }
RUBICON_ACTION(PlanAction, PlanState, earth_height_value) {
  st.earth_clause.numbers.push_back(st.take_quantity());
}
RUBICON_ACTION(PlanAction, PlanState, earth_height) { st.add_earth_clause(); }
RUBICON_ACTION(PlanAction, PlanState, earth_number_key) { st.begin_earth_clause(begin); }
RUBICON_ACTION(PlanAction, PlanState, earth_number_value) {
  st.earth_clause.numbers.push_back(st.take_quantity());
}
RUBICON_ACTION(PlanAction, PlanState, earth_number) { st.add_earth_clause(); }
RUBICON_ACTION(PlanAction, PlanState, earth_at_frame) {
  st.begin_earth_clause(begin);
  st.earth_clause.at = st.take_frame();
}
RUBICON_ACTION(PlanAction, PlanState, earth_at) { st.add_earth_clause(); }
RUBICON_ACTION(PlanAction, PlanState, earth_item) { st.add(std::move(st.earth), begin); }
RUBICON_ACTION(PlanAction, PlanState, dig_key) {
  st.dig = {};
  st.announce("dig");
}
RUBICON_ACTION(PlanAction, PlanState, dig_earth) { st.dig.earth = st.word(begin); }
RUBICON_ACTION(PlanAction, PlanState, dig_shape) { st.dig.shape = st.take_shape(); }
RUBICON_ACTION(PlanAction, PlanState, dig_volume) { st.dig.volume = st.take_quantity(); }
RUBICON_ACTION(PlanAction, PlanState, dig_number_key) { st.begin_dig_clause(begin); }
RUBICON_ACTION(PlanAction, PlanState, dig_number_value) {
  st.dig_clause.number = st.take_quantity();
}
RUBICON_ACTION(PlanAction, PlanState, dig_number) { st.add_dig_clause(); }
RUBICON_ACTION(PlanAction, PlanState, dig_load_key) {
  st.begin_dig_clause(begin);
  st.duration = {};
  st.law.reset();
}
RUBICON_ACTION(PlanAction, PlanState, dig_trucks) { st.dig_clause.trucks = st.take_dotted_name(); }
RUBICON_ACTION(PlanAction, PlanState, dig_load_takes) { st.dig_clause.is_timed = true; }
RUBICON_ACTION(PlanAction, PlanState, dig_load) {
  if (st.dig_clause.is_timed) st.take_dig_duration();
  st.add_dig_clause();
}
RUBICON_ACTION(PlanAction, PlanState, dig_attitude_key) { st.begin_dig_clause(begin); }
RUBICON_ACTION(PlanAction, PlanState, dig_attitude_frame) { st.dig_clause.frame = st.take_frame(); }
RUBICON_ACTION(PlanAction, PlanState, dig_attitude) { st.add_dig_clause(); }
RUBICON_ACTION(PlanAction, PlanState, dig_dump_key) { st.begin_dig_clause(begin); }
RUBICON_ACTION(PlanAction, PlanState, dig_dump_frame) { st.dig_clause.frame = st.take_frame(); }
RUBICON_ACTION(PlanAction, PlanState, dig_dump) { st.add_dig_clause(); }
RUBICON_ACTION(PlanAction, PlanState, dig_place_key) { st.begin_dig_clause(begin); }
RUBICON_ACTION(PlanAction, PlanState, dig_place_frame) {
  st.dig_clause.places.push_back(st.take_frame());
}
RUBICON_ACTION(PlanAction, PlanState, dig_place) { st.add_dig_clause(); }
RUBICON_ACTION(PlanAction, PlanState, dig_stage_key) {
  st.begin_dig_clause(begin);
  st.dig_clause.is_stage = true;
}
RUBICON_ACTION(PlanAction, PlanState, dig_server) { st.dig_clause.by = st.take_dotted_name(); }
RUBICON_ACTION(PlanAction, PlanState, dig_stage) {
  st.take_dig_duration();
  st.add_dig_clause();
}
RUBICON_ACTION(PlanAction, PlanState, dig_item) { st.add_to_task(std::move(st.dig), begin); }
RUBICON_ACTION(PlanAction, PlanState, haul_key) {
  st.haul = {};
  st.announce("haul");
}
RUBICON_ACTION(PlanAction, PlanState, haul_dig) {
  st.haul.digs.push_back(st.take_qualified_name());
}
RUBICON_ACTION(PlanAction, PlanState, haul_number_key) { st.begin_haul_clause(begin); }
RUBICON_ACTION(PlanAction, PlanState, haul_number_value) {
  st.haul_clause.number = st.take_quantity();
}
RUBICON_ACTION(PlanAction, PlanState, haul_number) { st.add_haul_clause(); }
RUBICON_ACTION(PlanAction, PlanState, haul_place_key) { st.begin_haul_clause(begin); }
RUBICON_ACTION(PlanAction, PlanState, haul_place_frame) {
  st.haul_clause.places.push_back(st.take_frame());
}
RUBICON_ACTION(PlanAction, PlanState, haul_place) { st.add_haul_clause(); }
RUBICON_ACTION(PlanAction, PlanState, haul_tip_key) {
  st.begin_haul_clause(begin);
  st.duration = {};
  st.law.reset();
}
RUBICON_ACTION(PlanAction, PlanState, haul_tip) {
  st.haul_clause.duration = st.duration;
  st.haul_clause.law = st.law;
  st.add_haul_clause();
}
RUBICON_ACTION(PlanAction, PlanState, haul_heap_key) { st.begin_haul_clause(begin); }
RUBICON_ACTION(PlanAction, PlanState, haul_heap_earth) { st.haul_clause.earth = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, haul_heap_frame) { st.haul_clause.frame = st.take_frame(); }
RUBICON_ACTION(PlanAction, PlanState, haul_heap) { st.add_haul_clause(); }
RUBICON_ACTION(PlanAction, PlanState, haul_raise_key) {
  st.begin_haul_clause(begin);
  st.values = {};
}
RUBICON_ACTION(PlanAction, PlanState, haul_raise) {
  st.haul_clause.values = std::move(st.values);
  st.add_haul_clause();
}
RUBICON_ACTION(PlanAction, PlanState, haul_item) { st.add_to_task(std::move(st.haul), begin); }
RUBICON_ACTION(PlanAction, PlanState, via_key) { st.values = {}; }
RUBICON_ACTION(PlanAction, PlanState, via_item) {
  st.add_to_task(syntax::ViaItem{std::move(st.goal), {}}, begin);
}
RUBICON_ACTION(PlanAction, PlanState, guide_use) {
  st.add_to_task(syntax::GuideItem{std::move(st.guide_names), {}}, begin);
}
RUBICON_ACTION(PlanAction, PlanState, plan_guide) {
  if (st.guide.kind.text.empty()) {
    st.add(syntax::GuideItem{std::move(st.guide_names), {}}, begin);
  } else {
    st.add(std::move(st.guide), begin);
  }
}
RUBICON_ACTION(PlanAction, PlanState, free_key) { st.begin_clause(begin); }
RUBICON_ACTION(PlanAction, PlanState, free_turn) {
  st.clause_of_motion.turns.push_back(st.take_name());
}
RUBICON_ACTION(PlanAction, PlanState, near_key) {
  st.begin_clause(begin);
  st.values = {};
}
RUBICON_ACTION(PlanAction, PlanState, near_values) {
  st.clause_of_motion.values = st.take_values();
}
RUBICON_ACTION(PlanAction, PlanState, lock_key) { st.begin_clause(begin); }
RUBICON_ACTION(PlanAction, PlanState, locked_parameter) {
  st.clause_of_motion.parameters.push_back(st.take_qualified_name());
}
RUBICON_ACTION(PlanAction, PlanState, deviation_key) { st.begin_clause(begin); }
RUBICON_ACTION(PlanAction, PlanState, deviation_quantity) {
  st.clause_of_motion.numbers.push_back(st.take_quantity());
}
RUBICON_ACTION(PlanAction, PlanState, enter_key) { st.begin_clause(begin); }
RUBICON_ACTION(PlanAction, PlanState, entering_body) { st.clause_of_motion.body = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, entered_component) {
  st.clause_of_motion.component = st.take_qualified_name();
}
RUBICON_ACTION(PlanAction, PlanState, motion_clause) {
  if (st.in_task) {
    st.add_to_task(std::move(st.clause_of_motion), begin);
  } else {
    st.add(std::move(st.clause_of_motion), begin);
  }
}
RUBICON_ACTION(PlanAction, PlanState, date_key) { st.date = {st.word(begin), {}, {}}; }
RUBICON_ACTION(PlanAction, PlanState, baseline_key) { st.date = {st.word(begin), {}, {}}; }
RUBICON_ACTION(PlanAction, PlanState, moment_date) {
  st.date.moments.push_back({st.string, {}, st.span_from(begin)});
}
RUBICON_ACTION(PlanAction, PlanState, moment_after_start) {
  st.date.moments.push_back({{}, st.take_quantity(), st.span_from(begin)});
}
RUBICON_ACTION(PlanAction, PlanState, date_item) { st.add_to_task(std::move(st.date), begin); }
RUBICON_ACTION(PlanAction, PlanState, zone_key) { st.up_to.reset(); }
RUBICON_ACTION(PlanAction, PlanState, up_to_height) { st.up_to = st.take_quantity(); }
RUBICON_ACTION(PlanAction, PlanState, zone_item) {
  st.add_to_task(syntax::ZoneItem{st.take_shape(), std::exchange(st.up_to, {}), {}}, begin);
}
RUBICON_ACTION(PlanAction, PlanState, after_item) {
  st.add_to_task(syntax::AfterItem{std::move(st.links), {}}, begin);
}

// what may overlap at the beginning
RUBICON_ACTION(PlanAction, PlanState, touching_things_key) { st.key = st.word(begin); }
RUBICON_ACTION(PlanAction, PlanState, embedded_key) { st.key = st.word(begin); }
RUBICON_ACTION(PlanAction, PlanState, waived_first) {
  st.component_name = st.take_qualified_name();
}
RUBICON_ACTION(PlanAction, PlanState, waived_second) { st.second_name = st.take_qualified_name(); }
RUBICON_ACTION(PlanAction, PlanState, waiver) {
  st.add_to_module(
      syntax::WaiverItem{
          std::move(st.key), std::move(st.component_name), std::move(st.second_name), {}},
      begin);
}

// modules, imports
RUBICON_ACTION(PlanAction, PlanState, module_key) {
  st.module = {};
  st.in_module = true;
  st.announce("module");
}
RUBICON_ACTION(PlanAction, PlanState, module_name) { st.module.name = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, module_item) {
  st.in_module = false;
  st.add(std::move(st.module), begin);
}
RUBICON_ACTION(PlanAction, PlanState, placed_module) {
  st.links.clear();
  st.place = {};
  st.place.module = st.take_dotted_name();
}
RUBICON_ACTION(PlanAction, PlanState, placed_frame) { st.place.at = st.take_frame(); }
RUBICON_ACTION(PlanAction, PlanState, stock_frame) { st.place.from = st.take_frame(); }
RUBICON_ACTION(PlanAction, PlanState, placed_as) { st.place.as = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, place_item) {
  st.place.after = std::exchange(st.links, {});
  st.add(std::move(st.place), begin);
}
RUBICON_ACTION(PlanAction, PlanState, import_key) {
  st.import = {};
  st.announce("import");
}
RUBICON_ACTION(PlanAction, PlanState, import_file) { st.import.file = st.string; }
RUBICON_ACTION(PlanAction, PlanState, import_name) { st.import.as = st.take_name(); }
RUBICON_ACTION(PlanAction, PlanState, import_item) { st.add_import(begin); }

// the short form, the plan
RUBICON_ACTION(PlanAction, PlanState, short_start) {
  st.add(syntax::StartItem{st.take_values(), {}}, begin);
}
RUBICON_ACTION(PlanAction, PlanState, goal_key) { st.values = {}; }
RUBICON_ACTION(PlanAction, PlanState, short_goal) {
  st.add(syntax::GoalItem{std::move(st.goal), {}}, begin);
}
RUBICON_ACTION(PlanAction, PlanState, carry_item) {
  st.add(syntax::CarryItem{st.take_shape(), {}}, begin);
}
RUBICON_ACTION(PlanAction, PlanState, plan_file_key) { st.announce("plan"); }
RUBICON_ACTION(PlanAction, PlanState, plan_name) { st.plan.name = st.take_name(); }

std::vector<std::string_view> plan_words() {
  return {
      "component",    "robot",    "crew",      "task",      "module",     "place",    "import",
      "site",         "contact",  "budget",    "start_at",  "currency",   "calendar", "situation",
      "storage",      "start",    "goal",      "via",       "carry",      "within",   "shape",
      "at",           "grip",     "mass",      "cost",      "park",       "size",     "by",
      "move",         "go",       "remove",    "hook",      "adjust",     "release",  "takes",
      "guide",        "priority", "zone",      "after",     "off",        "name",     "storey",
      "type",         "guid",     "attribute", "parameter", "for",        "when",     "group",
      "density",      "touching", "pool",      "of",        "choose",     "needs",    "rental",
      "mobilisation", "overtime", "overhead",  "whole",     "not_before", "due",      "baseline",
      "support",      "fixed",    "braced",    "free",      "near",       "lock",     "deviation",
      "enter",        "moving",   "path",      "repeat",    "area",       "outline",  "shaft",
      "cover",        "dig",      "earth",     "haul",      "workspaces", "fuel"};
}

}  // namespace

syntax::Plan parse_plan(const SourceMap& sources, FileId file, Diagnostics& diagnostics) {
  PlanState state(sources, file, diagnostics, "P00", plan_words());
  const bool finished = run_parser<grammar::plan_file, PlanAction>(state);
  state.plan.broken = !finished || state.errors() > 0;
  state.plan.span = state.span_from(state.begin());
  return std::move(state.plan);
}

std::vector<syntax::GridItem> parse_grids(const SourceMap& sources, FileId file) {
  Diagnostics diagnostics;
  PlanState state(sources, file, diagnostics, "P00", plan_words());
  run_parser<grammar::plan_file, PlanAction>(state);
  return std::move(state.grids);
}

}  // namespace rubicon::interpreter
