#include "bench/lacam_paper.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <memory>
#include <numeric>
#include <queue>
#include <random>
#include <unordered_map>

namespace rubicon::bench {

namespace {

using Places = std::vector<int>;
constexpr int kNone = -1;

struct PlacesHash {
  std::size_t operator()(const Places& places) const {
    std::size_t hash = places.size();
    for (const int place : places) {
      hash ^= static_cast<std::size_t>(place) + 0x9E3779B9U + (hash << 6U) + (hash >> 2U);
    }
    return hash;
  }
};

/// A node of the low level: agent `who` goes to `where`, and what its parents say.
struct Low {
  std::shared_ptr<Low> parent;
  int who = kNone;
  int where = kNone;
  std::size_t depth = 0;
};

/// A node of the high level.
struct High {
  Places places;
  High* parent = nullptr;
  std::vector<std::size_t> order;
  std::vector<double> priorities;
  std::queue<std::shared_ptr<Low>> tree;
};

class Paper {
 public:
  Paper(const grid::GridProblem& problem, std::uint64_t seed) : random_(seed) {
    const grid::GridMap& map = problem.map;
    std::vector<int> number(map.open.size(), kNone);
    std::vector<grid::Cell> cells;
    for (int y = 0; y < map.rows; ++y) {
      for (int x = 0; x < map.columns; ++x) {
        if (!map.is_open({x, y})) continue;
        number[map.index({x, y})] = static_cast<int>(cells.size());
        cells.push_back({x, y});
      }
    }
    for (const grid::Cell cell : cells) {
      std::vector<int>& beside = beside_.emplace_back();
      for (const grid::Cell next :
           {grid::Cell{cell.x - 1, cell.y}, grid::Cell{cell.x + 1, cell.y},
            grid::Cell{cell.x, cell.y - 1}, grid::Cell{cell.x, cell.y + 1}}) {
        if (map.is_open(next)) beside.push_back(number[map.index(next)]);
      }
    }
    for (const grid::GridAgent& agent : problem.agents) {
      starts_.push_back(number[map.index(agent.from)]);
      goals_.push_back(number[map.index(agent.to)]);
      distances_.emplace_back(cells.size(), kNone);
      distances_.back()[static_cast<std::size_t>(goals_.back())] = 0;
      border_.push_back({goals_.back()});
    }
    now_.assign(cells.size(), kNone);
    next_.assign(cells.size(), kNone);
  }

  PaperSolution run(std::int64_t limit) {
    PaperSolution solution;
    std::deque<High> nodes;
    std::unordered_map<Places, High*, PlacesHash> explored;
    std::vector<High*> open;
    const auto add = [&](Places places, High* parent) {
      High& node = nodes.emplace_back();
      node.places = std::move(places);
      node.parent = parent;
      node.tree.push(std::make_shared<Low>());
      set_order(node);
      explored.emplace(node.places, &node);
      open.push_back(&node);
    };
    add(starts_, nullptr);
    while (!open.empty() && static_cast<std::int64_t>(nodes.size()) < limit) {
      High* const node = open.back();
      if (node->places == goals_) {
        solution.solved = true;
        solution.cost = cost_of(node);
        break;
      }
      if (node->tree.empty()) {
        open.pop_back();
        continue;
      }
      const std::shared_ptr<Low> low = node->tree.front();
      node->tree.pop();
      if (low->depth < goals_.size()) {
        const std::size_t who = node->order[low->depth];
        Places to = beside_[static_cast<std::size_t>(node->places[who])];
        to.push_back(node->places[who]);
        std::shuffle(to.begin(), to.end(), random_);
        for (const int where : to) {
          node->tree.push(
              std::make_shared<Low>(Low{low, static_cast<int>(who), where, low->depth + 1}));
        }
      }
      Places next = new_places(*node, low.get());
      if (next.empty()) continue;
      const auto known = explored.find(next);
      if (known != explored.end()) {
        open.push_back(known->second);
      } else {
        add(std::move(next), node);
      }
    }
    solution.nodes = static_cast<std::int64_t>(nodes.size());
    return solution;
  }

