#pragma once

#include <array>
#include <vector>

#include "src/motion/collision/swept_query.hpp"

namespace rubicon::collision::test {

/// A closed mesh: the polygon (counter-clockwise, its own triangulation given by index) extruded
/// from z0 to z1. The sides and faces are cut `fineness` times into four where it is more than 0.
geometry::TriangleMesh extruded_mesh(const std::vector<Eigen::Vector2d>& polygon,
                                     const std::vector<std::array<int, 3>>& triangulation,
                                     double z0, double z1, int fineness = 0);

/// The L of legs 2 m and thickness 0.5 m, 1 m high, z from 0: not convex, so it stays triangles.
geometry::TriangleMesh l_mesh(int fineness = 0);
/// A cube of edge 2 m about the origin with a cubic cavity of edge 1 m.
geometry::TriangleMesh hollow_cube_mesh();
/// A cuboid about the origin.
geometry::TriangleMesh cuboid_mesh(const Vec3& half, int fineness = 0);

BodyPtr mesh_body(const geometry::TriangleMesh& mesh);

}  // namespace rubicon::collision::test
