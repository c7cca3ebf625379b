# Tower crane with fixed base: slewing jib, trolley, hoist. Jib 45 m, 30 m under the hook.
robot tower_crane {
  time_step 1;
  body mast {
    shape box(-0.9, -0.9, 0, 0.9, 0.9, 31);
    shape box(-3, -3, 0, 3, 3, 0.8);  # foundation block
  }
  body jib on mast {
    param theta range(-180, 180) step(2) speed(0.6 rpm) loaded(0.4 rpm) accel(0.72 deg/s2);
    frame rotz(theta);
    shape box(-1.2, -1.2, 31, 1.2, 1.2, 34);  # slewing ring and cabin
    shape box(1.2, -0.7, 31.5, 45, 0.7, 33);  # jib
  }
  body counter_jib on jib {
    frame trans(0, 0, 0);
    shape box(-13, -0.9, 31.5, -1.2, 0.9, 32.5);
    shape box(-13, -1.2, 29.5, -9.5, 1.2, 31.5);  # ballast
  }
  body trolley on jib {
    param x range(4, 44) step(0.5) speed(0.67 m/s) loaded(0.42 m/s) accel(0.25 m/s2) start(10);
    frame trans(x, 0, 31.2);
    shape box(-0.6, -0.6, 0, 0.6, 0.6, 0.3);
  }
  body hook on trolley {
    param z range(0, 29) step(0.5) speed(0.67 m/s) loaded(0.33 m/s) accel(0.3 m/s2) start(20);
    frame trans(0, 0, z - 31.2);  # z is the height of the hook above the foot of the mast
    shape box(-0.25, -0.25, 0, 0.25, 0.25, 1.2);  # hook block; the load hangs below
  }
  rope hoist_rope(20 mm) from trolley to hook at (0, 0, 1.2);  # all its falls together
  tool hook;
  capacity (4, 8 t), (18, 8 t), (30, 4.6 t), (45, 2.8 t);
  behaviour "lift_over.motion";
}
