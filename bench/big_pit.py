#!/usr/bin/env python3
"""Writes taskplans/pit.plan in the large into a folder, to measure the time of a bucket (docs/earthwork.md, "Speed"):

    bench/big_pit.py OUT [POSITIONS [WIDTH [DEPTH [CELL]]]]      and then: time rubicon run OUT/big.plan

Two excavators and four trucks; POSITIONS work positions for each excavator, a pit of 2.4 m x WIDTH x DEPTH at each of them, cells of
CELL m. Without dynamic workspaces and heaps. The machines are those of robots/, with room to travel.
"""

import pathlib
import sys

ROBOTS = pathlib.Path(__file__).resolve().parent.parent / "robots"


def widened(text: str, limit: int) -> str:
    return text.replace(f"range(-{limit}, {limit})", "range(-3000, 3000)")


def main() -> None:
    out = pathlib.Path(sys.argv[1])
    count, width, depth, cell = [
        float(given) for given in sys.argv[2:6] + ["8", "1.8", "2", "0.25"][len(sys.argv) - 2 :]
    ]
    count = int(count)
    out.mkdir(parents=True, exist_ok=True)
    for name, limit in (("excavator/excavator_on_tracks", 100), ("truck/dump_truck", 500)):
        source = ROBOTS / f"{name}.robot"
        (out / source.name).write_text(widened(source.read_text(), limit))
    for name in ("excavator/excavator_digging.motion", "truck/dump_truck.motion"):
        (out / pathlib.Path(name).name).write_text((ROBOTS / name).read_text())

    left = -2.4 * count - 8
    behind = -2.4 * max(0, count - 8)
    lines = [
        'plan big {',
        '  start_at "2026-03-02 07:00";',
        '  currency "EUR";',
        f'  earth ground {{ grid {round((12 - left) / cell)}, {round(22 / cell)}; cell {cell:g} m; at trans({left:.1f}, -2, 0); '
        'height 0 m; stands 90 deg; swell 0.25; density 1.8 t per m3; }',
        '  robot excavator_a "excavator_on_tracks.robot" { cost 143 per h; }',
        '  robot excavator_b "excavator_on_tracks.robot" at trans(0, 18, 0) { cost 143 per h; }',
    ]
    for i in range(1, 5):
        lines.append(
            f'  robot lorry[{i}] "dump_truck.robot" {{ start x {behind - 56 - 9 * i:.1f}, y 9; park x {14 + 9 * i}, y -24; cost 82 per h; }}'
        )
    digs = []
    for i in range(1, count + 1):
        for who, y, lane in (("a", 0, 6.2), ("b", 18, 11.8)):
            if i > 1:
                lines.append(
                    f"  task back_{who}[{i}] {{ by excavator_{who}; go x {-2.4 * (i - 1):.1f}; after dig_{who}[{i - 1}]; }}"
                )
            place = f"trans({4.4 - 2.4 * i:.1f}, {lane}"
            queue = ", ".join(f"trans({behind - 26 - 9 * k:.1f}, {lane}, 0)" for k in range(3))
            lines.append(
                f"  task dig_{who}[{i}] {{ by excavator_{who}; lock x; dig ground to box({6.8 - 2.4 * i:.1f}, {y - width / 2:g}, {-depth:g}, "
                f"{9.2 - 2.4 * i:.1f}, {y + width / 2:g}, 1) {{ bucket 1 m3; fill_factor 0.95; layer 0.5 m; cut roty(90); open roty(40); "
                f"dump at {place}, 2.9); fill takes 2 s; dump takes 2 s; load at {place}, 0); queue at {queue}; }}"
                + (f" after back_{who}[{i}];" if i > 1 else "")
                + " }"
            )
            digs.append(f"dig_{who}[{i}]")
    for i in range(1, 5):
        lines.append(
            f'  task haul[{i}] {{ by lorry[{i}]; haul {", ".join(digs)} {{ bed 11 m3; payload 16 t; out at trans(24, 9, 0), '
            "trans(46, 9, 0) * rotz(180); tip at trans(76, 6, 0) * rotz(180); tip takes 10 s; raise bed.phi 50; "
            f"back at trans(44, -12, 0) * rotz(180), trans({behind - 56:.1f}, -12, 0) * rotz(90), trans({behind - 56:.1f}, 9, 0); }} }}"
        )
    lines.append("}")
    (out / "big.plan").write_text("\n".join(lines) + "\n")


main()
