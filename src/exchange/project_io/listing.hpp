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

  /// How often something of this kind was added.
  int count(const std::string& kind) const;

  /// Everything so far as warnings, in the order of the first places; beyond a few hundred kinds
  /// (garbage makes new ones) a last one tells how many were left out.
  void report(interpreter::Diagnostics& diagnostics) const;

 private:
  struct Entry {
    interpreter::Diagnostic diagnostic;
    int count = 0;
  };
  std::vector<Entry> entries_;
  std::map<std::string, std::size_t> index_;
  int unlisted_ = 0;
};

}  // namespace rubicon::project_io
