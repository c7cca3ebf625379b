#include "src/results/advice/queue_orders.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/simulation/schedule/link.hpp"

namespace rubicon::advice {

namespace {

using interpreter::LinkSpec;
using math::at;
using schedule::TaskEnd;
using schedule::Ticks;
using taskplan::ResourceHold;
using taskplan::TaskOutcome;

class OrderSearch {
 public:
  OrderSearch(const interpreter::PlanModel& plan, const taskplan::Schedule& schedule)
      : plan_(plan), done_(plan.tasks.size(), nullptr), uses_(schedule.resources.size()) {
    std::map<std::string, const TaskOutcome*> by_name;
    for (const TaskOutcome& each : schedule.tasks) {
      if (!each.parking && each.result == taskplan::TaskResult::done) by_name[each.task] = &each;
    }
    for (std::size_t i = 0; i < plan.tasks.size(); ++i) {
      const auto found = by_name.find(plan.tasks[i].name);
      if (found == by_name.end()) continue;
      done_[i] = found->second;
      for (const ResourceHold& hold : found->second->holds) {
        uses_[at(hold.resource)].push_back({hold.to, static_cast<int>(i), hold.from});
      }
    }
    for (std::vector<Use>& uses : uses_) std::sort(uses.begin(), uses.end());
  }

  std::vector<QueueOrder> find(int task, std::size_t most) {
    std::vector<bool> seen(done_.size(), false);
    std::vector<int> open;
    const auto go_to = [&](int next) {
      if (done_[at(next)] != nullptr && !seen[at(next)]) open.push_back(next);
      seen[at(next)] = true;
    };
    go_to(task);
    for (std::size_t i = 0; i < open.size(); ++i) {
      const int waiting = open[i];
      for (const int other : waited_for(waiting)) {
        if (other == task) continue;
        if (orders_.size() >= most) return std::move(orders_);
        orders_.push_back({waiting, other});
        go_to(other);
      }
      for (const int before : linked_before(waiting)) go_to(before);
    }
    return std::move(orders_);
  }

 private:
  struct Use {
    Ticks to = 0;
    int task = -1;
    Ticks from = 0;
    auto operator<=>(const Use&) const = default;
  };

  static bool ends_before(const Use& a, const Use& b) { return a.to < b.to; }

  Ticks moment(int task, TaskEnd end) const {
    const TaskOutcome& outcome = *done_[at(task)];
    return end == TaskEnd::start ? outcome.start : outcome.start + outcome.duration;
  }

  /// Who gave back what the task took, in the time for which it can have waited for that.
  std::vector<int> waited_for(int task) const {
    const TaskOutcome& outcome = *done_[at(task)];
    std::vector<Use> found;
    // A lift that waited for a shift may have missed one by waiting for others.
    if (outcome.waits.resource == 0 && !outcome.lift) return {};
    const Ticks waited = outcome.waits.resource + outcome.waits.shift + outcome.waits.machine;
    for (const ResourceHold& hold : outcome.holds) {
      const std::vector<Use>& uses = uses_[at(hold.resource)];
      const Use earliest{hold.from - waited, -1, 0};
      for (auto use = std::upper_bound(uses.begin(), uses.end(), earliest, ends_before);
           use != uses.end() && use->to <= hold.from; ++use) {
        if (use->task != task && use->from < use->to) found.push_back(*use);
      }
    }
    std::sort(found.begin(), found.end(), [](const Use& a, const Use& b) {
      return std::pair(-a.to, a.task) < std::pair(-b.to, b.task);
    });
    std::vector<int> tasks;
    for (const Use& each : found) {
      if (std::find(tasks.begin(), tasks.end(), each.task) == tasks.end()) {
        tasks.push_back(each.task);
      }
    }
    return tasks;
  }

  /// The tasks before it by the links that let it start, or finish, last.
  std::vector<int> linked_before(int task) const {
    std::vector<int> tasks;
    for (const TaskEnd end : {TaskEnd::start, TaskEnd::finish}) {
      Ticks latest = 0;
      std::vector<int> last;
      for (const LinkSpec& link : plan_.tasks[at(task)].after) {
        if (end_after(link.type) != end || done_[at(link.task)] == nullptr) continue;
        const Ticks time = moment(link.task, end_before(link.type)) + link.lag;
        if (time < latest) continue;
        if (time > latest) last.clear();
        latest = time;
        last.push_back(link.task);
      }
      tasks.insert(tasks.end(), last.begin(), last.end());
    }
    return tasks;
  }

  const interpreter::PlanModel& plan_;
  std::vector<const TaskOutcome*> done_;  ///< by task; null: it is not done
  std::vector<std::vector<Use>> uses_;    ///< of each robot and crew, in the order of their ends
  std::vector<QueueOrder> orders_;
};

}  // namespace

std::vector<QueueOrder> queue_orders(const interpreter::PlanModel& plan,
                                     const taskplan::Schedule& schedule, int task,
                                     std::size_t most) {
  return OrderSearch(plan, schedule).find(task, most);
}

}  // namespace rubicon::advice
