"""--set gives parameters of a plan other values, in every command that reads a plan, and a result keeps what it was given."""

import json
import os
import subprocess
import tempfile
import unittest

RUBICON = os.environ["RUBICON"]
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PLAN = os.path.join(ROOT, "examples", "10_a_row_of_columns", "site.plan")


def rubicon(*arguments):
    return subprocess.run([RUBICON, *arguments], stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120)


class Set(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.result = os.path.join(folder.name, "r")

    def test_runs_the_plan_with_other_values(self):
        tasks = [row["task"] for row in json.loads(rubicon("run", PLAN, "--format", "json").stdout)["tasks"]]
        self.assertEqual(len(tasks), 6, tasks)
        run = rubicon("run", PLAN, "--format", "json", "--set", "bays=4", "--set", "pitch=2.5 m")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(len(json.loads(run.stdout)["tasks"]), 10)

    def test_a_result_keeps_what_it_was_given(self):
        self.assertEqual(rubicon("run", PLAN, "--set", "bays=3", "--out", self.result).returncode, 0)
        with open(os.path.join(self.result, "trace.jsonl"), encoding="utf-8") as trace:
            header = json.loads(trace.readline())
        self.assertEqual(header["set"], {"bays": "3"})
        verified = rubicon("verify", self.result)
        self.assertEqual(verified.returncode, 0, verified.stdout + verified.stderr)
        self.assertEqual(rubicon("why", self.result, "span_3").returncode, 0)
        exported = rubicon("export", self.result, "--mspdi", "-")
        self.assertIn("span_3", exported.stdout, exported.stderr)
        refused = rubicon("why", self.result, "span_3", "--set", "bays=4")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("--set goes with a plan", refused.stderr)

    def test_a_plan_that_is_given_nothing_leaves_no_word_of_it(self):
        rubicon("run", PLAN, "--out", self.result)
        with open(os.path.join(self.result, "trace.jsonl"), encoding="utf-8") as trace:
            self.assertNotIn("set", json.loads(trace.readline()))

    def test_goes_with_every_command_that_reads_a_plan(self):
        for call in (("check", PLAN), ("why", PLAN, "span_3"), ("debug", PLAN, "span_3", "--batch"),
                     ("export", PLAN, "--mspdi", "-")):
            result = rubicon(*call, "--set", "bays=3")
            self.assertEqual(result.returncode, 0, (call, result.stderr))
        self.assertEqual(rubicon("why", PLAN, "span_3").returncode, 2)

    def test_parameters_of_an_imported_plan_have_their_full_names(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in (("yard.plan", 'plan yard { parameter pitch = 2 m; parameter long = 3 * 1.1 m; crew c; task t { by c; takes 1 h; name "pitch {pitch} of {long}"; } }'),
                               ("main.plan", 'plan p { import "yard.plan" as yard; crew c; task t { by c; takes 1 h; name "twice {yard.pitch}"; } }')):
                with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                    file.write(text)
            plan = os.path.join(folder, "main.plan")
            for given, said in (("yard.pich=3", "--set yard.pich=3: the plan has no parameter 'yard.pich'; did you mean yard.pitch?"),
                                ("pitch=3", "--set pitch=3: the plan has no parameter 'pitch'; did you mean yard.pitch?"),
                                ("yard.pitch=3 deg", "--set yard.pitch=3 deg: the parameter is a length, found an angle")):
                self.assertIn(said, rubicon("check", plan, "--set", given).stderr)
            run = json.loads(rubicon("run", plan, "--set", "yard.pitch=3", "--format", "json").stdout)
            self.assertEqual(sorted(task["attributes"]["name"] for task in run["tasks"]), ["pitch 3 of 3.3", "twice 3"])

    def test_says_what_is_wrong(self):
        for given, said in (
            ("bay=3", "the plan has no parameter 'bay'; did you mean bays?"),
            ("bays=three", "expected a number"),
            ("bays=3 m", "the parameter is a plain number, found a length"),
            ("pitch=3 kg", "the parameter is a length, found a mass"),
            ("bays", "expected NAME=VALUE"),
            ("=3", "expected NAME=VALUE"),
            ("bays=1e9", "copies"),
            ("machine=nothing", "nothing.robot"),
        ):
            result = rubicon("check", PLAN, "--set", given)
            self.assertEqual(result.returncode, 2, given)
            self.assertIn(said, result.stderr, given)


if __name__ == "__main__":
    unittest.main()
