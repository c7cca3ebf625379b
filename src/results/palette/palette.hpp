#pragma once

#include <array>
#include <string_view>

namespace rubicon::palette {

/// What is drawn on a light ground, each colour as "#rrggbb" (sRGB). The values are those of
/// palette.json, which the report page reads too.
struct Drawing {
  std::string_view text, muted, line, panel;
  std::string_view machine;    ///< motion of a machine, in charts
  std::string_view crew;       ///< crew work
  std::string_view wait;       ///< waiting
  std::string_view critical;   ///< outlines of the critical path
  std::string_view off;        ///< ground of times without a shift
  std::string_view bad;        ///< what was rejected
  std::string_view forbidden;  ///< where a robot may not stand
  std::string_view ground, fixture;
  std::string_view waiting;  ///< a component that is not placed yet
  std::string_view carried;
  std::string_view zone;  ///< of people
  std::string_view rope;
  std::array<std::string_view, 6> machines;     ///< in turn, by the number of the robot
  std::array<std::string_view, 12> components;  ///< placed, in turn, by the number of their kind
};
extern const Drawing kDrawing;

/// Parameters of the control sequence "ESC [ ... m" (ECMA-48, SGR), from the 16 colours that a
/// terminal has.
struct Terminal {
  std::string_view good, bad, warn, note, mark;
};
extern const Terminal kTerminal;

}  // namespace rubicon::palette
