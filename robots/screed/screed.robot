# A screed on a bridge: the bridge travels along x on rails, the carriage along y on the bridge, the beam is set down to work.
robot screed {
  body bridge {
    param x range(-1, 60) step(0.5) speed(0.5 m/s) accel(0.5 m/s2);
    frame trans(x, 0, 0);
    shape box(-0.3, -1.5, 1.6, 0.3, 21.5, 2.1);
  }
  body carriage on bridge {
    param y range(0, 20) step(0.5) speed(0.5 m/s) accel(0.5 m/s2);
    frame trans(0, y, 0);
    shape box(-0.4, -0.4, 1.2, 0.4, 0.4, 1.6);
  }
  body beam on carriage {
    param z range(0, 1) step(0.25) speed(0.2 m/s) start(0.5);
    param phi step(15) speed(30 deg/s);
    frame trans(0, 0, z) * rotz(phi);
    shape box(-0.1, -0.45, 0, 0.1, 0.45, 0.2);
    shape cylinder(0.05, 0.2, 1.2);
  }
  tool beam;
  touching beam bridge;
  behaviour { chain { line }; }
}
