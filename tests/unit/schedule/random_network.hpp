#pragma once

#include <random>

#include "src/simulation/schedule/network.hpp"

namespace rubicon::test {

/// When the plans of random networks start.
inline constexpr const char* kRandomStart = "2026-03-05 09:20";

/// What a random network has.
struct RandomNetworkWanted {
  bool calendars = true;
  bool resources = true;
  bool lags = true;
  bool forward = false;  ///< only links whose bound is in the future when it becomes known
  bool shares = false;   ///< crews of several, of whom tasks need some
};

/// The same networks from the same seed.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}

  int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }

  /// Up to 40 tasks whose links lead back in a random order, so not in file order.
  schedule::Network network(const RandomNetworkWanted& wanted);

 private:
  std::mt19937 engine_;
};

}  // namespace rubicon::test
