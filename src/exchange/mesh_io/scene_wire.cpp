#include "src/exchange/mesh_io/scene_wire.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

namespace rubicon::mesh_io {

namespace {

constexpr std::string_view kWireMagic = "rubicon-mesh 5\n";
constexpr std::string_view kEnd = "end\n";
constexpr std::size_t kLongestName = 1024;        // assimp's own limit
constexpr std::size_t kLongestNote = 1000;        // a message for people
constexpr std::size_t kLongestFailure = 1000;     // a message for people
constexpr std::size_t kLongestPathBeside = 4096;  // of a file beside the mesh
constexpr std::size_t kMostFilesBeside = 1000;
constexpr std::uint8_t kScene = 1;
constexpr std::uint8_t kFailure = 2;

template <class T>
bool put(const ByteSink& sink, T value) {
  static_assert(std::is_trivially_copyable_v<T>);
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  return sink({bytes, sizeof(T)});
}

bool put_text(const ByteSink& sink, std::string_view text) {
  return put(sink, static_cast<std::uint32_t>(text.size())) && sink(text);
}

bool put_node(const ByteSink& sink, const FileNode& node) {
  const std::string_view name = std::string_view(node.name).substr(0, kLongestName);
  const std::string_view note = std::string_view(node.note).substr(0, kLongestNote);
  if (!put_text(sink, name) || !put_text(sink, note) ||
      !put(sink, static_cast<std::int32_t>(node.parent)) ||
      !put(sink, static_cast<std::uint64_t>(node.vertices.size())) ||
      !put(sink, static_cast<std::uint64_t>(node.triangles.size()))) {
    return false;
  }
  for (const math::Vec3& p : node.vertices) {
    if (!put(sink, p.x()) || !put(sink, p.y()) || !put(sink, p.z())) return false;
  }
  for (const std::array<int, 3>& t : node.triangles) {
    for (const int index : t) {
      if (!put(sink, static_cast<std::int32_t>(index))) return false;
    }
  }
  return true;
}

/// Names of files beside the mesh; too many, or too long ones, become one that is no name: a scene
/// of which not all files are known is not remembered.
bool put_files_beside(const ByteSink& sink, const std::vector<std::string>& files) {
  const bool fits = files.size() <= kMostFilesBeside &&
                    std::all_of(files.begin(), files.end(), [](const std::string& file) {
                      return file.size() <= kLongestPathBeside;
                    });
  if (!fits) return put(sink, std::uint32_t{1}) && put_text(sink, "");
  if (!put(sink, static_cast<std::uint32_t>(files.size()))) return false;
  return std::all_of(files.begin(), files.end(),
                     [&](const std::string& file) { return put_text(sink, file); });
}

bool put_scene(const ByteSink& sink, const FileScene& scene) {
  if (!put(sink, scene.declared_metres_per_unit) ||
      !put(sink, static_cast<std::uint8_t>(scene.in_metres ? 1 : 0)) ||
      !put(sink, static_cast<std::uint8_t>(scene.y_up ? 1 : 0)) ||
      !put_files_beside(sink, scene.files_beside) || !put(sink, scene.origin.x()) ||
      !put(sink, scene.origin.y()) || !put(sink, scene.origin.z()) ||
      !put(sink, static_cast<std::uint64_t>(scene.nodes.size()))) {
    return false;
  }
  for (const FileNode& node : scene.nodes) {
    if (!put_node(sink, node)) return false;
  }
  return true;
}

/// Takes values off the front of a message; every call says whether there was enough.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  std::size_t left() const { return bytes_.size(); }

  template <class T>
  bool get(T& value) {
    if (bytes_.size() < sizeof(T)) return false;
    std::memcpy(&value, bytes_.data(), sizeof(T));
    bytes_.remove_prefix(sizeof(T));
    return true;
  }

  bool get_text(std::size_t most, std::string_view& text) {
    std::uint32_t size = 0;
    if (!get(size) || size > most || size > bytes_.size()) return false;
    text = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return true;
  }

  bool skip(std::string_view expected) {
    if (bytes_.substr(0, expected.size()) != expected) return false;
    bytes_.remove_prefix(expected.size());
    return true;
  }

