# A wrist that turns half as far as the jib it stands on, and a screw: 190 degrees are not -170.
robot geared {
  time_step 1;
  body jib {
    param theta cyclic step(5);
    frame trans(0, 0, 0.01 * theta) * rotz(theta);
    shape box(-0.5, -0.5, 0, 0.5, 0.5, 1);
  }
  body wrist on jib {
    param psi = jib.theta / 2;
    param z range(0, 10) step(1);
    frame trans(0, 0, z) * rotz(psi);
    shape box(0, -0.2, 1, 6, 0.2, 2);
  }
  tool wrist;
  behaviour "behaviour.motion";
}
