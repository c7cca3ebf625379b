"""rubicon import of building models: alone, and joined to a schedule, as users call it."""

import csv
import os
import shutil
import subprocess
import tempfile
import unittest

RUBICON = os.environ["RUBICON"]
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
MODELS = os.path.join(ROOT, "tests", "cli", "models")
CRANE = os.path.join(ROOT, "robots", "tower_crane")

SCHEDULE = """<?xml version="1.0" encoding="UTF-8"?>
<Project xmlns="http://schemas.microsoft.com/project"><Name>house</Name><Tasks>
<Task><UID>1</UID><ID>1</ID><Name>Dig</Name><OutlineLevel>1</OutlineLevel><Duration>PT8H0M0S</Duration></Task>
<Task><UID>2</UID><ID>2</ID><Name>Floor</Name><OutlineLevel>1</OutlineLevel><Duration>PT8H0M0S</Duration>
<PredecessorLink><PredecessorUID>1</PredecessorUID><Type>1</Type></PredecessorLink></Task>
<Task><UID>3</UID><ID>3</ID><Name>Walls</Name><OutlineLevel>1</OutlineLevel><Duration>PT16H0M0S</Duration>
<PredecessorLink><PredecessorUID>2</PredecessorUID><Type>1</Type></PredecessorLink></Task>
<Task><UID>4</UID><ID>4</ID><Name>Roof</Name><OutlineLevel>1</OutlineLevel><Duration>PT8H0M0S</Duration>
<PredecessorLink><PredecessorUID>3</PredecessorUID><Type>1</Type></PredecessorLink></Task>
</Tasks></Project>
"""

MATCH = """plan {
  site box(-50, -50, -2, 50, 50, 0);
  robot crane "tower_crane_swivel.robot" at trans(0, 0, 0) { start jib.theta 0, x 12, z 20; }
  crew riggers;
  crew erectors;
}
stock box(-20, -12, 0, -6, 12, 4);
by crane;
hook 3 min by riggers;
adjust 4 min by erectors;
release 1 min by erectors;
grip trans(0, 0, 1);
density 500;
type IfcSlab -> task "Floor";
name "wall" -> task "Walls";
"""


def rubicon(*arguments, cwd=None):
    return subprocess.run([RUBICON, *arguments], capture_output=True, text=True, timeout=120, cwd=cwd)


class InAFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content.encode() if isinstance(content, str) else content)
        return self.path(name)

    def text(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return file.read()

    def model(self, name):
        return shutil.copy(os.path.join(MODELS, name), self.folder)

    def rows(self, name):
        with open(self.path(name), encoding="utf-8", newline="") as file:
            return {row["component"]: row for row in csv.DictReader(file)}


class AsItStands(InAFolder):
    def stands(self, model, *options):
        """Imports a model, checks and runs the plan; the text of the plan and the rows of the table."""
        done = rubicon("import", self.model(model), *options, "--out", self.path("a.plan"))
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
        self.assertEqual(rubicon("fmt", "--check", self.path("a.plan")).returncode, 0)
        for command in ("check", "run"):
            result = rubicon(command, self.path("a.plan"))
            self.assertEqual(result.returncode, 0, result.stderr)
        return self.text("a.plan"), self.rows("a_elements.csv"), done.stderr

    def expect(self, row, place, size, turn=0):
        for key, value in zip(("x", "y", "z", "length", "width", "height", "turn_deg"), (*place, *size, turn)):
            self.assertAlmostEqual(float(row[key]), value, delta=2e-5, msg=key)

    def test_ifc_2x3(self):
        plan, rows, said = self.stands("house_2x3.ifc")
        self.assertEqual(said, "")
        self.assertEqual(list(rows), ["wall_e_ground_floor", "wall_ground_floor", "slab_ground_floor"])
        self.expect(rows["wall_e_ground_floor"], (22, 0.1, 0.2), (4, 0.2, 2.5))
        self.expect(rows["wall_ground_floor"], (24.1, 2.5, 0.2), (4, 0.2, 2.5), 90)
        self.expect(rows["slab_ground_floor"], (22.2, 2.2, 0), (6, 6, 0.2))
        self.assertEqual(rows["wall_e_ground_floor"]["name"], "wall \u00e9")
        self.assertEqual(rows["wall_ground_floor"]["guid"], "2Yvctv9pz7Ex4gZ2sK7Jm0")
        self.assertIn("// house_2x3.ifc: IFC2X3, 3 elements, lengths in 0.001 m", plan)
        self.assertIn('part "2Yvctv9pz7Ex4gZ2sK7Jm0") at rotz(-90) * trans(-24.1, -2.5, -0.2);', plan)

    def test_ifc_4_in_national_coordinates(self):
        plan, rows, said = self.stands("house_4.ifc")
        self.assertIn("IfcRoof 'dome' (4Yvctv9pz7Ex4gZ2sK7Jm0) of house_4.ifc is left out", said)
        self.assertIn("// The point 155000, 463000, 0 of the model is the origin of this plan", plan)
        self.assertEqual(list(rows), ["wall_e_ground_floor", "wall_ground_floor", "slab_ground_floor"])
        self.expect(rows["wall_e_ground_floor"], (22, 0.1, 0.2), (4, 0.2, 2.5))
        self.expect(rows["wall_ground_floor"], (24.1, 2.5, 0.2), (4, 0.2, 2.5), 90)
        self.expect(rows["slab_ground_floor"], (22.2, 2.2, 0), (6, 6, 0.2))

    def test_gltf_with_two_nodes_of_one_name(self):
        plan, rows, _ = self.stands("frames.gltf")
        self.assertEqual(list(rows), ["wall_a_first_floor", "wall_a_first_floor_2"])
        self.expect(rows["wall_a_first_floor"], (1.5, -0.5, 3), (1, 1, 1))
        self.expect(rows["wall_a_first_floor_2"], (4.70711, 0, 3), (1, 1, 1), -45)
        self.assertEqual(rows["wall_a_first_floor"]["storey"], "First floor")
        self.assertIn('mesh("a_meshes/wall_a_first_floor_2.obj", m)', plan)
        self.assertEqual(len(os.listdir(self.path("a_meshes"))), 2)

    def test_collada(self):
        plan, rows, _ = self.stands("columns.dae")
        self.assertEqual(list(rows), ["n1_n0", "n2_n0"])
        self.expect(rows["n2_n0"], (9.5, 0.5, 0), (1, 1, 1))
        self.assertIn('mesh("columns.dae", part "n2")', plan)

    def test_obj_with_two_objects(self):
        plan, rows, _ = self.stands("blocks.obj", "--unit", "mm")
        self.assertEqual(list(rows), ["wall", "slab"])
        self.expect(rows["slab"], (2.5, 0.1, 0), (1, 0.2, 2.5))
        self.assertIn('mesh("blocks.obj", mm, part "slab")', plan)

    def test_stl_that_lies_on_its_side(self):
        plan, rows, _ = self.stands("beam.stl", "--unit", "m", "--up", "y")
        self.assertEqual(list(rows), ["beam"])
        self.expect(rows["beam"], (1.5, -0.15, 0), (3, 0.3, 0.2))
        self.assertIn('mesh("beam.stl", m, up y)', plan)

    def test_several_models_without_out_are_printed(self):
        self.model("house_2x3.ifc")
        self.model("columns.dae")
        done = rubicon("import", "house_2x3.ifc", "columns.dae", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.count("  component "), 5)
        self.assertEqual(sorted(os.listdir(self.folder)), ["columns.dae", "house_2x3.ifc"])


class WithASchedule(InAFolder):
    def setUp(self):
        super().setUp()
        self.model("house_2x3.ifc")
        for name in ("tower_crane_swivel.robot", "lift_over_and_turn.motion"):
            shutil.copy(os.path.join(CRANE, name), self.folder)
        self.write("house.xml", SCHEDULE)

    def put_up(self, match=MATCH):
        self.write("house.match", match)
        return rubicon("import", "house_2x3.ifc", "--schedule", "house.xml", "--match", "house.match", "--out",
                       "house.plan", cwd=self.folder)

    def test_the_tasks_put_the_house_up(self):
        done = self.put_up()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("1 element that no rule is about; no part of the plan: 1 IfcWallStandardCase 'wall \u00e9'", done.stderr)
        self.assertIn("2 tasks of the schedule without an element; they keep their duration: dig, roof", done.stderr)
        plan = self.text("house.plan")
        self.assertIn("// 1 element that no rule is about", plan)
        self.assertIn("'Ground floor', IfcWallStandardCase 'wall \u00e9', 1Yvctv9pz7Ex4gZ2sK7Jm0", plan)
        self.assertEqual(rubicon("check", "house.plan", cwd=self.folder).stderr, "")
        run = rubicon("run", "house.plan", "--format", "csv", cwd=self.folder)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        tasks = {row["task"]: row for row in csv.DictReader(run.stdout.splitlines())}
        self.assertEqual(list(tasks), ["dig", "floor_begins", "set_slab_ground_floor", "floor_ends", "walls_begins",
                                       "set_wall_ground_floor", "walls_ends", "roof"])

        def hours(task, key="start"):
            return float(tasks[task][key]) / 3600

        self.assertAlmostEqual(hours("set_slab_ground_floor"), 8)
        self.assertAlmostEqual(hours("set_slab_ground_floor", "work"), 8 / 60)
        self.assertAlmostEqual(hours("set_wall_ground_floor"), hours("floor_ends"))
        self.assertAlmostEqual(hours("roof"), hours("walls_ends"))
        rows = self.rows("house_elements.csv")
        self.assertEqual([row["fate"] for row in rows.values()], ["unmatched", "moved", "moved"])
        self.assertEqual(rows["slab_ground_floor"]["mass"], "3600")

    def test_the_schedule_comes_back(self):
        self.put_up()
        for plan, schedule in (("house.plan", "back.xml"), ("direct.plan", "direct.xml")):
            if plan == "direct.plan":
                rubicon("import", "house.xml", "--out", plan, cwd=self.folder)
            done = rubicon("export", plan, "--mspdi", schedule, cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)

        def tasks(name):
            text = self.text(name)
            return text[text.index("<Tasks>"):text.index("</Tasks>")]

        self.assertEqual(tasks("back.xml"), tasks("direct.xml"))

    def test_a_plan_that_check_would_refuse_is_not_written(self):
        self.write("house.plan", "plan old { }\n")
        for wrong, words in (("grip nonsense;", "house.match:16:6:"), ("hook 3 min by nobody;", "'nobody'"),
                             ("mass -5 kg;", "greater than 0"), ("priority x;", "no parameter"),
                             ("density 1e300;", "the mass of component")):
            done = self.put_up(MATCH + f"{wrong}\n-> task \"Roof\";\n")
            self.assertEqual(done.returncode, 2, wrong + done.stderr)
            self.assertIn("the plan is not written: 'rubicon check' refuses it", done.stderr)
            self.assertIn(words, done.stderr)
            self.assertEqual(self.text("house.plan"), "plan old { }\n")

    def test_mistakes_are_told_where_the_match_file_has_them(self):
        for old, new, words in (
                ("hook 3 min", "hook 3 m", "house.match:9:6: error: hook needs a time, but 'm' is a length"),
                ("3 min by riggers", "3 min by rigers", "house.match:9:15: error: unknown crew 'rigers'"),
                ("by crane", "by krane", "house.match:8:4: error: unknown robot or crew 'krane'"),
                ("tower_crane_swivel", "towercrane", "house.match:3:15: error: robot file 'towercrane.robot'"),
                ("trans(0, 0, 1);\ndensity", "trans(0, 0, 1)\ndensity",
                 "house.match:13:1: error: expected ';' after grip, found 'density'"),
                ("by crane;\n", "", "house.match:13:1: error: this rule does not say who lifts its elements"),
                ("density 500", "density 90000000", "house.match:13:9: error: the mass of component"),
                ("stock box", "\0stock box", "house.match:7:1: error: not UTF-8: byte 0x00")):
            done = self.put_up(MATCH.replace(old, new))
            self.assertEqual(done.returncode, 2, new + done.stderr)
            self.assertIn(words, done.stderr)
            self.assertNotIn("house.plan:", done.stderr)
            self.assertEqual(done.stderr.count(words.partition(" error: ")[2]), 1)
            self.assertFalse(os.path.exists(self.path("house.plan")))

    def test_doubts_of_the_match_file(self):
        done = self.put_up(MATCH.replace("density 500", "density 0.5") + "type IfcStair -> stands;\n"
                           "type IfcSlab -> stands;\n")
        self.assertEqual(done.returncode, 0, done.stderr)
        for words in ("house.match:13:9: warning: density 0.5 has no unit and is taken as 0.5 kg/m3: are tons meant?",
                      "house.match:16:1: warning: no element fits this rule",
                      "house.match:17:1: warning: rules above this one take all elements that it fits"):
            self.assertIn(words, done.stderr)
        done = self.put_up(MATCH.replace("density 500", "density 2.4 t/m3"))
        self.assertNotIn("density", done.stderr)
        self.assertEqual(self.rows("house_elements.csv")["slab_ground_floor"]["mass"], "17280")

    def test_mistakes_of_the_match_file_are_told_and_the_old_plan_stays(self):
        self.write("house.plan", "plan old { }\n")
        for wrong, words in (("type IfcSlab -> task \"Flor\";", "did you mean Floor?"),
                             ("type IfcSlab -> walk;", "house.match:16:"),
                             ("-> task \"Roof\" { stock yard; }", "without room in stock area 'yard'")):
            done = self.put_up(MATCH + wrong)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(words, done.stderr)
            self.assertEqual(self.text("house.plan"), "plan old { }\n")


class WhatIsWrittenPassesTheCheck(InAFolder):
    def imported(self, model, text, *options, out="a.plan"):
        self.write(model, text)
        done = rubicon("import", model, "--out", out, *options, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        check = rubicon("check", out, cwd=self.folder)
        self.assertEqual(check.returncode, 0, check.stderr + self.text(out))
        return self.text(out)

    def test_a_flat_element(self):
        sheet = "o sheet\nv 0 0 1\nv 2 0 1\nv 2 1 1\nf 1 2 3\n"
        self.assertIn("grip trans(0, 0, 0);", self.imported("a.obj", sheet, "--unit", "m"))

    def test_a_plan_whose_name_ends_a_text(self):
        two = "".join(f"o a\"{z}\nv 0 0 {z}\nv 2 0 {z}\nv 2 1 {z}\nf -3 -2 -1\n" for z in (1, 2))
        self.assertIn('mesh("b_c_meshes/', self.imported("a.obj", two, "--unit", "m", out='b"c.plan'))

    def test_elements_that_no_plan_can_hold_are_left_out(self):
        far = "".join(f"o {name}\nv {x} 0 0\nv {x} 1 0\nv {x} 1 1\nf -3 -2 -1\n"
                      for name, x in (("near", -9.9e6), ("far", 9.9e6)))
        plan = self.imported("a.obj", far, "--unit", "m")
        self.assertIn("is left out: it reaches farther than", plan)
        self.assertEqual(plan.count("\n  component "), 1)

    def test_a_link_that_changes_the_format_is_refused(self):
        self.write("a.data", "o sheet\nv 0 0 1\nv 2 0 1\nv 2 1 1\nf 1 2 3\n")
        os.symlink("a.data", self.path("a.obj"))
        done = rubicon("import", "a.obj", "--unit", "m", "--out", "a.plan", cwd=self.folder)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("name the file itself", done.stderr)


class WrongCalls(InAFolder):
    def refused(self, words, *arguments):
        done = rubicon("import", *arguments, cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertIn(words, done.stderr)

    def test_calls_that_make_no_sense(self):
        self.model("house_2x3.ifc")
        self.model("blocks.obj")
        self.write("a.xml", SCHEDULE)
        self.refused("--schedule and --match go together", "house_2x3.ifc", "--match", "a.match")
        self.refused("models and schedules cannot be mixed", "house_2x3.ifc", "a.xml")
        self.refused("one schedule at a time", "a.xml", "a.xml")
        self.refused("go with a model", "a.xml", "--unit", "mm")
        self.refused("says no unit", "blocks.obj")
        self.refused("--unit", "blocks.obj", "--unit", "ell")
        self.refused("cannot be read", "missing.ifc")
        self.refused("there is no such file", "house_2x3.ifc", "--schedule", "b.xml", "--match", "b.match")

    def test_a_model_elsewhere_is_refused(self):
        self.model("house_2x3.ifc")
        os.mkdir(self.path("plans"))
        self.refused("lies outside the folder of the plan", "house_2x3.ifc", "--out", "plans/a.plan")
        self.refused("has no folder 'nowhere'", "house_2x3.ifc", "--out", "nowhere/a.plan")
        self.assertEqual(os.listdir(self.path("plans")), [])

    def test_a_full_disk_is_an_error(self):
        self.model("frames.gltf")
        with tempfile.TemporaryDirectory() as folder:
            os.symlink("/dev/full", os.path.join(folder, "a_elements.csv"))
            shutil.copy(self.path("frames.gltf"), folder)
            done = rubicon("import", "frames.gltf", "--out", "a.plan", cwd=folder)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertFalse(os.path.exists(os.path.join(folder, "a.plan")))


class Hostile(InAFolder):
    """Files made to do harm: each is refused in seconds, and the command itself lives."""

    def refused(self, name, content, *options):
        self.write(name, content)
        done = rubicon("import", name, *options, cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr[:500])
        self.assertIn("error", done.stderr)

    def ifc(self):
        with open(os.path.join(MODELS, "house_2x3.ifc"), encoding="utf-8") as file:
            return file.read()

    def test_ifc_that_is_cut_off_anywhere(self):
        whole = self.ifc()
        for share in range(1, 20):
            self.refused("a.ifc", whole[: len(whole) * share // 20])

    def test_ifc_that_nests_repeats_or_points_nowhere(self):
        whole = self.ifc()
        self.refused("a.ifc", whole.replace("#6=", "#6=(" + "(" * 100000))
        self.refused("a.ifc", whole.replace("#7=", "#6="))
        self.refused("a.ifc", whole.replace("#26=IFCPRODUCTDEFINITIONSHAPE($,$,(#25))",
                                            "#26=IFCPRODUCTDEFINITIONSHAPE($,$,(#99999))")
                     .replace("#48=IFCPRODUCTDEFINITIONSHAPE($,$,(#47))", "#48=IFCPRODUCTDEFINITIONSHAPE($,$,(#48))"))

    def test_placements_in_a_ring_leave_their_element_out(self):
        text = self.ifc().replace("#29=IFCLOCALPLACEMENT(#12,#28)", "#29=IFCLOCALPLACEMENT(#29,#28)")
        self.write("a.ifc", text)
        done = rubicon("import", "a.ifc", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("the placements it hangs on lead in a ring", done.stderr)
        self.assertEqual(done.stdout.count("  component "), 2)

    def test_other_formats(self):
        self.refused("a.gltf", '{"asset":{"version":"2.0"},"nodes":[' + '{"children":[0]},' * 10000 + "{}]}")
        self.refused("a.dae", "<COLLADA>" + "<node>" * 300000)
        self.refused("a.stl", b"\0" * 80 + b"\xff\xff\xff\xff" + b"\0" * 50, "--unit", "m")
        self.refused("a.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "--unit", "m")
        self.refused("a.ply", "ply\nformat ascii 1.0\nelement vertex 100000000\nproperty float x\nend_header\n",
                     "--unit", "m")

    def test_names_that_would_break_out_of_their_line_do_not(self):
        text = self.ifc().replace("'slab'", "'a\"; } task x { takes 1 h; } // \\X\\0A component y { \\X2\\202E\\X0\\'")
        self.write("a.ifc", text)
        done = rubicon("import", "a.ifc", "--out", "a.plan", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(rubicon("check", "a.plan", cwd=self.folder).returncode, 0)
        self.assertEqual(self.text("a.plan").count("\n  component "), 3)
        self.assertNotIn("\n  task ", self.text("a.plan"))


if __name__ == "__main__":
    unittest.main()
