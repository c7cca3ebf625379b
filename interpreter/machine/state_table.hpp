#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace rubicon::interpreter {

/// A 128-bit hash; wide enough that two different states of a run never meet (2^-64 at 2^32
/// states).
struct Hash128 {
  std::uint64_t low = 0;
  std::uint64_t high = 0;
  friend bool operator==(const Hash128&, const Hash128&) = default;
};

/// Mixes words into a 128-bit hash; the same on every machine.
class StateHasher {
 public:
  void add(std::uint64_t word) {
    a_ = (std::rotl(a_ ^ word, 29) + b_) * 0x9e3779b97f4a7c15ull;
    b_ = std::rotl(b_ + word, 41) * 0xc2b2ae3d27d4eb4full ^ (a_ >> 32);
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value == 0 ? 0.0 : value)); }
  Hash128 finish() const {
    return {mix(a_ + 0x165667b19e3779f9ull * b_), mix(b_ ^ std::rotl(a_, 17))};
  }

 private:
  static std::uint64_t mix(std::uint64_t x) {
    x = (x ^ (x >> 33)) * 0xff51afd7ed558ccdull;
    x = (x ^ (x >> 33)) * 0xc4ceb9fe1a85ec53ull;
    return x ^ (x >> 33);
  }
  std::uint64_t a_ = 0x243f6a8885a308d3ull;
  std::uint64_t b_ = 0x13198a2e03707344ull;
};

/// Counts by 128-bit key: open addressing, grows by doubling, copies with its owner. Its memory is
/// bounded: before it would hold more than `kMostStates` keys it forgets them all.
class StateTable {
 public:
  /// A motion that comes back to a state within so many attempts is found out for certain. Reason:
  /// far more than the default budget (20000), and 12 MB.
  static constexpr std::size_t kMostStates = std::size_t{1} << 18;

  /// The count stored under `key`, created as `initial` if it is new; `inserted` tells which.
  std::uint32_t& find_or_insert(const Hash128& key, std::uint32_t initial, bool& inserted);
  void clear();
  std::size_t size() const { return size_; }

 private:
  struct Slot {
    Hash128 key;
    std::uint32_t count = 0;
    bool used = false;
  };
  void grow();
  std::uint32_t& restart_with(const Hash128& key, std::uint32_t initial, bool& inserted);
  std::vector<Slot> slots_;
  std::size_t size_ = 0;
};

}  // namespace rubicon::interpreter
