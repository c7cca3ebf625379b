"""The folder of a result and the files of a run: exchanged as a whole, whenever a run is ended, and the same bytes however
the path of the plan was typed. RUBICON_KILLS in the environment gives more kills."""

import hashlib
import os
import random
import re
import shutil
import signal
import stat
import subprocess
import tempfile
import time
import unittest

RUBICON = os.environ["RUBICON"]
KILLS = int(os.environ.get("RUBICON_KILLS", "12"))
NAMES = ("trace.jsonl", "schedule.json", "schedule.csv", "report.html")

ROBOT = """robot gantry {
  body trolley {
    param x step(0.5) range(-10, 6000);
    frame trans(x, 0, 0);
    shape box(-0.4, -0.4, 0, 0.4, 0.4, 1);
  }
  tool trolley;
  behaviour "move.motion";
}
"""
PLAN = """plan p {{
  robot "../robots/gantry.robot";
  component wall {{ shape box(7000, -9, 0, 7001, 9, 1); }}
  start x 0;
  goal x {goal};
}}
"""


def rubicon(*arguments, cwd=None):
    return subprocess.run([RUBICON, *arguments], capture_output=True, text=True, timeout=120, cwd=cwd)


def files_of(folder):
    """Name to bytes of the plain files of a folder."""
    result = {}
    for name in sorted(os.listdir(folder)):
        path = os.path.join(folder, name)
        if os.path.isfile(path):
            with open(path, "rb") as file:
                result[name] = file.read()
    return result


