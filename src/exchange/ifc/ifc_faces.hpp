#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "src/exchange/ifc/ifc_far_points.hpp"
#include "src/exchange/ifc/record_writer.hpp"
#include "src/exchange/ifc/step_file.hpp"
#include "src/exchange/ifc/step_values.hpp"

namespace rubicon::ifc {

/// Writes the faces that IFC 4 gives as lists of numbers as the faces of IFC 2x3.
class FaceWriter {
 public:
  /// All must outlive this object.
  FaceWriter(const StepFile& file, const FarPoints& far, RecordWriter& out)
      : file_(file), far_(far), out_(out) {}

  /// Whether this is what can be written: IfcTriangulatedFaceSet or IfcPolygonalFaceSet.
  static bool takes(const StepRecord& record);

  /// Writes the record as IfcFacetedBrep if it is closed, else as IfcShellBasedSurfaceModel, under
  /// its own number. False, and nothing that counts is written, if an index or a point is not
  /// there.
  bool write(const StepRecord& record);

 private:
  using Points = std::vector<std::uint64_t>;
  const Points* points_of(std::uint64_t list);
  std::optional<std::uint64_t> loop(const StepItem& indices, const Points& points,
                                    const std::vector<std::size_t>& through);
  bool triangles(const StepItem& list, const Points& points,
                 const std::vector<std::size_t>& through, Points& faces);
  bool polygons(const StepItem& list, const Points& points, const std::vector<std::size_t>& through,
                Points& faces);

  const StepFile& file_;
  const FarPoints& far_;
  RecordWriter& out_;
  std::map<std::uint64_t, Points> lists_;  ///< numbers of the points written for a list
};

}  // namespace rubicon::ifc
