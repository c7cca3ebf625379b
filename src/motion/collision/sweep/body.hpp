#pragma once

#include <memory>
#include <vector>

#include "src/motion/collision/convex/convex.hpp"
#include "src/motion/collision/mesh/mesh_inside.hpp"
#include "src/motion/collision/mesh/triangle_soup.hpp"
#include "src/motion/collision/sweep/motion_bounds.hpp"
#include "src/motion/collision/sweep/swept_box.hpp"
#include "src/motion/collision/swept_query.hpp"

namespace rubicon::collision {

/// A solid piece or a mesh of a body, and the box around it.
struct BodyPart {
  OrientedBox box;       ///< in the body's centred coordinates
  bool aligned = false;  ///< box.R is the identity
  bool is_box = false;   ///< the part is this box, to 1e-10 m
  double width = 0;      ///< m, smallest extent of a solid piece
  int piece = -1;        ///< index into Body::convexes(), or
  int soup = -1;         ///< into Body::soups()
};

/// A point of a body that is looked for inside the closed meshes of another.
struct Probe {
  Vec3 point = Vec3::Zero();
  double width = 0;  ///< m, of the solid piece it belongs to; infinite for meshes
};

/// A rigid body ready for queries: the union of convex pieces and triangle soups. All coordinates
/// are relative to `extent().centre`, so that bodies drawn far from their origin lose nothing.
/// Can be owned through itself, so that who remembers it keeps its address from another.
class Body : public std::enable_shared_from_this<Body> {
 public:
  /// `pieces` and `soups` in the frame of the shapes; at least one of them not empty.
  Body(std::vector<ConvexPiece> pieces, std::vector<TriangleSoup> soups, const Vec3& centre);
  Body(const Body&) = delete;  // the views point into the pieces
  Body& operator=(const Body&) = delete;

  const std::vector<Convex>& convexes() const { return convexes_; }
  const std::vector<TriangleSoup>& soups() const { return soups_; }
  /// All pieces, then all soups.
  const std::vector<BodyPart>& parts() const { return parts_; }
  /// A tree over the parts; empty where they are few.
  const WideTree& part_tree() const { return part_tree_; }
  const BodyExtent& extent() const { return extent_; }
  const Bounds& bounds() const { return bounds_; }
  /// A few points of every part, for tests of containment.
  const std::vector<Probe>& probes() const { return probes_; }
  /// Points half way through closed meshes under their triangles, and a tree over them, for tests
  /// of meshes whose surfaces lie in each other.
  const std::vector<Probe>& surface_probes() const { return surface_probes_; }
  const WideTree& surface_probe_tree() const { return surface_probe_tree_; }
  /// One a soup.
  const std::vector<MeshInside>& mesh_insides() const { return mesh_insides_; }
  bool has_closed_soup() const { return has_closed_soup_; }

 private:
  std::vector<ConvexPiece> pieces_;
  std::vector<Convex> convexes_;  ///< views of `pieces_`
  std::vector<TriangleSoup> soups_;
  std::vector<BodyPart> parts_;
  WideTree part_tree_;
  BodyExtent extent_;
  Bounds bounds_;
  std::vector<Probe> probes_;
  std::vector<Probe> surface_probes_;
  WideTree surface_probe_tree_;
  std::vector<MeshInside> mesh_insides_;
  bool has_closed_soup_ = false;
};

}  // namespace rubicon::collision
