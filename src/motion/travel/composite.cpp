#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "src/motion/travel/outline.hpp"

namespace rubicon::travel {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// A piece of an edge of a ring between two nodes, in the sense of the ring.
struct Stretch {
  int from = 0;
  int to = 0;
  Owner owner;

  std::tuple<int, int, int, Owner> order() const {
    return {std::min(from, to), std::max(from, to), from, owner};
  }
};

class CompositeBuilder {
 public:
  CompositeBuilder(const std::vector<Piece>& pieces, const std::vector<const Contact*>& contacts)
      : pieces_(pieces), contacts_(contacts) {}

  Composite build(std::vector<int> members) {
    result_.pieces = std::move(members);
    find_nodes();
    find_stretches();
    keep_outer_stretches();
    link();
    find_loops();
    return std::move(result_);
  }

 private:
  struct Mark {  ///< a point on an edge of a piece
    Owner owner;
    int node = 0;
  };

  const Ring& ring(int piece) const { return pieces_[at(piece)].ring; }

  void find_nodes() {
    std::vector<ExactPoint> points;
    std::vector<Mark> marks;
    const auto mark = [&](const Owner& owner) {
      marks.push_back({owner, static_cast<int>(points.size()) - 1});
    };
    result_.box = box_of(ring(result_.pieces.front()));
    for (const int piece : result_.pieces) {
      result_.box.include(box_of(ring(piece)));
      const int size = static_cast<int>(ring(piece).size());
      for (int i = 0; i < size; ++i) {
        points.emplace_back(ring(piece)[at(i)]);
        mark({piece, i});
        mark({piece, i == 0 ? size - 1 : i - 1});
      }
    }
    for (const Contact* contact : contacts_) {
      neighbours_[contact->a].push_back(contact->b);
      neighbours_[contact->b].push_back(contact->a);
      for (const Meeting& meeting : contact->meetings) {
        points.push_back(meeting.at);
        mark({contact->a, meeting.edge_a});
        mark({contact->b, meeting.edge_b});
      }
    }
    std::vector<int> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&points](int a, int b) {
      const int by_place = compare(points[at(a)], points[at(b)]);
      return by_place != 0 ? by_place < 0 : a < b;
    });
    // Points that are the same, exactly, become one node, whichever edges they were found on.
    std::vector<int> node_of(points.size());
    for (const int point : order) {
      if (result_.nodes.empty() || compare(result_.nodes.back(), points[at(point)]) != 0) {
        result_.nodes.push_back(points[at(point)]);
      }
      node_of[at(point)] = static_cast<int>(result_.nodes.size()) - 1;
    }
    for (Mark& each : marks) each.node = node_of[at(each.node)];
    marks_ = std::move(marks);
  }

  /// Nodes are ordered by x, then y, so along an edge their numbers rise or fall.
  void find_stretches() {
    std::sort(marks_.begin(), marks_.end(), [](const Mark& a, const Mark& b) {
      return std::tie(a.owner, a.node) < std::tie(b.owner, b.node);
    });
    for (std::size_t i = 0; i + 1 < marks_.size(); ++i) {
      const Mark& a = marks_[i];
      const Mark& b = marks_[i + 1];
      if (a.owner != b.owner || a.node == b.node) continue;
      const Ring& corners = ring(a.owner.piece);
      const LatticePoint& start = corners[at(a.owner.edge)];
      const LatticePoint& end = next_corner(corners, at(a.owner.edge));
      const bool rises = std::tie(start.x, start.y) < std::tie(end.x, end.y);
      stretches_.push_back({rises ? a.node : b.node, rises ? b.node : a.node, a.owner});
    }
    std::sort(stretches_.begin(), stretches_.end(),
              [](const Stretch& a, const Stretch& b) { return a.order() < b.order(); });
  }

  void keep_outer_stretches() {
    for (std::size_t first = 0; first < stretches_.size();) {
      std::size_t end = first;
      bool both_sides = false;
      while (end < stretches_.size() && same_place(stretches_[first], stretches_[end])) {
        both_sides = both_sides || stretches_[end].from != stretches_[first].from;
        ++end;
      }
      if (!both_sides && !covered(first, end)) add_edge(first, end);
      first = end;
    }
  }

  static bool same_place(const Stretch& a, const Stretch& b) {
    return std::minmax(a.from, a.to) == std::minmax(b.from, b.to);
  }

  bool covered(std::size_t first, std::size_t end) const {
    const Stretch& stretch = stretches_[first];
    const auto found = neighbours_.find(stretch.owner.piece);
    if (found == neighbours_.end()) return false;
    for (const int other : found->second) {
      const bool owns =
          std::any_of(stretches_.begin() + static_cast<std::ptrdiff_t>(first),
                      stretches_.begin() + static_cast<std::ptrdiff_t>(end),
                      [other](const Stretch& shared) { return shared.owner.piece == other; });
      if (!owns && place_of_middle(result_.nodes[at(stretch.from)], result_.nodes[at(stretch.to)],
                                   ring(other)) > 0) {
        return true;
      }
    }
    return false;
  }

  void add_edge(std::size_t first, std::size_t end) {
    const Stretch& stretch = stretches_[first];
    const Ring& corners = ring(stretch.owner.piece);
    Edge edge;
    edge.from = stretch.to;
    edge.to = stretch.from;
    edge.line_a = next_corner(corners, at(stretch.owner.edge));
    edge.line_b = corners[at(stretch.owner.edge)];
    edge.length = (result_.nodes[at(edge.to)].p - result_.nodes[at(edge.from)].p).norm();
    edge.heading = (metres(edge.line_b) - metres(edge.line_a)).normalized();
    edge.owner = stretch.owner;
    for (std::size_t i = first + 1; i < end; ++i) edge.co_owners.push_back(stretches_[i].owner);
    result_.edges.push_back(std::move(edge));
  }

  /// Whether direction v comes before w in turning clockwise from r; none is along r.
  static bool sooner_clockwise(const LatticePoint& r, const LatticePoint& v,
                               const LatticePoint& w) {
    constexpr LatticePoint kZero{0, 0};
    const int side_v = turn(kZero, r, kZero, v);
    const int side_w = turn(kZero, r, kZero, w);
    // Right of r come the first 180 degrees, then what is opposite, then what is left of it.
    if (side_v != side_w) return side_v < side_w;
    return turn(kZero, v, kZero, w) < 0;
  }

  void link() {
    std::vector<std::vector<int>> leaving(result_.nodes.size());
    for (std::size_t i = 0; i < result_.edges.size(); ++i) {
      leaving[at(result_.edges[i].from)].push_back(static_cast<int>(i));
    }
    result_.pinch.assign(result_.nodes.size(), false);
    for (std::size_t node = 0; node < leaving.size(); ++node) {
      result_.pinch[node] = leaving[node].size() > 1;
    }
    for (std::size_t i = 0; i < result_.edges.size(); ++i) {
      Edge& edge = result_.edges[i];
      const LatticePoint back{edge.line_a.x - edge.line_b.x, edge.line_a.y - edge.line_b.y};
      int best = -1;
      LatticePoint best_way;
      for (const int candidate : leaving[at(edge.to)]) {
        const Edge& next = result_.edges[at(candidate)];
        const LatticePoint way{next.line_b.x - next.line_a.x, next.line_b.y - next.line_a.y};
        if (best >= 0 && !sooner_clockwise(back, way, best_way)) continue;
        best = candidate;
        best_way = way;
      }
      edge.next = best;
      result_.edges[at(best)].previous = static_cast<int>(i);
    }
  }

  void find_loops() {
    for (Edge& edge : result_.edges) edge.loop = -1;
    for (std::size_t first = 0; first < result_.edges.size(); ++first) {
      if (result_.edges[first].loop >= 0) continue;
      Loop loop;
      loop.first = static_cast<int>(first);
      const Vec2 origin = result_.nodes[at(result_.edges[first].from)].p;
      double twice_area = 0;
      int index = loop.first;
      do {
        Edge& edge = result_.edges[at(index)];
        edge.loop = static_cast<int>(result_.loops.size());
        loop.length += edge.length;
        const Vec2 a = result_.nodes[at(edge.from)].p - origin;
        const Vec2 b = result_.nodes[at(edge.to)].p - origin;
        twice_area += a.x() * b.y() - a.y() * b.x();
        index = edge.next;
      } while (index != loop.first);
      loop.hole = twice_area > 0;
      result_.loops.push_back(loop);
    }
  }

  const std::vector<Piece>& pieces_;
  const std::vector<const Contact*>& contacts_;
  std::map<int, std::vector<int>> neighbours_;
  std::vector<Mark> marks_;
  std::vector<Stretch> stretches_;
  Composite result_;
};

}  // namespace

