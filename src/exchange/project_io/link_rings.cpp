#include "src/exchange/project_io/link_rings.hpp"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

namespace rubicon::project_io {

namespace {

/// 2 t is the start of task t, 2 t + 1 its finish.
class EventGraph {
 public:
  explicit EventGraph(const Project& project) : project_(project) {
    const std::size_t count = project.tasks.size();
    after_.resize(2 * count);
    place_.resize(2 * count);
    build_outline();
    std::unordered_map<std::int64_t, std::size_t> index;
    for (std::size_t t = 0; t < count; ++t) index.emplace(project.tasks[t].uid, t);
    for (std::size_t t = 0; t < count; ++t) {
      for (const Link& link : project.tasks[t].after) {
        const auto found = index.find(link.predecessor);
        if (found == index.end()) continue;
        const bool from_finish = schedule::end_before(link.type) == schedule::TaskEnd::finish;
        const bool to_finish = schedule::end_after(link.type) == schedule::TaskEnd::finish;
        add(2 * found->second + (from_finish ? 1 : 0), 2 * t + (to_finish ? 1 : 0));
      }
    }
    index_ = std::move(index);
  }

  std::vector<LinkPlace> backward_links() {
    find_sets();
    std::vector<LinkPlace> result;
    for (std::size_t t = 0; t < project_.tasks.size(); ++t) {
      const std::vector<Link>& links = project_.tasks[t].after;
      for (std::size_t i = 0; i < links.size(); ++i) {
        const auto found = index_.find(links[i].predecessor);
        if (found == index_.end()) continue;
        const bool from_finish = schedule::end_before(links[i].type) == schedule::TaskEnd::finish;
        const bool to_finish = schedule::end_after(links[i].type) == schedule::TaskEnd::finish;
        const std::size_t from = 2 * found->second + (from_finish ? 1 : 0);
        const std::size_t to = 2 * t + (to_finish ? 1 : 0);
        if (set_[from] == set_[to] && place_[from] >= place_[to]) result.push_back({t, i});
      }
    }
    return result;
  }

 private:
  void add(std::size_t from, std::size_t to) { after_[from].push_back(to); }

  /// Edges of the outline, and the place of every event on a walk round it.
  void build_outline() {
    std::vector<std::size_t> open;
    std::size_t step = 0;
    const auto close = [&] {
      place_[2 * open.back() + 1] = step++;
      open.pop_back();
    };
    for (std::size_t t = 0; t < project_.tasks.size(); ++t) {
      while (!open.empty() && project_.tasks[open.back()].level >= project_.tasks[t].level) close();
      add(2 * t, 2 * t + 1);
      if (!open.empty()) {
        add(2 * open.back(), 2 * t);
        add(2 * t + 1, 2 * open.back() + 1);
      }
      place_[2 * t] = step++;
      open.push_back(t);
    }
    while (!open.empty()) close();
  }

  // Tarjan's sets, without recursion: chains of tasks are long.
  void find_sets() {
    const std::size_t count = after_.size();
    set_.assign(count, kNowhere);
    std::vector<std::size_t> order(count, kNowhere), low(count, 0), next(count, 0);
    std::vector<std::size_t> path, stack;
    std::size_t visited = 0, sets = 0;
    for (std::size_t root = 0; root < count; ++root) {
      if (order[root] != kNowhere) continue;
      path.push_back(root);
      while (!path.empty()) {
        const std::size_t at = path.back();
        if (order[at] == kNowhere) {
          order[at] = low[at] = visited++;
          stack.push_back(at);
        }
        if (next[at] < after_[at].size()) {
          const std::size_t to = after_[at][next[at]++];
          if (order[to] == kNowhere) {
            path.push_back(to);
          } else if (set_[to] == kNowhere) {
            low[at] = std::min(low[at], order[to]);
          }
          continue;
        }
        path.pop_back();
        if (!path.empty()) low[path.back()] = std::min(low[path.back()], low[at]);
        if (low[at] != order[at]) continue;
        std::size_t member = kNowhere;
        do {
          member = stack.back();
          stack.pop_back();
          set_[member] = sets;
        } while (member != at);
        ++sets;
      }
    }
  }

  static constexpr std::size_t kNowhere = SIZE_MAX;
  const Project& project_;
  std::unordered_map<std::int64_t, std::size_t> index_;
  std::vector<std::vector<std::size_t>> after_;
  std::vector<std::size_t> place_;
  std::vector<std::size_t> set_;
};

}  // namespace

std::vector<LinkPlace> links_in_rings(const Project& project) {
  return EventGraph(project).backward_links();
}

}  // namespace rubicon::project_io
