#include "interpreter/expand/qualify.hpp"

#include <fmt/format.h>

#include <optional>
#include <set>
#include <type_traits>
#include <utility>
#include <variant>

#include "interpreter/syntax/file_provider.hpp"

namespace rubicon::interpreter::expansion {

namespace {

using Names = std::set<std::string>;

class Qualifier {
 public:
  Qualifier(const std::string& name, const std::string& file, Diagnostics& diagnostics)
      : name_(name), file_(file), diagnostics_(diagnostics) {}

  void run(syntax::Plan& plan) {
    for (const syntax::PlanItem& item : plan.items) {
      std::visit([this](const auto& each) { declare(each); }, item);
    }
    for (syntax::PlanItem& item : plan.items) {
      std::visit([this](auto& each) { rename(each); }, item);
    }
  }

 private:
  // ---- what is declared
  // ---------------------------------------------------------------------------

  void declare(const syntax::ComponentItem& item) { components_.insert(item.name.text); }
  void declare(const syntax::TaskItem& item) { tasks_.insert(item.name.text); }
  void declare(const syntax::CrewItem& item) { workers_.insert(item.name.text); }
  void declare(const syntax::PoolItem& item) { workers_.insert(item.name.text); }
  void declare(const syntax::RobotUse& item) {
    if (item.name) workers_.insert(item.name->text);
  }
  void declare(const syntax::CalendarItem& item) { calendars_.insert(item.name.text); }
  void declare(const syntax::ModuleItem& item) { modules_.insert(item.name.text); }
  void declare(const syntax::AreaItem& item) { areas_.insert(item.name.text); }
  void declare(const syntax::PlaceItem& item) { places_.insert(item.as.text); }
  template <typename Item>
  void declare(const Item&) {}

  // ---- items
  // --------------------------------------------------------------------------------------

  void rename(syntax::ComponentItem& item) {
    prefix(item.name);
    rename_holders(item);
    for (syntax::Shape& shape : item.shapes) find_file(shape.file);
  }
  void rename(syntax::SiteItem& item) { find_file(item.shape.file); }
  void rename(syntax::StorageItem& item) {
    prefix(item.name);
    find_file(item.shape.file);
  }
  void rename(syntax::MovingItem& item) {
    prefix(item.name);
    for (syntax::Shape& shape : item.shapes) find_file(shape.file);
  }
  void rename(syntax::CalendarItem& item) { prefix(item.name); }
  void rename(syntax::RobotUse& item) {
    if (!item.name) {
      refuse(item.file.span, "a robot without a name");
      return;
    }
    prefix(*item.name);
    find_file(item.file);
    for (syntax::String& script : item.behaviour) find_file(script);
    for (syntax::Name& each : item.calendar) refer(each, calendars_);
    for (syntax::Breakdown& each : item.breakdowns) {
      find_times(each.every_law);
      find_times(each.takes_law);
    }
    outside(item.charges);
  }
  void rename(syntax::CrewItem& item) {
    prefix(item.name);
    for (syntax::Name& each : item.calendar) refer(each, calendars_);
    outside(item.charges);
  }
  void rename(syntax::PoolItem& item) {
    prefix(item.name);
    for (syntax::Name& each : item.of) refer(each, workers_);
  }
  void rename(syntax::AreaItem& item) { prefix(item.name); }
  void rename(syntax::EarthItem& item) { refuse(item.name.span, "an earth"); }
  void rename(syntax::NetworkItem& item) { refuse(item.name.span, "a network"); }
  void rename(syntax::FleetItem& item) { refuse(item.name.span, "a fleet"); }
  void rename(syntax::OverheadItem& item) { refuse(item.span, "overhead"); }
  void rename(syntax::TaskItem& item) {
    prefix(item.name);
    rename_parts(item);
  }
  void rename(syntax::ModuleItem& item) {
    prefix(item.name);
    for (const syntax::ModulePart& part : item.items) {
      if (const auto* component = std::get_if<syntax::ComponentItem>(&part)) {
        inner_components_.insert(component->name.text);
      } else if (const auto* task = std::get_if<syntax::TaskItem>(&part)) {
        inner_tasks_.insert(task->name.text);
      }
    }
    for (syntax::ModulePart& part : item.items) {
      if (auto* component = std::get_if<syntax::ComponentItem>(&part)) {
        for (syntax::Shape& shape : component->shapes) find_file(shape.file);
        rename_holders(*component);
      } else if (auto* task = std::get_if<syntax::TaskItem>(&part)) {
        rename_parts(*task);
      } else if (auto* waiver = std::get_if<syntax::WaiverItem>(&part)) {
        rename(*waiver);
      }
    }
    inner_components_.clear();
    inner_tasks_.clear();
  }
  void rename(syntax::PlaceItem& item) {
    refer(item.module, modules_);
    prefix(item.as);
    links(item.after);
  }
  void rename(syntax::WaiverItem& item) {
    for (syntax::QualifiedName* each : {&item.first, &item.second}) {
      if (!each->body && workers_.count(each->name.text) != 0) {
        prefix(each->name);
      } else {
        refer(*each, components_, inner_components_);
      }
    }
  }
  void rename(syntax::ImportItem& item) { refuse(item.span, "an import with a block"); }
  void rename(syntax::NumberItem& item) { refuse(item.span, item.name.text); }
  void rename(syntax::StringItem& item) { refuse(item.span, item.name.text); }
  void rename(syntax::SituationItem& item) { refuse(item.span, "situation"); }
  void rename(syntax::StartItem& item) { refuse(item.span, "start"); }
  void rename(syntax::GoalItem& item) { refuse(item.span, "goal"); }
  void rename(syntax::ViaItem& item) { refuse(item.span, "via"); }
  void rename(syntax::CarryItem& item) { refuse(item.span, "carry"); }
  void rename(syntax::WithinItem& item) { refuse(item.span, "within"); }
  void rename(syntax::MotionClause& item) { refuse(item.span, item.key.text); }
  void rename(syntax::WholeItem& item) { refuse(item.span, "whole"); }
  void rename(syntax::SupportItem& item) { refuse(item.span, "support"); }
  template <typename Item>
  void rename(Item&) {}

