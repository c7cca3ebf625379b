#pragma once

#include <string>

#include "src/results/gltf/binary_data.hpp"
#include "src/results/replay/replay.hpp"

namespace rubicon::gltf {

/// A glTF 2.0 document (Khronos, glTF 2.0 Specification, 2021): its JSON, whose one buffer has no
/// uri yet, and the bytes of that buffer.
// NOLINTNEXTLINE(bugprone-exception-escape): what moves the JSON throws nothing
struct Document {
  Json json;
  std::string binary;
};

struct FilmOptions {
  /// Seconds of the plan for one of the animation; 0: so many that it lasts a minute, but at
  /// least 1.
  double speed_up = 0;
};

/// The scene of a trace and one animation, "construction", of all that happened. Below one root
/// node, which turns z up into y up, stand the site, the components and the robots; an element of a
/// frame of a body is a node. A component is a node at each of its places and at the tool that
/// carries it, and only one of them has a size at a time. Throws std::invalid_argument, with a
/// message for the user, for what makes no film.
Document make_document(const replay::Replay& replay, const FilmOptions& options);

}  // namespace rubicon::gltf
