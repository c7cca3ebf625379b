"""Joints between strips of a floor that are older than the plan allows: where, how late, and what verify makes of them."""

import math
import unittest

from result_case import ResultCase, rubicon

GANTRY = """robot gantry {
  body bridge { param x range(-1, 41) step(0.5) speed(0.5 m/s); frame trans(x, 0, 0); shape box(-0.1, -1, 2, 0.1, 31, 2.2); }
  body beam on bridge { param y range(0, 30) step(0.5) speed(0.5 m/s) start(0.5); frame trans(0, y, 0.1);
                        shape box(-0.1, -0.1, 0, 0.1, 0.1, 2); }
  tool beam;
  behaviour { which { working: chain { line }; default: chain { move_to(y, goal(y)), move_to(x, goal(x)) };
                      } }
}
"""
WIDE, DEEP = 8, 6
PACE = 30 / 3600 / 0.06  # m/s
LINE = WIDE / PACE       # s
SIDE = 1 / 0.5           # s, to the next line


class ColdJoints(ResultCase):
    def plan(self, clause="", more="", area="outline (0, 0), (8, 0), (8, 6), (0, 6);", robot='robot g "gantry.robot";'):
        self.write("gantry.robot", GANTRY)
        return ('plan p { start_at "2026-03-16 07:00"; %s %s area deck { %s } task lay { by g; '
                "cover deck { width 1 m; clearance 0.2 m; above 0.1 m; thickness 0.06 m; rate 30 m3 per h; from (0, 0.5); %s } } }"
                % (more, robot, area, clause))

    def joints(self, *arguments, **named):
        _, tasks = self.run_plan(self.plan(*arguments, **named))
        return tasks["lay"]["cover"]["cold_joints"]

    def test_lines_there_and_back(self):
        found = self.joints("cold_joint after 60 s;")
        # At the end where it turned a line is SIDE old when the next comes, at the other 2 LINE + SIDE.
        self.assertAlmostEqual(found["after"], 60)
        self.assertAlmostEqual(found["oldest"], 2 * LINE + SIDE, delta=1e-3)
        self.assertAlmostEqual(found["all_joints"], (DEEP - 1) * WIDE, delta=1e-3)
        cold = WIDE * (2 * LINE + SIDE - 60) / (2 * LINE)
        self.assertEqual(found["count"], DEEP - 1)
        self.assertAlmostEqual(found["length"], (DEEP - 1) * cold, delta=1e-3)
        for place in found["places"]:
            self.assertAlmostEqual(math.dist(place["from"], place["to"]), cold, delta=1e-3)
            self.assertEqual(place["from"][1], place["to"][1])
            self.assertAlmostEqual(place["age"], found["oldest"], delta=1e-3)
            self.assertAlmostEqual(place["late"], place["age"] - 60, delta=1e-6)
            self.assertAlmostEqual(place["joined"] - place["laid"], place["age"], delta=1e-6)
        self.assertEqual(sorted(round(place["from"][1], 6) for place in found["places"]), [1, 2, 3, 4, 5])
        self.assertRegex(self.run_result.stdout, r"cold joints +after +places +m +oldest +at +late by\nlay +0:01:00 +5 +19\.9 +0:01:57 +\(0\.00, 1\.00\) +0:00:57")
        self.assertRegex(self.run_result.stdout, r"cold joint of +from +to +m +age +late by +joined\nlay +\(\d\.\d\d, 1\.00\) +\(\d\.\d\d, 1\.00\) +4\.0 +0:01:57 +0:00:57 +2026-03-16 07:0")
        # None is older than that; without the clause nobody asks.
        later = self.joints("cold_joint after 2 min;")
        self.assertEqual((later["count"], later["places"], later["length"]), (0, [], 0))
        self.assertRegex(self.run_result.stdout, r"lay +0:02:00 +0 +0\.0 +0:01:57 +\(0\.00, 1\.00\) +-")
        _, tasks = self.run_plan(self.plan())
        self.assertNotIn("cold_joints", tasks["lay"]["cover"])
        self.assertNotIn("cold joints", self.run_result.stdout)

    def test_a_break_makes_a_joint_across_and_beside(self):
        calendar = "calendar site { mon-fri 07:00-07:03, 07:33-16:00; carry_over; }"
        robot = 'robot g "gantry.robot" { calendar site; }'
        found = self.joints("cold_joint after 20 min;", more=calendar, robot=robot)
        across = [place for place in found["places"] if abs(place["from"][0] - place["to"][0]) < 1e-6]
        self.assertEqual(len(across), 1)
        self.assertAlmostEqual(math.dist(across[0]["from"], across[0]["to"]), 1, delta=1e-6)
        # It stopped in the fourth strip where a step ended, not before 07:03.
        self.assertEqual(sorted((across[0]["from"][1], across[0]["to"][1])), [3, 4])
        self.assertGreater(across[0]["age"], 30 * 60 - 5)
        self.assertLess(across[0]["age"], 30 * 60 + 1e-6)
        beside = [place for place in found["places"] if place not in across]
        # What it laid before is cold when the fifth comes, the third when it goes on.
        self.assertEqual(sorted(round(place["from"][1], 6) for place in beside), [3, 4])
        x = across[0]["from"][0]
        self.assertTrue(all(min(abs(place[end][0] - x) for end in ("from", "to")) < 1e-6 for place in beside))
        # A motion that goes on over the break has no such joint.
        through = self.joints("cold_joint after 20 min;", more=calendar.replace(" carry_over;", ""), robot=robot)
        self.assertEqual(through["count"], 0)
        self.assertAlmostEqual(through["oldest"], 2 * LINE + SIDE, delta=1e-3)

    def test_verify_finds_joints_that_are_not_told_so(self):
        self.joints("cold_joint after 60 s;")

        def record(result):
            return next(record for record in result.records if record["type"] == "cold_joint")

        def limit(result, seconds):
            result.header["tasks"][0]["cover"]["cold_after"] = seconds

        def move(result):
            record(result)["ends"][1] += 0.5
            record(result)["ends"][3] += 0.5

        def shift(result):
            record(result)["ends"][0] += 1.5
            record(result)["ends"][2] += 1.5

        def age(result):
            record(result)["age"] += 20
            record(result)["joined"] += 20

        def told(result):
            return result.schedule["tasks"][0]["cover"]["cold_joints"]

        self.assertIn("is not told", self.faults_of(lambda result: result.records.remove(record(result))))
        self.assertIn("no cold joint at", self.faults_of(move))
        self.assertIn("no cold joint at", self.faults_of(shift))
        self.assertIn("told as 2.3 min old; found 1.9 min", self.faults_of(age))
        self.assertIn("age is not the time between", self.faults_of(lambda result: record(result).update(age=90)))
        self.assertIn("no cold joint at", self.faults_of(lambda result: limit(result, 3600)))
        self.assertIn("is not told", self.faults_of(lambda result: limit(result, 20)))
        self.assertIn("another limit", self.faults_of(lambda result: limit(result, 60.5)))
        self.assertIn("not those of the trace", self.faults_of(lambda result: told(result)["places"].pop()))
        self.assertIn("m long", self.faults_of(lambda result: told(result).update(length=25)))
        self.assertIn("oldest joint", self.faults_of(lambda result: told(result).update(oldest=130)))
        self.assertIn("not told", self.faults_of(lambda result: result.schedule["tasks"][0]["cover"].pop("cold_joints")))
        self.run_plan(self.plan())
        joint = {"type": "cold_joint", "task": "lay", "robot": "g", "ends": [0, 1, 4, 1], "age": 90, "laid": 0, "joined": 90}
        self.assertIn("has no limit", self.faults_of(
            lambda result: result.records.insert(-1, {**joint, "t": result.records[-1]["t"]})))

    def test_mistakes_are_told_at_their_places(self):
        for clause, message in (("cold_joint after 0 min;", "a joint is cold after some time, found 0"),
                                ("cold_joint 90 min;", "expected after"),
                                ("cold_joint after 2 m;", "needs a time, but 'm' is a length"),
                                ("cold_joint after;", "expected a duration such as 90 min"),
                                ("cold_joint after 1 h; cold_joint after 2 h;", "cold_joint is given twice"),
                                ("cold_joints after 1 h;", "cold_joint"),
                                ("cold_joint after -5 min;", "cannot be negative")):
            checked = rubicon("check", self.write("p.plan", self.plan(clause)))
            self.assertEqual(checked.returncode, 2, clause + checked.stdout)
            self.assertIn(message, checked.stderr, clause)
        warned = rubicon("check", self.write("p.plan", self.plan("cold_joint after 90;")))
        self.assertIn("has no unit and is taken as 90 s", warned.stderr)


if __name__ == "__main__":
    unittest.main()
