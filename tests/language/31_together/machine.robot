# An arm in the XZ plane on a turning base, its bucket kept level by a derived parameter.
robot arm {
  time_step 1;
  const level = 0 deg;
  body base {
    param theta range(-170, 170) step(5) speed(20 deg/s) loaded(12 deg/s);
    frame trans(0, 0, 1) * rotz(theta);
    shape cylinder(0.9, -1, 0);
  }
  body boom on base {
    param phi range(-60, 20) step(4) speed(12 deg/s);
    frame trans(0.3, 0, 0.2) * roty(phi);
    shape box(0, -0.2, -0.2, 4, 0.2, 0.2);
  }
  body stick on boom {
    param phi range(0, 130) step(6) speed(18 deg/s);
    frame trans(4, 0, 0) * roty(phi);
    shape capsule(0, 0, 0, 2.5, 0, 0, 0.15);
  }
  body bucket on stick {
    param phi = level - boom.phi - stick.phi;
    frame trans(2.7, 0, 0) * roty(phi);
    shape prism(-0.4, 0.4, 0, 0.1, 0.8, 0.1, 0.6, -0.5, 0.1, -0.5) at rotx(90);
  }
  tool bucket;
  touching boom bucket;
  behaviour "behaviour.motion";
}
