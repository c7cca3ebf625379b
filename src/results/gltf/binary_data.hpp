#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "src/motion/math/pose.hpp"

namespace rubicon::gltf {

using Json = nlohmann::ordered_json;
using math::Vec3;

/// A row of numbers of the binary part, as floats, `width` numbers an element.
using Floats = std::vector<float>;

/// The binary part of a document: what its accessors and buffer views speak of.
class BinaryData {
 public:
  /// Positions or normals of corners; returns the number of the accessor.
  int add_corners(const std::vector<Vec3>& corners, bool bounded);
  /// Times of keys, increasing.
  int add_times(const Floats& times);
  /// Values of keys: translations and scales (width 3), rotations (4).
  int add_values(const Floats& values, std::size_t width);

  /// Writes `accessors`, `bufferViews` and `buffers` (without uri) and returns the bytes.
  std::string finish(Json& document);

 private:
  enum View { corners_view, keys_view, view_count };
  int add(View view, const Floats& numbers, std::size_t width, bool bounded);

  std::string bytes_[view_count];
  Json accessors_ = Json::array();
};

}  // namespace rubicon::gltf
