#include "src/exchange/urdf/findings.hpp"

#include <fmt/format.h>

#include <utility>

namespace rubicon::urdf {

namespace {

using interpreter::Diagnostic;
using interpreter::Severity;

constexpr std::size_t kMaxKinds = 300;

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
  add(diagnostic_of(Severity::warning, code, span, std::move(message), std::move(hint)), kind);
}

void Findings::note(const char* code, const std::string& kind, interpreter::Span span,
                    std::string message, std::string hint) {
  add(diagnostic_of(Severity::note, code, span, std::move(message), std::move(hint)), kind);
}

void Findings::add(Diagnostic diagnostic, const std::string& kind) {
  const auto found = index_.find(kind);
  if (found != index_.end()) {
    ++entries_[found->second].count;
  } else if (entries_.size() == kMaxKinds) {
    ++unlisted_;
  } else {
    index_.emplace(kind, entries_.size());
    entries_.push_back({std::move(diagnostic), 1});
  }
}

void Findings::report(interpreter::Diagnostics& diagnostics) const {
  for (const Entry& each : entries_) {
    Diagnostic diagnostic = each.diagnostic;
    if (each.count > 1) diagnostic.message += fmt::format(" ({} more like it)", each.count - 1);
    diagnostics.add(std::move(diagnostic));
  }
  if (unlisted_ > 0) {
    diagnostics.warning("I25", entries_.back().diagnostic.span,
                        fmt::format("{} more findings of other kinds are not listed", unlisted_));
  }
}

}  // namespace rubicon::urdf
