"""Where every machine of a trace is at any moment, calculated from the trace alone: an independent look at what a run says."""

import bisect
import math
import re

import upright

NAMES = {
    "trans": upright.trans,
    "rotz": upright.rotz,
    "sin": lambda degrees: math.sin(math.radians(degrees)),
    "cos": lambda degrees: math.cos(math.radians(degrees)),
    "__builtins__": {},
}

SUBSTEP = 0.5
"""s: a step is looked at this often. No machine here moves more than 1.5 m in that time."""


def compiled(formula):
    """A formula or frame of the header, with body.name as body_name."""
    return compile(re.sub(r"([A-Za-z_]\w*)\.([A-Za-z_]\w*)", r"\1_\2", formula), formula, "eval")


class Machine:
    """A robot: where its bodies and its load are at a configuration, and its configuration over time."""

    def __init__(self, header, components):
        self.name = header["name"]
        self.mounting = upright.frame_of(header["pose"])
        self.bodies = []
        index = {None: -1}
        for body in header["bodies"]:
            index[body["name"]] = len(self.bodies)
            solids = [upright.Solid(shape) for shape in body["shapes"]]
            self.bodies.append((body["name"], index[body["parent"]], compiled(body["frame"]), solids))
        self.tool = index[header["tool"]["body"]], compiled(header["tool"]["frame"])
        self.cyclic = {p["name"] for p in header["parameters"] if p["cyclic"]}
        self.components = components
        self.ends, self.steps = [], []  # of each step: when it ends; from when, to when, from q, to q
        self.loads = []  # from when, to when, component, pose in the tool
        self.q = header["start"]

    def step(self, begin, end, q):
        if end > begin and q != self.q:
            self.ends.append(end)
            self.steps.append((begin, end, self.q, q))
        self.q = q

    def configuration(self, t):
        i = bisect.bisect_left(self.ends, t)
        if i == len(self.steps):
            return self.q
        begin, end, before, after = self.steps[i]
        if t <= begin:
            return before
        part = (t - begin) / (end - begin)
        return {name: value + part * self.way(name, value, after[name]) for name, value in before.items()}

    def way(self, name, before, after):
        way = after - before
        if name in self.cyclic and abs(way) > 180:
            way -= math.copysign(360, way)
        return way

    def placed(self, t):
        """(name, solid) of all its bodies and its load."""
        values = {name.replace(".", "_"): value for name, value in self.configuration(t).items()}
        frames, result = [], []
        for name, parent, frame, solids in self.bodies:
            frames.append((self.mounting if parent < 0 else frames[parent]) * eval(frame, NAMES, values))
            result += [(f"{self.name}.{name}", solid.at(frames[-1])) for solid in solids]
        for begin, end, component, X_TO in self.loads:
            if begin <= t <= end:
                X_WO = frames[self.tool[0]] * eval(self.tool[1], NAMES, values) * X_TO
                result += [(component, solid.at(X_WO)) for solid in self.components[component]]
        return result

    def moments(self):
        """All moments at which it is looked at: it moves."""
        for begin, end, _, _ in self.steps:
            parts = max(1, math.ceil((end - begin) / SUBSTEP))
            for k in range(parts):
                yield begin + (end - begin) * (k + 0.5) / parts
            yield end


class Replay:
    """All machines of a run (scene_support.Run) whose trace has its steps, and the people's zones over time."""

    def __init__(self, run):
        self.contact = run.header["contact"]
        self.components = {
            component["name"]: [upright.Solid(shape) for shape in component["shapes"]]
            for component in run.header["components"]
        }
        self.machines = {robot["name"]: Machine(robot, self.components) for robot in run.header["robots"]}
        self.zones = {
            task["name"]: (task["robot"], [upright.Solid(zone).at(upright.trans(0, 0, 0)) for zone in task["zones"]])
            for task in run.header["tasks"]
            if task["zones"]
        }
        self.overhead = {
            task["name"]: [upright.Solid(zone).at(upright.trans(0, 0, 0)) for zone in task["zones_overhead"]]
            for task in run.header["tasks"]
            if task["zones"]
        }
        self.times = {}  # of each task with a zone: from when, to when
        last = {}  # of each task: when what it did last was over
        for record in run.records:
            self._take(record, last)

    def _take(self, record, last):
        kind, task = record["type"], record["task"]
        machine = self.machines.get(record["robot"])
        if kind == "try" and record["ok"]:
            machine.step(last[task], record["t"], record["q"])
        elif kind == "attach":
            X_TO = upright.frame_of(record["pose"])
            machine.loads.append((record["t"], math.inf, record["component"], X_TO))
        elif kind == "detach":
            machine.loads[-1] = (machine.loads[-1][0], record["t"], *machine.loads[-1][2:])
        elif kind == "task_start" and task in self.zones:
            self.times[task] = (record["t"], math.inf)
        elif kind == "task_end" and task in self.times:
            self.times[task] = (self.times[task][0], record["t"])
        if "t" in record and kind != "end":
            last[task] = record["t"]

    def overlaps(self, moving, others):
        """Where a machine, whenever it moves, is in one of the others: (time, part, part of the other)."""
        for t in self.machines[moving].moments():
            parts = self.machines[moving].placed(t)
            for other in others:
                theirs = self.machines[other].placed(t)
                for name, part in parts:
                    for met, standing in theirs:
                        if upright.overlap(part, standing, self.contact):
                            yield t, name, met

    def intrusions(self):
        """Where a machine is in a zone that is not its own: (time, part, task of the zone)."""
        for name, machine in self.machines.items():
            for task, (robot, zones) in self.zones.items():
                if robot == name:
                    continue
                begin, end = self.times[task]
                for t in [begin, *(t for t in machine.moments() if begin <= t <= end)]:
                    for part, solid in machine.placed(t):
                        if any(upright.overlap(solid, zone, self.contact) for zone in zones):
                            yield t, part, task

    def loads_over_people(self):
        """Where the load of a machine hangs over a zone that is not its own: (time, load, task of the zone)."""
        for name, machine in self.machines.items():
            for task, (robot, _) in self.zones.items():
                if robot == name:
                    continue
                begin, end = self.times[task]
                for t in [begin, *(t for t in machine.moments() if begin <= t <= end)]:
                    for part, solid in machine.placed(t):
                        is_load = part in self.components
                        if is_load and any(upright.overlap(solid, air, self.contact) for air in self.overhead[task]):
                            yield t, part, task
