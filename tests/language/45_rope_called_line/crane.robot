robot crane {
  body mast { shape box(-0.5, -0.5, 0, 0.5, 0.5, 9); }
  body slew on mast { frame trans(0, 0, 9); }
  body jib on slew {
    param theta range(-170, 170) step(5) speed(5 deg/s);
    frame rotz(theta);
    shape box(0.6, -0.3, 0, 12, 0.3, 0.5);
  }
  body cab on jib { shape box(-2, -0.3, 0, -0.6, 0.3, 0.5); }
  body trolley on jib {
    param x range(2, 11) step(0.5) speed(0.5 m/s) start(5);
    frame trans(x, 0, -0.3);
    shape box(-0.2, -0.2, 0, 0.2, 0.2, 0.2);
  }
  body hook on trolley {
    param z range(-8, -1) step(0.5) speed(0.5 m/s) start(-4);
    frame trans(0, 0, z);
    shape box(-0.2, -0.2, 0, 0.2, 0.2, 0.4);
  }
  rope line(10 mm) from trolley to hook at (0, 0, 0.4);
  tool hook;
  behaviour { chain { line } }
}
