robot chart {
  body hook {
    param x range(4, 50) step(1) start(20);
    param z range(0, 42) step(1) start(10);
    frame trans(x, 0, z);
  }
  capacity (10, 5 t), (50, 1 t);
  behaviour { chain { move_to(x, goal(x)), move_to(z, goal(z)) }; }
}
