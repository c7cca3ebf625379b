#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace rubicon::robot {

/// Scratch space for one value per parameter or body of a robot: on the stack for every ordinary
/// robot, since motion steps are evaluated a million times a second, on the heap for larger ones.
/// Contents start undefined.
template <class T, std::size_t kInline = 32>
class InlineBuffer {
 public:
  explicit InlineBuffer(std::size_t size) : size_(size) {
    if (size > kInline) heap_.resize(size);
  }
  InlineBuffer(const InlineBuffer&) = delete;
  InlineBuffer& operator=(const InlineBuffer&) = delete;

  std::span<T> span() { return {size_ > kInline ? heap_.data() : inline_.data(), size_}; }
  T& operator[](std::size_t i) { return span()[i]; }

 private:
  std::size_t size_;
  std::array<T, kInline> inline_;
  std::vector<T> heap_;
};

}  // namespace rubicon::robot
