"""Studies that search: the best of many variants without trying all, the same whatever the threads and kills."""

import csv
import io
import json
import os
import random
import signal
import subprocess
import time
import unittest

from result_case import RUBICON, ResultCase, rubicon

HOIST = "robot hoist { body hook { param z range(0, 20) step(0.5) speed(1 m/s) start(5); frame trans(0, 0, z); shape box(-0.1, -0.1, 0, 0.1, 0.1, 0.5); } tool hook; behaviour { chain { move_to(z, goal(z)) } } }"

# The best gang is 9 (with fewer it takes longer, and every mason beyond 9 stands in the way), the best beginning 3.4, the best
# method the third of five hoists in no order. 13 x 5 x any number: far more than a budget of 150.
PLAN = """plan house {
  currency "EUR";
  parameter gang = 2;
  parameter begin = 0;
  parameter method = "boards";
  robot hoist "{method}.robot";
  crew masons { size gang; cost 40 per h; }
  task wall { by masons; takes pert(4 h, 6 h, 8 h); }
  task idle { by masons; takes 12 h / min(gang, 9) + 1 h * max(gang - 9, 0) + 1 h * (begin - 3.4) * (begin - 3.4); after wall; }
  task lift { by hoist; go z 15; after idle; }
}
"""
VARY = 'vary gang 2 to 14 by 1; vary begin 0 to 9.5; vary method "boards", "frames", "tunnel", "panels", "bricks"; '

# The higher the load is lifted the less is left to do by hand; from 12 m on it meets the slab above.
LIFT = """plan lift { support off; robot h "hoist.robot"; crew gang { cost 40 per h; } parameter high = 6;
  site box(-3, -3, 12.5, 3, 3, 13);
  task up { by h; go z high; } task rest { by gang; takes 1 h * (20 - high); } }
"""


