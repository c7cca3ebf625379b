#pragma once

#include <string>
#include <utility>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/syntax/diagnostic.hpp"

namespace rubicon::site {

/// Two things that are in each other when a plan begins.
struct BeginningOverlap {
  interpreter::OverlapSpec pair;
  /// As waivers call them: a robot, not its body; nothing for things with a timetable.
  std::string first_owner, second_owner;
  /// Where the two stand in the plan; the site has no place.
  interpreter::Span first, second;
};

/// Which pairs of things that stand on the site at the beginning (its shapes, components, robots
/// with what they carry, things with a timetable that are there at 0 s) are in each other, and
/// which waivers are about a pair that is not.
struct Beginning {
  std::vector<BeginningOverlap> overlaps;  ///< by the second: components, robots, in their order
  std::vector<interpreter::Span> idle_waivers;
  /// Components that do not stand, and why; where the plan examines support.
  std::vector<std::pair<int, std::string>> floating;
};

/// Looks at the beginning of a plan: deeper than its contact tolerance is an overlap, waived pairs
/// are left out. What belongs to one robot, or to the site, is not compared. Throws
/// std::invalid_argument, naming the thing, for shapes without extent.
Beginning look_at_beginning(const interpreter::PlanModel& plan);

/// What is to be said of it: P33, P34, P45.
std::vector<interpreter::Diagnostic> warnings_of(const interpreter::PlanModel& plan,
                                                 const Beginning& beginning);

}  // namespace rubicon::site
