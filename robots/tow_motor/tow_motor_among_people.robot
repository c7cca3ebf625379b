# Tow motor that goes where its guide leads, among people and vehicles.
robot tow_motor_among_people {
  time_step 1;
  sensor 10;
  body truck {
    param x step(0.5) speed(1.2 m/s) accel(0.5 m/s2) range(-100, 100);
    param y range(-100, 100);  # never moved by itself: the rules below change it
    param theta cyclic step(10) speed(30 deg/s) accel(20 deg/s2);
    rule theta <- theta + theta_s;
    rule x <- x + x_s * cos(theta) - y_s * sin(theta);
    rule y <- y + x_s * sin(theta) + y_s * cos(theta);
    frame trans(x, y, 0) * rotz(theta);
    shape box(-1.2, -0.5, 0.05, 0.4, 0.5, 1.1);  # chassis
    shape box(-0.4, -0.4, 1.1, 0.2, 0.4, 2);  # driver
    shape box(0.4, -0.45, 0.05, 1.6, 0.45, 0.3);  # forks
  }
  tool truck;
  behaviour "follow_among_people.motion";
}
