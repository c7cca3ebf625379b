#include <algorithm>
#include <utility>

#include "src/simulation/schedule/link_order.hpp"
#include "src/simulation/taskplan/foreseen_times.hpp"
#include "src/simulation/taskplan/plan_network.hpp"
#include "src/simulation/taskplan/simulation.hpp"

namespace rubicon::taskplan {

using schedule::TaskEnd;

void Simulation::prepare_links() {
  const std::size_t count = specs_.size();
  std::vector<schedule::NetworkTask>& tasks = network_.tasks;
  tasks = network_tasks(plan_);
  const auto foreseen = foreseen_times(plan_, tasks);
  for (const interpreter::TaskSpec& park : parks_) tasks.emplace_back().name = park.name;
  for (std::size_t i = 0; i < count; ++i) {
    // Motions are work too.
    if (tasks[i].work == 0 && specs_[i]->robot >= 0) tasks[i].work = 1;
  }
  tied_ = schedule::link_order(tasks).tied_both_ways;
  followers_.resize(count);
  status_.resize(count, Status::pending);
  to_start_.resize(count, 0);
  to_finish_.resize(count, 0);
  times_.resize(count);
  known_.resize(count, 0);
  foreseen_.resize(count, false);
  for (std::size_t i = 0; i < foreseen.size(); ++i) {
    if (!foreseen[i]) continue;
    foreseen_[i] = true;
    times_[i] = *foreseen[i];
  }
  for (std::size_t i = 0; i < count; ++i) {
    const int task = static_cast<int>(i);
    for (const schedule::Link& link : tasks[i].after) {
      followers_[index(link.task)].emplace_back(task, link.type);
      if (excluded_.contains(link.task)) continue;
      if (waits_to_start(task, link.type)) ++to_start_[i];
      if (end_after(link.type) == TaskEnd::finish) ++to_finish_[i];
    }
  }
}

/// Tasks without links ask from now on; of those that are foreseen all is known already.
void Simulation::start_plan() {
  const int always = std::get<int>(desk_->queue_for({}, {}));
  for (int task = 0; task < static_cast<int>(plan_.tasks.size()); ++task) {
    if (foreseen_[index(task)]) {
      const schedule::TaskTimes& times = times_[index(task)];
      status_[index(task)] = Status::asking;
      desk_->ask(always, task, spec(task).priority, times.start);
      publish(task, TaskEnd::start, times.start);
      publish(task, TaskEnd::finish, times.finish);
    } else if (to_start_[index(task)] == 0) {
      make_ready(task, -1);
    }
  }
  spread();
}

/// Work that is known starts so late that it does not finish too early, and so waits for what holds
/// its finish too.
bool Simulation::waits_to_start(int task, schedule::LinkType type) const {
  return end_after(type) == TaskEnd::start || (known_work(task) && !tied_[index(task)]);
}

schedule::LinkBounds Simulation::bounds_of(int task, bool with_finish) const {
  schedule::LinkBounds bounds;
  const std::vector<schedule::Link>& links = network_.tasks[index(task)].after;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const TaskEnd end = end_after(links[i].type);
    // A task that is not done holds nobody who began without it.
    if ((end == TaskEnd::finish && !with_finish) || excluded_.contains(links[i].task)) continue;
    const schedule::TaskTimes& before = times_[index(links[i].task)];
    const bool from_start = end_before(links[i].type) == TaskEnd::start;
    bounds.hold(end,
                bound_of(links[i], from_start ? before.start : before.finish,
                         desk_->calendar(queue_[index(task)])),
                static_cast<int>(i));
  }
  return bounds;
}

/// Its links are known, since it is known when `before` starts or finishes (-1: since the plan
/// began): the task asks for its robots and crews from the moment they let it start.
void Simulation::make_ready(int task, int before) {
  if (excluded_.contains(task) || foreseen_[index(task)]) return;
  const bool known = known_work(task);
  const schedule::LinkBounds bounds = bounds_of(task, known && !tied_[index(task)]);
  const schedule::WorkCalendar& calendar = desk_->calendar(queue_[index(task)]);
  const schedule::EarliestStart earliest =
      known ? earliest_start(bounds, 0, work_[index(task)], calendar)
            : earliest_start_of_unknown(bounds, 0, calendar);
  schedule::TaskTimes times;
  // What a negative lag allows may be over when it becomes known.
  times.ready = times.wanted = std::max(earliest.wanted, now_.now);
  if (earliest.hold != schedule::StartHold::not_before) {
    times.held = schedule::Held::link;
    times.link =
        earliest.hold == schedule::StartHold::start_link ? bounds.start_link : bounds.finish_link;
  }
  if (before >= 0 && earliest.wanted < now_.now) {
    const std::vector<schedule::Link>& links = network_.tasks[index(task)].after;
    const auto told = std::find_if(links.begin(), links.end(), [&](const schedule::Link& link) {
      return link.task == before && waits_to_start(task, link.type);
    });
    times.held = schedule::Held::link;
    times.link = static_cast<int>(told - links.begin());
    times.known_late = true;
  }
  times.start = std::max(earliest.start, now_.now);
  journal_.assign(times_[index(task)], times);
  journal_.assign(status_[index(task)], Status::asking);
  desk_->ask(queue_[index(task)], task, spec(task).priority, times.start);
  new_waits_.push_back(task);
  if (!is_milestone(task)) return;
  publish(task, TaskEnd::start, times.start);
  if (to_finish_[index(task)] > 0) return;
  publish(task, TaskEnd::finish, held_finish(bounds_of(task, true), times.start));
}

/// From now on it is known when the task starts or finishes.
void Simulation::publish(int task, TaskEnd end, schedule::Ticks time) {
  schedule::TaskTimes times = times_[index(task)];
  (end == TaskEnd::start ? times.start : times.finish) = time;
  journal_.assign(times_[index(task)], times);
  const std::uint8_t bit = end == TaskEnd::start ? 1 : 2;
  journal_.assign(known_[index(task)], static_cast<std::uint8_t>(known_[index(task)] | bit));
  news_.emplace_back(task, end);
}

void Simulation::count_down(int& counter) {
  --counter;
  journal_.on_undo([&counter] { ++counter; });
}

/// Tells the followers of what became known, until nothing new does.
void Simulation::spread() {
  while (!news_.empty() && !rejection_) {
    const auto [task, end] = news_.back();
    news_.pop_back();
    if (excluded_.contains(task)) continue;
    for (const auto& [follower, type] : followers_[index(task)]) {
      if (end_before(type) != end || excluded_.contains(follower)) continue;
      if (end_after(type) == TaskEnd::finish) {
        count_down(to_finish_[index(follower)]);
        ActiveTask* const active = find_active(follower);
        if (to_finish_[index(follower)] == 0 && active && active->doing == Doing::held) {
          wake_at(*active, std::max(now_.now, bounds_of(follower, true).finish));
        }
      }
      if (waits_to_start(follower, type)) {
        count_down(to_start_[index(follower)]);
        if (to_start_[index(follower)] == 0) make_ready(follower, task);
      }
    }
  }
}

}  // namespace rubicon::taskplan
