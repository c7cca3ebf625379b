#include "src/simulation/schedule/components.hpp"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <map>
#include <utility>

#include "src/simulation/schedule/index.hpp"

namespace rubicon::schedule {

namespace {

class Tarjan {
 public:
  explicit Tarjan(const Graph& graph)
      : graph_(graph),
        components_(graph.size(), -1),
        order_(graph.size(), -1),
        low_(graph.size(), -1),
        next_(graph.size(), 0) {}

  std::vector<int> run() {
    for (int root = 0; root < static_cast<int>(graph_.size()); ++root) {
      if (order_[at(root)] < 0) walk(root);
    }
    return std::move(components_);
  }

 private:
  void enter(int node) {
    order_[at(node)] = low_[at(node)] = visited_++;
    path_.push_back(node);
    open_.push_back(node);
  }

  void walk(int root) {
    enter(root);
    while (!path_.empty()) {
      const int node = path_.back();
      if (next_[at(node)] < graph_[at(node)].size()) {
        const int to = graph_[at(node)][next_[at(node)]++];
        if (order_[at(to)] < 0) {
          enter(to);
        } else if (components_[at(to)] < 0) {
          low_[at(node)] = std::min(low_[at(node)], order_[at(to)]);
        }
        continue;
      }
      path_.pop_back();
      if (!path_.empty()) {
        int& low = low_[at(path_.back())];
        low = std::min(low, low_[at(node)]);
      }
      if (low_[at(node)] == order_[at(node)]) close(node);
    }
  }

  void close(int first) {
    int node = -1;
    do {
      node = open_.back();
      open_.pop_back();
      components_[at(node)] = count_;
    } while (node != first);
    ++count_;
  }

  const Graph& graph_;
  std::vector<int> components_;
  std::vector<int> order_;         // in which a node was met; -1: not yet
  std::vector<int> low_;           // the first met that is known to be reached from it
  std::vector<std::size_t> next_;  // its next edge to follow
  std::vector<int> path_;
  std::vector<int> open_;  // met, and in no component yet
  int visited_ = 0;
  int count_ = 0;
};

}  // namespace

std::vector<int> strong_components(const Graph& graph) { return Tarjan(graph).run(); }

std::vector<int> ring_through(const Graph& graph, const std::vector<int>& components, int node) {
  std::map<int, int> before;  // of the nodes met, so that a small ring in a large graph is cheap
  std::deque<int> queue{node};
  while (!queue.empty()) {
    const int from = queue.front();
    queue.pop_front();
    for (const int to : graph[at(from)]) {
      if (to == node) {
        std::vector<int> ring;
        for (int each = from; each != node; each = before.at(each)) ring.push_back(each);
        ring.push_back(node);
        std::reverse(ring.begin(), ring.end());
        return ring;
      }
      if (components[at(to)] != components[at(node)]) continue;
      if (before.emplace(to, from).second) queue.push_back(to);
    }
  }
  return {};
}

}  // namespace rubicon::schedule
