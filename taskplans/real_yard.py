#!/usr/bin/env python3
"""taskplans/real_yard.py RUBICON FOLDER [--data DIR]: twenty tow motors bring forty pallets into the yard of a real building.

The Schependomlaan building (docs/case-study.md) is not part of this project: its files lie in ../shared/data/schependomlaan. This imports its four models
into FOLDER and writes yard.plan beside them: the building as it is when it is done, every wall, slab, stair and beam of it an obstacle; a fence round it with
two gates of one lane, which is driven in both directions; a road of one direction round the building, with places for two pallets each; and the stock
outside, on a road of two lanes.

Then: rubicon run FOLDER/yard.plan --out FOLDER/result; rubicon verify FOLDER/result
"""

import argparse
import csv
import glob
import math
import os
import re
import shutil
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DATA = os.path.join(ROOT, "..", "shared", "data", "schependomlaan")
ROBOT = os.path.join(ROOT, "robots", "tow_motor")
MARKER = "root_nulpunt"

PITCH = 5
"""From node to node of a road, m."""

ROAD = 18
"""From the building to the middle of the road round it, m; of that the place of a vehicle that serves pallets takes a third."""

FENCE = 26
"""From the building to the fence, m."""

PALLETS = 40

PLAN = """# Twenty tow motors bring pallets from the stock in the south through two gates of one lane to their places round the
# Schependomlaan building, which stands there as its models have it.
plan yard {{
  parameter motors = 20;
  support off;  # the building stands; what holds each part of it is not asked here
  # the ground, but for the building; and the fence, with a gap of 3.5 m at each gate
  site box({x0} - 60, {y0} - 70, -0.5, {x1} + 60, {y0}, 0);
  site box({x0} - 60, {y1}, -0.5, {x1} + 60, {y1} + 40, 0);
  site box({x0} - 60, {y0}, -0.5, {x0}, {y1}, 0);
  site box({x1}, {y0}, -0.5, {x1} + 60, {y1}, 0);
  site box({west} - 8, {fence} - 0.1, 0, {gate_1} - 1.75, {fence} + 0.1, 2);
  site box({gate_1} + 1.75, {fence} - 0.1, 0, {gate_2} - 1.75, {fence} + 0.1, 2);
  site box({gate_2} + 1.75, {fence} - 0.1, 0, {east} + 8, {fence} + 0.1, 2);
  site box({west} - 8.1, {fence}, 0, {west} - 7.9, {north} + 8, 2);
  site box({east} + 7.9, {fence}, 0, {east} + 8.1, {north} + 8, 2);
  site box({west} - 8, {north} + 7.9, 0, {east} + 8, {north} + 8.1, 2);

  network lanes {{
    class road {{ speed 2 m/s; width 3.5 m; }}
    class gate {{ speed 1 m/s; width 3.5 m; }}
    # outside: a road of two lanes, and the stock south of it
    for i from 1 to 20 {{
      node out_east[i] at trans({street} + {pitch} * i, {fence} - 12, 0);
      node out_west[i] at trans({street} + {pitch} * i, {fence} - 6, 0) * rotz(180);
      node stock[i] at trans({street} + {pitch} * i, {fence} - 18, 0) * rotz(-90);
      lane out_east[i] to out_west[i] road both;
      lane out_east[i] to stock[i] road both;
      when (i > 1) {{
        lane out_east[i - 1] to out_east[i] road;
        lane out_west[i] to out_west[i - 1] road;
      }}
    }}
    # inside: a road round the building, against the clock
{ring}    # the gates: one lane, in both directions
{gates}  }}
  fleet tow_motors {{
    robot "tow_motor_on_lanes.robot";
    size motors;
    on lanes;
    at stock[1], stock[2], stock[3], stock[4], stock[5], stock[6], stock[7], stock[8], stock[9], stock[10], stock[11],
        stock[12], stock[13], stock[14], stock[15], stock[16], stock[17], stock[18], stock[19], stock[20];
    choose nearest;
    cost 32 per h;
  }}
{pallets}
  # the building
{building}}}
"""

PALLET = """  component pallet[{i}] {{
    shape box(-0.6, -0.5, 0.1, 0.6, 0.5, 1);
    shape box(-0.6, -0.5, 0, 0.6, -0.4, 0.1);
    shape box(-0.6, 0.4, 0, 0.6, 0.5, 0.1);
    at trans({street} + {pitch} * {stock}, {fence} - {back}, 0) * rotz(-90);
    grip trans(0, 0, 2);
    mass 900 kg;
  }}
  task bring[{i}] {{ by tow_motors; move pallet[{i}] to trans({x:g}, {y:g}, 0) * rotz({turn}); hook 10 s; release 10 s; {after}}}
"""


