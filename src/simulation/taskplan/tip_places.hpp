#pragma once

#include "src/simulation/taskplan/stage.hpp"

namespace rubicon::taskplan {

/// Two places of the plan are one where their frames are the same.
bool is_same_place(const math::Pose& a, const math::Pose& b);

/// The task that hauls and has a place to tip: its truck is on its way there, tips, or stands there
/// still. -1: the place is free. `task`: what its own truck has does not count.
int who_tips_at(const Stage& stage, const math::Pose& X_WL, int task);

/// Whether all tasks that this one serves have dug all, by themselves or because they are left out.
bool all_is_dug(const Stage& stage, const interpreter::HaulSpec& haul);

/// A truck stands where it has tipped. The task that hauls and has nowhere else to tip; -1: none.
/// `for_good`: the truck goes nowhere from there, so those that are still to be loaded count, too.
int who_wants_the_tip_of(const Stage& stage, int task, bool for_good);

}  // namespace rubicon::taskplan
