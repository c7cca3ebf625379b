#!/usr/bin/env python3
"""Draws how ACE goes in the figures of its paper (coordinates of our own), each an ordinary plan, by `rubicon guides --exact`.

    taskplans/draw_figures.py PATH/TO/rubicon [OUT.svg]

What moves is drawn where it is at first and, pale, where it is when the way ends. Beside ACE the verdicts of the others.
"""

import json
import os
import subprocess
import sys
import tempfile

import draw_ways

HERE = os.path.dirname(os.path.abspath(__file__))
SCALE = 2.4
POINT = """robot point {
  body point {
    param x step(0.5) speed(1 m/s) range(-1000, 1000);
    param y step(0.5) speed(1 m/s) range(-1000, 1000);
    frame trans(x, y, 0);
  }
  tool point;
  behaviour { chain { follow } }
}
"""


def box(x, y, width, height):
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]


def u_opening_down(x, y, width, height, wall):
    return [(x, y), (x + wall, y), (x + wall, y + height - wall), (x + width - wall, y + height - wall), (x + width - wall, y),
            (x + width, y), (x + width, y + height), (x, y + height)]


# Title, start, destination, seen (west, south, east, north), things: name, corners, and of what moves (from s, to s, vx, vy).
FIGURES = (
    ("Figure 1", (0, -20), (0, 40), (-40, -24, 24, 44),
     [("m", [(-6, 0), (6, 0), (8, 6), (0, 10), (-8, 6)], (25, 60, -0.75, 0))]),
    ("Figure 3", (0, -40), (0, 60), (-45, -44, 30, 64),
     [("s", box(-20, 0, 40, 4), None), ("m1", box(-26, -20, 7, 22), (70, 1e4, -1, 0)), ("m2", box(19, -20, 7, 22), None)]),
    ("Figure 4b", (0, -40), (0, 60), (-95, -44, 26, 72),
     [("s", box(-20, 0, 40, 4), None), ("m1", box(-32, -26, 12, 13), None), ("m2", box(-26, -14, 7, 17), (80, 140, -1, 1))]),
    ("Figure 4c, the door opens", (0, -10), (0, 80), (-76, -34, 34, 84),
     [("w1", box(-30, -30, 60, 4), None), ("w2", box(26, -30, 4, 60), None), ("w3", box(-30, 26, 60, 4), None),
      ("w4", box(-30, -30, 4, 40), None), ("m", box(-31, 9, 5, 20), (150, 170, -2, 0))]),
    ("Figure 5", (0, -40), (0, 90), (-92, -44, 26, 94),
     [("s1", box(-20, 0, 40, 4), None), ("m1", box(-32, -26, 12, 13), None), ("m2", box(-26, -3, 7, 6), (82, 140, -1, 1)),
      ("m3", box(-26, -15, 6, 13), (82, 140, -1, 1)), ("s2", u_opening_down(-25, 20, 34, 20, 3), None),
      ("m4", [(-2, 55), (4, 51), (10, 55), (10, 63), (-2, 63)], (190, 1e4, -0.2, 0))]),
)


def plan_text(start, goal, things):
    lines = [f'  robot point "point.robot" {{ start x {start[0]}, y {start[1]}; }}', "  support off;"]
    for name, corners, moves in things:
        shape = "shape prism(0, 3, {});".format(", ".join(f"{x}, {y}" for x, y in corners))
        if moves is None:
            lines.append(f"  component {name} {{ {shape} }}")
            continue
        begin, end, vx, vy = moves
        away = f"trans({vx * (end - begin)}, {vy * (end - begin)}, 0)"
        lines.append(f"  moving {name} {{ {shape} path 0 s trans(0, 0, 0), {begin} s trans(0, 0, 0), {end:.0f} s {away}; }}")
    lines.append(f"  task go {{ by point; go x {goal[0]}, y {goal[1]}; }}")
    return "plan figure {\n" + "\n".join(lines) + "\n}\n"


