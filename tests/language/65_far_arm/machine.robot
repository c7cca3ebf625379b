robot arm {
  time_step 1;
  body b0 {
    param theta cyclic step(90) speed(15.5);
    frame trans(0.0, 0.0, 0.0) * rotz(-theta);
    shape box(-0.4, -0.3, 0.0, 0.4, 0.35, 1.0);
  }
  body b1 on b0 {
    param theta range(-41.0, 155.0) step(90) speed(10.0);
    frame trans(0.1, -0.038, 1.2) * rotz(theta);
    shape sphere(0.836, 0.0, 0.0, 0.244);
  }
  body b2 on b1 {
    param x range(0.0, 0.728) step(1) speed(0.35);
    frame trans(1.671, 0.082, 0.0) * trans(x, 0.0, 0.0);
    shape cylinder(0.232, 0.15, 1.662) at roty(90.0);
    shape box(-0.1, -0.1, -0.1, 0.1, 0.12, 0.1);
  }
  body b3 on b2 {
    param phi range(-61.0, 115.0) step(90) speed(10.0);
    frame trans(1.812, -0.041, 0.0) * roty(-45.0) * roty(phi);
    shape capsule(0.3, 0.0, 0.0, 0.763, -0.047, 0.0, 0.206);
  }
  body b4 on b3 {
    param z range(0.0, 1.195) step(1) speed(0.2);
    frame trans(1.063, 0.087, 0.0) * trans(0.0, 0.0, -z);
    shape cylinder(0.196, 0.15, 0.707) at roty(90.0);
  }
  body b5 on b4 {
    param phi cyclic step(90) speed(6.0);
    frame trans(0.857, 0.02, 0.0) * roty(90.0) * roty(-phi);
    shape prism(-0.199, 0.199, 0.15, -0.199, 0.489, -0.119, 0.439, 0.139, 0.2, 0.199);
  }
  touching b0 b2;
  touching b1 b3;
  touching b2 b4;
  touching b3 b5;
  tool b5 at trans(0.639, 0.0, 0.0) * roty(90.0);
  behaviour "behaviour.motion";
}
