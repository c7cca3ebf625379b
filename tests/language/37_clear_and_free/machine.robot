# robot that slides along two fixed axes (no rotation): gantry, overhead trolley
robot gantry {
  time_step 1;
  sensor 6;
  body trolley {
    param x step(1) range(-10, 60);
    param y step(1) range(-30, 30);
    frame trans(x, y, 0);
    shape box(-0.4, -0.4, 0, 0.4, 0.4, 1);
  }
  tool trolley;
  behaviour "behaviour.motion";
}
