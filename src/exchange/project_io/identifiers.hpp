#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace rubicon::project_io {

/// Makes names for a plan out of names for people: small letters, digits and `_`, letters with
/// accents as the plain ones ("Höhe 2e verdieping" becomes hohe_2e_verdieping), at most 48 long, no
/// word that the language reserves, each once in this set.
class Identifiers {
 public:
  /// `fallback` where the name has no letter or digit that can be kept; `prefix`, if not empty, is
  /// put before a name that is taken, and a number behind where that does not help.
  std::string make(std::string_view name, const std::string& fallback,
                   const std::string& prefix = {});

  /// Keeps a name for somebody else.
  void reserve(const std::string& name) { taken_.insert(name); }

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> next_;
};

}  // namespace rubicon::project_io
