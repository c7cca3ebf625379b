#include "src/motion/collision/pair/mesh_mesh_narrow_phase.hpp"

#include <algorithm>
#include <numeric>

#include "src/motion/collision/base/tolerances.hpp"
#include "src/motion/collision/pair/box_mesh_narrow_phase.hpp"
#include "src/motion/collision/tree/kernels.hpp"

namespace rubicon::collision {

struct MeshMeshNarrowPhase::Seen {
  Placement start;
  Placement middle;
  Placement end;
  Vec3 axis;
  Vec3 point;
  double unit_sagitta = 0;
  double uniform_growth = 0;
};

namespace {

/// Whether a moving box stays on one side of a flat one that stands, seen along its face.
bool beside_face(const BoxPassage& moving, const OrientedBox& flat) {
  const TurnedBox& box = moving.box;
  const Vec3 n = flat.R.col(2);
  const double at_start = n.dot(box.start - flat.centre);
  const double at_end = n.dot(box.end - flat.centre);
  const double start_reach = (box.R_start.transpose() * n).cwiseAbs().dot(box.half);
  const double end_reach = (box.R_end.transpose() * n).cwiseAbs().dot(box.half);
  const double room = flat.half[2] + box.uniform_growth + box.axial_growth;
  return std::min(at_start - start_reach, at_end - end_reach) >= room ||
         std::max(at_start + start_reach, at_end + end_reach) <= -room;
}

}  // namespace

MeshMeshNarrowPhase::MeshMeshNarrowPhase(const Sweep& sweep, const TriangleSoup& moving,
                                         const BodyPart& fixed_part, const TriangleSoup& fixed,
                                         const Placement& X_WB, double contact_tolerance)
    : sweep_(sweep),
      moving_(moving),
      fixed_part_(fixed_part),
      fixed_(fixed),
      X_WB_(X_WB),
      contact_tolerance_(std::max(contact_tolerance, kRoundingDepth)) {}

Verdict MeshMeshNarrowPhase::verdict(SweepSlice& slice) const {
  const Seen poses = seen(slice);
  std::vector<Open> open;
  ItemList own;
  own_packs(slice, own);
  ItemList met;
  for (const int pack : own) {
    packs_near(poses, pack, met);
    if (met.size() == 0) continue;
    const TrianglePack& triangles = moving_.packs()[static_cast<std::size_t>(pack)];
    for (int i = triangles.first; i < triangles.first + triangles.count; ++i) {
      const TrianglePass moving = pass(poses, i);
      for (const int other : met) {
        if (!meets(moving, other)) continue;
        if (sweep_.is_translation() || deep_at_a_pose({i, other}, poses, true)) {
          return Verdict::kHit;
        }
        open.push_back({i, other});
      }
    }
  }
  return open.empty() ? Verdict::kFree : in_halves(slice, open, kHalvings);
}

/// The packs of the moving mesh that come near the standing one.
void MeshMeshNarrowPhase::own_packs(SweepSlice& slice, ItemList& found) const {
  if (slice.uniform_growth() > 0) {
    // Seen from a moving mesh a general motion has another bound: all of its packs.
    while (found.capacity() < static_cast<int>(moving_.packs().size())) found.grow();
    found.set_size(static_cast<int>(moving_.packs().size()));
    std::iota(found.begin(), found.end(), 0);
    return;
  }
  const BoxMeshNarrowPhase whole(sweep_, fixed_part_, moving_, true, X_WB_, 0);
  collect_packs(whole.passage(slice), moving_, found);
}

/// The close box around a pack of the moving mesh over a slice, in the frame of the standing one.
BoxPassage MeshMeshNarrowPhase::passage(const Seen& poses, int own) const {
  const OrientedBox& box = moving_.pack_boxes()[static_cast<std::size_t>(own)];
  BoxPassage result;
  result.translation = sweep_.is_translation();
  result.box.half = box.half;
  result.box.R_start = poses.start.R * box.R;
  result.box.start = poses.start * box.centre;
  result.box.end = poses.end * box.centre;
  if (result.translation) {
    result.box.R_end = result.R_middle = result.box.R_start;
    result.middle = 0.5 * (result.box.start + result.box.end);
    return result;
  }
  result.box.R_end = poses.end.R * box.R;
  result.R_middle = poses.middle.R * box.R;
  result.middle = poses.middle * box.centre;
  result.box.growth_axis = poses.axis;
  result.box.uniform_growth = poses.uniform_growth;
  if (poses.unit_sagitta > 0) {
    const double radius = poses.axis.cross(result.box.start - poses.point).norm() + box.half.norm();
    result.box.axial_growth = poses.unit_sagitta * radius;
  }
  return result;
}

/// The packs of the standing mesh that the box around one of the moving mesh is not proved free of.
void MeshMeshNarrowPhase::packs_near(const Seen& poses, int own, ItemList& found) const {
  const BoxPassage whole = passage(poses, own);
  collect_packs(whole, fixed_, found);
  if (found.size() == 0) return;
  int* last = std::remove_if(found.begin(), found.end(), [&](int pack) {
    return beside_face(whole, fixed_.pack_boxes()[static_cast<std::size_t>(pack)]);
  });
  found.set_size(static_cast<int>(last - found.begin()));
  if (found.size() == 0) return;
  const BoxPass pass = box_pass(whole, kRoundingDepth);
  last = std::remove_if(found.begin(), found.end(), [&](int pack) {
    return kernels().meeting_triangles(pass, fixed_.packs()[static_cast<std::size_t>(pack)]) == 0;
  });
  found.set_size(static_cast<int>(last - found.begin()));
}

MeshMeshNarrowPhase::Seen MeshMeshNarrowPhase::seen(SweepSlice& slice) const {
  const Mat3 to_fixed = X_WB_.R.transpose();
  return {relative(slice.start(), X_WB_),
          relative(slice.middle(), X_WB_),
          relative(slice.end(), X_WB_),
          to_fixed * slice.axis(),
          to_fixed * (slice.point() - X_WB_.t),
          slice.unit_sagitta(),
          slice.uniform_growth()};
}

TrianglePass MeshMeshNarrowPhase::pass(const Seen& poses, int triangle) const {
  TrianglePass result;
  double radius = 0;
  std::array<Vec3, 3> middle;
  for (int k = 0; k < 3; ++k) {
    const Vec3& corner = moving_.corner(triangle, k);
    const Vec3 start = poses.start * corner;
    const Vec3 end = poses.end * corner;
    middle[k] = poses.middle * corner;
    for (int axis = 0; axis < 3; ++axis) {
      result.start[k][axis] = start[axis];
      result.end[k][axis] = end[axis];
    }
    if (poses.unit_sagitta > 0)
      radius = std::max(radius, poses.axis.cross(start - poses.point).norm());
  }
  for (int k = 0; k < 3; ++k) {
    const Vec3 edge = middle[(k + 1) % 3] - middle[k];
    for (int axis = 0; axis < 3; ++axis) result.edges[k][axis] = edge[axis];
    result.growth_axis[k] = poses.axis[k];
  }
  result.axial_growth = poses.unit_sagitta * radius;
  result.uniform_growth = poses.uniform_growth;
  const double altitude = smallest_altitude(
      moving_.corner(triangle, 0), moving_.corner(triangle, 1), moving_.corner(triangle, 2));
  result.tolerance = std::min(contact_tolerance_, thickness_tolerance(altitude));
  return result;
}

TrianglePass MeshMeshNarrowPhase::still(const Placement& pose, int triangle) const {
  Seen standing;
  standing.start = standing.middle = standing.end = pose;
  standing.axis = Vec3::UnitZ();
  standing.point = Vec3::Zero();
  return pass(standing, triangle);
}

bool MeshMeshNarrowPhase::meets(const TrianglePass& pass, int pack) const {
  return kernels().met_by_triangle(pass, fixed_.packs()[static_cast<std::size_t>(pack)]) != 0;
}

bool MeshMeshNarrowPhase::deep_at_a_pose(const Open& pair, const Seen& poses,
                                         bool start_too) const {
  const auto deep_at = [&](const Placement& pose) {
    return meets(still(pose, pair.triangle), pair.pack);
  };
  return deep_at(poses.middle) || deep_at(poses.end) || (start_too && deep_at(poses.start));
}

Verdict MeshMeshNarrowPhase::in_halves(SweepSlice& slice, const std::vector<Open>& open,
                                       int halvings) const {
  if (halvings == 0) return Verdict::kUndecided;
  for (SweepSlice* half : {&slice.first_half(), &slice.second_half()}) {
    const Seen poses = seen(*half);
    std::vector<Open> left;
    for (const Open& pair : open) {
      if (!meets(pass(poses, pair.triangle), pair.pack)) continue;
      if (deep_at_a_pose(pair, poses, false)) return Verdict::kHit;
      left.push_back(pair);
    }
    if (left.empty()) continue;
    const Verdict found = in_halves(*half, left, halvings - 1);
    if (found != Verdict::kFree) return found;
  }
  return Verdict::kFree;
}

}  // namespace rubicon::collision
