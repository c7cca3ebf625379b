#include "src/motion/collision/pair/containment.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "src/motion/collision/base/tolerances.hpp"
#include "src/motion/collision/pair/surface_search.hpp"

namespace rubicon::collision {
namespace {

/// So many points of a body, or somewhat fewer, are looked at in haste.
constexpr std::size_t kFewMiddles = 48;

/// Whether a probe of one body, at `point` in the frame of a mesh of another, is deep in that.
bool deep_in(const MeshInside& mesh, const Probe& probe, const Vec3& point,
             double contact_tolerance) {
  const double depth =
      std::max(std::min(contact_tolerance, thickness_tolerance(probe.width)), kRoundingDepth);
  return mesh.soup().bounds().contains(point) && mesh.holds_deep(point, depth);
}

/// The first of the probes of `inner` that is deep in a closed mesh of `outer`, in the frame of
/// `inner`.
std::optional<Vec3> deep_probe(const Body& outer, const Body& inner, const Placement& to_outer,
                               double contact_tolerance) {
  for (const MeshInside& mesh : outer.mesh_insides()) {
    if (!mesh.soup().closed()) continue;
    for (const Probe& probe : inner.probes()) {
      if (deep_in(mesh, probe, to_outer * probe.point, contact_tolerance)) return probe.point;
    }
  }
  return std::nullopt;
}

/// The same of its points half way through, for two meshes that may be one solid.
std::optional<Vec3> deep_middle(const Body& outer, const Body& inner, const Placement& to_outer,
                                double contact_tolerance) {
  const Placement to_inner = to_outer.inverse();
  for (const MeshInside& mesh : outer.mesh_insides()) {
    if (!mesh.soup().closed()) continue;
    const Bounds& bounds = mesh.soup().bounds();
    const Vec3 centre = to_inner * bounds.centre();
    std::array<Slab, 3> slabs;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 direction = to_inner.R.col(axis);
      slabs[axis] = {direction, direction.dot(centre), bounds.half()[axis]};
    }
    ItemList found;
    inner.surface_probe_tree().collect(placed(bounds, to_inner), slabs, found);
    // The first of them, whatever the order of the tree.
    int first = -1;
    for (const int index : found) {
      if (first >= 0 && index > first) continue;
      const Probe& probe = inner.surface_probes()[static_cast<std::size_t>(index)];
      if (deep_in(mesh, probe, to_outer * probe.point, contact_tolerance)) first = index;
    }
    if (first >= 0) return inner.surface_probes()[static_cast<std::size_t>(first)].point;
  }
  return std::nullopt;
}

/// Whether one of some points half way through `inner` is deep in a closed mesh of `outer`.
bool some_middle_is_deep(const Body& outer, const Body& inner, const Placement& to_outer,
                         double contact_tolerance) {
  const std::vector<Probe>& probes = inner.surface_probes();
  const std::size_t stride = probes.size() / kFewMiddles + 1;
  for (const MeshInside& mesh : outer.mesh_insides()) {
    for (std::size_t i = 0; i < probes.size(); i += stride) {
      const Vec3 point = to_outer * probes[i].point;
      if (mesh.surely_holds(point) && deep_in(mesh, probes[i], point, contact_tolerance)) {
        return true;
      }
    }
  }
  return false;
}

/// Whether a mesh of one body comes near a mesh of the other, one of them closed.
bool surfaces_come_near(const Body& a, const Body& b, const Placement& a_in_b,
                        double contact_tolerance) {
  for (const MeshInside& mesh_a : a.mesh_insides()) {
    for (const MeshInside& mesh_b : b.mesh_insides()) {
      if (!mesh_a.soup().closed() && !mesh_b.soup().closed()) continue;
      if (SurfaceSearch(mesh_a, mesh_b, a_in_b, contact_tolerance).comes_near()) return true;
    }
  }
  return false;
}

/// A point of the surface of a mesh of `inner` that is deep in a closed one of `outer`, in the
/// frame of `outer`.
std::optional<Vec3> deep_surface(const Body& outer, const Body& inner, const Placement& to_outer,
                                 double contact_tolerance) {
  for (const MeshInside& around : outer.mesh_insides()) {
    if (!around.soup().closed()) continue;
    for (const MeshInside& mesh : inner.mesh_insides()) {
      SurfaceSearch search(mesh, around, to_outer, contact_tolerance);
      if (auto point = search.find()) return point;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Vec3> contained_point(const Body& a, const Body& b, const Placement& a_in_b,
                                    double contact_tolerance) {
  const Placement b_in_a = a_in_b.inverse();
  if (placed(a.bounds(), a_in_b).disjoint(b.bounds()) ||
      placed(b.bounds(), b_in_a).disjoint(a.bounds())) {
    return std::nullopt;
  }
  if (b.has_closed_soup()) {
    if (auto probe = deep_probe(b, a, a_in_b, contact_tolerance)) return a_in_b * *probe;
  }
  if (a.has_closed_soup()) {
    if (auto probe = deep_probe(a, b, b_in_a, contact_tolerance)) return probe;
  }
  if (!surfaces_come_near(a, b, a_in_b, contact_tolerance)) return std::nullopt;
  if (auto point = deep_middle(b, a, a_in_b, contact_tolerance)) return a_in_b * *point;
  if (auto point = deep_middle(a, b, b_in_a, contact_tolerance)) return point;
  // These points are quick; the search misses nothing.
  if (auto point = deep_surface(b, a, a_in_b, contact_tolerance)) return point;
  if (auto point = deep_surface(a, b, b_in_a, contact_tolerance)) return a_in_b * *point;
  return std::nullopt;
}

bool surely_contained(const Body& a, const Body& b, const Placement& a_in_b,
                      double contact_tolerance) {
  return some_middle_is_deep(b, a, a_in_b, contact_tolerance) ||
         some_middle_is_deep(a, b, a_in_b.inverse(), contact_tolerance);
}

bool contained(const Body& a, const Body& b, const Placement& a_in_b, double contact_tolerance) {
  return contained_point(a, b, a_in_b, contact_tolerance).has_value();
}

}  // namespace rubicon::collision
