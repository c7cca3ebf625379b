"""Plans made from a seed that mix what plans seldom mix: milestones and tasks that take no time, all links with lags both
ways, calendars with shifts of a minute and over midnight, days off in a row, crews shared on the way, removals of what
others need, park positions and zones in each other's way, robots in one place, load charts."""

import os
import random

LINE = """robot %s {
  body car {
    param x range(-100, 100) step(1) speed(1 m/s);
    frame trans(x, 0, 0);
    shape box(-0.5, -0.5, 0, 0.5, 0.5, 1);
  }
  tool car;
  behaviour { %s }
}
"""
GANTRY = """robot %s {
  body hoist {
    param x range(-100, 100) step(1) speed(1 m/s);
    param y range(-100, 100) step(1) speed(1 m/s);
    param z range(0, 20) step(1) speed(1 m/s) start(5);
    frame trans(x, y, z);
    shape box(-0.2, -0.2, 0, 0.2, 0.2, 1);
  }
  tool hoist;
  capacity (10, 4 t), (30, 2 t), (90, 1 t);
  behaviour { %s }
}
"""
ROBOTS = {
    "line": (LINE, "chain { move_to(x, goal(x)) };"),
    "waiting": (LINE, "first { move_to(x, goal(x)), wait };"),
    "evading": (LINE, "first { move_to(x, goal(x)), move_dir(x, -1), wait };"),
    "pacing": (LINE, "cycle { move_dir(x, 1), move_dir(x, -1) };"),
    "gantry": (GANTRY, "chain { move_to(z, 8) }; chain { move_to(x, goal(x)) }; chain { move_to(y, goal(y)) };"
                       " chain { move_to(z, goal(z)) };"),
    "straight": (GANTRY, "first { move_to(x, goal(x)), move_to(y, goal(y)), move_to(z, goal(z)), wait };"),
}
HOURS = ("mon-fri 07:00-12:00, 12:30-16:00;", "mon-sun 00:00-00:01, 00:02-00:03, 06:00-06:01, 23:59-24:00;",
         "mon-sun 22:00-24:00; mon-sun 00:00-06:00; off 2026-03-03, 2026-03-04, 2026-03-05;",
         "mon-sun 00:00-00:10, 00:11-12:00, 12:01-24:00;", "mon-sat 06:00-14:00; off 2026-03-02, 2026-03-03;",
         "mon-sun 20:00-24:00; mon-sun 00:00-08:00;", "tue-sun 07:30-15:00;")


