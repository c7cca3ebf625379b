#!/usr/bin/env python3
"""The cycle of taskplans/trench.plan by the behaviour of the machine, by the planner of the thesis and by rrt_connect, before and after the
adjustment of speeds (F. Langari 2015, 3.4.4).

    bench/cycle_times.py [RUBICON]        the command, build/release/bin/rubicon if not given

After: all joints of a step arrive together, and a step takes as long as the slowest of them needs (eqs. 3.13 to 3.16). Before: all steps of a
motion take as long as the longest. Both of the first cycle, in seconds, from the steps in the trace."""
import json
import os
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
WAYS = {0: "behaviour", 1: "rrt_plus", 2: "rrt_connect"}
PARTS = ("to_truck_1", "dump_1", "return_1")


def steps_of(records, task):
    """Seconds of each step of a task."""
    steps, before = [], None
    for record in records:
        if record.get("task") != task:
            continue
        if record["type"] == "task_start":
            before = record["t"]
        if record["type"] in ("try", "wait") and record["t"] > before:
            steps.append(record["t"] - before)
            before = record["t"]
    return steps


def first_cycle(rubicon, way):
    """Seconds of digging, and of each part before and after the adjustment."""
    plan = os.path.join(ROOT, "taskplans", "trench.plan")
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([rubicon, "run", plan, "--set", f"way={way}", "--set", "loads=1", "--out", folder], check=True, stdout=subprocess.DEVNULL)
        with open(os.path.join(folder, "trace.jsonl"), encoding="utf-8") as file:
            records = [json.loads(line) for line in file][1:]
    digging = sum(record["time"] for record in records if record["type"] == "work")
    steps = [steps_of(records, part) for part in PARTS]
    return digging, [len(each) * max(each) for each in steps], [sum(each) for each in steps]


def main():
    rubicon = sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "build", "release", "bin", "rubicon")
    print(f"{'way':12} {'':8}" + "".join(f"{part[:-2]:>10}" for part in PARTS) + f"{'cycle':>10}")
    for way, name in WAYS.items():
        digging, before, after = first_cycle(rubicon, way)
        for when, parts in (("before", before), ("after", after)):
            print(f"{name:12} {when:8}" + "".join(f"{seconds:10.1f}" for seconds in parts) + f"{sum(parts) + digging:10.1f}")
        ratios = [second / first for first, second in zip(before, after)] + [(sum(after) + digging) / (sum(before) + digging)]
        print(f"{name:12} {'ratio':8}" + "".join(f"{ratio:10.2f}" for ratio in ratios))


if __name__ == "__main__":
    main()
