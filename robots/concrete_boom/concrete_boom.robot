# A concrete pump with a boom of four parts of 6 m, folded like a zigzag: all parts stand at the same angle to the horizontal, up and
# down in turn. So the tip stays as high as the foot of the boom, whatever its reach, and two parameters guide the hose over a floor.
robot concrete_boom {
  body boom_1 {
    param theta step(2) speed(6 deg/s) accel(6 deg/s2);
    param phi range(20, 85) step(1) speed(4 deg/s) accel(4 deg/s2) start(60);
    frame trans(0, 0, 4.2) * rotz(theta) * roty(-phi);
    shape box(0, -0.3, -0.3, 6, 0.3, 0.3);
  }
  body boom_2 on boom_1 {
    param phi = -2 * boom_1.phi;
    frame trans(6, 0, 0) * roty(-phi);
    shape box(0, -0.25, -0.25, 6, 0.25, 0.25);
  }
  body boom_3 on boom_2 {
    param phi = 2 * boom_1.phi;
    frame trans(6, 0, 0) * roty(-phi);
    shape box(0, -0.2, -0.2, 6, 0.2, 0.2);
  }
  body boom_4 on boom_3 {
    param phi = -2 * boom_1.phi;
    frame trans(6, 0, 0) * roty(-phi);
    shape box(0, -0.15, -0.15, 6, 0.15, 0.15);
  }
  body hose on boom_4 {
    param phi = boom_1.phi;
    frame trans(6, 0, 0) * roty(-phi);
    shape cylinder(0.1, -3.6, 0);
  }
  body truck {
    shape box(-4, -1.25, 0.5, 4, 1.25, 3.6);
    shape cylinder(0.4, 3.6, 3.9);
  }
  tool hose at trans(0, 0, -3.6);
  behaviour "pour.motion";
}
