#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "src/exchange/ifc/solid_faces.hpp"

namespace rubicon::ifc {

/// A part of a body cut in two; without faces: nothing is there.
struct SplitFaces {
  std::vector<Face> inside, outside;
};

/// Cuts parts of one body with planes, one after the other. Corners keep their numbers; new ones,
/// the same for all faces of an edge, come behind.
class FaceSplitter {
 public:
  /// Puts new corners behind `points`, which it must outlive.
  explicit FaceSplitter(std::vector<math::Vec3>& points)
      : points_(points), base_(static_cast<int>(points.size())) {}

  /// Cuts what closed faces enclose and closes both parts; the outer one only where it is wanted.
  /// What lies on the plane within kOnPlane belongs to the part it bounds. Nothing if the section
  /// cannot be closed.
  std::optional<SplitFaces> split(std::vector<Face> faces, const HalfSpace& plane, bool outside_too,
                                  WorkBudget& budget);

  /// Of a new corner that lies on an edge of the body: the edge's ends, the smaller number first.
  std::optional<Edge> edge_of(int corner) const;

 private:
  struct Mark {
    std::size_t round = 0;
    int side = 0;
    double distance = 0;
  };
  /// A corner of a face on the plane.
  struct Stop {
    double along = 0;  ///< the line in which plane and face meet
    int corner = 0;
    int surplus = 0;  ///< edges that end here, less those that begin
  };

  int side(int corner);
  bool sort_face(Face face, std::vector<Face>& inside, std::vector<Face>& outside,
                 WorkBudget& budget);
  bool cut_face(const Face& face, std::vector<Face>& inside, std::vector<Face>& outside,
                WorkBudget& budget);
  bool close_face(std::vector<Edge> edges, const Face& face, bool is_inside, std::vector<Face>& to,
                  WorkBudget& budget);
  std::vector<Stop> stops_of(const std::vector<Edge>& edges, const math::Vec3& way) const;
  void put(Face face, bool is_inside, std::vector<Face>& to);
  void cover(bool is_inside, std::vector<Face>& to);
  int crossing_of(int a, int b);
  std::optional<Edge> edge_along(int a, int b) const;

  std::vector<math::Vec3>& points_;
  int base_;  ///< corners from here on are new
  std::vector<Edge> edge_of_;
  HalfSpace plane_;
  bool outside_too_ = false;
  std::size_t round_ = 0;
  std::vector<Mark> marks_;
  std::map<Edge, int> crossings_;
  std::vector<int> on_plane_;  ///< corners of the face that is cut
  std::vector<Edge> missing_inside_, missing_outside_;
};

}  // namespace rubicon::ifc