def travel(rubicon, start, goal, things):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in (("point.robot", POINT), ("figure.plan", plan_text(start, goal, things))):
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        told = subprocess.run([rubicon, "guides", os.path.join(folder, "figure.plan"), "go", "--exact", "--format", "json"],
                              capture_output=True, text=True, check=False)
    if told.returncode != 0:
        sys.exit(told.stderr)
    return {each["method"]: each for each in json.loads(told.stdout)["methods"]}


def panel(figure, methods, x):
    title, start, goal, (west, south, east, north), things = figure
    ace = methods["ace"]

    def place(a, b):
        return f"{SCALE * (a - west):.1f},{SCALE * (north - b):.1f}"

    def shape(corners, colour, more=""):
        return f'<polygon points="{" ".join(place(*p) for p in corners)}" fill="{colour}"{more}/>'

    width, height = SCALE * (east - west), SCALE * (north - south)
    clip = f"c{x:.0f}"
    parts = [f'<clipPath id="{clip}"><rect width="{width:.1f}" height="{height:.1f}"/></clipPath>',
             f'<rect width="{width:.1f}" height="{height:.1f}" fill="#f4f5f6"/><g clip-path="url(#{clip})">']
    for _, corners, moves in things:
        if moves is not None:
            begin, end, vx, vy = moves
            gone = min(max(ace["time"] - begin, 0), end - begin)
            parts.append(shape([(a + vx * gone, b + vy * gone) for a, b in corners], "#d9a630", ' fill-opacity="0.3"'))
        parts.append(shape(corners, "#8a949e" if moves is None else "#d9a630"))
    parts.append(f'<polyline points="{place(*start)} {place(*goal)}" fill="none" stroke="#5b6672" stroke-dasharray="4 3"/>')
    for mode, points in draw_ways.stretches(ace):
        line = " ".join(place(*point) for point in points)
        parts.append(f'<polyline points="{line}" fill="none" stroke="{draw_ways.COLOUR[mode]}" stroke-width="1.8"/>')
    for point, colour in ((start, "#15803d"), (goal, "#1d232a")):
        a, b = place(*point).split(",")
        parts.append(f'<circle cx="{a}" cy="{b}" r="3.5" fill="{colour}"/>')
    parts.append("</g>")
    parts.append(f'<text y="-22" font-weight="bold">{title}</text><text y="-6">ace {ace["length"]:.1f} m</text>')
    for i, name in enumerate(("bug2", "simple", "tangent")):
        each = methods[name]
        text = f'{name}: {each["length"]:.1f} m' if each["verdict"] == "reached" else f'{name}: {each["verdict"]}'
        parts.append(f'<text y="{height + 16 + 15 * i:.1f}" font-size="11.5">{text}</text>')
    return f'<g transform="translate({x:.1f} {{y:.1f}})">{"".join(parts)}</g>', width, height


def draw(rubicon):
    x, parts = 14, []
    for figure in FIGURES:
        part, width, height = panel(figure, travel(rubicon, *figure[1:3], figure[4]), x)
        parts.append((part, height))
        x += width + 22
    tallest = max(height for _, height in parts)
    body = "".join(part.replace("{y:.1f}", f"{48 + tallest - height:.1f}") for part, height in parts)
    key = "".join(f'<g transform="translate({14 + 110 * i} {tallest + 120:.1f})"><path d="M0 -4h26" stroke="{colour}" stroke-width="2.5"/>'
                  f'<text x="32">{mode}</text></g>' for i, (mode, colour) in enumerate(draw_ways.COLOUR.items()))
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {x:.0f} {tallest + 134:.0f}" font-family="sans-serif" font-size="13" fill="#1d232a">'
            f'<rect width="100%" height="100%" fill="#fff"/>{body}{key}</svg>\n')


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    out = sys.argv[2] if len(sys.argv) > 2 else os.path.join(os.path.dirname(HERE), "docs", "pictures", "ace_figures.svg")
    with open(out, "w", encoding="utf-8") as file:
        file.write(draw(sys.argv[1]))


if __name__ == "__main__":
    main()
