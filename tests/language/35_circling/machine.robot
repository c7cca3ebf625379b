# automated mobile agent (tow motor): turns on the spot, drives along its axis (paper, section 4.3)
robot agent {
  time_step 1;
  sensor 10;
  body truck {
    param x step(0.5);
    param y;
    param z start(0);
    param theta cyclic step(77.31);
    rule theta <- theta + theta_s;
    rule x <- x + x_s * cos(theta) - y_s * sin(theta);
    rule y <- y + x_s * sin(theta) + y_s * cos(theta);
    rule z <- z_c;
    frame trans(x, y, z) * rotz(theta);
    shape box(-1.2, -0.7, 0, 1.2, 0.7, 2);
  }
  tool truck;
  behaviour "behaviour.motion";
}
