#include "src/results/advice/changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/results/advice/queue_orders.hpp"

namespace rubicon::advice {

namespace {

using interpreter::LinkSpec;
using interpreter::PlanModel;
using interpreter::TaskSpec;
using math::at;

/// m: how far above its goal a waypoint is tried.
constexpr std::array<double, 3> kHeights = {2, 5, 10};

/// Something that was in the way: a task that has to do with it, and how.
struct Obstacle {
  enum class Kind { put_there, needs_the_place, takes_it_away };
  int task = -1;
  Kind kind = Kind::put_there;
  std::string thing;
  auto operator<=>(const Obstacle&) const = default;
};

class ChangeFinder {
 public:
  ChangeFinder(const PlanModel& plan, const why::TaskStory& story)
      : plan_(plan), story_(story), task_(task_named(story.task)) {}

  Changes find(const taskplan::Schedule& schedule) {
    if (task_ < 0) return {};
    find_obstacles();
    for (const Obstacle& each : obstacles_) try_order(each);
    std::vector<QueueOrder> orders = queue_orders(plan_, schedule, task_, kMostQueueOrders + 1);
    const bool more = orders.size() > kMostQueueOrders;
    if (more) orders.pop_back();
    for (const QueueOrder& each : orders) {
      if (each.first == task_) link(each.first, each.second);
    }
    if (spec().robot >= 0) try_robots();
    if (!is_done()) try_waypoints();
    for (const QueueOrder& each : orders) {
      if (each.first != task_) link(each.first, each.second);
    }
    if (more) {
      found_.left_out.push_back({"other orders of tasks that waited for robots and crews",
                                 fmt::format("the first {} were looked at", kMostQueueOrders)});
    }
    return std::move(found_);
  }

 private:
  const TaskSpec& spec() const { return plan_.tasks[at(task_)]; }
  bool is_done() const { return story_.run.result == "done"; }
  const std::string& name(int task) const { return plan_.tasks[at(task)].name; }

  int task_named(const std::string& name) const {
    const auto found = std::find_if(plan_.tasks.begin(), plan_.tasks.end(),
                                    [&](const TaskSpec& each) { return each.name == name; });
    return found == plan_.tasks.end() ? -1 : static_cast<int>(found - plan_.tasks.begin());
  }

  // ---- what was in the way

  void find_obstacles() {
    for (const why::Motion& motion : story_.motions) {
      if (motion.reached) continue;
      if (motion.first_hit) add(motion.first_hit->met, motion.first_hit->origin);
      for (const why::InTheWay& each : motion.way) add(each.met, each.origin);
      for (const why::Attempt& each : motion.last) add(each.met, each.origin);
    }
    for (const why::Span& pause : story_.pauses) {
      if (pause.what == "machine")
        add({task_named(pause.whom), Obstacle::Kind::needs_the_place, ""});
    }
    if (is_done()) {
      add({task_named(story_.run.after), Obstacle::Kind::needs_the_place, ""});
    }
  }

  void add(const std::string& thing, const std::optional<why::Origin>& origin) {
    if (!origin) return;
    using Kind = why::Origin::Kind;
    const bool place = origin->kind == Kind::zone || origin->kind == Kind::machine;
    if (origin->kind != Kind::component && !place) return;
    add({task_named(origin->task),
         place ? Obstacle::Kind::needs_the_place : Obstacle::Kind::put_there, thing});
    if (origin->kind != Kind::component) return;
    for (std::size_t i = 0; i < plan_.tasks.size(); ++i) {
      if (takes(plan_.tasks[i], thing)) {
        add({static_cast<int>(i), Obstacle::Kind::takes_it_away, thing});
      }
    }
  }

  bool takes(const TaskSpec& task, const std::string& thing) const {
    const auto is_it = [&](int component) { return plan_.components[at(component)].name == thing; };
    return (task.move && is_it(*task.move)) ||
           std::any_of(task.remove.begin(), task.remove.end(), is_it);
  }

  void add(Obstacle obstacle) {
    if (obstacle.task < 0 || obstacle.task == task_) return;
    const auto same = [&](const Obstacle& each) {
      return each.task == obstacle.task && each.kind == obstacle.kind;
    };
    // What puts a thing in the way takes it from elsewhere.
    const bool puts = obstacle.kind == Obstacle::Kind::takes_it_away &&
                      std::any_of(obstacles_.begin(), obstacles_.end(), [&](const Obstacle& each) {
                        return each.task == obstacle.task && each.thing == obstacle.thing;
                      });
    if (puts || std::any_of(obstacles_.begin(), obstacles_.end(), same)) return;
    obstacles_.push_back(std::move(obstacle));
  }

