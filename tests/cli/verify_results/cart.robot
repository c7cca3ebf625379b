# A cart that turns on the spot and drives along its own axis.
robot cart {
  time_step 1;
  body truck {
    param x step(0.5) speed(1 m/s) range(-40, 40);
    param y range(-40, 40);
    param theta cyclic step(15) speed(30 deg/s);
    rule x <- x + x_s * cos(theta);
    rule y <- y + x_s * sin(theta);
    frame trans(x, y, 0) * rotz(theta);
    shape box(-0.6, -0.4, 0.1, 0.6, 0.4, 0.9);
    shape capsule(0.4, -0.4, 0.15, 0.4, 0.4, 0.15, 0.1);
  }
  body mast on truck {
    param z step(0.2) speed(0.2 m/s) range(0, 1.5);
    param phi = 20 * z;
    frame trans(0, 0, z + 0.9) * rotz(phi);
    shape sphere(0, 0, 0.2, 0.15);
  }
  tool mast;
  behaviour "cart.motion";
}
