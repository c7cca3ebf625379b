# Dump truck of three axles: it takes 10 m3 of loose soil in a bed that it tips to the back. Its tool frame stands on the ground below the middle of the bed, x to the front.
robot dump_truck {
  time_step 1;
  body truck {
    param x step(1) speed(5 m/s) loaded(3 m/s) accel(0.8 m/s2) range(-500, 500);
    param y range(-500, 500);  # never moved by itself: the rules below change it
    param theta cyclic step(10) speed(20 deg/s) loaded(12 deg/s) accel(10 deg/s2);
    rule theta <- theta + theta_s;
    rule x <- x + x_s * cos(theta) - y_s * sin(theta);
    rule y <- y + x_s * sin(theta) + y_s * cos(theta);
    frame trans(x, y, 0) * rotz(theta);
    shape box(-2.6, -1.2, 0.4, 4.6, 1.2, 1.2);  # chassis
    shape box(2.8, -1.2, 1.2, 4.6, 1.2, 2.9);  # cab
  }
  body bed on truck {
    param phi range(0, 50) step(5) speed(4 deg/s);
    frame trans(-2.6, 0, 1.25) * roty(-phi);
    shape box(0, -1.2, 0, 5.2, 1.2, 0.1);
    shape box(0, -1.2, 0.1, 5.2, -1.1, 1.05);
    shape box(0, 1.1, 0.1, 5.2, 1.2, 1.05);
    shape box(5.1, -1.1, 0.1, 5.2, 1.1, 1.05);
  }
  touching truck bed;
  tool truck;
  behaviour "dump_truck.motion";
}
