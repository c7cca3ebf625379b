#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "interpreter/check/check_number.hpp"
#include "interpreter/check/check_plan_parts.hpp"
#include "interpreter/check/solid_box.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

using syntax::UnitKind;

/// Largest priority either way.
constexpr double kMaxPriority = 1e9;

class TaskChecker {
 public:
  TaskChecker(Subject& subject, const Scope& scope, const syntax::TaskItem& item, TaskSpec& task)
      : subject_(subject), scope_(scope), item_(item), task_(task) {}

  void check() {
    task_.name = item_.name.text;
    task_.span = item_.name.span;
    task_.whole = subject_.model.whole;
    // Who does it, and whether something moves, decides what else may be said.
    for (const syntax::TaskPart& part : item_.parts) {
      if (const auto* by = std::get_if<syntax::ByItem>(&part)) check_by(*by);
      if (const auto* move = std::get_if<syntax::MoveItem>(&part)) check_move(*move);
      if (const auto* go = std::get_if<syntax::GoItem>(&part)) note_go(*go);
    }
    if (go_ != nullptr)
      task_.go = resolve_goal(subject_, robot(), go_->goal, ValueUse::goal, scope_.X_WP);
    for (const syntax::TaskPart& part : item_.parts) {
      std::visit([&](const auto& each) { check_part(each); }, part);
    }
    check_robot();
  }

 private:
  // ---- who, and what moves ----------------------------------------------------------------------

  const RobotSpec* robot() const {
    return task_.robot < 0 ? nullptr
                           : &subject_.model.robots[static_cast<std::size_t>(task_.robot)];
  }
  bool moves() const { return move_ != nullptr || go_ != nullptr; }

  void check_by(const syntax::ByItem& item) {
    by_ = &item;
    for (const syntax::Name& name : item.names) {
      const auto [place, is_new] = by_spans_.emplace(name.text, name.span);
      if (!is_new) {
        subject_.twice(name.span, fmt::format("'{}' is named twice", name.text), place->second);
        continue;
      }
      const auto crew = subject_.crews.find(name.text);
      if (crew != subject_.crews.end()) {
        task_.crews.push_back(crew->second);
        continue;
      }
      const auto found = subject_.robots.find(name.text);
      if (found == subject_.robots.end()) {
        all_known_ = false;
        subject_.unknown(name.span, "robot or crew", name.text,
                         {&subject_.robots, &subject_.crews});
      } else if (task_.robot >= 0) {
        Diagnostic diagnostic;
        diagnostic.code = "P05";
        diagnostic.span = name.span;
        diagnostic.message = fmt::format("a task is done by one robot, found '{}' and '{}'",
                                         robot()->name, name.text);
        diagnostic.notes.push_back({robot_span_, "the first robot"});
        diagnostic.hint = "make it two tasks";
        subject_.diagnostics.add(std::move(diagnostic));
      } else {
        task_.robot = found->second;
        robot_span_ = name.span;
      }
    }
  }

  void check_move(const syntax::MoveItem& item) {
    if (move_ != nullptr) {
      subject_.twice(item.span, "a task moves one component; move is given twice", move_->span);
      return;
    }
    move_ = &item;
    task_.move_span = item.span;
    task_.move = find_component(subject_, scope_, item.component);
    if (task_.move) check_grip(item);
    task_.X_WO_goal = scope_.X_WP * resolve_frame_or_identity(subject_, item.to);
    if (go_ != nullptr) refuse_both(item.span);
  }

