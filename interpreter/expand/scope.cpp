#include "interpreter/expand/scope.hpp"

namespace rubicon::interpreter::expansion {

std::optional<Value> find_value(const Scope& scope, const std::string& name, bool& known) {
  known = true;
  for (auto each = scope.variables.rbegin(); each != scope.variables.rend(); ++each) {
    if (each->name != name) continue;
    Value value;
    value.number = static_cast<double>(each->value);
    return value;
  }
  const auto parameter = scope.parameters.find(name);
  if (parameter != scope.parameters.end()) return parameter->second.value;
  known = false;
  return std::nullopt;
}

std::string near_name(Scope& scope, const std::string& name) {
  return scope.suggestions.ending(name, [&] {
    std::vector<std::string> names;
    for (const Scope::Variable& each : scope.variables) names.push_back(each.name);
    for (const auto& [each, parameter] : scope.parameters) names.push_back(each);
    return names;
  });
}

}  // namespace rubicon::interpreter::expansion