class Search(ResultCase):
    def setUp(self):
        super().setUp()
        self.write("house.plan", PLAN)
        for method, hours in (("boards", 5), ("frames", 3), ("tunnel", 0.5), ("panels", 4), ("bricks", 2)):
            self.write(method + ".robot", HOIST.replace("1 m/s", "%.9f m/s" % (10 / 3600 / hours)))

    def study(self, items, *arguments, expected=0, plan="house.plan"):
        path = self.write("s.study", 'study s { plan "%s"; %s }' % (plan, items))
        self.result = rubicon("study", path, *arguments)
        self.assertEqual(self.result.returncode, expected, self.result.stdout + self.result.stderr)
        return self.result.stdout

    def json_of(self, items, *arguments, expected=0, plan="house.plan"):
        return json.loads(self.study(items, "--format", "json", *arguments, expected=expected, plan=plan))

    def chosen(self, study):
        return dict(study["variants"][study["choice"]["chosen"] - 1]["set"])

    def test_it_finds_what_is_known_to_be_the_best_and_its_runs_can_be_made_again(self):
        items = VARY + "design search 150; runs 3; seed 5; choose least mean(makespan);"
        study = self.json_of(items)
        self.assertEqual((study["design"], len(study["variants"])), ("search", 150))
        settings = self.chosen(study)
        self.assertEqual((settings["gang"], settings["method"]), ("9", "tunnel"))
        self.assertLess(abs(float(settings["begin"]) - 3.4), 0.2)
        self.assertEqual(study["variants"][0]["set"], {"gang": "2", "begin": "0", "method": "boards"}, "the first values are tried first")
        row = [each for each in csv.DictReader(io.StringIO(self.study(items, "--format", "csv"))) if each["variant"] == str(study["choice"]["chosen"])][0]
        sets = [part for name, value in settings.items() for part in ("--set", "%s=%s" % (name, value))]
        times = []
        for run in range(3):
            made = rubicon("run", os.path.join(self.folder, "house.plan"), *sets, "--sample", "5:%d" % run, "--format", "json")
            times.append(json.loads(made.stdout)["process_time"])
        self.assertAlmostEqual(float(row["makespan mean"]), sum(times) / 3, 5)

    def test_it_does_far_better_than_as_many_at_random(self):
        best = {}
        for design in ("search", "latin"):
            found = []
            for seed in range(3):
                study = self.json_of(VARY + "design %s 100; seed %d; choose least mean(makespan);" % (design, seed))
                found.append(min(each["value"] for each in study["choice"]["judged"]))
            best[design] = sorted(found)[1]
        self.assertLess(best["search"] + 1800, best["latin"], best)

    def test_what_is_rejected_never_wins(self):
        self.write("hoist.robot", HOIST)
        self.write("lift.plan", LIFT)
        study = self.json_of("vary high 6.0 to 19.5; design search 60; choose least mean(cost);", plan="lift.plan")
        high = float(self.chosen(study)["high"])
        self.assertTrue(11.5 < high <= 12.01, high)
        rejected = [each["variant"] for each in study["choice"]["passed_over"]]
        self.assertTrue(rejected)
        self.assertTrue(all(float(study["variants"][i - 1]["set"]["high"]) > 12 for i in rejected))
        text = self.study("vary high 13.0 to 19.5; design search 30; choose least mean(cost);", plan="lift.plan", expected=1)
        self.assertIn("none is good; the first are shown", text)
        self.assertIn("h.hook meets site", text)

    def test_limits_hold_and_one_that_cannot_run_is_passed_over(self):
        study = self.json_of('vary gang 3, 0, 1 to 2, 4 to 14; vary begin 0 to 9.5; design search 80; choose least mean(cost) with mean(makespan) <= 15 h;')
        value = [each["value"] for each in study["choice"]["judged"]]
        makespans = {i + 1: each["answers"][0]["mean"] for i, each in enumerate(study["variants"]) if "fault" not in each}
        self.assertTrue(value and all(makespans[each["variant"]] <= 15 * 3600 for each in study["choice"]["judged"]))

    def test_without_a_rule_it_looks_for_the_front_of_time_and_cost(self):
        study = self.json_of(VARY + "design search 160;")
        front = [study["variants"][i - 1]["set"] for i in study["pareto"]]
        self.assertTrue(all(each["method"] == "tunnel" for each in front), front)
        text = self.study(VARY + "design search 160;")
        self.assertIn("160 variants of house.plan", text)
        self.assertIn("shown; --format csv tells all", text)

    def test_few_combinations_are_all_tried(self):
        study = self.json_of('vary gang 2 to 4; vary method "boards", "tunnel"; design search 50; choose least mean(makespan);')
        full = self.json_of('vary gang 2 to 4; vary method "boards", "tunnel"; choose least mean(makespan);')
        self.assertEqual(study["variants"], full["variants"])

    def test_the_same_bytes_with_any_number_of_threads_and_after_kills(self):
        items = VARY + "design search 60; runs 20; seed 3; choose least p80(makespan);"
        texts, folders = set(), []
        for jobs in (1, 2, 4):
            out = os.path.join(self.folder, "out%d" % jobs)
            texts.add(self.study(items, "--out", out, "--jobs", str(jobs)))
            folders.append(self.files(out))
        self.assertEqual(len(texts), 1)
        self.assertTrue(all(each == folders[0] for each in folders))
        out, path = os.path.join(self.folder, "killed"), os.path.join(self.folder, "s.study")
        progress, delay, kills = os.path.join(out, "study.progress"), random.Random(4), 0
        for _ in range(40):
            process = subprocess.Popen([RUBICON, "study", path, "--out", out, "--resume"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            before = os.path.getsize(progress) if os.path.exists(progress) else 0
            deadline = time.monotonic() + 5
            while kills < 5 and time.monotonic() < deadline and process.poll() is None:
                if os.path.exists(progress) and os.path.getsize(progress) > before + delay.randrange(1, 20000):
                    process.send_signal(signal.SIGKILL)
                    kills += 1
                    break
            text, errors = process.communicate(timeout=120)
            if process.returncode != -signal.SIGKILL:
                break
        self.assertGreaterEqual(kills, 3)
        self.assertEqual((process.returncode, errors), (0, ""))
        self.assertEqual(text, texts.pop())
        self.assertEqual(self.files(out), folders[0])

    def files(self, folder):
        result = {}
        for name in sorted(os.listdir(folder)):
            with open(os.path.join(folder, name), "rb") as file:
                result[name] = file.read()
        return result

    def test_mistakes_are_told_at_their_places(self):
        for items, message in (("vary gang 2, 3; design search;", "design search: expected how many variants at most, 2 to 100000"),
                               ("vary gang 2, 3; design search 2.5;", "design search: expected how many variants at most"),
                               ("vary gang 2, 3; design search 200000;", "design search: expected how many variants at most"),
                               ("vary gang 2, 3; design search 20 m;", "design search: expected how many variants at most"),
                               ("design search 20;", "there is nothing to search among"),
                               ("vary gang 2, 3; design serch 20;", "unknown design 'serch': full, latin, one_at_a_time or search"),
                               ("vary gng 2, 3; design search 20;", "the plan has no parameter 'gng'")):
            self.study(items, expected=2)
            self.assertIn(message, self.result.stderr)


if __name__ == "__main__":
    unittest.main()
