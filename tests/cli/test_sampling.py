"""Durations that are not certain: means, draws by seed, run and place, and what verify makes of them."""

import json
import os
import re
import subprocess
import unittest

from result_case import RUBICON, ResultCase, rubicon

LAWS = ("uniform(60 s, 180 s)", "triangular(1 min, 2 min, 5 min)", "pert(0 s, 1 min, 4 min)", "normal(100 s, 10 s)",
        "lognormal(100 s, 50 s)", "gamma(100 s, 50 s)", "exponential(100 s)")
MEANS = (120, 160, 80, 100, 100, 100, 100)


def one_each(more=""):
    tasks = " ".join("task t%d { by gang; takes %s; %s }" % (i, law, "after t%d;" % (i - 1) if i else "") for i, law in enumerate(LAWS))
    return "plan p { crew gang; %s %s }" % (tasks, more)


class Sampling(ResultCase):
    def durations(self, schedule):
        return [task["duration"] for task in sorted(schedule["tasks"], key=lambda task: task["task"]) if task["task"] != "other"]

    def sampled(self, sample, text=None):
        path = self.write("p.plan", text or one_each())
        result = rubicon("run", path, "--out", self.out, "--sample", sample)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        verified = rubicon("verify", self.out)
        self.assertEqual(verified.returncode, 0, verified.stdout + verified.stderr)
        with open(os.path.join(self.out, "schedule.json"), encoding="utf-8") as file:
            return json.load(file), result.stdout

    def test_without_a_sample_each_stands_for_its_mean(self):
        schedule, _ = self.run_plan(one_each())
        self.assertEqual(self.durations(schedule), list(MEANS))
        self.assertEqual(schedule["uncertain"], 7)
        self.assertNotIn("sample", schedule)
        self.assertIn("7 durations are not certain, and stand for their means; --sample SEED draws them\n", self.run_result.stdout)

    def test_the_same_sample_is_the_same_run(self):
        first, text = self.sampled("7:3")
        with open(os.path.join(self.out, "trace.jsonl"), "rb") as file:
            trace = file.read()
        second, _ = self.sampled("7:3")
        with open(os.path.join(self.out, "trace.jsonl"), "rb") as file:
            self.assertEqual(file.read(), trace)
        self.assertEqual(first, second)
        self.assertEqual(first["sample"], {"seed": 7, "run": 3})
        self.assertIn("7 durations are not certain, and drawn with seed 7, run 3\n", text)
        for other in ("7:4", "8:3"):
            self.assertTrue(all(a != b for a, b in zip(self.durations(first), self.durations(self.sampled(other)[0]))))

    def test_a_place_keeps_its_draw_whatever_else_there_is(self):
        alone, _ = self.sampled("5")
        beside, _ = self.sampled("5", one_each("task other { takes exponential(1 h); priority 9; }"))
        self.assertEqual(self.durations(alone), self.durations(beside))

    def test_draws_have_their_means(self):
        # The sum of 40 runs; its standard error is that of the sum of the laws over the root of 40.
        path = self.write("p.plan", one_each())
        total = 0
        for run in range(40):
            result = subprocess.run([RUBICON, "run", path, "--format", "json", "--sample", "1:%d" % run], capture_output=True, text=True, timeout=60)
            total += json.loads(result.stdout)["process_time"]
        deviation = (34.6**2 + 51**2 + 42.8**2 + 10**2 + 50**2 + 50**2 + 100**2) ** 0.5
        self.assertLess(abs(total / 40 - sum(MEANS)), 4 * deviation / 40**0.5)

    def test_crew_work_of_a_lift_is_drawn_too(self):
        self.write("hoist.robot", "robot hoist { body hook { param z range(0, 20) step(1) speed(1 m/s) start(5); frame trans(0, 0, z); shape box(-0.1, -0.1, 0, 0.1, 0.1, 0.5); } tool hook; behaviour { chain { move_to(z, goal(z)) } } }")
        text = """plan p { support off; robot h "hoist.robot"; crew riggers; component c { shape box(-0.5, -0.5, 0, 0.5, 0.5, 1); at trans(0, 0, 0); grip trans(0, 0, 1); }
          task lift { by h; move c to trans(0, 0, 4); hook triangular(1 min, 2 min, 5 min) by riggers; release uniform(10 s, 20 s); } }"""
        schedule, _ = self.sampled("3", text)
        work = schedule["tasks"][0]["work"]
        self.assertGreater(work, 70)
        self.assertLess(work, 320)
        self.assertNotEqual(work, self.sampled("4", text)[0]["tasks"][0]["work"])

    def test_verify_knows_the_laws(self):
        self.run_plan(one_each())

        def longer(result):
            result.header["tasks"][0]["takes"][0]["duration"] = 130

        self.assertIn("takes takes 130 s, and the mean of its uniform is 120 s", self.faults_of(longer))
        self.sampled("7")

        def outside(result):
            result.header["tasks"][0]["takes"][0]["duration"] = 181

        self.assertIn("takes takes 181 s, which uniform does not allow", self.faults_of(outside))

    def test_what_is_wrong_is_said(self):
        for law, message in (("triangular(3 min, 2 min, 5 min)", "the likely value is below the low value"), ("pert(1 min)", "pert takes 3 values (low, likely, high), found 1"),
                             ("exponential(0 s)", "the mean is 0"), ("normal(1 min, 2 min)", "the deviation is larger than the mean: take lognormal or gamma")):
            path = self.write("p.plan", "plan p { task t { takes %s; } }" % law)
            result = rubicon("check", path)
            self.assertEqual(result.returncode, 2)
            self.assertRegex(result.stderr + result.stdout, r"p\.plan:1:\d+: error: " + re.escape(message))
        path = self.write("p.plan", one_each())
        for sample in ("x", "1:", "-1", "1:2:3", "99999999999999999999"):
            result = rubicon("run", path, "--sample=" + sample)
            self.assertEqual(result.returncode, 2, sample)
            self.assertIn("expected SEED or SEED:RUN, such as 7 or 7:12, found '%s'" % sample, result.stderr)


if __name__ == "__main__":
    unittest.main()
