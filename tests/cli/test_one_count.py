"""The same words and the same counts everywhere: the terminal, the table, schedule.json, the trace, the chart, the report, `why` and `debug`."""

import collections
import csv
import json
import os
import re
import subprocess
import unittest

from result_case import ResultCase, film_of, rubicon

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
WORDS = ("done", "short", "rejected", "not reached")
# All results there are: done, rejected, not reached; with refused steps, waits and machines that make room; a short plan.
PLANS = (os.path.join(HERE, "verify_results", "yard.plan"), os.path.join(ROOT, "taskplans", "two_cranes.plan"),
         os.path.join(ROOT, "examples", "08_what_cannot_be_done", "site.plan"),
         os.path.join(ROOT, "robots", "tower_crane", "cases", "trap", "site.plan"))


class OneCount(ResultCase):
    def load(self, plan):
        """Runs a plan; the folder of its result."""
        out = os.path.join(self.folder, os.path.relpath(plan, ROOT).replace(os.sep, "_"))
        self.told = rubicon("run", plan, "--out", out)
        self.assertIn(self.told.returncode, (0, 1), self.told.stderr)
        with open(os.path.join(out, "schedule.json"), encoding="utf-8") as file:
            self.tasks = json.load(file)["tasks"]
        with open(os.path.join(out, "schedule.csv"), encoding="utf-8", newline="") as file:
            self.table = list(csv.DictReader(file))
        with open(os.path.join(out, "trace.jsonl"), encoding="utf-8") as file:
            self.header, *self.records = map(json.loads, file)
        self.planned = {task["name"] for task in self.header.get("tasks", [])} or {self.header["plan"]}
        return out

    def test_results(self):
        seen = set()
        for plan in PLANS:
            out = self.load(plan)
            results = [(task["task"], task["result"]) for task in self.tasks]
            seen.update(result for _, result in results)
            self.assertEqual([(row["task"], row["result"]) for row in self.table], results)
            ends = [(r["task"], r["result"]) for r in self.records if r["type"] == "task_end"]
            self.assertEqual(sorted(ends), sorted(results))
            self.assertEqual(sorted((run["task"], run["result"]) for run in film_of(out)["runs"]), sorted(results))
            # Machines that go out of the way are rows, and count as no tasks.
            count = collections.Counter(result for name, result in results if name in self.planned)
            total = sum(count.values())
            words = f"{count['done']} of {total} tasks done" + "".join(f", {count[word]} {word}" for word in WORDS[1:] if count[word])
            self.assertIn(f"\n{words}, process time", self.told.stdout)
            chart = os.path.join(self.folder, "chart.svg")
            self.assertEqual(rubicon("export", out, "--svg", chart).returncode, 0)
            with open(chart, encoding="utf-8") as file:
                self.assertRegex(file.read(), rf"<desc>[^<]*\b{re.escape(words)}[^<]*</desc>")
            for name, result in results:
                if name not in self.planned:
                    continue
                said = rubicon("why", out, name)
                self.assertRegex(said.stdout, rf"^{re.escape(name)} is {result}\b")
                self.assertEqual(json.loads(rubicon("why", out, name, "--format", "json").stdout)["result"], result)
                if result != "done":
                    self.assertRegex(self.told.stdout, rf"(?m)^{re.escape(name)} .* {result}: ")
        self.assertEqual(seen, set(WORDS))

    def test_steps(self):
        waits = 0
        for plan in PLANS:
            out = self.load(plan)
            own = collections.defaultdict(lambda: [0, 0])
            for record in self.records:
                if record["type"] in ("try", "wait"):
                    own[record["task"]][0] += 1
                    own[record["task"]][1] += record["type"] == "wait" or record["ok"]
                    waits += record["type"] == "wait"
            by_name = collections.defaultdict(lambda: [0, 0])
            for task in self.tasks:
                by_name[task["task"]][0] += task["tried"]
                by_name[task["task"]][1] += task["accepted"]
            self.assertEqual({name: tuple(each) for name, each in by_name.items() if any(each)},
                             {name: tuple(each) for name, each in own.items()})
            self.assertEqual([(int(row["tried"]), int(row["accepted"])) for row in self.table],
                             [(task["tried"], task["accepted"]) for task in self.tasks])
            listed = subprocess.run([os.environ["RUBICON"], "debug", out], input="tasks\nquit\n", capture_output=True, text=True, timeout=300).stdout
            told = re.findall(r"(?m)^(?:->)? *\d+  (.*?) +(\d+) tried +(\d+) accepted ", listed)
            self.assertEqual(sorted((name, int(tried), int(accepted)) for name, tried, accepted in told),
                             sorted((task["task"], task["tried"], task["accepted"]) for task in self.tasks if task["task"] in {n for n, _, _ in told}))
            self.assertTrue(told)
            for task in self.tasks:
                if task["task"] not in self.planned or task["tried"] == 0:
                    continue
                self.assertRegex(self.told.stdout, rf"(?m)^{re.escape(task['task'])} .* {task['tried']} +{task['accepted']}  {task['result']}")
                said = [tuple(map(int, each)) for each in re.findall(r": (\d+) steps tried, (\d+) accepted", rubicon("why", out, task["task"]).stdout)]
                self.assertEqual(tuple(map(sum, zip(*said))), (task["tried"], task["accepted"]), task["task"])
        self.assertGreater(waits, 0)

    def test_waits(self):
        """Of a task what it waited for others and for shifts; not for the tasks before it."""
        for plan in PLANS:
            self.load(plan)
            for task in self.tasks:
                if task["result"] != "done":
                    continue
                seconds = round(sum(each for kind, each in task["waited"].items() if kind != "predecessor"))
                clock = f"{seconds // 3600}:{seconds // 60 % 60:02}:{seconds % 60:02}"
                self.assertRegex(self.told.stdout, rf"(?m)^{re.escape(task['task'])} .* {clock} +{task['tried']} +{task['accepted']}  done")


if __name__ == "__main__":
    unittest.main()
