robot crane {
  time_step 2;
  body mast { shape box(-1, -1, 0, 1, 1, 44); }
  body jib on mast { param theta range(-180, 180) step(5); frame rotz(theta); }
  body hook on jib {
    param x range(4, 50) step(1) start(20);
    param z range(0, 42) step(1) start(10);
    frame trans(x, 0, z);
  }
  behaviour { chain { move_to(theta, goal(theta)), move_to(x, goal(x)), move_to(z, goal(z)) }; }
}
