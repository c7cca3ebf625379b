"""What a plan says of components and tasks only to hand it on stands wherever a result is read."""

import csv
import json
import os
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree

RUBICON = os.environ["RUBICON"]
PROJECT = "{http://schemas.microsoft.com/project}"

ROBOT = """robot gantry {
  body bridge { param x range(-50, 50) step(1) speed(1); frame trans(x, 0, 0); }
  body hoist on bridge { param z range(-10, 30) step(1) speed(1); frame trans(0, 0, z); }
  tool hoist;
  behaviour "g.motion";
}
"""
SCRIPT = "chain { move_to(x, goal(x)), move_to(z, goal(z)) };\n"
PLAN = """plan yard {
  robot g "g.robot";
  crew c;
  component column_1 {
    name "Stütze 1"; storey "0"; type "IfcColumn"; guid "0UEcPQQZ"; attribute fire "60 min; R";
    shape box(-0.2, -0.2, 0, 0.2, 0.2, 3); at trans(10, 0, 0); grip trans(0, 0, 3);
  }
  component bare { shape box(-0.2, -0.2, 0, 0.2, 0.2, 3); at trans(10, 5, 0); grip trans(0, 0, 3); }
  task set_1 { name "Stütze 1 setzen, sehr vorsichtig und nur bei Tag"; attribute shift "2"; by g; move column_1 to trans(20, 0, 0); }
  task paint { attribute storey "7"; by c; takes 1 min; after set_1; }
}
"""
NAMELESS = PLAN.replace('name "Stütze 1 setzen, sehr vorsichtig und nur bei Tag"; ', "")


