#include "src/fleets/grid/lacam.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace rubicon::grid {

namespace {

/// What it takes, in expansions, to look at a configuration beside those of its agents: so that a
/// search without agents to move ends too.
constexpr std::int64_t kLook = 1;

/// "Agent `agent` goes to `cell`", and what its parents say. The root says nothing.
struct Constraint {
  int parent = -1;
  int agent = -1;
  int depth = 0;
  CellId cell = kNowhere;
};

/// A configuration, and what of its followers was tried.
struct Node {
  Configuration cells;
  int parent = -1;
  std::vector<float> priorities;
  std::vector<Constraint> constraints = {Constraint{}};  ///< a tree, breadth first
  std::size_t tried = 0;                                 ///< of the constraints
  std::size_t grown = 0;                                 ///< of them, those that have children
};

std::uint64_t hash_of(const Configuration& cells) {
  std::uint64_t hash = cells.size();
  for (const CellId cell : cells) {
    hash = (hash ^ static_cast<std::uint64_t>(cell)) * 0x9E3779B97F4A7C15U;
    hash ^= hash >> 29U;
  }
  return hash;
}

class Search {
 public:
  Search(const CellGraph& graph, Distances& distances, const Configuration& starts,
         const Configuration& goals, std::uint64_t seed, int only)
      : only_(only),
        graph_(graph),
        distances_(distances),
        goals_(goals),
        moves_(graph, distances, goals),
        random_(seed) {
    std::vector<float> priorities(starts.size());
    for (std::size_t i = 0; i < starts.size(); ++i) {
      priorities[i] = static_cast<float>(distances.of(static_cast<int>(i), starts[i])) / kFar;
    }
    add(starts, -1, std::move(priorities));
  }

  LacamResult run(std::int64_t limit) {
    LacamResult result;
    while (!open_.empty() && spent() < limit && kept_ < kMostKept) {
      const int top = open_.back();
      if (is_goal(nodes_[at(top)].cells)) {
        result.end = LacamResult::End::solved;
        for (int i = top; i >= 0; i = nodes_[at(i)].parent) {
          result.steps.push_back(nodes_[at(i)].cells);
        }
        std::reverse(result.steps.begin(), result.steps.end());
        break;
      }
      ++looks_;
      set_order(top);
      if (!next_constraint(top)) {
        open_.pop_back();
        continue;
      }
      Configuration next(goals_.size(), kNowhere);
      for (int i = static_cast<int>(nodes_[at(top)].tried) - 1; i > 0;
           i = nodes_[at(top)].constraints[at(i)].parent) {
        const Constraint& each = nodes_[at(top)].constraints[at(i)];
        next[at(each.agent)] = each.cell;
      }
      if (!moves_.find(nodes_[at(top)].cells, next, order_, random_)) continue;
      const int known = find(next);
      if (known >= 0) {
        open_.push_back(known);
      } else {
        std::vector<float> priorities = priorities_after(top, next);
        add(std::move(next), top, std::move(priorities));
      }
    }
    if (result.end != LacamResult::End::solved) {
      if (open_.empty()) result.end = LacamResult::End::exhausted;
      for (std::size_t i = 0; i < goals_.size(); ++i) {
        if (nodes_[at(nearest_)].cells[i] != goals_[i]) result.away.push_back(static_cast<int>(i));
      }
    }
    result.expansions = spent();
    return result;
  }

 private:
  static constexpr float kFar = 1e6F;
  /// Bytes of all configurations that are kept at most, and of one without its agents, about.
  static constexpr std::int64_t kMostKept = 2'000'000'000;
  static constexpr std::int64_t kKeptBeside = 350;

  bool is_goal(const Configuration& cells) const {
    return only_ < 0 ? cells == goals_ : cells[at(only_)] == goals_[at(only_)];
  }
  std::int64_t spent() const { return moves_.expansions() + looks_ * kLook; }

  int find(const Configuration& cells) const {
    const auto [first, last] = known_.equal_range(hash_of(cells));
    for (auto each = first; each != last; ++each) {
      if (nodes_[at(each->second)].cells == cells) return each->second;
    }
    return -1;
  }

  void add(Configuration cells, int parent, std::vector<float> priorities) {
    const int index = static_cast<int>(nodes_.size());
    kept_ += kKeptBeside + 8 * static_cast<std::int64_t>(cells.size());
    known_.emplace(hash_of(cells), index);
    std::int64_t away = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      away += distances_.of(static_cast<int>(i), cells[i]);
    }
    if (away < least_away_) {
      least_away_ = away;
      nearest_ = index;
    }
    Node& node = nodes_.emplace_back();
    node.cells = std::move(cells);
    node.parent = parent;
    node.priorities = std::move(priorities);
    open_.push_back(index);
  }

  /// Who has waited longest comes first; who has arrived, last.
  std::vector<float> priorities_after(int parent, const Configuration& cells) const {
    std::vector<float> result = nodes_[at(parent)].priorities;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i] == goals_[i]) {
        result[i] -= static_cast<float>(static_cast<int>(result[i]));
      } else {
        result[i] += 1;
      }
    }
    return result;
  }

  void set_order(int index) {
    if (ordered_ == index) return;
    ordered_ = index;
    const std::vector<float>& priorities = nodes_[at(index)].priorities;
    if (order_.empty()) {
      order_.resize(priorities.size());
      std::iota(order_.begin(), order_.end(), 0);
    }
    std::sort(order_.begin(), order_.end(), [&](int a, int b) {
      return priorities[at(a)] != priorities[at(b)] ? priorities[at(a)] > priorities[at(b)] : a < b;
    });
  }

  /// Counts the next constraint of a node as tried; false where all were. `order_` is that of it.
  bool next_constraint(int index) {
    Node& node = nodes_[at(index)];
    while (node.tried == node.constraints.size()) {
      if (node.grown == node.constraints.size()) return false;
      const auto parent = static_cast<int>(node.grown++);
      const int depth = node.constraints[at(parent)].depth;
      if (at(depth) >= goals_.size()) continue;
      const int agent = order_[at(depth)];
      const CellId here = node.cells[at(agent)];
      const std::size_t first = node.constraints.size();
      node.constraints.push_back({parent, agent, depth + 1, here});
      for (const CellId beside : graph_.beside(here)) {
        node.constraints.push_back({parent, agent, depth + 1, beside});
      }
      for (std::size_t i = node.constraints.size() - 1; i > first; --i) {
        std::swap(node.constraints[i], node.constraints[first + random_.below(i - first + 1)]);
      }
    }
    ++node.tried;
    return true;
  }

  int only_;
  const CellGraph& graph_;
  Distances& distances_;
  const Configuration& goals_;
  NextMoves moves_;
  RandomBits random_;
  std::vector<Node> nodes_;
  std::unordered_multimap<std::uint64_t, int> known_;
  std::vector<int> open_;
  std::vector<int> order_;
  int ordered_ = -1;
  int nearest_ = 0;
  std::int64_t least_away_ = std::numeric_limits<std::int64_t>::max();
  std::int64_t looks_ = 0;
  std::int64_t kept_ = 0;
};

}  // namespace

LacamResult lacam(const CellGraph& graph, Distances& distances, const Configuration& starts,
                  const Configuration& goals, std::uint64_t seed, std::int64_t limit, int only) {
  return Search(graph, distances, starts, goals, seed, only).run(limit);
}

}  // namespace rubicon::grid
