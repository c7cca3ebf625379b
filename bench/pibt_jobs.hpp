#pragma once

#include <cstdint>
#include <vector>

#include "src/fleets/grid/job_board.hpp"

namespace rubicon::bench {

/// The baseline for vehicles that do jobs on cells: priority inheritance with backtracking by its
/// published rule (K. Okumura, M. Machida, X. Defago, Y. Tamura, Artificial Intelligence 310, 2022,
/// algorithm 1), one tick after the other and without looking ahead. A vehicle's priority grows by
/// one each tick until it is where it wants to be; then it is what it was at first, a share below
/// one that no two have in common. The cells to try come by their distance, of equal ones those
/// where nobody is, then by chance. Nothing of it is shared with NextMoves. Jobs are given out by
/// the same JobBoard.
class PibtJobs {
 public:
  PibtJobs(const grid::GridProblem& problem, const std::vector<grid::GridJob>& jobs,
           std::uint64_t seed);
  /// One tick; false when all jobs are delivered, or none will be.
  bool advance();
  int ticks() const { return now_; }
  const grid::JobBoard& board() const { return board_; }

 private:
  bool assign(std::size_t vehicle, int pushed_by);
  int goal_row(std::size_t vehicle) const;

  grid::CellGraph graph_;
  grid::Configuration cells_;
  grid::JobBoard board_;
  grid::Distances distances_;
  grid::RandomBits random_;
  std::vector<int> leg_;
  std::vector<double> first_, priority_;
  std::vector<int> here_, next_here_;
  grid::Configuration next_;
  std::vector<std::size_t> order_;
  int now_ = 0;
  int last_arrival_ = 0;
};

}  // namespace rubicon::bench
