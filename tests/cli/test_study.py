"""Studies: many runs of a plan, the same whatever the threads and however often they were killed."""

import csv
import io
import json
import os
import random
import re
import resource
import signal
import subprocess
import time
import unittest

from result_case import RUBICON, rubicon
from study_case import PLAN, StudyCase


class Study(StudyCase):
    def study(self, items, *arguments, expected=0, name="s.study"):
        path = self.path_of(items, name)
        self.result = rubicon("study", path, *arguments)
        self.assertEqual(self.result.returncode, expected, self.result.stdout + self.result.stderr)
        return self.result.stdout

    def json_of(self, items, *arguments, expected=0):
        return json.loads(self.study(items, "--format", "json", *arguments, expected=expected))

    def test_a_run_of_a_study_is_the_run_that_its_row_names(self):
        out = os.path.join(self.folder, "out")
        self.study("vary floors 2, 3; vary gang 2, 3; runs 12; seed 5; ask makespan, cost, finish(slab[2]);", "--out", out)
        self.assertEqual(sorted(os.listdir(out)), ["drivers.csv", "progress.csv", "runs.csv", "study.html", "study.json", "variants.csv"])
        with open(os.path.join(out, "runs.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 48)
        for row in random.Random(1).sample(rows, 6):
            run = rubicon("run", os.path.join(self.folder, "house.plan"), "--set", "floors=" + row["floors"], "--set", "gang=" + row["gang"],
                          "--sample", row["seed"] + ":" + row["run"], "--format", "json")
            schedule = json.loads(run.stdout)
            self.assertEqual(schedule["process_time"], float(row["makespan"]))
            self.assertEqual(schedule["cost"], float(row["cost"]))
            slab = [task for task in schedule["tasks"] if task["task"] == "slab_2"][0]
            self.assertAlmostEqual(slab["start"] + slab["duration"], float(row["finish(slab_2)"]), 6)

    def test_draws_are_the_same_in_all_variants(self):
        study = self.json_of("vary gang 2, 3; runs 50; choose least mean(makespan);")
        self.assertEqual(*[variant["answers"][0]["mean"] for variant in study["variants"]])
        self.assertEqual(study["choice"]["equal"], [1, 2])
        self.assertEqual(study["choice"]["chosen"], 1)

    def test_without_runs_durations_stand_for_their_means(self):
        text = self.study("vary floors 1 to 3;")
        self.assertIn("3 variants of house.plan, durations at their means", text)
        plain = json.loads(rubicon("run", os.path.join(self.folder, "house.plan"), "--format", "json").stdout)
        study = self.json_of("vary floors 1 to 3;")
        self.assertEqual(study["variants"][2]["answers"][0]["mean"], plain["process_time"])

    def test_the_rule_passes_over_what_is_late(self):
        study = self.json_of('vary floors 1 to 3; runs 100; choose most mean(cost) with p80(finish) <= "2026-03-03";')
        self.assertEqual(study["choice"]["chosen"], 2)
        self.assertEqual([each["variant"] for each in study["choice"]["passed_over"]], [3])
        self.study('vary floors 1 to 3; runs 100; choose most mean(cost) with p80(finish) <= "2026-03-01";', expected=1)
        self.assertIn("chosen: none", self.result.stdout)

    def test_the_same_bytes_with_any_number_of_threads(self):
        items = "vary floors 2 to 5; runs at most 300 until width(p80(finish)) < 2 h; seed 3; choose least p95(cost);"
        texts, folders = set(), []
        for jobs in (1, 2, 4, 9):
            out = os.path.join(self.folder, "out%d" % jobs)
            texts.add(self.study(items, "--out", out, "--jobs", str(jobs)))
            folders.append(self.files(out))
        self.assertEqual(len(texts), 1)
        self.assertTrue(all(each == folders[0] for each in folders))

    def test_killed_ten_times_it_ends_with_the_same_bytes(self):
        items = "vary floors 2 to 5; runs 2000; seed 3; ask makespan, cost, waiting; choose least p95(cost);"
        whole = os.path.join(self.folder, "whole")
        expected = self.study(items, "--out", whole)
        out = os.path.join(self.folder, "killed")
        path = os.path.join(self.folder, "s.study")
        kills, delay = 0, random.Random(2)
        progress = os.path.join(out, "study.progress")
        sizes = []
        for _ in range(60):
            process = subprocess.Popen([RUBICON, "study", path, "--out", out, "--resume"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            before = os.path.getsize(progress) if os.path.exists(progress) else 0
            if kills < 10:
                # Killed once it has written more, somewhere in the middle of a line as a rule.
                deadline = time.monotonic() + 5
                while time.monotonic() < deadline and process.poll() is None:
                    if os.path.exists(progress) and os.path.getsize(progress) > before + delay.randrange(1, 40000):
                        break
                process.send_signal(signal.SIGKILL)
            text, _ = process.communicate(timeout=120)
            if process.returncode == 0:
                break
            kills += 1
            sizes.append(os.path.getsize(progress))
        self.assertGreaterEqual(kills, 5)
        self.assertEqual(text, expected)
        self.assertEqual(self.files(out), self.files(whole))
        self.assertEqual(sizes, sorted(sizes), "no run that was finished is lost")

    def test_a_damaged_log_costs_the_runs_that_are_damaged(self):
        items = "vary floors 2, 3; runs 4000;"
        whole, out = os.path.join(self.folder, "whole"), os.path.join(self.folder, "out")
        expected = self.study(items, "--out", whole)
        # Killed as soon as it has written something; then lines of tasks that are not there, and nonsense.
        path, progress = os.path.join(self.folder, "s.study"), os.path.join(out, "study.progress")
        process = subprocess.Popen([RUBICON, "study", path, "--out", out], stdout=subprocess.DEVNULL)
        deadline = time.monotonic() + 5
        while time.monotonic() < deadline and process.poll() is None and not (os.path.exists(progress) and os.path.getsize(progress) > 2000):
            pass
        process.kill()
        process.wait()
        with open(progress, encoding="utf-8") as file:
            head, *noted = file.read().splitlines(keepends=True)
        # What is damaged within a line looks like another run: another first time, another run, two lines as one.
        runs = [line for line in noted if line.startswith("run\t")][:3]
        self.assertEqual(len(runs), 3)
        runs[0] = re.sub(r"^(run\t\d+\t\d+\t)", r"\g<1>9", runs[0])
        runs[1] = re.sub(r"^run\t(\d+)\t\d+", r"run\t\g<1>\t77", runs[1])
        runs[2] = runs[2][:len(runs[2]) // 2] + runs[2][len(runs[2]) // 3:]
        with open(progress, "w", encoding="utf-8") as file:
            file.write(head + "".join(runs))
            file.write("run\t0\t0\t1 1 0\t99999999\t\t\t\t.\nrun\t1\t3\tinf inf 1\t\t\t-7\tno\t.\nrun\t0\t1\t1 1\t.\n\0\0\nvariant\t.\n")
        self.assertEqual(self.study(items, "--out", out, "--resume"), expected)
        self.assertEqual(self.files(out), self.files(whole))

    def test_it_does_not_go_on_from_another_study_or_plan(self):
        out = os.path.join(self.folder, "out")
        os.mkdir(out)
        self.study("vary floors 2, 3; runs 5;", "--out", out)
        with open(os.path.join(out, "study.progress"), "w", encoding="utf-8") as file:
            file.write("study\tabc\t.\n")
        self.study("vary floors 2, 3; runs 5;", "--out", out, "--resume", expected=2)
        self.assertIn("are of another study", self.result.stderr)
        self.assertIn("without --resume it begins again", self.result.stderr)
        self.study("vary floors 2, 3; runs 5;", "--out", out)
        self.assertNotIn("study.progress", os.listdir(out))

    def test_it_does_not_go_on_with_a_mesh_that_has_changed(self):
        corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
        faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
        self.write("stone.obj", "".join("v %d %d %d\n" % each for each in corners) + "".join("f %d %d %d\n" % tuple(i + 1 for i in each) for each in faces))
        self.write("house.plan", PLAN.replace("parameter floors", 'component stone { shape mesh("stone.obj", m); at trans(0, 0, 0); }\n  parameter floors'))
        out = os.path.join(self.folder, "out")
        process = subprocess.Popen([RUBICON, "study", self.path_of("vary floors 2, 3; runs 20000;"), "--out", out], stdout=subprocess.DEVNULL)
        progress, deadline = os.path.join(out, "study.progress"), time.monotonic() + 20
        while time.monotonic() < deadline and process.poll() is None and not (os.path.exists(progress) and os.path.getsize(progress) > 2000):
            pass
        process.kill()
        process.wait()
        with open(os.path.join(self.folder, "stone.obj"), "a", encoding="utf-8") as file:
            file.write("v 0 0 2\nf 1 2 5\nf 1 5 3\nf 2 3 5\n")
        self.study("vary floors 2, 3; runs 20000;", "--out", out, "--resume", expected=2)
        self.assertIn("has changed since the runs in this folder were made", self.result.stderr)

    def test_one_that_cannot_run_is_told_and_the_others_go_on(self):
        study = self.json_of("vary gang 2, 1, 3; runs 20; choose least mean(cost);")
        self.assertIn("fault", study["variants"][1])
        self.assertEqual([variant.get("runs") for variant in study["variants"]], [20, None, 20])
        self.assertEqual(study["choice"]["passed_over"], [{"variant": 2, "why": "cannot run"}])
        # Also the first one: what is compared with the first is compared with the first that runs.
        study = self.json_of("vary gang 1, 2, 3; runs 20; choose least mean(cost);")
        self.assertEqual([variant.get("runs") for variant in study["variants"]], [None, 20, 20])
        self.assertIn("fault", study["variants"][0])
        self.assertNotIn("difference", study["variants"][1]["answers"][0])
        self.assertIn("difference", study["variants"][2]["answers"][0])
        # Where none runs, and where a setting has a wrong kind, the study is wrong.
        self.study("vary gang 1; runs 20;", expected=2)
        self.assertIn("the plan cannot run with the first values", self.result.stderr)
        self.study("vary gang 2 m, 2; runs 20;", expected=2)
        self.assertIn("s.study:1:35: error: the parameter is", self.result.stderr)

    def test_behaviours_are_varied_by_their_files(self):
        texts = {
            "cart.robot": "robot cart { time_step 1; body base { param x range(0, 20) step(1) start(0); param y range(0, 20) step(1) start(0);"
                          " frame trans(x, y, 0); shape box(-0.3, -0.3, 0, 0.3, 0.3, 1); } tool base; behaviour \"both.motion\"; }",
            "both.motion": "chain { move_to(x, goal(x)), move_to(y, goal(y)) };",
            "diagonal.motion": "chain { follow };",
            "carts.plan": "plan carts { parameter way = \"both\"; robot plain \"cart.robot\";"
                          " robot other \"cart.robot\" at trans(0, 30, 0) { behaviour \"{way}.motion\"; }"
                          " task a { by plain; go x 8, y 6; } task b { by other; go x 8, y 6; after a; } }",
            "carts.study": "study carts { plan \"carts.plan\"; vary way \"both\", \"diagonal\"; ask finish(a), makespan; }",
        }
        for name, text in texts.items():
            with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        result = rubicon("study", os.path.join(self.folder, "carts.study"), "--format", "json")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        study = json.loads(result.stdout)
        asked = [[variant["answers"][k]["mean"] for k in study["asked"]] for variant in study["variants"]]
        # 8 and 6 steps one after the other, or at once.
        self.assertEqual(asked, [[14, 28], [14, 22]])
        plan = os.path.join(self.folder, "carts.plan")
        result = rubicon("check", plan, "--set", "way=bott")
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        self.assertIn("behaviour 'bott.motion'", result.stderr)

    def test_mistakes_are_told_at_their_places(self):
        for items, message in (("vary flors 2;", "s.study:1:35: error: the plan has no parameter 'flors'; did you mean floors?"),
                               ("ask utilisation(mason);", "the plan has no robot or crew 'mason'; did you mean masons?"),
                               ("ask finish(slab[9]);", "the plan has no task 'slab_9'"),
                               ("vary floors 3 to 2;", "the range 3 to 2 is empty"),
                               ("vary floors 2 m;", "the parameter is"),
                               ('plan "no.plan";', "a study says 'plan' once")):
            self.study(items, expected=2)
            self.assertIn(message, self.result.stderr)
        self.write("house.plan", PLAN.replace('start_at "2026-03-02 08:00";', ""))
        self.study('choose least mean(cost) with p80(finish) <= "2026-03-03";', expected=2)
        self.assertIn("the plan does not say when it begins", self.result.stderr)
        checked = rubicon("check", os.path.join(self.folder, "s.study"))
        self.assertEqual(checked.returncode, 2)

    def test_variants_are_compared_run_by_run_in_json_and_csv(self):
        out = os.path.join(self.folder, "out")
        items = "vary floors 2, 3; runs 200; ask makespan, cost;"
        study = self.json_of(items, "--out", out)
        self.assertNotIn("difference", study["variants"][0]["answers"][0])
        difference = study["variants"][1]["answers"][0]["difference"]
        means = [variant["answers"][0]["mean"] for variant in study["variants"]]
        self.assertAlmostEqual(difference["mean"], means[1] - means[0], 4)
        with open(os.path.join(out, "runs.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        pairs = [float(b["makespan"]) - float(a["makespan"]) for a, b in zip(rows[:200], rows[200:])]
        mean = sum(pairs) / 200
        half = 1.97196 * (sum((each - mean) ** 2 for each in pairs) / 199 / 200) ** 0.5  # Student's, 199 degrees of freedom
        self.assertAlmostEqual(difference["interval"][0], mean - half, 0)
        self.assertAlmostEqual(difference["interval"][1], mean + half, 0)
        width = study["variants"][1]["answers"][0]["mean_interval"]
        self.assertLess(2 * half, width[1] - width[0], "the same draws: narrower than either mean")
        with open(os.path.join(out, "variants.csv"), encoding="utf-8") as file:
            table = list(csv.DictReader(file))
        self.assertEqual(table[0]["makespan difference"], "")
        self.assertAlmostEqual(float(table[1]["makespan difference_low"]), difference["interval"][0], 4)

    def test_drivers_and_progress_are_in_json_csv_and_page(self):
        out = os.path.join(self.folder, "out")
        study = self.json_of("vary floors 2, 3; runs 200;", "--out", out)
        with open(os.path.join(out, "drivers.csv"), encoding="utf-8") as file:
            drivers = list(csv.DictReader(file))
        self.assertEqual([(int(each["variant"]), each["duration"], float(each["correlation"])) for each in drivers],
                         [(variant["variant"], each["duration"], each["correlation"]) for variant in study["variants"] for each in variant["drivers"]])
        self.assertLess(float(drivers[0]["low"]), float(drivers[0]["high"]))
        with open(os.path.join(out, "progress.csv"), encoding="utf-8") as file:
            progress = list(csv.DictReader(file))
        self.assertEqual(len(progress), 42)
        self.assertEqual([float(each["p90"]) for each in progress[:21]], study["variants"][0]["progress"]["p90"])
        self.assertTrue(all(float(each["p10"]) <= float(each["p50"]) <= float(each["p90"]) for each in progress))
        with open(os.path.join(out, "study.html"), encoding="utf-8") as file:
            page = file.read()
        for part in ('"drivers":', '"progress":', '"difference":', "What drives the time", "Progress", "less variant"):
            self.assertIn(part, page)

    def test_films_are_those_of_the_runs_at_the_quantiles(self):
        out = os.path.join(self.folder, "out")
        self.study("vary floors 2, 3; vary gang 2, 3; runs 40; seed 5; choose least p80(makespan);", "--out", out, "--films")
        with open(os.path.join(out, "study.json"), encoding="utf-8") as file:
            study = json.load(file)
        chosen = study["choice"]["chosen"]
        quantiles = study["variants"][chosen - 1]["answers"][0]["quantiles"]
        self.assertEqual({film["run"] for film in study["films"] if film["variant"] == chosen}, {each["run"] for each in quantiles})
        for film in study["films"]:
            variant = study["variants"][film["variant"] - 1]
            verified = rubicon("verify", os.path.join(out, film["folder"]))
            self.assertEqual(verified.returncode, 0, verified.stdout)
            with open(os.path.join(out, film["folder"], "schedule.json"), encoding="utf-8") as file:
                time = json.load(file)["process_time"]
            self.assertIn(time, [each["value"] for each in variant["answers"][0]["quantiles"] if each["run"] == film["run"]])
        with open(os.path.join(out, "study.html"), encoding="utf-8") as file:
            self.assertIn('"films":[', file.read())
        self.assertIn("--out", rubicon("study", os.path.join(self.folder, "s.study"), "--films").stderr)

    def test_a_full_disk_loses_no_run_that_is_noted(self):
        """A file system of 64 KB: the study ends with a message; with more room it goes on, and the result is that of one that never stopped."""
        items = "vary floors 2 to 5; runs 2000; seed 3;"
        whole, small = os.path.join(self.folder, "whole"), os.path.join(self.folder, "small")
        expected = self.study(items, "--out", whole)
        os.mkdir(small)
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", small], capture_output=True, check=False)
        if mounted.returncode != 0:
            self.skipTest("a file system can be mounted by root alone")
        try:
            out = os.path.join(small, "out")
            self.study(items, "--out", out, expected=2)
            self.assertIn("No space left on device", self.result.stderr)
            noted = os.path.getsize(os.path.join(out, "study.progress"))
            self.assertGreater(noted, 30000)
            self.study(items, "--out", out, "--resume", expected=2)  # still full
            self.assertGreaterEqual(os.path.getsize(os.path.join(out, "study.progress")), noted - 4096, "what was noted stays")
            subprocess.run(["mount", "-o", "remount,size=64m", small], check=True)
            with open(os.path.join(out, "study.progress"), encoding="utf-8") as file:
                before = sum(re.search(r"^run\t.*\t\.\t[0-9a-f]{8}\n$", line) is not None for line in file)
            self.assertGreater(before, 100)
            self.assertEqual(self.study(items, "--out", out, "--resume"), expected)
            self.assertEqual(self.files(out), self.files(whole))
        finally:
            subprocess.run(["umount", small], check=True)

    def test_a_file_that_may_not_grow_is_a_full_disk(self):
        items = "vary floors 2 to 5; runs 2000; seed 3;"
        out, whole = os.path.join(self.folder, "out"), os.path.join(self.folder, "whole")
        expected = self.study(items, "--out", whole)
        command = [RUBICON, "study", self.path_of(items), "--out", out]
        limited = subprocess.run(command, capture_output=True, text=True, check=False, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (99_000, 99_000)))
        self.assertEqual(limited.returncode, 2, limited.stderr)
        self.assertIn("File too large", limited.stderr)
        self.assertEqual(self.study(items, "--out", out, "--resume"), expected)
        self.assertEqual(self.files(out), self.files(whole))

    def test_a_distribution_with_negative_durations_is_told(self):
        self.write("house.plan", PLAN.replace("pert(4 h, 6 h, 14 h)", "triangular(-4 h, 6 h, 14 h)"))
        self.study("vary floors 2, 3; runs 5;", expected=2)
        self.assertIn("house.plan", self.result.stderr)
        # Of a later variant: it is told, and the others go on.
        self.write("house.plan", PLAN.replace("pert(4 h, 6 h, 14 h)", "triangular(4 h - floors * 2 h, 6 h, 14 h)"))
        study = self.json_of("vary floors 2, 3, 1; runs 5;")
        self.assertEqual(["fault" in variant for variant in study["variants"]], [False, True, False])
        self.assertIn("house.plan", study["variants"][1]["fault"])

    def test_tables_and_csv_have_a_row_a_variant(self):
        items = "vary floors 2, 3; runs 150; ask makespan, utilisation(masons), waiting(resource), rejected;"
        rows = list(csv.DictReader(io.StringIO(self.study(items, "--format", "csv"))))
        self.assertEqual([row["floors"] for row in rows], ["2", "3"])
        self.assertLess(float(rows[0]["makespan p10"]), float(rows[0]["makespan p95"]))
        text = self.study(items)
        for part in ("makespan", "utilisation(masons)", "waiting(resource)", "what drives the makespan of variant 1", "critical in most runs"):
            self.assertIn(part, text)


if __name__ == "__main__":
    unittest.main()
