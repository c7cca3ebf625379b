"""A robot passes what lies in its lane as the Blackmon paper says: right of it, left of it in its own lane, in the lane beside,
or back and round; where it is beside the obstacle is read from the trace."""

import json
import os
import unittest

from result_case import ResultCase, rubicon

HERE = os.path.dirname(os.path.abspath(__file__))
PLAN = os.path.join(HERE, "..", "..", "taskplans", "bypass.plan")


class Bypass(ResultCase):
    def places(self, obstacle):
        ran = rubicon("run", PLAN, "--set", f"obstacle={obstacle}", "--out", self.out)
        self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)
        verified = rubicon("verify", self.out)
        self.assertEqual(verified.returncode, 0, verified.stdout + verified.stderr)
        with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
            records = [json.loads(line) for line in file]
        self.assertEqual([r["type"] for r in records if r["type"] == "wait"], ["wait"])
        return [(r["q"]["x"], r["q"]["y"], r["q"]["theta"]) for r in records if r["type"] == "try" and r["ok"]]

    def test_the_first_gap_that_is_wide_enough(self):
        # y of its middle, from the middle of its lane, while it is beside what lies from x = 28 to 30.
        for obstacle, beside in ((1, {-0.5}), (4, {1}), (2, {4})):
            with self.subTest(obstacle):
                places = self.places(obstacle)
                self.assertEqual({round(y, 6) for x, y, _ in places if 27 < x < 31}, beside)
                # It had not gone further over than it had to, and is in the middle of its lane again well before the goal.
                self.assertEqual(max(y for _, y, _ in places), max(beside | {0}))
                self.assertEqual({(round(y, 6), theta) for x, y, theta in places if x > 33}, {(0, 0)})

    def test_back_and_round_without_a_gap(self):
        places = self.places(3)
        self.assertEqual({round(y, 6) for x, y, _ in places if 27 < x < 31}, {20})
        back = next(i for i, (x, _, _) in enumerate(places) if x > 20)
        self.assertIn((0, 0), [(round(x, 6), round(y, 6)) for x, y, _ in places[back:]])
        self.assertEqual([round(value, 6) for value in places[-1]], [60, 0, 0])


if __name__ == "__main__":
    unittest.main()
