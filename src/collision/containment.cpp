#include "src/collision/containment.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "src/collision/surface_search.hpp"
#include "src/collision/tolerances.hpp"

namespace rubicon::collision {
namespace {

/// The first of the probes of `inner` that is deep in a closed mesh of `outer`, in the frame of
/// `inner`.
std::optional<Vec3> deep_probe(const Body& outer, const Body& inner, const Placement& to_outer,
                               double contact_tolerance) {
  for (std::size_t i = 0; i < outer.soups().size(); ++i) {
    const TriangleSoup& soup = outer.soups()[i];
    if (!soup.closed()) continue;
    const auto deep = [&](const Probe& probe) {
      const double depth =
          std::max(std::min(contact_tolerance, thickness_tolerance(probe.width)), kRoundingDepth);
      const Vec3 point = to_outer * probe.point;
      return soup.bounds().contains(point) && outer.mesh_insides()[i].holds_deep(point, depth);
    };
    for (const Probe& probe : inner.probes()) {
      if (deep(probe)) return probe.point;
    }
    // Two meshes may be the same solid: a point within each part of it is asked.
    if (inner.surface_probe_tree().size() == 0) continue;
    const Placement to_inner = to_outer.inverse();
    const Vec3 centre = to_inner * soup.bounds().centre();
    std::array<Slab, 3> slabs;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 direction = to_inner.R.col(axis);
      slabs[axis] = {direction, direction.dot(centre), soup.bounds().half()[axis]};
    }
    ItemList found;
    inner.surface_probe_tree().collect(placed(soup.bounds(), to_inner), slabs, found);
    // The first of them, whatever the order of the tree.
    int first = -1;
    for (const int index : found) {
      if (first >= 0 && index > first) continue;
      if (deep(inner.surface_probes()[static_cast<std::size_t>(index)])) first = index;
    }
    if (first >= 0) return inner.surface_probes()[static_cast<std::size_t>(first)].point;
  }
  return std::nullopt;
}

/// A point of the surface of a mesh of `inner` that is deep in a closed one of `outer`, in the
/// frame of `outer`.
std::optional<Vec3> deep_surface(const Body& outer, const Body& inner, const Placement& to_outer,
                                 double contact_tolerance) {
  for (const MeshInside& around : outer.mesh_insides()) {
    if (!around.soup().closed()) continue;
    for (const MeshInside& mesh : inner.mesh_insides()) {
      SurfaceSearch search(mesh, around, to_outer, contact_tolerance);
      if (const auto point = search.find()) return point;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Vec3> contained_point(const Body& a, const Body& b, const Placement& a_in_b,
                                    double contact_tolerance) {
  const Placement b_in_a = a_in_b.inverse();
  if (b.has_closed_soup()) {
    if (const auto probe = deep_probe(b, a, a_in_b, contact_tolerance)) return a_in_b * *probe;
  }
  if (a.has_closed_soup()) {
    if (const auto probe = deep_probe(a, b, b_in_a, contact_tolerance)) return probe;
  }
  // Their points are quick; the search misses nothing.
  if (const auto point = deep_surface(b, a, a_in_b, contact_tolerance)) return point;
  if (const auto point = deep_surface(a, b, b_in_a, contact_tolerance)) return a_in_b * *point;
  return std::nullopt;
}

bool contained(const Body& a, const Body& b, const Placement& a_in_b, double contact_tolerance) {
  return contained_point(a, b, a_in_b, contact_tolerance).has_value();
}

}  // namespace rubicon::collision
