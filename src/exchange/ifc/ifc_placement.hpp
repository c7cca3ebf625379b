#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "src/exchange/ifc/step_file.hpp"
#include "src/motion/math/pose.hpp"

namespace rubicon::ifc {

/// The point of an IfcCartesianPoint in the units of the file (z is 0 where it has two
/// coordinates); nothing if the record is none, or its numbers are none.
std::optional<math::Vec3> cartesian_point(const StepFile& file, std::uint64_t id);

/// The unit vector of an IfcDirection; nothing if the record is none, or it has no length.
std::optional<math::Vec3> unit_direction(const StepFile& file, std::uint64_t id);

/// The pose of an IfcAxis2Placement3D or 2D, translation in the units of the file. Axes as the
/// standard has them (IfcBuildAxes): z first, x as near to the given one as that allows.
std::optional<math::Pose> axis_placement(const StepFile& file, std::uint64_t id);

/// What mapped and derived shapes are moved by: it may scale and mirror.
using Transformation = Eigen::Transform<double, 3, Eigen::Affine>;

/// An IfcCartesianTransformationOperator2D or 3D, also a non-uniform one, translation in the units
/// of the file. Nothing if it is none, or flattens what it moves.
std::optional<Transformation> transformation(const StepFile& file, std::uint64_t id);

/// Where the things of a file stand. Placements are relative to others; each is worked out once.
class IfcPlacements {
 public:
  /// `file` must outlive this object.
  explicit IfcPlacements(const StepFile& file) : file_(&file) {}

  /// The pose of an IfcLocalPlacement in the world of the file, translation in the units of the
  /// file. Nothing when it, or one it is relative to, is no IfcLocalPlacement, or they lead in a
  /// ring.
  std::optional<math::Pose> world(std::uint64_t id);

  /// Why `world` gave nothing the last time: "it is placed by an IfcGridPlacement, which is not
  /// read".
  const std::string& fault() const { return fault_; }

  /// The pose of a product likewise; the origin where it names no placement.
  std::optional<math::Pose> of_product(std::uint64_t product);

 private:
  const StepFile* file_;
  struct Place {
    std::optional<math::Pose> X_W;
    std::string fault;  ///< why there is none
  };
  std::string fault_of(std::uint64_t id) const;
  std::unordered_map<std::uint64_t, Place> known_;
  std::string fault_;
};

}  // namespace rubicon::ifc
