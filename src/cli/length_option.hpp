#pragma once

#include <optional>
#include <string>

namespace rubicon::cli {

/// The length of an option, "5 mm", "2cm", "0.5 m", in m; one that is not given ("") stays as it
/// is. A message if it is none, or not from `least` to `most`.
std::optional<std::string> take_length(const char* option, const std::string& text, double least,
                                       double most, double& length);

}  // namespace rubicon::cli
