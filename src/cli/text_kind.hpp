#pragma once

#include <optional>
#include <string>

#include "interpreter/parse/parse.hpp"

namespace rubicon::cli {

/// What a file holds, by the end of its name; nothing for other names.
inline std::optional<interpreter::TextKind> kind_of(const std::string& path) {
  const auto ends = [&](const char* suffix) {
    const std::string end = suffix;
    return path.size() > end.size() && path.compare(path.size() - end.size(), end.size(), end) == 0;
  };
  if (ends(".motion")) return interpreter::TextKind::script;
  if (ends(".robot")) return interpreter::TextKind::robot;
  if (ends(".plan")) return interpreter::TextKind::plan;
  if (ends(".study")) return interpreter::TextKind::study;
  return std::nullopt;
}

}  // namespace rubicon::cli
