"""Studies on several ranks of MPI: the same bytes as threads, what a lost rank had is done by others, and a job that was killed is resumed."""

import os
import random
import shutil
import signal
import subprocess
import time
import unittest

from result_case import RUBICON, rubicon
from study_case import StudyCase

# Open MPI keeps memory that its modules allocated; they are unloaded at the end, so that no suppression can name them.
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMPI_MCA_rmaps_base_oversubscribe="1",
                   OMPI_MCA_btl_base_warn_component_unused="0", ASAN_OPTIONS="detect_leaks=0")
ROUNDS = int(os.environ.get("RUBICON_ROUNDS", "8"))
ITEMS = "vary floors 2 to 5; vary gang 2, 1; runs at most 600 until width(p80(finish)) < 2 h; seed 3; choose least p95(cost);"


def mpi(ranks, *arguments, options=()):
    return ["mpirun", "--oversubscribe", *options, "-n", str(ranks), RUBICON, "study", *arguments]


class StudyOnRanks(StudyCase):
    def on_threads(self, path, folder="threads"):
        out = os.path.join(self.folder, folder)
        made = rubicon("study", path, "--out", out)
        self.assertIn(made.returncode, (0, 1), made.stderr)
        return made.stdout, self.files(out)

    def test_the_same_bytes_on_one_to_four_ranks(self):
        path = self.path_of(ITEMS)
        text, files = self.on_threads(path)
        for ranks, more in ((1, ()), (2, ()), (3, ("--jobs", "2")), (4, ())):
            out = os.path.join(self.folder, "ranks%d" % ranks)
            made = subprocess.run(mpi(ranks, path, "--out", out, *more), capture_output=True, text=True, timeout=120, env=ENVIRONMENT)
            self.assertEqual(made.returncode, 0, made.stderr)
            self.assertEqual(made.stdout, text, "%d ranks" % ranks)
            self.assertEqual(self.files(out), files, "%d ranks" % ranks)

    def test_a_search_has_the_same_bytes(self):
        path = self.path_of("vary floors 2 to 5; vary gang 2 to 60; design search 24; runs 20; choose least mean(cost);")
        text, files = self.on_threads(path)
        out = os.path.join(self.folder, "ranks")
        made = subprocess.run(mpi(3, path, "--out", out), capture_output=True, text=True, timeout=120, env=ENVIRONMENT)
        self.assertEqual((made.returncode, made.stdout), (0, text), made.stderr)
        self.assertEqual(self.files(out), files)

    def test_what_is_wrong_is_told_once(self):
        path = self.path_of("vary flors 2;")
        made = subprocess.run(mpi(3, path), capture_output=True, text=True, timeout=60, env=ENVIRONMENT)
        self.assertEqual(made.returncode, 2, made.stderr)
        self.assertEqual(made.stderr.count("the plan has no parameter 'flors'"), 1, made.stderr)
        missing = subprocess.run(mpi(2, os.path.join(self.folder, "no.study")), capture_output=True, text=True, timeout=60, env=ENVIRONMENT)
        self.assertEqual(missing.returncode, 2, missing.stderr)

    def start(self, path, out, *options, ranks=3):
        return subprocess.Popen(mpi(ranks, path, "--out", out, "--resume", options=options), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                env=ENVIRONMENT)

    def ranks_of(self, launcher):
        """Process ids of the ranks, by rank."""
        found = {}
        for name in os.listdir("/proc"):
            try:
                with open("/proc/%s/stat" % name, encoding="utf-8") as file:
                    parent = int(file.read().rsplit(")", 1)[1].split()[1])
                if parent != launcher:
                    continue
                with open("/proc/%s/environ" % name, "rb") as file:
                    for each in file.read().split(b"\0"):
                        if each.startswith(b"OMPI_COMM_WORLD_RANK="):
                            found[int(each.split(b"=")[1])] = int(name)
            except (OSError, ValueError, IndexError):
                continue
        return found

    def end_of(self, process):
        """What a job has printed when its ranks have ended: a launcher that lost one may not end itself."""
        begin = seen = time.monotonic()
        while process.poll() is None and time.monotonic() < min(begin + 200, seen + 15):
            time.sleep(0.02)
            if self.ranks_of(process.pid):
                seen = time.monotonic()
        try:
            return process.communicate(timeout=5)
        except subprocess.TimeoutExpired:
            process.kill()
            return process.communicate(timeout=10)

    def wait_for_more(self, progress, before, more, process):
        deadline = time.monotonic() + 20
        while time.monotonic() < deadline and process.poll() is None:
            if os.path.exists(progress) and os.path.getsize(progress) > before + more:
                return
            time.sleep(0.001)

    def test_what_a_killed_rank_had_is_done_by_others(self):
        path = self.path_of("vary floors 4, 5; runs %d; seed 3; choose least p95(cost);" % (750 * ROUNDS))
        text, files = self.on_threads(path)
        out = os.path.join(self.folder, "ranks")
        process = self.start(path, out, "--enable-recovery")
        self.wait_for_more(os.path.join(out, "study.progress"), 0, 2000, process)
        os.kill(self.ranks_of(process.pid)[2], signal.SIGKILL)
        stdout, stderr = self.end_of(process)
        self.assertIn("rank 2 is left out", stderr)
        self.assertEqual(stdout, text)
        self.assertEqual(self.files(out), files)

    def test_killed_again_and_again_it_ends_with_the_same_bytes(self):
        path = self.path_of("vary floors 2 to 5; runs %d; seed 3; choose least p95(cost);" % (500 * ROUNDS))
        text, files = self.on_threads(path)
        out = os.path.join(self.folder, "killed")
        progress = os.path.join(out, "study.progress")
        delay, kills, sizes = random.Random(4), 0, [0]
        while True:
            if os.path.exists(os.path.join(out, "study.json")) and not os.path.exists(progress):
                # Killed between the results and the end of the job: nothing was left to go on from.
                self.assertEqual(self.files(out), files, "results are whole or not there")
                shutil.rmtree(out)
                sizes = [0]
            process = self.start(path, out)
            if kills < ROUNDS + 2:
                if kills % 2 == 0:  # as soon as they are there: on a quick machine the study ends soon
                    ranks = {}
                    while process.poll() is None and len(ranks) < 2:
                        ranks = self.ranks_of(process.pid)
                else:
                    self.wait_for_more(progress, sizes[-1], delay.randrange(1, 3000), process)
                    ranks = self.ranks_of(process.pid)
                # Rank 0, another, or all and the launcher.
                victims = ([ranks.get(0)], [ranks.get(1)], [*ranks.values(), process.pid])[kills % 3]
                for each in victims:
                    if each is not None and process.poll() is None:
                        os.kill(each, signal.SIGKILL)
            stdout, _ = self.end_of(process)
            if process.returncode == 0:
                break
            kills += 1
            if os.path.exists(progress):
                sizes.append(os.path.getsize(progress))
                self.assertEqual(sizes, sorted(sizes), "no run that was finished is lost")
            elif not os.path.exists(os.path.join(out, "study.json")):
                self.assertEqual(sizes[-1], 0, "the runs are gone")
            self.assertLess(kills, 40)
        self.assertGreaterEqual(kills, 1)
        self.assertEqual(stdout, text)
        self.assertEqual(self.files(out), files)


if __name__ == "__main__":
    unittest.main()
