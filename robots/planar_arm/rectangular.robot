# The same arm by a rectangle: the hand is moved along x and z and turned (1995 paper, Figure 5 b). The rectangle is as large as
# the disc of 5 m that the arm reaches, so neither holds the other.
robot planar_arm {
  body hand {
    param x range(-4.431, 4.431) step(0.2) speed(0.5 m/s);
    param z range(-4.431, 4.431) step(0.2) speed(0.5 m/s);
    param phi range(-360, 360) step(5) speed(60 deg/s);
    frame trans(x, 0, z) * roty(phi);
    shape box(0, -0.1, -0.1, 0.4, 0.1, 0.1);
  }
  tool hand;
  behaviour { chain { follow }; }
}
