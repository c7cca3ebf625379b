#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/functions/function_scope.hpp"

/// The functions of the motion language (LANGUAGE section 4): one table that the checker, the
/// compiler, the machine and `rubicon help functions` read.
namespace rubicon::interpreter {

/// What may stand as an argument.
enum class Argument : std::uint8_t {
  none,
  // The first only: the name of a control parameter, of which more may be asked.
  parameter,
  movable_parameter,  ///< a command can move it
  rotation,           ///< an angle
  lower_limited,      ///< it has a minimum
  upper_limited,      ///< it has a maximum
  // Values.
  value_of_parameter,      ///< of the kind of the parameter before
  direction_of_parameter,  ///< a sign
  angle,
  place,  ///< on the way: what here() gave
  value,  ///< of any kind
};

/// What the result measures.
enum class Result : std::uint8_t {
  of_parameter,  ///< as the parameter
  of_argument,   ///< as the first value; of a direction a plain number
  direction,     ///< of the parameter; stored, a 0 becomes the preferred one
  condition,     ///< 1 or 0
  number,
  length,
  time,
  place,  ///< on the way; only kept in a variable and handed to functions
};

/// What the value depends on beside the arguments. What the motion does not change is `fixed`.
enum class Reads : std::uint8_t { fixed, configuration, site, sensor, clock };

/// Arguments of one function at most.
inline constexpr std::size_t kMostArguments = 4;

/// A function with one list of arguments; `min(p)` and `min(p, v)` are two.
struct Function {
  std::string_view name;
  std::array<Argument, kMostArguments> arguments{};
  Result result = Result::number;
  Reads reads = Reads::configuration;
  std::string_view text;  ///< one line for people, of p, v, d and a as `signature` names them
  /// The value. `parameter` is the index of the one that is named first, if any; `values` are the
  /// other arguments. What is not finite ends the motion.
  double (*evaluate)(FunctionScope& motion, int parameter,
                     std::span<const double> values) = nullptr;

  std::size_t argument_count() const;
  bool takes_parameter() const;
};

/// All functions, in the order of the reference; those of one name follow each other, the one with
/// fewer arguments first.
std::span<const Function> functions();

/// The first function of that name; null if there is none.
const Function* find_function(std::string_view name);

/// The function of that name with so many arguments; null if there is none.
const Function* find_function(std::string_view name, std::size_t arguments);

/// Each name once, in the order of the table.
std::vector<std::string> function_names();

/// As people write it: `min(p, v)`. p is a parameter, v a value, d a direction, a an angle, w a
/// place on the way.
std::string signature(const Function& function);

}  // namespace rubicon::interpreter
