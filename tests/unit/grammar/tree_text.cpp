#include "tests/unit/grammar/tree_text.hpp"

#include <fmt/format.h>

namespace rubicon::grammar_test {

namespace {

/// One writer a tree: S-expressions, a function for every node.
class Writer {
 public:
  std::string take() { return std::move(text_); }

  void name(const syntax::Name& value) {
    word(value.text);
    for (const syntax::ExpressionPtr& index : value.indices) expression(index);
  }
  void name(const syntax::QualifiedName& value) {
    if (value.body) name(*value.body);
    name(value.name);
  }
  void string(const syntax::String& value) { word('"' + value.text + '"'); }
  void number(const syntax::Number& value) {
    word(fmt::format("{}:{}:{}", value.value, static_cast<int>(value.unit), value.unit_text));
    expression(value.expression);
  }

  void expression(const syntax::Expression& value) {
    using Kind = syntax::Expression::Kind;
    open(fmt::format("e{}", static_cast<int>(value.kind)));
    if (value.kind == Kind::number) number(value.number);
    if (value.kind == Kind::binary) word(std::to_string(static_cast<int>(value.op)));
    if (!value.name.name.text.empty()) name(value.name);
    for (const syntax::ExpressionPtr& operand : value.operands) expression(*operand);
    close();
  }
  void expression(const syntax::ExpressionPtr& value) {
    if (value) expression(*value);
  }

  void statement(const syntax::Statement& value) {
    open(fmt::format("s{}", static_cast<int>(value.kind)));
    if (!value.name.name.text.empty()) name(value.name);
    expression(value.value);
    for (const syntax::Statement& element : value.elements) statement(element);
    if (value.until) {
      open("until");
      expression(value.until);
      close();
    }
    for (const syntax::Module& module : value.modules) {
      open("module");
      for (const syntax::Label& label : module.labels) {
        open(fmt::format("label{}", static_cast<int>(label.kind)));
        name(label.name);
        expression(label.condition);
        close();
      }
      for (const syntax::Statement& inner : module.statements) statement(inner);
      close();
    }
    close();
  }

  void script(const syntax::Script& value) {
    for (const syntax::BehaviourDefinition& behaviour : value.behaviours) {
      open("behaviour");
      name(behaviour.name);
      for (const syntax::Statement& inner : behaviour.statements) statement(inner);
      close();
    }
    for (const syntax::Statement& inner : value.statements) statement(inner);
  }

  void frame(const syntax::Frame& value) {
    open("frame");
    for (const syntax::FrameElement& element : value.elements) {
      open(fmt::format("f{}", static_cast<int>(element.kind)));
      if (element.kind == syntax::FrameElement::Kind::node) name(element.node);
      for (const syntax::ExpressionPtr& argument : element.arguments) expression(argument);
      close();
    }
    close();
  }
  void frame(const std::optional<syntax::Frame>& value) {
    if (value) frame(*value);
  }

  void shape(const syntax::Shape& value) {
    open("shape");
    name(value.kind);
    for (const syntax::Number& entry : value.numbers) number(entry);
    string(value.file);
    if (value.unit) name(*value.unit);
    if (value.scale) number(*value.scale);
    if (value.up) name(*value.up);
    if (value.part) string(*value.part);
    if (value.hull) name(*value.hull);
    frame(value.at);
    close();
  }

  void behaviour(const syntax::BehaviourItem& value) {
    open("behaviour");
    if (value.file) string(*value.file);
    script(value.script);
    close();
  }

