#pragma once

#include <string>
#include <vector>

/// The functions of the motion language (LANGUAGE section 4).
namespace rubicon::interpreter::script_check {

enum class FunctionId { goal, r_goal, dir, axis, min, max, dist, clear, free, time, abs, sin, cos };

struct Function {
  const char* name;
  FunctionId id;
  std::vector<std::size_t> argument_counts;  ///< allowed numbers of arguments, ascending
  bool takes_parameter;  ///< the first argument, if any, must be a control parameter
};

/// All functions, in the order of the reference.
const std::vector<Function>& functions();

/// The function of that name, null if there is none.
const Function* find_function(const std::string& name);

}  // namespace rubicon::interpreter::script_check
