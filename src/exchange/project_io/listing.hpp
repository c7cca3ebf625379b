#pragma once

#include <map>
#include <string>
#include <vector>

#include "interpreter/syntax/diagnostic.hpp"

namespace rubicon::project_io {

/// What a reader could not take over. Doubts of the same kind become one warning at the first
/// place, with how many more there are: a file with a hundred thousand tasks says the same thing
/// once.
class Listing {
 public:
  /// `kind` groups: what is said of the first of a kind stands for all.
  void add(const std::string& code, const std::string& kind, interpreter::Span span,
           const std::string& message, const std::string& hint = {});

  /// The same for a diagnostic of any severity. An error is listed however many kinds there are.
  void add(interpreter::Diagnostic diagnostic, const std::string& kind);

  /// How often something of this kind was added.
  int count(const std::string& kind) const;

  /// Whether any error was added: what was read is then no schedule.
  bool has_errors() const { return has_errors_; }

  /// Everything so far, in the order of the first places; beyond a few hundred kinds (garbage makes
  /// new ones) a last warning tells how many were left out.
  void report(interpreter::Diagnostics& diagnostics) const;

  /// The same without the last warning.
  void report_listed(interpreter::Diagnostics& diagnostics) const;
  int unlisted() const { return unlisted_; }
  /// Where the last kind that is listed has its first place; there must be one.
  interpreter::Span last_place() const { return entries_.back().diagnostic.span; }

 private:
  struct Entry {
    interpreter::Diagnostic diagnostic;
    int count = 0;
  };
  std::vector<Entry> entries_;
  std::map<std::string, std::size_t> index_;
  int unlisted_ = 0;
  bool has_errors_ = false;
};

}  // namespace rubicon::project_io
