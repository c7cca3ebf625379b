#pragma once

#include <cstdint>

namespace rubicon::ifc {

/// How much may still be done for a file: what it says is not trusted, and some shapes take time
/// that grows with the square of their size.
class WorkBudget {
 public:
  explicit WorkBudget(std::uint64_t steps) : left_(steps) {}

  /// Takes `steps` away; false when that many are not left: give up then.
  bool spend(std::uint64_t steps) {
    if (steps > left_) {
      left_ = 0;
      return false;
    }
    left_ -= steps;
    return true;
  }

 private:
  std::uint64_t left_;
};

}  // namespace rubicon::ifc