 private:
  static std::size_t of(int index) { return static_cast<std::size_t>(index); }

  int distance(std::size_t agent, int place) {
    std::vector<int>& table = distances_[agent];
    std::deque<int>& border = border_[agent];
    while (table[of(place)] == kNone && !border.empty()) {
      const int here = border.front();
      border.pop_front();
      for (const int beside : beside_[of(here)]) {
        if (table[of(beside)] != kNone) continue;
        table[of(beside)] = table[of(here)] + 1;
        border.push_back(beside);
      }
    }
    return table[of(place)];
  }

  /// At first by the distance; then who has not arrived longest goes first.
  void set_order(High& node) {
    for (std::size_t i = 0; i < goals_.size(); ++i) {
      if (node.parent == nullptr) {
        node.priorities.push_back(distance(i, node.places[i]) / 1e5);
      } else {
        const double before = node.parent->priorities[i];
        node.priorities.push_back(node.places[i] == goals_[i] ? before - std::floor(before)
                                                              : before + 1);
      }
    }
    node.order.resize(goals_.size());
    std::iota(node.order.begin(), node.order.end(), std::size_t{0});
    std::sort(node.order.begin(), node.order.end(), [&](std::size_t a, std::size_t b) {
      return node.priorities[a] > node.priorities[b];
    });
  }

  Places new_places(const High& node, const Low* low) {
    Places to(goals_.size(), kNone);
    std::fill(now_.begin(), now_.end(), kNone);
    std::fill(next_.begin(), next_.end(), kNone);
    for (std::size_t i = 0; i < to.size(); ++i) now_[of(node.places[i])] = static_cast<int>(i);
    for (; low != nullptr && low->who != kNone; low = low->parent.get()) {
      const int there = now_[of(low->where)];
      if (next_[of(low->where)] != kNone) return {};
      if (there != kNone && there != low->who && to[of(there)] == node.places[of(low->who)]) {
        return {};
      }
      to[of(low->who)] = low->where;
      next_[of(low->where)] = low->who;
    }
    for (const std::size_t agent : node.order) {
      if (to[agent] == kNone && !pibt(agent, node.places, to)) return {};
    }
    return to;
  }

  bool pibt(std::size_t agent, const Places& from, Places& to) {
    std::vector<std::pair<std::pair<int, std::uint64_t>, int>> choices;
    const auto add = [&](int place) {
      choices.push_back({{distance(agent, place), random_()}, place});
    };
    for (const int beside : beside_[of(from[agent])]) add(beside);
    add(from[agent]);
    std::sort(choices.begin(), choices.end());
    for (const auto& [key, place] : choices) {
      if (next_[of(place)] != kNone) continue;
      const int there = now_[of(place)];
      if (there != kNone && to[of(there)] == from[agent]) continue;
      to[agent] = place;
      next_[of(place)] = static_cast<int>(agent);
      if (there != kNone && of(there) != agent && to[of(there)] == kNone &&
          !pibt(of(there), from, to)) {
        continue;
      }
      return true;
    }
    to[agent] = from[agent];
    next_[of(from[agent])] = static_cast<int>(agent);
    return false;
  }

  std::int64_t cost_of(const High* node) const {
    std::vector<const High*> steps;
    for (; node != nullptr; node = node->parent) steps.push_back(node);
    std::int64_t cost = 0;
    for (std::size_t i = 0; i < goals_.size(); ++i) {
      std::size_t at_goal = 0;  // ticks from the end on
      while (at_goal < steps.size() && steps[at_goal]->places[i] == goals_[i]) ++at_goal;
      cost += static_cast<std::int64_t>(steps.size() - at_goal);
    }
    return cost;
  }

  std::mt19937_64 random_;
  std::vector<std::vector<int>> beside_;
  Places starts_, goals_;
  std::vector<std::vector<int>> distances_;
  std::vector<std::deque<int>> border_;
  std::vector<int> now_, next_;
};

}  // namespace

PaperSolution lacam_of_the_paper(const grid::GridProblem& problem, std::uint64_t seed,
                                 std::int64_t limit) {
  return Paper(problem, seed).run(limit);
}

}  // namespace rubicon::bench
