# A cart on a lane. It drives until something is in its way, and is tried again when that has passed.
robot cart {
  time_step 1;
  body cart {
    param x range(-100, 100) step(1) speed(1 m/s);
    frame trans(x, 0, 0);
    shape box(-0.8, -0.5, 0.05, 0.8, 0.5, 1.2);
  }
  tool cart;
  behaviour { chain { move_to(x, goal(x)) } }
}
