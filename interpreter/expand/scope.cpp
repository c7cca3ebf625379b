#include "interpreter/expand/scope.hpp"

#include <algorithm>

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
  if (scope.importer != nullptr && scope.later.count(name) == 0) {
    return find_value(*scope.importer, name, known);
  }
  known = false;
  return std::nullopt;
}

bool is_own_name(const Scope& scope, const std::string& name) {
  return scope.parameters.count(name) != 0 ||
         std::any_of(scope.variables.begin(), scope.variables.end(),
                     [&](const Scope::Variable& each) { return each.name == name; });
}

const Scope* declared_later(const Scope& scope, const std::string& name) {
  const Scope* each = &scope;
  while (each != nullptr && each->later.count(name) == 0) each = each->importer;
  return each;
}

bool may_be_declared(const Scope& scope) {
  const Scope* each = &scope;
  while (each != nullptr && !each->broken) each = each->importer;
  return each != nullptr;
}

std::string near_name(Scope& scope, const std::string& name) {
  return scope.suggestions.ending(name, [&] {
    std::vector<std::string> names;
    for (const Scope::Variable& each : scope.variables) names.push_back(each.name);
    for (const Scope* plan = &scope; plan != nullptr; plan = plan->importer) {
      for (const auto& [each, parameter] : plan->parameters) names.push_back(each);
    }
    return names;
  });
}

}  // namespace rubicon::interpreter::expansion
