# Tow motor with forks that drives on the lanes of a network: from node to node, and beside them as its script says.
robot tow_motor_on_lanes {
  time_step 1;
  body truck {
    param x step(0.5) speed(1.2 m/s) loaded(0.8 m/s) accel(0.5 m/s2) range(-500, 500);
    param y range(-500, 500);  # never moved by itself: the rules below change it
    param theta cyclic step(10) speed(30 deg/s) loaded(20 deg/s) accel(20 deg/s2);
    rule theta <- theta + theta_s;
    rule x <- x + x_s * cos(theta) - y_s * sin(theta);
    rule y <- y + x_s * sin(theta) + y_s * cos(theta);
    frame trans(x, y, 0) * rotz(theta);
    shape box(-1.2, -0.5, 0.05, 0.4, 0.5, 1.1);  # chassis
    shape box(-0.4, -0.4, 1.1, 0.2, 0.4, 2);  # driver
    shape box(0.4, -0.45, 0.05, 0.5, 0.45, 2);  # mast
  }
  body forks on truck {
    param z range(0, 1.2) step(0.1) speed(0.25 m/s) loaded(0.15 m/s) accel(0.25 m/s2) start(0.2);  # the prongs, above the ground
    frame trans(0.5, 0, z);
    shape box(0, -0.3, 0.02, 1.15, -0.15, 0.08);
    shape box(0, 0.15, 0.02, 1.15, 0.3, 0.08);
  }
  # a metre above the middle of a pallet that is a metre high: there a crane takes hold of it too
  tool forks at trans(0.6, 0, 2);
  behaviour "bring_by_lanes.motion";
}
