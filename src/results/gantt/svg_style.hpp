#pragma once

#include "src/results/palette/palette.hpp"

namespace rubicon::gantt {

// Lengths are pixels, of which 1600 make the width: that of a sheet A3.
inline constexpr double kWidth = 1600;
inline constexpr double kMargin = 24;
inline constexpr double kLeft = 252;  ///< where time begins
inline constexpr double kPlot = kWidth - kLeft - kMargin;
inline constexpr double kSmallSize = 10;  ///< of texts

// Colours, as on the report page.
inline constexpr const palette::Drawing& kColours = palette::kDrawing;

}  // namespace rubicon::gantt