def footprint(table):
    """The rectangle round all elements, in whole metres."""
    xs, ys = [], []
    with open(table, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            if row["component"].startswith(MARKER):
                continue
            turn = math.radians(float(row["turn_deg"]))
            length, width = float(row["length"]) / 2, float(row["width"]) / 2
            half_x = abs(length * math.cos(turn)) + abs(width * math.sin(turn))
            half_y = abs(length * math.sin(turn)) + abs(width * math.cos(turn))
            xs += [float(row["x"]) - half_x, float(row["x"]) + half_x]
            ys += [float(row["y"]) - half_y, float(row["y"]) + half_y]
    return math.floor(min(xs)), math.floor(min(ys)), math.ceil(max(xs)), math.ceil(max(ys))


def spread(start, end):
    """Places with the pitch between the two, as many on both sides of the middle."""
    count = int((end - start) // PITCH)
    first = (start + end - PITCH * count) / 2
    return [first + PITCH * i for i in range(count + 1)]


def make_plan(table, imported):
    x0, y0, x1, y1 = footprint(table)
    west, east, south, north = x0 - ROAD, x1 + ROAD, y0 - ROAD, y1 + ROAD
    fence = y0 - FENCE
    columns = spread(west, east)
    west, east = columns[0], columns[-1]
    rows = spread(south + PITCH, north - PITCH)
    # The road, against the clock from its south-western corner: place, heading, and where the building is, if it is beside it.
    ring = [(x, south, 0, 90) for x in columns]
    ring += [(east, y, 90, 180) for y in rows]
    ring += [(x, north, 180, -90) for x in reversed(columns)]
    ring += [(west, y, -90, 0) for y in reversed(rows)]
    text, bays = "", []
    for i, (x, y, heading, turn) in enumerate(ring, 1):
        text += f"    node ring[{i}] at trans({x:g}, {y:g}, 0) * rotz({heading});\n"
        beside = x0 - 3 <= x <= x1 + 3 if turn in (90, -90) else y0 - 3 <= y <= y1 + 3
        if not beside:
            continue
        ahead = (math.cos(math.radians(turn)), math.sin(math.radians(turn)))
        bays.append((x, y, turn, ahead))
        text += (f"    node place[{len(bays)}] at trans({x + 6 * round(ahead[0]):g}, {y + 6 * round(ahead[1]):g}, 0) * rotz({turn});\n"
                 f"    lane ring[{i}] to place[{len(bays)}] road both;\n")
    text += f"    for i from 2 to {len(ring)} {{ lane ring[i - 1] to ring[i] road; }}\n    lane ring[{len(ring)}] to ring[1] road;\n"
    # The road outside has its nodes where the one inside has them, and a gate at two of these.
    street = columns[len(columns) // 2] - 11 * PITCH
    gates, gate_at = "", []
    for column in (2, len(columns) - 3):
        i = round((columns[column] - street) / PITCH)
        gates += f"    lane out_west[{i}] to ring[{column + 1}] gate both;\n"
        gate_at.append(columns[column])
    values = {"street": f"{street:g}", "pitch": PITCH, "fence": fence}
    pallets = ""
    places = [(bay, row) for row in (0, 1) for bay in range(len(bays))][:PALLETS]
    for i, (bay, row) in enumerate(places, 1):
        x, y, turn, ahead = bays[bay]
        off = 14 - 2 * row  # the far one first
        after = f"after bring[{i - len(bays)}]; " if row else ""
        if i > 20 and i - 20 != i - len(bays):
            after = (after.rstrip("; ") + f", bring[{i - 20}]; ") if after else f"after bring[{i - 20}]; "
        pallets += PALLET.format(i=i, stock=(i - 1) % 20 + 1, back=24 + 2 * ((i - 1) // 20), x=x + off * round(ahead[0]),
                                 y=y + off * round(ahead[1]), turn=turn, after=after, **values)
    building = imported.split("{", 1)[1].rsplit("}", 1)[0]
    building = re.sub(r"  component " + MARKER + r"\w* \{.*?\n  \}\n", "", building, flags=re.DOTALL)
    return PLAN.format(x0=x0, y0=y0, x1=x1, y1=y1, west=f"{west:g}", east=f"{east:g}", north=f"{north:g}", gate_1=f"{gate_at[0]:g}",
                       gate_2=f"{gate_at[1]:g}", ring=text, gates=gates, pallets=pallets, building=building, **values)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rubicon", help="the command")
    parser.add_argument("folder", help="where the plan is written")
    parser.add_argument("--data", default=DATA, help="the folder of the models")
    arguments = parser.parse_args()
    models = sorted(glob.glob(os.path.join(arguments.data, "*.ifc")))
    if not models:
        sys.exit(f"{arguments.data} has no models: they are not part of this project (docs/case-study.md says where they come from)")
    os.makedirs(arguments.folder, exist_ok=True)
    for file in (*models, os.path.join(ROBOT, "tow_motor_on_lanes.robot"), os.path.join(ROBOT, "bring_by_lanes.motion")):
        shutil.copy(file, arguments.folder)
    names = [os.path.basename(file) for file in models]
    rubicon = os.path.abspath(arguments.rubicon)
    done = subprocess.run([rubicon, "import", *names, "--out", "building.plan"], cwd=arguments.folder, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        sys.exit(done.stderr)
    with open(os.path.join(arguments.folder, "building.plan"), encoding="utf-8") as file:
        imported = file.read()
    plan = os.path.join(arguments.folder, "yard.plan")
    with open(plan, "w", encoding="utf-8") as file:
        file.write(make_plan(os.path.join(arguments.folder, "building_elements.csv"), imported))
    done = subprocess.run([rubicon, "fmt", plan], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(done.stderr)


if __name__ == "__main__":
    main()
