"""Plans made from a seed in which machines stand in each other's way and their scripts wait by counters and clocks, so that
no state ever comes back: pairs that face each other in a corridor, and rings of three or four on one circle."""

import os
import random
import re

CAR = """robot %s {
  body car {
    param x range(-100, 100) step(1) speed(1 m/s);
    frame trans(x, 0, 0);
    shape box(-0.5, -0.5, 0, 0.5, 0.5, 1);
  }
  tool car;
  behaviour { %s }
}
"""
CARRIAGE = """robot %s {
  body car {
    param theta range(-180, 180) step(5) speed(5 deg/s);
    frame rotz(theta) * trans(10, 0, 0);
    shape box(-0.5, -0.5, 0, 0.5, 0.5, 1);
  }
  tool car;
  behaviour { %s }
}
"""
# What a script counts by: how a count begins, how it goes on, and while what it waits.
COUNTS = (("var(n) = 0;", "var(n) = var(n) + 1", "var(n) < {patience}"),
          ("var(n) = {patience};", "var(n) = var(n) - 1", "var(n) > 0"),
          ("var(n) = {patience};", "var(n) = var(n) + 1", "var(n) > 0"),  # a slip of the sign: for ever
          ("var(n) = 0;", "var(n) = time()", "var(n) < {patience}"),
          ("var(n) = 0;", "var(n) = 1.01 * var(n) + time()", "var(n) < {patience}"),
          ("", "", "time() < {patience}"))


def script(rng):
    choice = rng.choice
    begin, count, waits = choice(COUNTS)
    values = {"patience": choice((5, 30, 200, 3600, 1e15))}
    begin, waits = begin.format(**values), waits.format(**values)
    step = count + ", " if count else ""
    aside = choice(("", "", "", "move_dir(x, 1), ", "move_dir(x, -1), ", "move_dir(x, -1), move_dir(x, 1), "))
    wait = choice(("wait", "wait", "wait", "chain { wait, wait }"))
    forms = (
        f"chain {{ move_to(x, goal(x)), {step}{aside}{wait} }};",
        f"first {{ move_to(x, goal(x)), {step}{aside}{wait} }};",
        f"cycle {{ move_to(x, goal(x)), {step}{wait} }} until (dist(x, goal(x)) < 0.001);",
        f"chain {{ each {{ move_to(x, goal(x)), move_dir(x, dir(x, goal(x))) }}, {step}{wait} }};",
        f"chain {{ {step}{wait} }} until (not ({waits})); chain {{ move_to(x, goal(x)), {aside}{step}{wait} }};",
        f"chain {{ which {{ when ({waits} and not clear(x, dir(x, goal(x)))): {step.replace(', ', '; ')}wait; "
        f"default: move_to(x, goal(x)); }} }} until (dist(x, goal(x)) < 0.001);",
        "chain { move_to(x, goal(x)), wait };",
        "first { move_to(x, goal(x)), wait };",
    )
    form = choice(forms)
    return f"{begin} {form}" if "var(n)" in form else form


def named(ring, text):
    """The text with the name of the only parameter."""
    return re.sub(r"\bx\b", "theta", text) if ring else text


def write_plan(seed, folder):
    """Writes the plan of this seed and its robots; its path."""
    rng = random.Random(seed)
    choice = rng.choice
    ring = rng.random() < 0.4
    count = choice((3, 4)) if ring else 2
    lines = ["plan site {", f"  budget {choice((40, 150, 400))};"]
    for number in range(count):
        with open(os.path.join(folder, f"r{number}.robot"), "w", encoding="utf-8") as file:
            file.write((CARRIAGE if ring else CAR) % (f"r{number}", named(ring, script(rng))))
        start = number * 360 // count - 180 + 45 if ring else (-6, 6)[number]
        park = choice(("", "", "", f" park x {start};"))
        lines.append(f'  robot r{number} "r{number}.robot" {{ start x {start};{park} }}')
    if rng.random() < 0.4:
        lines.append("  crew people;")
        for number in range(choice((1, 3))):
            lines.append(f"  task work{number} {{ by people; takes {choice((7, 60, 300))} s; }}")
    for number in range(count):
        goal = (number + 1) % count * 360 // count - 180 + 45 if ring else (7, -7)[number]
        via = f" via x {(number * 360 // count - 180 + 60) if ring else (-4, 4)[number]};" if rng.random() < 0.3 else ""
        back = choice(("", "", "", f" after drive{number - 1};" if number else ""))
        lines.append(f"  task drive{number} {{ by r{number}; go x {goal};{via}{back} priority {choice((0, 0, 1))}; }}")
    path = os.path.join(folder, "site.plan")
    with open(path, "w", encoding="utf-8") as file:
        file.write(named(ring, "\n".join(lines)) + "\n}\n")
    return path
