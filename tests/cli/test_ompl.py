"""Guides by planners of OMPL: what runs and is verified, names that are wrong, limits, and a build without OMPL."""

import json
import os
import shutil
import subprocess
import unittest

from guide_case import GuideCase
from result_case import rubicon, RUBICON

TASKPLANS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "taskplans")
PLAN = """plan p {
  robot car "car.robot";
  component wall { shape box(-0.5, -6, 0, 0.5, 6, 2); at trans(5, 0, 0); }
  guide way ompl "%s" { %s }
  guide other ompl "%s" { seed 5; checks 2000; }
  task over { by car; go x 10, y 0; guide way; }
  task back { by car; go x 0, y 0; guide other; after over; }
}
"""


class Ompl(GuideCase):
    def plan(self, planner="RRTConnect", clauses="", other="BITstar"):
        return PLAN % (planner, clauses, other)

    def checked(self, planner, clauses="", kind=None):
        text = self.plan("@", clauses)
        path = self.write("bad.plan", text.replace('ompl "@"', kind or f'ompl "{planner}"'))
        told = rubicon("check", path)
        self.assertEqual(told.returncode, 2, told.stdout + told.stderr)
        return told.stderr

    def test_ways_are_driven_and_verified_and_the_same_each_time(self):
        _, tasks = self.run_plan(self.plan(clauses='seed 3; step 5; set "intermediate_states" 1;'))
        self.assertEqual([task["result"] for task in tasks.values()], ["done", "done"])
        self.assertEqual(rubicon("verify", self.out).returncode, 0)
        first = [(plan["kind"], plan["way"]) for plan in self.records("guide")]
        self.assertEqual([kind for kind, _ in first], ["ompl RRTConnect", "ompl BITstar"])
        self.run_plan(self.plan(clauses='seed 3; step 5; set "intermediate_states" 1;'))
        self.assertEqual([(plan["kind"], plan["way"]) for plan in self.records("guide")], first)
        self.run_plan(self.plan(clauses='seed 4; step 5; set "intermediate_states" 1;'))
        again = [(plan["kind"], plan["way"]) for plan in self.records("guide")]
        self.assertNotEqual(again[0], first[0])

        def another_way(result):
            next(record for record in result.records if record["type"] == "guide")["way"][2] -= 0.3

        self.assertIn("waypoint", self.faults_of(another_way))

    def test_wrong_names_and_values_are_told_with_what_is_meant(self):
        told = self.checked("RRTConect")
        self.assertIn("OMPL has no geometric planner 'RRTConect'; did you mean RRTConnect?", told)
        self.assertIn("4:18: ", told)
        self.assertIn("planners are ABITstar, AITstar", told)
        for planner in ("pRRT", "pSBL", "CForest", "AnytimePathShortening"):
            self.assertRegex(self.checked(planner), f"guides do not take {planner} of OMPL: it runs .*in threads")
        self.assertIn("take LazyPRM", self.checked("PRM"))
        self.assertIn("ompl needs the name of a planner in quotes", self.checked("", kind="ompl"))
        self.assertIn("rrt takes no name of a planner", self.checked("", kind='rrt "RRT"'))
        self.assertIn("RRT of OMPL has no parameter 'rnge'; did you mean range?", self.checked("RRT", 'set "rnge" 1;'))
        self.assertIn("range must be from 0 to 1e+09", self.checked("RRT", 'set "range" -1;'))
        self.assertIn('set "range" is given twice', self.checked("RRT", 'set "range" 1; set "range" 2;'))
        self.assertIn("a number", self.checked("RRT", 'set "range";'))
        self.assertIn("turn_radius is for vehicles", self.checked("RRT", "turn_radius 5 m;"))
        self.assertIn("rrt has no clause 'set'", self.checked("", 'set "range" 1;', kind="rrt"))

    def test_limits_and_no_way_are_reasons(self):
        closed = self.plan("RRTstar", "checks 300;", "EST").replace("-6, 0, 0.5, 6", "-20.5, 0, 0.5, 20.5")
        told = rubicon("run", self.write("site.plan", closed), "--out", self.out)
        self.assertEqual(told.returncode, 1, told.stdout + told.stderr)
        plan = self.records("guide")[0]
        self.assertFalse(plan["found"])
        self.assertLessEqual(plan["checks"], 300)
        self.assertIn("guide way (ompl RRTstar): no way", told.stdout)
        told = rubicon("run", self.write("site.plan", closed.replace("checks 300;", "nodes 40;")), "--out", self.out)
        self.assertEqual(told.returncode, 1, told.stdout + told.stderr)
        self.assertRegex(self.records("guide")[0]["cause"], "^no way found with [34][0-9] nodes")

    def test_the_shipped_plan_does_its_work_whatever_ways_it_goes(self):
        """taskplans/trench_by_ompl.plan: what holds by every version of OMPL, shown by other seeds and another planner as well."""
        with open(os.path.join(TASKPLANS, "trench_by_ompl.plan"), encoding="utf-8") as file:
            text = file.read().replace("../robots", os.path.join(TASKPLANS, "..", "robots"))
        ways = set()
        for change in (("", ""), ("seed 3", "seed 4"), ("BITstar", "AITstar")):
            _, tasks = self.run_plan(text.replace(*change))  # done, and verify finds no contact and no fault
            self.assertEqual({task["result"] for task in tasks.values()}, {"done"})
            plans = self.records("guide")
            self.assertIn("ompl RRTConnect", {plan["kind"] for plan in plans if plan["found"]})
            for plan in plans:
                self.assertTrue(plan["found"] or plan["kind"].startswith("ompl"), plan)
                ways.add(tuple(plan["way"]))
            steps = [record["q"] for record in self.records("try") if record["task"].startswith("to_truck")]
            self.assertGreater(len(steps), 20)
            for q in steps:
                self.assertAlmostEqual(q["boom.phi"] + q["stick.phi"] + q["bucket.phi"], 265, delta=2 + 1e-5)
        self.assertGreater(len(ways), 4)

    def test_a_truck_parks(self):
        self.expect_parking('ompl "RRTConnect" {')

    def test_the_comparison_has_them_when_asked(self):
        path = self.write("site.plan", self.plan())
        told = rubicon("guides", path, "over", "--seeds", "1", "--ompl", "EST,RRTConnect,TRRT", "--format", "json")
        self.assertEqual(told.returncode, 0, told.stderr)
        guides = json.loads(told.stdout)["motions"][0]["guides"]
        kinds = [guide["kind"] for guide in guides if guide["kind"].startswith("ompl")]
        self.assertEqual(kinds, ["ompl RRTConnect", "ompl EST", "ompl TRRT"])
        for guide in guides:
            if guide["kind"].startswith("ompl"):
                self.assertTrue(all(trial["found"] for trial in guide["trials"]), guide)
        told = rubicon("guides", path, "over", "--seeds", "1", "--ompl", "RTT")
        self.assertEqual(told.returncode, 2)
        self.assertIn("did you mean RRT?", told.stderr)
        told = rubicon("guides", path, "over", "--svg", os.path.join(self.folder, "way.svg"), "--kind", "ompl EST")
        self.assertEqual(told.returncode, 0, told.stderr)
        with open(os.path.join(self.folder, "way.svg"), encoding="utf-8") as file:
            self.assertIn("ompl EST", file.read())

    def test_a_build_without_ompl_says_how_to_get_it(self):
        alone = os.path.join(self.folder, "bin")
        os.mkdir(alone)
        command = shutil.copy(RUBICON, alone)
        path = self.write("site.plan", self.plan())
        told = subprocess.run([command, "run", path], capture_output=True, text=True, check=False)
        self.assertEqual(told.returncode, 2)
        self.assertIn("guide 'way' is a planner of OMPL, and this build has no OMPL", told.stderr)
        self.assertIn("libompl-dev", told.stderr)
        told = subprocess.run([command, "run", os.path.join(TASKPLANS, "trench_by_ompl.plan")], capture_output=True, text=True, check=False)
        self.assertEqual(told.returncode, 2)
        self.assertIn("this build has no OMPL", told.stderr)
        without = self.write("site.plan", self.plan().replace('ompl "RRTConnect"', "rrt").replace('ompl "BITstar"', "rrt"))
        told = subprocess.run([command, "check", without], capture_output=True, text=True, check=False)
        self.assertEqual(told.returncode, 0, told.stderr)


if __name__ == "__main__":
    unittest.main()
