#!/usr/bin/env python3
"""taskplans/studies/schependomlaan.py RUBICON FOLDER [--data DIR] [--runs N]: two studies of a real building, made from its models and its schedule.

The Schependomlaan building (docs/case-study.md) is not part of this project: its files lie in ../shared/data/schependomlaan. This imports them into FOLDER
and writes beside them

  crane_position.plan, crane_position.study   where the crane stands, and which one it is: cost, hours, what it cannot do
  finish_date.plan, finish_date.study         the contractor's schedule with durations that are not certain: which date can be promised

Then: rubicon study FOLDER/crane_position.study --out FOLDER/crane, rubicon study FOLDER/finish_date.study --out FOLDER/date.
"""

import argparse
import glob
import os
import re
import shutil
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DATA = os.path.join(ROOT, "..", "shared", "data", "schependomlaan")
CASE = os.path.join(ROOT, "tests", "scenes", "schependomlaan")
MATCH = os.path.join(CASE, "building.match")
CRANE = os.path.join(ROOT, "robots", "tower_crane")
SCHEDULE = "planning-2015-02-18.mspdi.xml"

# What the models have inside of one another, or the schedule in the wrong order, cannot be put up by any crane (docs/case-study.md): it is not compared.
LEFT_OUT = (
    "set_binnenwand_01_eerste_verdieping_9",
    "set_binnenblad_01_eerste_verdieping_20",
    "set_binnenblad_02_tweede_verdieping_11",
    "set_hoeklijn_bordes_00_begane_grond",
    "set_geveldrager_01_eerste_verdieping_2",
    "set_liftwand_03_derde_verdieping_4",
)

CRANE_STUDY = """# Where the crane of the Schependomlaan building stands, and whether a smaller one does. A variant in which it cannot lift
# or reach an element is not chosen; the table says which element.
study crane_position {
  plan "crane_position.plan";
  vary crane "heavy_crane", "tower_crane_swivel";
  vary crane_x -14 m, -10 m, -6 m;
  vary crane_y 3 m, 7 m, 11 m, 15 m;
  ask cost, utilisation(crane), waiting(machine), rejected;
  choose least mean(cost);
}
"""

DATE_STUDY = """# Which date of the Schependomlaan building can be promised? Of each duration of the contractor's schedule: at best
# four fifths of it, most likely as it is, at worst 1.8 times as long.
study finish_date {
  plan "finish_date.plan";
  runs %d;
  seed 1;
  ask finish, makespan;
}
"""


def imported(rubicon, folder, *arguments):
    done = subprocess.run([rubicon, "import", *arguments], cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        sys.exit(done.stderr)


def read(folder, name):
    with open(os.path.join(folder, name), encoding="utf-8") as file:
        return file.read()


def write(folder, name, text):
    with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
        file.write(text)


def replaced(text, old, new):
    if old not in text:
        sys.exit("the imported plan does not say: " + old)
    return text.replace(old, new)


def crane_position(rubicon, folder, data):
    models = sorted(os.path.basename(file) for file in glob.glob(os.path.join(data, "*.ifc")))
    imported(rubicon, folder, *models, "--schedule", SCHEDULE, "--match", "building.match", "--out", "crane_position.plan")
    text = read(folder, "crane_position.plan")
    text = replaced(text, '  robot crane "heavy_crane.robot" at trans(-6, 11, -0.7) {',
                    '  parameter crane = "heavy_crane";\n  parameter crane_x = -6 m;\n  parameter crane_y = 11 m;\n'
                    '  robot crane "{crane}.robot" at trans(crane_x, crane_y, -0.7) {')
    for task in LEFT_OUT:
        text, count = re.subn(r"\n  task %s \{.*?\n  \}" % task, "", text, flags=re.S)
        if count != 1:
            sys.exit("the imported plan has no task " + task)
        text = text.replace("    milestone %s;\n" % task, "")
        text = re.sub(r"\b%s,\s+" % task, "", re.sub(r",\s+%s;" % task, ";", text))
    write(folder, "crane_position.plan", text)
    write(folder, "crane_position.study", CRANE_STUDY)


def finish_date(rubicon, folder, runs):
    imported(rubicon, folder, SCHEDULE, "--out", "finish_date.plan")
    text = read(folder, "finish_date.plan")

    def spread(match):
        hours = float(match.group(1))
        return "takes pert(%g h, %g h, %g h)" % (0.8 * hours, hours, 1.8 * hours) if hours > 0 else match.group(0)

    write(folder, "finish_date.plan", re.sub(r"takes ([0-9.]+) h", spread, text))
    write(folder, "finish_date.study", DATE_STUDY % runs)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("rubicon")
    parser.add_argument("folder")
    parser.add_argument("--data", default=DATA, help="where the models and the schedule are")
    parser.add_argument("--runs", type=int, default=1000, help="of the schedule (1000)")
    options = parser.parse_args()
    if not os.path.isdir(options.data):
        sys.exit("there is no " + os.path.normpath(options.data))
    rubicon = os.path.abspath(options.rubicon)
    os.makedirs(options.folder, exist_ok=True)
    for file in (*glob.glob(os.path.join(options.data, "*")), MATCH, os.path.join(CASE, "heavy_crane.robot"),
                 os.path.join(CRANE, "tower_crane_swivel.robot"), os.path.join(CRANE, "lift_over_and_turn.motion")):
        shutil.copy(file, options.folder)
    crane_position(rubicon, options.folder, options.data)
    finish_date(rubicon, options.folder, options.runs)


if __name__ == "__main__":
    main()
