#include "src/collision/containment.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "src/collision/tolerances.hpp"
#include "src/collision/winding.hpp"

namespace rubicon::collision {
namespace {

bool deep_inside(const TriangleSoup& soup, const InsideGrid& grid, const Vec3& point,
                 double depth) {
  switch (grid.at(point)) {
    case InsideGrid::Cell::kOutside:
      return false;
    case InsideGrid::Cell::kInside:
      return !surface_within(soup, point, depth);
    case InsideGrid::Cell::kUnknown:
      break;
  }
  return winding_number(soup, point) != 0 && !surface_within(soup, point, depth);
}

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
      return soup.bounds().contains(point) &&
             deep_inside(soup, outer.inside_grids()[i], point, depth);
    };
    for (const Probe& probe : inner.probes()) {
      if (deep(probe)) return probe.point;
    }
    // Surfaces that lie in each other do not cross: between two meshes more points are asked.
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

}  // namespace

std::optional<Vec3> contained_point(const Body& a, const Body& b, const Placement& a_in_b,
                                    double contact_tolerance) {
  if (b.has_closed_soup()) {
    if (const auto probe = deep_probe(b, a, a_in_b, contact_tolerance)) return a_in_b * *probe;
  }
  if (a.has_closed_soup()) return deep_probe(a, b, a_in_b.inverse(), contact_tolerance);
  return std::nullopt;
}

bool contained(const Body& a, const Body& b, const Placement& a_in_b, double contact_tolerance) {
  return contained_point(a, b, a_in_b, contact_tolerance).has_value();
}

}  // namespace rubicon::collision