def rubicon(*arguments):
    done = subprocess.run([RUBICON, *arguments], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    return done.stdout


class Attributes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = cls.temporary.name
        for name, text in (("g.robot", ROBOT), ("g.motion", SCRIPT), ("yard.plan", PLAN), ("nameless.plan", NAMELESS)):
            with open(os.path.join(cls.folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        cls.plan = os.path.join(cls.folder, "yard.plan")
        cls.out = os.path.join(cls.folder, "out")
        cls.table = rubicon("run", cls.plan, "--out", cls.out)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_json(self):
        with open(os.path.join(self.out, "schedule.json"), encoding="utf-8") as file:
            schedule = json.load(file)
        set_1, paint = schedule["tasks"]
        self.assertEqual(set_1["component"], "column_1")
        self.assertEqual(set_1["attributes"], {"name": "Stütze 1 setzen, sehr vorsichtig und nur bei Tag", "shift": "2"})
        self.assertEqual(paint["attributes"], {"storey": "7"})
        self.assertNotIn("component", paint)
        self.assertEqual(schedule["components"], [{"component": "column_1", "attributes": {
            "name": "Stütze 1", "storey": "0", "type": "IfcColumn", "guid": "0UEcPQQZ", "fire": "60 min; R"}}])

    def test_csv_has_them_in_its_last_columns(self):
        with open(os.path.join(self.out, "schedule.csv"), encoding="utf-8", newline="") as file:
            rows = list(csv.reader(file))
        self.assertEqual(rows[0][-7:], ["name", "component", "component_name", "storey", "type", "guid", "attributes"])
        self.assertEqual(rows[0][:2] + rows[0][-15:-7],
                         ["task", "robot", "begins", "ends", "due", "late", "baseline_start", "baseline_finish",
                          "total_float", "free_float"])
        self.assertEqual(rows[1][-7:], ["Stütze 1 setzen, sehr vorsichtig und nur bei Tag", "column_1", "Stütze 1", "0",
                                        "IfcColumn", "0UEcPQQZ", "shift=2; fire=60 min; R"])
        self.assertEqual(rows[2][-7:], ["", "", "", "7", "", "", ""])

    def test_an_export_gives_the_same_table(self):
        with open(os.path.join(self.out, "schedule.csv"), encoding="utf-8") as file:
            self.assertEqual(rubicon("export", self.out, "--csv", "-"), file.read())

    def test_the_table_has_names_where_there_are_any(self):
        head, first, second = self.table.splitlines()[:3]
        self.assertEqual(head.split()[:3], ["task", "name", "robot"])
        self.assertIn("Stütze 1 setzen, sehr vorsi…  g", first)
        self.assertEqual(second.split()[:2], ["paint", "c"])
        nameless = rubicon("run", os.path.join(self.folder, "nameless.plan"))
        self.assertEqual(nameless.splitlines()[0].split()[:2], ["task", "robot"])

    def test_why(self):
        told = rubicon("why", self.out, "set_1")
        self.assertIn('  set_1: name "Stütze 1 setzen, sehr vorsichtig und nur bei Tag", shift "2"\n', told)
        self.assertIn('  column_1: name "Stütze 1", storey "0", type "IfcColumn", guid "0UEcPQQZ", fire "60 min; R"\n', told)
        story = json.loads(rubicon("why", self.out, "set_1", "--format", "json"))
        self.assertEqual(story["attributes"]["shift"], "2")
        self.assertEqual(story["component"]["name"], "column_1")
        self.assertEqual(story["component"]["attributes"]["guid"], "0UEcPQQZ")
        self.assertNotIn("component", json.loads(rubicon("why", self.out, "paint", "--format", "json")))

    def test_gltf(self):
        film = os.path.join(self.folder, "film.gltf")
        rubicon("export", self.out, "--gltf", film)
        with open(film, encoding="utf-8") as file:
            nodes = [node for node in json.load(file)["nodes"] if node["name"] == "column_1"]
        self.assertEqual({node["extras"]["is"] for node in nodes}, {"waiting", "carried", "placed"})
        for node in nodes:
            self.assertEqual(node["extras"]["attributes"]["guid"], "0UEcPQQZ")

    def test_microsoft_project_has_them_in_text_columns(self):
        for source in (self.plan, self.out):
            root = xml.etree.ElementTree.fromstring(rubicon("export", source, "--mspdi", "-"))
            fields = {field.findtext(PROJECT + "FieldID"): field.findtext(PROJECT + "Alias")
                      for field in root.find(PROJECT + "ExtendedAttributes")}
            task = next(each for each in root.iter(PROJECT + "Task") if each.findtext(PROJECT + "Name", "").startswith("Stütze"))
            texts = {fields[value.findtext(PROJECT + "FieldID")]: value.findtext(PROJECT + "Value")
                     for value in task.findall(PROJECT + "ExtendedAttribute")}
            self.assertEqual(texts, {"shift": "2", "storey": "0", "type": "IfcColumn", "guid": "0UEcPQQZ", "fire": "60 min; R"})
            self.assertIn("188743731", fields)

    def test_a_name_that_was_changed_in_an_imported_plan_goes_out(self):
        first, plan, second = (os.path.join(self.folder, name) for name in ("first.xml", "back.plan", "second.xml"))
        rubicon("export", self.plan, "--mspdi", first)
        rubicon("import", first, "--out", plan)
        with open(plan, encoding="utf-8") as file:
            text = file.read()
        self.assertIn('name "Stütze 1 setzen, sehr vorsichtig und nur bei Tag";', text)
        with open(plan, "w", encoding="utf-8") as file:
            file.write(text.replace("sehr vorsichtig und nur bei Tag", "Nachtschicht"))
        rubicon("export", plan, "--mspdi", second)
        names = [task.findtext(PROJECT + "Name") for task in xml.etree.ElementTree.parse(second).iter(PROJECT + "Task")]
        self.assertIn("Stütze 1 setzen, Nachtschicht", names)
        self.assertNotIn("Stütze 1 setzen, sehr vorsichtig und nur bei Tag", names)


if __name__ == "__main__":
    unittest.main()
