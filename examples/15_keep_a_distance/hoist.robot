# A hoist on a rail that others use too. Its trolley keeps a metre from everything; its hook has to touch what it takes.
robot hoist {
  body trolley {
    param x range(0, 30) step(1) speed(1 m/s);
    frame trans(x, 0, 9);
    shape box(-0.6, -0.4, 0, 0.6, 0.4, 0.5);
  }
  body hook on trolley {
    param z range(0, 8.5) step(0.5) speed(0.5 m/s) start(6);
    frame trans(0, 0, z - 9);
    shape box(-0.2, -0.2, 0, 0.2, 0.2, 0.4);
  }
  tool hook;
  buffer 1 m;
  behaviour "give_way.motion";
}