def digests(folder):
    return {name: hashlib.sha256(text).hexdigest() for name, text in files_of(folder).items()}


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = os.path.realpath(folder.name)
        self.write("robots/gantry.robot", ROBOT)
        self.write("robots/move.motion", "chain { move_to(x, goal(x)) };\n")
        self.short = self.write("plans/short.plan", PLAN.format(goal=40))
        self.long = self.write("plans/long.plan", PLAN.format(goal=1500))
        os.makedirs(self.path("results"))

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def write(self, name, text):
        path = self.path(name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def run_plan(self, plan, out, cwd=None):
        result = rubicon("run", plan, "--out", out, cwd=cwd)
        self.assertEqual(result.returncode, 0, result.stderr)

    def result(self, folder):
        """The digests of a result as the commands find it: what was moving in first."""
        staged = os.path.join(folder, ".rubicon-new")
        found = digests(folder) | (digests(staged) if os.path.isdir(staged) else {})
        return {name: digest for name, digest in found.items() if name in NAMES}

    def strangers(self, folder):
        """What the command left over in and beside a result folder."""
        return [name for top in (folder, os.path.dirname(folder)) for name in os.listdir(top) if ".rubicon-" in name]


class Whole(Case):
    def test_files_that_are_not_ours_stay(self):
        out = self.path("results/out")
        self.run_plan(self.short, out)
        notes = self.write("results/out/notes.txt", "mine")
        os.chmod(notes, 0o640)
        os.symlink("nowhere", self.path("results/out/link"))
        os.chmod(out, 0o750)
        inode = os.stat(notes).st_ino
        for folders in (False, True):
            if folders:
                self.write("results/out/photos/deep/one.txt", "mine too")
            self.run_plan(self.long if not folders else self.short, out)
            self.assertEqual(sorted(os.listdir(out)), sorted(
                [*(n for n in NAMES if n in os.listdir(out)), "link", "notes.txt"] + ["photos"] * folders))
            self.assertEqual((os.stat(notes).st_ino, stat.S_IMODE(os.stat(notes).st_mode)), (inode, 0o640))
            self.assertEqual(os.readlink(self.path("results/out/link")), "nowhere")
            self.assertEqual(stat.S_IMODE(os.stat(out).st_mode), 0o750)
            self.assertEqual(rubicon("verify", out).returncode, 0)
            self.assertEqual(self.strangers(out), [])
        self.assertEqual(files_of(self.path("results/out/photos/deep")), {"one.txt": b"mine too"})

    def test_a_link_to_the_folder_and_the_folder_one_is_in(self):
        out = self.path("results/out")
        self.run_plan(self.short, out)
        os.symlink("results/out", self.path("link"))
        self.run_plan(self.long, self.path("link"))
        self.assertTrue(os.path.islink(self.path("link")))
        expected = digests(out)
        # A shell that is in the folder stays in it.
        inode = os.stat(out).st_ino
        self.run_plan(self.short, ".", cwd=out)
        self.assertEqual(os.stat(out).st_ino, inode)
        self.assertNotEqual(digests(out), expected)
        self.run_plan(self.long, "../out", cwd=out)
        self.assertEqual(digests(out), expected)
        self.assertEqual(self.strangers(out), [])

    def test_folders_on_the_way_are_made(self):
        out = self.path("results/a/b/out/")
        self.run_plan(self.short, out)
        self.assertEqual(rubicon("verify", out).returncode, 0)
        self.assertEqual(os.listdir(self.path("results/a/b")), ["out"])

    def test_what_cannot_be_written_leaves_the_old_result(self):
        out = self.path("results/out")
        self.run_plan(self.short, out)
        before = digests(out)
        if os.geteuid() != 0:
            os.chmod(out, 0o555)
            self.assertEqual(rubicon("run", self.long, "--out", out).returncode, 2)
            os.chmod(out, 0o755)
        # A limit on the size of files stands for a full disk.
        result = subprocess.run(["bash", "-c", 'trap "" XFSZ; ulimit -f 20; exec "$@"', "-", RUBICON, "run", self.long,
                                 "--out", out], capture_output=True, text=True)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn(f"cannot write '{out}/trace.jsonl'", result.stderr)
        self.assertEqual((digests(out), self.strangers(out)), (before, []))
        for wrong in (self.short, self.path("results/out/schedule.csv")):
            self.assertEqual(rubicon("run", self.long, "--out", wrong).returncode, 2)
        os.symlink("nowhere", self.path("lost"))
        self.assertIn("leads nowhere", rubicon("run", self.long, "--out", self.path("lost")).stderr)

    def test_a_folder_without_a_parent_to_write_to(self):
        if os.geteuid() == 0:
            self.skipTest("root may write everywhere")
        out = self.path("results/out")
        self.run_plan(self.short, out)
        os.chmod(self.path("results"), 0o555)
        self.addCleanup(os.chmod, self.path("results"), 0o755)
        self.run_plan(self.long, out)
        self.assertEqual(rubicon("verify", out).returncode, 0)
        self.assertEqual(self.strangers(out), [])

    def test_runs_at_the_same_time(self):
        out = self.path("results/out")
        wanted = []
        for plan in (self.short, self.long):
            self.run_plan(plan, out)
            wanted.append(digests(out))
        for folders in (False, True):
            if folders:
                os.makedirs(self.path("results/out/photos"))
            runs = [subprocess.Popen([RUBICON, "run", plan, "--out", out], stdout=subprocess.DEVNULL,
                                     stderr=subprocess.PIPE) for plan in (self.short, self.long) * 3]
            self.assertEqual([run.communicate(timeout=60)[1] for run in runs], [b""] * len(runs))
            if not folders:
                self.assertIn(digests(out), wanted)
            self.assertEqual(self.strangers(out), [])

    def test_a_result_that_was_ended_while_it_moved_in_is_read_as_the_new_one(self):
        out, new = self.path("results/out"), self.path("results/new")
        self.run_plan(self.short, out)
        self.run_plan(self.long, new)
        tried = rubicon("export", new, "--csv", "-").stdout
        staged = os.path.join(out, ".rubicon-new")
        shutil.copytree(new, staged)
        os.replace(os.path.join(staged, "schedule.json"), os.path.join(out, "schedule.json"))
        self.assertEqual(rubicon("verify", out).returncode, 0)
        self.assertEqual(rubicon("export", out, "--csv", "-").stdout, tried)
        self.run_plan(self.short, out)
        self.assertEqual(self.strangers(out), [])
        self.assertEqual(rubicon("verify", out).returncode, 0)

    def test_what_a_killed_run_left_is_removed_but_what_is_not_ours_comes_back(self):
        out = self.path("results/out")
        self.run_plan(self.short, out)
        left = self.path("results/.out.rubicon-AbCd12")
        shutil.copytree(out, left)
        self.write("results/.out.rubicon-AbCd12/notes.txt", "mine")
        self.write("results/.out.rubicon-AbCd12x/notes.txt", "no folder of ours")
        self.write("results/.other.rubicon-AbCd12/notes.txt", "of another result")
        self.run_plan(self.long, out)
        self.assertFalse(os.path.exists(left))
        self.assertEqual(files_of(out)["notes.txt"], b"mine")
        self.assertTrue(os.path.exists(self.path("results/.out.rubicon-AbCd12x")))
        self.assertTrue(os.path.exists(self.path("results/.other.rubicon-AbCd12")))


class Foreign(Case):
    """A name tells nothing: only what an older result left in the folder may be replaced or removed."""

    MINE = ("runs.csv", "jobs.csv", "agents.csv", "loads.csv", "charts.csv", "walk.csv", "variants.csv", "drivers.csv",
            "progress.csv", "study.json", "study.html", "ways.json", "charts.svg", "trace.jsonl.gz")

    def test_files_of_somebody_with_names_of_ours_stay(self):
        self.write("work/times.csv", "hook\n100\n150\n")
        for name in self.MINE:
            self.write("work/" + name, "hook\n100\n150\n")
        plan = self.write("work/site.plan", """plan site { crew a; parameter n = 1;
  task x { by a; takes measured("runs.csv", min, column "hook"); } }""")
        mine = files_of(self.path("work"))
        os.makedirs(self.path("work/walk.json"))
        for out, cwd in (("work", self.folder), (".", self.path("work"))):
            self.run_plan("site.plan" if cwd != self.folder else plan, out, cwd=cwd)
            self.assertEqual({name: text for name, text in files_of(self.path("work")).items() if name in mine}, mine)
            self.assertEqual(rubicon("verify", self.path("work")).returncode, 0)
            self.assertEqual(self.strangers(self.path("work")), [])
        # A study would write some of them: it refuses before it computes.
        study = self.write("work/s.study", 'study s { plan "site.plan"; vary n 1, 2; runs 20; }')
        before = files_of(self.path("work"))
        result = rubicon("study", study, "--out", self.path("work"))
        self.assertEqual(result.returncode, 2)
        self.assertIn(f"'{self.path('work')}/runs.csv' is read here: write to another folder", result.stderr)
        self.assertEqual(files_of(self.path("work")), before)

    def test_a_result_does_not_replace_what_is_not_one(self):
        out = self.path("results/out")
        names = ("schedule.csv", "schedule.json", "trace.jsonl", "report.html")
        for name in names:
            self.write("results/out/" + name, '{"tasks": [], "of": "my planning tool"}\n')
            result = rubicon("run", self.short, "--out", out)
            if name not in NAMES or name == "report.html" and result.returncode == 0:
                self.skipTest("this build has no page")
            self.assertEqual(result.returncode, 2)
            self.assertIn(f"'{out}/{name}' is not from an earlier result", result.stderr)
            self.assertEqual(os.listdir(out), [name])
            os.remove(os.path.join(out, name))
        # A table of ours alone, as somebody copies it to read it, is theirs.
        self.run_plan(self.short, self.path("results/other"))
        shutil.copy(self.path("results/other/schedule.csv"), out)
        self.assertEqual(rubicon("run", self.short, "--out", out).returncode, 2)
        os.remove(os.path.join(out, "schedule.csv"))
        os.symlink(self.path("results/other/schedule.csv"), os.path.join(out, "schedule.csv"))
        self.assertEqual(rubicon("run", self.short, "--out", out).returncode, 2)
        self.write("results/out/study.progress", "mine")
        self.write("plans/s.study", 'study s { plan "short.plan"; runs 1; }')
        result = rubicon("study", self.path("plans/s.study"), "--out", out)
        self.assertEqual((result.returncode, files_of(out)["study.progress"]), (2, b"mine"), result.stderr)

    def test_results_replace_each_other_and_earlier_versions(self):
        out = self.path("results/out")
        plan = self.write("plans/crew.plan", "plan c { crew a; parameter n = 1; task x { by a; takes uniform(1 min, 5 min); } }")
        study = self.write("plans/s.study", 'study s { plan "crew.plan"; vary n 1, 2; runs 20; }')
        empty = self.write("plans/empty.plan", "plan e { crew a; }")
        grid = self.write("plans/g.plan", """plan g { network floor { policy grid { expansions 1000; }
  map "g.map"; scenario "g.scen"; } }""")
        self.write("plans/g.map", "type octile\nheight 2\nwidth 3\nmap\n...\n...\n")
        self.write("plans/g.scen", "version 1\n0\tg.map\t3\t2\t0\t0\t2\t1\t3\n")
        walk = self.write("plans/w.plan", """plan w { network n { policy tarry; class road { speed 2 m/s; }
  node a at trans(0, 0, 0); node b at trans(10, 0, 0); lane a to b both; explore r from a; } }""")
        jobs = self.write("plans/j.plan", """plan j { network floor { policy grid { seed 3; } map "g.map";
  agent a from (0, 0) to (0, 0); jobs 2; } }""")
        calls = {"run": ("run", plan), "walk": ("run", walk), "jobs": ("run", jobs), "study": ("study", study), "grid": ("run", grid), "packed": ("run", plan, "--compress"),
                 "empty": ("run", empty)}
        for folders in (False, True):
            if folders:
                os.makedirs(os.path.join(out, "photos"))
            alone = {}
            for name in [*calls, *reversed(calls)]:
                for target in (out, self.path("results", name + "_alone")):
                    result = rubicon(*calls[name], "--out", target)
                    self.assertEqual(result.returncode, 0, f"{name}: {result.stderr}")
                alone[name] = digests(self.path("results", name + "_alone"))
                self.assertEqual(digests(out), alone[name], name)
        # What earlier versions left had no marks in its page and fewer columns.
        self.run_plan(plan, out)
        for name, text in files_of(out).items():
            text = re.sub(rb'\n<meta name="rubicon-[^>]*>', b"", text).replace(b",attributes", b"")
            with open(os.path.join(out, name), "wb") as file:
                file.write(text)
        self.run_plan(plan, out)
        self.assertEqual(digests(out), digests(self.path("results/run_alone")))


class Stopped(Case):
    def time_of(self, *arguments):
        start = time.monotonic()
        rubicon(*arguments)
        return time.monotonic() - start

    def stop(self, number, delay, *arguments):
        """Ends a command after a delay; True if the signal ended it."""
        command = subprocess.Popen([RUBICON, *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(delay)
        command.send_signal(number)
        return command.wait(timeout=60) == -number

    def test_a_killed_run_leaves_the_old_result_or_the_new_one(self):
        for folders in (False, True):
            out = self.path("results/out")
            shutil.rmtree(out, ignore_errors=True)
            wanted = []
            for plan in (self.short, self.long):
                self.run_plan(plan, out)
                wanted.append(self.result(out))
            self.write("results/out/notes.txt", "mine")
            if folders:
                self.write("results/out/photos/one.txt", "mine")
            span = self.time_of("run", self.long, "--out", out)
            chance = random.Random(11)
            for kill in range(KILLS):
                plan = (self.short, self.long)[kill % 2]
                self.stop(signal.SIGKILL, chance.uniform(0, span * 1.2), "run", plan, "--out", out)
                self.assertIn(self.result(out) if folders else {
                    name: each for name, each in digests(out).items() if name in NAMES}, wanted)
                self.assertIn("notes.txt", os.listdir(out))
                self.assertEqual(os.path.exists(self.path("results/out/photos/one.txt")), folders)
                self.assertLessEqual(len(self.strangers(out)), 1)
            self.run_plan(self.long, out)
            self.assertEqual(self.strangers(out), [])

    def test_a_signal_leaves_nothing_over(self):
        out = self.path("results/out")
        self.run_plan(self.short, out)
        calls = [("run", self.long, "--out", out), ("run", self.long, "--out", self.path("results/a/b/new")),
                 ("run", self.long, "--trace", self.path("results/t.jsonl")),
                 ("report", out, "--out", self.path("results/r.html")),
                 ("export", out, "--gltf", self.path("results/g.glb"), "--svg", self.path("results/s.svg"))]
        chance = random.Random(5)
        for call in calls:
            span = self.time_of(*call)
            for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP) * max(KILLS // 12, 1):
                for name in os.listdir(self.path("results")):
                    if name != "out":
                        path = self.path("results", name)
                        shutil.rmtree(path) if os.path.isdir(path) else os.remove(path)
                self.stop(number, chance.uniform(0, span), *call)
                # What was in place before the signal came is whole.
                allowed = {"out", "t.jsonl", "r.html", "g.glb", "s.svg", "a"}
                self.assertLessEqual(set(os.listdir(self.path("results"))), allowed, call)
                self.assertEqual(self.strangers(out), [], call)
                if "a" in os.listdir(self.path("results")):
                    self.assertEqual(os.listdir(self.path("results/a/b")), ["new"])
                    self.assertEqual(rubicon("verify", self.path("results/a/b/new")).returncode, 0)

    def test_a_killed_run_leaves_no_half_written_trace(self):
        trace = self.path("results/t.jsonl")
        self.assertTrue(self.stop(signal.SIGKILL, 0.05, "run", self.path("plans/long.plan"), "--trace", trace) or True)
        self.assertIn(os.listdir(self.path("results")), ([], ["t.jsonl"]))


class Origin(Case):
    def setUp(self):
        super().setUp()
        self.out = self.path("results/out")
        self.run_plan(self.long, self.out)
        if "report.html" not in os.listdir(self.out):
            self.skipTest("this build has no page")

    def test_a_report_of_another_trace_or_schedule_is_a_fault(self):
        self.assertEqual(rubicon("verify", self.out).returncode, 0)
        old = files_of(self.out)
        self.run_plan(self.short, self.out)
        report = os.path.join(self.out, "report.html")
        with open(report, "wb") as file:
            file.write(old["report.html"])
        result = rubicon("verify", self.out)
        self.assertEqual(result.returncode, 1)
        self.assertIn(f"{report}: it was made of another trace", result.stdout)
        self.assertIn(f"{report}: it was made of another schedule.json", result.stdout)
        self.assertIn('"kind": "report"', rubicon("verify", self.out, "--format", "json").stdout)
        rubicon("report", self.out)
        self.assertEqual(rubicon("verify", self.out).returncode, 0)

    def test_a_report_without_the_mark_is_named(self):
        report = os.path.join(self.out, "report.html")
        with open(report, "rb") as file:
            page = file.read()
        with open(report, "wb") as file:
            file.write(re.sub(rb'\n<meta name="rubicon-[^>]*>', b"", page))
        result = rubicon("verify", self.out)
        self.assertEqual(result.returncode, 0)
        self.assertIn("does not say which trace it was made of", result.stderr)


class Paths(Case):
    def test_the_bytes_do_not_depend_on_how_the_path_was_typed(self):
        os.symlink("plans", self.path("linked"))
        os.symlink("short.plan", self.path("plans/other.plan"))
        typed = [("plans/short.plan", self.folder), ("./plans/../plans//short.plan", self.folder),
                 (self.short, "/"), ("short.plan", self.path("plans")), ("../plans/short.plan", self.path("robots")),
                 ("linked/short.plan", self.folder), ("plans/other.plan", self.folder)]
        found = []
        for i, (plan, cwd) in enumerate(typed):
            out = self.path("results", str(i), "out")
            self.run_plan(plan, out, cwd=cwd)
            rubicon("export", out, *(option for kind in ("gltf", "svg", "mspdi", "csv")
                                     for option in (f"--{kind}", os.path.join(out, kind))))
            found.append(files_of(out))
            self.assertEqual(len(found[-1]), len(found[0]))
        for i, each in enumerate(found):
            for name, text in each.items():
                self.assertEqual(text, found[0][name], f"{name} of {typed[i]}")
                self.assertNotIn(self.folder.encode(), text, name)
        inside = rubicon("export", ".", "--svg", "-", cwd=self.path("results/0/out")).stdout
        self.assertEqual(inside.encode(), found[0]["svg"])

    def test_messages_have_the_path_that_was_typed(self):
        self.write("robots/move.motion", "chain { move_to(q, goal(x)) };\n")
        self.assertIn("robots/move.motion:1:", rubicon("run", "plans/short.plan", cwd=self.folder).stderr)
        self.assertIn("../robots/move.motion:1:", rubicon("run", "short.plan", cwd=self.path("plans")).stderr)
        self.assertIn(f"{self.folder}/robots/move.motion:1:", rubicon("run", self.short).stderr)
        self.assertIn("'plans/none.plan'", rubicon("run", "plans/none.plan", cwd=self.folder).stderr)

    def test_what_reads_a_result_needs_no_file_of_the_plan(self):
        out = self.path("results/out")
        self.run_plan(self.short, out)
        shutil.rmtree(self.path("robots"))
        shutil.rmtree(self.path("plans"))
        self.assertEqual(rubicon("verify", out).returncode, 0)
        self.assertIn("../robots/move.motion", rubicon("debug", out, "-x", "step; list", "--batch").stdout)
        self.assertEqual(rubicon("why", out, "p").returncode, 0)
        self.assertEqual(rubicon("export", out, "--mspdi", "-").returncode, 0)


if __name__ == "__main__":
    unittest.main()
