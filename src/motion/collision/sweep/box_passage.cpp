#include "src/motion/collision/sweep/box_passage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

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

/// Ways shorter than this share of the box hardly make a box around it larger.
constexpr double kShortWay = 0.05;
/// A way nearly along an axis of the box (sine of the angle) has no outline across it.
constexpr double kSameWay = 0.01;

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
  // The swept box along its middle axes, and across its way along the outlines of its faces.
  std::array<Slab, FloatSlabs::kMost> slabs;
  std::size_t count = 0;
  const auto add = [&](const Vec3& n) {
    const double start_reach_n = (n.transpose() * box.R_start).cwiseAbs().dot(box.half);
    const double end_reach_n =
        passage.translation ? start_reach_n : (n.transpose() * box.R_end).cwiseAbs().dot(box.half);
    const double at_start = n.dot(box.start);
    const double at_end = n.dot(box.end);
    const double growth_n = box.uniform_growth + box.axial_growth * n.cross(box.growth_axis).norm();
    const double lower = std::min(at_start - start_reach_n, at_end - end_reach_n) - growth_n;
    const double upper = std::max(at_start + start_reach_n, at_end + end_reach_n) + growth_n;
    slabs[count++] = {n, 0.5 * (lower + upper), 0.5 * (upper - lower)};
  };
  for (int j = 0; j < 3; ++j) add(passage.R_middle.col(j));
  const Vec3 displacement = box.end - box.start;
  if (displacement.norm() > kShortWay * box.half.norm()) {
    for (int j = 0; j < 3; ++j) {
      const Vec3 across = displacement.cross(passage.R_middle.col(j));
      const double length = across.norm();
      if (length > kSameWay * displacement.norm()) add(across / length);
    }
  }
  soup.pack_tree().collect(swept, std::span<const Slab>(slabs).first(count), found);
}

}  // namespace rubicon::collision
