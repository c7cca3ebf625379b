robot crane {
  time_step 1;
  body mast {
    shape box(-0.5, -0.5, 0, 0.5, 0.5, 20);
  }
  body jib on mast {
    param theta range(-180, 180) step(2) speed(4 deg/s);
    frame rotz(theta);
    shape box(0.6, -0.5, 20.5, 30, 0.5, 21.5);
  }
  body trolley on jib {
    param x range(4, 28) step(0.5) speed(0.5 m/s) start(10);
    frame trans(x, 0, 20.2);
    shape box(-0.4, -0.4, 0, 0.4, 0.4, 0.2);
  }
  body hook on trolley {
    param z range(0, 18) step(0.5) speed(0.5 m/s) start(15);
    frame trans(0, 0, z - 20.2);
    shape box(-0.2, -0.2, 0, 0.2, 0.2, 0.8);
  }
  rope hoist(20 mm) from trolley to hook at (0, 0, 0.8);
  tool hook;
  behaviour {
    chain { move_to(theta, goal(theta)) };
  }
}
