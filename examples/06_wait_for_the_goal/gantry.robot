# A hoist on two rails: x along the hall, y across, a metre a step, a second each.
robot gantry {
  body trolley {
    param x range(0, 30) step(1) speed(1 m/s);
    param y range(-6, 6) step(1) speed(0.5 m/s);
    frame trans(x, y, 0);
    shape box(-0.4, -0.4, 4, 0.4, 0.4, 5);
  }
  tool trolley;
  behaviour "tour.motion";
}
