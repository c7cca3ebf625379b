#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <variant>

#include "src/exchange/mesh_io/file_scene.hpp"

namespace rubicon::mesh_io {

/// Takes the next bytes of a message; false when they cannot be delivered.
using ByteSink = std::function<bool(std::string_view)>;

/// What the helper has to say: a scene, or why there is none.
using SceneMessage = std::variant<FileScene, std::string>;

/// Writes a message as bytes, piece by piece. Both ends run on the same machine: numbers go in its
/// own byte order. False when the sink failed.
bool encode(const SceneMessage& message, const ByteSink& sink);

/// Most bytes an encoded message within `limits` can have.
std::uint64_t largest_message(const SceneLimits& limits);

/// Reads a message from a sender that is not trusted: counts are checked against `limits` and the
/// bytes that are there before anything is allocated, indices must be in range, parents earlier,
/// names become printable UTF-8. The error says what was wrong with the message.
struct WireError {
  std::string message;
};
std::variant<SceneMessage, WireError> decode(std::string_view bytes, const SceneLimits& limits);

/// Bytes of a name that a message shows.
inline constexpr std::size_t kLongestNameShown = 80;

/// `text` with everything that is not printable UTF-8 replaced by '?', at most `most` bytes.
std::string printable(std::string_view text, std::size_t most);

}  // namespace rubicon::mesh_io
