# A cart that goes anywhere on a floor.
robot cart {
  body cart {
    param x range(-2, 14) step(0.5) speed(1 m/s);
    param y range(-6, 6) step(0.5) speed(1 m/s);
    frame trans(x, y, 0);
    shape box(-0.4, -0.4, 0, 0.4, 0.4, 1);
  }
  tool cart;
  behaviour { chain { follow }; }
}
