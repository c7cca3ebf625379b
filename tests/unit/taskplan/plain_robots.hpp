#pragma once

// Robots of few words, for plans in which several machines meet.

namespace rubicon::taskplan {

/// A car on a line, 1 m a second.
inline constexpr const char* kLine = R"(robot line {
  body car {
    param x range(-100, 100) step(1) speed(1 m/s);
    frame trans(x, 0, 0);
    shape box(-0.5, -0.5, 0, 0.5, 0.5, 1);
  }
  tool car;
  behaviour { chain { move_to(x, goal(x)) }; }
}
)";
/// A gantry that takes things from above.
inline constexpr const char* kGantry = R"(robot gantry {
  body hoist {
    param x range(-100, 100) step(1) speed(1 m/s);
    param y range(-100, 100) step(1) speed(1 m/s);
    param z range(0, 20) step(1) speed(1 m/s) start(5);
    frame trans(x, y, z);
    shape box(-0.2, -0.2, 0, 0.2, 0.2, 1);
  }
  tool hoist;
  capacity (10, 4 t), (30, 2 t), (90, 1 t);
  behaviour { chain { move_to(x, goal(x)) }; chain { move_to(y, goal(y)) }; chain { move_to(z, goal(z)) }; }
}
)";

}  // namespace rubicon::taskplan
