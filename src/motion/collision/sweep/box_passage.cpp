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
  // The swept box along its middle axes, and across its way along the outlines of its faces; both
  // are worked out in the frame of the middle pose.
  const Mat3 to_middle = passage.R_middle.transpose();
  const Vec3 start = to_middle * box.start;
  const Vec3 end = to_middle * box.end;
  Mat3 start_axes = Mat3::Identity();
  Mat3 end_axes = Mat3::Identity();
  Vec3 middle_growth = Vec3::Constant(box.uniform_growth);
  if (!passage.translation) {
    start_axes = to_middle * box.R_start;
    end_axes = to_middle * box.R_end;
    middle_growth += box.axial_growth * across_axes(to_middle * box.growth_axis);
  }
  std::array<Slab, FloatSlabs::kMost> slabs;
  std::size_t count = 0;
  const auto add = [&](const Vec3& n, double lower, double upper) {
    slabs[count++] = {n, 0.5 * (lower + upper), 0.5 * (upper - lower)};
  };
  const Vec3 start_along = start_axes.cwiseAbs() * box.half;
  const Vec3 end_along = end_axes.cwiseAbs() * box.half;
  const Vec3 lower = (start - start_along).cwiseMin(end - end_along) - middle_growth;
  const Vec3 upper = (start + start_along).cwiseMax(end + end_along) + middle_growth;
  for (int j = 0; j < 3; ++j) add(passage.R_middle.col(j), lower[j], upper[j]);
  const Vec3 way = end - start;
  const double squared = way.squaredNorm();
  if (squared > kShortWay * kShortWay * box.half.squaredNorm()) {
    // No direction sees more of the growth than all of it.
    const double all_growth = box.uniform_growth + box.axial_growth;
    for (int j = 0; j < 3; ++j) {
      const int k = (j + 1) % 3;
      const int l = (j + 2) % 3;
      const double across_squared = way[k] * way[k] + way[l] * way[l];
      if (!(across_squared > kSameWay * kSameWay * squared)) continue;
      const double length = std::sqrt(across_squared);
      const double n_k = way[l] / length;
      const double n_l = -way[k] / length;
      const double at_start = n_k * start[k] + n_l * start[l];
      const double at_end = n_k * end[k] + n_l * end[l];
      const double start_reach_n =
          (n_k * start_axes.row(k) + n_l * start_axes.row(l)).cwiseAbs().dot(box.half);
      const double end_reach_n =
          (n_k * end_axes.row(k) + n_l * end_axes.row(l)).cwiseAbs().dot(box.half);
      add(n_k * passage.R_middle.col(k) + n_l * passage.R_middle.col(l),
          std::min(at_start - start_reach_n, at_end - end_reach_n) - all_growth,
          std::max(at_start + start_reach_n, at_end + end_reach_n) + all_growth);
    }
  }
  soup.pack_tree().collect(swept, std::span<const Slab>(slabs).first(count), found);
}

}  // namespace rubicon::collision
