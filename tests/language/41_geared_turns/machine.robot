# A mirror that turns twice as far as the jib, the other way: whole turns, so that angles stay in (-180, 180].
robot geared {
  time_step 1;
  body jib {
    param theta cyclic step(5);
    frame rotz(theta);
    shape box(-0.5, -0.5, 0, 0.5, 0.5, 1);
  }
  body mirror on jib {
    param psi = 30 - 2 * jib.theta;
    param z range(0, 10) step(1);
    frame trans(0, 0, z) * rotz(psi);
    shape box(0, -0.2, 1, 6, 0.2, 2);
  }
  tool mirror;
  behaviour "behaviour.motion";
}
