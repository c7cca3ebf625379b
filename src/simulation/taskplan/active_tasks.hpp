#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "src/simulation/taskplan/active_task.hpp"

namespace rubicon::taskplan {

/// The tasks under way, in the order in which they began. A copy is cheap and a moment to go back
/// to: it shares what does not change.
class ActiveTasks {
 public:
  void add(ActiveTask task) { tasks_.push_back(std::make_shared<ActiveTask>(std::move(task))); }
  void erase(int task) {
    std::erase_if(tasks_, [&](const auto& each) { return each->task == task; });
  }

  /// To be changed; null if it is not under way.
  ActiveTask* find(int task) {
    for (auto& each : tasks_) {
      if (each->task != task) continue;
      // Others may keep this state to go back to it: what changes is a copy.
      if (each.use_count() > 1) each = std::make_shared<ActiveTask>(*each);
      return each.get();
    }
    return nullptr;
  }
  const ActiveTask* look_at(int task) const {
    for (const auto& each : tasks_) {
      if (each->task == task) return each.get();
    }
    return nullptr;
  }

  bool empty() const { return tasks_.empty(); }
  std::size_t size() const { return tasks_.size(); }
  const ActiveTask& operator[](std::size_t i) const { return *tasks_[i]; }

 private:
  std::vector<std::shared_ptr<ActiveTask>> tasks_;
};

}  // namespace rubicon::taskplan
