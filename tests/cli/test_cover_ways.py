"""Ways between strips of a floor: turns with a radius, and guides round what stands in the machine's way."""

import json
import math
import os
import unittest

from result_case import ResultCase, rubicon

SWEEPER = """robot sweeper {
  body chassis { param x range(-5, 45) step(0.5) speed(1 m/s); param y range(-5, 45) step(0.5) speed(1 m/s); param theta cyclic step(10) speed(60 deg/s);
                 frame trans(x, y, 0) * rotz(theta); shape box(-0.5, -0.3, 0, 0.5, 0.3, 1); }
  tool chassis;
  behaviour { chain { line }; }
}
"""
# Its mast is wider than its tool's point: it needs more room than a clearance of 0.1 m.
GANTRY = """robot gantry {
  body bridge { param x range(-1, 41) step(0.5) speed(0.5 m/s); frame trans(x, 0, 0); shape box(-0.1, -1, 2, 0.1, 31, 2.2); }
  body mast on bridge { param y range(0, 30) step(0.5) speed(0.5 m/s) start(0.5); frame trans(0, y, 0.1); shape box(-0.3, -0.3, 0, 0.3, 0.3, 2); }
  tool mast;
  behaviour { which { working: chain { line }; guided: chain { follow }; default: chain { line }; } }
}
"""
FLOOR = "area deck { outline (0, 0), (16, 0), (16, 12), (0, 12); column (8, 6), 0.3 m; }"
BARS = "component bars { shape box(-0.15, -0.15, 0, 0.15, 0.15, 0.8); at trans(8, 6, 0); }"


