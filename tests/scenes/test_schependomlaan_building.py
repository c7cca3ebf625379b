"""The whole Schependomlaan building: its models and its schedule imported, joined, and put up by a crane and crews."""

import collections
import csv
import filecmp
import glob
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import scene_support as scene
from schependomlaan import activities, boxes

DATA = os.path.join(scene.ROOT, "..", "shared", "data", "schependomlaan")
CASE = os.path.join(scene.ROOT, "tests", "scenes", "schependomlaan")
MOTION = os.path.join(scene.ROOT, "robots", "tower_crane", "lift_over_and_turn.motion")

PLACED = 1e-4
"""How far (m) an element may end from where the model has it."""

TURNED = 1e-6
"""The same of its orientation (rad)."""

DRAWN = 2e-5
"""How far (m) the box of an element may be from the one that the program wrote which drew the model."""

REFUSED = {
    # drawn into a beam by 2 cm and by 4 mm
    "set_binnenwand_01_eerste_verdieping_9": "binnenwand_01_eerste_verdieping_9 meets heb220_01_eerste_verdieping_2",
    "set_binnenblad_01_eerste_verdieping_20": "binnenblad_01_eerste_verdieping_20 meets heb220_01_eerste_verdieping",
    # drawn into another wall
    "set_binnenblad_02_tweede_verdieping_11": "binnenblad_02_tweede_verdieping_11 meets binnenwand_02_tweede_verdieping_9",
    # below a beam, and beside a wall that overhangs it: no hook comes there
    "set_hoeklijn_bordes_00_begane_grond": "crane.hook meets heb220_01_eerste_verdieping",
    "set_geveldrager_01_eerste_verdieping_2": "crane.hook meets binnenblad_01_eerste_verdieping_4",
    # the schedule has the roof beam two days before the wall that carries it
    "set_liftwand_03_derde_verdieping_4": "liftwand_03_derde_verdieping_4 meets hea220_04_dak",
}


def command(*arguments, cwd):
    done = scene.rubicon(*arguments, cwd=cwd)
    if done.returncode == 2:
        raise AssertionError(done.stderr)
    return done


