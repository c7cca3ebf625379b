# Tow motor with a pallet: turns on the spot, drives along its own axis (1995 paper, 2.3 and 4.3).
robot tow_motor {
  time_step 1;
  sensor 10;
  body truck {
    param x step(0.5) speed(1.2 m/s) loaded(0.8 m/s) accel(0.5 m/s2) range(-40, 60);
    param y range(-40, 40);  # never moved by itself: the rules below change it
    param z;
    param theta cyclic step(10) speed(30 deg/s) loaded(20 deg/s) accel(20 deg/s2);
    rule theta <- theta + theta_s;
    rule x <- x + x_s * cos(theta) - y_s * sin(theta);
    rule y <- y + x_s * sin(theta) + y_s * cos(theta);
    rule z <- z_c;  # it stays on its floor
    frame trans(x, y, z) * rotz(theta);
    shape box(-0.4, -0.5, 0, 1.2, 0.5, 1.1);  # chassis
    shape box(0.5, -0.45, 1.1, 1.1, 0.45, 2);  # driver
    shape box(-1.2, -0.4, 0, -0.4, 0.4, 0.15);  # bed
    shape box(-1.2, -0.4, 0.15, -0.4, 0.4, 1.0);  # pallet
  }
  tool truck;
  behaviour "to_goal.motion";
}