class CoverWays(ResultCase):
    def plan(self, clauses, robot=SWEEPER, more="", floor=FLOOR, task=""):
        self.write("machine.robot", robot)
        return 'plan p { robot g "machine.robot"; %s %s task lay { by g; cover deck { width 1 m; clearance 0.6 m; %s } %s } }' % (floor, more, clauses, task)

    def header(self):
        with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
            return json.loads(next(file))

    def strips(self):
        """The two ends of each strip, the lesser first."""
        task = self.header()["tasks"][0]
        poses = [goal["pose"] for goal in task["via"]] + [task["go"]["pose"]]
        places = [(round(pose[3], 4), round(pose[7], 4)) for pose in poses]
        return sorted(tuple(sorted(places[i - 1:i + 1])) for i, works in enumerate(task["cover"]["working"]) if works)

    def test_turns_have_the_radius(self):
        _, tasks = self.run_plan(self.plan("turn_radius 1.5 m;", more=BARS))
        cover = tasks["lay"]["cover"]
        self.assertGreater(cover["covered"], 0.85)
        task = self.header()["tasks"][0]
        self.assertEqual(task["cover"]["turn_radius"], 1.5)
        poses = [goal["pose"] for goal in task["via"]] + [task["go"]["pose"]]
        length, turns, before = 0, 0, 0
        for a, b in zip(poses, poses[1:]):
            turned = math.degrees(math.atan2(b[4], b[0]) - math.atan2(a[4], a[0]))
            turned = (turned + 180) % 360 - 180
            chord = math.dist((a[3], a[7]), (b[3], b[7]))
            self.assertGreaterEqual(chord, 3 * math.sin(math.radians(abs(turned)) / 2) - 3e-4)
            length += math.radians(abs(turned)) * 1.5 if abs(turned) > 1e-6 else chord
            side = 0 if abs(turned) < 1e-6 else math.copysign(1, turned)
            turns += side != 0 and side != before
            before = side
        self.assertAlmostEqual(cover["length"], length, delta=0.05)
        self.assertLessEqual(abs(cover["turns"] - turns), 4)  # arcs of less than a degree are none
        # The machine is turned as its way runs.
        with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
            records = [json.loads(line) for line in file][1:]
        last = None
        for record in records:
            if record["type"] == "goal" and record["k"] > 1:
                pose = poses[record["k"] - 2]
                self.assertAlmostEqual(math.cos(math.radians(last["theta"])), pose[0], 4)
                self.assertAlmostEqual(math.sin(math.radians(last["theta"])), pose[4], 4)
            last = record.get("q", last)

    def test_verify_finds_a_turn_that_is_too_narrow(self):
        self.run_plan(self.plan("turn_radius 1.5 m;"))
        self.assertIn("with a radius of 1.6 m", self.faults_of(lambda result: result.header["tasks"][0]["cover"].update(turn_radius=1.6)))

        def turn_back(result):
            pose = result.header["tasks"][0]["via"][0]["pose"]
            for i in (0, 1, 4, 5):
                pose[i] = -pose[i]
        self.assertIn("does not lie ahead", self.faults_of(turn_back))

    def test_guides_lead_between_strips(self):
        clauses = "clearance 0.1 m; above 0.1 m;"
        floor = "area deck { outline (0, 0), (8, 0), (8, 6), (0, 6); shaft (5, 2), (6, 2), (6, 3), (5, 3); }"
        kiosk = "component kiosk { shape box(5, 2, 0, 6, 3, 1.5); }"
        plain = self.plan(clauses, robot=GANTRY, more=kiosk, floor=floor).replace("clearance 0.6 m; ", "")
        _, tasks = self.run_plan(plain, expected=1)
        self.assertRegex(tasks["lay"]["reason"], "blocked by kiosk")
        strips = self.strips()
        guided = plain.replace("cover deck {", "cover deck { guide way;").replace("task lay", "guide way rrt_connect; task lay")
        _, tasks = self.run_plan(guided)
        self.assertEqual(tasks["lay"]["result"], "done")
        self.assertGreater(tasks["lay"]["cover"]["covered"], 0.99)
        self.assertEqual(self.strips(), strips)
        with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
            records = [json.loads(line) for line in file]
        working = records[0]["tasks"][0]["cover"]["working"]
        guides, goal = 0, 0
        for record in records[1:]:
            if record["type"] == "goal":
                goal = record["k"] - 1
            if record["type"] in ("guide", "way_point"):
                self.assertFalse(working[goal], "on a strip nothing leads")
                guides += record["type"] == "guide"
            if record["type"] == "try" and record["ok"]:
                self.assertEqual(record["command"], "line" if working[goal] else "follow")
        self.assertGreater(guides, 5)
        self.assertTrue(any(record["type"] == "guide" and len(record["way"]) > 4 for record in records), "one leads round the column")

    def test_mistakes_are_told_at_their_places(self):
        for clauses, message in (("turn_radius 1 m; order cells;", "no order by cells"),
                                 ("turn_radius 9 m;", "with turns of 9 m the machine has no room"),
                                 ("turn_radius -1 m;", "cannot be negative"),
                                 ("turn_radius 1 s;", "needs a length"),
                                 ("turn_radius 1 m; turn_radius 2 m;", "given twice"),
                                 ("guide way;", "unknown guide 'way'"),
                                 ("guide;", "expected the name of a guide"),
                                 ("turn_radius 1 m; guide way;", "no guide")):
            checked = rubicon("check", self.write("p.plan", self.plan(clauses)))
            self.assertEqual(checked.returncode, 2, clauses + checked.stdout)
            self.assertIn(message, checked.stderr, clauses)
        checked = rubicon("check", self.write("p.plan", self.plan("", task="guide way;", more="guide way rrt_connect;")))
        self.assertIn("stands in the cover", checked.stderr)
        # Strips that no turn leads to are left out, and that is said.
        narrow = "area deck { outline (0, 0), (30, 0), (30, 2.4), (0, 2.4); }"
        checked = rubicon("check", self.write("p.plan", self.plan("turn_radius 1.2 m;", floor=narrow)))
        self.assertEqual(checked.returncode, 0, checked.stderr)
        self.assertIn("left out: with turns of 1.2 m there is no room", checked.stderr)
        # Who cannot turn cannot follow such a way.
        _, tasks = self.run_plan(self.plan("turn_radius 1.5 m;", robot=GANTRY), expected=1)
        self.assertIn("goal out of reach", tasks["lay"]["reason"])


if __name__ == "__main__":
    unittest.main()
