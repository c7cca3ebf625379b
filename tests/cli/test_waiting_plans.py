"""Machines whose scripts count and look at the clock while they wait for each other: every run ends, and says why. The long
form by hand: RUBICON_WAITING_PLANS=500 python3 tests/cli/test_waiting_plans.py, with RUBICON naming the command."""

import json
import os
import re
import resource
import subprocess
import tempfile
import unittest

import waiting_plans

RUBICON = os.environ["RUBICON"]
SEED = int(os.environ.get("RUBICON_SEED", "0"))
PLANS = int(os.environ.get("RUBICON_WAITING_PLANS", "40"))
SECONDS = 20  # of processor time
MEMORY = 1 << 30  # bytes
with open(RUBICON, "rb") as command:
    SANITIZED = b"__asan_init" in command.read()  # its shadow memory alone is terabytes of address space
WAITS = re.compile(r"; [1-9]\d* of them waits since \S+ s, when anybody last made progress")


def limit():
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    if not SANITIZED:
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


class WaitingPlans(unittest.TestCase):
    def test_every_plan_ends(self):
        waited = 0
        for number in range(PLANS):
            seed = SEED * 10000 + number
            with self.subTest(seed=seed), tempfile.TemporaryDirectory() as folder:
                plan = waiting_plans.write_plan(seed, folder)
                out = os.path.join(folder, "out")
                run = subprocess.run([RUBICON, "run", plan, "--out", out], capture_output=True, text=True, preexec_fn=limit)
                self.assertIn(run.returncode, (0, 1), run.stderr)
                with open(os.path.join(out, "schedule.json"), encoding="utf-8") as file:
                    tasks = json.load(file)["tasks"]
                for task in tasks:
                    if task["result"] != "done":
                        self.assertTrue(task["reason"])
                    if task.get("reason", "").startswith("budget:") and "wait" in task["reason"]:
                        waited += 1
                        self.assertRegex(task["reason"], WAITS)
                verdict = subprocess.run([RUBICON, "verify", out], capture_output=True, text=True)
                self.assertEqual(verdict.returncode, 0, verdict.stdout + verdict.stderr)
        self.assertGreater(waited, PLANS * 0.2)


if __name__ == "__main__":
    unittest.main()
