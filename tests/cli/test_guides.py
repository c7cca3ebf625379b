"""Guides: ways that are found are free, machines in the way are waited for, verify finds what is not as a guide says; and the
command that compares them."""

import csv
import io
import json
import math
import os
import random
import unittest

from guide_case import GuideCase
from result_case import film_of, rubicon

HERE = os.path.dirname(os.path.abspath(__file__))
EXCAVATOR = os.path.join(HERE, "..", "..", "robots", "excavator", "excavator.robot")
SCENE = os.path.join(HERE, "..", "..", "robots", "excavator", "cases", "trench_to_truck", "site.plan")
TRUCK = os.path.join(HERE, "..", "..", "robots", "truck", "steered_truck.robot")
TOW_MOTOR = os.path.join(HERE, "..", "..", "robots", "tow_motor", "tow_motor_guided.robot")
SEED = int(os.environ.get("RUBICON_SEED", "1995"))
ROUNDS = int(os.environ.get("RUBICON_ROUNDS", "8"))

ROUND_THE_WALL = """plan p {
  robot car "car.robot";
  component wall { shape box(-0.5, -6, 0, 0.5, 6, 2); at trans(5, 0, 0); }
  guide way rrt_connect { seed 3; }
  task over { by car; go x 10, y 0; guide way; }
}
"""


