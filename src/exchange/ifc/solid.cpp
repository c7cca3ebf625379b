#include "src/exchange/ifc/solid.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "src/motion/math/angles.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::ifc {

namespace {

using math::Vec3;

using math::at;

/// How far `to` is turned to the left of `from` about `n`, (-180, 180].
double turn_deg(const Vec3& from, const Vec3& to, const Vec3& n) {
  return math::atan2_deg(n.dot(from.cross(to)), from.dot(to));
}

/// Takes a loop apart where it comes by a corner again.
void put_simple(const Loop& loop, std::vector<Loop>& loops) {
  Loop path;
  std::map<int, std::size_t> place;
  for (const int corner : loop) {
    const auto seen = place.find(corner);
    if (seen != place.end()) {
      const auto from = static_cast<std::ptrdiff_t>(seen->second);
      loops.emplace_back(path.begin() + from, path.end());
      for (std::size_t i = seen->second; i < path.size(); ++i) place.erase(path[i]);
      path.resize(static_cast<std::size_t>(from));
    }
    place.emplace(corner, path.size());
    path.push_back(corner);
  }
  loops.push_back(std::move(path));
}

}  // namespace

std::vector<Edge> net(std::vector<Edge> edges) {
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> left;
  for (std::size_t i = 0; i < edges.size();) {
    const auto [first, last] = std::equal_range(edges.begin(), edges.end(), edges[i]);
    const auto [back, back_last] =
        std::equal_range(edges.begin(), edges.end(), Edge(edges[i].second, edges[i].first));
    for (auto k = back_last - back; k < last - first; ++k) left.push_back(edges[i]);
    i = static_cast<std::size_t>(last - edges.begin());
  }
  return left;
}

bool is_closed(const Solid& solid) {
  std::vector<Edge> edges;
  for (const auto& t : solid.triangles) {
    for (std::size_t k = 0; k < 3; ++k) edges.emplace_back(t[k], t[(k + 1) % 3]);
  }
  return !edges.empty() && net(std::move(edges)).empty();
}

double volume_of(const Solid& solid) {
  if (solid.triangles.empty()) return 0;
  const Vec3 origin = solid.points[at(solid.triangles[0][0])];
  double sum = 0;
  for (const auto& t : solid.triangles) {
    const Vec3 a = solid.points[at(t[0])] - origin;
    const Vec3 b = solid.points[at(t[1])] - origin;
    sum += a.dot(b.cross(solid.points[at(t[2])] - origin));
  }
  return sum / 6;
}

Solid welded(const Solid& solid) {
  Solid result;
  std::map<std::tuple<double, double, double>, int> known;
  std::vector<int> place;
  for (const Vec3& p : solid.points) {
    // Minus zero is zero.
    const auto [found, is_new] = known.try_emplace({p.x() + 0.0, p.y() + 0.0, p.z() + 0.0},
                                                   static_cast<int>(result.points.size()));
    if (is_new) result.points.push_back(p);
    place.push_back(found->second);
  }
  for (const auto& t : solid.triangles) {
    const std::array<int, 3> moved{place[at(t[0])], place[at(t[1])], place[at(t[2])]};
    if (moved[0] != moved[1] && moved[1] != moved[2] && moved[2] != moved[0]) {
      result.triangles.push_back(moved);
    }
  }
  return result;
}

Solid compact(const Solid& solid) {
  Solid result;
  std::map<int, int> place;
  for (const auto& t : solid.triangles) {
    std::array<int, 3> moved{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [found, is_new] = place.try_emplace(t[k], static_cast<int>(result.points.size()));
      if (is_new) result.points.push_back(solid.points[at(t[k])]);
      moved[k] = found->second;
    }
    result.triangles.push_back(moved);
  }
  return result;
}

std::optional<std::vector<Loop>> border_loops(const std::vector<Vec3>& points,
                                              std::vector<Edge> edges, const Vec3& normal) {
  const std::vector<Edge> left = net(std::move(edges));
  std::vector<char> used(left.size(), 0);
  std::vector<Loop> loops;
  for (std::size_t first = 0; first < left.size(); ++first) {
    if (used[first] != 0) continue;
    Loop loop;
    std::size_t current = first;
    while (true) {
      used[current] = 1;
      const auto [a, b] = left[current];
      loop.push_back(a);
      const auto begin = std::lower_bound(left.begin(), left.end(), Edge(b, -1));
      std::optional<std::size_t> next;
      double best = 0;
      for (auto each = begin; each != left.end() && each->first == b; ++each) {
        const auto i = static_cast<std::size_t>(each - left.begin());
        if (used[i] != 0 && i != first) continue;
        const double turn = turn_deg(points[at(b)] - points[at(a)],
                                     points[at(each->second)] - points[at(b)], normal);
        if (!next || turn > best) {
          next = i;
          best = turn;
        }
      }
      if (!next) return std::nullopt;
      if (*next == first) break;
      current = *next;
    }
    put_simple(loop, loops);
  }
  return loops;
}

}  // namespace rubicon::ifc