  void rename_holders(syntax::ComponentItem& item) {
    for (syntax::Fixing& each : item.fixed_to) {
      rename_holder(each.to);
      if (each.after) refer(*each.after, tasks_, inner_tasks_);
    }
    for (syntax::QualifiedName& each : item.braced_by) rename_holder(each);
  }
  void rename_holder(syntax::QualifiedName& holder) {
    if (!holder.body && workers_.count(holder.name.text) != 0) {
      prefix(holder.name);
    } else {
      refer(holder, components_, inner_components_);
    }
  }

  void rename_parts(syntax::TaskItem& item) {
    for (syntax::TaskPart& part : item.parts) {
      if (auto* by = std::get_if<syntax::ByItem>(&part)) {
        for (syntax::Name& each : by->names) refer(each, workers_);
        for (syntax::Name& each : by->all_of) refer(each, workers_);
        for (syntax::QualifiedName& each : by->same_as) refer(each, tasks_, inner_tasks_);
      } else if (auto* needs = std::get_if<syntax::NeedsItem>(&part)) {
        for (syntax::NeedsItem::Need& need : needs->needs) refer(need.crew, workers_);
      } else if (auto* work = std::get_if<syntax::WorkItem>(&part)) {
        if (work->by) refer(*work->by, workers_);
        find_times(work->law);
      } else if (auto* dig = std::get_if<syntax::DigItem>(&part)) {
        for (syntax::DigItem::Clause& clause : dig->clauses) {
          if (clause.trucks) refer(*clause.trucks, workers_);
          if (clause.by) refer(*clause.by, workers_);
          find_times(clause.law);
        }
      } else if (auto* cover = std::get_if<syntax::CoverItem>(&part)) {
        refer(cover->area, areas_);
      } else if (auto* haul = std::get_if<syntax::HaulItem>(&part)) {
        for (syntax::QualifiedName& each : haul->digs) refer(each, tasks_, inner_tasks_);
        for (syntax::HaulItem::Clause& clause : haul->clauses) find_times(clause.law);
      } else if (auto* move = std::get_if<syntax::MoveItem>(&part)) {
        refer(move->component, components_, inner_components_);
      } else if (auto* remove = std::get_if<syntax::RemoveItem>(&part)) {
        refer(remove->component, components_, inner_components_);
      } else if (auto* clause = std::get_if<syntax::MotionClause>(&part)) {
        if (clause->body) refer(clause->component, components_, inner_components_);
      } else if (auto* after = std::get_if<syntax::AfterItem>(&part)) {
        links(after->links);
      } else if (auto* zone = std::get_if<syntax::ZoneItem>(&part)) {
        find_file(zone->shape.file);
      }
    }
  }

  // ---- names and files
  // ----------------------------------------------------------------------------

  void find_times(std::optional<syntax::DurationLaw>& law) {
    if (law && law->file) find_file(*law->file);
  }
  void outside(syntax::Charges& charges) {
    for (syntax::Overtime& overtime : charges.overtime) {
      if (overtime.outside) refer(*overtime.outside, calendars_);
    }
  }
  void links(std::vector<syntax::Link>& all) {
    for (syntax::Link& link : all) refer(link.name, tasks_, inner_tasks_);
  }
  void prefix(syntax::Name& name) { name.text = name_ + "." + name.text; }
  void refer(syntax::Name& name, const Names& declared) {
    if (declared.count(name.text) != 0) prefix(name);
  }
  void refer(syntax::QualifiedName& name, const Names& declared, const Names& inner) {
    if (!name.body && inner.count(name.name.text) != 0) return;
    if (declared.count(name.text()) != 0) {
      name.name.text = name.text();
      name.body.reset();
      prefix(name.name);
    } else if (name.body && places_.count(name.body->text) != 0) {
      prefix(*name.body);
    }
  }
  void find_file(syntax::String& file) {
    if (!file.text.empty()) file.text = resolve_path(file_, file.text);
  }

  void refuse(Span span, const std::string& what) {
    diagnostics_.error("P28", span,
                       fmt::format("{} belongs into the plan that imports this one", what));
  }

  const std::string& name_;
  const std::string& file_;
  Diagnostics& diagnostics_;
  Names components_, tasks_, workers_, calendars_, modules_, places_, areas_;
  Names inner_components_, inner_tasks_;  ///< of the module at hand
};

}  // namespace

void qualify(syntax::Plan& plan, const std::string& name, const std::string& file,
             Diagnostics& diagnostics) {
  Qualifier(name, file, diagnostics).run(plan);
}

}  // namespace rubicon::interpreter::expansion