  // Items of robots.
  void item(const syntax::SettingItem& value) { name(value.name), number(value.value); }
  void item(const syntax::BodyItem& value) {
    name(value.name);
    if (value.on) name(*value.on);
    for (const syntax::ParameterItem& parameter : value.parameters) {
      open("param");
      name(parameter.name);
      expression(parameter.derived);
      for (const syntax::Attribute& attribute : parameter.attributes) {
        open("attribute");
        name(attribute.name);
        for (const syntax::Number& entry : attribute.numbers) number(entry);
        close();
      }
      close();
    }
    for (const syntax::RuleItem& rule : value.rules) name(rule.parameter), expression(rule.value);
    for (const syntax::FrameItem& entry : value.frames) frame(entry.frame);
    for (const syntax::ShapeItem& entry : value.shapes) shape(entry.shape);
    for (const syntax::BehaviourItem& entry : value.behaviours) behaviour(entry);
  }
  void item(const syntax::ToolItem& value) { name(value.body), frame(value.at); }
  void item(const syntax::ConstItem& value) { name(value.name), expression(value.value); }
  void item(const syntax::TouchingItem& value) { name(value.a), name(value.b); }
  void item(const syntax::CapacityItem& value) {
    for (const auto& [radius, mass] : value.points) number(radius), number(mass);
  }
  void item(const syntax::RopeItem& value) {
    if (value.name) name(*value.name);
    number(value.radius);
    for (const syntax::RopeItem::End* end : {&value.from, &value.to}) {
      name(end->body);
      for (const syntax::Number& each : end->point) number(each);
    }
  }
  void item(const syntax::BufferItem& value) {
    number(value.distance);
    for (const syntax::Name& body : value.bodies) name(body);
  }
  void item(const syntax::GuideDeclaration& value) {
    name(value.name);
    name(value.kind);
    for (const syntax::GuideClause& clause : value.clauses) {
      name(clause.key);
      if (clause.number) number(*clause.number);
      if (clause.condition) expression(*clause.condition);
      for (const syntax::QualifiedName& word : clause.words) name(word);
      for (const syntax::GuideClause::Value& each : clause.values) {
        name(each.parameter);
        number(each.number);
      }
    }
  }
  void item(const syntax::MotionClause& value) {
    name(value.key);
    names(value.turns);
    values(value.values);
    for (const syntax::QualifiedName& each : value.parameters) name(each);
    for (const syntax::Number& each : value.numbers) number(each);
    if (value.body) name(*value.body), name(value.component);
  }
  void item(const syntax::BehaviourItem& value) { behaviour(value); }

