#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace rubicon::encoding {

using Digest = std::array<std::uint8_t, 32>;

/// SHA-256 (FIPS 180-4) of bytes that come piece by piece: equal digests stand for equal content,
/// also where somebody tries to make them differ.
class Sha256 {
 public:
  Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;
  ~Sha256();

  void add(std::string_view bytes);
  /// The digest of all that was added. Call it once.
  Digest finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// 64 lower case hexadecimal digits.
std::string hex(const Digest& digest);
/// Those of the digest of these bytes.
std::string sha256_hex(std::string_view bytes);

}  // namespace rubicon::encoding
