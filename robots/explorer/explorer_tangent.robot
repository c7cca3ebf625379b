# A round vehicle without a map: it turns on the spot by quarters, drives along its own axis in steps of a quarter
# of a metre, and feels what is around it.
robot explorer_tangent {
  time_step 1;
  sensor 50;
  body disc {
    param x step(0.25) speed(1 m/s) range(-500, 500);
    param y range(-500, 500);  # never moved by itself: the rules below change it
    param theta cyclic step(90) speed(90 deg/s);
    rule theta <- theta + theta_s;
    rule x <- x + x_s * cos(theta) - y_s * sin(theta);
    rule y <- y + x_s * sin(theta) + y_s * cos(theta);
    frame trans(x, y, 0) * rotz(theta);
    shape cylinder(0.4, 0, 1);
  }
  tool disc;
  behaviour "tangent.motion";
}