class Plan:
    """A plan as items for its head, and tasks: a name, items and links (task before, type, lag in seconds)."""

    def __init__(self, seed):
        self.rng = random.Random(seed)
        self.head = []
        self.tasks = []
        choice = self.rng.choice
        self.head += [f'start_at "2026-03-0{self.rng.randrange(2, 8)} {choice((0, 6, 7, 15, 23)):02}:{choice((0, 30, 59)):02}";',
                      'currency "EUR";', f"contact {choice((0, 1, 5))} mm;"]
        for name in ("day", "night"):
            self.head.append(f"calendar {name} {{ {choice(HOURS)} {choice(('', '', 'carry_over;'))} }}")
        self.robots = [self.add_robot(number) for number in range(self.rng.randrange(5))]
        self.crews = [f"c{number}" for number in range(self.rng.randrange(1, 4))]
        for crew in self.crews:
            self.head.append(f"crew {crew} {{ size {self.rng.randrange(1, 4)}; {self.terms()} }}")
        self.components = [self.add_component(number) for number in range(self.rng.randrange(6))]
        for number in range(choice((0, 1, 2, 4, 6, 9, 12))):
            self.add_task(number)

    def terms(self):
        cost = f"cost {self.rng.choice((0, 1, 33.3, 180, 1e6))} per h;" if self.rng.random() < 0.6 else ""
        return cost + (self.rng.choice((" calendar day;", " calendar night;")) if self.rng.random() < 0.4 else "")

    def add_robot(self, number):
        rng, choice = self.rng, self.rng.choice
        kind = choice(("line", "line", "waiting", "evading", "gantry", "gantry", "straight", "pacing"))
        park = ""
        if ROBOTS[kind][0] is GANTRY:
            start = f"start x {rng.randrange(-8, 9)}, y {choice((0, 3, -3, 10))}, z {rng.randrange(1, 9)};"
            if rng.random() < 0.5:
                park = f"park x {choice((-20, 0, 20, 5))}, y {choice((-20, 0, 20))}, z {rng.randrange(10)};"
        else:
            start = f"start x {rng.randrange(-10, 11)};"
            if rng.random() < 0.5:
                park = f"park x {choice((-30, 30, 0, 4))};"
        place = choice(("", "at trans(0, 0, 0)", "at trans(0, 2, 0)", "at trans(3, 0, 0) * rotz(90)"))
        self.head.append(f'robot r{number} "{kind}.robot" {place} {{ {start} {park} {self.terms()} }}')
        return f"r{number}", kind

    def add_component(self, number):
        rng, choice = self.rng, self.rng.choice
        place = f"{rng.randrange(-8, 9)}, {choice((0, 0, 2, 5, -4))}, {choice((0, 0, 0, 0.6))}"
        self.head.append(f"component k{number} {{ shape box(-0.4, -0.4, 0, 0.4, 0.4, 0.6); at trans({place}); "
                         f"grip trans(0, 0, 0.6); mass {choice((0.1, 1, 3))} t; }}")
        return f"k{number}"

    def duration(self):
        return self.rng.choice((0, 0, 1, 7, 30, 60, 90, 600, 3600, 30000))

    def motion(self, kind):
        """What a robot of this kind does in a task."""
        rng, choice = self.rng, self.rng.choice
        if ROBOTS[kind][0] is LINE:
            return [f"go x {rng.randrange(-14, 15)};", "budget 20;" if kind == "pacing" else ""]
        if not self.components or rng.random() < 0.3:
            return [f"go x {rng.randrange(-12, 13)}, y {choice((0, 2, -4, 30))}, z {rng.randrange(9)};"]
        items = [f"move {choice(self.components)} to trans({rng.randrange(-8, 9)}, {choice((0, 2, 5, -4, 200))}, "
                 f"{choice((0, 0, 0.6, 1.2, -1))});", f"within {choice((0.05, 0.5))};" if rng.random() < 0.3 else ""]
        for work in ("hook", "adjust", "release"):
            if rng.random() < 0.6:
                by = f" by {choice(self.crews)}" if rng.random() < 0.6 else ""
                items.append(f"{work} {self.duration()} s{by};")
        return items

    def add_task(self, number):
        rng, choice = self.rng, self.rng.choice
        items, by = [], []
        if self.robots and rng.random() < 0.65:
            name, kind = choice(self.robots)
            items += self.motion(kind)
            by = [name] + ([choice(self.crews)] if rng.random() < 0.3 else [])
        elif rng.random() < 0.9:
            by = rng.sample(self.crews, rng.randrange(1, min(2, len(self.crews)) + 1))
        if by:
            items.append("by " + ", ".join(by) + ";")
        for _ in range(choice((0, 1, 1, 2)) if not by or by[0] in self.crews or rng.random() < 0.3 else 0):
            items.append(f"takes {self.duration()} s;")
        if self.components and rng.random() < 0.15:
            items.append(f"remove {choice(self.components)};")
        if rng.random() < 0.25:
            x, y = rng.randrange(-8, 8), choice((-1, -1, 2, -4))
            items.append(f"zone box({x}, {y}, 0, {x + choice((1, 4))}, {y + 2}, {choice((1, 3))});")
        if rng.random() < 0.4:
            items.append(f"priority {choice((-1, 1, 2, 5))};")
        links = [(f"t{rng.randrange(number)}", choice(("FS", "FS", "SS", "FF", "SF")),
                  choice((0, 0, 5, 60, 3600, 86400, -5, -60, -3600, -86400)))
                 for _ in range(choice((0, 0, 1, 1, 2, 3)) if number > 0 else 0)]
        self.tasks.append((f"t{number}", items, links))

    def followers(self, name):
        """All tasks that come after a task, by links of any type."""
        found = {name}
        for task, _, links in self.tasks:  # links go backwards in the file
            if any(before in found for before, _, _ in links):
                found.add(task)
        return found - {name}

    def text(self, without=()):
        """The plan; tasks of `without` and links to them are left out."""
        lines = ["plan site {"] + ["  " + item for item in self.head]
        for name, items, links in self.tasks:
            if name in without:
                continue
            after = ", ".join(f"{task} {kind}" + (f" {'+' if lag > 0 else '-'} {abs(lag)} s" if lag else "")
                              for task, kind, lag in links if task not in without)
            lines.append(f"  task {name} {{ {' '.join(items)} {f'after {after};' if after else ''} }}")
        return "\n".join(lines) + "\n}\n"


def write_robots(folder):
    for name, (text, script) in ROBOTS.items():
        with open(os.path.join(folder, name + ".robot"), "w", encoding="utf-8") as file:
            file.write(text % (name, script))
