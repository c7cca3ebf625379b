#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "src/exchange/ifc/solid.hpp"
#include "src/exchange/ifc/solid_faces.hpp"

namespace rubicon::ifc {

/// A convex region: what is inside of all its half spaces. It need not be bounded.
using Cell = std::vector<HalfSpace>;

/// A closed body by its plane faces, to be cut many times.
class FaceSolid {
 public:
  /// Triangles in one plane make one face, but where `apart`. Nothing without budget, or too far
  /// out.
  static std::optional<FaceSolid> of(const Solid& body, bool apart, WorkBudget& budget);

  /// Takes away what lies inside of a cell. False, and nothing is changed, if it cannot be worked
  /// out. Where a cut fails because corners lie too near to a plane, the plane is moved by up to
  /// kShift. `fill_now`: the new faces are made triangles of at once, which takes longer; a cut
  /// that leaves faces with crossing borders fails then, otherwise triangles() does.
  bool subtract(const Cell& cell, bool fill_now, WorkBudget& budget);

  /// Keeps what lies inside of a cell; as above.
  bool intersect(const Cell& cell, bool fill_now, WorkBudget& budget);

  /// Without faces nothing is left.
  bool is_empty() const { return faces_.empty(); }
  /// Whether a cut has changed something.
  bool is_changed() const { return is_changed_; }

  /// Of all faces.
  std::size_t corners() const;

  /// The surface, closed and with the volume that the faces enclose. Faces that cuts have left in
  /// one plane are joined, where that can be done. Nothing if it does not close.
  std::optional<Solid> triangles(WorkBudget& budget) const;

 private:
  bool subtract_once(const Cell& cell, bool fill_now, WorkBudget& budget);
  bool intersect_once(const Cell& cell, bool fill_now, WorkBudget& budget);

  std::vector<math::Vec3> points_;
  std::vector<Face> faces_;
  std::size_t given_ = 0;  ///< corners of the body as it was
  bool is_changed_ = false;
};

/// A closed body as convex cells that touch: cut along its own faces until nothing sticks out.
/// Nothing if that takes too many cells, or the body cannot be cut.
std::optional<std::vector<Cell>> convex_cells(const Solid& body, WorkBudget& budget);

/// What of a closed body lies outside of a cell; without triangles: nothing does. Nothing if it
/// cannot be worked out. Planes are moved as above.
std::optional<Solid> subtract(const Solid& body, const Cell& cell, WorkBudget& budget);

/// What of a closed body lies inside of a cell; as above.
std::optional<Solid> intersect(const Solid& body, const Cell& cell, WorkBudget& budget);

/// Metres: far below what a building is measured in, a few times what is taken for touching.
inline constexpr double kShift = 1e-4;

}  // namespace rubicon::ifc
