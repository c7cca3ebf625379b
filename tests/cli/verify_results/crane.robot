# A small slewing crane: jib, trolley with hook, a swivel.
robot crane {
  time_step 2;
  body mast { shape box(-0.4, -0.4, 0, 0.4, 0.4, 9); }
  body jib on mast {
    param theta range(-180, 180) step(6) speed(6 deg/s) loaded(4 deg/s);
    frame rotz(theta);
    shape box(-2, -0.3, 9, 12, 0.3, 9.5);
  }
  body hook on jib {
    param x range(1.5, 11.5) step(0.5) speed(0.5 m/s) loaded(0.4 m/s) start(4);
    param z range(0, 8) step(0.5) speed(0.5 m/s) loaded(0.25 m/s) start(6);
    param theta cyclic step(15) speed(15 deg/s);
    frame trans(x, 0, z) * rotz(theta);
    shape cylinder(0.15, 0, 0.4);
  }
  tool hook;
  capacity (2, 3 t), (12, 1.2 t);
  behaviour "crane.motion";
}
