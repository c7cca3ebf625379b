robot arm {
  const level = 35 deg;
  body boom { param phi range(-60, 60) step(1); frame roty(phi); }
  body bucket on boom { param phi = level - boom.phi; frame trans(3, 0, 0) * roty(phi); }
  behaviour { chain { move_to(boom.phi, goal(boom.phi)) }; }
}