  // Items of plans and tasks.
  void values(const syntax::Values& value) {
    for (const syntax::NamedValue& entry : value.values) name(entry.name), number(entry.value);
  }
  void goal(const syntax::Goal& value) { frame(value.at), values(value.values); }
  void links(const std::vector<syntax::Link>& list) {
    for (const syntax::Link& link : list) {
      open("link");
      name(link.name);
      if (link.type) name(*link.type);
      if (link.lag) number(*link.lag);
      close();
    }
  }
  void costs(const std::vector<syntax::Cost>& list) {
    for (const syntax::Cost& cost : list) number(cost.amount);
  }
  void names(const std::vector<syntax::Name>& list) {
    for (const syntax::Name& entry : list) name(entry);
  }
  void item(const syntax::StorageItem& value) {
    name(value.name);
    shape(value.shape);
  }
  void places(const std::vector<syntax::FloorPlace>& value) {
    for (const syntax::FloorPlace& place : value) number(place.x), number(place.y);
  }
  void item(const syntax::AreaItem& value) {
    open("area");
    name(value.name);
    for (const syntax::Number& height : value.height) number(height);
    for (const syntax::Frame& at : value.at) frame(at);
    for (const syntax::AreaItem::Part& part : value.parts) {
      open(part.key.text);
      places(part.places);
      if (part.size) number(*part.size);
      close();
    }
    close();
  }
  void item(const syntax::EarthItem& value) {
    open("earth");
    name(value.name);
    for (const syntax::EarthItem::Clause& clause : value.clauses) {
      open(clause.key.text);
      for (const syntax::Number& entry : clause.numbers) number(entry);
      if (clause.file) string(*clause.file);
      if (clause.at) frame(*clause.at);
      close();
    }
    close();
  }
  void item(const syntax::CoverItem& value) {
    open("cover");
    name(value.area);
    for (const syntax::CoverItem::Clause& clause : value.clauses) {
      open(clause.key.text);
      if (clause.number) number(*clause.number);
      if (clause.second) number(*clause.second);
      if (clause.place) places({*clause.place});
      if (clause.word) name(*clause.word);
      close();
    }
    close();
  }
  void item(const syntax::MovingItem& value) {
    name(value.name);
    for (const syntax::Shape& entry : value.shapes) shape(entry);
    for (const auto& path : value.paths) {
      open("path");
      for (const syntax::MovingItem::Place& place : path) number(place.time), frame(place.at);
      close();
    }
    if (value.repeat) word("repeat");
    if (value.people) word("people");
  }
  void item(const syntax::NetworkItem& value) {
    name(value.name);
    variants(value.parts);
  }
  void numbers_by_name(const std::vector<syntax::NumberItem>& values) {
    for (const syntax::NumberItem& entry : values) name(entry.name), number(entry.value);
  }
  void item(const syntax::PolicyItem& value) {
    name(value.name);
    numbers_by_name(value.numbers);
    names(value.minimise);
  }
  void item(const syntax::LaneClassItem& value) {
    name(value.name);
    for (const syntax::Number& entry : value.speed) number(entry);
    for (const syntax::Number& entry : value.width) number(entry);
    for (const syntax::Number& entry : value.cost) number(entry);
  }
  void item(const syntax::ErrandItem& value) {
    name(value.name), name(value.from), name(value.to), number(value.start);
    numbers_by_name(value.numbers);
  }
  void item(const syntax::LaneReportItem& value) {
    name(value.from), name(value.to), name(value.what);
    for (const syntax::Number& entry : value.edges) number(entry);
    number(value.time), name(value.by);
  }
  void item(const syntax::BarrierItem& value) {
    name(value.from), name(value.to), number(value.since);
    if (value.until) number(*value.until);
  }
  void item(const syntax::ExploreItem& value) {
    name(value.name), name(value.from);
    numbers_by_name(value.numbers);
  }
  void item(const syntax::NodeItem& value) { name(value.name), frame(value.at); }
  void item(const syntax::LaneItem& value) {
    name(value.from), name(value.to);
    names(value.lane_class);
    names(value.both);
    for (const auto& [from, to] : value.beside) name(from), name(to);
    for (const syntax::Number& entry : value.length) number(entry);
  }
  void item(const syntax::FleetItem& value) {
    name(value.name);
    for (const syntax::String& entry : value.file) string(entry);
    for (const syntax::Number& entry : value.size) number(entry);
    names(value.on), names(value.at), names(value.choose);
    item(value.member);
  }
  void item(const syntax::SiteItem& value) { shape(value.shape); }
  void item(const syntax::NumberItem& value) { name(value.name), number(value.value); }
  void item(const syntax::StringItem& value) { name(value.name), string(value.value); }
  void item(const syntax::SituationItem& value) { names(value.names); }
  void item(const syntax::WholeItem& value) {
    if (value.value) name(*value.value);
  }
  void item(const syntax::CalendarItem& value) {
    name(value.name);
    for (const syntax::Shift& shift : value.shifts) {
      open(shift.carry_over ? "carry_over" : "shift");
      name(shift.first_day);
      if (shift.last_day) name(*shift.last_day);
      for (const auto& [from, to] : shift.times) string(from), string(to);
      for (const syntax::String& day : shift.off) string(day);
      if (shift.lost) number(*shift.lost);
      if (shift.first_month) name(*shift.first_month);
      if (shift.last_month) name(*shift.last_month);
      close();
    }
  }
  void item(const syntax::ComponentItem& value) {
    name(value.name);
    for (const syntax::Shape& entry : value.shapes) shape(entry);
    for (const syntax::Frame& entry : value.at) frame(entry);
    word("grip");
    for (const syntax::Frame& entry : value.grip) frame(entry);
    for (const syntax::Number& entry : value.mass) number(entry);
    for (const syntax::Number& entry : value.density) number(entry);
    for (const syntax::Number& entry : value.cost) number(entry);
    for (const syntax::Fixing& entry : value.fixed_to) {
      name(entry.to);
      if (entry.after) name(*entry.after);
    }
    for (const syntax::QualifiedName& entry : value.braced_by) name(entry);
    if (value.people) word("people");
    for (const syntax::AttributeItem& entry : value.attributes) item(entry);
  }
  void item(const syntax::SupportItem& value) {
    if (value.mode) name(*value.mode);
    if (value.gap) number(*value.gap);
  }
  void item(const syntax::AttributeItem& value) { name(value.key), string(value.text); }
  void item(const syntax::RobotUse& value) {
    if (value.name) name(*value.name);
    string(value.file);
    frame(value.at);
    for (const syntax::String& entry : value.behaviour) word("behaviour"), string(entry);
    for (const syntax::Values& entry : value.start) values(entry);
    costs(value.cost);
    names(value.calendar);
    charges(value.charges);
    word("park");
    for (const syntax::Values& entry : value.park) values(entry);
    for (const syntax::Breakdown& entry : value.breakdowns) {
      open("breakdown");
      number(entry.every);
      law(entry.every_law);
      number(entry.takes);
      law(entry.takes_law);
      close();
    }
  }
  void item(const syntax::CrewItem& value) {
    name(value.name);
    for (const syntax::Number& entry : value.size) number(entry);
    costs(value.cost);
    charges(value.charges);
    names(value.calendar);
  }
  void charges(const syntax::Charges& value) {
    for (const syntax::Rental& rental : value.rental) {
      number(rental.amount);
      if (rental.from) string(*rental.from);
      if (rental.to) string(*rental.to);
    }
    for (const syntax::Number& amount : value.mobilisation) number(amount);
    for (const syntax::Overtime& overtime : value.overtime) {
      number(overtime.factor);
      if (overtime.outside) name(*overtime.outside);
    }
    for (const syntax::Fuel& fuel : value.fuel) {
      word("fuel");
      number(fuel.working);
      if (fuel.idling) number(*fuel.idling);
      if (fuel.price) number(*fuel.price);
    }
  }
  void item(const syntax::PoolItem& value) {
    name(value.name);
    names(value.of);
    names(value.choose);
  }
  void item(const syntax::OverheadItem& value) { number(value.amount); }
  void item(const syntax::NeedsItem& value) {
    for (const syntax::NeedsItem::Need& need : value.needs) number(need.units), name(need.crew);
  }
  void law(const std::optional<syntax::DurationLaw>& value) {
    if (!value) return;
    name(value->name);
    for (const syntax::Number& entry : value->values) number(entry);
    if (value->file) string(*value->file);
    for (const syntax::Name& entry : value->units) name(entry);
    for (const syntax::String& entry : value->columns) string(entry);
  }
  void item(const syntax::DigItem& value) {
    open("dig");
    if (value.volume) number(*value.volume);
    if (value.earth) name(*value.earth);
    if (value.shape) shape(*value.shape);
    for (const syntax::DigItem::Clause& clause : value.clauses) {
      open(clause.is_stage ? "stage" : "clause");
      name(clause.key);
      if (clause.number) number(*clause.number);
      if (clause.trucks) name(*clause.trucks);
      if (clause.law) {
        law(clause.law);
      } else if (clause.duration) {
        number(*clause.duration);
      }
      if (clause.by) name(*clause.by);
      if (clause.frame) frame(*clause.frame);
      for (const syntax::Frame& place : clause.places) frame(place);
      close();
    }
    close();
  }
  void item(const syntax::HaulItem& value) {
    open("haul");
    for (const syntax::QualifiedName& dig : value.digs) name(dig);
    for (const syntax::HaulItem::Clause& clause : value.clauses) {
      open("clause");
      name(clause.key);
      if (clause.number) number(*clause.number);
      for (const syntax::Frame& place : clause.places) frame(place);
      if (clause.law) {
        law(clause.law);
      } else if (clause.duration) {
        number(*clause.duration);
      }
      if (clause.earth) name(*clause.earth);
      if (clause.frame) frame(*clause.frame);
      if (clause.values) values(*clause.values);
      close();
    }
    close();
  }
  void item(const syntax::WorkspacesItem& value) {
    open("workspaces");
    names(value.of);
    for (const syntax::NumberItem& each : value.numbers) item(each);
    close();
  }
  void item(const syntax::WorkItem& value) {
    name(value.name), number(value.duration);
    law(value.law);
    if (value.by) name(*value.by);
    if (value.turning) name(*value.turning);
  }
  void item(const syntax::ByItem& value) {
    names(value.names);
    names(value.all_of);
    for (const syntax::QualifiedName& entry : value.same_as) name(entry);
  }
  void item(const syntax::MoveItem& value) { name(value.component), frame(value.to); }
  void item(const syntax::GoItem& value) { goal(value.goal); }
  void item(const syntax::RemoveItem& value) { name(value.component); }
  void item(const syntax::ViaItem& value) { goal(value.goal); }
  void item(const syntax::GuideItem& value) { names(value.names); }
  void item(const syntax::WithinItem& value) {
    if (value.length) number(*value.length);
    values(value.values);
  }
  void item(const syntax::ZoneItem& value) {
    shape(value.shape);
    if (value.up_to) number(*value.up_to);
  }
  void item(const syntax::DateItem& value) {
    name(value.name);
    for (const syntax::Moment& moment : value.moments) {
      if (moment.date) string(*moment.date);
      if (moment.after_start) number(*moment.after_start);
    }
  }
  void item(const syntax::AfterItem& value) { links(value.links); }
  void item(const syntax::TaskItem& value) {
    name(value.name);
    variants(value.parts);
  }
  void item(const syntax::WaiverItem& value) {
    name(value.kind), name(value.first), name(value.second);
  }
  void item(const syntax::ModuleItem& value) {
    name(value.name);
    variants(value.items);
  }
  void item(const syntax::PlaceItem& value) {
    name(value.module), frame(value.at), name(value.as), links(value.after);
  }
  void item(const syntax::ImportItem& value) {
    string(value.file);
    if (value.as) name(*value.as);
  }
  void item(const syntax::StartItem& value) { values(value.values); }
  void item(const syntax::GoalItem& value) { goal(value.goal); }
  void item(const syntax::CarryItem& value) { shape(value.shape); }

