#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "interpreter/check/check_number.hpp"
#include "interpreter/check/check_plan_parts.hpp"
#include "interpreter/check/solid_box.hpp"
#include "src/motion/geometry/above.hpp"

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
      if (const auto* move = std::get_if<syntax::MoveItem>(&part)) check_move(*move);
      if (const auto* go = std::get_if<syntax::GoItem>(&part)) note_go(*go);
      if (const auto* cover = std::get_if<syntax::CoverItem>(&part)) note_cover(*cover);
      if (const auto* dig = std::get_if<syntax::DigItem>(&part)) note_dig(*dig);
      if (const auto* haul = std::get_if<syntax::HaulItem>(&part)) note_haul(*haul);
    }
    for (const syntax::TaskPart& part : item_.parts) {
      if (const auto* by = std::get_if<syntax::ByItem>(&part)) check_by(*by);
    }
    const std::vector<int> diggers = task_.crews;
    if (dig_ != nullptr) add_dig_crews();
    if (go_ != nullptr)
      task_.go = resolve_goal(subject_, robot(), go_->goal, ValueUse::goal, scope_.X_WP);
    if (cover_ != nullptr) check_cover();
    for (const syntax::TaskPart& part : item_.parts) {
      std::visit([&](const auto& each) { check_part(each); }, part);
    }
    for (const syntax::TaskPart& part : item_.parts) {
      if (const auto* needs = std::get_if<syntax::NeedsItem>(&part)) check_needs(*needs);
    }
    std::vector<GoalSpec> goals = task_.via;
    if (task_.go) goals.push_back(*task_.go);
    if (goals_known_) {
      check_clauses(subject_, robot(), task_.clauses, goals, move_ != nullptr, given_);
    }
    if (dig_ != nullptr) check_dig(diggers);
    if (haul_ != nullptr) check_haul();
    check_robot();
  }

 private:
  // ---- who, and what moves ----------------------------------------------------------------------

  const RobotSpec* robot() const {
    return task_.robot < 0 ? nullptr
                           : &subject_.model.robots[static_cast<std::size_t>(task_.robot)];
  }
  bool moves() const { return move_ != nullptr || go_ != nullptr || cover_ != nullptr; }
  bool drives() const {
    return moves() || haul_ != nullptr || (dig_ != nullptr && robot() != nullptr);
  }

  void check_by(const syntax::ByItem& item) {
    by_ = &item;
    for (const syntax::Name& name : item.names) {
      const auto [place, is_new] = by_spans_.emplace(name.text, name.span);
      if (!is_new) {
        subject_.twice(name.span, fmt::format("'{}' is named twice", name.text), place->second);
        continue;
      }
      const auto pool = subject_.pools.find(name.text);
      const auto crew = subject_.crews.find(name.text);
      const auto found = subject_.robots.find(name.text);
      if (pool != subject_.pools.end()) {
        add_member(pool->second, name.span);
      } else if (crew != subject_.crews.end()) {
        add_crew(crew->second, name.span);
      } else if (found != subject_.robots.end()) {
        add_robot(found->second, name.span);
      } else {
        all_known_ = false;
        subject_.unknown(name.span, "robot or crew", name.text,
                         {&subject_.robots, &subject_.crews, &subject_.pools});
      }
    }
    for (const syntax::Name& name : item.all_of) add_all_of(name);
    for (const syntax::QualifiedName& name : item.same_as) add_same_as(name);
  }

  void add_crew(int crew, Span span) {
    if (std::find(task_.crews.begin(), task_.crews.end(), crew) != task_.crews.end()) {
      subject_.error("P02", span,
                     fmt::format("crew '{}' is in the task twice",
                                 subject_.model.crews[static_cast<std::size_t>(crew)].name));
      return;
    }
    task_.crews.push_back(crew);
  }

  void add_robot(int found, Span span) {
    if (task_.robot >= 0) {
      Diagnostic diagnostic;
      diagnostic.code = "P05";
      diagnostic.span = span;
      diagnostic.message = fmt::format("a task is done by one robot, found '{}' and '{}'",
                                       robot()->name, name_of_robot(found));
      diagnostic.notes.push_back({robot_span_, "the first robot"});
      diagnostic.hint = "make it two tasks";
      subject_.diagnostics.add(std::move(diagnostic));
      return;
    }
    task_.robot = found;
    robot_span_ = span;
  }

  const std::string& name_of_robot(int index) const {
    return subject_.model.robots[static_cast<std::size_t>(index)].name;
  }

  /// The one of the pool that this choice has.
  void add_member(int pool, Span span) {
    for (const PoolMember& member : scope_.members) {
      if (member.pool != pool) continue;
      const PoolSpec& spec = subject_.model.pools[static_cast<std::size_t>(pool)];
      const int index = spec.members[static_cast<std::size_t>(member.member)];
      if (spec.of_robots) {
        add_robot(index, span);
      } else {
        add_crew(index, span);
      }
      return;
    }
    all_known_ = false;  // it has no members, or too many; that was said
  }

  void add_all_of(const syntax::Name& name) {
    const int index = subject_.find(subject_.pools, name, "pool");
    if (index < 0) return;
    const PoolSpec& pool = subject_.model.pools[static_cast<std::size_t>(index)];
    for (const int member : pool.members) {
      if (!pool.of_robots) {
        add_crew(member, name.span);
      } else if (moves()) {
        subject_.error("P05", name.span,
                       fmt::format("a task is moved by one robot, and pool '{}' has {}", pool.name,
                                   pool.members.size()),
                       fmt::format("write by {};", pool.name));
        all_known_ = false;
        return;
      } else {
        task_.also_robots.push_back(member);
      }
    }
  }

  void add_same_as(const syntax::QualifiedName& name) {
    once("same as", name.span);
    const std::optional<int> other = find_task(subject_, scope_, name);
    if (!other) return;
    task_.same_as = *other;
    if (scope_.members.empty()) all_known_ = false;  // that task has no pool; it was said
    for (const PoolMember& member : scope_.members) {
      const PoolSpec& pool = subject_.model.pools[static_cast<std::size_t>(member.pool)];
      if (by_spans_.count(pool.name) == 0) add_member(member.pool, name.span);
    }
  }

  /// So many of a crew, wherever it works in the task; if it is named nowhere, for all of it. Of a
  /// member of a pool in `by` only if it is the one that the task has.
  void check_needs(const syntax::NeedsItem& item) {
    for (const syntax::NeedsItem::Need& need : item.needs) {
      const int crew = needed_crew(need.crew);
      if (crew < 0) continue;
      const CrewSpec& spec = subject_.model.crews[static_cast<std::size_t>(crew)];
      const double people = need.units.value;
      if (people < 1 || people > spec.size || std::floor(people) != people) {
        subject_.error("P09", need.units.span,
                       fmt::format("expected a whole number of people from 1 to {}, the size of "
                                   "crew '{}', found {}",
                                   spec.size, spec.name, people),
                       people > spec.size ? "give the crew a larger size" : "");
        continue;
      }
      const auto twice = [&](const NeedSpec& each) { return each.crew == crew; };
      if (std::any_of(task_.needs.begin(), task_.needs.end(), twice)) {
        subject_.error("P02", need.crew.span,
                       fmt::format("how many of '{}' it needs is given twice", spec.name));
        continue;
      }
      if (!works(crew) && may_be_chosen(crew)) continue;
      task_.needs.push_back({crew, static_cast<int>(people)});
      if (!works(crew)) task_.crews.push_back(crew);
    }
  }

  /// Of a pool that the task has one of; this choice has another.
  bool may_be_chosen(int crew) const {
    return std::any_of(scope_.members.begin(), scope_.members.end(), [&](const PoolMember& member) {
      const PoolSpec& pool = subject_.model.pools[static_cast<std::size_t>(member.pool)];
      return !pool.of_robots &&
             std::find(pool.members.begin(), pool.members.end(), crew) != pool.members.end();
    });
  }

  int needed_crew(const syntax::Name& name) {
    const bool is_pool = subject_.pools.count(name.text) != 0;
    if (is_pool || subject_.robots.count(name.text) != 0) {
      subject_.error("P05", name.span,
                     fmt::format("needs is about people of a crew, but '{}' is a {}", name.text,
                                 is_pool ? "pool" : "robot"),
                     fmt::format("write by {};", name.text));
      return -1;
    }
    return subject_.find(subject_.crews, name, "crew");
  }

  bool works(int crew) const {
    const auto is_it = [&](const std::optional<WorkSpec>& work) {
      return work && work->crew == crew;
    };
    return std::find(task_.crews.begin(), task_.crews.end(), crew) != task_.crews.end() ||
           is_it(task_.hook) || is_it(task_.adjust) || is_it(task_.release);
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
    task_.X_WO_goal = resolve_placed_frame(subject_, item.to, scope_.X_WP);
    if (go_ != nullptr) refuse_both(item.span);
  }

  /// That of a module is the same wherever it is placed, and is there if it is placed nowhere.
  const ComponentSpec& moved_component(const syntax::QualifiedName& name) const {
    if (scope_.module != nullptr && !name.body) {
      const auto own = scope_.module->component_index.find(name.name.text);
      if (own != scope_.module->component_index.end()) {
        return scope_.module->checked_components[static_cast<std::size_t>(own->second)];
      }
    }
    return subject_.model.components[static_cast<std::size_t>(*task_.move)];
  }

  /// Without a grip the tool goes to the origin of the component: fine where that is its top.
  void check_grip(const syntax::MoveItem& item) {
    const ComponentSpec& component = moved_component(item.component);
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

  void note_cover(const syntax::CoverItem& item) {
    if (cover_ != nullptr) {
      subject_.twice(item.span, "cover is given twice", cover_->span);
      return;
    }
    cover_ = &item;
  }

  /// Its way stands in the place of `via` and `go`. The tool works alike whichever way it is
  /// turned, but for a machine that turns with a radius.
  void check_cover() {
    if (move_ != nullptr || go_ != nullptr) {
      subject_.error("P05", cover_->span, "a task that covers an area neither moves nor goes",
                     "make it two tasks");
      return;
    }
    if (robot() != nullptr && robot()->fleet >= 0) {
      subject_.error("P51", cover_->span,
                     fmt::format("{} is of a fleet and drives by its network: it covers no area",
                                 robot()->name));
      return;
    }
    auto way = resolve_cover(subject_, *cover_);
    if (!way) {
      goals_known_ = false;
      return;
    }
    task_.cover = way->cover;
    task_.go = std::move(way->goals.back());
    way->goals.pop_back();
    task_.via = std::move(way->goals);
    if (!(task_.cover->turn_radius > 0)) task_.clauses.free = robot::FreeTurn::z;
    for (const syntax::CoverItem::Clause& clause : cover_->clauses) {
      if (clause.guides.empty()) continue;
      task_.guides = resolve_guides(subject_, robot(), {clause.guides, clause.key.span});
    }
  }

  void check_part(const syntax::CoverItem& /*item*/) {}
  void check_part(const syntax::DigItem& /*item*/) {}
  void check_part(const syntax::HaulItem& /*item*/) {}

  void note_haul(const syntax::HaulItem& item) {
    if (haul_ != nullptr) {
      subject_.twice(item.span, "haul is given twice", haul_->span);
      return;
    }
    haul_ = &item;
  }

  void check_haul() {
    const Span place = haul_->digs.front().span;
    if (move_ != nullptr || go_ != nullptr || cover_ != nullptr || dig_ != nullptr) {
      subject_.error("P05", place, "a task that hauls does nothing else", "make it two tasks");
      return;
    }
    if (!task_.takes.empty() || !task_.via.empty()) {
      subject_.error("P62", place,
                     task_.via.empty() ? "a task that hauls takes as long as its rounds: no takes"
                                       : "a task that hauls has its waypoints in haul",
                     "out at trans(10, 0, 0); loaded, back at trans(0, 10, 0); empty");
      return;
    }
    if (!all_known_) return;
    if (robot() == nullptr || !task_.also_robots.empty()) {
      subject_.error(
          "P62", place,
          robot() == nullptr ? "haul is done by a robot, the truck" : "one truck hauls in a task",
          "a task for each truck: by lorry; haul dig { ... }");
      return;
    }
    if (!robot()->robot || !robot()->robot->usable) return;
    task_.haul = resolve_haul(subject_, scope_, *haul_, *robot());
  }

  void note_dig(const syntax::DigItem& item) {
    if (dig_ != nullptr) {
      subject_.twice(item.span, "dig is given twice", dig_->span);
      return;
    }
    dig_ = &item;
  }

  /// Those who haul and serve are held from start to finish, as those who dig.
  void add_dig_crews() {
    for (const int crew : crews_of_dig(subject_, *dig_)) {
      if (std::find(task_.crews.begin(), task_.crews.end(), crew) == task_.crews.end()) {
        task_.crews.push_back(crew);
      }
    }
  }

  int units_of(int crew) const { return people_of(subject_, task_, crew); }

  /// Its rounds are one work of all whom it holds.
  void check_dig(const std::vector<int>& diggers) {
    if (moves()) {
      subject_.error("P05", dig_->place(), "a task that digs neither moves nor goes nor covers",
                     "make it two tasks");
      return;
    }
    if (!task_.also_robots.empty()) {
      subject_.error("P55", by_ == nullptr ? dig_->place() : by_->span,
                     fmt::format("one robot digs, and '{}' is another",
                                 name_of_robot(task_.also_robots.front())),
                     "a task for each robot, with a part of the pit");
      return;
    }
    if (robot() != nullptr) {
      check_motion_dig(diggers);
      return;
    }
    if (!task_.takes.empty()) {
      subject_.error("P55", task_.takes.front().span,
                     "a task that digs takes as long as its rounds: no takes beside dig");
      return;
    }
    if (!all_known_) return;
    std::vector<CrewUnits> units;
    for (const int crew : diggers) units.push_back({crew, units_of(crew)});
    const auto soil = take_soil(subject_, scope_, *dig_, item_);
    if (dig_->earth && !soil) return;
    task_.dig = resolve_dig(subject_, *dig_, soil, units, [&](int crew) { return units_of(crew); });
    if (!task_.dig) return;
    if (soil) task_.remove.push_back(soil->component);
    WorkSpec work;
    work.span = dig_->span;
    work.duration = static_cast<double>(task_.dig->result.time) / hauling::kPerSecond;
    task_.takes.push_back(work);
  }

  /// A robot digs with its own body.
  void check_motion_dig(const std::vector<int>& crews) {
    const std::string name = name_of_robot(task_.robot);
    if (!dig_->earth) {
      subject_.error("P55", dig_->place(),
                     fmt::format("robot '{}' digs in an earth, and a volume has no place", name),
                     "dig ground to box(4, -1, -2, 8, 1, 1) { ... }, or a crew in place of the "
                     "robot");
      return;
    }
    if (!task_.takes.empty()) {
      subject_.error("P55", task_.takes.front().span,
                     "a task that digs takes as long as its rounds: no takes beside dig");
      return;
    }
    if (!task_.via.empty() || robot()->fleet >= 0) {
      subject_.error("P55", dig_->place(),
                     robot()->fleet >= 0
                         ? fmt::format("'{}' drives in a fleet: it does not dig", name)
                         : "a task that digs has no waypoints of its own");
      return;
    }
    if (!all_known_ || !robot()->robot || !robot()->robot->usable) return;
    for (const int crew : crews) {
      for (const syntax::DigItem::Clause& clause : dig_->clauses) {
        if (!clause.trucks) continue;
        const auto trucks = subject_.crews.find(clause.trucks->text);
        if (trucks == subject_.crews.end() || trucks->second != crew) continue;
        subject_.error("P55", clause.trucks->span,
                       fmt::format("crew '{}' works with the robot and hauls; expected two crews",
                                   clause.trucks->text));
        return;
      }
    }
    const auto soil = take_soil(subject_, scope_, *dig_, item_);
    if (!soil) return;
    task_.motion_dig = resolve_motion_dig(subject_, *dig_, *soil, *robot(), crews,
                                          [&](int crew) { return units_of(crew); });
    if (task_.motion_dig) task_.remove.push_back(soil->component);
  }

  void refuse_both(Span span) {
    subject_.error("P07", span,
                   fmt::format("task '{}' has move and go; expected one of them", item_.name.text),
                   "make it two tasks, the second after the first");
  }

  void check_robot() {
    if ((moves() || haul_ != nullptr) && robot() != nullptr && robot()->fleet >= 0) {
      task_.guides = {subject_.model.fleets[static_cast<std::size_t>(robot()->fleet)].guide};
    }
    if (!moves() || task_.robot >= 0 || !all_known_) return;
    if (by_ == nullptr && subject_.plan.broken) return;
    const Span span = move_ != nullptr ? move_->span : go_ != nullptr ? go_->span : cover_->span;
    subject_.error("P05", span,
                   fmt::format("{} needs a robot, but task '{}' is done by {}",
                               move_ != nullptr ? "move"
                               : go_ != nullptr ? "go"
                                                : "cover",
                               item_.name.text, by_ == nullptr ? "nobody" : "crews alone"),
                   "write by ROBOT;");
  }

  // ---- all other items --------------------------------------------------------------------------

  void check_part(const syntax::ByItem&) {}
  void check_part(const syntax::MoveItem&) {}
  void check_part(const syntax::NeedsItem&) {}
  void check_part(const syntax::GoItem&) {}
  void check_part(const std::shared_ptr<const syntax::TaskBlock>&) {}  // expand leaves none

  void check_part(const syntax::RemoveItem& item) {
    const std::optional<int> component = find_component(subject_, scope_, item.component);
    if (component) task_.remove.push_back(*component);
  }

  void check_part(const syntax::WorkItem& item) {
    WorkSpec work;
    work.span = item.span;
    if (item.law) {
      work.law = resolve_law(subject_, *item.law);
      if (work.law && work.law->is_certain()) {
        subject_.error("P52", item.law->span,
                       fmt::format("{} lists a duration for each use, and {} is done once",
                                   item.law->name.text, item.name.text),
                       "write the duration itself; lists are for the stages of a dig");
      }
      if (work.law) work.duration = work.law->mean();
    } else {
      const auto duration = resolve_duration(subject_, item.duration, item.name.text);
      if (duration) work.duration = *duration;
    }
    if (item.by) work.crew = crew(*item.by, item.name.text);
    if (item.turning) work.turning = turns(item, *item.turning, work.duration);
    if (item.name.text == "takes") {
      task_.takes.push_back(work);
      return;
    }
    if (move_ == nullptr && !subject_.plan.broken) {
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

  /// Whether the work turns the load: only adjusting does, about the vertical, and not at once.
  bool turns(const syntax::WorkItem& item, const syntax::Name& turned, double duration) {
    if (item.name.text != "adjust") {
      subject_.error(
          "P46", turned.span,
          fmt::format("a load is turned while it hangs, found turning in {}", item.name.text),
          "write it in adjust: adjust 4 min by CREW turning theta;");
    } else if (turned.text != "theta") {
      subject_.error("P46", turned.span,
                     fmt::format("people turn a hanging load about the vertical, which is theta; "
                                 "found '{}'",
                                 turned.text),
                     "write turning theta");
    } else if (!(schedule::ticks_from_seconds(duration) > 0)) {
      subject_.error("P46", item.duration.span, "turning a load takes time, found 0",
                     "write for example adjust 4 min turning theta;");
    } else {
      return true;
    }
    return false;
  }

  int crew(const syntax::Name& name, const std::string& work) {
    if (subject_.robots.count(name.text) != 0) {
      subject_.error("P05", name.span,
                     fmt::format("{} is done by a crew, but '{}' is a robot", work, name.text));
      return -1;
    }
    if (subject_.pools.count(name.text) != 0) {
      subject_.error("P40", name.span,
                     fmt::format("{} is done by a crew, but '{}' is a pool", work, name.text),
                     fmt::format("name the pool in by, for the whole task: by {};", name.text));
      return -1;
    }
    return subject_.find(subject_.crews, name, "crew");
  }

  void check_part(const syntax::ViaItem& item) {
    needs_motion(item.span, "via");
    if (cover_ != nullptr) {
      subject_.error("P05", item.span, "a task that covers an area has its waypoints from that");
      return;
    }
    task_.via.push_back(resolve_goal(subject_, robot(), item.goal, ValueUse::via, scope_.X_WP));
  }

  void check_part(const syntax::GuideItem& item) {
    needs_motion(item.span, "guide");
    once("guide", item.span);
    if (cover_ != nullptr) {
      subject_.error("P54", item.span, "a task that covers an area has its way from that",
                     "a guide that leads from strip to strip stands in the cover: "
                     "cover AREA { guide NAME; }");
      return;
    }
    task_.guides = resolve_guides(subject_, robot(), item);
    if (robot() == nullptr || robot()->fleet < 0) return;
    subject_.error("P51", item.span,
                   fmt::format("{} is of a fleet and drives by its network: a task of it has no "
                               "guide",
                               robot()->name));
  }

  void check_part(const syntax::SituationItem& item) {
    for (const syntax::Name& name : item.names) task_.situations.push_back(name.text);
  }

  void check_part(const syntax::WithinItem& item) {
    needs_motion(item.span, "within");
    resolve_within(subject_, robot(), item, task_.within);
  }

  void check_part(const syntax::MotionClause& clause) {
    needs_motion(clause.span, clause.key.text.c_str());
    if (clause.key.text != "enter") once(clause.key.text, clause.span);
    resolve_clause(subject_, scope_, robot(), clause, task_.clauses);
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
    double top = geometry::highest_point(*shape) + geometry::kAirOverPeople;
    if (item.up_to) {
      const auto height =
          bounded(subject_, *item.up_to, UnitKind::length, "up_to", -kMaxLength, kMaxLength);
      if (height) top = scope_.X_WP.translation().z() + *height;
    }
    task_.zones_overhead.push_back(geometry::with_what_is_above(*shape, top));
    task_.zones.push_back(*std::move(shape));
  }

  void check_part(const syntax::WholeItem& item) {
    once("whole", item.span);
    if (move_ == nullptr && !subject_.plan.broken) {
      subject_.error("P06", item.span,
                     fmt::format("whole is about a lift; task '{}' has no move", item_.name.text));
    }
    if (const auto value = resolve_whole(subject_, item)) task_.whole = *value;
  }

  void check_part(const syntax::DateItem& item) {
    once(item.name.text, item.name.span);
    std::vector<schedule::Ticks> moments;
    for (const syntax::Moment& moment : item.moments) {
      if (const auto time = resolve_moment(subject_, moment, item.name.text)) {
        moments.push_back(*time);
      }
    }
    if (moments.size() != item.moments.size()) return;
    if (item.name.text == "not_before") {
      task_.not_before = std::max<schedule::Ticks>(moments[0], 0);
    } else if (item.name.text == "due") {
      task_.due = moments[0];
    } else if (moments[1] < moments[0]) {
      subject_.error("P10", item.moments[1].span, "the baseline ends before it begins");
    } else {
      task_.baseline = Baseline{moments[0], moments[1]};
    }
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
    if (drives() || subject_.plan.broken) return;  // it may have had one
    subject_.error("P06", span,
                   fmt::format("{} is about a motion, but task '{}' has neither move nor go", what,
                               item_.name.text));
  }

  void once(const std::string& what, Span span) {
    const auto [place, is_new] = given_.emplace(what, span);
    if (!is_new) subject_.twice(span, what + " is given twice", place->second);
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
  const syntax::CoverItem* cover_ = nullptr;
  const syntax::DigItem* dig_ = nullptr;
  const syntax::HaulItem* haul_ = nullptr;
  bool all_known_ = true;
  bool goals_known_ = true;  ///< false: what is covered is wrong, which was said
  Span robot_span_;
  std::map<std::string, Span> by_spans_;
  std::map<std::string, Span> given_;
  std::map<std::string, Span> attribute_spans_;
};

}  // namespace

int people_of(const Subject& subject, const TaskSpec& task, int crew) {
  for (const NeedSpec& need : task.needs) {
    if (need.crew == crew) return need.people;
  }
  return static_cast<int>(subject.model.crews[static_cast<std::size_t>(crew)].size);
}

void check_task(Subject& subject, const Scope& scope, const syntax::TaskItem& item,
                TaskSpec& task) {
  const auto choices = choices_of(subject, scope, item);
  if (choices.front().empty()) {
    TaskChecker(subject, scope, item, task).check();
    return;
  }
  std::vector<TaskSpec> specs;
  Scope each = scope;
  for (const std::vector<PoolMember>& members : choices) {
    each.members = members;
    const int errors = subject.diagnostics.errors();
    TaskSpec& spec = specs.emplace_back();
    TaskChecker(subject, each, item, spec).check();
    spec.members = members;
    // What is wrong is most often so for all.
    if (subject.diagnostics.errors() != errors) break;
    each.records_uses = false;
  }
  task = specs.front();
  task.members.clear();
  for (const PoolMember& member : choices.front()) {
    const PoolSpec& pool = subject.model.pools[static_cast<std::size_t>(member.pool)];
    if (pool.of_robots) {
      task.robot = -1;
    } else {
      std::erase(task.crews, pool.members[static_cast<std::size_t>(member.member)]);
    }
  }
  task.choices = std::move(specs);
}

}  // namespace rubicon::interpreter::plan_check
