#include "interpreter/expand/plain_items.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "interpreter/expand/evaluate.hpp"

namespace rubicon::interpreter::expansion {

namespace {

using syntax::Dimension;
using syntax::Expression;
using syntax::UnitKind;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A number as it stands there, its sign before it: nothing to compute.
bool is_literal(const Expression& expression) {
  const bool is_signed =
      expression.kind == Expression::Kind::negate || expression.kind == Expression::Kind::plus;
  const Expression& number = is_signed ? *expression.operands[0] : expression;
  return number.kind == Expression::Kind::number && number.number.unit != UnitKind::compound;
}

}  // namespace

// ---- items
// ------------------------------------------------------------------------------------------

void PlainItems::item(syntax::CalendarItem& value) {
  name(value.name);
  for (syntax::Shift& shift : value.shifts) {
    mark(shift.span);
    mark(shift.first_day.span);
    if (shift.last_day) mark(shift.last_day->span);
    for (auto& [from, to] : shift.times) mark(from.span), mark(to.span);
    for (syntax::String& day : shift.off) text(day);
    each(shift.lost);
    if (shift.first_month) mark(shift.first_month->span);
    if (shift.last_month) mark(shift.last_month->span);
  }
}

void PlainItems::item(syntax::ComponentItem& value) {
  name(value.name);
  each(value.shapes);
  each(value.at);
  each(value.grip);
  each(value.mass);
  each(value.density);
  each(value.cost);
  each(value.fixed_to);
  each(value.braced_by);
  each(value.attributes);
}

void PlainItems::item(syntax::MovingItem& value) {
  name(value.name);
  each(value.shapes);
  for (auto& path : value.paths) {
    for (syntax::MovingItem::Place& place : path) number(place.time), part(place.at);
  }
}

void PlainItems::item(syntax::AreaItem& value) {
  name(value.name);
  each(value.height);
  each(value.at);
  for (syntax::AreaItem::Part& part : value.parts) {
    mark(part.key.span);
    mark(part.span);
    for (syntax::FloorPlace& place : part.places) number(place.x), number(place.y);
    each(part.size);
  }
}

void PlainItems::item(syntax::CoverItem& value) {
  name(value.area);
  for (syntax::CoverItem::Clause& clause : value.clauses) {
    mark(clause.key.span);
    each(clause.number);
    each(clause.second);
    if (clause.place) number(clause.place->x), number(clause.place->y);
    each(clause.word);
    each(clause.guides);
  }
}

void PlainItems::item(syntax::EarthItem& value) {
  name(value.name);
  for (syntax::EarthItem::Clause& clause : value.clauses) {
    mark(clause.key.span);
    each(clause.numbers);
    if (clause.file) text(*clause.file);
    each(clause.at);
  }
}

void PlainItems::item(syntax::DigItem& value) {
  each(value.volume);
  if (value.earth) mark(value.earth->span);
  each(value.shape);
  for (syntax::DigItem::Clause& clause : value.clauses) {
    mark(clause.key.span);
    each(clause.number);
    each(clause.trucks);
    each(clause.duration);
    law(clause.law);
    each(clause.by);
    each(clause.frame);
    each(clause.places);
  }
}

void PlainItems::item(syntax::HaulItem& value) {
  each(value.digs);
  for (syntax::HaulItem::Clause& clause : value.clauses) {
    mark(clause.key.span);
    each(clause.number);
    each(clause.places);
    each(clause.duration);
    law(clause.law);
    if (clause.earth) mark(clause.earth->span);
    each(clause.frame);
    each(clause.values);
  }
}

void PlainItems::item(syntax::WorkspacesItem& value) {
  mark(value.keyword);
  each(value.of);
  each_number(value.numbers);
  for (syntax::Span& span : value.watch) mark(span);
}

void PlainItems::law(std::optional<syntax::DurationLaw>& value) {
  if (!value) return;
  mark(value->span);
  mark(value->name.span);
  each(value->values);
  if (value->file) text(*value->file);
  for (syntax::Name& unit : value->units) mark(unit.span);
  for (syntax::String& column : value->columns) text(column);
}

void PlainItems::each_number(std::vector<syntax::NumberItem>& values) {
  for (syntax::NumberItem& each : values) {
    mark(each.span);
    mark(each.name.span);
    number(each.value);
  }
}

void PlainItems::item(syntax::PolicyItem& value) {
  mark(value.name.span);
  each_number(value.numbers);
  for (syntax::Name& what : value.minimise) mark(what.span);
}

void PlainItems::item(syntax::LaneClassItem& value) {
  name(value.name);
  each(value.speed);
  each(value.width);
  each(value.cost);
}

void PlainItems::item(syntax::ErrandItem& value) {
  name(value.name);
  name(value.from);
  name(value.to);
  number(value.start);
  each_number(value.numbers);
}

void PlainItems::item(syntax::BarrierItem& value) {
  name(value.from);
  name(value.to);
  number(value.since);
  each(value.until);
}

void PlainItems::item(syntax::ExploreItem& value) {
  name(value.name);
  name(value.from);
  each_number(value.numbers);
}

void PlainItems::item(syntax::LaneReportItem& value) {
  name(value.from);
  name(value.to);
  mark(value.what.span);
  each(value.edges);
  number(value.time);
  name(value.by);
}

void PlainItems::item(syntax::LaneItem& value) {
  name(value.from);
  name(value.to);
  for (syntax::Name& lane_class : value.lane_class) mark(lane_class.span);
  for (auto& [from, to] : value.beside) name(from), name(to);
  each(value.length);
}

void PlainItems::item(syntax::FleetItem& value) {
  name(value.name);
  for (syntax::String& file : value.file) text(file);
  each(value.size);
  each(value.on);
  each(value.at);
  for (syntax::Name& rule : value.choose) mark(rule.span);
  item(value.member);
}

void PlainItems::item(syntax::RobotUse& value) {
  each(value.name);
  text(value.file);
  for (syntax::String& script : value.behaviour) text(script);
  each(value.at);
  each(value.start);
  each(value.cost);
  part(value.charges);
  each(value.calendar);
  each(value.park);
  for (syntax::Breakdown& breakdown : value.breakdowns) {
    mark(breakdown.span);
    number(breakdown.every);
    law(breakdown.every_law);
    number(breakdown.takes);
    law(breakdown.takes_law);
  }
}

void PlainItems::item(syntax::CrewItem& value) {
  name(value.name);
  each(value.size);
  each(value.cost);
  part(value.charges);
  each(value.calendar);
}

void PlainItems::item(syntax::PoolItem& value) {
  name(value.name);
  each(value.of);
  for (syntax::Name& rule : value.choose) mark(rule.span);
}

void PlainItems::item(syntax::ByItem& value) {
  each(value.names);
  each(value.all_of);
  each(value.same_as);
}

void PlainItems::item(syntax::NeedsItem& value) {
  for (syntax::NeedsItem::Need& need : value.needs) number(need.units), name(need.crew);
}

void PlainItems::item(syntax::PlaceItem& value) {
  name(value.module);
  part(value.at);
  each(value.from);
  name(value.as);
  links(value.after);
}

void PlainItems::item(syntax::ImportItem& value) {
  text(value.file);
  each(value.as);
}

void PlainItems::item(syntax::WithinItem& value) {
  each(value.length);
  part(value.values);
}

void PlainItems::item(syntax::WorkItem& value) {
  mark(value.name.span);
  number(value.duration);
  law(value.law);
  each(value.by);
  if (value.turning) mark(value.turning->span);
}

void PlainItems::item(syntax::DateItem& value) {
  mark(value.name.span);
  for (syntax::Moment& moment : value.moments) {
    mark(moment.span);
    if (moment.date) text(*moment.date);
    each(moment.after_start);
  }
}

void PlainItems::item(syntax::MotionClause& value) {
  mark(value.key.span);
  each(value.turns);
  part(value.values);
  each(value.parameters);
  each(value.numbers);
  if (!value.body) return;
  part(*value.body);
  name(value.component);
}

void PlainItems::item(syntax::GuideDeclaration& value) {
  name(value.name);
  mark(value.kind.span);
  if (value.planner) text(*value.planner);
  for (syntax::GuideClause& clause : value.clauses) {
    mark(clause.span);
    mark(clause.key.span);
    if (clause.setting) text(*clause.setting);
    each(clause.number);
    for (syntax::QualifiedName& word : clause.words) name(word);
    for (syntax::GuideClause::Value& each : clause.values) {
      name(each.parameter);
      number(each.number);
    }
  }
}

void PlainItems::item(syntax::AttributeItem& value) {
  mark(value.key.span);
  text(value.text);
}

// ---- what they are made of ----------------------------------------------------------------------

void PlainItems::part(syntax::Values& value) {
  mark(value.span);
  for (syntax::NamedValue& each : value.values) name(each.name), number(each.value);
}

void PlainItems::part(syntax::Charges& value) {
  for (syntax::Rental& rental : value.rental) {
    mark(rental.span);
    number(rental.amount);
    if (rental.from) text(*rental.from);
    if (rental.to) text(*rental.to);
  }
  each(value.mobilisation);
  for (syntax::Overtime& overtime : value.overtime) {
    mark(overtime.span);
    number(overtime.factor);
    each(overtime.outside);
  }
  for (syntax::Fuel& fuel : value.fuel) {
    mark(fuel.span);
    number(fuel.working);
    if (fuel.idling) number(*fuel.idling);
    if (fuel.price) number(*fuel.price);
  }
}

void PlainItems::part(syntax::Frame& value) {
  mark(value.span);
  for (syntax::FrameElement& element : value.elements) {
    mark(element.span);
    if (element.kind == syntax::FrameElement::Kind::node) name(element.node);
    for (syntax::ExpressionPtr& each : element.arguments) argument(each, element);
  }
}

void PlainItems::goal(syntax::Goal& value) {
  mark(value.span);
  each(value.at);
  part(value.values);
}

void PlainItems::links(std::vector<syntax::Link>& value) {
  for (syntax::Link& link : value) {
    mark(link.span);
    name(link.name);
    if (link.type) mark(link.type->span);
    each(link.lag);
  }
}

void PlainItems::shape(syntax::Shape& value) {
  mark(value.span);
  mark(value.kind.span);
  each(value.numbers);
  text(value.file);
  if (value.unit) mark(value.unit->span);
  each(value.scale);
  if (value.up) mark(value.up->span);
  if (value.part) text(*value.part);
  each(value.at);
}

void PlainItems::name(syntax::Name& value) {
  mark(value.span);
  if (value.indices.empty()) return;
  const std::optional<std::string> text = plain_name(value, scope_, diagnostics_);
  value.indices.clear();
  if (text) {
    value.text = *text;
  } else {
    failed_ = true;
  }
}

void PlainItems::name(syntax::QualifiedName& value) {
  mark(value.span);
  each(value.body);
  name(value.name);
}

void PlainItems::number(syntax::Number& value) {
  mark(value.span);
  if (!value.expression) return;
  const syntax::ExpressionPtr expression = std::exchange(value.expression, nullptr);
  const std::optional<Value> result = evaluate_number(*expression, scope_, diagnostics_);
  if (!result) {
    failed_ = true;
    return;
  }
  value.value = result->number;
  value.dimension = result->dimension;
  value.unit = unit_kind(result->dimension);
}

void PlainItems::argument(syntax::ExpressionPtr& value, const syntax::FrameElement& element) {
  if (is_literal(*value)) return;  // the copies share it
  const std::optional<Value> result = evaluate_number(*value, scope_, diagnostics_);
  if (!result) {
    failed_ = true;
    return;
  }
  auto literal = std::make_shared<Expression>();
  literal->span = value->span;
  mark(literal->span);
  const bool moves = element.kind == syntax::FrameElement::Kind::trans;
  const Dimension wanted = dimension_of(moves ? UnitKind::length : UnitKind::angle);
  if (!result->dimension.is_bare() && !(result->dimension == wanted)) {
    failed_ = true;
    diagnostics_.error(
        "F09", literal->span,
        fmt::format("{} needs {}, but the value is {}", moves ? "trans" : "a rotation",
                    dimension_text(wanted), kind_text(*result)));
    return;
  }
  literal->number.value = result->number;
  literal->number.span = literal->span;
  value = std::move(literal);
}

// ---- texts --------------------------------------------------------------------------------------

void PlainItems::text(syntax::String& value) {
  mark(value.span);
  std::size_t at = value.text.find('{');
  if (at == std::string::npos) return;
  std::string out = value.text.substr(0, at);
  while (at < value.text.size()) {
    const std::size_t end = value.text[at] == '{' ? insert(value, at, out) : 0;
    if (end == 0) {
      out += value.text[at++];
    } else {
      at = end;
    }
  }
  value.text = std::move(out);
}

std::size_t PlainItems::insert(const syntax::String& value, std::size_t at, std::string& out) {
  const std::string& written = value.text;
  std::size_t end = at + 1;
  const auto is_in_name = [&](std::size_t place) {
    return place < written.size() && (is_letter(written[place]) || is_digit(written[place]));
  };
  // `yard.pitch` is the parameter of a plan that is imported.
  const auto is_point = [&](std::size_t place) {
    return place > at + 1 && written[place] == '.' && is_in_name(place - 1) &&
           is_in_name(place + 1) && !is_digit(written[place + 1]);
  };
  while (end < written.size() && (is_in_name(end) || is_point(end))) ++end;
  const std::string name = written.substr(at + 1, end - at - 1);
  if (name.empty() || is_digit(name.front()) || end == written.size() || written[end] != '}') {
    return 0;
  }
  bool known = false;
  const std::optional<Value> found = find_value(scope_, name, known);
  if (!found) {
    failed_ = true;
    if (known || may_be_declared(scope_)) return end + 1;
    diagnostics_.error(
        "P23", value.span,
        fmt::format("there is no parameter '{}' for this text{}", name, near_name(scope_, name)),
        "a '{' that is meant to stay is written &lbrace;");
    return end + 1;
  }
  out += found->kind == Value::Kind::text ? found->text : number_text(found->number);
  return end + 1;
}

}  // namespace rubicon::interpreter::expansion
