#include "src/exchange/urdf/findings.hpp"

#include <fmt/format.h>

#include <utility>

namespace rubicon::urdf {

namespace {

using interpreter::Diagnostic;
using interpreter::Severity;

Diagnostic diagnostic_of(Severity severity, const char* code, interpreter::Span span,
                         std::string message, std::string hint) {
  Diagnostic result;
  result.severity = severity;
  result.code = code;
  result.span = span;
  result.message = std::move(message);
  result.hint = std::move(hint);
  return result;
}

}  // namespace

void Findings::warn(const char* code, const std::string& kind, interpreter::Span span,
                    std::string message, std::string hint) {
  listing_.add(diagnostic_of(Severity::warning, code, span, std::move(message), std::move(hint)),
               kind);
}

void Findings::note(const char* code, const std::string& kind, interpreter::Span span,
                    std::string message, std::string hint) {
  listing_.add(diagnostic_of(Severity::note, code, span, std::move(message), std::move(hint)),
               kind);
}

void Findings::report(interpreter::Diagnostics& diagnostics) const {
  listing_.report_listed(diagnostics);
  if (listing_.unlisted() > 0) {
    diagnostics.warning(
        "I25", listing_.last_place(),
        fmt::format("{} more findings of other kinds are not listed", listing_.unlisted()));
  }
}

}  // namespace rubicon::urdf
