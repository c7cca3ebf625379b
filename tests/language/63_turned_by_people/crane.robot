# A slewing crane without a swivel.
robot crane {
  time_step 1;
  body mast { shape box(-0.3, -0.3, 0, 0.3, 0.3, 12); }
  body jib on mast {
    param theta range(-180, 180) step(5) speed(5 deg/s);
    frame rotz(theta);
    shape box(-1, -0.3, 12, 14, 0.3, 12.5);
  }
  body trolley on jib {
    param x range(2, 13) step(0.5) speed(0.5 m/s) start(10);
    frame trans(x, 0, 11.8);
    shape box(-0.2, -0.2, 0, 0.2, 0.2, 0.2);
  }
  body hook on trolley {
    param z range(0, 11) step(0.5) speed(0.5 m/s) start(9);
    frame trans(0, 0, z - 11.8);
    shape box(-0.1, -0.1, 0, 0.1, 0.1, 0.4);
  }
  rope hoist_rope(20 mm) from trolley to hook at (0, 0, 0.4);
  tool hook;
  behaviour {
    var(height) = 1 m;
    chain { move_to(z, max(z, goal(z) + var(height))) };
    chain { move_to(theta, goal(theta)), move_dir(z, dir(z, max(z))) };
    chain { move_to(x, goal(x)), move_dir(z, dir(z, max(z))) };
    which {
      place: chain { move_to(z, goal(z)) };
      transport: chain { move_to(z, goal(z) + var(height)) };
      default: chain { move_to(z, goal(z)) };
    };
  }
}
