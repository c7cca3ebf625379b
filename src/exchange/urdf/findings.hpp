#pragma once

#include <string>

#include "interpreter/syntax/diagnostic.hpp"
#include "src/exchange/project_io/listing.hpp"

namespace rubicon::urdf {

/// What was assumed, mended or not taken over. Findings of the same kind become one message at the
/// first place, with how many more there are.
class Findings {
 public:
  /// Something of the machine is other than in its file.
  void warn(const char* code, const std::string& kind, interpreter::Span span, std::string message,
            std::string hint = {});
  /// Something that a user may want to know.
  void note(const char* code, const std::string& kind, interpreter::Span span, std::string message,
            std::string hint = {});

  /// In the order of the first places; beyond a few hundred kinds (garbage makes new ones) a last
  /// one tells how many were left out.
  void report(interpreter::Diagnostics& diagnostics) const;

 private:
  project_io::Listing listing_;
};

}  // namespace rubicon::urdf
