#pragma once

#include <span>

#include "src/motion/robot/robot_model.hpp"

/// What whole turns mean for the parameters of a robot (LANGUAGE 6): a cyclic angle is kept in
/// (-180, 180] and goes the short way round; a limited rotation keeps its turns, and of the angles
/// that point the same way the one in reach counts, unless a whole turn changes something else; of
/// anything else every value stands for itself.
/// The arithmetic is that of src/motion/math/turns.hpp. A tie, half a turn both ways, goes the way
/// the parameter prefers, but in `reduced`, where it is +180.
namespace rubicon::robot {

/// A value, or a difference of values, of a cyclic parameter in (-180, 180]; of others as it is.
double reduced(const Parameter& parameter, double value);

/// Reduces all cyclic angles of q to (-180, 180].
void normalise(const RobotModel& model, std::span<double> q);

/// How far it is from one value to another: the short way round for a cyclic parameter.
double way_between(const Parameter& parameter, double from, double to);

/// The value of a limited rotation that points as `value` does, lies in its range, and is nearest
/// to `current`. Other parameters, those that count their turns, and values of which none lies in
/// the range, come back as they are.
double nearest_turn_equivalent(const Parameter& parameter, double value, double current);

/// Whether an angle that points as `value` does lies in the range of a rotation.
bool has_turn_equivalent(const Parameter& parameter, double value);

/// The angle that has the axis of `value`, in either sense, nearest to `current`; a quarter turn
/// both ways goes the way the parameter prefers.
double nearest_axis(const Parameter& parameter, double value, double current);

}  // namespace rubicon::robot
