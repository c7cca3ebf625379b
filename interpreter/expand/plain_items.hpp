#pragma once

#include "interpreter/expand/scope.hpp"
#include "interpreter/syntax/diagnostic.hpp"

namespace rubicon::interpreter::expansion {

/// Makes items plain in place: numbers are computed, names and texts spelt out, spans know their
/// copy. What holds other items (tasks, modules) is left to whoever unrolls them.
class PlainItems {
 public:
  PlainItems(Scope& scope, Diagnostics& diagnostics) : scope_(scope), diagnostics_(diagnostics) {}

  /// False after saying what is wrong with it.
  template <typename Item>
  bool make_plain(Item& value) {
    failed_ = false;
    mark(value.span);
    item(value);
    return !failed_;
  }

  /// A name that is declared or used.
  bool make_plain(syntax::Name& value) {
    failed_ = false;
    name(value);
    return !failed_;
  }

 private:
  void item(syntax::SiteItem& value) { shape(value.shape); }
  void item(syntax::StorageItem& value) { name(value.name), shape(value.shape); }
  void item(syntax::MovingItem& value);
  void item(syntax::AreaItem& value);
  void item(syntax::CoverItem& value);
  void item(syntax::DigItem& value);
  void item(syntax::HaulItem& value);
  void item(syntax::WorkspacesItem& value);
  void item(syntax::EarthItem& value);
  void law(std::optional<syntax::DurationLaw>& value);
  void item(syntax::NetworkItem& value) { name(value.name); }
  void item(syntax::PolicyItem& value);
  void item(syntax::LaneClassItem& value);
  void item(syntax::NodeItem& value) { name(value.name), part(value.at); }
  void item(syntax::LaneItem& value);
  void item(syntax::ErrandItem& value);
  void item(syntax::LaneReportItem& value);
  void item(syntax::BarrierItem& value);
  void item(syntax::ExploreItem& value);
  void each_number(std::vector<syntax::NumberItem>& values);
  void item(syntax::FleetItem& value);
  void item(syntax::NumberItem& value) { name(value.name), number(value.value); }
  void item(syntax::StringItem& value) { name(value.name), text(value.value); }
  void item(syntax::SituationItem& value) { each(value.names); }
  void item(syntax::CalendarItem& value);
  void item(syntax::ComponentItem& value);
  void item(syntax::WaiverItem& value) { name(value.first), name(value.second); }
  void item(syntax::RobotUse& value);
  void item(syntax::CrewItem& value);
  void item(syntax::TaskItem& value) { name(value.name); }
  void item(syntax::ModuleItem& value) { name(value.name); }
  void item(syntax::PlaceItem& value);
  void item(syntax::ImportItem& value);
  void item(syntax::StartItem& value) { part(value.values); }
  void item(syntax::GoalItem& value) { goal(value.goal); }
  void item(syntax::ViaItem& value) { goal(value.goal); }
  void item(syntax::CarryItem& value) { shape(value.shape); }
  void item(syntax::WithinItem& value);
  void item(syntax::PoolItem& value);
  void item(syntax::OverheadItem& value) { number(value.amount); }
  void item(syntax::ByItem& value);
  void item(syntax::NeedsItem& value);
  void item(syntax::MoveItem& value) { name(value.component), part(value.to); }
  void item(syntax::GoItem& value) { goal(value.goal); }
  void item(syntax::RemoveItem& value) { name(value.component); }
  void item(syntax::WorkItem& value);
  void item(syntax::GuideItem& value) { each(value.names); }
  void item(syntax::GuideDeclaration& value);
  void item(syntax::MotionClause& value);
  void item(syntax::ZoneItem& value) { shape(value.shape), each(value.up_to); }
  void item(syntax::WholeItem& value) { each(value.value); }
  void item(syntax::DateItem& value);
  void item(syntax::SupportItem& value) { each(value.mode), each(value.gap); }
  void item(syntax::AfterItem& value) { links(value.links); }
  void item(syntax::AttributeItem& value);
  void item(syntax::PlanParameter& value) { text(value.text); }

  // What items are made of; overloads of `part` are called for each of a list.
  void part(syntax::Name& value) { name(value); }
  void part(syntax::Number& value) { number(value); }
  void part(syntax::Shape& value) { shape(value); }
  void part(syntax::Frame& value);
  void part(syntax::Values& value);
  void part(syntax::Cost& value) { mark(value.span), number(value.amount); }
  void part(syntax::QualifiedName& value) { name(value); }
  void part(syntax::Fixing& value) { name(value.to), each(value.after); }
  void part(syntax::Charges& value);
  void part(syntax::AttributeItem& value) { mark(value.span), item(value); }
  template <typename Part>
  void each(std::vector<Part>& values) {
    for (Part& value : values) part(value);
  }
  template <typename Part>
  void each(std::optional<Part>& value) {
    if (value) part(*value);
  }
  void name(syntax::Name& value);
  void name(syntax::QualifiedName& value);
  void number(syntax::Number& value);
  void text(syntax::String& value);
  void shape(syntax::Shape& value);
  void goal(syntax::Goal& value);
  void links(std::vector<syntax::Link>& value);
  void argument(syntax::ExpressionPtr& value, const syntax::FrameElement& element);
  /// What stands at text[at] == '{': the end of "{name}" and its value; 0 where it is a plain
  /// brace.
  std::size_t insert(const syntax::String& value, std::size_t at, std::string& out);

  void mark(Span& span) const {
    if (span.file != kNoFile) span.copy = scope_.copy;
  }

  Scope& scope_;
  Diagnostics& diagnostics_;
  bool failed_ = false;
};

}  // namespace rubicon::interpreter::expansion
