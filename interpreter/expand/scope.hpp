#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/syntax/name_suggestion.hpp"
#include "interpreter/syntax/syntax.hpp"

/// What the files of this folder share.
namespace rubicon::interpreter::expansion {

/// What an expression gives: a number with its dimension, a text or a condition.
struct Value {
  enum class Kind { number, text, condition };
  Kind kind = Kind::number;
  double number = 0;  ///< in base units; of a condition 0 or 1
  syntax::Dimension dimension = {};
  std::string text = {};
};

struct Parameter {
  std::optional<Value> value;  ///< none: it is wrong, which was said
  Span span;
};

/// The names that can stand in an expression, and in the copy they stand in.
struct Scope {
  struct Variable {
    std::string name;
    std::int64_t value = 0;
    Span span;
  };
  std::map<std::string, Parameter> parameters = {};
  std::map<std::string, Span> later = {};  ///< parameters that are declared further down
  std::vector<Variable> variables = {};    ///< of the `for` around, the innermost last
  const Scope* importer = nullptr;         ///< of the plan that imports this one
  bool broken = false;  ///< a mistake in the syntax: what is unknown may be declared there
  std::uint32_t copy = 0;
  std::string prefix = {};  ///< of its names in the plan that is run: "yard."
  NameSuggestions suggestions = {};
};

/// The value of a parameter or variable, of this plan before those that import it; nothing where
/// the name is unknown (`known` false) or its declaration wrong.
std::optional<Value> find_value(const Scope& scope, const std::string& name, bool& known);

/// Whether it is a parameter or a variable of this plan itself.
bool is_own_name(const Scope& scope, const std::string& name);

/// The scope, of this plan or of one that imports it, in which the parameter is declared further
/// down; null if there is none.
const Scope* declared_later(const Scope& scope, const std::string& name);

/// Whether an unknown name may be that of a parameter whose declaration is wrong.
bool may_be_declared(const Scope& scope);

/// "; did you mean bays?", or nothing.
std::string near_name(Scope& scope, const std::string& name);

}  // namespace rubicon::interpreter::expansion
