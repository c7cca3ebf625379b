#!/usr/bin/env python3
"""Crosses the yard of taskplans/busy_yard.plan with each guide, and prints what it takes and how near it came to others.

    taskplans/cross_yard.py PATH/TO/rubicon

Time, way and stops are those of `rubicon run`. How near the motor came to people, vehicles and the gate is reckoned here,
from the trace: their outlines seen from above, ten times a second.
"""

import json
import math
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
PLAN = os.path.join(HERE, "busy_yard.plan")
GUIDES = ("bug1", "bug2", "visbug21", "simple", "tangent", "ace", "visibility")

NEAR = 0.5
"""m; a near miss: the motor drives or turns with somebody nearer than this."""

APART = 2
"""s; near misses of one thing that are nearer in time count once."""

FAR = 15
"""m between corners: nothing here is so large that it could be near then."""

SAMPLES = 10
"""A second."""


def run(rubicon, way):
    """Exit code, schedule, trace of the plan led by the guide of this number."""
    with tempfile.TemporaryDirectory() as folder:
        told = subprocess.run([rubicon, "run", PLAN, "--set", f"way={way}", "--out", folder, "--format", "json"],
                              capture_output=True, text=True, check=False)
        if told.returncode not in (0, 1):
            sys.exit(told.stderr)
        with open(os.path.join(folder, "trace.jsonl"), encoding="utf-8") as file:
            return told.returncode, json.loads(told.stdout), [json.loads(line) for line in file]


def outline(shape):
    """Corners (m) of a shape seen from above, in its own frame."""
    if shape["type"] == "box":
        (x0, y0, _), (x1, y1, _) = shape["lower"], shape["upper"]
        return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    # An upright capsule; the polygon lies round the circle.
    radius = shape["radius"] / math.cos(math.pi / 16)
    return [(radius * math.cos(k * math.pi / 8), radius * math.sin(k * math.pi / 8)) for k in range(16)]


def placed(corners, x, y, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [(x + c * a - s * b, y + s * a + c * b) for a, b in corners]


def off_segment(p, a, b):
    dx, dy = b[0] - a[0], b[1] - a[1]
    share = min(max(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy), 0), 1)
    return math.hypot(p[0] - a[0] - share * dx, p[1] - a[1] - share * dy)


def distance(one, other):
    """Between two convex outlines that do not overlap."""
    return min(off_segment(p, polygon[k - 1], polygon[k])
               for points, polygon in ((one, other), (other, one)) for p in points for k in range(len(polygon)))


def heading(pose):
    return math.degrees(math.atan2(pose[4], pose[0]))


class Thing:
    """Something with a timetable: where it is at a time of the plan (s)."""

    def __init__(self, header, stops):
        self.name = header["name"]
        self.people = "overhead" in header
        self.path = [(each["t"], each["pose"][3], each["pose"][7], heading(each["pose"])) for each in header["path"]]
        self.corners = [outline(shape) for shape in header["shapes"]]
        self.runs = [(0, 0, False)]  # from when, its own time then, whether it stands
        for stop in stops:
            start, own, stands = self.runs[-1]
            if stop["by"] == "" or not stands:
                self.runs.append((stop["t"], own if stands else own + stop["t"] - start, stop["by"] != ""))

    def outlines(self, time):
        start, own, stands = [each for each in self.runs if each[0] <= time][-1]
        own = own if stands else own + time - start
        own = math.fmod(own, self.path[-1][0])
        k = next(k for k in range(1, len(self.path)) if own < self.path[k][0])
        (t0, x0, y0, a0), (t1, x1, y1, a1) = self.path[k - 1], self.path[k]
        share = (own - t0) / (t1 - t0)
        turn = math.remainder(a1 - a0, 360)
        return [placed(each, x0 + share * (x1 - x0), y0 + share * (y1 - y0), a0 + share * turn) for each in self.corners]


class Motor:
    """The tow motor: where it is at a time, and whether it moves then."""

    def __init__(self, trace):
        robot = trace[0]["robots"][0]
        self.at = robot["pose"][3], robot["pose"][7]
        self.corners = [outline(shape) for body in robot["bodies"] for shape in body["shapes"]]
        start = robot["start"]
        self.keys = [(0, start["x"], start["y"], start["theta"])]
        for record in trace[1:]:
            if record["type"] == "try" and record["ok"]:
                q = record["q"]
                self.keys.append((record["t"], q["x"], q["y"], q["theta"]))
            elif record["type"] in ("wait", "stop", "pause"):
                self.keys.append((record["t"], *self.keys[-1][1:]))

    def length(self):
        """m that it drove."""
        return sum(math.hypot(b[1] - a[1], b[2] - a[2]) for a, b in zip(self.keys, self.keys[1:]))

    def moments(self):
        """(time, outlines, whether it moves), SAMPLES a second."""
        k = 1
        for i in range(int(self.keys[-1][0] * SAMPLES)):
            time = i / SAMPLES
            while self.keys[k][0] <= time:
                k += 1
            (t0, x0, y0, a0), (t1, x1, y1, a1) = self.keys[k - 1], self.keys[k]
            share = (time - t0) / (t1 - t0)
            turn = math.remainder(a1 - a0, 360)
            x, y = self.at[0] + x0 + share * (x1 - x0), self.at[1] + y0 + share * (y1 - y0)
            yield time, [placed(each, x, y, a0 + share * turn) for each in self.corners], (x0, y0, a0) != (x1, y1, a1)


def encounters(trace):
    """Near misses with people and with others, and the least distance from people while it moved (m)."""
    stops = [record for record in trace[1:] if record["type"] == "moving"]
    things = [Thing(each, [stop for stop in stops if stop["name"] == each["name"]]) for each in trace[0]["movings"]]
    last = {}
    count = {True: 0, False: 0}
    nearest = math.inf
    for time, motor, moves in Motor(trace).moments():
        if not moves:
            continue
        for thing in things:
            others = thing.outlines(time)
            if math.dist(motor[0][0], others[0][0]) > FAR:
                continue
            off = min(distance(a, b) for a in motor for b in others)
            if thing.people:
                nearest = min(nearest, off)
            if off >= NEAR:
                continue
            count[thing.people] += time - last.get(thing.name, -math.inf) > APART
            last[thing.name] = time
    return count[True], count[False], nearest


def rows(rubicon):
    """One a guide: name, task of the schedule, m driven, near misses, nearest person, stops of others, s they are late."""
    for way, guide in enumerate(GUIDES, 1):
        _, schedule, trace = run(rubicon, way)
        (task,) = schedule["tasks"]
        if task["result"] != "done":
            yield guide, task, None
            continue
        stops = sum(each["stops"] for each in schedule.get("timetables", []))
        late = sum(each["late"] for each in schedule.get("timetables", []))
        yield guide, task, (Motor(trace).length(), *encounters(trace), stops, late)


def table(rubicon):
    yield "| guide | time s | of it waiting s | driven m | near misses: people | vehicles, gate | nearest person m | others stopped | for s |"
    yield "|---|---|---|---|---|---|---|---|---|"
    for guide, task, figures in rows(rubicon):
        if figures is None:
            yield f"| `{guide}` | {task['result']} | - | - | - | - | - | - | - |"
            continue
        length, people, others, nearest, stops, late = figures
        yield (f"| `{guide}` | {task['duration']:.0f} | {task['waited']['machine']:.0f} | {length:.1f} | {people} | {others} "
               f"| {nearest:.2f} | {stops} | {late:.0f} |")


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    print("\n".join(table(sys.argv[1])))


if __name__ == "__main__":
    main()
