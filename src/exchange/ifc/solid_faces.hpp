#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "src/exchange/ifc/solid.hpp"

namespace rubicon::ifc {

/// Where a face comes from that a cut made.
inline constexpr int kFromCut = -1;

/// An axis-aligned box.
struct Extent {
  math::Vec3 low = math::Vec3::Constant(HUGE_VAL);
  math::Vec3 high = math::Vec3::Constant(-HUGE_VAL);

  void add(const math::Vec3& p);
  void add(const Extent& other);
  bool meets(const Extent& other, double margin) const;
  /// The least and the greatest distance of a corner of the box from a plane, above zero outside.
  std::pair<double, double> distances(const HalfSpace& plane) const;
};

/// A piece of a body's surface in one plane, by its border: the area lies on the left of its edges,
/// seen from outside. Edges are in no order; areas may have holes and parts. It is not cut into
/// triangles before the end: their sides would be cut again and again.
struct Face {
  std::vector<Edge> edges;
  /// Outwards, of length 1; zero where the face is too narrow to tell.
  math::Vec3 normal = math::Vec3::Zero();
  int source = kFromCut;  ///< the face of the body that it lies in
  Extent extent;
  /// Its area, where that is known already.
  std::vector<std::array<int, 3>> triangles;
};

Extent extent_of(const std::vector<math::Vec3>& points, const std::vector<Edge>& edges);

/// Area times normal, twice.
math::Vec3 area_vector(const std::vector<math::Vec3>& points, const std::vector<Edge>& edges);

/// The faces of a closed body: triangles in one plane that touch make one, but where `apart`.
/// None without budget, and where corners lie too far out to reckon with.
std::vector<Face> plane_faces(const Solid& body, bool apart, WorkBudget& budget);

/// The plane of a face; nothing if it is too narrow to tell its direction.
std::optional<HalfSpace> plane_of(const std::vector<math::Vec3>& points, const Face& face);

/// What the faces of a closed surface enclose.
double volume_of(const std::vector<math::Vec3>& points, const std::vector<Face>& faces);

/// Puts in the triangles of a face that has none. False if its border is no border of an area.
bool fill(const std::vector<math::Vec3>& points, Face& face, WorkBudget& budget);

/// The corners that faces use, each once.
std::vector<int> corners_of(const std::vector<Face>& faces);

}  // namespace rubicon::ifc
