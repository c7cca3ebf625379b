"""The flow of material: what a command tells of components and storage places, against figures worked out by hand."""

import csv
import io
import json
import os
import unittest

from result_case import ResultCase, rubicon

EXAMPLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples", "09_two_machines")

CRATE = "component %s { shape box(-0.5, -0.5, 0, 0.5, 0.5, 1); at trans(%s, 0, 0); grip trans(0, 0, 1); mass %s; }"
SITE = """plan crates {
  robot hoist "hoist.robot" { start x 2, z 6; }
  site box(0, -5, -1, 30, 5, 0);
  storage yard box(0, -5, 0, 3, 5, 2);
  storage yard box(3, -5, 0, 6, 5, 2);
  storage rack box(13, -1, 0, 15, 1, 2);
""" + "\n".join(CRATE % each for each in (("a", 2, 500), ("b", 5, 700), ("idle", 28, 1))) + """
  task a1 { by hoist; move a to trans(14, 0, 0); }
  task b1 { by hoist; move b to trans(24, 0, 0); after a1; }
  task a2 { by hoist; move a to trans(20, 0, 0); after b1; }
}
"""


class Flow(ResultCase):
    def setUp(self):
        super().setUp()
        for name in ("hoist.robot", "give_way.motion"):
            with open(os.path.join(EXAMPLE, name), encoding="utf-8") as file:
                self.write(name, file.read())
        self.plan = self.write("site.plan", SITE)

    def flow(self, source, *options):
        told = rubicon("flow", source, *options)
        self.assertEqual(told.returncode, 0, told.stderr)
        return told.stdout

    def test_figures(self):
        # x at 1 m/s, z at 0.5 m/s. Down to a: 10 s. a1: up 5 m, along 12, down 5. b1: the same way up and down, 9 m to it and 19 m
        # with it. a2: 10 m back, 6 m with it.
        flow = json.loads(self.flow(self.plan, "--format", "json"))
        self.assertEqual(flow["end"], 166)
        a, b, idle = flow["components"]
        self.assertEqual(a, {"name": "a", "mass": 500, "from": "yard", "to": "", "removed": False, "lifts": 2, "waited": 10 + 98,
                             "carried": 32 + 26, "distance": 38, "refused": 0})
        self.assertEqual(b, {"name": "b", "mass": 700, "from": "yard", "to": "", "removed": False, "lifts": 1, "waited": 71,
                             "carried": 39, "distance": 29, "refused": 0})
        self.assertEqual((idle["lifts"], idle["carried"], idle["distance"], idle["waited"]), (0, 0, 0, 0))
        yard, rack = flow["storages"]
        self.assertEqual(yard, {"name": "yard", "in": 0, "out": 2, "mean_stay": 40.5, "stock": [
            {"t": 0, "count": 2, "mass": 1200}, {"t": 10, "count": 1, "mass": 700}, {"t": 71, "count": 0, "mass": 0}]})
        self.assertEqual(rack, {"name": "rack", "in": 1, "out": 1, "mean_stay": 98, "stock": [
            {"t": 0, "count": 0, "mass": 0}, {"t": 42, "count": 1, "mass": 500}, {"t": 140, "count": 0, "mass": 0}]})

    def test_table_and_csv(self):
        self.assertEqual(self.flow(self.plan), """crates: the flow of material

component  from  to  lifts   waited  carried  distance  refused
a          yard  -       2  0:01:48  0:00:58    38.0 m        0
b          yard  -       1  0:01:11  0:00:39    29.0 m        0
together                 3           0:01:37    67.0 m        0
1 more was never moved.

storage  at start  in  out  at end  most     when  mean stay
yard            2   0    2       0     2  0:00:00    0:00:41
rack            0   1    1       0     1  0:00:42    0:01:38
""")
        rows = list(csv.DictReader(io.StringIO(self.flow(self.plan, "--format", "csv"))))
        self.assertEqual([row["component"] for row in rows], ["a", "b", "idle"])
        self.assertEqual((rows[0]["distance"], rows[0]["carried"]), ("38.000", "58"))

    def test_refused_steps_and_rejected_tasks(self):
        # A wall that the hoist cannot lift b over: what was tried does not count, since the task is undone.
        wall = "component wall { shape box(17, -5, 0, 18, 5, 8); }\n  task a1"
        flow = json.loads(self.flow(self.write("site.plan", SITE.replace("task a1", wall)), "--format", "json"))
        b = flow["components"][1]
        self.assertEqual((b["lifts"], b["distance"], b["refused"], b["to"]), (0, 0, 0, "yard"))

    def test_a_result_tells_the_same_as_its_plan(self):
        out = os.path.join(self.folder, "result")
        self.assertEqual(rubicon("run", self.plan, "--out", out).returncode, 0)
        self.assertEqual(self.flow(out, "--format", "json"), self.flow(self.plan, "--format", "json"))

    def test_bad_input(self):
        self.assertEqual(rubicon("flow", os.path.join(self.folder, "nothing.plan")).returncode, 2)
        out = os.path.join(self.folder, "short")
        self.assertEqual(rubicon("run", self.plan, "--out", out, "--trace-detail", "tasks").returncode, 0)
        told = rubicon("flow", out)
        self.assertEqual(told.returncode, 2)
        self.assertIn("step", told.stderr)


if __name__ == "__main__":
    unittest.main()
