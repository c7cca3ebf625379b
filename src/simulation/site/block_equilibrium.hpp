#pragma once

#include <optional>
#include <vector>

#include "src/motion/math/pose.hpp"

namespace rubicon::site {

/// A rigid body that may move.
struct RigidBlock {
  math::Vec3 centre = math::Vec3::Zero();  ///< of its mass, {W}, m
  double mass = 0;                         ///< kg
  bool braced = false;                     ///< held from outside against turning and going sideways
};

/// Where a block rests on another, or on what cannot move: pressure and friction at the corners,
/// 1 mm inside of the sides.
struct BlockContact {
  int upper = 0;
  int lower = -1;                           ///< -1: what cannot move
  std::vector<math::Vec3> corners;          ///< {W}, m
  math::Vec3 normal = math::Vec3::UnitZ();  ///< unit, towards the upper block
};

/// Two blocks that cannot move against each other.
struct BlockJoint {
  int first = 0;
  int second = -1;  ///< -1: what cannot move
};

/// How a block begins to move, up to a common factor: its centre, and its turn about it.
struct BlockMotion {
  int block = 0;
  math::Vec3 move = math::Vec3::Zero();  ///< m
  math::Vec3 turn = math::Vec3::Zero();  ///< rad
  double size = 0;                       ///< m: how far its contacts are from its centre
};

/// Whether forces between rigid blocks can balance their weights: compression at the corners of
/// contacts, friction within an eight-sided pyramid inside of Coulomb's cone, which lies as the
/// contact does, whatever joints and braces have to give (Livesley 1978; Whiting, Ochsendorf and
/// Durand 2009). A linear programme finds the forces; what they leave over is the power of a motion
/// that no contact forbids and in which the centre of mass of all comes down. Empty: the forces
/// balance. Else the motion with the fewest parts, those that move only. Nothing: the programme was
/// not solved within its bound of iterations.
std::optional<std::vector<BlockMotion>> find_collapse(const std::vector<RigidBlock>& blocks,
                                                      const std::vector<BlockContact>& contacts,
                                                      const std::vector<BlockJoint>& joints,
                                                      double friction);

}  // namespace rubicon::site
