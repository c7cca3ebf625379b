# A gantry over the pit: its hook goes 3 m below the ground. It goes up, across, and down.
robot gantry {
  time_step 1;
  body bridge {
    param x range(0, 14) step(0.5) speed(0.5 m/s) start(11);
    frame trans(x, 0, 0);
    shape box(-0.2, -1, 6, 0.2, 11, 6.5);
  }
  body trolley on bridge {
    param y range(0, 10) step(0.5) speed(0.5 m/s) start(5);
    frame trans(0, y, 6);
    shape box(-0.3, -0.3, -0.4, 0.3, 0.3, 0);
  }
  body hook on trolley {
    param z range(-3, 5) step(0.25) speed(0.25 m/s) start(3);
    frame trans(0, 0, z - 6);
    shape box(-0.1, -0.1, 0, 0.1, 0.1, 0.3);
  }
  tool hook;
  behaviour {
    chain { move_to(z, max(z)) };
    chain { move_to(x, goal(x)), move_to(y, goal(y)) };
    chain { move_to(z, goal(z)) };
  }
}
