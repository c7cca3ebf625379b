#!/usr/bin/env python3
"""Draws the ways of all methods that travel without a map across taskplans/yard_without_map.plan, and prints what they come to.

    taskplans/draw_ways.py PATH/TO/rubicon [OUT.svg]

The ways are those of `rubicon guides ... --exact`; the table has besides what the machine takes that each guide leads, from
`rubicon run`, with all its bodies tested at each step.
"""

import json
import os
import re
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROBOTS = os.path.join(os.path.dirname(HERE), "robots")
PLAN = os.path.join(HERE, "yard_without_map.plan")
GUIDES = ("bug1", "bug2", "visbug21", "simple", "tangent", "ace", "visibility")
COLOUR = {"towards": "#2b6cb0", "searching": "#d4a017", "tracking": "#c2410c"}
SCALE = 3.6
WEST, SOUTH, EAST, NORTH = -36, -31, 42, 31


def command(rubicon, *arguments):
    result = subprocess.run([rubicon, *arguments, "--format", "json"], capture_output=True, text=True, check=False)
    if result.returncode not in (0, 1):
        sys.exit(result.stderr)
    return json.loads(result.stdout)


def boxes():
    """Name and plan view (x0, y0, x1, y1) of each component of the plan; all are boxes where they stand."""
    with open(PLAN, encoding="utf-8") as file:
        found = re.findall(r"component (\w+) \{ shape box\(([^)]*)\)", file.read())
    for name, numbers in found:
        x0, y0, _, x1, y1, _ = map(float, numbers.split(","))
        yield name, (x0, y0, x1, y1)


def exact(rubicon):
    return command(rubicon, "guides", PLAN, "cross", "--exact")


def on_the_site(rubicon, guide):
    """The task as `rubicon run` has it, led by this guide."""
    with open(PLAN, encoding="utf-8") as file:
        text = file.read().replace("guide way tangent;", f"guide way {guide};").replace("../robots", ROBOTS)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "yard.plan")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        (task,) = [task for task in command(rubicon, "run", path)["tasks"] if task["task"] == "cross"]
    return task


def once(way):
    """The way until it goes on as it did before: a loop without end is drawn once."""
    seen = set()
    for (before, _), (point, mode) in zip([(None, 0)] + way, way):
        if (before, point) in seen:
            return
        seen.add((before, point))
        yield point, mode


def stretches(method):
    """The way in stretches of one mode: (mode, points)."""
    way = [(tuple(point), tuple(COLOUR)[mode]) for point, mode in zip(method["way"], method["modes"])]
    result = []
    before = None
    for point, mode in once(way) if method["verdict"] == "limit" else way:
        if before is not None and result and result[-1][0] == mode:
            result[-1][1].append(point)
        elif before is not None:
            result.append((mode, [before, point]))
        before = point
    return result


def place(x, y):
    return f"{SCALE * (x - WEST):.1f},{SCALE * (NORTH - y):.1f}"


def panel(number, method, start, goal):
    width, height = SCALE * (EAST - WEST), SCALE * (NORTH - SOUTH)
    parts = [f'<clipPath id="yard"><rect width="{width:.1f}" height="{height:.1f}"/></clipPath><rect width="{width:.1f}" height="{height:.1f}" fill="#f4f5f6"/>']
    for _, (x0, y0, x1, y1) in boxes():
        corner = place(x0, y1).split(",")
        parts.append(f'<rect x="{corner[0]}" y="{corner[1]}" width="{SCALE * (x1 - x0):.1f}" height="{SCALE * (y1 - y0):.1f}" fill="#8a949e"/>')
    parts.append(f'<polyline points="{place(*start)} {place(*goal)}" fill="none" stroke="#5b6672" stroke-dasharray="4 3"/>')
    for mode, points in stretches(method):
        line = " ".join(place(*point) for point in points)
        parts.append(f'<polyline points="{line}" fill="none" stroke="{COLOUR[mode]}" stroke-width="1.8" clip-path="url(#yard)"/>')
    for point, colour in ((start, "#15803d"), (goal, "#1d232a")):
        x, y = place(*point).split(",")
        parts.append(f'<circle cx="{x}" cy="{y}" r="3.5" fill="{colour}"/>')
    parts.append(f'<text y="-6"><tspan font-weight="bold">{method["method"]}</tspan> {method["verdict"]}, {shown(method)}</text>')
    x, y = 14 + (width + 14) * (number % 3), 30 + (height + 34) * (number // 3)
    return f'<g transform="translate({x:.1f} {y:.1f})"><svg y="-20" overflow="visible"><g transform="translate(0 20)">{"".join(parts)}</g></svg></g>'


def shown(method):
    return f'{method["length"]:.1f} m' if method["verdict"] == "reached" else "no end"


def draw(data):
    width, height = SCALE * (EAST - WEST), SCALE * (NORTH - SOUTH)
    methods = data["methods"]
    rows = (len(methods) + 2) // 3
    panels = "".join(panel(i, method, data["start"], data["destination"]) for i, method in enumerate(methods))
    x = 14 + (width + 14) * (len(methods) % 3)
    y = 30 + (height + 34) * (rows - 1)
    key = "".join(f'<g transform="translate({x:.1f} {y + 24 + 22 * i:.1f})"><path d="M0 -4h26" stroke="{colour}" stroke-width="2.5"/><text x="34">{mode}</text></g>' for i, (mode, colour) in enumerate(COLOUR.items()))
    size = (14 + 3 * (width + 14), 16 + rows * (height + 34))
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {size[0]:.0f} {size[1]:.0f}" font-family="sans-serif" font-size="13" fill="#1d232a">'
            f'<rect width="100%" height="100%" fill="#fff"/>{panels}{key}</svg>\n')


def table(data, rubicon):
    by_name = {method["method"]: method for method in data["methods"]}
    yield "| guide | verdict | way of the disc m | of the shortest | time of the machine s |"
    yield "|---|---|---|---|---|"
    for guide in GUIDES:
        method = by_name.get(guide, {"verdict": "reached", "length": data["shortest"]})
        task = on_the_site(rubicon, guide)
        length = f'{method["length"]:.1f}' if method["verdict"] == "reached" else "-"
        share = f'{method["length"] / data["shortest"]:.2f}' if method["verdict"] == "reached" else "-"
        machine = f'{task["duration"]:.0f}' if task["result"] == "done" else "rejected"
        yield f'| `{guide}` | {method["verdict"]} | {length} | {share} | {machine} |'


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    out = sys.argv[2] if len(sys.argv) > 2 else os.path.join(os.path.dirname(HERE), "docs", "pictures", "ways.svg")
    data = exact(sys.argv[1])
    with open(out, "w", encoding="utf-8") as file:
        file.write(draw(data))
    print("\n".join(table(data, sys.argv[1])))


if __name__ == "__main__":
    main()