class WholeBuilding(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        for file in (*glob.glob(os.path.join(DATA, "*")), *glob.glob(os.path.join(CASE, "*.[mr]*")), MOTION):
            shutil.copy(file, cls.folder)
        cls.models = sorted(os.path.basename(file) for file in glob.glob(os.path.join(DATA, "*.ifc")))
        cls.schedule = "planning-2015-02-18.mspdi.xml"
        cls.imported = command("import", *cls.models, "--schedule", cls.schedule, "--match", "building.match",
                               "--out", "building.plan", cwd=cls.folder)
        with open(os.path.join(cls.folder, "building_elements.csv"), encoding="utf-8", newline="") as table:
            cls.elements = list(csv.DictReader(table))
        cls.moved = {row["task"]: row for row in cls.elements if row["fate"] == "moved"}
        cls.outcome = scene.Run(os.path.join(cls.folder, "building.plan"), cls.folder, "--trace-detail", "tasks",
                                "--out", os.path.join(cls.folder, "result"))

    def test_every_element_of_the_models_is_accounted_for(self):
        self.assertEqual(collections.Counter(row["fate"] for row in self.elements),
                         {"moved": 256, "unmatched": 12, "left out": 5})
        self.assertEqual(len({row["guid"] + row["model"] for row in self.elements}), 273)
        self.assertIn("12 elements that no rule is about; no part of the plan: 1 IfcBeam 'geveldrager'", self.imported.stderr)
        self.assertIn("102 tasks of the schedule without an element; they keep their duration", self.imported.stderr)
        with open(os.path.join(self.folder, "building.plan"), encoding="utf-8") as file:
            plan = file.read()
        for row in self.elements:
            listed = [line for line in plan.splitlines() if row["guid"] in line and "mesh(" not in line]
            self.assertTrue(listed, row["component"])

    def test_the_plan_is_sound(self):
        # In the stock stairs and beams with plates would tip as they are drawn: people put something below.
        said = command("check", "building.plan", cwd=self.folder).stderr
        warnings = [line.split("warning: ")[1] for line in said.splitlines() if "warning: " in line]
        tips = [line for line in warnings if "does not stand: its centre of mass is" in line and line.endswith(", site")]
        self.assertEqual((len(tips), len(warnings)), (17, 17), said)
        self.assertEqual(sum("trappen" in line for line in tips), 6)
        self.assertEqual(scene.rubicon("fmt", "--check", "building.plan", cwd=self.folder).returncode, 0)

    def test_the_boxes_of_all_elements_are_those_of_the_program_that_drew_them(self):
        drawn = {}
        for model in self.models:
            drawn.update(boxes.of_file(os.path.join(self.folder, model)))
        compared = 0
        for row in self.elements:
            box = drawn.get((row["model"], row["guid"]))
            if box is None or float(row["turn_deg"]) not in (0, 90):
                continue
            self.assertLess(boxes.difference(box, boxes.of_row(row)), DRAWN, row["component"])
            compared += 1
        self.assertEqual(compared, 268)  # all but the markers and a column turned by 60 degrees

    def test_every_lifted_element_ends_where_the_model_has_it(self):
        poses = self.outcome.final_poses()
        done = [row for task, row in self.moved.items() if self.outcome.tasks[task]["result"] == "done"]
        self.assertEqual(len(done), 250)
        for row in done:
            place = scene.translation(*(float(row[axis]) for axis in "xyz"))
            model = scene.multiply(place, scene.rotation_z(float(row["turn_deg"])))
            self.assertLess(scene.position_error(poses[row["component"]], model), PLACED, row["component"])
            self.assertLess(scene.turn_error(poses[row["component"]], model), TURNED, row["component"])

    def test_refused_elements_have_their_reasons(self):
        self.assertEqual(self.outcome.exit_code, 1)
        refused = {task: self.outcome.tasks[task]["reason"] for task in self.outcome.results("rejected")}
        self.assertEqual(set(refused), set(REFUSED))
        for task, reason in refused.items():
            self.assertIn(REFUSED[task], reason)

    def test_the_process_time_of_the_activities(self):
        rows = activities.table(os.path.join(self.folder, "building_elements.csv"),
                                os.path.join(self.folder, "result", "schedule.csv"))
        print("\n" + activities.text(rows))
        floor = rows[0]
        self.assertEqual(floor.name, "kanaalplaatvloer_leggen_lev_week_16")
        self.assertEqual((floor.elements, floor.done, floor.planned), (48, 48, 8))
        # 48 elements of 8 minutes with the crews, and what the crane takes.
        self.assertAlmostEqual(floor.work, 6.4, places=6)
        self.assertGreater(floor.motion, 1.5)
        self.assertLess(floor.motion, 4)
        for row in rows:
            self.assertLessEqual(row.first[:10], row.last[:10])

    def test_nothing_begins_before_the_schedule_lets_it(self):
        begins = {"kanaalplaatvloer_leggen_lev_week_16": "2015-04-13", "lijmwerk_kalkzandsteen_elementen": "2015-04-22",
                  "stelwerk_lijmwerk_lift": "2015-07-15"}
        rows = activities.table(os.path.join(self.folder, "building_elements.csv"),
                                os.path.join(self.folder, "result", "schedule.csv"))
        for row in rows:
            if row.name in begins:
                self.assertEqual(row.first[:10], begins[row.name])

    def test_a_second_method_finds_no_fault_in_the_result(self):
        command("run", "building.plan", "--out", "whole", cwd=self.folder)
        verified = scene.rubicon("verify", "whole", cwd=self.folder)
        self.assertEqual(verified.returncode, 0, verified.stdout)
        self.assertIn("no fault", verified.stdout)

    def test_the_schedule_comes_back_as_it_was(self):
        command("export", "building.plan", "--mspdi", "back.xml", cwd=self.folder)
        command("import", self.schedule, "--out", "schedule.plan", cwd=self.folder)
        command("export", "schedule.plan", "--mspdi", "direct.xml", cwd=self.folder)

        def tasks(name):
            with open(os.path.join(self.folder, name), encoding="utf-8") as file:
                return re.findall(r"<Task>.*?</Task>", file.read(), re.DOTALL)

        self.assertEqual(tasks("back.xml"), tasks("direct.xml"))
        self.assertEqual(len(tasks("back.xml")), 157)

    def test_the_same_models_give_the_same_bytes(self):
        command("import", *self.models, "--schedule", self.schedule, "--match", "building.match", "--out", "again.plan",
                cwd=self.folder)
        for end in (".plan", "_elements.csv"):
            self.assertTrue(filecmp.cmp(os.path.join(self.folder, "building" + end),
                                        os.path.join(self.folder, "again" + end), shallow=False), end)


class YardOfTheBuilding(unittest.TestCase):
    """taskplans/real_yard.py: twenty tow motors among all that the models have."""

    def test_twenty_motors_bring_forty_pallets(self):
        script = os.path.join(scene.ROOT, "taskplans", "real_yard.py")
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, "-B", script, os.environ["RUBICON"], folder], check=True, timeout=120)
            self.assertEqual(scene.rubicon("fmt", "--check", "yard.plan", cwd=folder).returncode, 0)
            outcome = scene.Run(os.path.join(folder, "yard.plan"), folder, "--out", os.path.join(folder, "result"))
            self.assertEqual(outcome.exit_code, 0, outcome.stderr)
            self.assertEqual(sorted(outcome.results("done")), sorted(f"bring_{i}" for i in range(1, 41)))
            self.assertEqual({task["robot"] for task in outcome.tasks.values()}, {f"tow_motors_{i}" for i in range(1, 21)})
            verified = scene.rubicon("verify", "result", cwd=folder)
            self.assertEqual(verified.returncode, 0, verified.stdout)
            self.assertIn("40 tasks (40 done)", verified.stdout)

    def test_without_the_models_it_says_so(self):
        script = os.path.join(scene.ROOT, "taskplans", "real_yard.py")
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, "-B", script, os.environ["RUBICON"], folder, "--data", folder], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("has no models: they are not part of this project", done.stderr)


if __name__ == "__main__":
    if not os.path.isdir(DATA):
        print(f"skipped: the data folder {os.path.normpath(DATA)} is not there")
        sys.exit(scene.SKIPPED)
    unittest.main(verbosity=2)
