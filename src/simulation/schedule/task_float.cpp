#include "src/simulation/schedule/task_float.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "src/simulation/schedule/index.hpp"

namespace rubicon::schedule {

namespace {

/// A task that is moved as it is, the working time of its parts the same wherever they stand.
class Placement {
 public:
  explicit Placement(const TimedTask& task) : task_(task), parts_(task.parts) {
    if (task.milestone) {
      parts_.clear();
    } else if (parts_.empty()) {
      parts_.push_back(
          {task.calendar->work_between(task.start, task.finish), task.calendar, false});
    }
    std::erase_if(parts_, [](const TaskPart& part) { return part.work == 0; });
  }

  /// The latest finish that is not after `limit`; never sooner than its own.
  Ticks finish_by(Ticks limit) const {
    if (limit <= task_.finish) return task_.finish;
    if (parts_.empty()) return limit;
    // What a link held to a finish out of shift may be held longer.
    if (task_.calendar->last_working(task_.finish) < task_.finish) return limit;
    const TaskPart& last = parts_.back();
    if (!last.whole) return std::max(task_.finish, last.calendar->last_working(limit));
    const Ticks start = start_of(last, limit, task_.finish);
    return start > task_.finish - last.work ? start + last.work : task_.finish;
  }

  /// Its start when it finishes then.
  Ticks start_for(Ticks finish) const {
    if (finish == task_.finish) return task_.start;
    if (parts_.empty()) return finish - (task_.finish - task_.start);
    Ticks start = finish;
    for (std::size_t i = parts_.size(); i-- > 0 && start > task_.start;) {
      start = start_of(parts_[i], start, task_.start);
    }
    return std::max(task_.start, start);
  }

  /// The latest finish with which it starts not after `limit`; never sooner than its own.
  Ticks finish_if_started_by(Ticks limit) const {
    if (limit <= task_.start) return task_.finish;
    if (parts_.empty()) return limit + (task_.finish - task_.start);
    Ticks start = limit;
    if (!task_.calendar->works_at(limit)) start = task_.calendar->last_working(limit) - kSecond;
    Ticks finish = start;
    for (const TaskPart& part : parts_) finish = finish_of(part, finish);
    finish = std::max(finish, task_.finish);
    // Where it would wait on its way it could start later: it finishes sooner.
    if (start_for(finish) > limit) finish = finish_by(finish - 1);
    return start_for(finish) > limit ? task_.finish : finish;
  }

  /// Working time from its finish to a later one.
  Ticks float_to(Ticks finish) const {
    return task_.milestone ? finish - task_.finish
                           : task_.calendar->work_between(task_.finish, finish);
  }

 private:
  /// The last start of a part that is over by then; of one that is whole the search ends where it
  /// would finish before `least`.
  static Ticks start_of(const TaskPart& part, Ticks finish, Ticks least) {
    Ticks start = part.calendar->latest_start(finish, part.work);
    if (!part.whole) return start;
    finish = part.calendar->last_working(finish);
    while (finish - start != part.work && finish > least) {
      finish = part.calendar->shift_end(start);
      start = part.calendar->latest_start(finish, part.work);
    }
    return start;
  }

  /// When a part is over that can begin then.
  static Ticks finish_of(const TaskPart& part, Ticks from) {
    if (!part.whole) return part.calendar->finish(from, part.work);
    Ticks start = part.calendar->next_working(from);
    while (start < kEndOfTime && part.calendar->shift_end(start) - start < part.work) {
      start = part.calendar->next_working(part.calendar->shift_end(start));
    }
    return within_time(start + part.work);
  }

  const TimedTask& task_;
  std::vector<TaskPart> parts_;
};

class BackwardPass {
 public:
  BackwardPass(const std::vector<TimedTask>& tasks, const std::vector<Precedence>& precedences,
               Ticks end)
      : tasks_(tasks),
        precedences_(precedences),
        end_(end),
        into_(tasks.size()),
        out_(tasks.size()) {
    for (const TimedTask& task : tasks) places_.emplace_back(task);
    for (std::size_t i = 0; i < precedences.size(); ++i) {
      into_[at(precedences[i].after)].push_back(i);
      out_[at(precedences[i].before)].push_back(i);
    }
  }

  std::vector<TaskFloat> run() {
    find_latest();
    std::vector<TaskFloat> floats(tasks_.size());
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
      floats[i].latest_finish = latest_[i];
      floats[i].latest_start = places_[i].start_for(latest_[i]);
      floats[i].total = places_[i].float_to(latest_[i]);
      floats[i].free = std::min(floats[i].total, places_[i].float_to(undisturbed(i)));
    }
    return floats;
  }

 private:
  /// How late the task before may finish if the event after comes at `moment`.
  Ticks limit(const Precedence& each, Ticks moment) const {
    Ticks event = moment - each.gap;
    if (each.hours != nullptr) event = each.hours->latest_start(event, each.repair);
    return each.from == TaskEnd::finish ? event
                                        : places_[at(each.before)].finish_if_started_by(event);
  }

  /// From the last to the first; what a ring leads back to is looked at again. Latest finishes only
  /// fall, and not below those of the run.
  void find_latest() {
    latest_.assign(tasks_.size(), 0);
    for (std::size_t i = 0; i < tasks_.size(); ++i) latest_[i] = places_[i].finish_by(end_);
    std::vector<std::size_t> order(tasks_.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::pair(tasks_[a].finish, tasks_[a].start) <
             std::pair(tasks_[b].finish, tasks_[b].start);
    });
    std::vector<bool> waits(tasks_.size(), true);
    while (!order.empty()) {
      const std::size_t after = order.back();
      order.pop_back();
      if (!waits[after]) continue;
      waits[after] = false;
      for (const std::size_t number : into_[after]) {
        const Precedence& each = precedences_[number];
        const Ticks moment =
            each.to == TaskEnd::start ? places_[after].start_for(latest_[after]) : latest_[after];
        const std::size_t before = at(each.before);
        const Ticks finish = places_[before].finish_by(limit(each, moment));
        if (finish >= latest_[before]) continue;
        latest_[before] = finish;
        if (!waits[before]) order.push_back(before);
        waits[before] = true;
      }
    }
  }

  /// The latest finish with which all that comes after stays where it was.
  Ticks undisturbed(std::size_t task) const {
    Ticks finish = end_;
    for (const std::size_t number : out_[task]) {
      const Precedence& each = precedences_[number];
      const TimedTask& after = tasks_[at(each.after)];
      finish =
          std::min(finish, limit(each, each.to == TaskEnd::start ? after.start : after.finish));
    }
    return places_[task].finish_by(finish);
  }

  const std::vector<TimedTask>& tasks_;
  const std::vector<Precedence>& precedences_;
  Ticks end_;
  std::vector<Placement> places_;
  std::vector<std::vector<std::size_t>> into_, out_;
  std::vector<Ticks> latest_;  ///< finishes
};

}  // namespace

std::vector<TaskFloat> floats_of(const std::vector<TimedTask>& tasks,
                                 const std::vector<Precedence>& precedences, Ticks end) {
  return BackwardPass(tasks, precedences, end).run();
}

}  // namespace rubicon::schedule
