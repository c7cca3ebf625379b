"""Plans with random machines, scripts, sites and calendars, which get into each other's way."""

import math
import os
import random
import shutil

HERE = os.path.dirname(os.path.abspath(__file__))

# The parameters of random steps, and the text. All turn by theta, which the goals are about.
ROBOTS = (
    (("theta", "boom.phi", "stick.phi"), """robot arm {
  time_step 1;
  body base {
    param theta cyclic step(%(turn)g) speed(5);
    frame trans(0, 0, 0.5) * rotz(theta);
    shape cylinder(0.5, -0.5, 0.2);
  }
  body boom on base {
    param phi range(-80, 80) step(%(small_turn)g) speed(5);
    frame trans(0.2, 0, 0.3) * roty(phi);
    shape box(0, -0.1, -0.1, 2, 0.1, 0.1);
  }
  body stick on boom {
    param phi range(-150, 150) step(%(small_turn)g) speed(5);
    frame trans(2, 0, 0) * roty(phi);
    shape %(shape)s;
  }
  tool stick;
  touching base stick;
  behaviour "%(script)s";
}
"""),
    (("theta", "x", "z", "psi"), """robot crane {
  time_step 1;
  body jib {
    param theta range(-180, 180) step(%(turn)g) speed(5);
    frame rotz(theta);
    shape box(-1, -0.2, 4, 5, 0.2, 4.3);
  }
  body hook on jib {
    param x range(0.5, 5) step(%(move)g) speed(1);
    param z range(0, 3.5) step(%(small_move)g) speed(1);
    param psi cyclic step(%(small_turn)g) speed(10);
    frame trans(x, 0, z) * rotx(psi);
    shape %(shape)s;
  }
  tool hook;
  behaviour "%(script)s";
}
"""),
    (("x", "theta", "z"), """robot cart {
  time_step 1;
  body truck {
    param x step(%(move)g) speed(1) range(-9, 9);
    param y range(-9, 9);
    param theta cyclic step(%(turn)g) speed(10);
    param z step(%(small_move)g) speed(1) range(0, 3);
    rule x <- x + x_s * cos(theta);
    rule y <- y + x_s * sin(theta);
    frame trans(x, y, z) * rotz(theta);
    shape %(shape)s;
  }
  tool truck;
  behaviour "%(script)s";
}
"""))


def shape(rng, size):
    """Any kind of shape, somewhere near the origin, straight or turned."""

    def length(least=0.1, most=1.0):
        return round(size * rng.uniform(least, most), 3)

    kind = rng.choice(("box", "box", "cylinder", "sphere", "capsule", "prism", "mesh"))
    if kind == "box":
        low, high = (-length(), -length(), -length(0.01, 0.5)), (length(), length(), length(0.01, 0.5))
        solid = "box(%g, %g, %g, %g, %g, %g)" % (*low, *high)
    elif kind == "cylinder":
        solid = f"cylinder({length(0.05, 0.6)}, {-length(0.01)}, {length(0.01)})"
    elif kind == "sphere":
        solid = f"sphere(0, 0, 0, {length(0.05, 0.6)})"
    elif kind == "capsule":
        solid = f"capsule(0, 0, 0, {length()}, {length()}, {length()}, {length(0.03, 0.4)})"
    elif kind == "prism":
        corners = []
        count = rng.randrange(5, 10)
        for i in range(count):  # a star, seldom convex
            radius = length(0.2)
            corners += [radius * math.cos(2 * math.pi * i / count), radius * math.sin(2 * math.pi * i / count)]
        solid = f"prism({-length(0.01, 0.5)}, {length(0.01, 0.5)}, {', '.join('%.3f' % c for c in corners)})"
    else:
        solid = f'mesh("angle.stl", m, scale {length(0.3)})'
    turn = [rng.choice((0, 0, 90, round(rng.uniform(0, 360), 3))) for _ in range(2)]
    place = [length(-0.3, 0.3) for _ in range(3)]
    return f"{solid} at trans({place[0]}, {place[1]}, {place[2]}) * rotx({turn[0]}) * rotz({turn[1]})"


