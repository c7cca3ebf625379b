"""Tests that run a plan into a result folder, and look whether verify finds what is changed in it."""

import base64
import gzip
import json
import os
import re
import struct
import subprocess
import tempfile
import unittest

import seeded_faults

RUBICON = os.environ["RUBICON"]
ROBOTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "verify_results")


def rubicon(*arguments):
    return subprocess.run([RUBICON, *arguments], capture_output=True, text=True, timeout=300)


def film_of(folder):
    """The head of the film in the report page."""
    with open(os.path.join(folder, "report.html"), encoding="utf-8") as file:
        packed = re.search(r'<script type="text/plain" id="film">([^<]*)<', file.read()).group(1)
    film = gzip.decompress(base64.b64decode(packed))
    (length,) = struct.unpack_from("<I", film, 12)
    return json.loads(film[16:16 + length])


class ResultCase(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = self.temporary.name
        self.out = os.path.join(self.folder, "out")

    def tearDown(self):
        self.temporary.cleanup()

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def run_plan(self, text, expected=0, options=()):
        """The schedule and its tasks by name; ROBOTS in the text is the folder of the tests' robots.
        `expected`: the exit code, None for a run that ends, whatever is rejected."""
        path = self.write("p.plan", text.replace("ROBOTS", ROBOTS))
        self.run_result = rubicon("run", path, "--out", self.out, *options)
        self.assertIn(self.run_result.returncode, (0, 1) if expected is None else (expected,), self.run_result.stdout + self.run_result.stderr)
        verified = rubicon("verify", self.out)
        self.assertEqual(verified.returncode, 0, verified.stdout + verified.stderr)
        with open(os.path.join(self.out, "schedule.json"), encoding="utf-8") as file:
            schedule = json.load(file)
        return schedule, {task["task"]: task for task in schedule["tasks"]}

    def faults_of(self, change):
        """What verify finds when `change` was made to the result."""
        result = seeded_faults.Result(self.out)
        change(result)
        folder = os.path.join(self.folder, "changed")
        os.makedirs(folder, exist_ok=True)
        result.write(folder)
        verified = rubicon("verify", folder)
        self.assertEqual(verified.returncode, 1, verified.stdout + verified.stderr)
        return verified.stdout
