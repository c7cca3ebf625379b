#!/usr/bin/env python3
"""The maps and scenarios of a folder, run with policy grid, as a table: solved, processor seconds, ratios.

usage: bench/grid_table.py FOLDER [--expansions N] [--agents N,N] [--first] [--rubicon FILE]

Each result is judged by rubicon verify. --first measures the first solution alone: one expansion more than it takes."""

import argparse
import glob
import json
import os
import resource
import subprocess
import sys
import tempfile

PLAN = 'plan bench {{ network floor {{ policy grid {{ expansions {}; }} map "{}"; scenario "{}"; agents {}; }} }}\n'


def run(rubicon, folder, plan):
    """The result and the processor seconds of a plan; nothing where the input is wrong."""
    path = os.path.join(folder, "bench.plan")
    with open(path, "w", encoding="utf-8") as file:
        file.write(plan)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([rubicon, "run", path, "--format", "json"], capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode == 2:
        return None, 0
    ways = os.path.join(folder, "ways.json")
    with open(ways, "w", encoding="utf-8") as file:
        file.write(done.stdout)
    subprocess.run([rubicon, "verify", ways], check=True, capture_output=True)
    return json.loads(done.stdout), after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder")
    parser.add_argument("--expansions", type=int, default=10_000_000)
    parser.add_argument("--agents", default="50,100,200,400,1000")
    parser.add_argument("--first", action="store_true")
    parser.add_argument("--rubicon", default="build/release/bin/rubicon")
    options = parser.parse_args()
    print("scenario agents outcome first_ratio ratio makespan seconds")
    with tempfile.TemporaryDirectory() as folder:
        for scenario in sorted(glob.glob(os.path.join(os.path.abspath(options.folder), "*.scen"))):
            with open(scenario, encoding="utf-8") as file:
                map_file = os.path.join(os.path.dirname(scenario), os.path.basename(file.read().split("\n")[1].split()[1]))
            for agents in options.agents.split(","):
                result, seconds = run(options.rubicon, folder, PLAN.format(options.expansions, map_file, scenario, agents))
                if result is None:
                    continue  # fewer agents in the scenario
                if options.first and result["outcome"] == "solved":
                    budget = result["first_expansions"] + 1
                    result, seconds = run(options.rubicon, folder, PLAN.format(budget, map_file, scenario, agents))
                bound = max(1, result["least_cost"])
                first, cost = (result.get(name, 0) / bound for name in ("first_cost", "cost"))
                print(os.path.basename(scenario), agents, result["outcome"], f"{first:.3f} {cost:.4f}", result.get("makespan", "-"), f"{seconds:.2f}")
                sys.stdout.flush()


if __name__ == "__main__":
    main()
