"""Guides that think, that steer and that go down a field: what runs, what verify finds in a changed result, and the picture."""

import math
import os
import re
import subprocess
import time
import unittest
import xml.etree.ElementTree as xml

from guide_case import GuideCase
from result_case import RUBICON, rubicon

HERE = os.path.dirname(os.path.abspath(__file__))
EXCAVATOR = os.path.join(HERE, "..", "..", "robots", "excavator", "excavator.robot")
TRUCK = os.path.join(HERE, "..", "..", "robots", "truck", "steered_truck.robot")
PARK = os.path.join(HERE, "..", "..", "robots", "truck", "cases", "park_in_a_bay", "site.plan")
FIELD = os.path.join(HERE, "..", "..", "examples", "22_down_a_field", "site.plan")

THINKS = """plan p {
  robot car "car.robot";
  robot other "other.robot" { start x 6, y 9; }
  component wall { shape box(-0.5, -6, 0, 0.5, 6, 2); at trans(5, 0, 0); }
  guide way rrt_connect { seed 3; thinks 100 ms per check; }
  task over { by car; go x 10, y 0; guide way; }
}
"""


class GuideKinds(GuideCase):
    def checked(self, clauses, robot="car.robot", kind="rrt_connect"):
        path = self.write("bad.plan", f'plan p {{ robot "{robot}"; guide way {kind} {{ {clauses} }} goal x 1; guide way; }}')
        told = rubicon("check", path)
        return told.returncode, told.stderr

    def test_thinking_takes_its_time_and_is_told_apart(self):
        _, tasks = self.run_plan(THINKS)
        task = tasks["over"]
        plan, = self.records("guide")
        think, = self.records("think")
        self.assertEqual(think["checks"], plan["checks"])
        self.assertAlmostEqual(think["t"], 0.1 * plan["checks"], places=6)
        self.assertAlmostEqual(task["thinking"], 0.1 * plan["checks"], places=6)
        self.assertAlmostEqual(task["motion"] - task["thinking"], plan["motion_time"], delta=0.01)
        self.assertIn("s of computation by its guide", self.run_result.stdout)
        with open(os.path.join(self.out, "schedule.csv"), encoding="utf-8") as file:
            self.assertTrue(file.readline().rstrip().endswith(",thinking"))

    def test_a_way_that_is_blocked_meanwhile_is_planned_again(self):
        blocked = THINKS.replace("guide way; }\n}", """guide way; }
  task block { by other; go x 5, y 7.2; }
}""").replace("-6, 0, 0.5, 6", "-20.5, 0, 0.5, 6").replace("seed 3", "seed 3; replans 4")
        _, tasks = self.run_plan(blocked)
        self.assertEqual(tasks["over"]["result"], "done")
        plans = [plan for plan in self.records("guide") if plan["task"] == "over"]
        self.assertGreater(len(plans), 1)
        self.assertAlmostEqual(tasks["over"]["thinking"], sum(0.1 * plan["checks"] for plan in plans), places=6)

    def test_verify_finds_thinking_that_is_none(self):
        self.run_plan(THINKS)

        def shorter(result):
            for record in result.records:
                if record["type"] == "think":
                    record["t"] -= 1

        def none(result):
            result.records[:] = [record for record in result.records if record["type"] != "think"]

        def other_count(result):
            next(record for record in result.records if record["type"] == "think")["checks"] += 1

        def not_told(result):
            result.schedule["tasks"][0]["thinking"] -= 0.5

        self.assertIn("of thinking instead of", self.faults_of(shorter))
        self.assertIn("its guide planned, and did not think", self.faults_of(none))
        self.assertIn("where it planned", self.faults_of(other_count))
        self.assertIn("the thinking of guides is", self.faults_of(not_told))

    def test_a_truck_parks_on_arcs(self):
        out = self.out
        told = rubicon("run", PARK, "--out", out)
        self.assertEqual(told.returncode, 0, told.stdout + told.stderr)
        self.assertEqual(rubicon("verify", out).returncode, 0)
        guide, = self.records("guide")
        way = [guide["way"][i:i + 3] for i in range(0, len(guide["way"]), 3)]
        cusps, before = 0, 1
        for (x, y, theta), (to_x, to_y, to_theta) in zip(way, way[1:]):
            turned = (to_theta - theta + 180) % 360 - 180
            chord = math.hypot(to_x - x, to_y - y)
            self.assertGreaterEqual(chord + 1e-9, 2 * 6.5 * math.sin(math.radians(abs(turned) / 2)))
            ahead = (to_x - x) * math.cos(math.radians(theta)) + (to_y - y) * math.sin(math.radians(theta))
            cusps += ahead * before < 0
            before = ahead
        self.assertGreater(cusps, 0)

        def narrower(result):
            result.records[0]["guides"][0]["turn_radius"] = 8

        self.assertIn("narrower than its radius of 8 m", self.faults_of(narrower))

    def test_a_truck_parks_by_a_roadmap_and_by_a_tree_from_the_goal(self):
        for kind in ("prm { nodes 1500;", "drrt { step 30;"):
            self.expect_parking(kind)

    def test_a_field_names_its_minimum_and_another_guide_goes_on(self):
        told = rubicon("run", FIELD, "--out", self.out)
        self.assertEqual(told.returncode, 0, told.stdout + told.stderr)
        self.assertEqual(rubicon("verify", self.out).returncode, 0)
        plans = [(plan["kind"], plan["found"]) for plan in self.records("guide")]
        self.assertEqual(plans, [("potential", True), ("potential", False), ("rrt_connect", True)])
        cause = next(plan["cause"] for plan in self.records("guide") if not plan["found"])
        self.assertRegex(cause, r"^no way: the field has a minimum at cart\.x [\d.]+, cart\.y [\d.]+, where cart\.cart is [\d.]+ m "
                                r"from (shelf|wing)$|^no way: the field has a minimum at x [\d.]+, y [\d.]+, where cart\.cart is [\d.]+ m from (shelf|wing)$")
        why = rubicon("why", self.out, "behind_the_shelf")
        self.assertIn("the field has a minimum", why.stdout)

    def test_verify_finds_a_field_that_is_not_as_told(self):
        self.assertEqual(rubicon("run", FIELD, "--out", self.out).returncode, 0)

        def bent(result):
            plan = next(record for record in result.records if record["type"] == "guide" and record["kind"] == "potential")
            plan["way"][len(plan["way"]) // 2] += 0.4

        def left_out(result):
            points = [i for i, record in enumerate(result.records) if record["type"] == "way_point"]
            del result.records[points[1]]

        self.assertRegex(self.faults_of(bent), "off the way to waypoint|the way of a guide")
        self.assertIn("of the guide begins where", self.faults_of(left_out))

    def test_a_run_that_is_killed_while_a_guide_thinks_leaves_the_old_result_or_the_new_one(self):
        self.run_plan(THINKS)
        plan = self.write("slower.plan", THINKS.replace("100 ms", "200 ms"))
        new = os.path.join(self.folder, "new")
        begin = time.monotonic()
        self.assertEqual(rubicon("run", plan, "--out", new).returncode, 0)
        span = time.monotonic() - begin

        def traced(folder):
            with open(os.path.join(folder, "trace.jsonl"), "rb") as file:
                return file.read()

        wanted = [traced(self.out), traced(new)]
        self.assertNotEqual(*wanted)
        for kill in range(6):
            command = subprocess.Popen([RUBICON, "run", plan, "--out", self.out], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(span * kill / 5)
            command.kill()
            command.wait(timeout=60)
            self.assertIn(traced(self.out), wanted)
        self.assertEqual(rubicon("run", plan, "--out", self.out).returncode, 0)
        self.assertEqual(traced(self.out), wanted[1])
        self.assertEqual(rubicon("verify", self.out).returncode, 0)

    def test_its_picture_has_the_way_and_the_minima(self):
        picture = os.path.join(self.folder, "field.svg")
        told = rubicon("guides", FIELD, "behind_the_shelf", "--svg", picture, "--kind", "potential")
        self.assertEqual(told.returncode, 0, told.stderr)
        with open(picture, encoding="utf-8") as file:
            text = file.read()
        xml.fromstring(text)
        self.assertRegex(text, r"minimum: cart\.cart is [\d.]+ m from (shelf|wing)")
        again = rubicon("guides", FIELD, "behind_the_shelf", "--svg", picture, "--kind", "potential")
        self.assertEqual(again.returncode, 0)
        with open(picture, encoding="utf-8") as file:
            self.assertEqual(text, file.read())
        for arguments, message in ((("--axes", "x,w"), "'w' is no parameter"), (("--axes", "x,x"), "two different parameters"),
                                   (("--kind", "rtr"), "unknown kind of guide 'rtr'")):
            told = rubicon("guides", FIELD, "behind_the_shelf", "--svg", picture, *arguments)
            self.assertEqual(told.returncode, 2)
            self.assertIn(message, told.stderr)
        self.assertEqual(rubicon("guides", FIELD, "behind_the_shelf", "--axes", "x,y").returncode, 2)

    def test_a_third_parameter_has_a_slider(self):
        # A pillar that only the upper arm of the excavator meets, on one side: what is forbidden depends on theta.
        plan = self.write("e.plan", f"""plan p {{
  robot "{EXCAVATOR}";
  component pillar {{ shape box(-0.5, -0.5, 0, 0.5, 0.5, 6); at rotz(60) * trans(6, 0, 0); }}
  guide way rrt_connect {{ seed 2; }}
  start theta 0, boom.phi 30, stick.phi 100, bucket.phi 100;
  goal theta 110, boom.phi 30, stick.phi 100, bucket.phi 100;
  guide way;
}}
""")
        axes = ("--axes", "boom.phi,stick.phi,theta")

        def told(*arguments):
            result = rubicon("guides", plan, *arguments)
            self.assertEqual(result.returncode, 0, result.stderr)
            return result.stdout

        page = told("--page", "-", *axes)
        self.assertEqual(page, told("--page", "-", *axes))
        values = re.search(r'data-values="([^"]*)"', page).group(1).split("|")
        self.assertIn("110 degrees", values)
        self.assertEqual(values, sorted(values, key=lambda value: float(value.split()[0])))
        first = int(re.search(r'type="range" .*? value="(\d+)"', page).group(1))
        self.assertEqual(values[first], "0 degrees")
        picture = xml.fromstring(page[page.index("<svg"):page.index("</svg>") + 6])
        layers = [each for each in picture.iter() if each.get("class") == "layer"]
        self.assertEqual(len(layers), 2 * len(values))
        shown = [k for k, layer in enumerate(layers) if layer.get("display") == "inline"]
        self.assertEqual(shown, [first, first + len(values)])

        def area(value):
            """Cells that are dark in the layer of a value."""
            paths = [path.get("d") for path in layers[values.index(value)].iter() if path.get("d")]
            return sum(int(end) - int(begin) for d in paths for end, begin in re.findall(r"H(\d+)v1H(\d+)z", d))

        cell = float(re.search(r"scale\(([\d.]+) ", page).group(1))
        self.assertGreater(area("60 degrees"), 1.3 * area("0 degrees"))
        # The picture of one value shows what the page does.
        for value in ("0", "60"):
            picture = told("--svg", "-", *axes, "--at", value)
            widths = [float(each.get("width")) for each in xml.fromstring(picture).iter() if each.get("fill") == "#5b6470"]
            self.assertAlmostEqual(sum(widths) / cell, area(f"{value} degrees"), delta=1)
            self.assertIn(f"theta {value}, bucket.phi 100", picture)
        # The way turns one way or the other: a ring at 60 degrees or at -90.
        rings = [len([each for each in layers[len(values) + values.index(value)].iter() if each.get("r")]) for value in ("60 degrees", "-90 degrees")]
        self.assertEqual(min(rings), 0)
        self.assertGreaterEqual(max(rings), 1)
        for arguments, message in ((("--svg", "-", "--axes", "boom.phi,stick.phi", "--at", "3"), "third parameter"),
                                   (("--page", "-", "--axes", "boom.phi,stick.phi"), "three parameters"),
                                   (("--svg", "-", *axes, "--at", "1000"), "theta is from -180 to 180, found 1000"),
                                   (("--svg", "-", *axes, "--at", "nan"), ""), (("--page", "-"), ""), (axes, "--axes goes with"),
                                   (("--page", "-", "--axes", "theta,theta,theta"), "different"),
                                   (("--page", "-", "--axes", "theta,boom.phi,stick.phi,bucket.phi"), "different"),
                                   (("--page", plan, *axes), "")):
            result = rubicon("guides", plan, *arguments)
            self.assertEqual(result.returncode, 2, arguments)
            self.assertIn(message, result.stderr)
        with open(plan, encoding="utf-8") as file:
            self.assertIn("pillar", file.read())

    def test_pictures_go_with_their_options(self):
        self.assertEqual(rubicon("guides", FIELD, "behind_the_shelf", "--kind", "rrt").returncode, 2)

    def test_its_chart_has_each_parameter_that_moves(self):
        chart = os.path.join(self.folder, "chart.svg")
        told = rubicon("guides", FIELD, "behind_the_shelf", "--chart", chart, "--kind", "rrt_connect")
        self.assertEqual(told.returncode, 0, told.stderr)
        with open(chart, encoding="utf-8") as file:
            text = file.read()
        xml.fromstring(text)
        self.assertEqual(len(re.findall(r"<path ", text)), 4)
        self.assertIn(">x, m<", re.sub(r"cart\.", "", text))
        told = rubicon("guides", FIELD, "behind_the_shelf", "--chart", chart, "--kind", "potential")
        self.assertEqual(told.returncode, 2)
        self.assertIn("the field has a minimum", told.stderr)

    def test_what_is_said_wrongly_has_its_place(self):
        for clauses, message in (
                ("thinks 20 per check;", "us, ms or s"), ("thinks us per check;", "a number after thinks"),
                ("thinks 20 us;", "'per' check"), ("thinks 20 us per leg;", "'check'"),
                ("thinks 61 s per check;", "a check may take at most 60 s"), ("turn_radius 2 deg;", "turn_radius"),
                ("turn_radius -1 m;", "turn_radius must be a number from 0"),
                ("turn_radius 2 m;", "turn_radius is for vehicles"), ("influence 2 m;", "rrt_connect has no clause 'influence'")):
            code, told = self.checked(clauses)
            self.assertEqual(code, 2, clauses)
            self.assertIn(message, told, clauses)
            self.assertRegex(told, r"bad\.plan:1:\d+: error", clauses)
        code, told = self.checked("turn_radius 2 m; safety 1;", TRUCK, "astar")
        self.assertEqual(code, 2)
        self.assertIn("there is no safety", told)
        self.assertEqual(self.checked("thinks 0 s per check;")[0], 0)
        self.assertEqual(self.checked("repulsion 0; influence 20 cm; attraction 3; step 5;", kind="potential")[0], 0)
        self.assertRegex(self.checked("turn_radius 2 m;", TRUCK, "potential")[1], "potential has no clause 'turn_radius'")
        for kind, why in (("dstar_lite", "arcs do not lead from node to node of its lattice"), ("rrt_limcon", "an arc moves three")):
            told = self.checked("turn_radius 2 m;", TRUCK, kind)[1]
            self.assertIn(f"{kind} has no clause 'turn_radius'", told)
            self.assertIn(f"{why}: take rrt_connect", told)


if __name__ == "__main__":
    unittest.main()
