# A trolley that needs 2 s and 0.5 m to be fast, on a bridge whose speed is there at once.
robot ramped {
  time_step 1;
  body bridge {
    param y step(0.5) speed(0.5 m/s) range(-20, 20);
    frame trans(0, y, 0);
    shape box(-20, -0.2, 5, 20, 0.2, 5.4);
  }
  body trolley on bridge {
    param x step(0.5) speed(0.5 m/s) loaded(0.25 m/s) accel(250 mm/s2) range(-20, 20);
    param z step(0.5) speed(0.5 m/s) accel(0.5) range(0.5, 4.5) start(4);
    param theta cyclic step(30) speed(15 deg/s) accel(7.5 deg/s2);
    frame trans(x, 0, z) * rotz(theta);
    shape box(-0.2, -0.2, 0, 0.2, 0.2, 0.4);
  }
  tool trolley;
  behaviour "behaviour.motion";
}
