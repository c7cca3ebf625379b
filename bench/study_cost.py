#!/usr/bin/env python3
"""bench/study_cost.py RUBICON [PLAN [RUNS]]: what a run of a study costs beside a run of the command, and what a thread costs.

Processor time (user and system) rather than the clock, so that other work on the machine matters little. A plain run is made with --sample and without
a result folder, as a run of a study is; its start-up, which a study pays once, is what `rubicon check` takes.
"""

import os
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
    start_up, _, _ = measured([rubicon, "check", plan])
    plain, plain_clock, plain_memory = measured([rubicon, "run", plan, "--sample", "1:0", "--format", "json"])
    print("%-22s %8.3f s processor time, %.3f s of it start-up; %7.1f MB" % ("rubicon run", plain, start_up, plain_memory))
    with tempfile.TemporaryDirectory() as folder:
        study = os.path.join(folder, "cost.study")
        with open(study, "w", encoding="utf-8") as file:
            file.write('study cost { plan "%s"; runs %d; }\n' % (plan, runs))
        first = 0
        for jobs in (1, 2, 4):
            spent, clock, memory = measured([rubicon, "study", study, "--jobs", str(jobs)])
            each = (spent - start_up) / runs
            text = "%8.3f s processor time a run, %.2f of a plain run without start-up; %7.1f MB" % (each, each / (plain - start_up), memory)
            if jobs == 1:
                first = memory
            else:
                text += ", a thread more %.1f MB (%.0f %% of a plain run)" % ((memory - first) / (jobs - 1), 100 * (memory - first) / (jobs - 1) / plain_memory)
            print("%-22s %s; %.2f s by the clock" % ("%d runs, %d thread%s" % (runs, jobs, "" if jobs == 1 else "s"), text, clock))


if __name__ == "__main__":
    main()