Composite build_composite(const std::vector<Piece>& pieces, std::vector<int> members,
                          const std::vector<const Contact*>& contacts) {
  return CompositeBuilder(pieces, contacts).build(std::move(members));
}

Corner corner_before(const Composite& composite, int edge) {
  const Edge& out = composite.edges[at(edge)];
  const Edge& in = composite.edges[at(out.previous)];
  return {in.line_a, in.line_b, out.line_a, out.line_b};
}

bool Corner::opens_to(const Aim& aim) const {
  const bool left_of_in = side(in_a, in_b, aim) > 0;
  const bool left_of_out = side(out_a, out_b, aim) > 0;
  // Where the walk turns left the free space is left of both edges, else left of either.
  return turn(in_a, in_b, out_a, out_b) > 0 ? left_of_in && left_of_out : left_of_in || left_of_out;
}

bool Corner::admits(const Aim& aim, bool backward) const {
  const int sense = backward ? -1 : 1;
  const bool left_of_in = sense * side(in_a, in_b, aim) >= 0;
  const bool left_of_out = sense * side(out_a, out_b, aim) >= 0;
  return turn(in_a, in_b, out_a, out_b) > 0 ? left_of_in && left_of_out : left_of_in || left_of_out;
}

}  // namespace rubicon::travel
