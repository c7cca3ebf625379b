#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "src/fleets/grid/distances.hpp"
#include "src/fleets/grid/random_bits.hpp"
#include "src/fleets/grid/window_table.hpp"

namespace rubicon::grid {

/// Where a vehicle has to go, one place after the other: those from `first` to before `last`.
/// The distance to place `i` is goal `row` + i of the Distances.
struct Legs {
  std::array<CellId, 2> places = {-1, -1};
  int first = 0;
  int last = 0;
  int row = 0;

  CellId goal(int leg) const { return places[at(leg)]; }
  /// Which place comes next for who is in `cell` and was on its way to place `leg`.
  int after(int leg, CellId cell) const {
    while (leg < last && places[at(leg)] == cell) ++leg;
    return leg;
  }
  /// Steps from `cell` over all places that are left.
  int left(Distances& distances, int leg, CellId cell) const {
    if (leg >= last) return 0;
    int steps = distances.to_goal(row + leg, cell);
    for (int next = leg + 1; next < last; ++next) {
      steps += distances.to_goal(row + next, places[at(next - 1)]);
    }
    return steps;
  }
};

/// Ticks until all places were reached, as far as the window says; beyond it as if the vehicle were
/// alone.
int cost_of(const WindowWay& way, const Legs& legs, Distances& distances);

/// The way of one vehicle of the least cost between those of a table, to the end of the window:
/// A* over cells and ticks (D. Silver, "Cooperative pathfinding", AIIDE 2005), over one place after
/// the other.
class WindowSearch {
 public:
  WindowSearch(const CellGraph& graph, Distances& distances, const WindowTable& table, int window);

  /// The vehicle is in `start` and stands there for `ready` ticks more. False if there is no way,
  /// or none was found with the work that one search may take: then `way` is as it was.
  bool find(CellId start, int ready, const Legs& legs, RandomBits& random, WindowWay& way);

  /// Cells at one tick from which the next were sought.
  std::int64_t expansions() const { return expansions_; }

 private:
  struct Visit {
    CellId cell = -1;
    int tick = 0;
    int leg = 0;
    int cost = 0;
    int parent = -1;
  };
  /// A visit to go on from: first by its cost, then the latest, then by chance.
  struct Candidate {
    int cost = 0;
    int tick = 0;
    std::uint32_t chance = 0;
    int visit = -1;
    bool operator>(const Candidate& other) const {
      if (cost != other.cost) return cost > other.cost;
      if (tick != other.tick) return tick < other.tick;
      return chance != other.chance ? chance > other.chance : visit > other.visit;
    }
  };
  struct Mark {
    std::uint32_t search = 0;
    CellId cell = -1;
    int tick = 0;
    int leg = 0;
  };

  bool is_new(CellId cell, int tick, int leg);
  void reach(CellId cell, int tick, int leg, int cost, int parent, std::uint32_t chance);

  const CellGraph& graph_;
  Distances& distances_;
  const WindowTable& table_;
  int window_;
  std::vector<Mark> marks_;  ///< a hash table, by search
  std::uint32_t search_ = 0;
  std::vector<Visit> visits_;
  std::vector<Candidate> open_;  ///< a heap, the best in front
  std::int64_t expansions_ = 0;
};

}  // namespace rubicon::grid
