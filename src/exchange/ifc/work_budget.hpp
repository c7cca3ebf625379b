#pragma once

#include <algorithm>
#include <cstdint>

namespace rubicon::ifc {

/// How much may still be done for a file: what it says is not trusted, and some shapes take time
/// that grows with the square of their size. A step is a corner, a side, a plane or a record looked
/// at once. Steps are counted, not time: the same file is read, or not, on every machine and under
/// any load.
class WorkBudget {
 public:
  explicit WorkBudget(std::uint64_t steps) : steps_(steps), left_(steps) {}

  /// Takes `steps` away; false when that many are not left: give up then.
  bool spend(std::uint64_t steps) {
    if (steps > left_) {
      left_ = 0;
      is_spent_ = true;
      return false;
    }
    left_ -= steps;
    return true;
  }

  /// A budget of its own for one thing that can be left out when it takes too much: at most half of
  /// what is left, where half of all stays for what cannot. What it used is to be spent.
  WorkBudget share(std::uint64_t most) const {
    const std::uint64_t kept = steps_ / 2;
    return WorkBudget(left_ > kept ? std::min(most, (left_ - kept) / 2) : 0);
  }

  /// Whether something had to be given up.
  bool is_spent() const { return is_spent_; }
  std::uint64_t steps() const { return steps_; }
  std::uint64_t used() const { return steps_ - left_; }

 private:
  std::uint64_t steps_;
  std::uint64_t left_;
  bool is_spent_ = false;
};

}  // namespace rubicon::ifc
