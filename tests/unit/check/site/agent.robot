robot agent {
  body truck {
    param x step(1);
    param y;
    param z;
    param theta cyclic step(15);
    rule x <- x + x_s * cos(theta) - y_s * sin(theta);
    rule y <- y + x_s * sin(theta) + y_s * cos(theta);
    rule z <- z_c;
    frame trans(x, y, z) * rotz(theta);
  }
  behaviour { chain { move_to(x, r_goal(x)) }; }
}
