#!/usr/bin/env python3
"""bench/study_cost.py RUBICON [PLAN [RUNS [ROUNDS]]]: what a run of a study costs beside a run of the command, and what a thread costs.

A plain run is made with --sample and without a result folder, as a run of a study is; its start-up, which a study pays once, is what `rubicon check` takes.
Costs of a run are processor time (user and system), so that other work on the machine matters little. The rate of a study is by the clock: in each round
a plain run and a study with one thread and with as many as there are processors are made in turn, and the figure is the median of the rounds' ratios. It is
told beside how much of the processors the study got: other programs take the rest, and a study cannot be faster than that.
"""

import os
import statistics
import subprocess
import sys
import tempfile
import time


def measured(command):
    """Processor seconds, seconds by the clock, and the most memory (MB) of a command, that of its children included."""
    begin = time.perf_counter()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if os.waitstatus_to_exitcode(status) not in (0, 1):
        sys.exit("failed: " + " ".join(command))
    return usage.ru_utime + usage.ru_stime, time.perf_counter() - begin, usage.ru_maxrss / 1024


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    rubicon = os.path.abspath(sys.argv[1])
    root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    plan = os.path.abspath(sys.argv[2]) if len(sys.argv) > 2 else os.path.join(root, "taskplans", "residential.plan")
    runs = int(sys.argv[3]) if len(sys.argv) > 3 else 6
    rounds = int(sys.argv[4]) if len(sys.argv) > 4 else 5
    cores = os.cpu_count()
    numbers = sorted({1, 2, 4, cores})
    single = [rubicon, "run", plan, "--sample", "1:0", "--format", "json"]
    start, plain = [], []
    studies = {jobs: [] for jobs in numbers}
    with tempfile.TemporaryDirectory() as folder:
        study = os.path.join(folder, "cost.study")
        with open(study, "w", encoding="utf-8") as file:
            file.write('study cost { plan "%s"; runs %d; }\n' % (plan, runs))
        for _ in range(rounds):
            start.append(measured([rubicon, "check", plan]))
            plain.append(measured(single))
            for jobs in numbers:
                studies[jobs].append(measured([rubicon, "study", study, "--jobs", str(jobs)]))

    def median(values):
        return statistics.median(list(values))

    start_up = median(spent for spent, _, _ in start)
    memory = median(each for _, _, each in plain)
    once = median(spent for spent, _, _ in plain)
    print("%-22s %8.3f s processor time, %.3f s of it start-up; %.1f MB" % ("rubicon run", once, start_up, memory))
    first = median(each for _, _, each in studies[1])
    for jobs in numbers:
        each = median((spent - start_up) / runs for spent, _, _ in studies[jobs])
        cost = median((a - s) / runs / (b - s) for (a, _, _), (b, _, _), (s, _, _) in zip(studies[jobs], plain, start))
        rate = median((b - s) / ((a - s) / runs) for (_, a, _), (_, b, _), (_, s, _) in zip(studies[jobs], plain, start))
        got = median(spent / clock for spent, clock, _ in studies[jobs])
        used = median(each for _, _, each in studies[jobs])
        text = "%8.3f s processor time a run, %.2f of a plain run without start-up; %.2f times its rate, with %.2f processors; %.1f MB" % (
            each, cost, rate, got, used)
        if jobs > 1:
            text += ", a thread more %.1f MB (%.0f %% of a plain run)" % ((used - first) / (jobs - 1), 100 * (used - first) / (jobs - 1) / memory)
        print("%-22s %s" % ("%d runs, %d thread%s" % (runs, jobs, "" if jobs == 1 else "s"), text))


if __name__ == "__main__":
    main()
