# A cart that turns on the spot and goes where its guide leads.
robot cart {
  time_step 1;
  body cart {
    param x step(2) speed(2 m/s) range(-100, 100);
    param y range(-100, 100);  # never moved by itself: the rules below change it
    param theta cyclic step(45) speed(90 deg/s);
    rule theta <- theta + theta_s;
    rule x <- x + x_s * cos(theta) - y_s * sin(theta);
    rule y <- y + x_s * sin(theta) + y_s * cos(theta);
    frame trans(x, y, 0) * rotz(theta);
    shape box(-1, -0.6, 0, 1, 0.6, 1.2);
  }
  tool cart;
  behaviour { chain { follow } }
}
