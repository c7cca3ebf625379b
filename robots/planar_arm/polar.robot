# The same arm by polar coordinates: a boom turns and the hand runs out along it (1995 paper, Figure 5 c). It has no hole about its
# foot, which the arm cannot reach into.
robot planar_arm {
  body boom {
    param phi range(-180, 180) step(5) speed(20 deg/s);
    frame roty(phi);
  }
  body hand on boom {
    param x range(0, 5) step(0.2) speed(0.5 m/s) start(3);
    param phi range(-360, 360) step(5) speed(60 deg/s);
    frame trans(x, 0, 0) * roty(phi);
    shape box(0, -0.1, -0.1, 0.4, 0.1, 0.1);
  }
  tool hand;
  behaviour { chain { follow }; }
}
