#pragma once

#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "src/motion/guides/space.hpp"

namespace rubicon::guides {

/// Random configurations of a robot, each joined to those nearest to it. It depends on the robot
/// and on the spec alone, not on the site: whether a leg is free is asked when it is used.
struct Roadmap {
  std::vector<Point> points;
  std::vector<std::vector<int>> next_to;  ///< by point; both ways, ascending
};

Roadmap make_roadmap(const Space& space);

/// What `prm` remembers from one way to the next: the roadmap, and what was in the way. A value:
/// the roadmap does not change, so that copies share it.
struct RoadmapMemory {
  std::shared_ptr<const Roadmap> roadmap;
  std::set<int> blocked_points;
  std::set<std::pair<int, int>> blocked_legs;  ///< from, to
};

}  // namespace rubicon::guides
