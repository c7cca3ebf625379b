#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "src/fleets/grid/cell_graph.hpp"
#include "src/fleets/grid/distances.hpp"
#include "src/fleets/grid/random_bits.hpp"

namespace rubicon::grid {

/// Where all agents are, by agent.
using Configuration = std::vector<CellId>;
/// Of an agent that has no next cell yet.
inline constexpr CellId kNowhere = -1;

/// A next cell for all agents at once, in which no two are in one cell or pass through each other:
/// priority inheritance with backtracking (K. Okumura, M. Machida, X. Defago, Y. Tamura, "Priority
/// inheritance with backtracking for iterative multi-agent path finding", Artificial Intelligence
/// 310, 2022). Each agent takes the free cell that is nearest to its goal; whoever stands there has
/// to go first. With the swap of K. Okumura, "Improving LaCAM for scalable eventually optimal
/// multi-agent pathfinding" (IJCAI 2023): two that must pass each other where there is no room for
/// that draw back until there is.
class NextMoves {
 public:
  NextMoves(const CellGraph& graph, Distances& distances, std::vector<CellId> goals);

  void set_goal(int agent, CellId goal) { goals_[static_cast<std::size_t>(agent)] = goal; }

  /// Fills what is kNowhere in `to`; the agents come in `order`. False where that failed: then `to`
  /// is of no use.
  bool find(const Configuration& from, Configuration& to, const std::vector<int>& order,
            RandomBits& random);

  /// Cells of agents from which a next cell was sought.
  std::int64_t expansions() const { return expansions_; }

 private:
  /// An agent that looks for its next cell.
  struct Seeker {
    int agent = 0;
    int count = 0;
    int tried = 0;  ///< of its candidates
    int swaps_with = -1;
    std::array<CellId, 5> candidates = {};
  };

  bool take_moves_given(const Configuration& from, const Configuration& to);
  bool seek(int agent, const Configuration& from, Configuration& to, RandomBits& random);
  Seeker seeker(int agent, const Configuration& from, const Configuration& to, RandomBits& random);
  /// The agent that has to come after to where `agent` is; -1 if it need not swap.
  int swap_partner(int agent, CellId best, const Configuration& from, const Configuration& to);
  bool must_swap(int pusher, int puller, CellId pusher_at, CellId puller_at);
  bool can_swap(CellId pusher_at, CellId puller_at) const;
  /// Where one goes on from `at` who is pushed from `behind`.
  struct WaysOn {
    int count = 0;
    CellId last = kNowhere;
  };
  WaysOn ways_on(CellId at, CellId behind) const;

  int& now(CellId cell) { return now_[static_cast<std::size_t>(cell)]; }
  int& next(CellId cell) { return next_[static_cast<std::size_t>(cell)]; }

  const CellGraph& graph_;
  Distances& distances_;
  std::vector<CellId> goals_;
  std::vector<int> now_, next_;  ///< by cell: the agent that is there, -1 for nobody
  std::vector<Seeker> seekers_;
  std::int64_t expansions_ = 0;
};

}  // namespace rubicon::grid
