#include "interpreter/check/check_script_functions.hpp"

namespace rubicon::interpreter::script_check {

const std::vector<Function>& functions() {
  static const std::vector<Function> kFunctions = {
      {"goal", FunctionId::goal, {1}, true},    {"r_goal", FunctionId::r_goal, {1}, true},
      {"dir", FunctionId::dir, {2}, true},      {"axis", FunctionId::axis, {2}, true},
      {"min", FunctionId::min, {1, 2}, true},   {"max", FunctionId::max, {1, 2}, true},
      {"dist", FunctionId::dist, {0, 2}, true}, {"clear", FunctionId::clear, {2}, true},
      {"free", FunctionId::free, {1}, false},   {"time", FunctionId::time, {0}, false},
      {"abs", FunctionId::abs, {1}, false},     {"sin", FunctionId::sin, {1}, false},
      {"cos", FunctionId::cos, {1}, false},
  };
  return kFunctions;
}

const Function* find_function(const std::string& name) {
  for (const Function& function : functions()) {
    if (name == function.name) return &function;
  }
  return nullptr;
}

}  // namespace rubicon::interpreter::script_check
