#!/usr/bin/env python3
"""Draws what the three representations of the planar arm reach, and where they differ (1995 paper, Figure 5).

    robots/planar_arm/draw_workspaces.py PATH/TO/rubicon [OUT.svg]

Each point of a grid is a task `go` to a frame there, turned by 30 degrees; what is reached is what rubicon run says is done. So the
picture is of the representations as they are simulated, not of a formula.
"""

import json
import math
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
KINDS = ("exact", "rectangular", "polar")
PITCH = 0.4
SIDE = 13  # points to either side of the foot
GRID = [(PITCH * i, PITCH * k) for k in range(-SIDE, SIDE + 1) for i in range(-SIDE, SIDE + 1)]
TURN = 30


def reached(rubicon, kind):
    """The points that the arm comes to, each from the posture it starts with."""
    with tempfile.TemporaryDirectory() as folder:
        plan = os.path.join(folder, "reach.plan")
        with open(plan, "w", encoding="utf-8") as file:
            file.write(f'plan reach {{\n  robot arm "{os.path.join(HERE, kind)}.robot";\n')
            for n, (x, z) in enumerate(GRID):
                file.write(f"  task go_{n} {{ by arm; go at trans({x:.3f}, 0, {z:.3f}) * roty({TURN}); }}\n")
            file.write("}\n")
        run = subprocess.run([rubicon, "run", plan, "--format", "json"], capture_output=True, text=True, check=False)
        if run.returncode not in (0, 1):
            sys.exit(run.stderr)
        results = {task["task"]: task["result"] for task in json.loads(run.stdout)["tasks"]}
    return {point for n, point in enumerate(GRID) if results[f"go_{n}"] == "done"}


def dots(points, colour, size=3.2):
    return "".join(f'<circle cx="{20 * x:.1f}" cy="{-20 * z:.1f}" r="{size}" fill="{colour}"/>' for x, z in sorted(points))


def panel(column, title, body, words):
    return (f'<g transform="translate({130 + 240 * column} 150)"><text y="-122" text-anchor="middle" font-weight="bold">{title}</text>{body}'
            f'<circle r="100" fill="none" stroke="#5b6672" stroke-dasharray="4 3"/><circle r="2.5" fill="#1d232a"/>'
            f'<text y="128" text-anchor="middle" fill="#5b6672">{words}</text></g>')


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    out = sys.argv[2] if len(sys.argv) > 2 else os.path.join(HERE, "workspaces.svg")
    reach = {kind: reached(sys.argv[1], kind) for kind in KINDS}
    exact = reach["exact"]
    panels = [panel(0, "exact", dots(exact, "#2b6cb0"), f"{len(exact)} of {len(GRID)} points")]
    for column, kind in enumerate(KINDS[1:], start=1):
        more, less = reach[kind] - exact, exact - reach[kind]
        body = dots(reach[kind] & exact, "#2b6cb0") + dots(more, "#c2410c") + dots(less, "#d4a017")
        panels.append(panel(column, kind, body, f"{len(more)} too many, {len(less)} too few"))
        print(f"{kind}: {len(reach[kind])} reached, {len(more)} that the arm does not reach, {len(less)} that it would")
    print(f"exact: {len(exact)} of {len(GRID)} reached, area {len(exact) * PITCH ** 2:.1f} m2 (ring of 1 to 5 m: {math.pi * 24:.1f} m2)")
    legend = ('<g transform="translate(30 312)"><circle r="4" fill="#2b6cb0"/><text x="10" y="4">reached, as by the arm</text>'
              '<circle cx="210" r="4" fill="#c2410c"/><text x="220" y="4">reached, but not by the arm</text>'
              '<circle cx="440" r="4" fill="#d4a017"/><text x="450" y="4">reached by the arm only</text></g>')
    with open(out, "w", encoding="utf-8") as file:
        file.write('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 740 330" font-family="sans-serif" font-size="12">'
                   '<rect width="740" height="330" fill="#ffffff"/>' + "".join(panels) + legend + "</svg>\n")


if __name__ == "__main__":
    main()
