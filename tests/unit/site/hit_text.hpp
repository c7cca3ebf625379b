#pragma once

#include <optional>
#include <string>

#include "src/simulation/site/robot_view.hpp"

namespace rubicon::test {

/// What met what, or "free".
inline std::string hit_text(const std::optional<interpreter::HitPair>& pair) {
  return pair ? pair->moved + " meets " + pair->met : "free";
}

}  // namespace rubicon::test
