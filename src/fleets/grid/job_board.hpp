#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/fleets/grid/grid_problem.hpp"
#include "src/fleets/grid/next_moves.hpp"

namespace rubicon::grid {

/// Something is to be brought from one cell to another; it may be taken from tick `arrives` on.
struct GridJob {
  std::string name;
  Cell from;
  Cell to;
  int arrives = 0;
};

/// What became of a job. Ticks; -1 for what did not happen.
struct JobRecord {
  int vehicle = -1;
  int taken = -1;
  int picked = -1;
  int delivered = -1;
};

/// Jobs between cells that all vehicles can reach, drawn evenly: both ends, which differ, of each.
/// Job `i` arrives at tick i x `interval`. Called j1, j2, ... Empty where a vehicle can reach no
/// two cells.
std::vector<GridJob> draw_jobs(const GridProblem& problem, std::size_t count, double interval,
                               std::uint64_t seed);

/// What is wrong with jobs; those of the vehicles beside that faults_of() finds. `agent` is the
/// number of the job.
std::vector<GridFault> faults_of_jobs(const GridProblem& problem, const std::vector<GridJob>& jobs);

/// Who has which job. Jobs are given out in the order in which they arrive, then in that of the
/// list: each to the vehicle without a job that has the fewest steps to it, of equal ones to the
/// first. A vehicle has one job at a time.
class JobBoard {
 public:
  JobBoard(const CellGraph& graph, const std::vector<GridJob>& jobs, std::size_t vehicles);

  /// Gives jobs out; the vehicles that got one.
  const std::vector<int>& give(int tick, const Configuration& cells);
  /// A vehicle is where it is: whether it has picked up or delivered there.
  bool arrive(int vehicle, int tick, CellId cell);

  int job_of(int vehicle) const { return job_of_[at(vehicle)]; }  ///< -1: none
  CellId from(int job) const { return from_[at(job)]; }
  CellId to(int job) const { return to_[at(job)]; }
  std::size_t delivered() const { return delivered_; }
  bool is_done() const { return delivered_ == jobs_.size(); }
  /// Whether jobs wait for nothing but a vehicle, or are under way.
  bool is_idle() const;
  const std::vector<JobRecord>& records() const { return records_; }

 private:
  int nearest_free(CellId cell);

  const CellGraph& graph_;
  const std::vector<GridJob>& jobs_;
  std::vector<CellId> from_, to_;
  std::vector<int> order_;  ///< of jobs, by when they arrive
  std::size_t given_ = 0;   ///< of them
  std::size_t delivered_ = 0;
  std::vector<JobRecord> records_;
  std::vector<int> job_of_;  ///< by vehicle
  std::size_t free_;         ///< vehicles without a job
  std::vector<int> got_;
  std::vector<int> there_;  ///< by cell: a free vehicle, -1 for none
  std::vector<std::uint32_t> seen_;
  std::uint32_t search_ = 0;
  std::vector<CellId> border_, next_;
};

}  // namespace rubicon::grid
