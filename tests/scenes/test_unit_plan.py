"""The shipped plan of a dwelling unit: everything ends where the plan says, and a wrong order is found out."""

import os
import re
import tempfile
import unittest

import scene_support as scene
import test_shipped_plans as shipped

PLAN = os.path.join(scene.ROOT, "taskplans", "unit.plan")

PLACED = 1e-6
"""m and rad: the crane reaches its goals exactly, the rest is rounding."""


def text_of_plan():
    with open(PLAN, encoding="utf-8") as file:
        return file.read()


def targets(text):
    """Target pose of each component by the text of the plan, of the last task that moves it."""
    place = r"move (\w+) to trans\(([^,]+), ([^,]+), ([^)]+)\)(?: \* rotz\(([^)]+)\))?;"
    poses = {}
    for component, x, y, z, turn in re.findall(place, text):
        turned = scene.rotation_z(float(turn or 0))
        poses[component] = scene.multiply(scene.translation(float(x), float(y), float(z)), turned)
    return poses


def run(text):
    """Runs a changed copy of the plan."""
    with tempfile.TemporaryDirectory() as folder:
        robots = os.path.relpath(os.path.join(scene.ROOT, "robots"), os.path.realpath(folder))
        plan = os.path.join(folder, "unit.plan")
        with open(plan, "w", encoding="utf-8") as file:
            file.write(text.replace('"../robots/', f'"{robots}/'))
        return scene.Run(plan, folder)


class AsShipped(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.outcome = run(text_of_plan())

    def test_no_task_is_refused(self):
        self.assertEqual(self.outcome.exit_code, 0, self.outcome.stderr)
        self.assertEqual(self.outcome.results("done"), list(self.outcome.tasks))
        self.assertEqual(len(self.outcome.tasks), len(re.findall(r"^  task ", text_of_plan(), re.MULTILINE)))

    def test_its_process_time_is_the_one_in_the_readme(self):
        self.assertEqual(round(self.outcome.process_time), shipped.promised_times()["unit"])

    def test_every_component_ends_where_the_plan_says(self):
        wanted = targets(text_of_plan())
        poses = self.outcome.final_poses()
        self.assertEqual(sorted(wanted), sorted(poses))
        for component, pose in poses.items():
            self.assertLess(scene.position_error(pose, wanted[component]), PLACED, component)
            self.assertLess(scene.turn_error(pose, wanted[component]), PLACED, component)

    def test_it_ends_with_the_crane_free(self):
        self.assertEqual(self.outcome.records[-1]["type"], "task_end")
        last = self.outcome.of_type("end")[-1]
        self.assertEqual(last["task"], "crane_free")
        self.assertTrue(last["reached"])


class RoofBeforeItsWalls(unittest.TestCase):
    """The first roof plank lies over the place of the west walls: no wall can be lowered through it."""

    @classmethod
    def setUpClass(cls):
        text = text_of_plan()
        for task, before, after in (
            ("set_roof_1", "set_south_3", "grout_floor"),
            ("set_west_1", "grout_floor", "set_roof_1"),
            ("set_roof_2", "set_roof_1", "set_south_3"),
        ):
            text, count = re.subn(rf"(task {task} \{{[^}}]*after ){before};", rf"\g<1>{after};", text)
            assert count == 1, f"task {task} does not come after {before} in the shipped plan"
        text, count = re.subn(r"(plan unit \{)", r"\1 support off;", text)  # no plank lies on walls that are not there
        assert count == 1, "the shipped plan is no plan unit {"
        cls.outcome = run(text)

    def test_the_wall_is_rejected_with_its_reason(self):
        self.assertEqual(self.outcome.exit_code, 1)
        self.assertEqual(self.outcome.results("rejected"), ["set_west_1"])
        reason = self.outcome.tasks["set_west_1"]["reason"]
        print(f"\nset_west_1: {reason}")
        self.assertIn("west_1 meets roof_1", reason)

    def test_what_comes_after_it_is_not_reached(self):
        tasks = self.outcome.tasks
        after = {task["name"]: [link["task"] for link in task["after"]] for task in self.outcome.header["tasks"]}
        missing = {"set_west_1"}
        for name in tasks:  # the order of execution: what a task comes after stands before it
            if missing & set(after[name]):
                missing.add(name)
        missing.remove("set_west_1")
        self.assertIn("set_west_2", missing)
        self.assertIn("crane_free", missing)
        self.assertEqual(set(self.outcome.results("not reached")), missing)
        self.assertEqual(tasks["set_west_2"]["reason"], "it comes after set_west_1, which is rejected")
        far = "it comes after set_west_2, which is not reached because set_west_1 is rejected"
        self.assertEqual(tasks["set_east_1"]["reason"], far)
        for name in missing:
            self.assertEqual((tasks[name]["tried"], tasks[name]["duration"]), (0, 0), name)

    def test_the_rest_goes_on(self):
        self.assertEqual(self.outcome.tasks["set_roof_1"]["result"], "done")
        begun = {record["task"] for record in self.outcome.of_type("task_start")}
        self.assertEqual(begun, set(self.outcome.results("done")) | {"set_west_1"})

    def test_the_wall_is_back_in_its_rack(self):
        rack = {component["name"]: component["pose"] for component in self.outcome.header["components"]}
        self.assertEqual(self.outcome.final_poses()["west_1"], rack["west_1"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
