#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubicon::urdf {

/// What separates words.
inline constexpr std::string_view kBlanks = " \t\r\n";

/// The finite number that the whole text is, blanks around it apart; the same in every locale.
std::optional<double> number_of(std::string_view text);

/// The finite numbers of a text, separated by blanks; nothing if something else stands there.
std::optional<std::vector<double>> numbers_of(std::string_view text);

/// The shortest text that reads as the same number; 0 for -0.
std::string text_of(double value);

/// Radians in degrees. A value within 1e-9 degrees of a whole one becomes that: descriptions write
/// 1.57079632679, and frames are exact at multiples of 90.
double degrees_of(double radians);

}  // namespace rubicon::urdf
