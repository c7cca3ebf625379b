#include <algorithm>
#include <array>

#include "src/motion/collision/base/tolerances.hpp"
#include "src/motion/collision/convex/convex.hpp"
#include "src/motion/collision/pair/surface_search.hpp"
#include "src/motion/collision/tree/kernels.hpp"

// Where the surfaces of two meshes come near each other at all.

namespace rubicon::collision {
namespace {

/// Whether the box around a pack is apart from a moved box by the axes of either.
bool boxes_apart(const Bounds& pack, const Bounds& around_moved, const Bounds& own,
                 const Placement& to_own, double reach) {
  Bounds grown = pack;
  grown.grow(Vec3::Constant(reach));
  if (grown.disjoint(around_moved)) return true;
  return placed(grown, to_own).disjoint(own);
}

}  // namespace

void SurfaceSearch::collect_packs() {
  const Bounds& bounds = inner_.soup().bounds();
  const double reach = contact_tolerance_ + kBoundsMargin;
  const Vec3 centre = to_outer_ * bounds.centre();
  std::array<Slab, 3> slabs;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 direction = to_outer_.R.col(axis);
    slabs[axis] = {direction, direction.dot(centre), bounds.half()[axis] + reach};
  }
  Bounds around = placed(bounds, to_outer_);
  around.grow(Vec3::Constant(reach));
  ItemList found;
  outer_.soup().pack_tree().collect(around, slabs, found);
  packs_.assign(found.begin(), found.end());
  // The order of the tree is not that of the mesh.
  std::sort(packs_.begin(), packs_.end());
}

bool SurfaceSearch::comes_near() {
  collect_packs();
  return !packs_.empty() && node_comes_near(0, 0);
}

/// Adds those packs of `outer` of the last list, which begins at `begin`, that come near a node as
/// a list of their own.
void SurfaceSearch::add_packs_near(const TriangleSoup::Node& node, std::size_t begin) {
  const Bounds around = placed(node.bounds, to_outer_);
  const double reach = contact_tolerance_ + kBoundsMargin;
  const std::size_t end = packs_.size();
  for (std::size_t i = begin; i < end; ++i) {
    const int pack = packs_[i];
    const Bounds& bounds = outer_.soup().pack_bounds()[static_cast<std::size_t>(pack)];
    if (!boxes_apart(bounds, around, node.bounds, to_inner_, reach)) packs_.push_back(pack);
  }
}

/// A triangle of `inner`, grown by the contact tolerance, as the kernels look at it.
TrianglePass SurfaceSearch::reaching(int triangle) const {
  TrianglePass pass;
  std::array<Vec3, 3> corners;
  for (int k = 0; k < 3; ++k) corners[k] = to_outer_ * inner_.soup().corner(triangle, k);
  for (int k = 0; k < 3; ++k) {
    const Vec3 edge = corners[(k + 1) % 3] - corners[k];
    for (int axis = 0; axis < 3; ++axis) {
      pass.start[k][axis] = pass.end[k][axis] = corners[k][axis];
      pass.edges[k][axis] = edge[axis];
    }
    pass.growth_axis[k] = 0;
  }
  pass.uniform_growth = contact_tolerance_ + kBoundsMargin;
  return pass;
}

bool SurfaceSearch::node_comes_near(int node, std::size_t begin) {
  const TriangleSoup::Node& here = inner_.soup().nodes()[static_cast<std::size_t>(node)];
  const std::size_t own = packs_.size();
  add_packs_near(here, begin);
  bool near = false;
  if (packs_.size() > own && here.count == 0) {
    near = node_comes_near(here.first, own) || node_comes_near(here.first + 1, own);
  }
  for (int i = here.first; !near && packs_.size() > own && i < here.first + here.count; ++i) {
    const TrianglePass pass = reaching(i);
    near =
        std::any_of(packs_.begin() + static_cast<std::ptrdiff_t>(own), packs_.end(), [&](int pack) {
          return kernels().met_by_triangle(
                     pass, outer_.soup().packs()[static_cast<std::size_t>(pack)]) != 0;
        });
  }
  packs_.resize(own);
  return near;
}

}  // namespace rubicon::collision
