#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "src/motion/collision/mesh/flat_cover.hpp"
#include "src/motion/collision/mesh/mesh_inside.hpp"

namespace rubicon::collision {

/// Looks for a point of the surface of one mesh that is deeper than the contact tolerance (less
/// where either is thin) inside another, closed one; all of it, not only some points. Source of the
/// method: docs/collision.md, "Inside".
class SurfaceSearch {
 public:
  /// `to_outer` places the frame of `inner` in that of `outer`.
  SurfaceSearch(const MeshInside& inner, const MeshInside& outer, const Placement& to_outer,
                double contact_tolerance);

  /// Whether the two surfaces come anywhere near each other; if they do not, a point of each part
  /// says all.
  bool comes_near();

  /// Such a point in the frame of `outer`; a point near it where the search has become too long to
  /// be finished.
  std::optional<Vec3> find();

 private:
  /// A triangle of `outer` near the one that is looked at, as that one sees it.
  struct Near {
    SeenTriangle seen;
    Vec2 lower = Vec2::Zero();
    Vec2 upper = Vec2::Zero();
    double highest = 0;            ///< m, above or below
    Vec3 outwards = Vec3::Zero();  ///< its own normal; zero where that is not known
    double offset = 0;             ///< m, of its plane along it
    bool same_side = false;        ///< perhaps both solids are on one side of one plane
  };
  /// The triangle of `inner` that is looked at: its corners and plane in the frame of `outer`.
  struct Looked {
    int index = 0;
    std::array<Vec3, 3> corners;
    Vec3 normal = Vec3::UnitZ();
    Vec3 u = Vec3::UnitX();
    Vec3 v = Vec3::UnitY();
    double allowed = 0;  ///< m

    Vec2 flat(const Vec3& point) const {
      return {u.dot(point - corners[0]), v.dot(point - corners[0])};
    }
    Vec3 solid(const Vec2& point) const { return corners[0] + point.x() * u + point.y() * v; }
  };

  void collect_packs();
  void add_packs_near(const TriangleSoup::Node& node, std::size_t begin);
  bool stays_outside(const TriangleSoup::Node& node, std::span<const int> packs);
  bool is_flat(const TriangleSoup::Node& node) const;
  TrianglePass reaching(int triangle) const;
  bool node_comes_near(int node, std::size_t begin);
  bool look_at_node(int node, std::size_t begin);
  bool look_at_packs(const TriangleSoup::Node& here, std::size_t own);
  bool look_at_triangle(int triangle, std::span<const int> packs);
  std::vector<Near> near_triangles(const Looked& looked, std::span<const int> packs);
  static std::vector<Near> near_to(const FlatPolygon& polygon, const std::vector<Near>& near,
                                   double reach);
  bool solids_meet_under(const Looked& looked, int other, const Near& near);
  bool touches_from_outside(const Looked& looked, const FlatPolygon& piece,
                            const std::vector<Near>& near) const;
  bool look_at_piece(const Looked& looked, const FlatPolygon& piece, const std::vector<Near>& near,
                     int halvings);
  bool look_at_rest(const Looked& looked, const FlatPolygon& rest, const std::vector<Near>& near);
  bool deep_somewhere(const Looked& looked, const FlatPolygon& rest);
  /// Notes a point; true.
  bool found(const Vec3& point);
  /// Counts a step of the search; true when there were too many, which counts as found.
  bool too_long(const Vec3& point, std::int64_t steps = 1);

  const MeshInside& inner_;
  const MeshInside& outer_;
  Placement to_outer_;
  Placement to_inner_;
  double contact_tolerance_;
  /// Packs of `outer` near the nodes from the root to the one that is looked at, one list after the
  /// other.
  std::vector<int> packs_;
  std::optional<Vec3> found_;
  std::int64_t steps_ = 0;
};

}  // namespace rubicon::collision
