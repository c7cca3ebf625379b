#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "src/exchange/ifc/ifc_faces.hpp"
#include "src/exchange/ifc/ifc_far_points.hpp"
#include "src/exchange/ifc/record_writer.hpp"
#include "src/exchange/ifc/step_file.hpp"
#include "src/exchange/ifc/step_values.hpp"

namespace rubicon::ifc {

/// Writes shapes in the words of IFC 2x3 that the library understands. Records keep their numbers
/// and are written once, however many shapes have them.
class ShapeWriter {
 public:
  /// All must outlive this object. Writes the context that all shapes are in.
  ShapeWriter(const StepFile& file, double metres_per_unit, const FarPoints& far,
              RecordWriter& out);

  /// The IfcGeometricRepresentationContext.
  std::uint64_t context() const { return context_; }

  /// Writes the body of an IfcProductDefinitionShape; the number of what was written, 0 if it has
  /// none that can be written whole.
  std::uint64_t write(std::uint64_t shape);

 private:
  enum class State { open, kept, dropped };

  bool keep(std::uint64_t root);
  std::vector<std::uint64_t> needs(const StepRecord& record) const;
  bool is_kept(std::uint64_t id) const;
  bool write_record(const StepRecord& record);
  bool write_representation(const StepRecord& record);
  bool write_curve(const StepRecord& record);
  bool write_profile(const StepRecord& record);
  bool write_plain(const StepRecord& record);
  bool write_far_point(std::uint64_t id, const StepItem& coordinates);
  std::uint64_t stand_in(std::string_view keyword, std::size_t index) const;
  bool write_value(const StepItem& item, bool reals, std::string& out) const;

  const StepFile& file_;
  double metres_per_unit_;
  const FarPoints& far_;
  RecordWriter& out_;
  FaceWriter faces_;
  std::unordered_map<std::uint64_t, State> state_;
  std::uint64_t origin_ = 0, flat_origin_ = 0, context_ = 0;
};

}  // namespace rubicon::ifc
