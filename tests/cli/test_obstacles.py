"""Areas with `obstacles from components`: what stands there when the floor is covered need not be said twice."""

import json
import os
import re
import subprocess
import tempfile
import unittest

RUBICON = os.environ["RUBICON"]
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCREED = os.path.join(ROOT, "examples", "18_cover_a_floor", "screed.robot")

HALL = "area hall { height 0 m; outline (0, 0), (8, 0), (8, 6), (0, 6); shaft (5, 2), (6, 2), (6, 3), (5, 3); %s }"
LAY = "task lay { by screed; cover hall { width 1 m; clearance 0.2 m; above 0.1 m; thickness 0.06 m; rate 30 m3 per h; } %s }"


def rubicon(*arguments, cwd=None):
    return subprocess.run([RUBICON, *arguments], capture_output=True, text=True, timeout=120, cwd=cwd)


class Obstacles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        with open(SCREED, encoding="utf-8") as file:
            self.write("screed.robot", file.read())

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)

    def plan(self, area="obstacles from components;", *, components="", tasks="", lay=""):
        self.write("lay.plan", "plan lay_a_floor {\n  robot screed \"screed.robot\";\n%s\n%s\n%s\n%s\n}\n"
                   % (components, HALL % area, tasks, LAY % lay))

    def cover(self):
        """Of the run: its covers in schedule.json."""
        out = os.path.join(self.folder, "out")
        ran = rubicon("run", "lay.plan", "--out", out, cwd=self.folder)
        self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)
        checked = rubicon("verify", out)
        self.assertEqual(checked.returncode, 0, checked.stdout)
        with open(os.path.join(out, "schedule.json"), encoding="utf-8") as file:
            tasks = json.load(file)["tasks"]
        subprocess.run(["rm", "-r", out], check=True)
        return next(each["cover"] for each in tasks if each["task"] == "lay")

    def refused(self, message, code="P54"):
        told = rubicon("check", "--format", "json", "lay.plan", cwd=self.folder).stdout
        ran = rubicon("check", "lay.plan", cwd=self.folder)
        self.assertEqual(ran.returncode, 2, ran.stdout + ran.stderr)
        self.assertRegex(ran.stdout + ran.stderr, re.compile(message, re.S))
        self.assertIn(code, told)

    COLUMN = "component column { shape box(-0.15, -0.15, 0, 0.15, 0.15, 1); at trans(2.5, 4, 0); }"

    def test_a_column_need_not_be_said_twice(self):
        self.plan("column (2.5, 4), 0.3 m;", components=self.COLUMN)
        said = self.cover()
        self.plan(components=self.COLUMN)
        self.assertEqual(self.cover(), said)
        # Said as well, it counts once.
        self.plan("column (2.5, 4), 0.3 m; obstacles from components;", components=self.COLUMN)
        self.assertEqual(self.cover(), said)

    def test_round_columns_and_walls(self):
        self.plan("round_column (2.5, 4), 0.4 m; shaft (6, 4.5), (7.5, 4.5), (7.5, 4.7), (6, 4.7);")
        said = self.cover()
        self.plan(components="""
component post { shape cylinder(0.2, -1, 1); at trans(2.5, 4, 0); }
component wall { shape box(0, 0, 0, 1.5, 0.2, 1); at trans(6, 4.5, 0); }""")
        self.assertEqual(self.cover(), said)

    def test_only_what_stands_in_the_layer_counts(self):
        self.plan("")
        free = self.cover()
        self.plan(components="""
component formwork { shape box(-1, -1, -0.3, 9, 7, -0.1); at trans(0, 0, 0); }
component lamp { shape box(-0.2, -0.2, 3, 0.2, 0.2, 3.2); at trans(2.5, 4, 0); }
component outside { shape box(0, 0, 0, 0.5, 0.5, 2); at trans(8.6, 3, 0); }""" + "\nsupport off;")
        self.assertEqual(self.cover(), free)

    def test_a_wall_at_the_border_keeps_its_clearance(self):
        self.plan(components="component wall { shape box(0, 0, -0.5, 0.5, 6, 0.5); at trans(7.5, 0, 0); } support off;")
        cover = self.cover()
        self.assertAlmostEqual(cover["covered_area"], 8 * 6 - 1 - 0.5 * 6, delta=0.05)

    def test_what_parts_the_floor_or_fills_it_is_an_error(self):
        self.plan(components="component wall { shape box(0, 0, 0, 0.2, 6, 2); at trans(3, 0, 0); }")
        self.refused("components part area 'hall' into 2 pieces while 'lay' covers it.*cover each piece")
        self.plan(components="component heap { shape box(-1, -1, 0, 9, 7, 2); at trans(0, 0, 0); }")
        self.refused("components stand on all of area 'hall'")

    def test_the_moment_counts(self):
        pallet = "component pallet { shape box(-0.5, -0.5, 0, 0.5, 0.5, 1); at trans(2.5, 4, 0); } crew hands;"
        clear = "task clear { by hands; remove pallet; takes 10 min; %s }"
        self.plan("")
        free = self.cover()
        self.plan(components=pallet)
        stands = self.cover()
        self.assertLess(stands["covered_area"], free["covered_area"])
        # Taken away before: free. After: it stands. Neither: said, with what to do.
        self.plan(components=pallet, tasks=clear % "", lay="after clear;")
        self.assertEqual(self.cover(), free)
        self.plan(components=pallet, tasks=clear % "after lay;")
        self.assertEqual(self.cover(), stands)
        self.plan(components=pallet, tasks=clear % "")
        self.refused(r"component 'pallet' may or may not stand on area 'hall' while 'lay' covers it: task 'clear'.*"
                     r"write after clear; in 'lay', or after lay; in 'clear'")
        # A link to the start, or with a negative lag, makes nothing sure; one over another task does.
        self.plan(components=pallet, tasks=clear % "", lay="after clear SS + 1 h;")
        self.refused("may or may not stand")
        self.plan(components=pallet, tasks=clear % "", lay="after clear - 1 min;")
        self.refused("may or may not stand")
        self.plan(components=pallet, tasks=clear % "" + " task tea { by hands; takes 5 min; after clear; }", lay="after tea SS;")
        self.assertEqual(self.cover(), free)

    def test_grammar(self):
        self.plan("obstacles from walls;")
        self.refused("expected components after obstacles from", "P00")
        self.plan("obstacles;")
        self.refused("expected from components after obstacles", "P00")
        self.plan("obstacles from components; obstacles from components;")
        self.refused("given twice", "P02")
        self.plan()
        self.assertEqual(rubicon("fmt", "lay.plan", cwd=self.folder).returncode, 0)
        with open(os.path.join(self.folder, "lay.plan"), encoding="utf-8") as file:
            self.assertIn("obstacles from components;", file.read())


if __name__ == "__main__":
    unittest.main()
