"""Areas that do not lie flat, holes in a grid, what `rubicon guides` tells of a way over an area, areas of imported plans."""

import json
import os
import xml.etree.ElementTree
from collections import Counter

from result_case import ResultCase, rubicon

import unittest

# Its tool's z points out of the wall, at y = -0.3.
PAINTER = """robot painter {
  body mast { param x range(-1, 20) step(0.5) speed(0.5 m/s); frame trans(x, -3, 0); shape box(-0.1, -0.1, 0, 0.1, 0.1, 8); }
  body head on mast { param z range(0, 8) step(0.5) speed(0.5 m/s) start(0.5); frame trans(0, 0.5, z); shape box(-0.2, -0.2, -0.2, 0.2, 2, 0.2); }
  tool head at trans(0, 2.2, 0) * rotx(90);
  behaviour { chain { line }; }
}
"""
DRILL = """robot drill {
  body bridge { param x range(-1, 41) step(0.5) speed(0.5 m/s); frame trans(x, 0, 0); shape box(-0.1, -1, 2, 0.1, 31, 2.2); }
  body bit on bridge { param y range(0, 30) step(0.5) speed(0.5 m/s) start(0.5); param z range(-0.5, 1) step(0.1) speed(0.1 m/s) start(0.5);
                       frame trans(0, y, z); shape cylinder(0.01, 0, 1.2); }
  tool bit;
  behaviour { which { guided: chain { follow }; default: chain { line }; } }
}
"""
WALL = "component wall { shape box(0, 0, 0, 8, 0.3, 6); }"
FACADE = "area facade { at rotx(90); outline (0, 0), (8, 0), (8, 6), (0, 6); shaft (3, 2), (5, 2), (5, 4), (3, 4); }"
SLAB = "area slab { height 0.2 m; outline (0, 0), (4.8, 0), (4.8, 3), (0, 3); shaft (2, 1), (3, 1), (3, 2), (2, 2); }"


