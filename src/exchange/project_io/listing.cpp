#include "src/exchange/project_io/listing.hpp"

#include <fmt/format.h>

namespace rubicon::project_io {

namespace {

/// More kinds than any real schedule has; nobody reads further.
constexpr std::size_t kMaxKinds = 300;

}  // namespace

void Listing::add(const std::string& code, const std::string& kind, interpreter::Span span,
                  const std::string& message, const std::string& hint) {
  const auto found = index_.find(kind);
  if (found != index_.end()) {
    ++entries_[found->second].count;
    return;
  }
  if (entries_.size() >= kMaxKinds) {
    ++unlisted_;
    return;
  }
  index_.emplace(kind, entries_.size());
  Entry entry;
  entry.diagnostic.severity = interpreter::Severity::warning;
  entry.diagnostic.code = code;
  entry.diagnostic.span = span;
  entry.diagnostic.message = message;
  entry.diagnostic.hint = hint;
  entry.count = 1;
  entries_.push_back(std::move(entry));
}

int Listing::count(const std::string& kind) const {
  const auto found = index_.find(kind);
  return found == index_.end() ? 0 : entries_[found->second].count;
}

void Listing::report(interpreter::Diagnostics& diagnostics) const {
  for (const Entry& entry : entries_) {
    interpreter::Diagnostic diagnostic = entry.diagnostic;
    if (entry.count > 1) {
      diagnostic.message += fmt::format(" ({} more like it)", entry.count - 1);
    }
    diagnostics.add(std::move(diagnostic));
  }
  if (unlisted_ > 0) {
    diagnostics.warning("I07", {}, fmt::format("{} more things were not understood", unlisted_),
                        "the file may be damaged");
  }
}

}  // namespace rubicon::project_io
