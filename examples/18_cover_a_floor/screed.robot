# A screed on a bridge that travels along x; the beam hangs from a carriage on the bridge.
robot screed {
  body bridge {
    param x range(0, 8) step(0.5) speed(0.5 m/s);
    frame trans(x, 0, 0);
    shape box(-0.2, 0, 1.6, 0.2, 6, 2);
  }
  body beam on bridge {
    param y range(0, 6) step(0.5) speed(0.5 m/s) start(0.5);
    frame trans(0, y, 0.1);
    shape box(-0.1, -0.1, 0, 0.1, 0.1, 1.2);
  }
  tool beam;
  behaviour {
    which {
      working: chain { line };
      default: chain { move_to(y, goal(y)), move_to(x, goal(x)) };
    }
  }
}
