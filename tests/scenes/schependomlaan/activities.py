"""Process time of the activities of a building, beside the hours that the schedule gives them.

usage: activities.py ELEMENTS.csv SCHEDULE.csv    what `rubicon import` and `rubicon run --out` wrote
"""

import csv
import sys
from dataclasses import dataclass


@dataclass
class Activity:
    name: str
    planned: float  # h in the schedule
    elements: int = 0
    done: int = 0
    motion: float = 0  # h of the robot, of what was done
    work: float = 0  # h of the crews
    first: str = ""  # date and time at which the first element is begun
    last: str = ""  # at which the last one stands


def table(elements, schedule):
    """The activities in the order in which they begin; those of which nothing was done at the end."""
    with open(elements, encoding="utf-8", newline="") as file:
        activity_of = {row["task"]: row for row in csv.DictReader(file) if row["task"]}
    rows = {}
    with open(schedule, encoding="utf-8", newline="") as file:
        for task in csv.DictReader(file):
            element = activity_of.get(task["task"])
            if element is None:
                continue
            row = rows.setdefault(element["activity"], Activity(element["activity"], float(element["activity_hours"])))
            row.elements += 1
            if task["result"] != "done":
                continue
            row.done += 1
            row.motion += float(task["motion"]) / 3600
            row.work += float(task["work"]) / 3600
            row.first = min(row.first or task["begins"], task["begins"])
            row.last = max(row.last, task["ends"])
    return sorted(rows.values(), key=lambda row: (row.first == "", row.first))


def text(rows):
    lines = [f"{'activity':<38}{'elements':>9}{'done':>6}{'crane, h':>10}{'crews, h':>10}{'in all, h':>11}"
             f"{'planned, h':>12}  {'from':<18}to"]
    for row in rows:
        lines.append(f"{row.name:<38}{row.elements:>9}{row.done:>6}{row.motion:>10.2f}{row.work:>10.2f}"
                     f"{row.motion + row.work:>11.2f}{row.planned:>12g}  {row.first:<18}{row.last}")
    return "\n".join(lines)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__.strip())
    print(text(table(*sys.argv[1:])))
