# The higher of two tower cranes beside each other: jib 45 m, 18.5 m above that of the lower one, 38 m under the hook. Its rope
# goes through the plane of the lower jib. Round it a column of 3.4 m belongs to the crane, the distance that the drivers
# keep: so no jib comes above a load of 4 m, which can always be raised out of the way. The column hangs from the trolley and follows
# the hook more slowly: with the hook at its top it is just above the lower jib (33 m), with the hook on the ground it is
# still above all that the lower crane can lift (22 m).
robot tower_crane_high {
  time_step 1;
  body mast {
    shape box(-0.9, -0.9, 0, 0.9, 0.9, 49.5);
    shape box(-3, -3, 0, 3, 3, 0.8);  # foundation block
  }
  body jib on mast {
    param theta range(-180, 180) step(2) speed(0.6 rpm) loaded(0.4 rpm) accel(0.72 deg/s2);
    frame rotz(theta);
    shape box(-1.2, -1.2, 49.5, 1.2, 1.2, 52.5);  # slewing ring and cabin
    shape box(1.2, -0.7, 50, 45, 0.7, 51.5);  # jib
    shape box(-13, -0.9, 50, -1.2, 0.9, 51);  # counter-jib
    shape box(-13, -1.2, 48, -9.5, 1.2, 50);  # ballast
  }
  body trolley on jib {
    param x range(8, 44) step(0.5) speed(0.67 m/s) loaded(0.42 m/s) accel(0.25 m/s2) start(12);
    frame trans(x, 0, 49.7);
    shape box(-0.6, -0.6, 0, 0.6, 0.6, 0.3);
    shape box(-0.1, -0.1, -10.4, 0.1, 0.1, 0);  # the upper length of the rope
  }
  body hook on trolley {
    param z range(-1, 38) step(0.5) speed(0.67 m/s) loaded(0.33 m/s) accel(0.3 m/s2) start(20);  # the hook above the foot of the mast
    param theta cyclic step(5) speed(10 deg/s) loaded(6 deg/s) accel(5 deg/s2);
    frame trans(0, 0, 0.2923 * z - 27.7);
    shape cylinder(3.4, 0, 11.6);
  }
  body block on trolley {
    param z = hook.z;
    param theta = hook.theta;
    frame trans(0, 0, z - 49.7) * rotz(theta);
    shape box(-0.25, -0.25, 0, 0.25, 0.25, 1.2);  # hook block; the load hangs below
    shape box(-0.1, -0.1, 1.2, 0.1, 0.1, 11.5);  # the lower length of the rope
  }
  body rope_1 on trolley {
    param z = 0.8 * hook.z - 40.9;
    frame trans(0, 0, z);
    shape box(-0.1, -0.1, 0, 0.1, 0.1, 10.4);
  }
  body rope_2 on trolley {
    param z = 0.546 * hook.z - 31.25;
    frame trans(0, 0, z);
    shape box(-0.1, -0.1, 0, 0.1, 0.1, 10.4);
  }
  touching hook block;
  touching hook rope_1;
  touching hook rope_2;
  touching block rope_1;
  touching block rope_2;
  touching rope_1 rope_2;
  tool hook at trans(0, 0, 0.7077 * z - 22) * rotz(theta);
  capacity (4, 8 t), (18, 8 t), (30, 4.6 t), (45, 2.8 t);
  behaviour "lift_over_and_wait.motion";
}
