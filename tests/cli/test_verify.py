"""rubicon verify: good results have no fault, and every fault that is seeded into them is found where it is."""

import base64
import collections
import gzip
import json
import os
import re
import subprocess
import tempfile
import unittest

import random_plans
import seeded_faults

RUBICON = os.environ["RUBICON"]
HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
SEED = int(os.environ.get("RUBICON_SEED", "1995"))
ROUNDS = int(os.environ.get("RUBICON_ROUNDS", "8"))
RANDOM_PLANS = int(os.environ.get("RUBICON_RANDOM_PLANS", "60"))


def rubicon(*arguments):
    return subprocess.run([RUBICON, *arguments], capture_output=True, text=True, timeout=300)


def plans():
    """Plans whose results are verified: ours, those that are shipped, those of the tour and the robots' cases."""
    found = [os.path.join(HERE, "verify_results", name) for name in ("yard.plan", "meeting.plan", "propped.plan")]
    for folder in ("taskplans", "examples", "robots", os.path.join("tests", "language")):
        for path, _, files in sorted(os.walk(os.path.join(ROOT, folder))):
            found += [os.path.join(path, name) for name in sorted(files) if name.endswith(".plan")]
    return found


class Verify(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = cls.temporary.name

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def run_plan(self, plan):
        folder = os.path.join(self.folder, str(abs(hash(plan))))
        if not os.path.exists(folder):
            result = rubicon("run", plan, "--out", folder)
            if "this build has no OMPL" in result.stderr:
                self.skipTest(f"{os.path.relpath(plan, ROOT)} needs OMPL, and this build has none")
            self.assertIn(result.returncode, (0, 1), f"{plan}: {result.stderr}")
        return folder

    def test_good_results_have_no_fault(self):
        for plan in plans():
            with self.subTest(plan=plan):
                folder = self.run_plan(plan)
                result = rubicon("verify", folder)
                self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
                if os.path.exists(os.path.join(folder, "charts.json")):  # no machine moves: test_charts
                    continue
                self.assertRegex(result.stdout, r"^verified: \d+ tasks \(\d+ done\), \d+ steps, .*no fault\n$")
                trace = rubicon("verify", os.path.join(folder, "trace.jsonl"))
                self.assertEqual(trace.returncode, 0, trace.stdout)
                self.expect_rejected_tasks_together(os.path.join(folder, "trace.jsonl"))

    def expect_rejected_tasks_together(self, path):
        """docs/trace.md: their records stand together, before all that begins after their start."""
        with open(path, encoding="utf-8") as file:
            header, *records = [json.loads(line) for line in file]
        if header["form"] == "short":  # one task, and nothing to go back to
            return
        for end, record in enumerate(records):
            if record["type"] != "task_end" or record["result"] != "rejected":
                continue
            begin = end
            while begin > 0 and records[begin - 1]["task"] == record["task"]:
                begin -= 1
                if records[begin]["type"] == "task_start":
                    break
            if records[begin]["type"] != "task_start":
                continue
            self.assertEqual(records[begin]["t"], record["t"])
            late = [other["task"] for other in records[:begin]
                    if other["type"] == "task_start" and other["t"] > record["t"]
                    and {"task": other["task"], "result": "done"}.items() <= self.end_of(records, other).items()]
            self.assertEqual(late, [], record["task"])

    @staticmethod
    def end_of(records, start):
        return next(r for r in records[records.index(start):] if r["type"] == "task_end" and r["task"] == start["task"])

    def test_results_of_random_plans_have_no_fault(self):
        """Nothing ever meets anything, whatever machines do: two methods that share nothing agree."""
        steps, waits = 0, 0
        for number in range(RANDOM_PLANS):
            folder = os.path.join(self.folder, f"random_{number}")
            os.makedirs(folder)
            with self.subTest(number=number):
                out = os.path.join(folder, "out")
                run = rubicon("run", random_plans.write_plan(SEED * 10000 + number, folder), "--out", out)
                self.assertIn(run.returncode, (0, 1), run.stderr)
                result = rubicon("verify", out, "--format", "json")
                self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
                steps += json.loads(result.stdout)["steps"]
                with open(os.path.join(out, "trace.jsonl"), encoding="utf-8") as file:
                    waits += file.read().count('"why":"machine"')
        self.assertGreater(steps, 50 * RANDOM_PLANS)
        self.assertGreater(waits, 0)

    def test_every_seeded_fault_is_found_at_its_place(self):
        names = [os.path.join(HERE, "verify_results", "yard.plan"),
                 os.path.join(HERE, "verify_results", "meeting.plan"),
                 os.path.join(HERE, "verify_results", "propped.plan"),
                 os.path.join(ROOT, "tests", "language", "63_turned_by_people", "site.plan"),
                 os.path.join(ROOT, "examples", "07_three_blocks", "site.plan"),
                 os.path.join(ROOT, "examples", "05_level_bucket", "site.plan"),
                 os.path.join(ROOT, "examples", "06_wait_for_the_goal", "site.plan"),
                 os.path.join(ROOT, "taskplans", "ceiling.plan"),
                 os.path.join(ROOT, "robots", "tower_crane", "cases", "trap", "site.plan"),
                 os.path.join(ROOT, "robots", "tower_crane", "cases", "over_a_wall", "site.plan")]
        results = [seeded_faults.Result(self.run_plan(name)) for name in names]
        folder = os.path.join(self.folder, "seeded")
        os.makedirs(folder)
        counts = collections.Counter()
        for number, fault in enumerate(seeded_faults.seeded(results, SEED, ROUNDS)):
            counts[fault.kind] += 1
            with self.subTest(number=number, kind=fault.kind, tasks=sorted(fault.tasks)[:3], line=fault.line):
                fault.result.write(folder)
                result = rubicon("verify", folder, "--format", "json")
                self.assertEqual(result.returncode, 1, result.stderr)
                faults = json.loads(result.stdout)["faults"]
                self.assertTrue(fault.is_found(faults), json.dumps(faults[:8], indent=1))
        self.assertEqual(len(counts), len(seeded_faults.KINDS), counts)
        self.assertGreaterEqual(sum(counts.values()), 200, counts)

    def expect_changed_is_found(self, folder, name, old, new, words):
        """A text of a good result that is changed in one file is a fault of that file."""
        path = os.path.join(folder, name)
        with open(path, encoding="utf-8", newline="") as file:
            good = file.read()
        self.assertIn(old, good)
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(good.replace(old, new, 1))
        result = rubicon("verify", folder)
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(good)
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        self.assertRegex(result.stdout, rf"(?m)^.*{name}.*{words}")

    def test_names_dates_and_floats_that_are_changed_are_found(self):
        path = os.path.join(self.folder, "names.plan")
        with open(path, "w", encoding="utf-8") as file:
            file.write('plan p { start_at "2028-02-28 07:00"; crew a; crew b;\n'
                       '  component wall { name "W1"; storey "3"; attribute lot "L 7"; shape box(0, 0, 0, 1, 1, 1); }\n'
                       '  task short { name "Grout 1"; by a; takes 10 h; baseline "2028-02-28 08:00" to "2028-02-29 08:00"; }\n'
                       "  task long { by b; takes 30 h; } task take { by a; remove wall; takes 1 h; after short; } }\n")
        folder = self.run_plan(path)
        for name, old, new, words in (("schedule.csv", ",68400,0,", ",7,0,", "its float is not that of schedule.json"),
                                      ("schedule.csv", ",68400,68400,", ",68400,7,", "its float is not"),
                                      ("schedule.csv", "Grout 1", "Pour 9", "'name' is not what the trace says"),
                                      ("schedule.json", '"begins":"2028-02-28 08:00"', '"begins":"2028-02-20 08:00"', "of its baseline 'begins' is"),
                                      ("schedule.json", '"ends":"2028-02-29 08:00"', '"ends":"2028-03-09 08:00"', "of its baseline 'ends' is"),
                                      ("schedule.json", '"name":"Grout 1"', '"name":"Pour 9"', "its name or another attribute"),
                                      ("schedule.json", '"kind":"crew"', '"kind":"robot"', "its kind is not that of the trace"),
                                      ("schedule.json", '"tried":', '"component":"wall","tried":', "'component' is not what the trace says"),
                                      ("schedule.json", '"tried":', '"parking":true,"tried":', "'parking' is not what the trace says"),
                                      ("schedule.json", '"storey":"3"', '"storey":"7"', "the attributes of component wall")):
            with self.subTest(name=name, old=old):
                self.expect_changed_is_found(folder, name, old, new, words)
        # What the page shows, behind a head that is right.
        path = os.path.join(folder, "report.html")
        with open(path, encoding="utf-8") as file:
            page = file.read()
        begin = page.index('id="film">') + len('id="film">')
        end = page.index("<", begin)
        film = gzip.decompress(base64.b64decode(page[begin:end])).replace(b'"name":"Grout 1"', b'"name":"Grout 7"')
        with open(path, "w", encoding="utf-8") as file:
            file.write(page[:begin] + base64.b64encode(gzip.compress(film)).decode() + page[end:])
        result = rubicon("verify", folder)
        self.assertEqual(result.returncode, 1)
        self.assertIn("report.html: the schedule that it shows is not schedule.json", result.stdout)

    def test_figures_of_digs_and_floors_that_are_changed_are_found(self):
        folder = self.run_plan(os.path.join(ROOT, "examples", "19_dig_and_haul", "site.plan"))
        for name, old, new, words in (("schedule.json", '"volume":600,', '"volume":700,', "'volume' is 700, by the trace 600"),
                                      ("schedule.json", '"per_hour":146', '"per_hour":246', "'per_hour'"),
                                      ("schedule.json", '"cost_per_m3":5', '"cost_per_m3":3', "'cost_per_m3'"),
                                      ("schedule.json", '"loads":60,', '"loads":50,', "'loads' is 50"),
                                      ("schedule.json", '"passes":660', '"passes":661', "'passes' is 661"),
                                      ("schedule.json", '"served":36', '"served":37', "'queue of excavator_a served' is 37"),
                                      ("schedule.json", '"mean_wait":23', '"mean_wait":33', "mean_wait"),
                                      ("schedule.json", '"longest_wait":530', '"longest_wait":630', "longest_wait"),
                                      ("schedule.json", '"utilisation":0.6475', '"utilisation":1.6475', "utilisation"),
                                      ("schedule.json", '"mean_length":0.0576', '"mean_length":0.0676', "mean_length"),
                                      ("loads.csv", "dig_pit,3,3,", "dig_pit,3,4,", "load 3 is not that of its rounds"),
                                      ("loads.csv", "dig_pit,3,", "dig_put,3,", "the schedule has no such task")):
            with self.subTest(name=name, old=old):
                self.expect_changed_is_found(folder, name, old, new, words)
        folder = self.run_plan(os.path.join(ROOT, "examples", "18_cover_a_floor", "site.plan"))
        with open(os.path.join(folder, "schedule.json"), encoding="utf-8") as file:
            turns = re.search(r'"turns":\d+', file.read()).group()
        self.expect_changed_is_found(folder, "schedule.json", turns, turns + "7", "'turns' of what it covers")

    def test_faults_of_a_large_result_are_found(self):
        result = seeded_faults.Result(self.run_plan(os.path.join(ROOT, "taskplans", "unit.plan")))
        folder = os.path.join(self.folder, "large")
        os.makedirs(folder)
        for number, fault in enumerate(seeded_faults.seeded([result], SEED + 1, 1)):
            with self.subTest(number=number, kind=fault.kind, tasks=sorted(fault.tasks)[:3], line=fault.line):
                fault.result.write(folder)
                told = rubicon("verify", folder, "--format", "json")
                self.assertEqual(told.returncode, 1, told.stderr)
                self.assertTrue(fault.is_found(json.loads(told.stdout)["faults"]), told.stdout[:2000])

    def test_a_copy_without_a_fault_is_good(self):
        """What the program of faults writes is a result like any other."""
        for name in ("yard.plan", "meeting.plan"):
            folder = os.path.join(self.folder, "copy")
            os.makedirs(folder, exist_ok=True)
            seeded_faults.Result(self.run_plan(os.path.join(HERE, "verify_results", name))).write(folder)
            self.assertEqual(rubicon("verify", folder).returncode, 0)

    def test_a_fault_is_one_line_with_its_place(self):
        good = seeded_faults.Result(self.run_plan(os.path.join(HERE, "verify_results", "yard.plan")))
        folder = os.path.join(self.folder, "line")
        os.makedirs(folder)
        good.header["site"].append({"type": "box", "lower": [-1.5, -0.5, 0], "upper": [-1, 0, 0.1],
                                    "pose": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]})
        good.write(folder)
        result = rubicon("verify", folder)
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stdout.splitlines()[0],
                         r"^\S+/trace\.jsonl:\d+: task set_slab_2 at 0:\d\d:\d\d(\.\d+)?: slab_2 meets site 2 "
                         r"\(at least \d+\.\d mm deep\)$")
        self.assertRegex(result.stdout.splitlines()[-1], r"^\d+ faults?$")

    def test_many_faults_are_counted(self):
        good = seeded_faults.Result(self.run_plan(os.path.join(HERE, "verify_results", "yard.plan")))
        folder = os.path.join(self.folder, "many")
        os.makedirs(folder)
        for index in good.places("try")[::2]:
            good.records[index]["t"] += 0.5
        good.write(folder)
        lines = rubicon("verify", folder).stdout.splitlines()
        self.assertEqual(len(lines), 51)
        self.assertRegex(lines[-1], r"^\d+ faults, the first 50 of them above$")
        told = json.loads(rubicon("verify", folder, "--format", "json").stdout)
        self.assertFalse(told["verified"])
        self.assertEqual(f"{len(told['faults'])} faults, the first 50 of them above", lines[-1])

    def test_what_cannot_be_read_exits_with_2(self):
        folder = os.path.join(self.folder, "unreadable")
        os.makedirs(folder)
        good = seeded_faults.Result(self.run_plan(os.path.join(HERE, "verify_results", "yard.plan")))
        header = json.dumps(good.header)
        rest = "\n".join(json.dumps(record) for record in good.records[1:])

        def expect(name, text, words):
            path = os.path.join(folder, name)
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            result = rubicon("verify", path)
            self.assertEqual((result.returncode, result.stdout), (2, ""), name)
            self.assertIn(words, result.stderr)
            self.assertTrue(result.stderr.startswith("rubicon: error: "), result.stderr)

        expect("empty", "", "empty:1: expected the header")
        expect("text", "hello\n", "text:1: expected JSON")
        expect("other", "{}\n", "expected 'type'")
        expect("torn", header + "\n" + rest[:-30], "expected JSON")
        expect("tasks", header.replace('"detail": "steps"', '"detail": "tasks"') + "\n" + rest, "expected every step")
        expect("deep", "[" * 100000, "too many brackets")
        expect("robot", header + "\n" + rest.replace('"robot": "left"', '"robot": "nobody"'), "a robot of the header")
        expect("huge", header + "\n" + rest.replace('"t": ', '"t": 1e400', 1), "expected")
        self.assertIn("there is no such file", rubicon("verify", os.path.join(folder, "missing")).stderr)
        self.assertEqual(rubicon("verify", folder).returncode, 2)
        self.assertEqual(rubicon("verify").returncode, 2)

    def test_a_result_without_schedules_exits_with_2(self):
        folder = os.path.join(self.folder, "half")
        os.makedirs(folder)
        seeded_faults.Result(self.run_plan(os.path.join(HERE, "verify_results", "yard.plan"))).write(folder)
        os.remove(os.path.join(folder, "schedule.csv"))
        self.assertIn("schedule.csv: there is no such file", rubicon("verify", folder).stderr)
        with open(os.path.join(folder, "schedule.csv"), "w", encoding="utf-8") as file:
            file.write("task\na\n")
        result = rubicon("verify", folder)
        self.assertEqual(result.returncode, 2)
        self.assertIn("schedule.csv: 2: expected a column 'robot'", result.stderr)


if __name__ == "__main__":
    unittest.main()
