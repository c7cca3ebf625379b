#include "src/motion/travel/visibility.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "src/motion/travel/timetable.hpp"

namespace rubicon::travel {
namespace {

std::size_t nth(int index) { return static_cast<std::size_t>(index); }

/// A point of the graph; `corner` is that of the outline, which has one for each edge that starts
/// at its node, so that a point where obstacles meet is several, one for each side.
struct GraphNode {
  ExactPoint at;
  int composite = -1;
  int edge = -1;
};

int sign_towards(const LatticePoint& a, const LatticePoint& b, const ExactPoint& p) {
  return side(ExactPoint(a), ExactPoint(b), p);
}

/// Whether a direction from the node of a corner, to p, starts in its free space, edges included;
/// `sense` -1: the opposite direction.
bool admits(const Corner& corner, const ExactPoint& p, int sense) {
  const bool left_of_in = sense * sign_towards(corner.in_a, corner.in_b, p) >= 0;
  const bool left_of_out = sense * sign_towards(corner.out_a, corner.out_b, p) >= 0;
  return turn(corner.in_a, corner.in_b, corner.out_a, corner.out_b) > 0 ? left_of_in && left_of_out
                                                                        : left_of_in || left_of_out;
}

/// Whether the way from a to b, which are not the same, enters an obstacle between them.
bool is_blocked(const Composite& composite, const ExactPoint& a, const ExactPoint& b) {
  std::vector<int> sides;
  sides.reserve(composite.nodes.size());
  bool left = false;
  bool right = false;
  for (const ExactPoint& node : composite.nodes) {
    sides.push_back(side(a, b, node));
    left = left || sides.back() >= 0;
    right = right || sides.back() <= 0;
  }
  if (!left || !right) return false;
  const auto between = [&](const ExactPoint& p) { return compare(a, p) * compare(p, b) > 0; };
  for (std::size_t i = 0; i < composite.edges.size(); ++i) {
    const Edge& edge = composite.edges[i];
    const int at_from = sides[nth(edge.from)];
    const int at_to = sides[nth(edge.to)];
    if (at_from * at_to < 0) {
      // The edge crosses the line of the way; the way crosses that of the edge between a and b?
      if (sign_towards(edge.line_a, edge.line_b, a) * sign_towards(edge.line_a, edge.line_b, b) <
          0) {
        return true;
      }
      continue;
    }
    if (at_from != 0 || !between(composite.nodes[nth(edge.from)])) continue;
    const Corner corner = corner_before(composite, static_cast<int>(i));
    const bool forward = admits(corner, b, 1);
    const bool backward = admits(corner, a, 1);
    if (forward != backward) return true;
  }
  return false;
}

/// Whether the way from a node of the graph to p starts in free space.
bool starts_free(const Outline& outline, const GraphNode& node, const ExactPoint& p) {
  if (node.edge >= 0) {
    const Composite& composite = outline.composites()[nth(node.composite)];
    return admits(corner_before(composite, node.edge), p, 1);
  }
  // The start or the destination; where it is on an outline, that decides.
  for (const Composite& composite : outline.composites()) {
    bool on_node = false;
    bool free = false;
    for (std::size_t i = 0; i < composite.edges.size(); ++i) {
      const Edge& edge = composite.edges[i];
      const ExactPoint& from = composite.nodes[nth(edge.from)];
      const ExactPoint& to = composite.nodes[nth(edge.to)];
      if (compare(from, node.at) == 0) {
        on_node = true;
        free = free || admits(corner_before(composite, static_cast<int>(i)), p, 1);
      } else if (sign_towards(edge.line_a, edge.line_b, node.at) == 0 &&
                 compare(from, node.at) * compare(node.at, to) > 0) {
        return sign_towards(edge.line_a, edge.line_b, p) >= 0;
      }
    }
    if (on_node) return free;
  }
  return true;
}

bool see_each_other(const Outline& outline, const GraphNode& a, const GraphNode& b) {
  if (compare(a.at, b.at) == 0) return false;
  if (!starts_free(outline, a, b.at) || !starts_free(outline, b, a.at)) return false;
  return std::none_of(outline.composites().begin(), outline.composites().end(),
                      [&](const Composite& composite) {
                        return !composite.pieces.empty() && is_blocked(composite, a.at, b.at);
                      });
}

std::vector<GraphNode> graph_nodes(const Outline& outline, const LatticePoint& start,
                                   const LatticePoint& destination) {
  std::vector<GraphNode> nodes{{ExactPoint(start), -1, -1}, {ExactPoint(destination), -1, -1}};
  for (std::size_t c = 0; c < outline.composites().size(); ++c) {
    const Composite& composite = outline.composites()[c];
    for (std::size_t i = 0; i < composite.edges.size(); ++i) {
      const Corner corner = corner_before(composite, static_cast<int>(i));
      // A shortest way turns only where the outline turns right.
      if (turn(corner.in_a, corner.in_b, corner.out_a, corner.out_b) >= 0) continue;
      nodes.push_back({composite.nodes[nth(composite.edges[i].from)], static_cast<int>(c),
                       static_cast<int>(i)});
    }
  }
  return nodes;
}

/// Dijkstra from node 0 to node 1; the nodes on the way.
std::vector<int> cheapest(const std::vector<Vec2>& nodes,
                          const std::vector<std::pair<int, int>>& edges, double& length) {
  std::vector<std::vector<int>> neighbours(nodes.size());
  for (const auto& [a, b] : edges) {
    neighbours[nth(a)].push_back(b);
    neighbours[nth(b)].push_back(a);
  }
  std::vector<double> cost(nodes.size(), std::numeric_limits<double>::infinity());
  std::vector<int> before(nodes.size(), -1);
  std::vector<bool> done(nodes.size(), false);
  cost[0] = 0;
  while (true) {
    int next = -1;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!done[i] && std::isfinite(cost[i]) && (next < 0 || cost[i] < cost[nth(next)])) {
        next = static_cast<int>(i);
      }
    }
    if (next < 0) return {};
    if (next == 1) break;
    done[nth(next)] = true;
    for (const int other : neighbours[nth(next)]) {
      const double through = cost[nth(next)] + (nodes[nth(other)] - nodes[nth(next)]).norm();
      if (through >= cost[nth(other)]) continue;
      cost[nth(other)] = through;
      before[nth(other)] = next;
    }
  }
  length = cost[1];
  std::vector<int> way;
  for (int node = 1; node >= 0; node = before[nth(node)]) way.push_back(node);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace

VisibilityResult shortest_way(const TravelQuery& query) {
  for (const Obstacle& obstacle : query.obstacles) {
    if (obstacle.timetable.size() > 1) {
      throw std::invalid_argument("a shortest way is known among standing obstacles only");
    }
  }
  MovingOutline world(query.obstacles);
  world.move_to(0);
  const Outline& outline = world.outline();
  const LatticePoint start = snap(query.start);
  const LatticePoint destination = snap(query.destination);
  VisibilityResult result;
  const std::vector<GraphNode> nodes = graph_nodes(outline, start, destination);
  for (const GraphNode& node : nodes) result.nodes.push_back(node.at.p);
  if (outline.covers(ExactPoint(start)) || outline.covers(ExactPoint(destination))) return result;
  if (start == destination) {
    result.reached = true;
    result.way = {result.nodes[0]};
    return result;
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (std::size_t j = i + 1; j < nodes.size(); ++j) {
      if (!see_each_other(outline, nodes[i], nodes[j])) continue;
      result.edges.emplace_back(static_cast<int>(i), static_cast<int>(j));
    }
  }
  for (const int node : cheapest(result.nodes, result.edges, result.length)) {
    result.way.push_back(result.nodes[nth(node)]);
  }
  result.reached = !result.way.empty();
  return result;
}

}  // namespace rubicon::travel
