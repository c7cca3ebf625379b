# The lower of two tower cranes beside each other: jib 45 m, 22 m under the hook. Its rope is there too, in four lengths of
# 8 m that slide past each other, so that nothing passes between trolley and hook.
robot tower_crane_low {
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
    shape box(-13, -0.9, 31.5, -1.2, 0.9, 32.5);  # counter-jib
    shape box(-13, -1.2, 29.5, -9.5, 1.2, 31.5);  # ballast
  }
  body trolley on jib {
    param x range(4, 44) step(0.5) speed(0.67 m/s) loaded(0.42 m/s) accel(0.25 m/s2) start(10);
    frame trans(x, 0, 31.2);
    shape box(-0.6, -0.6, 0, 0.6, 0.6, 0.3);
    shape box(-0.1, -0.1, -8, 0.1, 0.1, 0);  # the uppermost length
  }
  body hook on trolley {
    param z range(-1, 22) step(0.5) speed(0.67 m/s) loaded(0.33 m/s) accel(0.3 m/s2) start(20);
    param theta cyclic step(5) speed(10 deg/s) loaded(6 deg/s) accel(5 deg/s2);
    frame trans(0, 0, z - 31.2) * rotz(theta);  # z is the height of the hook above the foot of the mast
    shape box(-0.25, -0.25, 0, 0.25, 0.25, 1.2);  # hook block; the load hangs below
    shape box(-0.1, -0.1, 1.2, 0.1, 0.1, 9.2);  # the lowest length
  }
  body rope_1 on trolley {
    param z = (2 * hook.z - 68) / 3;  # a third of the way from the lowest length (hook.z - 30) to the uppermost (-8)
    frame trans(0, 0, z);
    shape box(-0.1, -0.1, 0, 0.1, 0.1, 8);
  }
  body rope_2 on trolley {
    param z = (hook.z - 46) / 3;
    frame trans(0, 0, z);
    shape box(-0.1, -0.1, 0, 0.1, 0.1, 8);
  }
  touching rope_1 hook;
  touching rope_2 hook;
  touching rope_1 rope_2;
  tool hook;
  capacity (4, 8 t), (18, 8 t), (30, 4.6 t), (45, 2.8 t);
  behaviour "lift_over_and_wait.motion";
}
