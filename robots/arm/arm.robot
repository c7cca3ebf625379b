# Ceiling drill: a six-axis arm of 2.2 m on a crawler that drives along its lane. Dimensions and speeds are those of a mid-sized
# industrial arm, rounded. The drill bit is the body `bit`; the tool frame is its tip, its z axis the axis of the hole.
robot arm {
  time_step 1;
  deviation 1 mm, 0.1 deg;
  body base {
    param x range(-20, 20) step(0.1) speed(0.5 m/s);
    frame trans(x, 0, 0);
    shape box(-0.9, -0.4, 0, 0.9, 0.4, 0.6);
  }
  body turret on base {
    param theta range(-180, 180) step(3) speed(60 deg/s);
    frame trans(0, 0, 0.6) * rotz(theta);
    shape cylinder(0.25, 0, 0.4);
  }
  body upper on turret {
    param phi range(-20, 160) step(3) speed(60 deg/s) start(120);
    frame trans(0.1, 0, 0.45) * roty(-phi);
    shape capsule(0, 0, 0, 1.1, 0, 0, 0.12);
  }
  body fore on upper {
    param phi range(-160, 160) step(3) speed(90 deg/s) start(-100);
    frame trans(1.1, 0, 0) * roty(-phi);
    shape capsule(0, 0, 0, 0.7, 0, 0, 0.1);
  }
  body wrist on fore {
    param psi range(-180, 180) step(5) speed(150 deg/s);
    frame trans(0.9, 0, 0) * rotx(psi);
    shape box(-0.2, -0.07, -0.07, 0, 0.07, 0.07);
  }
  body hand on wrist {
    param phi range(-120, 120) step(5) speed(150 deg/s) start(70);
    frame roty(-phi);
    shape box(-0.07, -0.06, -0.06, 0.16, 0.06, 0.06);
  }
  body drill on hand {
    param psi range(-180, 180) step(5) speed(200 deg/s);
    frame trans(0.16, 0, 0) * rotx(psi);
    shape box(0, -0.06, -0.12, 0.25, 0.06, 0.06);
  }
  body bit on drill {
    frame trans(0.25, 0, 0);
    shape cylinder(0.008, 0, 0.2) at roty(90);
  }
  touching turret fore;
  touching upper wrist;
  touching fore hand;
  touching wrist drill;
  touching hand bit;
  tool bit at trans(0.2, 0, 0) * roty(90);
  guide way rrt_connect { seed 1; }
  behaviour "arm.motion";
}
