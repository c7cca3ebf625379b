#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "src/motion/math/pose.hpp"

namespace rubicon::mesh_io {

/// A mesh file as text whose corners count from another point.
struct NearText {
  std::string text;
  math::Vec3 origin = math::Vec3::Zero();  ///< of the numbers in `text`, in those of the file
};

/// Moves the corners of a text near its origin where they all lie far out, as in national
/// coordinates: the library would round them to single precision. Corners are lines that begin with
/// `word` ("v" in OBJ, "vertex" in STL) and three numbers. Nothing where they lie near enough, or a
/// line is not of that form.
std::optional<NearText> move_near(std::string_view text, std::string_view word);

}  // namespace rubicon::mesh_io