 private:
  std::string_view bytes_;
};

/// Reads one node; the message says what was wrong, empty when nothing was.
std::string get_node(Reader& in, std::size_t index, std::uint64_t triangles_left, FileNode& node) {
  std::string_view name;
  std::string_view note;
  std::int32_t parent = 0;
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  if (!in.get_text(kLongestName, name) || !in.get_text(kLongestNote, note) || !in.get(parent) ||
      !in.get(vertices) || !in.get(triangles)) {
    return "a node is cut off";
  }
  if (parent < -1 || (parent >= 0 && static_cast<std::size_t>(parent) >= index)) {
    return "a node has no parent before it";
  }
  if (triangles > triangles_left || vertices > 3 * triangles) return "more than was allowed";
  if (in.left() < vertices * 3 * sizeof(double) + triangles * 3 * sizeof(std::int32_t)) {
    return "a node is cut off";
  }
  node.name = printable(name, kLongestName);
  node.note = printable(note, kLongestNote);
  node.parent = parent;
  node.vertices.resize(vertices);
  node.triangles.resize(triangles);
  for (math::Vec3& p : node.vertices) {
    for (int k = 0; k < 3; ++k) in.get(p[k]);
  }
  for (std::array<int, 3>& t : node.triangles) {
    for (int& corner : t) {
      std::int32_t value = 0;
      in.get(value);
      if (value < 0 || static_cast<std::uint64_t>(value) >= vertices) {
        return "a triangle names a corner that is not there";
      }
      corner = value;
    }
  }
  return {};
}

bool get_files_beside(Reader& in, std::vector<std::string>& files) {
  std::uint32_t count = 0;
  if (!in.get(count) || count > kMostFilesBeside) return false;
  for (std::uint32_t i = 0; i < count; ++i) {
    std::string_view file;
    if (!in.get_text(kLongestPathBeside, file)) return false;
    files.emplace_back(file);
  }
  return true;
}

std::variant<SceneMessage, WireError> get_scene(Reader& in, const SceneLimits& limits) {
  FileScene scene;
  std::uint8_t in_metres = 0;
  std::uint8_t y_up = 0;
  std::uint64_t count = 0;
  if (!in.get(scene.declared_metres_per_unit) || !in.get(in_metres) || !in.get(y_up) ||
      !get_files_beside(in, scene.files_beside) || !in.get(scene.origin.x()) ||
      !in.get(scene.origin.y()) || !in.get(scene.origin.z()) || !in.get(count)) {
    return WireError{"the head of the scene is cut off"};
  }
  if (count > limits.nodes) return WireError{"more nodes than were allowed"};
  scene.in_metres = in_metres != 0;
  scene.y_up = y_up != 0;
  std::uint64_t triangles_left = limits.triangles;
  for (std::size_t i = 0; i < count; ++i) {
    FileNode node;
    std::string wrong = get_node(in, i, triangles_left, node);
    if (!wrong.empty()) return WireError{std::move(wrong)};
    triangles_left -= node.triangles.size();
    scene.nodes.push_back(std::move(node));
  }
  return SceneMessage{std::move(scene)};
}

/// Length of the well-formed UTF-8 character at the front, 0 if there is none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const auto tail = [&](std::size_t i) { return i < text.size() && (byte(i) & 0xC0) == 0x80; };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return tail(1) ? 2 : 0;
  if (lead >= 0xE0 && lead <= 0xEF) {
    if (!tail(1) || !tail(2)) return 0;
    if (lead == 0xE0 && byte(1) < 0xA0) return 0;   // overlong
    if (lead == 0xED && byte(1) >= 0xA0) return 0;  // surrogate
    return 3;
  }
  if (lead >= 0xF0 && lead <= 0xF4) {
    if (!tail(1) || !tail(2) || !tail(3)) return 0;
    if (lead == 0xF0 && byte(1) < 0x90) return 0;   // overlong
    if (lead == 0xF4 && byte(1) >= 0x90) return 0;  // beyond U+10FFFF
    return 4;
  }
  return 0;
}

}  // namespace

bool encode(const SceneMessage& message, const ByteSink& sink) {
  if (!sink(kWireMagic)) return false;
  if (const auto* failure = std::get_if<std::string>(&message)) {
    return put(sink, kFailure) &&
           put_text(sink, std::string_view(*failure).substr(0, kLongestFailure)) && sink(kEnd);
  }
  return put(sink, kScene) && put_scene(sink, std::get<FileScene>(message)) && sink(kEnd);
}

std::uint64_t largest_message(const SceneLimits& limits) {
  constexpr std::uint64_t kHead =
      64 + kMostFilesBeside * (sizeof(std::uint32_t) + kLongestPathBeside);
  constexpr std::uint64_t kNode = 28 + kLongestName + kLongestNote;
  constexpr std::uint64_t kTriangle = 9 * sizeof(double) + 3 * sizeof(std::int32_t);
  return kHead + limits.nodes * kNode + limits.triangles * kTriangle + kEnd.size();
}

std::variant<SceneMessage, WireError> decode(std::string_view bytes, const SceneLimits& limits) {
  Reader in(bytes);
  std::uint8_t kind = 0;
  if (!in.skip(kWireMagic) || !in.get(kind)) return WireError{"it does not begin as a mesh does"};
  SceneMessage message;
  if (kind == kFailure) {
    std::string_view text;
    if (!in.get_text(kLongestFailure, text)) return WireError{"its failure message is cut off"};
    message = printable(text, kLongestFailure);
  } else if (kind == kScene) {
    std::variant<SceneMessage, WireError> scene = get_scene(in, limits);
    if (std::holds_alternative<WireError>(scene)) return scene;
    message = std::move(std::get<SceneMessage>(scene));
  } else {
    return WireError{"it is neither a mesh nor a failure"};
  }
  if (!in.skip(kEnd) || in.left() != 0) return WireError{"it does not end where it should"};
  return message;
}

std::string printable(std::string_view text, std::size_t most) {
  std::string result;
  while (!text.empty() && result.size() < most) {
    const std::size_t length = utf8_length(text);
    const auto lead = static_cast<unsigned char>(text[0]);
    const bool control = length == 1 && (lead < 0x20 || lead == 0x7F);
    if (length == 0 || control) {
      result += '?';
      text.remove_prefix(1);
    } else {
      if (result.size() + length > most) break;
      result += text.substr(0, length);
      text.remove_prefix(length);
    }
  }
  return result;
}

}  // namespace rubicon::mesh_io
