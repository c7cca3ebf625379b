#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "src/exchange/ifc/step_file.hpp"
#include "src/motion/math/pose.hpp"

namespace rubicon::ifc {

/// Shapes whose own coordinates lie far out, as programs write them that put everything into the
/// national grid: the library would round them to single precision. Their points are moved by one
/// offset, the same for the whole file, and so keep their digits.
class FarPoints {
 public:
  /// `shapes` are IfcProductDefinitionShape records. Where a shape has points both near and far,
  /// nothing is moved at all: it could not be told which belong together.
  FarPoints(const StepFile& file, double metres_per_unit, const std::vector<std::uint64_t>& shapes);

  /// Whether the points of this shape are moved.
  bool is_far(std::uint64_t shape) const { return far_shapes_.contains(shape); }
  /// What is taken off the points of a shape, in the units of the file; zero if it is not far.
  math::Vec3 offset_of(std::uint64_t shape) const {
    return is_far(shape) ? offset_ : math::Vec3(math::Vec3::Zero());
  }
  /// The point as it is to be written; nothing if that is how it stands.
  std::optional<math::Vec3> moved(const math::Vec3& p) const;

 private:
  std::set<std::uint64_t> far_shapes_;
  double limit_ = 0;  ///< in the units of the file
  math::Vec3 offset_ = math::Vec3::Zero();
};

}  // namespace rubicon::ifc
