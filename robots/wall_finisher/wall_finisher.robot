# Exterior wall finishing robot: a base on the roof edge, a carriage hanging before the wall, an end-effector that
# reaches 1.5 m to either side (1995 paper, 4.1). Each body has the paper's one-line behaviour; the robot's own makes the
# choice: where the effector's reach suffices the base stays.
robot wall_finisher {
  time_step 1;
  body base {
    param x range(0, 40) step(0.5) speed(0.25 m/s) accel(0.2 m/s2) start(2);
    frame trans(x, 0, 20);
    shape box(-1, 0, 0, 1, 2, 1);
    behaviour { chain { move_to(x, goal(x)) }; }
  }
  body carriage on base {
    param z range(-20, 0) step(0.5) speed(0.2 m/s) accel(0.2 m/s2) start(-1);
    frame trans(0, -0.5, z);
    shape box(-1.5, -0.5, -0.5, 1.5, 0, 0.5);
    behaviour { chain { move_to(z, goal(z)) }; }
  }
  body effector on carriage {
    param x range(-1.5, 1.5) step(0.25) speed(0.5 m/s) accel(0.5 m/s2);
    frame trans(x, 0, 0);
    shape box(-0.2, 0, -0.2, 0.2, 0.3, 0.2);
    behaviour { chain { move_to(x, goal(x)) }; }
  }
  tool effector;
  behaviour "by_reach.motion";
}
