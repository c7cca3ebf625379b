"""Results with one fault each, made from good ones by a program with a seed.

A fault is only seeded where it changes what the result says by more than what verify promises to see; each comes with
the tasks, and where it has one the line of the trace, at which it must be found.
"""

import copy
import csv
import datetime
import io
import json
import math
import random
import re


class Result:
    """A result folder in memory: trace records (the first is the header), schedule, table."""

    def __init__(self, folder):
        with open(f"{folder}/trace.jsonl", encoding="utf-8") as file:
            self.records = [json.loads(line) for line in file]
        with open(f"{folder}/schedule.json", encoding="utf-8") as file:
            self.schedule = json.load(file)
        with open(f"{folder}/schedule.csv", encoding="utf-8", newline="") as file:
            self.table = list(csv.reader(file))

    @property
    def header(self):
        return self.records[0]

    def write(self, folder):
        with open(f"{folder}/trace.jsonl", "w", encoding="utf-8") as file:
            file.writelines(json.dumps(record) + "\n" for record in self.records)
        with open(f"{folder}/schedule.json", "w", encoding="utf-8") as file:
            tasks = ",\n".join(json.dumps(task, separators=(",", ":")) for task in self.schedule["tasks"])
            rest = json.dumps({key: value for key, value in self.schedule.items() if key != "tasks"})
            file.write('{"tasks":[\n' + tasks + "\n]," + rest[1:])
        with open(f"{folder}/schedule.csv", "w", encoding="utf-8", newline="") as file:
            out = io.StringIO()
            csv.writer(out, lineterminator="\n").writerows(self.table)
            file.write(out.getvalue())

    # What happened: records of tasks that are done.

    def results(self):
        return {record["task"]: record["result"] for record in self.records if record["type"] == "task_end"}

    def places(self, *types, where=lambda record: True):
        """Indices of records of these types in tasks that are done."""
        short = self.header["form"] == "short"
        result = self.results()
        return [index for index, record in enumerate(self.records) if record["type"] in types and where(record)
                and (short or result[record["task"]] == "done")]

    def task(self, name):
        return next((task for task in self.header["tasks"] if task["name"] == name), None)

    def robot(self, name):
        return next(robot for robot in self.header["robots"] if robot["name"] == name)

    def span(self, name):
        times = {record["type"]: record["t"] for record in self.records[1:]
                 if record["task"] == name and record["type"] in ("task_start", "task_end")}
        return times.get("task_start"), times.get("task_end")

    def before(self, index):
        """The values of the robot before a step, and the clock of its task."""
        record = self.records[index]
        values, clock = None, None
        for other in self.places("try", "end", "task_start", "wait", "stop", "work", "pause", "attach", "detach"):
            if other >= index:
                break
            past = self.records[other]
            if past["robot"] == record["robot"] and "q" in past:
                values = past["q"]
            if past["task"] == record["task"]:
                clock = past["t"]
        if values is None:
            values = self.robot(record["robot"])["start"]
        return values, clock


# Poses as lists of three rows.

IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]


def product(a, b):
    rows = []
    for row in a:
        rows.append([sum(row[k] * b[k][j] for k in range(3)) + (row[3] if j == 3 else 0) for j in range(4)])
    return rows


def rows_of(pose):
    return [pose[0:4], pose[4:8], pose[8:12]]


def translation(x, y, z):
    return [[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z]]


