#pragma once

#include <string>

#include "interpreter/syntax/diagnostic.hpp"

namespace rubicon::interpreter {

/// Did-you-mean for the wrong names of one file. A file full of wrong names costs no more than a
/// few suggestions.
class NameSuggestions {
 public:
  /// "; did you mean X?" with the candidate nearest to `name`, empty if none is near. `list` gives
  /// the candidates and is called only when they are wanted.
  template <typename List>
  std::string ending(const std::string& name, const List& list) {
    if (left_ == 0) return {};
    --left_;
    const std::string nearest = did_you_mean(name, list());
    return nearest.empty() ? std::string() : "; did you mean " + nearest + "?";
  }

 private:
  // Each compares the name with all candidates; nobody reads more of them in one run.
  static constexpr int kMaxSuggestions = 100;
  int left_ = kMaxSuggestions;
};

}  // namespace rubicon::interpreter