  // ---- another order

  /// Whether links say that `later` comes after `earlier`, but for links from the one to the other.
  bool comes_after(int later, int earlier, bool direct_too) const {
    std::set<int> seen = {later};
    std::vector<int> open = {later};
    while (!open.empty()) {
      const int task = open.back();
      open.pop_back();
      for (const LinkSpec& link : plan_.tasks[at(task)].after) {
        if (link.task == earlier && (direct_too || task != later)) return true;
        if (link.task != earlier && seen.insert(link.task).second) open.push_back(link.task);
      }
    }
    return false;
  }

  void try_order(const Obstacle& obstacle) {
    const int other = obstacle.task;
    if (obstacle.kind != Obstacle::Kind::takes_it_away) link(task_, other);
    if (obstacle.kind != Obstacle::Kind::put_there) link(other, task_);
  }

  void link(int first, int second) {
    if (!linked_.emplace(first, second).second) return;
    std::string text = fmt::format("{} before {}", name(first), name(second));
    if (second == task_) text = fmt::format("{} after {}", name(second), name(first));
    if (comes_after(second, first, true)) return;  // so it was
    if (comes_after(first, second, false)) {
      found_.left_out.push_back({text, fmt::format("{} comes after {} by links over other tasks",
                                                   name(first), name(second))});
      return;
    }
    const auto& links = plan_.tasks[at(first)].after;
    const bool linked = std::any_of(links.begin(), links.end(),
                                    [&](const LinkSpec& each) { return each.task == second; });
    if (linked && is_done()) return;  // it only waits, as the plan wants it to
    if (linked) text += fmt::format(", its link 'after {}' left out", name(second));
    found_.changes.push_back({text, [first, second](PlanModel& plan) {
                                std::erase_if(
                                    plan.tasks[at(first)].after,
                                    [&](const LinkSpec& each) { return each.task == second; });
                                LinkSpec link;
                                link.task = first;
                                plan.tasks[at(second)].after.push_back(link);
                              }});
  }

  // ---- another robot

  void try_robots() {
    const auto& own = plan_.robots[at(spec().robot)];
    for (std::size_t i = 0; i < plan_.robots.size(); ++i) {
      const auto& other = plan_.robots[i];
      if (static_cast<int>(i) == spec().robot) continue;
      const std::string text = fmt::format("{} by {}", spec().name, other.name);
      if (!spec().choices.empty() || spec().same_as) {
        found_.left_out.push_back({text, "a pool gives it its robot"});
      } else if (own.robot != other.robot && names_parameters()) {
        found_.left_out.push_back(
            {text, "what the task says of parameters is meant for " + own.name});
      } else {
        found_.changes.push_back(
            {text, [task = task_, robot = static_cast<int>(i)](PlanModel& plan) {
               plan.tasks[at(task)].robot = robot;
             }});
      }
    }
  }

  /// Whether the task says anything of parameters of its robot.
  bool names_parameters() const {
    const TaskSpec& task = spec();
    const auto has_values = [](const interpreter::GoalSpec& goal) { return !goal.values.empty(); };
    return !task.within.values.empty() || !task.clauses.near.empty() ||
           !task.clauses.locked.empty() || !task.clauses.entered.empty() || !task.guides.empty() ||
           (task.go && has_values(*task.go)) ||
           std::any_of(task.via.begin(), task.via.end(), has_values);
  }

  // ---- a waypoint above

  void try_waypoints() {
    const TaskSpec& task = spec();
    if (!task.via.empty()) return;
    std::optional<math::Pose> X_WG;
    if (task.move) X_WG = task.X_WO_goal * plan_.components[at(*task.move)].X_OG;
    if (task.go && task.go->X_WG) X_WG = task.go->X_WG;
    if (!X_WG) return;
    for (const double height : kHeights) {
      math::Pose above = *X_WG;
      above.translation().z() += height;
      found_.changes.push_back(
          {fmt::format("{} over a waypoint {:g} m above its goal", task.name, height),
           [task = task_, above](PlanModel& plan) {
             interpreter::GoalSpec via;
             via.X_WG = above;
             plan.tasks[at(task)].via.push_back(via);
           }});
    }
  }

  const PlanModel& plan_;
  const why::TaskStory& story_;
  int task_;
  std::vector<Obstacle> obstacles_;
  std::set<std::pair<int, int>> linked_;  ///< looked at already
  Changes found_;
};

}  // namespace

Changes changes_for(const PlanModel& plan, const why::TaskStory& story,
                    const taskplan::Schedule& schedule) {
  return ChangeFinder(plan, story).find(schedule);
}

}  // namespace rubicon::advice
