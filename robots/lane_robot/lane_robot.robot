# A warehouse robot of 2 m by 2 m that keeps to its lane, and passes what lies in it: turns on the spot, drives along its axis.
robot lane_robot {
  time_step 1;
  sensor 12;
  body base {
    param x step(0.5) speed(1 m/s) range(-200, 200);
    param y range(-200, 200);  # never moved by itself: the rules below change it
    param theta cyclic step(15) speed(45 deg/s);
    rule theta <- theta + theta_s;
    rule x <- x + x_s * cos(theta) - y_s * sin(theta);
    rule y <- y + x_s * sin(theta) + y_s * cos(theta);
    frame trans(x, y, 0) * rotz(theta);
    shape box(-1, -1, 0.05, 1, 1, 1.2);
  }
  tool base;
  behaviour "pass_in_lane.motion";
}
