# Truck for swap bodies: it backs under a frame that stands on four legs beside it, raises its bed, and drives off with it.
robot swap_body_truck {
  time_step 1;
  body truck {
    param x step(1) speed(3 m/s) loaded(2 m/s) accel(0.6 m/s2) range(-200, 200);
    param y range(-200, 200);  # never moved by itself: the rules below change it
    param theta cyclic step(10) speed(15 deg/s) loaded(10 deg/s) accel(7.5 deg/s2);
    rule theta <- theta + theta_s;
    rule x <- x + x_s * cos(theta) - y_s * sin(theta);
    rule y <- y + x_s * sin(theta) + y_s * cos(theta);
    frame trans(x, y, 0) * rotz(theta);
    shape box(-3.2, -1.1, 0.3, 3.4, 1.1, 0.9);  # chassis
    shape box(3.4, -1.15, 0.3, 5.6, 1.15, 3);  # cab
  }
  body bed on truck {
    param z range(0, 0.2) step(0.05) speed(0.05 m/s);
    frame trans(0, 0, z);
    shape box(-3.2, -1.15, 0.9, 3.2, 1.15, 1.1);
  }
  # a metre above a frame that is 3.9 m high: there a crane takes hold of it too
  tool bed at trans(0, 0, 4.9);
  behaviour "straight_there.motion";
}
