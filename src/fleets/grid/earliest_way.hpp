#pragma once

#include <cstdint>
#include <vector>

#include "src/fleets/grid/distances.hpp"
#include "src/fleets/grid/stay_table.hpp"

namespace rubicon::grid {

/// The way of one agent that is soonest at its goal for good, between the stays of others: safe
/// interval path planning (M. Phillips and M. Likhachev, "SIPP: safe interval path planning for
/// dynamic environments", ICRA 2011) with steps of one tick.
class EarliestWay {
 public:
  EarliestWay(const CellGraph& graph, Distances& distances, const StayTable& stays);

  /// False if there is none that arrives at tick `latest` or before.
  bool find(int agent, CellId start, CellId goal, int latest, CellWay& way);

  /// Stays of the agent from which the next was sought.
  std::int64_t expansions() const { return expansions_; }

 private:
  /// In `cell` from `tick` on, in the gap between stays with this number.
  struct Visit {
    CellId cell = -1;
    int gap = 0;
    int tick = 0;
    int parent = -1;
  };
  /// A visit to go on from: first by when it can arrive, then the one that is nearest to the goal,
  /// then the one that was found last.
  struct Candidate {
    int arrival = 0;
    int distance = 0;
    int visit = -1;
    bool operator>(const Candidate& other) const {
      if (arrival != other.arrival) return arrival > other.arrival;
      if (distance != other.distance) return distance > other.distance;
      return visit < other.visit;
    }
  };
  /// When a gap was reached at first; of the search with this number.
  struct Mark {
    std::uint32_t search = 0;
    int tick = 0;
  };

  int gap_begin(CellId cell, int gap) const;
  int gap_end(CellId cell, int gap) const;
  void reach(CellId cell, int gap, int tick, int parent, int agent, int latest);
  void expand(int visit, int agent, int latest);
  bool swaps(CellId here, CellId beside, int tick) const;

  const CellGraph& graph_;
  Distances& distances_;
  const StayTable& stays_;
  std::vector<std::vector<Mark>> marks_;  ///< by cell and gap
  std::uint32_t search_ = 0;
  std::vector<Visit> visits_;
  std::vector<Candidate> open_;  ///< a heap, the best in front
  int soonest_ = 0;              ///< tick at which the goal is free for good
  std::int64_t expansions_ = 0;
};

}  // namespace rubicon::grid
