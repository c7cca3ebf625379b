robot cart {
  body car {
    param x range(-20, 20) step(0.5) speed(1 m/s);
    frame trans(x, 0, 0);
    shape box(-0.3, -0.3, 0, 0.3, 0.3, 5);
  }
  tool car;
  behaviour { chain { move_to(x, goal(x)) }; }
}
