# Two-axle truck that steers: its place is the middle of its rear axle. A step that turns it by an angle leads along the chord of
# an arc of that angle, so it turns only while it drives. At 1.5 m/s and 6.5 m it turns by 13.2 degrees a second.
robot steered_truck {
  time_step 0.5;
  body truck {
    param x step(0.5) speed(1.5 m/s) range(-100, 100);
    param y range(-100, 100);  # never moved by itself: the rules below change it
    param theta cyclic step(4) speed(13.3 deg/s);
    rule theta <- theta + theta_s;
    rule x <- x + x_s * cos(theta + theta_s / 2);
    rule y <- y + x_s * sin(theta + theta_s / 2);
    frame trans(x, y, 0) * rotz(theta);
    shape box(-1.4, -1.25, 0.5, 5.2, 1.25, 1.1);  # chassis
    shape box(-1.4, -1.25, 1.1, 3.2, 1.25, 2.6);  # body
    shape box(3.4, -1.2, 1.1, 5.2, 1.2, 2.9);  # cab
  }
  tool truck;
  behaviour { chain { follow }; }
}
