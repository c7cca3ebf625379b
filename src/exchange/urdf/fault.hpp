#pragma once

#include <string>
#include <utility>

#include "interpreter/syntax/diagnostic.hpp"

namespace rubicon::urdf {

/// Ends an import: thrown inside this module, a diagnostic outside of it.
struct Fault {
  interpreter::Diagnostic diagnostic;
};

[[noreturn]] inline void fail(const char* code, interpreter::Span span, std::string message,
                              std::string hint = {}) {
  Fault fault;
  fault.diagnostic.code = code;
  fault.diagnostic.span = span;
  fault.diagnostic.message = std::move(message);
  fault.diagnostic.hint = std::move(hint);
  throw fault;
}

}  // namespace rubicon::urdf
