"""What the scene tests share: the real command, its trace, poses as the trace writes them."""

import json
import math
import os
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

SKIPPED = 77
"""Exit code by which ctest knows that a test could not run here."""


def rubicon(*arguments, cwd=ROOT):
    return subprocess.run([os.environ["RUBICON"], *arguments], capture_output=True, text=True, timeout=300, cwd=cwd)


class Run:
    """A plan as it was run: exit code, schedule by task, trace."""

    def __init__(self, plan, folder, *options):
        trace = os.path.join(folder, "trace.jsonl")
        done = rubicon("run", plan, "--format", "json", "--trace", trace, *options)
        self.exit_code, self.stderr = done.returncode, done.stderr
        if not done.stdout:
            raise AssertionError(f"rubicon run gave no schedule (exit {done.returncode}): {done.stderr}")
        schedule = json.loads(done.stdout)
        self.process_time = schedule["process_time"]
        self.tasks = {row["task"]: row for row in schedule["tasks"]}
        with open(trace, encoding="utf-8") as file:
            self.header, *self.records = map(json.loads, file)

    def of_type(self, kind):
        return [record for record in self.records if record["type"] == kind]

    def results(self, result):
        return [name for name, row in self.tasks.items() if row["result"] == result]

    def final_poses(self):
        """The pose of each component at the end: where it was set down last, else where it stood at first. Attempts of
        rejected tasks never set anything down for good."""
        poses = {component["name"]: component["pose"] for component in self.header["components"]}
        done = set(self.results("done"))
        poses.update((d["component"], d["pose"]) for d in self.of_type("detach") if d["task"] in done)
        return poses


def multiply(a, b):
    """a * b of poses of 12 numbers (three rows of the matrix)."""
    product = []
    for row in range(3):
        for column in range(4):
            value = sum(a[4 * row + k] * b[4 * k + column] for k in range(3))
            product.append(value + (a[4 * row + 3] if column == 3 else 0))
    return product


def inverse(a):
    turn = [[a[4 * column + row] for column in range(3)] for row in range(3)]
    return [
        number
        for row in range(3)
        for number in (*turn[row], -sum(turn[row][k] * a[4 * k + 3] for k in range(3)))
    ]


def translation(x, y, z):
    return [1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z]


def rotation_z(degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0]


def position_error(a, b):
    return math.dist((a[3], a[7], a[11]), (b[3], b[7], b[11]))


def turn_error(a, b):
    """The largest difference of any number of the rotation matrices; about radians where it is small."""
    return max(abs(a[4 * row + k] - b[4 * row + k]) for row in range(3) for k in range(3))