def rotation(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    rows = [[float(a == b) for b in range(3)] + [0.0] for a in range(3)]
    rows[i][i] = rows[j][j] = c
    rows[i][j], rows[j][i] = -s, s
    return rows


def frame(text, q):
    """The pose that a frame of a header has at the values q."""
    names = {"trans": translation, "rotx": lambda v: rotation(0, v), "roty": lambda v: rotation(1, v),
             "rotz": lambda v: rotation(2, v), "sin": lambda v: math.sin(math.radians(v)),
             "cos": lambda v: math.cos(math.radians(v))}
    result = translation(0, 0, 0)
    depth, begin, elements = 0, 0, []
    for place, letter in enumerate(text):
        depth += (letter == "(") - (letter == ")")
        if letter == "*" and depth == 0:
            elements.append(text[begin:place])
            begin = place + 1
    for element in elements + [text[begin:]]:
        code = re.sub(r"(?<![\w.])[A-Za-z_][\w.]*", lambda m: m[0] if m[0] in names else f"q[{m[0]!r}]", element)
        result = product(result, eval(code.strip(), {"__builtins__": {}}, {**names, "q": q}))
    return result


def body_pose(robot, name, q):
    body = next(body for body in robot["bodies"] if body["name"] == name)
    parent = body_pose(robot, body["parent"], q) if body["parent"] else rows_of(robot["pose"])
    return product(parent, frame(body["frame"], q))


def inverse_product(a, b):
    """b as seen from a."""
    turned = [[a[k][i] for k in range(3)] for i in range(3)]
    back = [-sum(turned[i][k] * a[k][3] for k in range(3)) for i in range(3)]
    return product([turned[i] + [back[i]] for i in range(3)], b)


def inner_point(shape):
    """A point well inside of a shape, in the frame of its body; None where it is not easily told."""
    if shape["type"] == "box":
        point = [(a + b) / 2 for a, b in zip(shape["lower"], shape["upper"])]
    elif shape["type"] == "sphere":
        point = shape["centre"]
    elif shape["type"] == "capsule":
        point = shape["a"]
    elif shape["type"] == "cylinder":
        point = [0, 0, (shape["z0"] + shape["z1"]) / 2]
    elif shape["type"] == "mesh":
        point = [0.15, 0.15, 0.5]  # of the angle of meeting.plan
    else:
        return None
    return [row[3] for row in product(rows_of(shape["pose"]), translation(*point))]


class Fault:
    """A result with one fault: where it must be found."""

    def __init__(self, kind, result, tasks, line=None, near=3, words=""):
        self.kind = kind
        self.result = result
        self.tasks = set(tasks)
        self.line = line  # of the trace, from 1
        self.near = near
        self.words = words  # that tell it

    def is_found(self, faults):
        """Whether one of the faults that verify tells is this one."""
        for fault in faults:
            if self.words not in fault["text"]:
                continue
            if self.line is not None and fault["file"].endswith("trace.jsonl"):
                if fault["task"] in self.tasks and abs(fault["line"] - self.line) <= self.near:
                    return True
            elif self.line is None and (fault["task"] in self.tasks or not self.tasks):
                return True
        return False


def steps(result, where=lambda record: True):
    return result.places("try", where=lambda record: record["ok"] and where(record))


def next_of_task(result, index):
    """Line of the first record with a time after `index` in the same task."""
    name = result.records[index]["task"]
    for other in range(index + 1, len(result.records)):
        record = result.records[other]
        if record["task"] == name and "t" in record:
            return other + 1
    return index + 1


# One function a kind: (good result, random numbers) -> Fault, or None where the result has no place for it.

def shift_a_step(good, rng):
    places = steps(good)
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    result.records[index]["t"] = round(result.records[index]["t"] + rng.choice((-1, 1)) * rng.uniform(0.001, 2), 9)
    return Fault("shift a step", result, [good.records[index]["task"]], index + 1)


def shift_the_rest_of_a_task(good, rng):
    places = steps(good)
    if not places:
        return None
    index = rng.choice(places)
    name, dt = good.records[index]["task"], rng.uniform(0.01, 30)
    result = copy.deepcopy(good)
    for record in result.records[index:]:
        if record["task"] == name:
            for key in ("t", "from"):
                if key in record:
                    record[key] = round(record[key] + dt, 9)
    return Fault("shift the rest of a task", result, [name], index + 1)


def drop_a_wait(good, rng):
    """A wait, pause or work is left out: a gap."""
    places = good.places("wait", "pause", "work", where=lambda record: record.get("t", 0) > record.get("from", -1))
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    del result.records[index]
    return Fault("drop a wait", result, [good.records[index]["task"]], next_of_task(good, index) - 1)


def close_a_wait_up(good, rng):
    """A pause for another machine is left out and what comes after it comes sooner: the two meet, or clock and
    links break."""
    places = good.places("pause", where=lambda record: record["why"] in ("machine", "shift"))
    if not places:
        return None
    index = rng.choice(places)
    pause = good.records[index]
    dt, name = pause["t"] - pause["from"], pause["task"]
    result = copy.deepcopy(good)
    del result.records[index]
    for record in result.records[index:]:
        if record["task"] == name:
            for key in ("t", "from"):
                if key in record:
                    record[key] = round(record[key] - dt, 9)
    return Fault("close a wait up", result, [name, *others(good, name)], None)


def others(good, name):
    return [task["name"] for task in good.header["tasks"] if task["name"] != name]


def swap_times(good, rng):
    """Two tasks of which one follows the other change places on the clock, in the schedules too."""
    spans = {name: good.span(name) for name, result in good.results().items() if result == "done"}
    pairs = [(task["name"], link["task"]) for task in good.header["tasks"] for link in task["after"]
             if link["type"] == "FS" and link["lag"] >= 0 and task["name"] in spans and link["task"] in spans]
    pairs = [(a, b) for a, b in pairs if spans[a][0] - spans[b][0] > 0.01 and spans[b][1] - spans[b][0] > 0.01]
    if not pairs:
        return None
    later, sooner = rng.choice(pairs)
    shift = {later: spans[sooner][0] - spans[later][0], sooner: spans[later][0] - spans[sooner][0]}
    result = copy.deepcopy(good)
    for record in result.records[1:]:
        for key in ("t", "from"):
            if key in record and record["task"] in shift:
                record[key] = round(record[key] + shift[record["task"]], 9)
    for row in result.schedule["tasks"]:
        row["start"] = round(row["start"] + shift.get(row["task"], 0), 9)
    for row in result.table[1:]:
        row[3] = repr(round(float(row[3]) + shift.get(row[0], 0), 9))
    return Fault("swap times", result, [later, sooner], words="too early after")


def start_too_early(good, rng):
    """A whole task begins before the robot's task before it is over."""
    tasks = [(good.span(name)[0], good.task(name)["robot"], name) for name, result in good.results().items()
             if result == "done" and good.task(name) and good.task(name)["robot"]]
    tasks.sort()
    pairs = [(a, b) for a, b in zip(tasks, tasks[1:]) if a[1] == b[1] and good.span(a[2])[1] - a[0] > 2]
    if not pairs:
        return None
    first, second = rng.choice(pairs)
    end = good.span(first[2])[1]
    dt = good.span(second[2])[0] - rng.uniform(first[0] + 0.5, end - 0.5)
    result = copy.deepcopy(good)
    for record in result.records[1:]:
        if record["task"] == second[2]:
            for key in ("t", "from"):
                if key in record:
                    record[key] = round(record[key] - dt, 9)
    return Fault("start too early", result, [first[2], second[2]], words="is still in")


def move_a_component(good, rng):
    places = good.places("attach")
    first = {}
    for index in places:
        first.setdefault(good.records[index]["component"], index)
    if not first:
        return None
    name, index = rng.choice(sorted(first.items()))
    result = copy.deepcopy(good)
    component = next(each for each in result.header["components"] if each["name"] == name)
    component["pose"][rng.choice((3, 7, 11))] += rng.choice((-1, 1)) * rng.uniform(1e-4, 0.5)
    return Fault("move a component", result, [good.records[index]["task"]], index + 1, words="from where it stood")


def change_a_value(good, rng):
    places = steps(good)
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    values = result.records[index]["q"]
    # A value that `together` names may be another: the step is then another one that is allowed.
    together = result.records[index]["parameter"]
    together = together if isinstance(together, list) else []
    names = sorted(set(values) - set(together))
    if not names:
        return None
    name = rng.choice(names)
    values[name] += rng.choice((-1, 1)) * rng.uniform(1e-4, 0.4)
    return Fault("change a value", result, [good.records[index]["task"]], index + 1)


def drop_a_step(good, rng):
    places = steps(good)
    if not places:
        return None
    index = rng.choice(places)
    line = next_of_task(good, index) - 1
    result = copy.deepcopy(good)
    del result.records[index]
    return Fault("drop a step", result, [good.records[index]["task"]], line)


def drop_a_step_neatly(good, rng):
    """The attempts after it are renumbered, the counts and schedules put right: only the motion tells."""
    places = steps(good)
    if not places:
        return None
    index = rng.choice(places)
    name = good.records[index]["task"]
    result = copy.deepcopy(good)
    del result.records[index]
    counted = False
    for record in result.records[index:]:
        if record["task"] != name:
            continue
        if "n" in record and record["type"] in ("try", "wait"):
            record["n"] -= 1
        if record["type"] == "end" and not counted:
            record["tries"] -= 1
            record["accepted"] -= 1
            counted = True
    for row in result.schedule["tasks"]:
        if row["task"] == name:
            row["tried"] -= 1
            row["accepted"] -= 1
    for row in result.table[1:]:
        if row[0] == name:
            row[5], row[6] = str(int(row[5]) - 1), str(int(row[6]) - 1)
    return Fault("drop a step neatly", result, [name], next_of_task(good, index) - 1)


def repeat_a_step(good, rng):
    places = steps(good)
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    result.records.insert(index, copy.deepcopy(result.records[index]))
    return Fault("repeat a step", result, [good.records[index]["task"]], index + 2)


def move_the_grip(good, rng):
    places = good.places("attach")
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    result.records[index]["pose"][rng.choice((3, 7, 11))] += rng.choice((-1, 1)) * rng.uniform(1e-4, 0.3)
    return Fault("move the grip", result, [good.records[index]["task"]], index + 1, words="from where it stood")


def move_where_it_is_gripped(good, rng):
    places = good.places("attach")
    if not places:
        return None
    index = rng.choice(places)
    task = good.task(good.records[index]["task"])
    if task.get("within"):
        return None
    result = copy.deepcopy(good)
    component = next(each for each in result.header["components"] if each["name"] == good.records[index]["component"])
    component["grip"][rng.choice((3, 7, 11))] += rng.choice((-1, 1)) * rng.uniform(2e-3, 1)
    return Fault("move where it is gripped", result, [task["name"]], index + 1, words="it takes its load")


def move_what_is_put_down(good, rng):
    places = good.places("detach")
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    result.records[index]["pose"][rng.choice((3, 7, 11))] += rng.choice((-1, 1)) * rng.uniform(1e-4, 0.3)
    return Fault("move what is put down", result, [good.records[index]["task"]], index + 1, words="is put")


def turn_what_is_put_down(good, rng):
    places = good.places("detach")
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    turned = product(rows_of(result.records[index]["pose"]), rotation(2, rng.choice((-1, 1)) * rng.uniform(0.01, 90)))
    result.records[index]["pose"] = [number for row in turned for number in row]
    return Fault("turn what is put down", result, [good.records[index]["task"]], index + 1, words="is put")


def move_the_goal(good, rng):
    tasks = [task["name"] for task in good.header["tasks"] if "to" in task and good.results()[task["name"]] == "done"]
    if not tasks:
        return None
    name = rng.choice(tasks)
    result = copy.deepcopy(good)
    result.task(name)["to"][rng.choice((3, 7, 11))] += rng.choice((-1, 1)) * rng.uniform(2e-3, 1)
    index = next(i for i in good.places("detach") if good.records[i]["task"] == name)
    return Fault("move the goal", result, [name], index + 1, words="from its goal")


def drop_a_load_change(good, rng):
    places = good.places("attach", "detach", "remove")
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    del result.records[index]
    name = good.records[index]["task"]
    return Fault("drop a load change", result, [name, *others(good, name)], None)


def overload(good, rng):
    """A component is too heavy for the chart of the robot."""
    places = [i for i in good.places("attach") if good.robot(good.records[i]["robot"])["capacity"]]
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    record = good.records[index]
    most = max(mass for _, mass in good.robot(record["robot"])["capacity"])
    next(each for each in result.header["components"] if each["name"] == record["component"])["mass"] = most + 1
    return Fault("overload", result, [record["task"]], index + 1, words="too heavy")


def forget_a_mass(good, rng):
    """A component that a robot with a load chart lifts has no mass."""
    places = [i for i in good.places("attach") if good.robot(good.records[i]["robot"])["capacity"]]
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    record = good.records[index]
    next(each for each in result.header["components"] if each["name"] == record["component"])["mass"] = 0
    return Fault("forget a mass", result, [record["task"]], index + 1, words="no mass")


def hide_an_overlap(good, rng):
    """Something stands in a component from the beginning, and the header does not tell."""
    if "beginning" not in good.header or not good.header["components"]:
        return None
    component = rng.choice(good.header["components"])
    point = inner_point(component["shapes"][0])
    if point is None:
        return None
    pose = [number for row in product(rows_of(component["pose"]), translation(*point)) for number in row]
    result = copy.deepcopy(good)
    result.header["site"].append({"type": "box", "lower": [-0.02] * 3, "upper": [0.02] * 3, "pose": pose})
    return Fault("hide an overlap", result, [""], 1, words=f"at the beginning {component['name']} is at least")


def sink_the_site(good, rng):
    """The top of the ground is lower than the plan's gap allows: what stands on it is in the air."""
    site = good.header["site"]
    if good.header.get("support", {}).get("mode") != "on" or not site or site[0]["type"] != "box":
        return None
    result = copy.deepcopy(good)
    result.header["site"][0]["upper"][2] -= good.header["support"]["gap"] + rng.choice((0.001, 0.02, 0.1))
    return Fault("sink the site", result, [""], words="does not stand: nothing within")


def shift_what_carries(good, rng):
    """What is put down has its mass beside what carries it: a heavy shape far out in the air, above all else."""
    places = good.places("detach")
    if good.header.get("support", {}).get("mode") != "on" or not places:
        return None
    name = good.records[rng.choice(places)]["component"]
    result = copy.deepcopy(good)
    component = next(each for each in result.header["components"] if each["name"] == name)
    component["shapes"].append({"type": "box", "lower": [40, 40, 60], "upper": [50, 50, 70], "pose": IDENTITY})
    by_forces = "friction" in good.header["support"]
    return Fault("shift what carries", result, [""],
                 words=f"{name} and what it rests on do not stand" if by_forces else f"{name} does not stand: its centre of mass")


def outweigh(good, rng):
    """What was put down is much heavier than what it stands on can balance."""
    places = good.places("detach")
    if "friction" not in good.header.get("support", {}) or not places:
        return None
    name = good.records[rng.choice(places)]["component"]
    result = copy.deepcopy(good)
    next(each for each in result.header["components"] if each["name"] == name)["mass"] *= rng.choice((50, 200))
    return Fault("outweigh", result, [""], words="their weights cannot be balanced")


def fix_it_later(good, rng):
    """It holds only after a task that ends when its brace has gone."""
    held = [(i, k) for i, each in enumerate(good.header["components"]) for k, task in enumerate(each.get("fixed_after", [])) if task]
    last = max((record for record in good.records if record["type"] == "task_end"), key=lambda record: record["t"], default=None)
    if not held or not any(record["type"] == "remove" for record in good.records):
        return None
    component, k = rng.choice(held)
    result = copy.deepcopy(good)
    result.header["components"][component]["fixed_after"][k] = last["task"]
    return Fault("fix it later", result, [""], 
                 words=good.header["components"][component]["name"]
                 + (" and what it rests on do not stand" if "friction" in good.header["support"] else " does not stand"))


def lengthen_work(good, rng):
    places = good.places("work")
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    record = result.records[index]
    if rng.random() < 0.5:
        record["time"] = round(max(record["time"] + rng.choice((-1, 1)) * rng.uniform(0.01, 600), 0), 9)
    else:
        record["t"] = round(record["t"] + rng.uniform(0.01, 600), 9)
    return Fault("lengthen work", result, [record["task"]], index + 1, near=12)


def take_a_day_off(good, rng):
    """The day of a work becomes a day off for its crew."""
    header = good.header
    if not header.get("start_at"):
        return None
    calendar_of = {crew["name"]: crew["calendar"] for crew in header["crews"]}
    places = good.places("work", where=lambda record: calendar_of.get(record["crew"]))
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    record = good.records[index]
    wanted = calendar_of[record["crew"]]
    calendar = next(each for each in result.header["calendars"] if each["name"] == wanted)
    date, clock = header["start_at"].split(" ")
    seconds = int(clock[:2]) * 3600 + int(clock[3:]) * 60 + record["from"]
    day = datetime.date.fromisoformat(date) + datetime.timedelta(days=int(seconds // 86400))
    calendar["off"].append(day.isoformat())
    return Fault("take a day off", result, [record["task"]], index + 1, words="of shifts for it")


def hang_a_load(good, rng):
    """What hangs on the hook of a lift that is held whole stays there for a day more, as if waiting for a shift."""
    whole = {task["name"] for task in good.header["tasks"] if task.get("whole")}
    places = good.places("attach", where=lambda record: record["task"] in whole)
    if not places:
        return None
    index = rng.choice(places)
    taken = good.records[index]
    dt = 3600 * rng.choice((18, 24, 72))
    result = copy.deepcopy(good)
    for record in result.records[index + 1:]:
        if record["task"] == taken["task"]:
            for key in ("t", "from"):
                if key in record:
                    record[key] = round(record[key] + dt, 9)
    result.records.insert(index + 1, {"type": "pause", "task": taken["task"], "robot": taken["robot"], "why": "shift",
                                      "for": "", "from": taken["t"], "t": round(taken["t"] + dt, 9)})
    return Fault("hang a load", result, [taken["task"]], words="hangs on its hook")


def invent_overtime(good, rng):
    """A lift that ends in its shift says that it ended in overtime."""
    whole = {task["name"] for task in good.header["tasks"] if task.get("whole")}
    places = good.places("detach", where=lambda record: record["task"] in whole)
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    result.records[index]["overtime"] = result.records[index].get("overtime", 0) + rng.uniform(1, 600)
    return Fault("invent overtime", result, [good.records[index]["task"]], index + 1, words="the overtime of the lift")


def shorten_a_shift(good, rng):
    """All shifts of a robot's calendar end before its first motion begins."""
    calendars = {robot["name"]: robot["calendar"] for robot in good.header["robots"] if robot.get("calendar")}
    places = steps(good, where=lambda record: record["robot"] in calendars)
    if not places:
        return None
    record = good.records[places[0]]
    result = copy.deepcopy(good)
    calendar = next(each for each in result.header["calendars"] if each["name"] == calendars[record["robot"]])
    for shift in calendar["shifts"]:
        shift["minutes"] = [[0, 1]]
    return Fault("shorten a shift", result, [record["task"]], words="out of shift")


def book_a_crew_twice(good, rng):
    """Two works at the same time are given to one crew."""
    places = good.places("work", where=lambda record: record["crew"])
    pairs = []
    for a in places:
        for b in places:
            one, other = good.records[a], good.records[b]
            overlap = min(one["t"], other["t"]) - max(one["from"], other["from"])
            if a != b and one["task"] != other["task"] and one["crew"] != other["crew"] and overlap > 0.01:
                pairs.append((a, b))
    if not pairs:
        return None
    a, b = rng.choice(pairs)
    result = copy.deepcopy(good)
    record = result.records[a]
    record["crew"] = good.records[b]["crew"]
    task = result.task(record["task"])
    planned = task["takes"] if record["what"] == "takes" else [task[record["what"]]]
    for work in planned:
        work["crew"] = record["crew"]
    return Fault("book a crew twice", result, [record["task"], good.records[b]["task"]], words="is still in")


def give_work_to_another(good, rng):
    crews = [crew["name"] for crew in good.header["crews"]]
    places = good.places("work", where=lambda record: record["crew"])
    if not places or len(crews) < 2:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    record = result.records[index]
    record["crew"] = rng.choice([crew for crew in crews if crew != record["crew"]])
    return Fault("give work to another", result, [record["task"]], index + 1, words="by the crew of the plan")


def break_a_link(good, rng):
    """The lag of a link becomes longer than what lies between the two tasks."""
    done = {name for name, result in good.results().items() if result == "done"}
    links = [(task["name"], i) for task in good.header["tasks"] for i, link in enumerate(task["after"])
             if task["name"] in done and link["task"] in done]
    if not links:
        return None
    name, i = rng.choice(links)
    result = copy.deepcopy(good)
    link = result.task(name)["after"][i]
    moment = good.span(name)[1 if link["type"] in ("FF", "SF") else 0]
    before = good.span(link["task"])[0 if link["type"] in ("SS", "SF") else 1]
    link["lag"] = round(moment - before + rng.uniform(0.001, 7200), 9)
    return Fault("break a link", result, [name], words="too early after")


def link_to_what_is_not_done(good, rng):
    results = good.results()
    undone = [name for name, result in results.items() if result != "done" and good.task(name)]
    done = [name for name, result in results.items() if result == "done" and good.task(name)]
    if not undone or not done:
        return None
    name = rng.choice(done)
    result = copy.deepcopy(good)
    result.task(name)["after"].append({"task": rng.choice(undone), "type": rng.choice(("FS", "SS")), "lag": 0})
    return Fault("link to what is not done", result, [name], words="it was done without")


def call_it_not_reached(good, rng):
    """A task is told as not reached, though all it follows is done."""
    results = good.results()
    names = [task["name"] for task in good.header["tasks"] if results[task["name"]] == "done"
             and all(results[link["task"]] == "done" for link in task["after"])]
    if not names:
        return None
    name = rng.choice(names)
    result = copy.deepcopy(good)
    last = next(i for i, record in enumerate(result.records) if record.get("task") == name
                and record["type"] == "task_end")
    result.records[last]["result"], result.records[last]["reason"] = "not reached", "no reason"
    result.records = [record for i, record in enumerate(result.records) if record.get("task") != name or i == last]
    return Fault("call it not reached", result, [name], words="all it follows is done")


def silence_a_refusal(good, rng):
    places = [i for i, record in enumerate(good.records) if record["type"] == "task_end" and record["result"] != "done"]
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    result.records[index]["reason"] = ""
    return Fault("silence a refusal", result, [good.records[index]["task"]], index + 1, words="no reason")


def call_it_done(good, rng):
    """A task that was refused or not reached is told as done."""
    places = [i for i, record in enumerate(good.records) if record["type"] == "task_end" and record["result"] != "done"
              and good.header["form"] == "full"]
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    result.records[index]["result"], result.records[index]["reason"] = "done", ""
    return Fault("call it done", result, [good.records[index]["task"]])


def is_surely_at_its_goal(good):
    """Not at the very edge of what `within` allows: there verify lets both pass."""
    within = good.header.get("within", {})
    end = [record for record in good.records if record["type"] == "end"][-1]
    return "length" not in within and all(
        abs(off) <= 0.98 * within.get(name, 0) + 1e-9 for name, off in end["residual"].items())


def hide_that_it_ended_short(good, rng):
    """The motion of a short plan is told as done where it ended short, or as short where it is at its goal; everywhere."""
    if good.header["form"] != "short":
        return None
    place = next(i for i, record in enumerate(good.records) if record["type"] == "task_end")
    told = {"done": "short", "short": "done"}.get(good.records[place]["result"])
    if told is None or (told == "short" and not is_surely_at_its_goal(good)):
        return None
    result = copy.deepcopy(good)
    reason = result.records[place]["reason"] if rng.random() < 0.5 else "short of the goal"
    for row in (result.records[place], result.schedule["tasks"][0]):
        row["result"], row["reason"] = told, reason
    result.table[1][7], result.table[1][8] = told, reason
    words = "ended short" if told == "done" else "stands at its goal"
    return Fault("hide that it ended short", result, [good.records[place]["task"]], place + 1, words=words)


def drop_a_task(good, rng):
    names = [name for name in good.results() if good.task(name)]
    if not names:
        return None
    name = rng.choice(names)
    result = copy.deepcopy(good)
    result.records = [record for record in result.records if record.get("task") != name]
    return Fault("drop a task", result, [name, *others(good, name)])


def cut_the_trace(good, rng):
    if len(good.records) < 5:
        return None
    result = copy.deepcopy(good)
    keep = rng.randrange(2, len(good.records) - 1)
    result.records = result.records[:keep]
    lost = {record["task"] for record in good.records[keep:]}
    return Fault("cut the trace", result, lost)


def site_name(result):
    """How the last shape of the site is called."""
    count = len(result.header["site"])
    return "site" if count == 1 else f"site {count}"


def wall_in_the_way(good, rng):
    """A thin plate across the way of the tool, in the middle of a step that jumps over it."""
    def jump(index):
        """Where a point inside the tool's body is before, in the middle of and after a step."""
        before, _ = good.before(index)
        robot = good.robot(good.records[index]["robot"])
        after = dict(good.records[index]["q"])
        for name in after:  # the short way round
            if abs(after[name] - before[name]) > 180:
                after[name] += 360 if after[name] < before[name] else -360
        middle = {name: (before[name] + after[name]) / 2 for name in after}
        body = next(each for each in robot["bodies"] if each["name"] == robot["tool"]["body"])
        point = inner_point(body["shapes"][0])
        if point is None:
            return None
        poses = [product(body_pose(robot, body["name"], q), translation(*point)) for q in (before, middle, after)]
        return [[row[3] for row in pose] for pose in poses]

    places = steps(good)
    rng.shuffle(places)
    for index in places[:40]:
        start, middle, end = jump(index) or ([0], [0], [0])
        length = math.dist(start, end)
        if length < 0.4:
            continue
        n = [(b - a) / length for a, b in zip(start, end)]
        i = min(range(3), key=lambda k: abs(n[k]))
        u = [(k == i) - n[i] * n[k] for k in range(3)]
        size = math.sqrt(sum(x * x for x in u))
        u = [x / size for x in u]
        v = [n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0]]
        pose = [number for k in range(3) for number in (u[k], v[k], n[k], middle[k])]
        thick = rng.choice((0.02, 0.002, 0.0006))
        result = copy.deepcopy(good)
        result.header["site"].append({"type": "box", "lower": [-0.05, -0.05, -thick / 2],
                                      "upper": [0.05, 0.05, thick / 2], "pose": pose})
        # Another step may meet it first.
        return Fault("wall in the way", result, good.results(), words=f"meets {site_name(result)} (")
    return None


def thing_where_a_load_is_put(good, rng):
    """Something lies where a component is put down: box, ball or cylinder, 20 mm deep or more."""
    places = good.places("detach")
    if not places:
        return None
    index = rng.choice(places)
    record = good.records[index]
    component = next(each for each in good.header["components"] if each["name"] == record["component"])
    point = inner_point(component["shapes"][0])
    if point is None:
        return None
    centre = product(rows_of(record["pose"]), translation(*point))
    pose = [number for row in centre for number in row]
    things = [{"type": "box", "lower": [-0.02] * 3, "upper": [0.02] * 3},
              {"type": "sphere", "centre": [0, 0, 0], "radius": 0.03},
              {"type": "cylinder", "z0": -0.05, "z1": 0.05, "radius": 0.02},
              {"type": "capsule", "a": [-0.1, 0, 0], "b": [0.1, 0, 0], "radius": 0.02}]
    result = copy.deepcopy(good)
    result.header["site"].append({**rng.choice(things), "pose": pose})
    return Fault("thing where a load is put", result, good.results(), words=f"meets {site_name(result)} (")


def grow_a_body(good, rng):
    """The tool's body reaches, at the end of a step, into the robot's first body, which it must not touch."""
    places = steps(good)
    rng.shuffle(places)
    for index in places[:20]:
        record = good.records[index]
        robot = good.robot(record["robot"])
        first, tool = robot["bodies"][0], robot["tool"]["body"]
        body = next(each for each in robot["bodies"] if each["name"] == tool)
        if body is first or body["parent"] == first["name"] or not (first["shapes"] and body["shapes"]):
            continue
        before, _ = good.before(index)
        relative = [inverse_product(body_pose(robot, tool, q), body_pose(robot, first["name"], q))
                    for q in (before, record["q"])]
        if math.dist(sum(relative[0], []), sum(relative[1], [])) < 0.01:
            continue  # the step does not move one against the other
        ends = inner_point(body["shapes"][0]), inner_point(first["shapes"][0])
        if None in ends:
            continue
        target = [row[3] for row in product(relative[1], translation(*ends[1]))]
        result = copy.deepcopy(good)
        grown = result.robot(record["robot"])
        next(each for each in grown["bodies"] if each["name"] == tool)["shapes"].append(
            {"type": "capsule", "a": ends[0], "b": target, "radius": 0.01, "pose": IDENTITY})
        # An earlier step may do it too.
        return Fault("grow a body", result, good.results(), words=f"{robot['name']}.{first['name']}")
    return None


def widen_a_buffer(good, rng):
    """A body that moves keeps so large a buffer that everything on the site is in it."""
    if not good.header["site"] and not good.header["components"]:
        return None
    places = steps(good)
    rng.shuffle(places)
    for index in places[:20]:
        record = good.records[index]
        robot = good.robot(record["robot"])
        body = rng.choice([each for each in robot["bodies"] if each["shapes"]])
        before, _ = good.before(index)
        relative = [body_pose(robot, body["name"], q) for q in (before, record["q"])]
        if math.dist(sum(relative[0], []), sum(relative[1], [])) < 0.01:
            continue  # the step does not move it
        result = copy.deepcopy(good)
        kept = result.robot(record["robot"])
        next(each for each in kept["bodies"] if each["name"] == body["name"])["buffer"] = 1000
        return Fault("widen a buffer", result, good.results(), words=f"the buffer of {robot['name']}.{body['name']} meets ")
    return None


def zone_round_a_robot(good, rng):
    """The zone of a task is where another robot stands or goes."""
    zoned = [task["name"] for task in good.header["tasks"] if task["zones"] and good.results()[task["name"]] == "done"]
    if not zoned:
        return None
    name = rng.choice(zoned)
    robots = [robot for robot in good.header["robots"] if robot["name"] != good.task(name)["robot"]]
    robot = rng.choice(robots)
    pose = robot["pose"]
    result = copy.deepcopy(good)
    zone = result.task(name)["zones"][0]
    # High enough for any of its bodies.
    zone.update({"type": "box", "lower": [-40, -40, -5], "upper": [40, 40, 40], "pose": pose})
    return Fault("zone round a robot", result, [*good.results(), ""], words=f"meets the zone of {name} (")


def people_under_a_load(good, rng):
    """A load of another robot hangs over the people of a task."""
    result = copy.deepcopy(good)
    for place in rng.sample(good.places("attach"), len(good.places("attach"))):
        lift = good.records[place]
        over = [task["name"] for task in good.header["tasks"] if task["zones"] and good.results()[task["name"]] == "done"
                and task["robot"] != lift["robot"] and good.span(task["name"])[0] < lift["t"] < good.span(task["name"])[1]]
        if not over or good.results().get(lift["task"]) != "done":
            continue
        name = rng.choice(over)
        zone = result.task(name)["zones_overhead"][0]
        zone.update({"type": "box", "lower": [-400, -400, -5], "upper": [400, 400, 400], "pose": IDENTITY})
        return Fault("people under a load", result, [*good.results(), ""],
                     words=f"meets the air above the zone of {name} (")
    return None


def edit_the_schedule(good, rng):
    rows = good.schedule["tasks"]
    row = rng.randrange(len(rows))
    result = copy.deepcopy(good)
    name = rows[row]["task"]
    field = rng.choice(("start", "duration", "tried", "accepted", "result", "process_time", "drop", "crew", "reason"))
    edited = result.schedule["tasks"][row]
    if field in ("start", "duration"):
        edited[field] = round(edited[field] + rng.uniform(0.001, 1000), 9)
    elif field in ("tried", "accepted"):
        edited[field] += rng.randrange(1, 9)
    elif field == "result":
        edited[field] = "rejected" if edited[field] == "done" else "done"
    elif field == "process_time":
        result.schedule[field] = round(result.schedule[field] + rng.uniform(0.001, 1000), 9)
        name = ""
    elif field == "drop":
        del result.schedule["tasks"][row]
    elif field == "crew":
        if "parking" in edited:
            return None
        edited[field] += "x"
    else:
        edited[field] += "!"
    return Fault("edit the schedule", result, [name])


def edit_the_table(good, rng):
    row = rng.randrange(1, len(good.table))
    result = copy.deepcopy(good)
    column = rng.choice((3, 4, 5, 6, 7))
    value = result.table[row][column]
    if column == 7:
        result.table[row][column] = "rejected" if value == "done" else "done"
    elif column < 5:
        result.table[row][column] = repr(round(float(value) + rng.uniform(0.001, 1000), 9))
    else:
        result.table[row][column] = str(int(value) + 1)
    return Fault("edit the table", result, [good.table[row][0]])


PARTS = ("motion", "work", "predecessor", "resource", "machine", "shift")


def split_of(row):
    """The parts of the time of a row of schedule.json: where each stands."""
    return {part: (row if part in row else row["waited"], part) for part in PARTS}


def lengthen_a_part(good, rng):
    """A part of the time of a task is more or less than it was: the parts do not add up."""
    row = rng.randrange(len(good.schedule["tasks"]))
    result = copy.deepcopy(good)
    edited = result.schedule["tasks"][row]
    place, name = split_of(edited)[rng.choice(PARTS)]
    less = place[name] > 0.1 and rng.random() < 0.5
    place[name] = round(place[name] + (-1 if less else 1) * rng.uniform(0.001, 0.1), 9)
    return Fault("lengthen a part", result, [edited["task"]])


def give_a_part_to_another(good, rng):
    """Motion or work is told as something else: the parts add up and yet are not those of the trace."""
    rows = [index for index, row in enumerate(good.schedule["tasks"])
            if row["result"] == "done" and row["motion"] + row["work"] > 1]
    if not rows:
        return None
    result = copy.deepcopy(good)
    edited = result.schedule["tasks"][rng.choice(rows)]
    parts = split_of(edited)
    source = rng.choice([part for part in ("motion", "work") if edited[part] > 0.5])
    # A wait of a script may be motion or waiting: the trace does not tell.
    if source == "motion" and any(r["type"] == "wait" and r["task"] == edited["task"] for r in good.records[1:]):
        return None
    target = rng.choice([part for part in PARTS if part != source])
    share = rng.uniform(0.01, 0.4)
    for part, sign in ((source, -1), (target, 1)):
        place, name = parts[part]
        place[name] = round(place[name] + sign * share, 9)
    return Fault("give a part to another", result, [edited["task"]])


def hide_a_wait(good, rng):
    """A wait on the way, as the trace tells it, is told as one of another kind."""
    waits = {"held": "predecessor", "crew": "resource", "machine": "machine", "shift": "shift",
             "lift": "shift"}
    places = good.places("pause", where=lambda record: record["t"] - record["from"] > 0.01)
    if not places:
        return None
    pause = good.records[rng.choice(places)]
    result = copy.deepcopy(good)
    edited = next(row for row in result.schedule["tasks"] if row["task"] == pause["task"])
    if "parking" in edited:
        return None
    waited, source = edited["waited"], waits[pause["why"]]
    target = rng.choice([name for name in waited if name != source])
    waited[target] = round(waited[target] + waited[source], 9)
    waited[source] = 0
    return Fault("hide a wait", result, [pause["task"]])


def wait_for_nothing(good, rng):
    """A whole task comes later, and its row tells that it waited: nothing came just then."""
    rows = [row["task"] for row in good.schedule["tasks"] if row["result"] == "done" and good.task(row["task"])]
    if not rows:
        return None
    name, dt = rng.choice(rows), rng.uniform(0.01, 100)
    result = copy.deepcopy(good)
    for record in result.records[1:]:
        if record["task"] == name:
            for key in ("t", "from"):
                if key in record:
                    record[key] = round(record[key] + dt, 9)
    row = next(row for row in result.schedule["tasks"] if row["task"] == name)
    wait = rng.choice(("resource", "machine", "predecessor"))
    # A robot's task that is held to its finish may have been ready late.
    lags = [link["lag"] for link in good.task(name)["after"]]
    ends = [link["type"] for link in good.task(name)["after"]]
    if wait == "predecessor" and (any(lag < 0 for lag in lags) or "FF" in ends or "SF" in ends):
        return None
    if wait == "machine" and good.task(name)["zones"]:
        return None
    row["start"] = round(row["start"] + dt, 9)
    row["waited"][wait] = round(row["waited"][wait] + dt, 9)
    return Fault("wait for nothing", result, [name])


def pause_for_nothing(good, rng):
    """A pause for a crew or at a link is told as longer, and what comes after it comes later."""
    places = good.places("pause", where=lambda record: record["why"] in ("crew", "shift", "held", "lift"))
    if not places:
        return None
    index = rng.choice(places)
    name, dt = good.records[index]["task"], rng.uniform(0.01, 100)
    if good.records[index]["why"] == "held" and any(link["lag"] < 0 for link in good.task(name)["after"]):
        return None
    result = copy.deepcopy(good)
    for number, record in enumerate(result.records[index:], index):
        if record["task"] == name:
            for key in ("t", "from"):
                if key in record and not (number == index and key == "from"):
                    record[key] = round(record[key] + dt, 9)
    return Fault("pause for nothing", result, [name], index + 1)


def edit_a_part_of_the_table(good, rng):
    row = rng.randrange(1, len(good.table))
    result = copy.deepcopy(good)
    column = good.table[0].index(rng.choice(("motion", "work", "waited_predecessor", "waited_resource",
                                             "waited_machine", "waited_shift")))
    result.table[row][column] = repr(round(float(good.table[row][column]) + rng.uniform(0.001, 100), 9))
    return Fault("edit a part of the table", result, [good.table[row][0]])


def change_a_cost(good, rng):
    """The money of a task, in one of the schedules."""
    if "cost" not in good.schedule:
        return None
    result = copy.deepcopy(good)
    more = rng.choice((-1, 1)) * rng.uniform(0.03, 50)
    if rng.random() < 0.5:
        edited = rng.choice(result.schedule["tasks"])
        edited["cost"] += more
        return Fault("change a cost", result, [edited["task"]], words="the cost is")
    row = rng.choice(result.table[1:])
    column = result.table[0].index("cost")
    row[column] = f"{float(row[column]) + more:.2f}"
    return Fault("change a cost", result, [row[0]], words="the cost is")


def change_a_rate(good, rng):
    """Another rate in the trace: all money that comes of it is wrong."""
    rated = [(kind, index) for kind in ("robots", "crews") for index, each in enumerate(good.header[kind])
             if each["cost_per_hour"] and next(use for use in good.schedule["resources"]
                                               if use["name"] == each["name"])["cost"] > 0.1]
    if not rated:
        return None
    kind, index = rng.choice(rated)
    result = copy.deepcopy(good)
    name = good.header[kind][index]["name"]
    least = 0.03 / next(use for use in good.schedule["resources"] if use["name"] == name)["cost"]
    result.header[kind][index]["cost_per_hour"] *= 1 + rng.choice((-1, 1)) * rng.uniform(max(0.001, least), 0.5)
    return Fault("change a rate", result, [""], words=f"{result.header[kind][index]['name']}: the cost is")


def edit_a_use(good, rng):
    """What is told of a robot or crew, or of all."""
    if not good.schedule["resources"]:
        return None
    result = copy.deepcopy(good)
    use = rng.choice(result.schedule["resources"])
    field = rng.choice(("held", "busy", "shifts", "tasks", "utilisation", "cost", "whole", "drop"))
    words = f"{use['name']}: "
    if field in ("held", "busy", "shifts"):
        use[field] = round(use[field] + rng.uniform(0.001, 100), 9)
    elif field == "tasks":
        use[field] += 1
    elif field == "utilisation":
        use[field] += rng.uniform(0.001, 0.5)
    elif field == "drop":
        result.schedule["resources"].remove(use)
        words = "robots and crews, in the plan"
    elif "cost" not in good.schedule:
        return None
    elif field == "cost":
        use[field] += rng.uniform(0.03, 100)
    else:
        result.schedule["cost"] += rng.uniform(0.01, 100)
        words = "the whole costs"
    return Fault("edit a use", result, [""], words=words)


def change_the_speed(good, rng):
    """A parameter is faster than it was: its steps last too long."""
    places = steps(good, where=lambda record: isinstance(record["parameter"], str))
    if not places:
        return None
    index = rng.choice(places)
    record = good.records[index]
    result = copy.deepcopy(good)
    robot = result.robot(record["robot"])
    parameter = next(each for each in robot["parameters"] if each["name"] == record["parameter"])
    parameter["speed"] *= 1.05
    parameter["loaded_speed"] *= 1.05
    first = next(i for i in places if good.records[i]["robot"] == record["robot"]
                 and good.records[i]["parameter"] == record["parameter"])
    return Fault("change the speed", result, [good.records[first]["task"]], first + 1, words="the step lasts")


def name_another_parameter(good, rng):
    places = steps(good, where=lambda record: isinstance(record["parameter"], str) and len(record["q"]) > 1)
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    record = result.records[index]
    robot = result.robot(record["robot"])
    rules = " ".join(each.get("rule", each.get("derived")) for each in robot["parameters"]
                     if each["name"] != record["parameter"])
    names = [each["name"] for each in robot["parameters"] if each["name"] != record["parameter"]
             and each["step"] > 0 and f"{record['parameter']}_s" not in rules]
    if not names:
        return None
    record["parameter"] = rng.choice(names)
    return Fault("name another parameter", result, [record["task"]], index + 1)


def goals_with_attempts(good):
    """Waypoints that are followed by an attempt of their task."""
    return [index for index in good.places("goal")
            if next((r["type"] for r in good.records[index + 1:] if r["task"] == good.records[index]["task"]
                     and r["type"] in ("try", "wait", "goal", "end")), "") in ("try", "wait")]


def drop_a_goal(good, rng):
    places = goals_with_attempts(good)
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    del result.records[index]
    # Of several waypoints the next one shows it, or the end of the motion.
    return Fault("drop a goal", result, [good.records[index]["task"]], words="waypoint")


def double_a_goal(good, rng):
    places = goals_with_attempts(good)
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    result.records.insert(index, copy.deepcopy(result.records[index]))
    return Fault("double a goal", result, [good.records[index]["task"]], index + 2, words="waypoint")


def shift_a_date(good, rng):
    """A date that people read is off by a minute, or by more."""
    if not good.header["start_at"]:
        return None
    result = copy.deepcopy(good)

    def off(text):
        moment = datetime.datetime.strptime(text, "%Y-%m-%d %H:%M")
        return (moment + datetime.timedelta(minutes=rng.choice((-1, 1, 60, 1440)))).strftime("%Y-%m-%d %H:%M")

    field = rng.choice(("row", "table", "start_at", "ends", "header"))
    if field == "row":
        row, name = rng.choice(result.schedule["tasks"]), rng.choice(("begins", "ends"))
        row[name] = off(row[name])
        return Fault("shift a date", result, [row["task"]], words=f"'{name}' is")
    if field == "table":
        row, name = rng.choice(result.table[1:]), rng.choice(("begins", "ends"))
        column = result.table[0].index(name)
        row[column] = off(row[column])
        return Fault("shift a date", result, [row[0]], words=f"'{name}' is")
    place = result.header if field == "header" else result.schedule
    key = "ends" if field == "ends" else "start_at"
    place[key] = off(place[key])
    return Fault("shift a date", result, [""], words="'ends' is" if field == "ends" else "the plan begins at")


def end_in_a_livelock(good, rng):
    """A motion on the way of a task that is done ended in a livelock, and nothing was tried again."""
    places = []
    for index in good.places("end", where=lambda record: record["reached"] or record["status"] == "done"):
        after = [r for r in good.records[index + 1:] if r["task"] == good.records[index]["task"]]
        again = next((r["type"] for r in after if r["type"] != "pause"), "")
        if good.records[index]["tries"] > 0 and not (again == "goal" and not good.records[index]["reached"]):
            places.append(index)
    if not places or good.header["form"] == "short":
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    result.records[index].update({"status": "livelock", "reached": False, "period": 2, "message": "livelock"})
    return Fault("end in a livelock", result, [good.records[index]["task"]], None, words="ended with 'livelock'")


def change_a_checksum(good, rng):
    result = copy.deepcopy(good)
    file = rng.choice(result.header["files"])
    if rng.random() < 0.5:
        file["text"] += "\n"
    else:
        file["sha256"] = file["sha256"][::-1]
    return Fault("change a checksum", result, [""], words="is not the one of its checksum")


def change_a_residual(good, rng):
    places = good.places("end", where=lambda record: record["residual"])
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    record = result.records[index]
    task = good.task(record["task"])
    within = task["within"] if task else {}
    # A joint that only turns the tool about the axis that is free may stand anywhere.
    free = task is not None and "free" in task
    if (free or rng.random() < 0.5) and "position_error" in record:
        record["position_error"] += within.get("length", 0) + rng.uniform(0.001, 5)
    else:
        parameter = rng.choice(sorted(record["residual"]))
        record["residual"][parameter] += sum(within.values()) + rng.uniform(0.01, 5)
    return Fault("change a residual", result, [record["task"]], index + 1)


def rename_a_hit(good, rng):
    places = good.places("try", where=lambda record: "hit" in record)
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    record = result.records[index]
    side = rng.randrange(2)
    if rng.random() < 0.5:
        record["hit"][side] += "x"
    else:
        record["hit"] = record["hit"][::-1]
        if record["hit"][0].startswith(record["robot"] + "."):
            return None  # two parts of one machine
    return Fault("rename a hit", result, [record["task"]], index + 1, words="'")


def give_another_reason(good, rng):
    places = good.places("try", where=lambda record: not record["ok"])
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    reasons = {"at goal", "no direction", "hit", "limit nothing", ""} - {result.records[index]["reason"]}
    result.records[index]["reason"] = rng.choice(sorted(reasons))
    return Fault("give another reason", result, [good.records[index]["task"]])


def edit_the_critical_path(good, rng):
    path = good.schedule["critical"]
    if len(path) < 2:
        return None
    result = copy.deepcopy(good)
    edited = result.schedule["critical"]
    place = rng.randrange(len(path))
    field = rng.choice(("drop", "swap", "all", "task", "text", "lag"))
    names = [task["task"] for task in path]
    if field == "drop":
        # Where the first is left out, the next may lead back to a task further down.
        del edited[max(place, 1)]
    elif field == "swap":
        other = (place + 1) % len(path)
        if names[place] == names[other]:
            return None
        edited[place], edited[other] = edited[other], edited[place]
    elif field == "all":
        edited.clear()
    elif field == "task":
        edited[place]["task"] = rng.choice([name for name in good.results() if name != names[place]])
    elif field == "text":
        edited[place]["text"] += "!"
    else:
        numbers = re.sub(r"(\d+(\.\d+)?) (h|min|s)\b", lambda m: f"{float(m[1]) + 1:g} {m[3]}", path[place]["text"])
        if numbers == path[place]["text"]:
            return None
        edited[place]["text"] = numbers
    return Fault("edit the critical path", result, [*good.results(), "", *names], words="critical path"
                 if field in ("drop", "swap", "all") else "")


def change_the_currency(good, rng):
    if "currency" not in good.schedule:
        return None
    result = copy.deepcopy(good)
    others = {"USD", "", "eur"} - {good.schedule["currency"]}
    rng.choice((result.header, result.schedule))["currency"] = rng.choice(sorted(others))
    return Fault("change the currency", result, [""], words="the cost is in")


def turns(good, where=lambda record: True):
    return good.places("turn", where=where)


def drop_a_turn(good, rng):
    if not turns(good):
        return None
    index = rng.choice(turns(good))
    result = copy.deepcopy(good)
    del result.records[index]
    return Fault("drop a turn", result, [good.records[index]["task"]], words="is put")


def turn_by_another_angle(good, rng):
    if not turns(good):
        return None
    index = rng.choice(turns(good))
    result = copy.deepcopy(good)
    result.records[index]["angle"] += rng.choice((-1, 1)) * rng.uniform(0.01, 60)
    return Fault("turn by another angle", result, [good.records[index]["task"]], index + 1, words="where it is told")


def turn_neatly_wrong(good, rng):
    """What hangs and is put down is right for another angle: only the goal tells."""
    if not turns(good):
        return None
    index = rng.choice(turns(good))
    result = copy.deepcopy(good)
    turn = result.records[index]
    off = rng.choice((-1, 1)) * rng.uniform(0.2, 20)
    detach = next(r for r in result.records[index:] if r["type"] == "detach" and r["task"] == turn["task"])
    tool = product(rows_of(detach["pose"]), inverse_product(rows_of(turn["pose"]), rows_of(IDENTITY)))
    hangs = product(rotation(2, off), rows_of(turn["pose"]))  # the tool is upright
    turn["angle"] += off
    turn["pose"] = [number for row in hangs for number in row]
    detach["pose"] = [number for row in product(tool, hangs) for number in row]
    return Fault("turn neatly wrong", result, [turn["task"]], result.records.index(detach) + 1, words="from its goal")


def turn_the_barred_way(good, rng):
    """The shorter way, which something bars: only the sweep tells."""
    places = turns(good, lambda record: "hit" in record)
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    turn = result.records[index]
    turn["angle"] -= math.copysign(360, turn["angle"])
    return Fault("turn the barred way", result, [turn["task"]], index + 1, words=" meets " + turn["hit"][1])


def turn_before_adjusting(good, rng):
    if not turns(good):
        return None
    index = rng.choice(turns(good))
    result = copy.deepcopy(good)
    result.records[index]["from"] -= rng.uniform(0.1, 20)
    return Fault("turn before adjusting", result, [good.records[index]["task"]], index + 1, words="while it is adjusted")


def lines(good, wanted=lambda record: True):
    return [i for i, r in enumerate(good.records) if r["type"] == "try" and r["command"] == "line" and r["ok"] and wanted(r)]


def leave_the_line(good, rng):
    """A step of `line` and the next are a little beside it: too little for the goal to tell."""
    places = [i for i in lines(good) if i + 1 in lines(good) and i - 1 in lines(good)]
    if not places:
        return None
    index = rng.choice(places)
    result = copy.deepcopy(good)
    result.records[index]["q"]["upper.phi"] += rng.choice((-1, 1)) * rng.uniform(0.3, 0.6)
    return Fault("leave the line", result, [good.records[index]["task"]], words="beside its straight way")


def lock_what_moves(good, rng):
    """The plan locks what the steps move."""
    tasks = [task for task in good.header["tasks"] if "lock" in task]
    if not tasks or not lines(good):
        return None
    name = rng.choice(tasks)["name"]
    result = copy.deepcopy(good)
    result.task(name)["lock"].append("upper.phi")
    return Fault("lock what moves", result, [name], words="which is locked")


def enter_without_leave(good, rng):
    tasks = [task for task in good.header["tasks"] if "enter" in task]
    if not tasks:
        return None
    name = rng.choice(tasks)["name"]
    result = copy.deepcopy(good)
    del result.task(name)["enter"]
    return Fault("enter without leave", result, [name], words="meets slab")


def turn_without_leave(good, rng):
    """The plan turns nothing."""
    tasks = [task for task in good.header["tasks"] if "turning" in task.get("adjust", {})]
    tasks = [task["name"] for task in tasks if any(good.records[i]["task"] == task["name"] for i in turns(good))]
    if not tasks:
        return None
    name = rng.choice(tasks)
    result = copy.deepcopy(good)
    del result.task(name)["adjust"]["turning"]
    return Fault("turn without leave", result, [name], words="the plan turns none")


KINDS = (shift_a_step, shift_the_rest_of_a_task, drop_a_wait, close_a_wait_up, swap_times, start_too_early,
         move_a_component, change_a_value, drop_a_step, drop_a_step_neatly, repeat_a_step, move_the_grip, move_where_it_is_gripped,
         move_what_is_put_down, turn_what_is_put_down, move_the_goal, drop_a_load_change, overload, forget_a_mass,
         hide_an_overlap, sink_the_site, shift_what_carries, lengthen_work,
         take_a_day_off, shorten_a_shift, hang_a_load, invent_overtime, book_a_crew_twice, give_work_to_another, break_a_link,
         link_to_what_is_not_done, silence_a_refusal, call_it_done, hide_that_it_ended_short, call_it_not_reached, drop_a_task, cut_the_trace,
         wall_in_the_way, thing_where_a_load_is_put, grow_a_body, widen_a_buffer, zone_round_a_robot, people_under_a_load, edit_the_schedule,
         edit_the_table, change_the_speed, name_another_parameter, lengthen_a_part, give_a_part_to_another,
         hide_a_wait, wait_for_nothing, pause_for_nothing, edit_a_part_of_the_table, change_a_cost, change_a_rate, edit_a_use,
         drop_a_goal, double_a_goal, shift_a_date, end_in_a_livelock, change_a_checksum, change_a_residual,
         rename_a_hit, give_another_reason, edit_the_critical_path, change_the_currency, drop_a_turn,
         turn_by_another_angle, turn_neatly_wrong, turn_the_barred_way, turn_before_adjusting, turn_without_leave, leave_the_line,
         lock_what_moves, enter_without_leave, outweigh, fix_it_later)


def seeded(results, seed, rounds):
    """`rounds` faults of each kind, in results that have a place for it."""
    rng = random.Random(seed)
    for kind in KINDS:
        made = 0
        for _ in range(20 * rounds):
            fault = kind(rng.choice(results), rng)
            if fault is not None:
                made += 1
                yield fault
            if made == rounds:
                break
