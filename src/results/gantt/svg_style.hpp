#pragma once

namespace rubicon::gantt {

// Lengths are pixels, of which 1600 make the width: that of a sheet A3.
inline constexpr double kWidth = 1600;
inline constexpr double kMargin = 24;
inline constexpr double kLeft = 252;  ///< where time begins
inline constexpr double kPlot = kWidth - kLeft - kMargin;
inline constexpr double kSmallSize = 10;  ///< of texts

// Colours of Okabe and Ito that colour-blind people can tell apart.
inline constexpr const char* kMotion = "#0072b2";
inline constexpr const char* kWork = "#e69f00";
inline constexpr const char* kWait = "#b3b3b8";
inline constexpr const char* kCritical = "#9b0000";
inline constexpr const char* kOff = "#eceef2";
inline constexpr const char* kInk = "#1a1a1a";
inline constexpr const char* kFaint = "#595959";
inline constexpr const char* kLine = "#d5d7dc";

}  // namespace rubicon::gantt
