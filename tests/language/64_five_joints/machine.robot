robot arm {
  time_step 1;
  body b0 {
    param theta range(-84.0, 132.0) step(90) speed(10.0);
    frame trans(0.0, 0.0, 0.0) * rotz(-theta);
    shape box(-0.4, -0.3, 0.0, 0.4, 0.35, 1.0);
  }
  body b1 on b0 {
    param phi range(-85.0, 42.0) step(90) speed(6.0);
    frame trans(0.1, -0.037, 1.2) * rotz(17.3) * roty(-phi);
  }
  body b2 on b1 {
    param phi range(-158.0, 102.0) step(90) speed(15.5);
    frame trans(1.816, 0.049, 0.0) * roty(-phi);
  }
  body b3 on b2 {
    param theta range(-130.0, 124.0) step(90) speed(15.5);
    frame trans(1.719, 0.007, 0.0) * rotz(theta);
  }
  body b4 on b3 {
    param phi range(-146.0, 139.0) step(90) speed(30.0);
    frame trans(1.154, -0.008, 0.0) * roty(phi);
  }
  touching b0 b2;
  touching b1 b3;
  touching b2 b4;
  tool b4 at trans(0.82, 0.0, 0.0);
  behaviour "behaviour.motion";
}
