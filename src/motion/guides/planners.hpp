#pragma once

#include <vector>

#include "src/motion/guides/space.hpp"

namespace rubicon::guides {

/// What a planner found: the points of the way, start first and goal last; none: no way. `nodes`
/// counts those of its trees.
struct Search {
  std::vector<Point> way;
  std::size_t nodes = 0;
  bool out_of_nodes = false;  ///< it stopped at the limit of nodes, else at that of checks
};

/// RRT (LaValle 1998) and the three of Langari 2015, 3.3: `rrt`, `rrt_nonuniform`, `rrt_plus`,
/// `rrt_limcon`. Start and goal must stand.
Search grow_to_goal(Space& space, const Point& start, const Point& goal);

/// Two trees that are connected by legs as long as are free (Kuffner, LaValle, ICRA 2000), then
/// shortened for the least motion time. `loaded`: with the speeds of a robot that carries.
Search connect_trees(Space& space, const Point& start, const Point& goal,
                     const robot::RobotModel& model, bool loaded);

}  // namespace rubicon::guides
