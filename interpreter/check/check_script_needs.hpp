#pragma once

#include <string>

#include "interpreter/check/check_script_values.hpp"
#include "interpreter/syntax/diagnostic.hpp"

namespace rubicon::interpreter::script_check {

/// Says where a value of one kind stands and another is needed: S12, S15, W01, W02, W07.
class ValueNeeds {
 public:
  explicit ValueNeeds(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// `value`, which is of kind `kind`, stands where `who` needs one of kind `wanted`; false if that
  /// does not fit.
  bool value(ValueKind wanted, const syntax::Expression& value, ValueKind kind,
             const std::string& who, Span place);

  /// The same where `who` needs a direction of `parameter`; `if_zero` says what a direction 0 means
  /// there.
  void direction(const syntax::Expression& value, ValueKind kind, const std::string& who,
                 const std::string& parameter, Span place, const std::string& if_zero);

  /// A literal whose unit is of the wrong kind: an error where anything else is a doubt.
  void wrong_unit(const syntax::Expression& literal, const std::string& need);

 private:
  Diagnostics& diagnostics_;
};

}  // namespace rubicon::interpreter::script_check
