#pragma once

#include <vector>

#include "src/results/verify/geometry/footing.hpp"

namespace rubicon::verify {

/// A rigid body with its weight, and what holds it.
struct BalancedBody {
  Vec3 centre = Vec3::Zero();  ///< of its mass, {W}, m
  double mass = 0;             ///< kg
  bool braced = false;         ///< any horizontal force and any moment from outside
};
/// A point at which a body rests on another.
struct BalancePoint {
  int upper = 0;
  int lower = -1;  ///< -1: what cannot move
  FootingPoint at;
};
/// Two bodies that give each other any force and moment.
struct BalanceJoint {
  int first = 0;
  int second = -1;  ///< -1: what cannot move
};
enum class Balance { holds, fails, not_known };

/// Whether forces at the points, along the edges of the pyramid of friction, add up to the weights:
/// the first phase of the revised simplex method with a full inverse. More than `kMostBodies` are
/// not known.
constexpr std::size_t kMostBodies = 120;
Balance balance_of(const std::vector<BalancedBody>& bodies, const std::vector<BalancePoint>& points,
                   const std::vector<BalanceJoint>& joints, double friction);

}  // namespace rubicon::verify
