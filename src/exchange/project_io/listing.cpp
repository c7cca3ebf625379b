#include "src/exchange/project_io/listing.hpp"

#include <fmt/format.h>

#include <utility>

namespace rubicon::project_io {

namespace {

/// More kinds than any real schedule has; nobody reads further.
constexpr std::size_t kMaxKinds = 300;

}  // namespace

void Listing::add(const std::string& code, const std::string& kind, interpreter::Span span,
                  const std::string& message, const std::string& hint) {
  interpreter::Diagnostic diagnostic;
  diagnostic.severity = interpreter::Severity::warning;
  diagnostic.code = code;
  diagnostic.span = span;
  diagnostic.message = message;
  diagnostic.hint = hint;
  add(std::move(diagnostic), kind);
}

void Listing::add(interpreter::Diagnostic diagnostic, const std::string& kind) {
  const auto found = index_.find(kind);
  if (found != index_.end()) {
    ++entries_[found->second].count;
    return;
  }
  const bool is_error = diagnostic.severity == interpreter::Severity::error;
  has_errors_ = has_errors_ || is_error;
  if (entries_.size() >= kMaxKinds && !is_error) {
    ++unlisted_;
    return;
  }
  index_.emplace(kind, entries_.size());
  entries_.push_back({std::move(diagnostic), 1});
}

int Listing::count(const std::string& kind) const {
  const auto found = index_.find(kind);
  return found == index_.end() ? 0 : entries_[found->second].count;
}

void Listing::report_listed(interpreter::Diagnostics& diagnostics) const {
  for (const Entry& entry : entries_) {
    interpreter::Diagnostic diagnostic = entry.diagnostic;
    if (entry.count > 1) {
      diagnostic.message += fmt::format(" ({} more like it)", entry.count - 1);
    }
    diagnostics.add(std::move(diagnostic));
  }
}

void Listing::report(interpreter::Diagnostics& diagnostics) const {
  report_listed(diagnostics);
  if (unlisted_ > 0) {
    diagnostics.warning("I07", {}, fmt::format("{} more things were not understood", unlisted_),
                        "the file may be damaged");
  }
}

}  // namespace rubicon::project_io
