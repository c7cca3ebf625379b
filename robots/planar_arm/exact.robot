# A planar arm of two links, 3 m and 2 m, and a hand that turns, in the xz plane: as it is built (1995 paper, Figure 4).
robot planar_arm {
  body upper {
    param phi range(-180, 180) step(5) speed(20 deg/s);
    frame roty(phi);
    shape capsule(0, 0, 0, 3, 0, 0, 0.15);
  }
  body lower on upper {
    param phi range(-180, 180) step(5) speed(30 deg/s) start(-90);
    frame trans(3, 0, 0) * roty(phi);
    shape capsule(0, 0, 0, 2, 0, 0, 0.12);
  }
  body hand on lower {
    param phi range(-360, 360) step(5) speed(60 deg/s);
    frame trans(2, 0, 0) * roty(phi);
    shape box(0, -0.1, -0.1, 0.4, 0.1, 0.1);
  }
  tool hand;
  touching upper hand;
  behaviour { chain { follow }; }
}
