"""A real floor, from its IFC model: 48 hollow-core elements lifted from a truck to their places."""

import csv
import os
import re
import subprocess
import sys
import tempfile
import unittest

import scene_support as scene

MODEL = os.path.join(scene.ROOT, "..", "shared", "data", "schependomlaan", "IFC-kanaalplaatvloer.ifc")

PLACED = 1e-3
"""How far (m) an element may end from where the model has it."""

TURNED = 1e-6
"""The same of its orientation (rad): 4 micrometres at the ends of the longest element."""

SECONDS = 1e-6
"""Durations are sums of hundreds of steps, each rounded to 1 ns."""


class Floor:
    """The plan of the floor in a folder of its own, and what came of it."""

    def __init__(self, order, shifts=()):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([os.environ["MAKE_SCHEPENDOMLAAN"], MODEL, folder, "--order", order], check=True)
            with open(os.path.join(folder, "elements.csv"), encoding="utf-8") as table:
                self.elements = {row["component"]: row for row in csv.DictReader(table)}
            plan = os.path.join(folder, "site.plan")
            for shift in shifts:
                shift_target(plan, *shift)
            self.outcome = scene.Run(plan, folder)

    def in_model(self, component):
        """Where the IFC has the element (make_schependomlaan_test compares elements.csv with the IFC itself)."""
        row = self.elements[component]
        place = scene.translation(*(float(row[axis]) for axis in "xyz"))
        return scene.multiply(place, scene.rotation_z(float(row["turn_deg"])))


def shift_target(plan, task, dx, dy):
    """Moves the target of one task by dx, dy (m)."""
    with open(plan, encoding="utf-8") as file:
        text = file.read()

    def moved(found):
        return f"{found[1]}{float(found[2]) + dx:.6f}, {float(found[3]) + dy:.6f},"

    text, count = re.subn(rf"(task {task} \{{.*?to trans\()(\S+), (\S+),", moved, text, count=1, flags=re.DOTALL)
    assert count == 1, f"no task {task} in {plan}"
    with open(plan, "w", encoding="utf-8") as file:
        file.write(text)


def crew_seconds(task):
    return sum(task[work]["duration"] for work in ("hook", "adjust", "release"))


def motion_seconds(outcome):
    """Seconds in motion of each task, from the configurations and speeds of the trace, not from its times."""
    robot = outcome.header["robots"][0]
    parameters = {parameter["name"]: parameter for parameter in robot["parameters"]}
    seconds = dict.fromkeys(outcome.tasks, 0.0)
    q = robot["start"]
    speed = "speed"
    for record in outcome.records:
        if record["type"] == "attach":
            speed = "loaded_speed"
        elif record["type"] == "detach":
            speed = "speed"
        elif record["type"] == "try" and record["ok"]:
            parameter = parameters[record["parameter"]]
            distance = abs(record["q"][parameter["name"]] - q[parameter["name"]])
            if parameter["cyclic"]:
                distance = min(distance, 360 - distance)
            seconds[record["task"]] += distance / (parameter[speed] or parameter["speed"])
            q = record["q"]
    return seconds


