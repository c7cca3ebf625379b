#pragma once

#include <string>

namespace rubicon::debug {

/// A value for people, to six digits; "?" for NaN, which is not known.
std::string number_text(double value);

/// "-36 -> -34"; with more digits where six do not show the difference.
std::string change_text(double before, double after);

/// "0.556 s": seconds to the millisecond.
std::string seconds_text(double seconds);

}  // namespace rubicon::debug
