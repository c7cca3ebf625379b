"""Results at the far end of what plans may hold: verify, report and export read what run wrote."""

import os
import unittest

from result_case import ResultCase, film_of, rubicon

HOUR = 3600

# A job of 110 thousand million rupiah, and one at the bounds of all rates.
MONEY = """
plan money {
  start_at "2026-03-02 07:00"; currency "IDR"; OVERHEAD
  crew gang { size 20; cost RATE per h; }
  crew fixers { size 3; cost 123456789.37 per h; MORE }
  task structure { by gang; takes 1100 h; }
  task part { by fixers; needs 1 fixers; takes 11111 s; }
  task whole { by fixers; takes 7777 h; }
}
"""


class Extremes(ResultCase):
    def read_all(self):
        """What report and export make of the result that verify took."""
        for command in (("report", self.out), ("export", self.out, "--csv", "-"), ("export", self.out, "--svg", os.path.join(self.folder, "x.svg"))):
            result = rubicon(*command)
            self.assertEqual((result.returncode, result.stderr), (0, ""), command)

    def test_currencies_with_many_zeros(self):
        small, large = (MONEY.replace("RATE", rate).replace("OVERHEAD", overhead).replace("MORE", more) for rate, overhead, more in (
            ("100000000", "", ""),
            ("1e12", "overhead 1e12 per day;", "rental 7.77e11 per day; mobilisation 1e12; overtime 90;")))
        schedule, tasks = self.run_plan(small)
        self.assertEqual(tasks["structure"]["cost"], 110_000_000_000)
        self.read_all()
        # More cents than 64 bits count.
        schedule, tasks = self.run_plan(large.replace("task structure { by gang; takes 1100 h; }", "for i from 1 to 4 { task structure[i] { by gang; takes 27000 h; } }"))
        self.assertEqual(tasks["structure_1"]["cost"], 27_000 * 10**12)
        self.assertEqual(schedule["cost_by_kind"]["overhead"], 4_501 * 10**12)
        self.assertAlmostEqual(schedule["cost"] / sum(schedule["cost_by_kind"].values()), 1, delta=1e-15)
        self.read_all()
        # Large as they are, a wrong amount is found.
        found = self.faults_of(lambda result: result.schedule.update(cost=result.schedule["cost"] * (1 + 1e-9)))
        self.assertIn("the whole costs", found)

    def test_a_plan_of_a_hundred_years(self):
        parts = 36
        plan = "plan long { crew c; for i from 1 to %d { task h[i] { by c; takes 27000 h; when (i > 1) { after h[i - 1]; } } } }" % parts
        schedule, _ = self.run_plan(plan)
        self.assertEqual(schedule["process_time"], parts * 27_000 * HOUR)
        self.assertEqual(film_of(self.out)["end"], parts * 27_000 * HOUR)
        self.read_all()


if __name__ == "__main__":
    unittest.main()
