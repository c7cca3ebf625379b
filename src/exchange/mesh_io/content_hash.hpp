#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace rubicon::mesh_io {

using Digest = std::array<std::uint8_t, 32>;

/// SHA-256 (FIPS 180-4) of bytes that come piece by piece: equal digests stand for equal content,
/// also where somebody tries to make them differ.
class ContentHash {
 public:
  ContentHash();
  ContentHash(ContentHash&&) noexcept;
  ~ContentHash();

  void add(std::string_view bytes);
  /// The digest of all that was added. Call it once.
  Digest finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// 64 lower case hexadecimal digits.
std::string hex(const Digest& digest);

}  // namespace rubicon::mesh_io
