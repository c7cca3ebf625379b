"""The cycle of an excavator (F. Langari 2015): times before and after the adjustment of speeds, heights over the bed of the truck."""

import json
import os
import sys
import unittest

from result_case import RUBICON, ResultCase, rubicon

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
sys.path.insert(0, os.path.join(ROOT, "bench"))
import cycle_times


class ExcavatorCycle(ResultCase):
    def test_speeds_that_are_adjusted_save_a_half(self):
        cycles = {}
        for way, name in cycle_times.WAYS.items():
            digging, before, after = cycle_times.first_cycle(RUBICON, way)
            self.assertEqual(digging, 5)
            for first, second in zip(before, after):
                self.assertLessEqual(second, first + 1e-6, name)
            # A swing of 150 degrees takes 10 s alone.
            self.assertGreaterEqual(after[0], 10, name)
            cycles[name] = (sum(before) + digging, sum(after) + digging)
            self.assertLess(cycles[name][1] / cycles[name][0], 0.6, name)
        # Where guides lead, the way back over workers and pipes is no climb from step to step.
        self.assertLess(cycles["rrt_connect"][1], 0.8 * cycles["behaviour"][1])

    def test_heights_over_the_bed(self):
        """Eqs. 3.3 and 3.4: a bed at 1.5 m, a bucket of 1.5 m and 1 m3, 0.3 m of safety, a truck of 10 m3 and 1 m depth: 3.3 m, 3.4 m, ..."""
        path = self.write("p.plan", """plan p {
          parameter bed = 1.5 m; parameter bucket_length = 1.5 m; parameter safety = 0.3 m; parameter depth = 1 m;
          parameter bucket = 1 m3; parameter truck = 10 m3; parameter rise = bucket / truck * depth;
          robot excavator "%s/robots/excavator/excavator.robot";
          for i from 1 to truck / bucket {
            task dump[i] { by excavator; go at trans(0, 6, bed + bucket_length + safety + (i - 1) * rise); free rotx, roty, rotz; }
          }
        }""" % ROOT)
        run = rubicon("run", path, "--out", self.out)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
            tasks = json.loads(file.readline())["tasks"]
        self.assertEqual([round(task["go"]["pose"][11], 9) for task in tasks], [round(3.3 + 0.1 * i, 9) for i in range(10)])


if __name__ == "__main__":
    unittest.main()
