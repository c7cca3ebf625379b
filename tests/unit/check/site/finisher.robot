robot finisher {
  body base {
    param x range(0, 40) step(0.5) start(2);
    frame trans(x, 0, 20);
    behaviour { chain { move_to(x, goal(x)) }; }
  }
  body effector on base {
    param x range(-1.5, 1.5) step(0.25);
    frame trans(x, 0, 0);
    behaviour { chain { move_to(x, goal(x)) }; }
  }
}
