#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "src/motion/math/pose.hpp"

namespace rubicon::ifc {

/// Collects the records of a STEP file that is being written, a line each.
class RecordWriter {
 public:
  /// New records get numbers behind `largest_id`.
  explicit RecordWriter(std::uint64_t largest_id) : next_(largest_id + 1) {}

  /// Writes a record under a number of its own; `body` is KEYWORD(...). Returns the number.
  std::uint64_t add(std::string_view body);
  /// Writes a record under the number it has.
  void put(std::uint64_t id, std::string_view body);

  /// IfcCartesianPoint; two coordinates with `flat`.
  std::uint64_t add_point(const math::Vec3& p, bool flat);
  /// IfcAxis2Placement3D.
  std::uint64_t add_placement(const math::Pose& X);

  const std::string& text() const { return text_; }

 private:
  std::uint64_t next_;
  std::string text_;
};

/// A number as STEP wants it: with a decimal point, every digit that counts.
std::string real_text(double value);

/// "#1,#2".
std::string references_text(const std::vector<std::uint64_t>& ids);

}  // namespace rubicon::ifc
