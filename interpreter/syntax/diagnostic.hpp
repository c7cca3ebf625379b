#pragma once

#include <string>
#include <vector>

#include "interpreter/syntax/source.hpp"

namespace rubicon::interpreter {

enum class Severity { error, warning, note };

/// A mistake or doubt of the user's text: where, what was expected, what was found, what to do.
struct Diagnostic {
  Severity severity = Severity::error;
  std::string code;     ///< "S05", "W02", ...: LANGUAGE section 10; "R.." robot files, "P.." plans,
                        ///< "F.." files
  Span span;            ///< the offending token
  std::string message;  ///< lower case, one line
  struct Related {
    Span span;
    std::string message;
  };
  std::vector<Related> notes;  ///< other places that matter
  std::string hint;            ///< what to do, where it is not in the message already
};

/// Collects diagnostics of one run.
class Diagnostics {
 public:
  void error(std::string code, Span span, std::string message, std::string hint = {});
  void warning(std::string code, Span span, std::string message, std::string hint = {});
  void note(std::string code, Span span, std::string message, std::string hint = {});
  void add(Diagnostic diagnostic);

  const std::vector<Diagnostic>& all() const { return all_; }
  bool has_errors() const { return errors_ > 0; }
  int errors() const { return errors_; }
  /// Sorted by file (in the order they were read) and position, the order of reporting kept where
  /// equal; exact duplicates (same place, same message) dropped.
  std::vector<Diagnostic> sorted() const;

  /// What is said of copies that a `for` made, from the diagnostic `from` on: each message says
  /// which copy ("(line 6, i = 3)"), and the same mistake of more copies is said once, of the
  /// first.
  void name_copies(std::size_t from, const SourceMap& sources);

 private:
  std::vector<Diagnostic> all_;
  int errors_ = 0;
};

/// The candidate nearest to `name` by edit distance (at most two letters away, fewer for short
/// names; transposition is one edit); empty if none is near. Ties: the first.
std::string did_you_mean(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace rubicon::interpreter
