# A hoist on one rail: x along it, z up and down.
robot hoist {
  body trolley {
    param x range(0, 30) step(1) speed(1 m/s);
    frame trans(x, 0, 9);
    shape box(-0.4, -0.4, 0, 0.4, 0.4, 0.5);
  }
  body hook on trolley {
    param z range(0, 8.5) step(0.5) speed(0.5 m/s) start(2);
    frame trans(0, 0, z - 9);
    shape box(-0.2, -0.2, 0, 0.2, 0.2, 0.4);
  }
  tool hook;
  behaviour "carry.motion";
}