  /// Without a grip the tool goes to the origin of the component: fine where that is its top.
  void check_grip(const syntax::MoveItem& item) {
    const ComponentSpec& component =
        subject_.model.components[static_cast<std::size_t>(*task_.move)];
    if (!subject_.without_grip.contains(component.span.begin) || !subject_.judges_names()) return;
    double top = 0;
    for (const geometry::Shape& shape : component.shapes) {
      const Eigen::AlignedBox3d box = box_around(shape.solid);
      for (int corner = 0; corner < 8 && !box.isEmpty(); ++corner) {
        const auto which = static_cast<Eigen::AlignedBox3d::CornerType>(corner);
        top = std::max(top, (shape.X_BS * box.corner(which)).z());
      }
    }
    if (top <= subject_.model.contact) return;
    Diagnostic diagnostic;
    diagnostic.severity = Severity::warning;
    diagnostic.code = "P20";
    diagnostic.span = item.component.span;
    diagnostic.message = fmt::format(
        "component '{}' is moved but has no grip: the tool goes to its origin, {:g} m below its "
        "top",
        item.component.text(), top);
    diagnostic.notes.push_back({component.span, "the component"});
    diagnostic.hint = fmt::format("write for example grip trans(0, 0, {:g});", top);
    subject_.diagnostics.add(std::move(diagnostic));
  }

  void note_go(const syntax::GoItem& item) {
    if (go_ != nullptr) {
      subject_.twice(item.span, "go is given twice", go_->span);
      return;
    }
    go_ = &item;
    if (move_ != nullptr) refuse_both(item.span);
  }

  void refuse_both(Span span) {
    subject_.error("P07", span,
                   fmt::format("task '{}' has move and go; expected one of them", item_.name.text),
                   "make it two tasks, the second after the first");
  }

  void check_robot() {
    if (!moves() || task_.robot >= 0 || !all_known_) return;
    const Span span = move_ != nullptr ? move_->span : go_->span;
    subject_.error("P05", span,
                   fmt::format("{} needs a robot, but task '{}' is done by {}",
                               move_ != nullptr ? "move" : "go", item_.name.text,
                               by_ == nullptr ? "nobody" : "crews alone"),
                   "write by ROBOT;");
  }

  // ---- all other items --------------------------------------------------------------------------

  void check_part(const syntax::ByItem&) {}
  void check_part(const syntax::MoveItem&) {}
  void check_part(const syntax::GoItem&) {}
  void check_part(const std::shared_ptr<const syntax::TaskBlock>&) {}  // expand leaves none

  void check_part(const syntax::RemoveItem& item) {
    const std::optional<int> component = find_component(subject_, scope_, item.component);
    if (component) task_.remove.push_back(*component);
  }

  void check_part(const syntax::WorkItem& item) {
    WorkSpec work;
    work.span = item.span;
    const auto duration =
        bounded(subject_, item.duration, UnitKind::time, item.name.text, 0, kMaxDuration);
    if (duration) work.duration = *duration;
    if (duration && *duration > 0 && item.duration.unit == UnitKind::none) {
      subject_.diagnostics.warning(
          "P22", item.duration.span,
          fmt::format("{0} {1:g} has no unit and is taken as {1:g} s", item.name.text, *duration),
          fmt::format("write {0:g} s, {0:g} min or {0:g} h", *duration));
    }
    if (item.by) work.crew = crew(*item.by, item.name.text);
    if (item.name.text == "takes") {
      task_.takes.push_back(work);
      return;
    }
    if (move_ == nullptr) {
      subject_.error("P06", item.name.span,
                     fmt::format("{} belongs to a task that moves a component; '{}' has no move",
                                 item.name.text, item_.name.text),
                     "work of a crew alone is written takes DURATION;");
    }
    std::optional<WorkSpec>& target = item.name.text == "hook"     ? task_.hook
                                      : item.name.text == "adjust" ? task_.adjust
                                                                   : task_.release;
    if (target) subject_.twice(item.name.span, item.name.text + " is given twice", target->span);
    target = work;
  }

  int crew(const syntax::Name& name, const std::string& work) {
    if (subject_.robots.count(name.text) != 0) {
      subject_.error("P05", name.span,
                     fmt::format("{} is done by a crew, but '{}' is a robot", work, name.text));
      return -1;
    }
    return subject_.find(subject_.crews, name, "crew");
  }

