#include "src/results/gltf/binary_data.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace rubicon::gltf {

namespace {

// Numbers of the specification.
constexpr int kFloat = 5126;
constexpr int kVertexAttributes = 34962;

/// Low byte first, whatever the machine.
void append(std::string& bytes, float number) {
  const auto bits = std::bit_cast<std::uint32_t>(number);
  for (int shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>((bits >> shift) & 0xFF);
  }
}

}  // namespace

int BinaryData::add(View view, const Floats& numbers, std::size_t width, bool bounded) {
  constexpr const char* kTypes[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
  Json accessor = {{"bufferView", static_cast<int>(view)},
                   {"byteOffset", bytes_[view].size()},
                   {"componentType", kFloat},
                   {"count", numbers.size() / width},
                   {"type", kTypes[width]}};
  if (bounded) {
    Floats least(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(width));
    Floats most = least;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      least[i % width] = std::min(least[i % width], numbers[i]);
      most[i % width] = std::max(most[i % width], numbers[i]);
    }
    accessor["min"] = least;
    accessor["max"] = most;
  }
  for (const float number : numbers) append(bytes_[view], number);
  accessors_.push_back(std::move(accessor));
  return static_cast<int>(accessors_.size()) - 1;
}

int BinaryData::add_corners(const std::vector<Vec3>& corners, bool bounded) {
  Floats numbers;
  for (const Vec3& corner : corners) {
    for (int i = 0; i < 3; ++i) numbers.push_back(static_cast<float>(corner[i]) + 0.0F);
  }
  return add(corners_view, numbers, 3, bounded);
}

int BinaryData::add_times(const Floats& times) { return add(keys_view, times, 1, true); }

int BinaryData::add_values(const Floats& values, std::size_t width) {
  return add(keys_view, values, width, false);
}

std::string BinaryData::finish(Json& document) {
  if (accessors_.empty()) return {};
  std::string all;
  Json views = Json::array();
  std::vector<int> number(view_count, -1);
  for (int view = 0; view < view_count; ++view) {
    if (bytes_[view].empty()) continue;
    number[static_cast<std::size_t>(view)] = static_cast<int>(views.size());
    Json entry = {{"buffer", 0}, {"byteOffset", all.size()}, {"byteLength", bytes_[view].size()}};
    if (view == corners_view) {
      entry["byteStride"] = 3 * sizeof(float);
      entry["target"] = kVertexAttributes;
    }
    views.push_back(std::move(entry));
    all += bytes_[view];
  }
  for (Json& accessor : accessors_) {
    accessor["bufferView"] = number[accessor["bufferView"].get<std::size_t>()];
  }
  document["accessors"] = std::move(accessors_);
  document["bufferViews"] = std::move(views);
  document["buffers"] = Json::array({{{"byteLength", all.size()}}});
  return all;
}

}  // namespace rubicon::gltf
