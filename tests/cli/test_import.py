"""rubicon import and rubicon export: schedules to plans and back, as users call them."""

import os
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

RUBICON = os.environ["RUBICON"]
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SAMPLES = os.path.join(ROOT, "tests", "unit", "project_io")
REAL = os.path.join(ROOT, "..", "shared", "data", "schependomlaan", "planning-2015-02-18.mspdi.xml")


def rubicon(*arguments):
    return subprocess.run([RUBICON, *arguments], capture_output=True, text=True, timeout=120)


class Import(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content)
        return self.path(name)

    def round_trip(self, schedule):
        """Imports, checks, formats, exports, imports again; the two plans, but for the file's name."""
        plan, back, again = self.path("a.plan"), self.path("b.xml"), self.path("c.plan")
        first = rubicon("import", schedule, "--out", plan)
        self.assertEqual((first.returncode, first.stdout), (0, ""), first.stderr)
        self.assertEqual(rubicon("check", plan).stderr, "")
        self.assertEqual(rubicon("fmt", "--check", plan).returncode, 0)
        out = rubicon("export", plan, "--mspdi", back)
        self.assertEqual((out.returncode, out.stdout, out.stderr), (0, "", ""))
        self.assertEqual(rubicon("import", back, "--out", again).returncode, 0)
        texts = []
        for path, name in ((plan, os.path.basename(schedule)), (again, "b.xml")):
            with open(path, encoding="utf-8") as file:
                texts.append(file.read().replace(f'import "{name}"', "import"))
        self.assertEqual(*texts)
        return first, texts[0]

    def test_microsoft_project_there_and_back(self):
        first, plan = self.round_trip(os.path.join(SAMPLES, "house.xml"))
        self.assertIn("warning: resource 'Beton' is a material", first.stderr)
        self.assertIn("task fundament {", plan)
        root = ElementTree.parse(self.path("b.xml")).getroot()
        space = "{http://schemas.microsoft.com/project}"
        self.assertEqual(root.tag, space + "Project")
        names = [task.findtext(space + "Name") for task in root.find(space + "Tasks")]
        self.assertEqual(names[:3], ["House", "Rohbau", "Fundament"])
        numbers = [task.findtext(space + "OutlineNumber") for task in root.find(space + "Tasks")]
        self.assertEqual(numbers[:4] + numbers[7:9], ["0", "1", "1.1", "1.2", "2", "2.1"])

    def test_primavera_there_and_back(self):
        first, plan = self.round_trip(os.path.join(SAMPLES, "hall.xer"))
        self.assertIn("this text is not UTF-8: it is read as Windows-1252", first.stderr)
        self.assertIn('currency "\u20ac";', plan)

    @unittest.skipUnless(os.path.exists(REAL), "../shared/data/schependomlaan is not there")
    def test_the_apartment_building_there_and_back(self):
        first, plan = self.round_trip(REAL)
        # 114 of the 157 rows are work; plan_begins is one more. The others head or part them.
        self.assertEqual(plan.count("\n  task "), 115)
        self.assertIn("ExtendedAttribute of Task is not taken over (113 more like it)", first.stderr)

    def test_the_plan_is_printed_without_out(self):
        result = rubicon("import", os.path.join(SAMPLES, "house.xml"))
        self.assertEqual(result.returncode, 0)
        self.assertTrue(result.stdout.startswith("plan house_garage {\n"))

    def test_what_cannot_be_read_exits_with_2_and_leaves_the_old_plan(self):
        plan = self.write("old.plan", b"plan old { }\n")
        for name, content, words in (("a.xml", b"<Project>", "a.xml:1:"), ("b.xml", b"<html/>", "found 'html'"),
                                     ("c.txt", b"hello", "expected Microsoft Project XML"), ("d", b"", "found nothing")):
            result = rubicon("import", self.write(name, content), "--out", plan)
            self.assertEqual(result.returncode, 2, name)
            self.assertIn(words, result.stderr)
        result = rubicon("import", self.path("missing.xml"))
        self.assertEqual(result.returncode, 2)
        self.assertIn("there is no such file", result.stderr)
        with open(plan, encoding="utf-8") as file:
            self.assertEqual(file.read(), "plan old { }\n")

    def test_export_of_a_wrong_plan_exits_with_2(self):
        plan = self.write("wrong.plan", b"plan p { task a { takes 1 h; after b; } }")
        result = rubicon("export", plan, "--mspdi", self.path("x.xml"))
        self.assertEqual(result.returncode, 2)
        self.assertIn("wrong.plan:1:", result.stderr)
        self.assertFalse(os.path.exists(self.path("x.xml")))

    def test_export_of_any_plan_to_standard_output(self):
        result = rubicon("export", os.path.join(ROOT, "taskplans", "unit.plan"), "--mspdi", "-")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("warning: the motions of task", result.stderr)
        self.assertIn("<Task>", result.stdout)

    def test_a_full_disk_is_an_error(self):
        schedule = os.path.join(SAMPLES, "house.xml")
        self.assertEqual(rubicon("import", schedule, "--out", "/dev/full").returncode, 2)
        plan = self.path("a.plan")
        rubicon("import", schedule, "--out", plan)
        self.assertEqual(rubicon("export", plan, "--mspdi", "/dev/full").returncode, 2)


if __name__ == "__main__":
    unittest.main()
