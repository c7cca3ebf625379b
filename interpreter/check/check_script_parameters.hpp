#pragma once

#include <set>
#include <string>
#include <vector>

#include "interpreter/check/check_script_parts.hpp"
#include "interpreter/check/check_script_values.hpp"

namespace rubicon::interpreter::script_check {

/// A control parameter that a script names.
struct Parameter {
  ValueKind kind = ValueKind::unknown;      ///< angle or length; unknown where the name is wrong
  const robot::Parameter* model = nullptr;  ///< null: wrong name, or no robot is known
};

/// Resolves the control parameters of a script: S08, S09.
class ParameterNames {
 public:
  ParameterNames(const Subject& subject, Diagnostics& diagnostics);

  /// The parameter of that name, null if it is wrong or no robot is known; says nothing.
  const robot::Parameter* find(const syntax::QualifiedName& name) const;

  /// The parameter of that name; a wrong one is said at `place`, once in a statement.
  Parameter resolve(const syntax::QualifiedName& name, Span place);
  void next_statement() { wrong_names_.clear(); }

  /// False, and said at `place`, if no command can move the parameter.
  bool check_movable(const Parameter& parameter, Span place);

 private:
  std::string wrong_name_text(const syntax::QualifiedName& name, bool is_parameter_name);
  std::string wrong_body_text(const syntax::QualifiedName& name);
  std::string other_way(const std::string& name, const std::vector<std::string>& parameters) const;

  const ScriptContext& context_;
  Diagnostics& diagnostics_;
  std::set<std::string> variables_;    // those the script assigns
  std::set<std::string> wrong_names_;  // already said in this statement
  Suggester bodies_;
};

}  // namespace rubicon::interpreter::script_check
