# A crawler arm of three joints. Its behaviour only follows: which way, a guide says.
robot arm {
  time_step 1;
  body base {
    param theta cyclic step(5) speed(10 deg/s);
    frame rotz(theta);
    shape box(-0.8, -0.6, 0, 0.8, 0.6, 1);
  }
  body boom on base {
    param phi range(-10, 90) step(5) speed(5 deg/s) start(60);
    frame trans(0, 0, 1.2) * roty(-phi);
    shape box(0, -0.15, -0.15, 3, 0.15, 0.15);
  }
  body stick on boom {
    param phi range(-150, 0) step(5) speed(10 deg/s) start(-90);
    frame trans(3, 0, 0) * roty(-phi);
    shape box(0, -0.1, -0.1, 2.4, 0.1, 0.1);
  }
  tool stick at trans(2.4, 0, 0);
  behaviour { chain { follow }; }
}
