#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "src/fleets/grid/job_board.hpp"

namespace rubicon::grid {

/// Work for each job when nothing else is said, in expansions.
inline constexpr std::int64_t kUsualPerJob = 20'000;
inline constexpr int kLongestWindow = 200;
inline constexpr int kLongestStand = 1'000;
/// Most open cells times ticks of a window, each with 4 bytes.
inline constexpr std::int64_t kMostInWindow = 100'000'000;

struct JobQuery {
  std::int64_t expansions = 0;  ///< in all; 0: kUsualPerJob for each job
  std::uint64_t seed = 1;
  int window = 30;  ///< ticks that are planned ahead
  /// Of the moves so many, as a share, end late: the vehicle then stands for 0 to `late_ticks`
  /// more, evenly. The planner sees that it stands, and not for how long.
  double late = 0;
  int late_ticks = 0;
};

/// A vehicle that came to its cell at `tick` stood there for `ticks` before it could go on.
struct Stand {
  int vehicle = -1;
  int tick = 0;
  int ticks = 0;
};

struct JobsResult {
  enum class End {
    running,
    done,       ///< all jobs are delivered
    standstill  ///< for a long time no job got on
  };
  End end = End::running;
  int ticks = 0;
  std::vector<std::string> ways;   ///< by vehicle, one letter a tick: r, l, d, u, w
  std::vector<JobRecord> records;  ///< by job
  std::vector<Stand> stands;
  std::vector<int> stuck;   ///< standstill: the vehicles with a job
  std::int64_t moves = 0;   ///< of all vehicles
  std::int64_t stood = 0;   ///< ticks in which vehicles with a job stood because a move ended late
  std::int64_t waited = 0;  ///< ticks in which vehicles with a job waited for others
  std::int64_t with_job = 0;  ///< ticks in which vehicles had a job
  std::int64_t least = 0;     ///< ticks of all jobs, from taken to delivered, as if alone
  std::int64_t expansions = 0;
  int pressed = 0;  ///< ticks in which all made way for a late vehicle
};

/// Vehicles on cells do jobs, and get new ones while others drive. Each tick the ways of all are
/// known to the end of a window, free of conflicts. Then the window moves on: the tick that comes
/// in is filled by NextMoves (PIBT); who has a new goal plans anew between the others, and so do
/// small groups of those that are not on their best way, while there is work left; what is not
/// worse is kept. (Rolling horizon: J. Li and others, "Lifelong multi-agent path finding in
/// large-scale warehouses", AAAI 2021; filled by PIBT and improved: H. Jiang and others, "Scaling
/// lifelong multi-agent path finding to more realistic settings", SoCS 2024.) What a way says of
/// times is not kept when a move ends late: the order at each cell is (KeepOrder). For a vehicle
/// that has taken far too long LaCAM finds ways for all that get it to its place, if there are any;
/// they are driven until it is there.
class JobTraffic {
 public:
  /// Of a problem and of jobs that faults_of() and faults_of_jobs() find nothing in. An agent
  /// without a job goes to its own goal.
  JobTraffic(const GridProblem& problem, const std::vector<GridJob>& jobs, const JobQuery& query);
  ~JobTraffic();
  JobTraffic(const JobTraffic&) = delete;
  JobTraffic& operator=(const JobTraffic&) = delete;

  /// Plans and moves one tick; false when it has ended.
  bool advance();
  const JobBoard& board() const;
  JobsResult take_result();

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// All of it.
JobsResult do_jobs(const GridProblem& problem, const std::vector<GridJob>& jobs,
                   const JobQuery& query);

}  // namespace rubicon::grid
