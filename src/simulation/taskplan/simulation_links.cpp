#include <algorithm>
#include <utility>

#include "src/simulation/taskplan/foreseen_times.hpp"
#include "src/simulation/taskplan/plan_network.hpp"
#include "src/simulation/taskplan/simulation.hpp"

namespace rubicon::taskplan {

using schedule::TaskEnd;

void Simulation::prepare_links(schedule::Network network, std::vector<Ticks> work) {
  network.tasks = network_tasks(plan_);
  const auto precomputed = foreseen_times(plan_, network.tasks);
  for (const interpreter::TaskSpec& park : parks_) network.tasks.emplace_back().name = park.name;
  for (std::size_t i = 0; i < specs_.size(); ++i) {
    // Motions are work too.
    if (network.tasks[i].work == 0 && specs_[i]->robot >= 0) network.tasks[i].work = 1;
  }
  status_.resize(specs_.size(), Status::pending);
  links_.emplace(std::move(network), std::move(work), precomputed,
                 [this](int task) -> const schedule::WorkCalendar& {
                   return allocator_->calendar(queue_[index(task)]);
                 });
  for (const auto& [task, excluded] : excluded_) links_->leave_out(task);
  links_->count_links();
}

/// Tasks without links ask from now on; of those that are precomputed all is known already.
void Simulation::start_plan() {
  const int always = std::get<int>(allocator_->queue_for({}, {}));
  for (int task = 0; task < static_cast<int>(plan_.tasks.size()); ++task) {
    if (links_->is_precomputed(task)) {
      const schedule::TaskTimes times = links_->times(task);
      status_[index(task)] = Status::asking;
      allocator_->ask(always, task, spec(task).priority, times.start);
      links_->publish(task, TaskEnd::start, times.start);
      links_->publish(task, TaskEnd::finish, times.finish);
    } else if (links_->may_start(task)) {
      may_start(task, -1);
    }
  }
  propagate();
}

/// The task asks for its robots and crews from the moment its links let it start.
void Simulation::may_start(int task, int before) {
  if (excluded_.contains(task) || links_->is_precomputed(task)) return;
  const schedule::TaskTimes times = links_->ready_times(task, before, now_.now);
  links_->set_times(task, times);
  journal_.assign(status_[index(task)], Status::asking);
  allocator_->ask(queue_[index(task)], task, spec(task).priority, times.start);
  new_waits_.push_back(task);
  if (!links_->is_milestone(task)) return;
  links_->publish(task, TaskEnd::start, times.start);
  if (!links_->may_finish(task)) return;
  links_->publish(task, TaskEnd::finish,
                  schedule::held_finish(links_->bounds_of(task, true), times.start));
}

/// A task that is held to its finish goes on.
void Simulation::may_finish(int task) {
  ActiveTask* const active = find_active(task);
  if (!active || active->doing != Doing::held) return;
  wake_at(*active, std::max(now_.now, links_->bounds_of(task, true).finish));
}

void Simulation::propagate() {
  if (!rejection_) links_->propagate(*this);
}

}  // namespace rubicon::taskplan