def script(rng, parameters):
    """To the goal, then here and there for a while, then to the goal again."""
    elements = [f"move_dir({rng.choice(parameters)}, {rng.choice((1, -1))})" for _ in range(4)]
    first, second = rng.sample(parameters, 2)
    elements.append(f"together {{ move_dir({first}, 1), move_dir({second}, -1) }}")
    rng.shuffle(elements)
    if rng.random() < 0.5:
        elements.append("wait")
    return ("chain { move_to(theta, goal(theta)) };\n"
            f"chain {{ {', '.join(elements)} }} until (time() > {rng.choice((5, 20, 60))});\n"
            "chain { move_to(theta, goal(theta)) };\n")


def robot(rng, number, count, folder):
    """Writes a robot; its statement in the plan, and its tasks."""
    parameters, text = rng.choice(ROBOTS)
    values = {"turn": rng.choice((1, 5, 20, 60)), "small_turn": rng.choice((1, 5, 20, 45)),
              "move": rng.choice((0.05, 0.3, 1)), "small_move": rng.choice((0.05, 0.2, 0.7)),
              "shape": shape(rng, 0.7), "script": f"script_{number}.motion"}
    with open(os.path.join(folder, f"robot_{number}.robot"), "w", encoding="utf-8") as file:
        file.write(text % values)
    with open(os.path.join(folder, f"script_{number}.motion"), "w", encoding="utf-8") as file:
        file.write(script(rng, parameters))
    angle, radius = 2 * math.pi * number / count, rng.uniform(1.2, 4)
    extra = rng.choice(("", "calendar day;", f"park theta {rng.randrange(-90, 90)};"))
    statement = (f'  robot r{number} "robot_{number}.robot" at trans({radius * math.cos(angle):.3f}, '
                 f"{radius * math.sin(angle):.3f}, 0) * rotz({rng.choice((0, 90, 200))}) {{ {extra} }}\n")
    tasks = ""
    for task in range(rng.randrange(1, 4)):
        items = [f"by r{number}{rng.choice(('', ', crew_1'))};", f"go theta {rng.uniform(-150, 150):.3f};",
                 "budget 300;", f"takes {rng.choice((0, 7))} s;"]
        if rng.random() < 0.2:
            x, y = rng.uniform(-3, 3), rng.uniform(-3, 3)
            items.append(f"zone box({x:.3f}, {y:.3f}, 0, {x + 1:.3f}, {y + 1:.3f}, 3);")
        if number > 0 and rng.random() < 0.4:
            link = rng.choice(("FS", "SS", "FF", "SF")) + rng.choice(("", " + 10 s", " - 5 s"))
            items.append(f"after t{rng.randrange(number)}_0 {link};")
        tasks += f"  task t{number}_{task} {{ {' '.join(items)} }}\n"
    return statement, tasks


def write_plan(seed, folder):
    """Writes the plan of this seed and all it needs; its path."""
    rng = random.Random(seed)
    shutil.copy(os.path.join(HERE, "verify_results", "angle.stl"), folder)
    count = rng.randrange(1, 4)
    robots, tasks = zip(*(robot(rng, number, count, folder) for number in range(count)))
    components = ""
    for number in range(rng.randrange(0, 12 if count == 1 else 4)):
        place = [round(rng.uniform(-5, 5), 3), round(rng.uniform(-5, 5), 3), round(rng.uniform(0, 3), 3)]
        components += (f"  component c{number} {{ shape {shape(rng, 1)}; at trans({place[0]}, {place[1]}, {place[2]})"
                       f" * rotz({rng.choice((0, 90, round(rng.uniform(0, 360), 3)))}); }}\n")
    carry_over = rng.choice(("", " carry_over;"))
    path = os.path.join(folder, "random.plan")
    with open(path, "w", encoding="utf-8") as file:
        file.write("plan random {\n"
                   f"  contact {rng.choice((0, 1, 1, 5, 20))} mm;\n"
                   '  start_at "2026-03-02 00:00";\n'
                   f"  calendar day {{ mon-sun 00:01-00:02, 00:03-00:10, 00:12-23:00;{carry_over} }}\n"
                   f"  crew crew_1 {{ {rng.choice(('', 'calendar day;'))} }}\n"
                   + "".join(robots) + components + "".join(tasks) + "}\n")
    return path
