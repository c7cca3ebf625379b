#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/motion/guides/lattice.hpp"

namespace rubicon::guides {

/// A field over the configurations of a robot: it draws to the goal and pushes away from what is
/// near. With d, the weighted distance to the goal, and r, the least distance (m) between anything
/// that the robot can move and anything that stands,
///
///     U = d^2 / 2 * (attraction + repulsion * (1 / r - 1 / influence)^2)
///
/// where r is less than `influence`, and without the second term elsewhere (O. Khatib, IJRR 5,
/// 1986; that the repulsion vanishes at the goal: S. S. Ge, Y. J. Cui, IEEE Trans. Robotics and
/// Automation 16, 2000). It is infinite where the robot may not stand. Pairs that touch at the
/// start or at the goal repel nowhere: what the robot stands on, what it shall lay something on.
class PotentialField {
 public:
  static constexpr double kBlocked = std::numeric_limits<double>::infinity();

  /// The space must outlive it.
  PotentialField(Space& space, const Point& start, Point goal);

  double value(const Point& point);
  /// The pair that comes nearest, however far; the field there is made of it.
  Nearness nearest(const Point& point);

 private:
  void leave_out_touching(const Point& point);

  Space& space_;
  Point goal_;
  PairsLeftOut left_out_;
};

/// The field at the nodes of a lattice, and the ways down from them.
class FieldOnLattice {
 public:
  FieldOnLattice(Space& space, const Point& start, const Point& goal)
      : space_(space), field_(space, start, goal), lattice_(space, start, goal) {}

  double value(const Lattice::Node& node);
  /// The neighbour with the least value that is below that of the node, and to which a free leg
  /// leads; none: it is a minimum.
  std::optional<Lattice::Node> below(const Lattice::Node& node);

  const Lattice& lattice() const { return lattice_; }
  PotentialField& field() { return field_; }

 private:
  friend class Descent;
  std::optional<Lattice::Node> lowest(const Point& from, double value,
                                      const std::vector<Lattice::Node>& nodes);

  Space& space_;
  PotentialField field_;
  Lattice lattice_;
  std::map<Lattice::Node, double> values_;
};

}  // namespace rubicon::guides
