#include "src/simulation/taskplan/plan_floats.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>

#include "src/motion/math/index.hpp"

namespace rubicon::taskplan {

namespace {

using schedule::Precedence;
using schedule::TaskEnd;

using math::at;

using HoursOf = std::function<const schedule::WorkCalendar&(int resource)>;

/// A robot or crew for a time; `node` -1: a robot that went out of the way.
struct Use {
  Ticks from = 0, to = 0;
  int node = -1;
  int people = 1;
  double priority = 0;
  Ticks repair = 0;  ///< of the robot when it was given back
  Ticks before = 0;  ///< working time of the task until it was taken
  Ticks after = 0;   ///< and since it was given back

  /// In the order in which they were given. What is given back at once is there for the next.
  std::tuple<Ticks, bool, double, int> place() const { return {from, to > from, -priority, node}; }
};

class Precedences {
 public:
  Precedences(const std::vector<DoneTask>& done, const schedule::LinkState& links,
              const HoursOf& hours_of, const Schedule& schedule)
      : done_(done), links_(links), hours_of_(hours_of), schedule_(schedule) {
    for (std::size_t i = 0; i < done.size(); ++i) node_of_[done[i].task] = static_cast<int>(i);
    for (const BreakdownOutcome& each : schedule.breakdowns) {
      repairs_[{each.robot, each.during, each.from}] = each.repair;
    }
  }

  std::vector<Precedence> take() {
    for (std::size_t i = 0; i < done_.size(); ++i) {
      add_links(static_cast<int>(i));
      add_waits(static_cast<int>(i));
    }
    add_uses();
    return std::move(all_);
  }

 private:
  const TaskOutcome& outcome(int node) const { return schedule_.tasks[done_[at(node)].row]; }
  Ticks start(int node) const { return outcome(node).start; }
  Ticks finish(int node) const { return outcome(node).start + outcome(node).duration; }
  Ticks moment(int node, TaskEnd end) const {
    return end == TaskEnd::start ? start(node) : finish(node);
  }
  int node_of(int task) const {
    const auto found = node_of_.find(task);
    return found == node_of_.end() ? -1 : found->second;
  }

  /// How long its robot was repaired after the task, in its hours.
  Ticks repair_after(const TaskOutcome& task, const ResourceHold& hold) const {
    const ResourceUse& resource = schedule_.resources[at(hold.resource)];
    if (!resource.robot) return 0;
    const auto found = repairs_.find({resource.name, task.task, hold.to});
    return found == repairs_.end() ? 0 : found->second;
  }

  /// As it went: one of them later, the other later.
  void add_as_it_went(int before, TaskEnd from, int after, TaskEnd to) {
    all_.push_back({before, from, after, to, moment(after, to) - moment(before, from)});
  }

  /// How long a machine that was asked took to leave the zone of the task: whatever lets it start
  /// later, this comes after it.
  Ticks leaving(int node) const {
    const auto& zone = links_.times(done_[at(node)].task).start_wait;
    if (!zone || !zone->wait.parking) return 0;
    return zone->wait.until - std::max(zone->since, zone->wait.parking->wanted);
  }

  void add_links(int node) {
    const int task = done_[at(node)].task;
    const std::vector<schedule::Link>& links = links_.links_of(task);
    for (const schedule::Link& link : links) {
      const int before = node_of(link.task);
      if (before < 0) continue;
      const bool to_start = end_after(link.type) == TaskEnd::start;
      const Ticks later = to_start ? leaving(node) : 0;
      all_.push_back({before, end_before(link.type), node, end_after(link.type), link.lag + later});
      // Nobody knows when a motion will end: what would look ahead to that starts after it.
      const bool looks_ahead = to_start ? link.lag < 0 : links_.known_work(task);
      if (end_before(link.type) == TaskEnd::start || links_.known_work(link.task)) continue;
      if (!looks_ahead || start(node) < finish(before)) continue;
      all_.push_back({before, TaskEnd::finish, node, TaskEnd::start, leaving(node)});
    }
    const schedule::TaskTimes& times = links_.times(done_[at(node)].task);
    if (!times.known_late || times.link < 0) return;
    // What a negative lag allows was over when it became known.
    const schedule::Link& link = links[at(times.link)];
    const int before = node_of(link.task);
    if (before < 0) return;
    const bool told_at_start =
        end_before(link.type) == TaskEnd::start || finish(before) > times.ready;
    add_as_it_went(before, told_at_start ? TaskEnd::start : TaskEnd::finish, node, TaskEnd::start);
  }

