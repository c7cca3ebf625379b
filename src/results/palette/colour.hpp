#pragma once

#include <array>
#include <string_view>

namespace rubicon::palette {

/// Red, green and blue in 0..1, linear in light (IEC 61966-2-1), of "#rrggbb". Throws
/// std::invalid_argument for any other text.
std::array<double, 3> linear_rgb(std::string_view colour);

/// The same mixed with white (share > 0) or black (share < 0), as the page mixes: before it is made
/// linear.
std::array<double, 3> linear_rgb(std::string_view colour, double share);

}  // namespace rubicon::palette
