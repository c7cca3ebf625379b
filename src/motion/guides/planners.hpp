#pragma once

#include <span>
#include <string>
#include <vector>

#include "src/motion/guides/guide.hpp"
#include "src/motion/guides/plan_memory.hpp"
#include "src/motion/guides/roadmap.hpp"
#include "src/motion/guides/space.hpp"

namespace rubicon::guides {

/// What a planner found: the points of the way, start first and goal last; none: no way. `nodes`
/// counts those of its trees, of the lattice those that were reached, of a roadmap all.
struct Search {
  std::vector<Point> way;
  double cost = 0;  ///< of a way over a lattice, before legs are joined
  std::size_t nodes = 0;
  std::vector<std::string> events = {};  ///< see PlanReport
  std::string cause;         ///< of no way, where it is not that the search was too short
  bool was_refused = false;  ///< and what refused its legs belongs to that
  std::vector<std::pair<Point, Point>> tree = {};  ///< see PlanReport
  bool out_of_nodes = false;  ///< it stopped at the limit of nodes or had no more, else at that of
                              ///< checks
};

/// RRT (LaValle 1998) and the three of Langari 2015, 3.3: `rrt`, `rrt_nonuniform`, `rrt_plus`,
/// `rrt_limcon`. Start and goal must stand.
Search grow_to_goal(Space& space, const Point& start, const Point& goal);

/// Two trees that are connected by legs as long as are free (Kuffner, LaValle, ICRA 2000), then
/// shortened for the least motion time. `loaded`: with the speeds of a robot that carries.
Search connect_trees(Space& space, const Point& start, const Point& goal,
                     const robot::RobotModel& model, bool loaded);

/// The cheapest way over the lattice about the goal (lattice.hpp): a leg costs its weighted length,
/// and with `safety` so many times more as nodes beside its end are blocked.
Search search_lattice(Space& space, const Point& start, const Point& goal);

/// The shortest way of a vehicle that steers over arcs and straight pieces, forwards and backwards,
/// that are as long as the diagonal of the pitch, with one way of Reeds and Shepp at its end.
/// Places and headings nearer to each other than a pitch and its turn count as one (after Dolgov,
/// Thrun, Montemerlo, Diebel, IJRR 29, 2010).
Search search_arcs(Space& space, const Point& start, const Point& goal);

/// Down a field over the lattice (potential.hpp), leg by leg, until it is at the goal or in a
/// minimum that is not the goal.
Search descend(Space& space, const Point& start, const Point& goal);

/// The shortest way over the roadmap of the memory, which is made if there is none yet.
Search search_roadmap(Space& space, const Point& start, const Point& goal, RoadmapMemory& memory);

/// The same over a lattice that is kept and repaired (repaired_lattice.hpp); without `safety`.
/// `nodes` of the result are expansions.
Search repair_lattice(Space& space, const Point& start, const Point& goal,
                      std::shared_ptr<const RepairedLattice>& memory);

/// Along a tree that is kept, cut where it is no longer free, and grown again (`drrt`).
Search search_tree(Space& space, const Point& start, const Point& goal,
                   std::shared_ptr<const GoalTree>& memory);

/// By a planner of OMPL (src/motion/ompl_bridge), whose way is then tested again, leg by leg.
Search plan_by_ompl(Space& space, const Point& start, const Point& goal);

/// The way of a vehicle in the plan view of what stands on the site: without a map (travel.hpp), or
/// the shortest (`visibility`). The machine is the disc about its place that holds it. `nodes` of
/// the result are the events of the way, or the nodes of the visibility graph.
Search travel_way(Space& space, const GuideTask& task, std::span<const double> q, const Point& goal,
                  MotionTests& tests);

/// The way with as few legs as are free of those that only go on in the same direction.
std::vector<Point> joined_legs(Space& space, const std::vector<Point>& points);

/// Makes a way shorter, where that saves motion time, by legs between places of it: `improve`
/// tests.
void shorten(Space& space, std::vector<Point>& way, const robot::RobotModel& model, bool loaded);

}  // namespace rubicon::guides