  void add_waits(int node) {
    const schedule::TaskTimes& times = links_.times(done_[at(node)].task);
    if (times.start_wait) {
      const schedule::MidWait& wait = times.start_wait->wait;
      // Who moved the machine out of the zone, or had it until it could go.
      const int mover = wait.parking ? wait.parking->task_before : wait.task_before;
      const bool asked = wait.parking && wait.parking->held == schedule::Held::asked;
      if (!asked && node_of(mover) >= 0) {
        add_as_it_went(node_of(mover), TaskEnd::finish, node, TaskEnd::start);
      }
    }
    for (const schedule::MidWait& wait : times.mid_waits) {
      const int before = node_of(wait.task_before);
      if (before >= 0) add_as_it_went(before, TaskEnd::finish, node, TaskEnd::finish);
    }
  }

  void add_uses() {
    std::vector<std::vector<Use>> uses(schedule_.resources.size());
    for (std::size_t i = 0; i < done_.size(); ++i) {
      for (const ResourceHold& hold : outcome(static_cast<int>(i)).holds) {
        uses[at(hold.resource)].push_back(
            {hold.from, hold.to, static_cast<int>(i), hold.people, done_[i].priority,
             repair_after(outcome(static_cast<int>(i)), hold), hold.before, hold.after});
      }
    }
    for (const TaskOutcome& task : schedule_.tasks) {
      if (!task.parking || task.result != TaskResult::done) continue;
      for (const ResourceHold& hold : task.holds) {
        uses[at(hold.resource)].push_back(
            {hold.from, hold.to, -1, hold.people, 0, repair_after(task, hold)});
      }
    }
    for (std::size_t i = 0; i < uses.size(); ++i) {
      std::sort(uses[i].begin(), uses[i].end(),
                [](const Use& a, const Use& b) { return a.place() < b.place(); });
      add_uses(uses[i], static_cast<int>(i));
    }
  }

  /// Hands people from task to task: those go first who have been free longest, as in the run, and
  /// so those who have not worked yet before all others.
  void add_uses(const std::vector<Use>& uses, int number) {
    const ResourceUse& resource = schedule_.resources[at(number)];
    struct Free {
      int node = -1;  ///< who had them, -1: nobody yet
      int people = 0;
      Ticks after = 0;  ///< working time of their task since it gave them back
    };
    std::multimap<Ticks, Free> free;
    free.emplace(0, Free{-1, static_cast<int>(resource.size)});
    Ticks parked = 0, repair = 0;
    for (const Use& use : uses) {
      if (use.node < 0) {
        parked += use.to - use.from;
        repair += use.repair;
        continue;
      }
      int wanted = use.people;
      while (wanted > 0 && !free.empty()) {
        auto [since, last] = *free.begin();
        free.erase(free.begin());
        const int taken = std::min(wanted, last.people);
        wanted -= taken;
        // The rest stays before those who have been free as long.
        if (taken < last.people) {
          free.emplace_hint(free.begin(), since, Free{last.node, last.people - taken, last.after});
        }
        if (last.node < 0) continue;
        // Of tasks that have them midway: what these waited for shifts does not count.
        const Ticks midway = last.after + use.before;
        Ticks gap = (resource.robot ? parked : 0) - midway;
        if (midway == 0) {
          gap = std::min(gap + leaving(use.node), start(use.node) - finish(last.node));
        }
        all_.push_back({last.node, TaskEnd::finish, use.node, TaskEnd::start, gap});
        if (repair == 0) continue;
        all_.back().repair = repair;
        all_.back().hours = &hours_of_(number);
      }
      free.emplace(use.to, Free{use.node, use.people, use.after});
      parked = 0;
      repair = use.repair;
    }
  }

  const std::vector<DoneTask>& done_;
  const schedule::LinkState& links_;
  const HoursOf& hours_of_;
  const Schedule& schedule_;
  std::map<std::tuple<std::string, std::string, Ticks>, Ticks> repairs_;  ///< robot, during, from
  std::map<int, int> node_of_;
  std::vector<Precedence> all_;
};

}  // namespace

void add_floats(const std::vector<DoneTask>& done, const schedule::LinkState& links,
                const HoursOf& hours_of, Schedule& schedule) {
  std::vector<schedule::TimedTask> tasks;
  for (const DoneTask& each : done) {
    const TaskOutcome& outcome = schedule.tasks[each.row];
    schedule::TimedTask& task = tasks.emplace_back();
    task.start = outcome.start;
    task.finish = outcome.start + outcome.duration;
    task.calendar = each.calendar;
    task.milestone = each.milestone;
    task.parts = each.parts;
  }
  const auto floats = schedule::floats_of(
      tasks, Precedences(done, links, hours_of, schedule).take(), schedule.process_time);
  for (std::size_t i = 0; i < done.size(); ++i) schedule.tasks[done[i].row].floats = floats[i];
}

}  // namespace rubicon::taskplan
