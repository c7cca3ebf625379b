#include "src/collision/box_mesh_test.hpp"

#include <cmath>

namespace rubicon::collision {
namespace {

void store(const Mat3& R, double (&rows)[3][3]) {
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) rows[i][k] = R(i, k);
  }
}

void store(const Vec3& v, double (&values)[3]) {
  for (int i = 0; i < 3; ++i) values[i] = v[i];
}

/// How far a direction of the frame's axes is from the growth axis, for each of the three.
Vec3 across_axes(const Vec3& axis) {
  const Vec3 squares = axis.cwiseAbs2();
  return {std::sqrt(squares.y() + squares.z()), std::sqrt(squares.z() + squares.x()),
          std::sqrt(squares.x() + squares.y())};
}

}  // namespace

BoxPass box_pass(const BoxPassage& passage, double contact_tolerance) {
  const TurnedBox& box = passage.box;
  const Mat3 to_box = passage.R_middle.transpose();
  const Mat3 start_axes = to_box * box.R_start;
  const Mat3 end_axes = to_box * box.R_end;
  const Vec3 start = to_box * (box.start - passage.middle);
  const Vec3 end = to_box * (box.end - passage.middle);
  const Vec3 growth_axis = to_box * box.growth_axis;
  BoxPass pass;
  store(to_box, pass.to_box);
  store(-(to_box * passage.middle), pass.offset);
  store(box.half, pass.half);
  store(start, pass.start);
  store(end, pass.end);
  store(growth_axis, pass.growth_axis);
  pass.axial_growth = box.axial_growth;
  pass.uniform_growth = box.uniform_growth;
  pass.tolerance = contact_tolerance;
  pass.same_axes = passage.translation;
  Vec3 start_reach = box.half;
  Vec3 end_reach = box.half;
  if (!passage.translation) {
    // Axis by axis, as the kernel wants them: columns become rows.
    store(start_axes.transpose(), pass.start_axes);
    store(end_axes.transpose(), pass.end_axes);
    start_reach = start_axes.cwiseAbs() * box.half;
    end_reach = end_axes.cwiseAbs() * box.half;
  }
  const Vec3 growth =
      Vec3::Constant(box.uniform_growth) + box.axial_growth * across_axes(growth_axis);
  store((start - start_reach).cwiseMin(end - end_reach) - growth, pass.lower);
  store((start + start_reach).cwiseMax(end + end_reach) + growth, pass.upper);
  return pass;
}

void collect_packs(const BoxPassage& passage, const TriangleSoup& soup, ItemList& found) {
  const TurnedBox& box = passage.box;
  const Vec3 start_reach = box.R_start.cwiseAbs() * box.half;
  const Vec3 end_reach = passage.translation ? start_reach : Vec3(box.R_end.cwiseAbs() * box.half);
  const Vec3 growth =
      Vec3::Constant(box.uniform_growth) + box.axial_growth * across_axes(box.growth_axis);
  Bounds swept;
  swept.lower = (box.start - start_reach).cwiseMin(box.end - end_reach) - growth;
  swept.upper = (box.start + start_reach).cwiseMax(box.end + end_reach) + growth;
  // The swept box along its middle axes.
  const BoxPass pass = box_pass(passage, 0);
  OrientedBox oriented;
  oriented.R = passage.R_middle;
  const Vec3 lower(pass.lower[0], pass.lower[1], pass.lower[2]);
  const Vec3 upper(pass.upper[0], pass.upper[1], pass.upper[2]);
  oriented.centre = passage.middle + passage.R_middle * (0.5 * (lower + upper));
  oriented.half = 0.5 * (upper - lower);
  soup.pack_tree().collect(swept, oriented, found);
}

}  // namespace rubicon::collision