class GoodOrder(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.floor = Floor("good")
        cls.outcome = cls.floor.outcome

    def test_every_element_is_lifted_and_none_refused(self):
        self.assertEqual(self.outcome.exit_code, 0, self.outcome.stderr)
        self.assertEqual(len(self.floor.elements), 48)
        self.assertEqual(len(self.outcome.tasks), 48)
        self.assertEqual(self.outcome.results("done"), list(self.outcome.tasks))
        for kind in ("attach", "detach"):
            handled = sorted(record["component"] for record in self.outcome.of_type(kind))
            self.assertEqual(handled, sorted(self.floor.elements))

    def test_every_element_ends_where_the_model_has_it(self):
        for component, pose in self.outcome.final_poses().items():
            self.assertLess(scene.position_error(pose, self.floor.in_model(component)), PLACED, component)
            self.assertLess(scene.turn_error(pose, self.floor.in_model(component)), TURNED, component)

    def test_the_crane_itself_has_it_there(self):
        """The pose follows from what the crane did: its configuration when it lets go, and how the element hung."""
        mounting = self.outcome.header["robots"][0]["pose"]
        hung, q, compared = {}, None, 0
        for record in self.outcome.records:
            if record["type"] == "try":
                q = record["q"]
            elif record["type"] == "attach":
                hung[record["component"]] = record["pose"]
            elif record["type"] == "detach":
                tool = scene.multiply(mounting, scene.rotation_z(q["jib.theta"]))
                tool = scene.multiply(tool, scene.translation(q["x"], 0, q["z"]))
                tool = scene.multiply(tool, scene.rotation_z(q["hook.theta"]))
                pose = scene.multiply(tool, hung[record["component"]])
                target = self.floor.in_model(record["component"])
                self.assertLess(scene.position_error(pose, target), PLACED, record["component"])
                self.assertLess(scene.turn_error(pose, target), TURNED, record["component"])
                compared += 1
        self.assertEqual(compared, 48)

    def test_the_seconds_of_every_element(self):
        crews = {task["name"]: crew_seconds(task) for task in self.outcome.header["tasks"]}
        motions = motion_seconds(self.outcome)
        moves = {task["name"]: task["move"] for task in self.outcome.header["tasks"]}
        print(f"\n{'element':<10}{'in all, s':>12}{'without crew, s':>17}")
        for name, row in self.outcome.tasks.items():
            print(f"{moves[name]:<10}{row['duration']:>12.1f}{row['duration'] - crews[name]:>17.1f}")
            self.assertAlmostEqual(row["duration"], crews[name] + motions[name], delta=SECONDS, msg=name)
            self.assertGreater(motions[name], 30, name)
        count = len(self.outcome.tasks)
        total = self.outcome.process_time
        in_motion = total - sum(crews.values())
        print(f"{'all':<10}{total:>12.1f}{in_motion:>17.1f}")
        print(f"{'an element':<10}{total / count:>12.1f}{in_motion / count:>17.1f}")
        self.assertAlmostEqual(total, sum(row["duration"] for row in self.outcome.tasks.values()), delta=SECONDS)


class NeighboursTouch(unittest.TestCase):
    """Contact is no collision, and a real overlap is no contact."""

    def test_half_the_tolerance_into_its_neighbour_is_contact(self):
        outcome = Floor("good", [("lay_floor_02", 0, -0.0005)]).outcome
        self.assertEqual(outcome.tasks["lay_floor_02"]["result"], "done", outcome.tasks["lay_floor_02"]["reason"])

    def test_five_millimetres_into_its_neighbour_is_a_collision(self):
        outcome = Floor("good", [("lay_floor_02", 0, -0.005)]).outcome
        self.assertEqual(outcome.exit_code, 1)
        self.assertEqual(outcome.tasks["lay_floor_02"]["result"], "rejected")
        self.assertIn("floor_02 meets floor_01", outcome.tasks["lay_floor_02"]["reason"])


class BadOrder(unittest.TestCase):
    """One element waits below the floor until the rest of it lies: its gap would have to be filled from below."""

    @classmethod
    def setUpClass(cls):
        cls.floor = Floor("bad")
        cls.outcome = cls.floor.outcome

    def test_the_last_gap_is_rejected_and_the_reason_names_the_pair(self):
        self.assertEqual(self.outcome.exit_code, 1)
        rejected = self.outcome.results("rejected")
        self.assertEqual(len(rejected), 1)
        self.assertEqual(len(self.outcome.results("done")), len(self.outcome.tasks) - 1)
        name = rejected[0]
        reason = self.outcome.tasks[name]["reason"]
        print(f"\n{name}: {reason}")
        self.assertEqual(list(self.outcome.tasks)[-1], name)
        hits = [record for record in self.outcome.of_type("try") if record["task"] == name and "hit" in record]
        moved, met = hits[-1]["hit"]
        self.assertIn(f"{moved} meets {met}", reason)
        self.assertIn(met, self.floor.elements)

    def test_the_rejected_element_stays_where_it_was(self):
        name = self.outcome.results("rejected")[0]
        component = name.removeprefix("lay_")
        parked = [record for record in self.outcome.of_type("detach") if record["component"] == component]
        self.assertEqual([record["task"] for record in parked], [f"park_{component}"])
        self.assertEqual(self.outcome.tasks[name]["duration"], 0)


if __name__ == "__main__":
    if not os.path.exists(MODEL):
        print(f"skipped: the model {os.path.normpath(MODEL)} is not there")
        sys.exit(scene.SKIPPED)
    unittest.main(verbosity=2)
