# The excavator of excavator_digging.robot on tracks: it travels along x, from one work position to the next, and digs from where it stands.
robot excavator_on_tracks {
  time_step 1;
  body undercarriage {
    param x step(1) speed(1 m/s) range(-100, 100);
    frame trans(x, 0, 0);
    shape box(-2.2, -1.4, 0, 2.2, 1.4, 1);
  }
  body upper on undercarriage {
    param theta cyclic step(5) speed(15 deg/s);
    frame rotz(theta);
    shape box(-3, -1.25, 1.2, 1, 1.25, 3);
  }
  body boom on upper {
    param phi range(-57, 65) step(5) speed(5.5 deg/s) start(40);
    frame trans(0.228, 0, 1.957) * roty(-phi);
    shape box(-0.1, -0.25, -0.35, 3.1, 0.25, 0.35) at roty(-20);
    shape box(-0.1, -0.22, -0.3, 2.9, 0.22, 0.3) at trans(2.72, 0, 0.99) * roty(20);
  }
  body stick on boom {
    param phi range(26, 146) step(5) speed(22.5 deg/s) start(80);
    frame trans(5.648, 0, 0) * roty(180 - phi);
    shape box(-0.4, -0.18, -0.25, 2.8, 0.18, 0.25);
  }
  body bucket on stick {
    param phi range(44, 215) step(5) speed(31.71 deg/s) start(120);
    frame trans(2.889, 0, 0) * roty(180 - phi);
    shape box(0, -0.5, -0.65, 1.4, 0.5, 0.15);
  }
  touching boom bucket;
  tool bucket at trans(1.562, 0, 0);  # the tip of the teeth
  deviation 5 mm, 0.5 deg;  # of the teeth beside the line of a cut; machine control on site holds them to 20 to 30 mm
  guide way rrt_connect { seed 1; }
  behaviour "excavator_digging.motion";
}
