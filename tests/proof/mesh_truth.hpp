#pragma once

#include "src/motion/geometry/shape.hpp"
#include "tests/proof/path.hpp"
#include "tests/proof/polytope.hpp"

namespace rubicon::collision::proof {

/// Convex pieces of one body with balls around them.
struct Pieces {
  std::vector<Polytope> polytopes;
  std::vector<Vec3> centres;
  std::vector<double> radii;
  double reach = 0;  ///< m, greatest distance of a corner from the origin of the frame

  void add(Polytope polytope);
};

Pieces pieces_of(const Polytope& polytope);
/// The triangles of a mesh; those without area (an altitude below 1 nm) are left out, as
/// docs/collision.md says.
Pieces pieces_of(const geometry::TriangleMesh& mesh);

/// Whether some piece of `a` meets some piece of `b`, each pair with its own tolerance: exact axes
/// of swept pieces if neither body turns, else branch and bound over poses.
Truth pieces_truth(const Pieces& a, const Path& path_a, const Pieces& b, const Path& path_b,
                   double contact_tolerance);

/// Whether points are inside a closed mesh: a ray in a random direction crosses its surface an odd
/// number of times.
bool is_inside(const geometry::TriangleMesh& mesh, const Vec3& point, const Vec3& direction);
double distance_to_surface(const geometry::TriangleMesh& mesh, const Vec3& point);

/// Containment of points of one body in a closed mesh at one pose. Hit: one of them is deeper
/// inside than the tolerance. An open mesh has no inside.
Truth any_inside(const geometry::TriangleMesh& mesh, const std::vector<Vec3>& points,
                 const Pose& X_MeshPoints, double tolerance, Random& random);
/// The same, but a hit only if all of them are.
Truth all_inside(const geometry::TriangleMesh& mesh, const std::vector<Vec3>& points,
                 const Pose& X_MeshPoints, double tolerance, Random& random);

}  // namespace rubicon::collision::proof