  void item(const syntax::PlanParameter& value) {
    name(value.name), expression(value.value), string(value.text);
  }
  template <typename Block>
  void item(const std::shared_ptr<const Block>& value) {
    const syntax::BlockHead& head = value->head;
    if (head.variable) name(*head.variable), number(head.first), number(head.last);
    expression(head.condition);
    variants(value->items);
  }

  template <typename Items>
  void variants(const Items& items) {
    for (const auto& entry : items) {
      open(fmt::format("i{}", entry.index()));
      std::visit([this](const auto& value) { this->item(value); }, entry);
      close();
    }
  }

  void measure(const syntax::Measure& value) {
    open("measure");
    for (const syntax::QualifiedName& word : value.words) name(word);
    close();
  }
  void literal(const syntax::Literal& value) {
    word(value.text);
    number(value.number);
  }
  void limit(const syntax::Limit& value) {
    measure(value.measure);
    word(value.comparison.text.substr(0, 2));
    if (value.text) {
      string(*value.text);
    } else {
      literal(value.number);
    }
  }
  void study(const syntax::Study& value) {
    open("study");
    name(value.name);
    for (const auto& each : value.plans) string(each.file);
    for (const syntax::VaryItem& each : value.vary) {
      open("vary");
      name(each.name);
      for (const syntax::VariedValue& one : each.values) {
        if (one.text) string(*one.text);
        if (!one.text) literal(one.first);
        if (one.last) literal(*one.last);
        if (one.step) literal(*one.step);
      }
      close();
    }
    for (const syntax::DesignItem& each : value.designs) {
      name(each.kind);
      if (each.count) number(*each.count);
    }
    for (const syntax::RunsItem& each : value.runs) {
      number(each.count);
      if (each.until) limit(*each.until);
    }
    for (const syntax::SeedItem& each : value.seeds) number(each.value);
    for (const syntax::Measure& each : value.asks) measure(each);
    for (const syntax::ChooseItem& each : value.chooses) {
      name(each.direction);
      measure(each.measure);
      for (const syntax::Limit& one : each.with) limit(one);
    }
    close();
  }

 private:
  void word(const std::string& value) { text_ += ' ' + value; }
  void open(const std::string& value) { text_ += " (" + value; }
  void close() { text_ += ')'; }

  std::string text_;
};

}  // namespace

std::string tree_text(const syntax::Expression& expression) {
  Writer writer;
  writer.expression(expression);
  return writer.take();
}

std::string tree_text(const syntax::Script& script) {
  Writer writer;
  writer.script(script);
  return writer.take();
}

std::string tree_text(const syntax::Robot& robot) {
  Writer writer;
  writer.name(robot.name);
  writer.variants(robot.items);
  return writer.take();
}

std::string tree_text(const syntax::Plan& plan) {
  Writer writer;
  writer.name(plan.name);
  writer.variants(plan.items);
  return writer.take();
}

std::string tree_text(const syntax::Study& study) {
  Writer writer;
  writer.study(study);
  return writer.take();
}

}  // namespace rubicon::grammar_test