class CoverAreas(ResultCase):
    def paint(self, clauses="", area=FACADE, more=WALL):
        self.write("painter.robot", PAINTER)
        return 'plan p { robot g "painter.robot"; %s %s task coat { by g; cover facade { width 0.5 m; clearance 0.25 m; above 0.3 m; %s } } }' % (
            more, area, clauses)

    def drill(self, clauses="holes 0.6 m, 0.5 m; depth 80 mm; feed 120 mm per min; clearance 0.1 m; above 0.05 m;", area=SLAB, more=""):
        self.write("drill.robot", DRILL)
        return 'plan p { robot g "drill.robot"; %s %s task bore { by g; cover slab { %s } } }' % (area, more, clauses)

    def header(self):
        with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
            return json.loads(next(file))

    def test_an_upright_area_is_covered_round_its_windows(self):
        _, tasks = self.run_plan(self.paint("rate 120 m2 per h;"))
        cover = tasks["coat"]["cover"]
        self.assertAlmostEqual(cover["covered_area"], 8 * 6 - 2 * 2, 6)
        self.assertAlmostEqual(cover["covered"], 1, 9)
        self.assertNotIn("volume", cover)
        task = self.header()["tasks"][0]
        self.assertAlmostEqual(task["cover"]["pace"], 120 / 3600 / 0.5, 12)
        self.assertEqual(task["cover"]["pose"], [1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0])
        for goal in task["via"]:
            x, y, z = goal["pose"][3], goal["pose"][7], goal["pose"][11]
            self.assertAlmostEqual(y, -0.3, 9)
            self.assertFalse(2.751 < x < 5.249 and 1.751 < z < 4.249, (x, z))
        self.assertGreaterEqual(tasks["coat"]["duration"], 44 / 0.5 / (120 / 3600 / 0.5))
        # What stands out of the wall as a component is in the way of the tool like a shaft.
        bare = FACADE.replace("shaft (3, 2), (5, 2), (5, 4), (3, 4);", "obstacles from components;")
        frame = "component frame { shape box(0, -0.05, 0, 2, 0, 2); at trans(3, 0, 2); }"
        _, tasks = self.run_plan(self.paint("rate 120 m2 per h;", bare, WALL + frame))
        self.assertAlmostEqual(tasks["coat"]["cover"]["covered_area"], 44, 6)
        # The tool's own body meets what reaches out farther; the area does not know of it.
        _, tasks = self.run_plan(self.paint(more=WALL + "component lamp { shape box(0, -0.9, 0, 0.2, 0, 0.2); at trans(6, 0, 5); }"), expected=1)
        self.assertRegex(tasks["coat"]["reason"], "blocked by lamp.*waypoint [0-9]+ of [0-9]+ over the floor is not reached")

    def test_cold_joints_of_an_upright_area_are_verified(self):
        _, tasks = self.run_plan(self.paint("thickness 0.2 mm; rate 30 m2 per h; cold_joint after 4 min;"))
        joints = tasks["coat"]["cover"]["cold_joints"]
        self.assertGreater(joints["count"], 0)
        for place in joints["places"]:
            self.assertTrue(0 <= place["from"][1] <= 6 and 0 <= place["from"][0] <= 8, place)
        self.assertAlmostEqual(tasks["coat"]["cover"]["volume"], 44 * 0.0002, 9)

    def test_lines_run_as_they_are_told(self):
        for word, direction in (("x", 0), ("y", 90)):
            self.run_plan(self.paint("lines %s;" % word))
            self.assertEqual(self.header()["tasks"][0]["cover"]["steps"]["direction"], direction)

    def test_holes_are_drilled_in_a_grid(self):
        _, tasks = self.run_plan(self.drill())
        cover = tasks["bore"]["cover"]
        expected = {(round(0.3 + 0.6 * i, 4), round(0.25 + 0.5 * k, 4)) for i in range(8) for k in range(6)}
        left_out = {p for p in expected if 1.9 < p[0] < 3.1 and 0.9 < p[1] < 2.1}
        self.assertEqual((cover["holes"], cover["left_out"]), (len(expected - left_out), len(left_out)))
        self.assertEqual(len(left_out), 4)
        self.assertIn("bore    slab     44         4       80", self.run_result.stdout)
        # Where the bit was at its depth, once each; in at its feed, and never through the shaft.
        with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
            records = [json.loads(line) for line in file][1:]
        bottoms, last, last_t = Counter(), None, 0
        for record in records:
            q = record.get("q")
            if record["type"] == "try" and record["ok"] and last:
                if abs(q["z"] - 0.12) < 1e-9:
                    bottoms[(round(q["x"], 4), round(q["y"], 4))] += 1
                if q["z"] < last["z"] and last["z"] < 0.26:
                    self.assertGreaterEqual(record["t"] - last_t, (last["z"] - q["z"]) / 0.002 - 1e-6)
                if q["z"] < 0.2:
                    self.assertEqual((q["x"], q["y"]), (last["x"], last["y"]))
            last, last_t = q or last, record.get("t", last_t)
        self.assertEqual(bottoms, Counter(expected - left_out))
        self.assertLessEqual(cover["length"], 44 * 0.6 + 6)

        def drift(result):
            result.header["tasks"][0]["via"][1]["pose"][3] += 0.05
        self.assertIn("goes on with the tool", self.faults_of(drift))

    def test_guides_keep_off_shafts_that_nothing_stands_in(self):
        area = "area slab { outline (0, 0), (12, 0), (12, 6), (0, 6); shaft (4, 1), (8, 1), (8, 5), (4, 5); }"
        for kind in ("rrt_connect", "prm"):
            guide = "guide way %s%s" % (kind, "" if "{" in kind else ";")
            self.run_plan(self.drill("width 1 m; clearance 0.3 m; above 0.1 m; order cells; guide way;", area, guide))
            with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
                records = [json.loads(line) for line in file]
            goal, last, travelled = 0, None, 0
            for record in records[1:]:
                if record["type"] == "goal":
                    goal = record["k"] - 1
                if record["type"] == "try" and record["ok"]:
                    for share in (0.25, 0.5, 0.75, 1):
                        if goal == 0:
                            break
                        x, y = (last[p] + share * (record["q"][p] - last[p]) for p in ("x", "y"))
                        self.assertFalse(3.75 < x < 8.25 and 0.75 < y < 5.25, (kind, x, y))
                    travelled += record["command"] == "follow"
                last = record.get("q", last)
            self.assertGreater(travelled, 5)

        def over_the_shaft(result):
            result.header["tasks"][0]["cover"]["floor"]["shafts"][0] = [0, 0.6, 12, 0.6, 12, 5.4, 0, 5.4]
        self.assertIn("into shaft 1 of its area", self.faults_of(over_the_shaft))

        def over_a_column(result):
            result.header["tasks"][0]["cover"]["floor"]["columns"].append([2, 3, 3, True])
        self.assertIn("into column 1 of its area", self.faults_of(over_a_column))

    def test_guides_tells_what_the_way_does(self):
        path = self.write("p.plan", self.paint())
        told = rubicon("guides", path, "--format", "json")
        self.assertEqual(told.returncode, 0, told.stderr)
        way = json.loads(told.stdout)
        self.assertEqual((way["covered"], way["inside_holes"], way["outside"]), (100, 0, 0))
        self.assertAlmostEqual(way["bound"], 44 / 0.5, 6)
        self.assertGreaterEqual(way["length"], way["bound"])
        heads, values = rubicon("guides", path, "coat", "--format", "csv").stdout.splitlines()
        self.assertEqual(dict(zip(heads.split(","), values.split(",")))["cells"], "%d" % way["cells"])
        self.assertRegex(rubicon("guides", path).stdout, r"of what the tool can reach, % +100\.00")
        svg = os.path.join(self.folder, "steps.svg")
        self.assertEqual(rubicon("guides", path, "--svg", svg).returncode, 0)
        root = xml.etree.ElementTree.parse(svg).getroot()
        groups = [each for each in root if each.tag.endswith("}g")]
        headings = [next(part.text for part in group if part.tag.endswith("}text")) for group in groups]
        self.assertEqual([heading.split(":")[0] for heading in headings],
                         ["1. Beams and edges, cut where they meet", "2. Cells", "3. Which cells touch, and along what", "4. Order of the cells",
                          "5. Lines at work", "6. The way"])
        self.assertEqual(rubicon("guides", path, "--svg", path).returncode, 2)
        self.assertEqual(rubicon("guides", self.write("d.plan", self.drill()), "--svg", svg).returncode, 0)
        self.assertIn("Holes", xml.etree.ElementTree.parse(svg).getroot()[3][0].text)

    def test_areas_of_imported_plans_have_dotted_names(self):
        self.write("level.plan", "plan level { parameter wide = 8 m; %s }" % FACADE.replace("(8, ", "(wide, "))
        plan = self.paint("", "import \"level.plan\" as level;").replace("cover facade", "cover level.facade")
        schedule, tasks = self.run_plan(plan)
        self.assertEqual(tasks["coat"]["cover"]["area"], "level.facade")
        # The task may stand in the plan that is imported, too.
        self.write("work.plan", self.paint())
        _, tasks = self.run_plan('plan q { import "work.plan" as work; }')
        self.assertEqual(tasks["work.coat"]["cover"]["area"], "work.facade")
        wrong = rubicon("check", self.write("p.plan", plan.replace("cover level.facade", "cover level.facad")))
        self.assertIn("did you mean level.facade?", wrong.stderr)

    def test_mistakes_are_told_at_their_places(self):
        for text, message in (
                (self.paint(area=FACADE.replace("at rotx(90);", "at rotx(90); height 1 m;")), "has a frame and a height as well"),
                (self.paint(area=FACADE.replace("at rotx(90);", "at rotx(90); at rotx(90);")), "the frame of area 'facade' is given twice"),
                (self.paint("lines z;"), "lines is shortest, fewest, x or y, found 'z'"),
                (self.paint("rate 120 m per h;"), "or an area per time up to"),
                (self.paint("depth 80 mm;"), "depth is of holes, and this cover drills none"),
                (self.drill("holes 0.6 m, 0.5 m;"), "holes do not say how deep they are"),
                (self.drill("holes 0.6 m; depth 80 mm;"), "expected ',' and how far holes are apart along y"),
                (self.drill("holes 0 m, 1 m; depth 80 mm;"), "the distance of holes must be between"),
                (self.drill("holes 1 mm, 1 mm; depth 80 mm;"), "the grid of holes has 14400000 places; a task has up to 5000"),
                (self.drill("holes 1 m, 1 m; depth 80 mm; feed 3 m;"), "expected a speed up to 10 m/s as feed"),
                (self.drill("holes 1 m, 1 m; depth 80 mm; width 1 m;"), "a pattern of holes has no strips: width says nothing"),
                (self.drill("holes 1 m, 1 m; depth 80 mm; clearance 5 m;"), "there is no room for a hole")):
            checked = rubicon("check", self.write("p.plan", text))
            self.assertEqual(checked.returncode, 2, text + checked.stderr)
            self.assertIn(message, checked.stderr)


if __name__ == "__main__":
    unittest.main()
