# A sweeper with a broom of 1 m. It drives where its nose points: the way of its task turns it.
robot sweeper {
  body chassis {
    param x range(-2, 20) step(1) speed(1.2 m/s);
    param y range(-2, 20) step(1) speed(1.2 m/s);
    param theta cyclic step(10) speed(45 deg/s);
    frame trans(x, y, 0) * rotz(theta);
    shape box(-0.6, -0.45, 0.05, 0.3, 0.45, 1.2);
    shape box(0.3, -0.5, 0.05, 0.5, 0.5, 0.3);  # the broom
  }
  tool chassis;
  behaviour { chain { line }; }
}