  void check_part(const syntax::ViaItem& item) {
    needs_motion(item.span, "via");
    task_.via.push_back(resolve_goal(subject_, robot(), item.goal, ValueUse::via, scope_.X_WP));
  }

  void check_part(const syntax::GuideItem& item) {
    needs_motion(item.span, "guide");
    once("guide", item.span);
    task_.guide = item.name.text;
    task_.guide_span = item.span;
    use("guide", item.span);
  }

  void check_part(const syntax::SituationItem& item) {
    for (const syntax::Name& name : item.names) task_.situations.push_back(name.text);
  }

  void check_part(const syntax::WithinItem& item) {
    needs_motion(item.span, "within");
    resolve_within(subject_, robot(), item, task_.within);
  }

  void check_part(const syntax::NumberItem& item) {
    if (item.name.text == "budget") {
      needs_motion(item.name.span, "budget");
      once("budget", item.name.span);
      task_.budget = resolve_budget(subject_, item.value);
    } else if (item.name.text == "priority") {
      once("priority", item.name.span);
      use("priority", item.span);
      task_.priority_span = item.span;
      const auto priority =
          bounded(subject_, item.value, UnitKind::none, "priority", -kMaxPriority, kMaxPriority);
      if (priority) task_.priority = *priority;
    } else {
      static const std::map<std::string, int> kItems = {{"budget", 0}, {"priority", 0}};
      subject_.unknown(item.name.span, "item of a task", item.name.text, {&kItems});
    }
  }

  void check_part(const syntax::ZoneItem& item) {
    use("zone", item.span);
    if (task_.zones.empty()) task_.zone_span = item.span;
    std::optional<geometry::Shape> shape = subject_.shapes.resolve(item.shape);
    if (!shape) return;
    shape->X_BS = scope_.X_WP * shape->X_BS;
    task_.zones.push_back(*std::move(shape));
  }

  void check_part(const syntax::WholeItem& item) {
    once("whole", item.span);
    if (move_ == nullptr) {
      subject_.error("P06", item.span,
                     fmt::format("whole is about a lift; task '{}' has no move", item_.name.text));
    }
    if (const auto value = resolve_whole(subject_, item)) task_.whole = *value;
  }

  void check_part(const syntax::AfterItem& item) {
    const std::vector<LinkSpec> links = resolve_links(subject_, scope_, item.links);
    task_.after.insert(task_.after.end(), links.begin(), links.end());
  }

  void check_part(const syntax::AttributeItem& item) {
    add_attribute(subject_, item, "task '" + item_.name.text + "'", attribute_spans_,
                  task_.attributes);
  }

  void needs_motion(Span span, const char* what) {
    if (moves()) return;
    subject_.error("P06", span,
                   fmt::format("{} is about a motion, but task '{}' has neither move nor go", what,
                               item_.name.text));
  }

  void once(const char* what, Span span) {
    const auto [place, is_new] = given_.emplace(what, span);
    if (!is_new) subject_.twice(span, std::string(what) + " is given twice", place->second);
  }

  void use(std::string what, Span span) {
    if (scope_.records_uses) subject_.use(std::move(what), span);
  }

  Subject& subject_;
  const Scope& scope_;
  const syntax::TaskItem& item_;
  TaskSpec& task_;
  const syntax::ByItem* by_ = nullptr;
  const syntax::MoveItem* move_ = nullptr;
  const syntax::GoItem* go_ = nullptr;
  bool all_known_ = true;
  Span robot_span_;
  std::map<std::string, Span> by_spans_;
  std::map<std::string, Span> given_;
  std::map<std::string, Span> attribute_spans_;
};

}  // namespace

void check_task(Subject& subject, const Scope& scope, const syntax::TaskItem& item,
                TaskSpec& task) {
  TaskChecker(subject, scope, item, task).check();
}

}  // namespace rubicon::interpreter::plan_check
