robot lamp {
  body b { param x step(1); frame trans(x, 0, 0); }
  behaviour "night.motion";
}
