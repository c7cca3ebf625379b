#include "interpreter/functions/function_table.hpp"

#include <algorithm>
#include <cmath>

#include "src/motion/math/angles.hpp"
#include "src/motion/robot/turns.hpp"

namespace rubicon::interpreter {

namespace {

using Values = std::span<const double>;

const robot::Parameter& parameter(const FunctionScope& motion, int index) {
  return motion.model().parameters[static_cast<std::size_t>(index)];
}

double q(const FunctionScope& motion, int index) {
  return motion.q()[static_cast<std::size_t>(index)];
}

/// From where the parameter stands to a value.
double way_to(const FunctionScope& motion, int index, double value) {
  return robot::way_between(parameter(motion, index), q(motion, index), value);
}

/// A whole step must get nearer: a dead band of half a step, else robots turn to and fro for ever.
/// What is exactly half a step away is in it, however it was rounded.
double direction_to(const FunctionScope& motion, int index, double value) {
  constexpr double kHalfAStep = 0.5 * (1 + 1e-6);
  const double way = way_to(motion, index, value);
  if (std::fabs(way) <= kHalfAStep * parameter(motion, index).quantum) return 0;
  return way > 0 ? 1 : -1;
}

int place(double value) { return static_cast<int>(value); }

/// The heading less the bearing of the goal: within half a turn at the place, then unwrapped
/// (Lee and Adams, ACE, restarted at each hit).
double off_course(const FunctionScope& motion, int index, int from) {
  const WayLog& way = motion.way();
  const double facing =
      robot::relative_goal(motion.model(), motion.mounting(), motion.q(), index, motion.p_WG());
  // What is off now, up to whole turns; the log knows how many.
  const double now = robot::way_between(parameter(motion, index), facing, q(motion, index));
  const double then = now - way.changed(index, from) + way.bearing_turned(from);
  return now - 360 * std::ceil(then / 360 - 0.5);
}

constexpr Function kFunctions[] = {
    {.name = "goal",
     .arguments = {Argument::parameter},
     .result = Result::of_parameter,
     .reads = Reads::fixed,
     .text = "the value of p in the goal configuration",
     .evaluate = [](FunctionScope& motion, int p, Values) -> double {
       return motion.goal()[static_cast<std::size_t>(p)];
     }},
    {.name = "r_goal",
     .arguments = {Argument::parameter},
     .result = Result::of_parameter,
     .text = "the value of p, all others left alone, that is nearest to the goal or faces it",
     .evaluate = [](FunctionScope& motion, int p, Values) -> double {
       return robot::relative_goal(motion.model(), motion.mounting(), motion.q(), p, motion.p_WG());
     }},
    {.name = "dir",
     .arguments = {Argument::parameter, Argument::value_of_parameter},
     .result = Result::direction,
     .text = "the direction in which a step of p gets nearer to v: 1, -1, or 0 within half a step",
     .evaluate = [](FunctionScope& motion, int p, Values values) -> double {
       return direction_to(motion, p, values[0]);
     }},
    {.name = "axis",
     .arguments = {Argument::rotation, Argument::value_of_parameter},
     .result = Result::of_parameter,
     .text = "v turned by half turns to within 90 degrees of where p is",
     .evaluate = [](FunctionScope& motion, int p, Values values) -> double {
       return robot::nearest_axis(parameter(motion, p), values[0], q(motion, p));
     }},
    {.name = "min",
     .arguments = {Argument::lower_limited},
     .result = Result::of_parameter,
     .reads = Reads::fixed,
     .text = "the lower limit of p",
     .evaluate = [](FunctionScope& motion, int p, Values) -> double {
       return parameter(motion, p).lower;
     }},
    {.name = "min",
     .arguments = {Argument::parameter, Argument::value_of_parameter},
     .result = Result::of_parameter,
     .text = "the smaller of v and the value of p now",
     .evaluate = [](FunctionScope& motion, int p, Values values) -> double {
       return std::min(q(motion, p), values[0]);
     }},
    {.name = "max",
     .arguments = {Argument::upper_limited},
     .result = Result::of_parameter,
     .reads = Reads::fixed,
     .text = "the upper limit of p",
     .evaluate = [](FunctionScope& motion, int p, Values) -> double {
       return parameter(motion, p).upper;
     }},
    {.name = "max",
     .arguments = {Argument::parameter, Argument::value_of_parameter},
     .result = Result::of_parameter,
     .text = "the larger of v and the value of p now",
     .evaluate = [](FunctionScope& motion, int p, Values values) -> double {
       return std::max(q(motion, p), values[0]);
     }},
    {.name = "dist",
     .result = Result::length,
     .text = "the straight distance from the tool to the goal position",
     .evaluate = [](FunctionScope& motion, int, Values) -> double {
       return motion.distance_to_goal();
     }},
    {.name = "dist",
     .arguments = {Argument::parameter, Argument::value_of_parameter},
     .result = Result::of_parameter,
     .text = "how far p is from v, the short way round for angles",
     .evaluate = [](FunctionScope& motion, int p, Values values) -> double {
       return std::fabs(way_to(motion, p, values[0]));
     }},
    {.name = "clear",
     .arguments = {Argument::movable_parameter, Argument::direction_of_parameter},
     .result = Result::condition,
     .reads = Reads::site,
     .text = "whether move_dir(p, d) would be accepted now",
     .evaluate = [](FunctionScope& motion, int p, Values values) -> double {
       return motion.would_accept(p, values[0]) ? 1 : 0;
     }},
    {.name = "free",
     .arguments = {Argument::angle},
     .result = Result::length,
     .reads = Reads::sensor,
     .text = "how far the robot could be pushed along heading a before it touches",
     .evaluate = [](FunctionScope& motion, int, Values values) -> double {
       return motion.free_distance(values[0]);
     }},
    {.name = "moving",
     .arguments = {Argument::angle},
     .result = Result::condition,
     .reads = Reads::sensor,
     .text = "whether what the robot would touch first along heading a, as far as it senses, moves",
     .evaluate = [](FunctionScope& motion, int, Values values) -> double {
       return motion.is_met_moving(values[0]) ? 1 : 0;
     }},
    {.name = "here",
     .result = Result::place,
     .text = "this place on the way, to be kept in a variable: var(hit) = here()",
     .evaluate = [](FunctionScope& motion, int, Values) -> double { return motion.way().here(); }},
    {.name = "back_at",
     .arguments = {Argument::place},
     .result = Result::condition,
     .text = "whether the robot is back at w, within half a step of all its parameters",
     .evaluate = [](FunctionScope& motion, int, Values values) -> double {
       return motion.way().is_at(motion.model(), place(values[0])) ? 1 : 0;
     }},
    {.name = "turned",
     .arguments = {Argument::rotation, Argument::place},
     .result = Result::of_parameter,
     .text = "by how much p has turned since w, whole turns counted",
     .evaluate = [](FunctionScope& motion, int p, Values values) -> double {
       return motion.way().changed(p, place(values[0]));
     }},
    {.name = "off_course",
     .arguments = {Argument::rotation, Argument::place},
     .result = Result::of_parameter,
     .text = "by how much p is turned from facing the goal, turns since w counted",
     .evaluate = [](FunctionScope& motion, int p, Values values) -> double {
       return off_course(motion, p, place(values[0]));
     }},
    {.name = "crossed",
     .arguments = {Argument::place},
     .result = Result::condition,
     .text = "whether the last step crossed the line from w to the goal, nearer to it than w",
     .evaluate = [](FunctionScope& motion, int, Values values) -> double {
       return motion.way().crossed(place(values[0]), motion.p_WG()) ? 1 : 0;
     }},
    {.name = "circled",
     .arguments = {Argument::place},
     .result = Result::number,
     .text =
         "1 if the last step closed a loop of the way since w anticlockwise, -1 clockwise, or 0",
     .evaluate = [](FunctionScope& motion, int, Values values) -> double {
       return motion.way().circled(place(values[0]));
     }},
    {.name = "time",
     .result = Result::time,
     .reads = Reads::clock,
     .text = "seconds since the motion began",
     .evaluate = [](FunctionScope& motion, int, Values) -> double { return motion.seconds(); }},
    {.name = "abs",
     .arguments = {Argument::value},
     .result = Result::of_argument,
     .reads = Reads::fixed,
     .text = "v without its sign",
     .evaluate = [](FunctionScope&, int, Values values) -> double { return std::fabs(values[0]); }},
    {.name = "sin",
     .arguments = {Argument::angle},
     .result = Result::number,
     .reads = Reads::fixed,
     .text = "the sine of a",
     .evaluate = [](FunctionScope&, int, Values values) -> double {
       return math::sin_deg(values[0]);
     }},
    {.name = "cos",
     .arguments = {Argument::angle},
     .result = Result::number,
     .reads = Reads::fixed,
     .text = "the cosine of a",
     .evaluate = [](FunctionScope&, int, Values values) -> double {
       return math::cos_deg(values[0]);
     }},
};

char letter(Argument argument) {
  switch (argument) {
    case Argument::value_of_parameter:
    case Argument::value:
      return 'v';
    case Argument::direction_of_parameter:
      return 'd';
    case Argument::angle:
      return 'a';
    case Argument::place:
      return 'w';
    default:
      return 'p';
  }
}

}  // namespace

std::size_t Function::argument_count() const {
  const auto* end = std::find(arguments.begin(), arguments.end(), Argument::none);
  return static_cast<std::size_t>(end - arguments.begin());
}

bool Function::takes_parameter() const {
  return arguments[0] != Argument::none && letter(arguments[0]) == 'p';
}

std::span<const Function> functions() { return kFunctions; }

const Function* find_function(std::string_view name) {
  for (const Function& function : kFunctions) {
    if (function.name == name) return &function;
  }
  return nullptr;
}

const Function* find_function(std::string_view name, std::size_t arguments) {
  for (const Function& function : kFunctions) {
    if (function.name == name && function.argument_count() == arguments) return &function;
  }
  return nullptr;
}

std::vector<std::string> function_names() {
  std::vector<std::string> names;
  for (const Function& function : kFunctions) {
    if (names.empty() || names.back() != function.name) names.emplace_back(function.name);
  }
  return names;
}

std::string signature(const Function& function) {
  std::string text = std::string(function.name) + "(";
  for (std::size_t i = 0; i < function.argument_count(); ++i) {
    if (i > 0) text += ", ";
    text += letter(function.arguments[i]);
  }
  return text + ")";
}

}  // namespace rubicon::interpreter