class Guides(GuideCase):
    def test_a_way_is_followed_without_a_refusal(self):
        _, tasks = self.run_plan(ROUND_THE_WALL)
        self.assertEqual(tasks["over"]["result"], "done")
        self.assertEqual(tasks["over"]["tried"], tasks["over"]["accepted"])
        plan, = self.records("guide")
        self.assertTrue(plan["found"])
        points = len(plan["way"]) // 2
        self.assertEqual([(each["k"], each["n"]) for each in self.records("way_point")],
                         [(k, points - 1) for k in range(1, points)])
        self.assertAlmostEqual(plan["motion_time"], tasks["over"]["duration"], delta=0.01)

    def test_the_same_plan_gives_the_same_bytes(self):
        traces = []
        for _ in range(2):
            self.run_plan(ROUND_THE_WALL)
            with open(os.path.join(self.out, "trace.jsonl"), "rb") as file:
                traces.append(file.read())
        self.assertEqual(traces[0], traces[1])

    def test_a_machine_on_the_goal_is_waited_for(self):
        schedule, tasks = self.run_plan("""plan p {
          robot car "car.robot";
          robot other "other.robot" { start x 10; }
          guide way rrt_connect;
          task over { by car; go x 10, y 0; guide way; }
          task leave { by other; go x 10, y 8; not_before 60 s; }
        }""")
        self.assertEqual(tasks["over"]["result"], "done")
        self.assertGreater(tasks["over"]["duration"], 59)
        found = [plan["found"] for plan in self.records("guide")]
        self.assertFalse(found[0])
        self.assertTrue(found[-1])

    def test_a_machine_that_comes_into_the_way_is_planned_round(self):
        # A wall with two doors; the other machine goes into the nearer one while the car is on its way to it.
        _, tasks = self.run_plan("""plan p {
          robot car "car.robot" { start x -19; }
          robot other "other.robot" { start x 5, y 12; }
          component wall_1 { shape box(4.5, -20.5, 0, 5.5, -10, 2); }
          component wall_2 { shape box(4.5, -8, 0, 5.5, -1, 2); }
          component wall_3 { shape box(4.5, 1, 0, 5.5, 8, 2); }
          component wall_4 { shape box(4.5, 16, 0, 5.5, 20.5, 2); }
          guide way rrt_connect { seed 2; }
          guide careful rrt_connect;
          task over { by car; go x 10, y 0; guide way; }
          task block { by other; go x 7, y 3; via x 7, y 12; not_before 1 s; guide careful; }
          task gate { by other; go x 6.6, y 0; after block; guide careful; }
        }""", expected=None)
        self.assertEqual(tasks["over"]["result"], "done")
        self.assertGreater(len([plan for plan in self.records("guide") if plan["task"] == "over"]), 1)

    def test_a_vehicle_beside_a_wall_gets_away(self):
        # Where an earlier way along the wall left it: at the outline of the wall for the disc that holds it, or just outside.
        radius = math.hypot(1.6, 0.45)
        for gap in (1e-4, 9e-5, 1e-3, 0.015):
            for kind in ("bug1", "bug2", "visibility"):
                _, tasks = self.run_plan("""plan p {
                  robot motor "%s" { start x %.9f, y -1.2, theta 90; }
                  component container { shape box(-2, -6, 0, 0.5, 1, 2.6); }
                  guide way %s;
                  task over { by motor; go x 12, y 2; guide way; }
                }""" % (TOW_MOTOR, -2 - radius - gap, kind))
                self.assertEqual(tasks["over"]["result"], "done", (gap, kind, tasks["over"]["reason"]))

    def test_no_way_is_rejected_with_what_was_tried(self):
        _, tasks = self.run_plan(ROUND_THE_WALL.replace("-6, 0, 0.5, 6", "-21, 0, 0.5, 21").replace("seed 3", "nodes 50"), 1)
        self.assertRegex(tasks["over"]["reason"], r"guide way \(rrt_connect\): no way found with \d+ nodes and \d+ checks, \d+ of "
                                                  r"them refused; most often \(in \d+\): car\.car meets wall")

    def test_verify_finds_what_is_not_as_the_guide_says(self):
        self.run_plan(ROUND_THE_WALL)

        def begins_elsewhere(result):
            guide = next(record for record in result.records if record["type"] == "guide")
            guide["way"][1] += 0.3

        def way_point_left_out(result):
            del result.records[[i for i, record in enumerate(result.records) if record["type"] == "way_point"][1]]

        def way_bent(result):
            guide = next(record for record in result.records if record["type"] == "guide")
            guide["way"][2] += 0.4

        def last_points_left_out(result):
            places = [i for i, record in enumerate(result.records) if record["type"] == "way_point"]
            for place in reversed(places[2:]):
                del result.records[place]

        def way_half(result):
            guide = next(record for record in result.records if record["type"] == "guide")
            guide["way"] = guide["way"][:-1]

        self.assertIn("of the guide begins where", self.faults_of(way_point_left_out))
        self.assertIn("off the way to waypoint 1", self.faults_of(way_bent))
        self.assertRegex(self.faults_of(last_points_left_out), "off the way|is done at waypoint")
        with self.assertRaises(AssertionError):
            self.faults_of(way_half)  # unreadable: exit code 2, not 1
        self.run_plan(ROUND_THE_WALL.replace("task over", "task before { by car; go x 1, y 0; }\n  task over")
                      .replace("guide way; }\n}", "guide way; after before; }\n}"))
        self.assertIn("the way of a guide", self.faults_of(begins_elsewhere))

    def forbidden_cells(self, grid):
        """Each cell: the values of its parameters in its middle, and whether it is forbidden."""
        columns, rows = grid["cells"]
        layers = grid.get("layers", [None])
        told = [bool(i % 2) for i, run in enumerate(grid["runs"]) for _ in range(run)]
        self.assertEqual(len(told), columns * rows * len(layers))
        for cell, blocked in enumerate(told):
            place = (cell % columns, cell // columns % rows)
            at = [low + (k + 0.5) / n * (high - low) for k, n, low, high in zip(place, grid["cells"], grid["low"], grid["high"])]
            yield [*at, layers[cell // columns // rows]], blocked

    def test_a_full_trace_has_where_the_robot_may_not_stand(self):
        """Judged again by the separating axes of two rectangles, but within 5 mm of where they touch."""
        long, wide, heading = 1.5, 0.5, lambda degrees: (math.cos(math.radians(degrees)), math.sin(math.radians(degrees)))

        def gap(x, y, theta):
            c, s = (abs(value) for value in heading(theta))
            own_x, own_y = long * c + wide * s, long * s + wide * c
            dx, dy = x - 5, y
            cx, sx = heading(theta)
            across = (abs(dx * cx + dy * sx) - long - 0.5 * c - 6 * s, abs(dy * cx - dx * sx) - wide - 0.5 * s - 6 * c)
            return max(abs(dx) - 0.5 - own_x, abs(dy) - 6 - own_y, *across)

        self.write("car.robot", """robot car {
          body car {
            param x step(0.5) speed(1 m/s) range(-20, 20);
            param y step(0.5) speed(1 m/s) range(-20, 20);
            param theta step(10) speed(30 deg/s) cyclic;
            frame trans(x, y, 0) * rotz(theta);
            shape box(-1.5, -0.5, 0, 1.5, 0.5, 1);
          }
          tool car;
          behaviour { chain { follow }; }
        }""")
        plan = ROUND_THE_WALL.replace("y 0; guide", "y 0, theta 90; guide")
        self.run_plan(plan)
        plain = self.all_records()
        self.run_plan(plan, options=("--trace-detail", "full"))
        grid, = self.records("forbidden")
        guide, = self.records("guide")
        records = self.all_records()
        self.assertEqual(records.index(grid), records.index(guide) + 1)
        # Nothing else is another.
        bare = [{key: value for key, value in record.items() if key not in ("graph", "legs")} for record in records if record != grid]
        self.assertEqual(bare, plain)
        self.assertEqual((grid["parameters"], grid["at"]), (["x", "y", "theta"], [0, 0, 0]))
        self.assertLessEqual({0, 90}, set(grid["layers"]))
        counts = {True: 0, False: 0}
        for at, blocked in self.forbidden_cells(grid):
            if abs(gap(*at)) < 0.005:
                continue
            self.assertEqual(blocked, gap(*at) < 0, at)
            counts[blocked] += 1
        self.assertGreater(min(counts.values()), 1000)

        def all_free(result):
            found = next(record for record in result.records if record["type"] == "forbidden")
            found["runs"] = [sum(found["runs"])]

        def past_the_limits(result):
            next(record for record in result.records if record["type"] == "forbidden")["high"][1] = 21

        def elsewhere(result):
            next(record for record in result.records if record["type"] == "forbidden")["at"][0] = 3

        def later(result):
            place = next(i for i, record in enumerate(result.records) if record["type"] == "forbidden")
            result.records.insert(place + 1, result.records.pop(place))

        self.assertIn("what is forbidden is told with x at 3 where the search began at 0", self.faults_of(elsewhere))
        self.assertIn("what is forbidden is told without a search right before it", self.faults_of(later))
        self.assertRegex(self.faults_of(all_free), r"cell \d+ of what is forbidden is told as free, and car\.car meets wall there")
        self.assertIn("what is told as forbidden goes past the limits of y: from", self.faults_of(past_the_limits))
        for key, value, expected in (("runs", grid["runs"][:-1], "cells of the grid in 'runs'"), ("cells", [0, 5], "'cells'"), ("layers", [1, 0], "ascending"),
                                     ("parameters", ["x", "y"], "two different parameters, or three"), ("parameters", ["x", "z", "y"], "parameters of the robot")):
            with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
                lines = [json.loads(line) for line in file]
            for record in lines:
                if record["type"] == "forbidden":
                    record[key] = value
            bad = self.write("bad.jsonl", "".join(json.dumps(record) + "\n" for record in lines))
            verified = rubicon("verify", bad)
            self.assertEqual(verified.returncode, 2, key)
            self.assertIn(expected, verified.stderr)
            if key == "runs":
                shown = rubicon("report", bad, "--out", os.path.join(self.folder, "bad.html"))
                self.assertEqual(shown.returncode, 2, shown.stderr)
                self.assertIn("'runs' of 'forbidden' has each of its cells once", shown.stderr)

    def test_where_a_robot_may_not_stand_is_told_of_the_first_searches(self):
        tasks = "".join(f"task t{i} {{ by car; go x {10 * (1 - i % 2)}, y 0; guide way; {f'after t{i - 1};' if i else ''} }}\n" for i in range(34))
        self.run_plan(ROUND_THE_WALL.replace("task over { by car; go x 10, y 0; guide way; }", tasks), options=("--trace-detail", "full"))
        self.assertEqual(len(self.records("guide")), 34)
        self.assertEqual([grid["task"] for grid in self.records("forbidden")], [f"t{i}" for i in range(32)])
        graphs = film_of(self.out)["graphs"]
        self.assertEqual(["forbidden" in graph for graph in graphs], [i < 32 for i in range(34)])

    def test_verify_reckons_what_a_way_is_like(self):
        # Joints, a vehicle that turns on the spot, one that steers, and one that carries at its loaded speed.
        short = """plan p {
  robot "%s";
  component pillar { shape box(-0.5, -2, 0, 0.5, 2, 2); at trans(6, 0, 0); }
  guide way rrt_connect { seed 3; %s }
  start x 0, y 0, theta 0;
  goal x 14, y 1, theta 170;
  guide way;
}
"""
        carrying = """plan p {
  robot car "car.robot";
  component block { mass 100 kg; shape box(-0.2, -0.2, 0, 0.2, 0.2, 0.3); at trans(2, 0, 1); }
  component wall { shape box(-0.5, -4, 0, 0.5, 4, 3); at trans(5, 0, 0); }
  support off;
  guide way rrt_connect { seed 3; }
  task over { by car; move block to trans(9, 0, 1); guide way; }
}
"""
        car = os.path.join(self.folder, "car.robot")
        with open(car, encoding="utf-8") as file:
            text = file.read()
        with open(car, "w", encoding="utf-8") as file:
            file.write(text.replace("speed(1 m/s)", "speed(1 m/s) loaded(0.4 m/s)").replace("tool car;", "tool car at trans(0, 0, 1);"))
        # Arcs of whole steps, of a machine that turns half, drives, and turns half.
        half_turns = """plan p {
  robot "%s";
  component post { shape box(-0.6, -0.6, 0, 0.6, 0.6, 2.5); at trans(3.47, -5.13, 0); }
  guide way rrt_connect { seed 71; turn_radius 3 m; }
  start x 0, y 0, theta 180;
  goal x -1.88, y 0, theta 0;
  guide way;
}
""" % TOW_MOTOR
        for plan in (ROUND_THE_WALL, half_turns, short % (TOW_MOTOR, ""), short % (TRUCK, "turn_radius 6.5 m;"), carrying):
            self.run_plan(plan)
            for key, word in (("roughness", "roughness"), ("length", "length"), ("motion_time", "motion time")):
                for share in (1 + 1e-5, 1 - 1e-5, 0):
                    def told_otherwise(result):
                        record = [each for each in result.records if each["type"] == "guide" and each["found"]][-1]
                        self.assertGreater(record[key], 0)
                        record[key] *= share

                    self.assertRegex(self.faults_of(told_otherwise), rf"trace.jsonl:\d+.* the {word} of the guide's way is told as [0-9.]+( m| s)? and is [0-9.]+")

    def test_verify_finds_a_way_that_does_not_keep_what_it_has_to(self):
        plan = ROUND_THE_WALL.replace("seed 3;", "seed 3; keep (abs(x + 2 * y) <= 30);")
        for text in (plan, """plan p {
  robot "car.robot";
  site box(4.5, -6, 0, 5.5, 6, 2);
  start x 0, y 0;
  guide way rrt_connect { seed 3; keep (x + 2 * y <= 30 and x - y >= -20); }
  guide way;
  goal x 10, y 0;
}
"""):
            self.run_plan(text)

            def holds_less(result):
                header = result.records[0]
                guide, = header["guides"] if header["form"] == "short" else header["tasks"][0]["guides"]
                bound = guide["keep"][0]
                self.assertEqual(bound["sum"], {"x": 1, "y": 2})
                bound["most"] -= 25

            self.assertIn("does not keep what the guide has to", self.faults_of(holds_less))

    def test_ways_among_random_boxes_are_free(self):
        """The excavator among boxes: what a guide finds is made without a refusal, and verify, by its own means, finds nothing."""
        rng = random.Random(SEED)
        found = 0
        for _ in range(ROUNDS):
            boxes = ""
            for i in range(rng.randint(2, 8)):
                size = [rng.uniform(0.2, 1.5) for _ in range(3)]
                place = f"rotz({rng.uniform(-180, 180):.3f}) * trans({rng.uniform(4, 9):.3f}, 0, {rng.uniform(0, 3):.3f})"
                boxes += (f"  component b{i} {{ shape box({-size[0]:.3f}, {-size[1]:.3f}, 0, {size[0]:.3f}, {size[1]:.3f}, "
                          f"{2 * size[2]:.3f}); at {place} * roty({rng.uniform(-40, 40):.2f}); }}\n")
            kind = rng.choice(("rrt_connect", "rrt_connect", "rrt_plus", "rrt_limcon", "astar", "prm", "drrt"))
            goal = f"theta {rng.uniform(-180, 180):.2f}, boom.phi {rng.uniform(20, 60):.2f}, stick.phi {rng.uniform(40, 140):.2f}"
            text = (f'plan p {{\n  robot e "{EXCAVATOR}";\n  support off;\n{boxes}  guide g {kind} {{ nodes 1500; }}\n'
                    f"  task go_there {{ by e; go {goal}, bucket.phi 100; guide g; }}\n}}\n")
            _, tasks = self.run_plan(text, expected=None)
            task = tasks["go_there"]
            if task["result"] != "done":
                self.assertRegex(task["reason"], "no way|start in collision")
                continue
            found += 1
            self.assertEqual(task["tried"], task["accepted"], text)
        self.assertGreater(found, ROUNDS // 4)


class GuidesCommand(unittest.TestCase):
    def test_it_compares_all_kinds(self):
        told = rubicon("guides", SCENE, "--seeds", "2")
        self.assertEqual(told.returncode, 0, told.stderr)
        for kind in ("rrt", "rrt_nonuniform", "rrt_plus", "rrt_limcon", "rrt_connect", "astar", "prm", "dstar_lite", "drrt", "potential"):
            self.assertRegex(told.stdout, rf"\n{kind} +\d/2 ")

    def test_csv_and_json_have_each_try_and_are_the_same_but_for_the_time(self):
        def rows():
            told = rubicon("guides", SCENE, "trench_to_truck", "--seeds", "2", "--format", "csv")
            self.assertEqual(told.returncode, 0, told.stderr)
            return [{key: value for key, value in row.items() if key != "ms"} for row in csv.DictReader(io.StringIO(told.stdout))]
        first = rows()
        self.assertEqual(len(first), 20)
        self.assertEqual(first, rows())
        data = json.loads(rubicon("guides", SCENE, "--seeds", "2", "--format", "json").stdout)
        guides = data["motions"][0]["guides"]
        self.assertEqual([len(guide["trials"]) for guide in guides], [2] * 10)
        connect = next(guide for guide in guides if guide["kind"] == "rrt_connect")
        self.assertEqual(f'{connect["trials"][1]["nodes"]}',
                         next(row["nodes"] for row in first if row["guide"] == "rrt_connect" and row["seed"] == "2"))

    def test_it_says_which_tasks_there_are(self):
        told = rubicon("guides", SCENE, "trench_to_truk")
        self.assertEqual(told.returncode, 2)
        self.assertIn("did you mean trench_to_truck?", told.stderr)
        self.assertEqual(rubicon("guides", SCENE, "--seeds", "0").returncode, 2)
        self.assertEqual(rubicon("guides", "nowhere.plan").returncode, 2)


if __name__ == "__main__":
    unittest.main()
