"""rubicon guides --exact: travel without a map in the plan view of a plan; figures of PLANNERS 8 as ordinary plans."""

import csv
import io
import json
import math
import os
import unittest

from result_case import ResultCase, film_of, rubicon

CAR = """robot car {
  body car {
    param x step(0.5) speed(2 m/s) range(-100, 100);
    param y step(0.5) speed(2 m/s) range(-100, 100);
    frame trans(x, y, 0);
    %s
  }
  tool car;
  behaviour { chain { follow }; }
}
"""
BLOCK = "component block { shape box(-10, 0, 0, 10, 10, 3); }"
U = "component u { shape prism(0, 3, -10, 20, -10, 0, -9, 0, -9, 19, 9, 19, 9, 0, 10, 0, 10, 20); }"


class Travel(ResultCase):
    def travel(self, things, *options, shape="", task="task over { by car; go x 0, y 30; }"):
        self.write("car.robot", CAR % shape)
        plan = self.write("site.plan", 'plan yard {\n  robot car "car.robot" { start x 0, y -20; }\n  support off;\n'
                                       f"  {things}\n  {task}\n}}\n")
        return rubicon("guides", plan, "--exact", *options)

    def methods(self, things, **more):
        told = self.travel(things, "--format", "json", **more)
        self.assertEqual(told.returncode, 0, told.stderr)
        data = json.loads(told.stdout)
        return data, {each["method"]: each for each in data["methods"]}

    def test_a_point_and_a_block(self):
        data, methods = self.methods(BLOCK)
        self.assertEqual((data["radius"], data["start"], data["destination"]), (0, [0, -20], [0, 30]))
        self.assertAlmostEqual(data["shortest"], 10 + 2 * math.hypot(10, 20), 9)
        self.assertAlmostEqual(methods["bug2"]["length"], 70, 9)
        self.assertAlmostEqual(methods["bug2"]["time"], 35, 9)
        self.assertAlmostEqual(methods["bug1"]["length"], 130, 9)
        self.assertEqual([(event["kind"], event["at"], event["obstacles"]) for event in methods["bug2"]["events"]],
                         [("hit", [0, 0], ["block"]), ("leave", [0, 10], ["block"]), ("reached", [0, 30], [])])
        for each in methods.values():
            self.assertEqual(each["verdict"], "reached", each["method"])
            if "bound" in each:
                self.assertLessEqual(each["length"], each["bound"]["length"] + 1e-9)

    def test_a_machine_is_a_disc(self):
        data, methods = self.methods(BLOCK, shape="shape box(-0.6, -0.3, 0, 0.6, 0.3, 1);")
        self.assertAlmostEqual(data["radius"], math.hypot(0.6, 0.3), 9)
        self.assertTrue(70 < methods["bug2"]["length"] < 70 + 4 * data["radius"], methods["bug2"]["length"])

    def test_only_what_is_as_high_as_the_machine_is_in_the_way(self):
        shape = "shape box(-0.5, -0.5, 0.2, 0.5, 0.5, 2);"
        ground = "site box(-100, -100, -1, 100, 100, 0);"
        for what in (ground, ground + " component bridge { shape box(-10, 0, 2.5, 10, 10, 3); }",
                     "component kerb { shape box(-10, 0, 0, 10, 10, 0.15); }"):
            _, methods = self.methods(what, shape=shape)
            self.assertAlmostEqual(methods["bug2"]["length"], 50, 9)
        _, methods = self.methods("component beam { shape box(-10, 0, 1.9, 10, 10, 3); }", shape=shape)
        self.assertGreater(methods["bug2"]["length"], 60)
        # What leans is in the way where it is low enough.
        lean = "component lean { shape box(-10, -0.1, 0, 10, 0.1, 10); at trans(0, 0, 0) * rotx(-45); }"
        data, methods = self.methods(lean)
        self.assertTrue(data["shortest"] > 50 and methods["bug2"]["verdict"] == "reached")

    def test_what_shuts_it_in(self):
        ring = " ".join(f"component wall_{i} {{ shape box(-5, 4, 0, 5, 5, 1); at trans(0, 30, 0) * rotz({90 * i}); }}" for i in range(4))
        data, methods = self.methods(ring)
        self.assertIsNone(data["shortest"])
        self.assertEqual({name: methods[name]["verdict"] for name in ("bug1", "bug2", "visbug21", "tangent", "ace")},
                         dict.fromkeys(("bug1", "bug2", "visbug21", "tangent", "ace"), "unreachable"))

    def test_a_trap(self):
        _, methods = self.methods(U)
        self.assertEqual({name for name, each in methods.items() if each["verdict"] != "reached"} - {"simple", "pledge"}, set())

    def test_table_and_csv(self):
        told = self.travel(BLOCK)
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertIn("over travels from (0.00, -20.00) to (0.00, 30.00), 50.00 m, without a map", told.stdout)
        self.assertRegex(told.stdout, r"\nbug2 +reached +70\.00 +35\.0 +\d+\.\d\d +3\n")
        self.assertIn("who knows the map goes 54.72 m\n", told.stdout)
        rows = list(csv.DictReader(io.StringIO(self.travel(BLOCK, "--format", "csv").stdout)))
        self.assertEqual([row["event"] for row in rows if row["method"] == "bug2"], ["hit", "leave", "reached"])

    def test_what_does_not_travel(self):
        told = self.travel(BLOCK, task="task over { by car; go at trans(0, 30, 0); }")
        self.assertEqual(told.returncode, 2)
        self.assertIn("go x 30, y 4;", told.stderr)
        told = rubicon("guides", os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "taskplans", "trench.plan"), "--exact")
        self.assertEqual(told.returncode, 2)

    def drive(self, guide, things=BLOCK, expected=0, options=(), start="x 0, y -20, theta 90", goal="x 0, y 30, theta 90"):
        """A vehicle that turns and drives follows a guide; the plan is verified."""
        self.write("truck.robot", """robot truck {
  time_step 1;
  body truck {
    param x step(0.5) speed(1 m/s) range(-200, 200);
    param y range(-200, 200);
    param theta cyclic step(10) speed(30 deg/s);
    rule theta <- theta + theta_s;
    rule x <- x + x_s * cos(theta) - y_s * sin(theta);
    rule y <- y + x_s * sin(theta) + y_s * cos(theta);
    frame trans(x, y, 0) * rotz(theta);
    shape box(-0.6, -0.4, 0.05, 0.6, 0.4, 1);
  }
  tool truck;
  behaviour { chain { follow } }
}
""")
        return self.run_plan('plan yard {\n  robot car "%s" { start %s; }\n  support off;\n  %s\n  guide way %s\n'
                             "  task over { by car; go %s; guide way; }\n}\n"
                             % (os.path.join(self.folder, "truck.robot"), start, things, guide, goal), expected, options)

    def record_of(self):
        with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
            record = next(record for record in map(json.loads, file) if record["type"] == "guide")
        self.assertTrue(record["found"], record.get("cause"))
        return record

    def way_of(self):
        record = self.record_of()
        numbers = record["way"]
        return [tuple(numbers[i:i + 2]) for i in range(0, len(numbers), 3)]

    def test_machines_follow_the_methods(self):
        lengths = {}
        for kind in ("bug1", "bug2", "visbug21", "simple", "tangent", "ace", "visibility"):
            _, tasks = self.drive(kind + ";")
            self.assertEqual(tasks["over"]["result"], "done", kind)
            way = self.way_of()
            self.assertEqual((way[0], way[-1]), ((0, -20), (0, 30)))
            lengths[kind] = sum(math.dist(a, b) for a, b in zip(way, way[1:]))
        # The disc has a radius of 0.72 m: the block grown by it, and what the exact walker says of a point round it.
        self.assertAlmostEqual(lengths["bug2"], 70, delta=4)
        self.assertAlmostEqual(lengths["bug1"], 130, delta=9)
        for kind, length in lengths.items():
            self.assertGreaterEqual(length, lengths["visibility"] - 1e-6, kind)

    def legs_of(self, record):
        numbers = record["graph"]
        return [(tuple(numbers[i:i + 2]), tuple(numbers[i + 3:i + 5])) for i in range(0, len(numbers), 6)]

    def test_a_full_trace_has_what_guides_searched_through(self):
        self.drive("visibility;")
        self.assertNotIn("graph", self.record_of())
        self.drive("visibility;", options=("--trace-detail", "full"))
        record, way = self.record_of(), self.way_of()
        legs = self.legs_of(record)
        self.assertEqual(record["legs"], len(legs))
        near = lambda a, b: math.dist(a, b) < 1e-6
        for a, b in zip(way, way[1:]):
            self.assertTrue(any((near(a, c) and near(b, d)) or (near(a, d) and near(b, c)) for c, d in legs), (a, b))
        # Round the block, the disc of 0.72 m: start and destination do not see each other, and nothing is seen through the block.
        for (ax, ay), (bx, by) in legs:
            for i in range(1, 20):
                x, y = ax + (bx - ax) * i / 20, ay + (by - ay) * i / 20
                self.assertFalse(-10.7 < x < 10.7 and -0.7 < y < 10.7 and (abs(x) < 10 or 0 < y < 10), (ax, ay, bx, by))

        def lead_out(result):
            guide = next(record for record in result.records if record["type"] == "guide")
            guide["graph"][3] = 1000

        self.assertIn("leg 1 of what the guide searched leads past the limits of x: 1000", self.faults_of(lead_out))
        self.drive("rrt_connect { seed 2; improve 0; }", options=("--trace-detail", "full"))
        record, way = self.record_of(), self.way_of()
        ends = {end for leg in self.legs_of(record) for end in leg}
        for place in way:
            self.assertTrue(any(near(place, end) for end in ends), place)

    def test_what_happens_on_the_way_is_told(self):
        self.drive("bug2;")
        with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
            record = next(record for record in map(json.loads, file) if record["type"] == "guide")
        self.assertEqual([event.split(" at ")[0] for event in record["events"]], ["hit", "leave", "reached"])
        self.assertRegex(record["events"][0], r"^hit at \(0\.00, -0\.7\d\) by block$")
        why = rubicon("why", self.out, "over").stdout
        self.assertRegex(why, r"    guide way \(bug2\): \d+ waypoints, \d+\.\d\d m, \d+ tests of legs\n      hit at ")
        why = json.loads(rubicon("why", self.out, "over", "--format", "json").stdout)
        self.assertEqual(why["motions"][0]["guides"][0]["events"], record["events"])

    def test_the_page_has_the_way_with_what_was_met(self):
        self.drive("tangent;", U)
        with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
            record = next(record for record in map(json.loads, file) if record["type"] == "guide")
        self.assertEqual(film_of(self.out)["walks"], [{"run": 0, "t": 0, "way": record["way"], "events": record["events"]}])
        self.assertEqual([event.split(" at ")[0] for event in record["events"]], ["hit", "track", "leave", "reached"])

    def test_the_truck_follows_with_all_its_bodies(self):
        shipped = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "robots", "truck", "swap_body_truck.robot")
        with open(shipped, encoding="utf-8") as file:
            truck = self.write("swap_body_truck.robot", file.read().replace('behaviour "straight_there.motion";', "behaviour { chain { follow } }"))
        for kind in ("bug2", "tangent", "visibility"):
            _, tasks = self.run_plan('plan yard {\n  robot car "%s" { start x 0, y -30, theta 90; }\n  support off;\n  %s\n  guide way %s;\n'
                                     "  task over { by car; go x 0, y 40, theta 90; guide way; }\n}\n" % (truck, BLOCK, kind))
            self.assertEqual(tasks["over"]["result"], "done", kind)

    def test_what_is_nearer_than_the_disc_where_it_stands_is_no_obstacle_to_leaving(self):
        kerb = BLOCK + " component kerb { shape box(0.5, -22, 0, 1.5, -18, 1); }"
        for kind in ("bug2", "tangent"):
            _, tasks = self.drive(kind + ";", kerb)  # and verify finds nothing in contact
            self.assertEqual(tasks["over"]["result"], "done", kind)
        # Where it must turn at once, the kerb is in the way.
        _, tasks = self.drive("bug2;", kerb + " component gate { shape box(-3, -18.9, 0, 3, -18.5, 1); }", expected=1)
        self.assertEqual(tasks["over"]["result"], "rejected")

    def test_ways_end_at_the_very_goal(self):
        """Corners of outlines lie on a lattice; starts and goals of machines do not."""
        for kind in ("bug1", "bug2", "visbug21", "simple", "tangent", "ace", "visibility"):
            for things, x in (("", 0.1), (BLOCK, 0.1), ("component post { shape box(1.9, 29, 0, 2.1, 31, 1); }", 1.3)):
                _, tasks = self.drive(kind + ";", things, start=f"x {x}, y -19.7, theta 90", goal="x 1.3, y 30.1, theta 90")
                self.assertEqual(tasks["over"]["result"], "done", (kind, things))
                way = self.way_of()
                self.assertEqual((way[0], way[-1]), ((x, -19.7), (1.3, 30.1)), kind)

    def test_sight_that_ends_beside_an_obstacle_ends_at_it(self):
        self.write("disc.robot", """robot disc {
  sensor 6;
  body car { param x step(0.5) range(-40, 40); param y range(-40, 40); param theta cyclic step(15);
    rule theta <- theta + theta_s; rule x <- x + x_s * cos(theta) - y_s * sin(theta); rule y <- y + x_s * sin(theta) + y_s * cos(theta);
    frame trans(x, y, 0) * rotz(theta); shape cylinder(0.5, 0.1, 1); }
  behaviour { chain { follow } }
}
""")
        schedule, _ = self.run_plan('plan p { robot "disc.robot"; guide g visbug21; start x -12, y 0, theta 0; goal x 7, y -5; guide g;'
                                    " component a { shape box(-2.98, -0.21, 0, 2.93, 0.71, 1); at trans(-1.20, -1.31, 0) * rotz(9.49); }"
                                    " component b { shape box(-1.76, -0.47, 0, 2.34, 0.51, 1); at trans(-7.02, -4.01, 0) * rotz(37.43); } }")
        self.assertEqual(schedule["tasks"][0]["result"], "done")

    def test_a_way_that_only_leads_out_is_none_to_a_goal(self):
        _, tasks = self.drive("pledge;", expected=1)
        self.assertIn("it got out, and seeks no goal; last escaped", tasks["over"]["reason"])

    def test_the_hand_says_on_which_side(self):
        sides = []
        for hand in ("right", "left"):
            self.drive("bug2 { hand %s; }" % hand)
            sides.append(min(self.way_of(), key=lambda p: abs(p[1] - 5))[0])
        self.assertLess(sides[0], -10)
        self.assertGreater(sides[1], 10)

    def test_a_goal_that_is_shut_in_is_no_way(self):
        ring = "component ring { shape box(-5, 20, 0, 5, 22, 3); shape box(-5, 38, 0, 5, 40, 3); shape box(-5, 20, 0, -3, 40, 3); shape box(3, 20, 0, 5, 40, 3); }"
        for kind in ("bug1", "bug2", "visbug21", "tangent", "ace", "visibility"):
            _, tasks = self.drive(kind + ";", ring, expected=1)
            self.assertIn("no way", tasks["over"]["reason"], kind)
        self.assertIn("there is none round what stands", tasks["over"]["reason"])

    def test_who_bars_the_only_way_is_waited_for(self):
        """As guides of other kinds do, whether it is a machine, something with a timetable, or people; walls are not waited for."""
        self.write("disc.robot", """robot disc {
  sensor 10;
  body b { param x step(0.5) speed(1 m/s) range(-100, 100); param y step(0.5) speed(1 m/s) range(-100, 100); frame trans(x, y, 0); shape cylinder(0.5, 0.1, 1); }
  tool b;
  behaviour { chain { follow } }
}
""")
        self.write("long.robot", """robot long {
  body b { param x step(0.5) speed(1 m/s) range(-100, 100); frame trans(x, 0, 0); shape box(-0.5, -1.9, 0.1, 0.5, 1.9, 1); }
  tool b;
  behaviour { chain { move_to(x, goal(x)) } }
}
""")
        walls = "component wall { shape box(5, -20, 0, 6, -2, 2); shape box(5, 2, 0, 6, 20, 2); shape box(5, -21, 0, 20, -20, 2);" \
                " shape box(5, 20, 0, 20, 21, 2); shape box(19, -20, 0, 20, 20, 2); }"
        gate = "moving gate { shape box(-0.5, -2, 0, 0.5, 2, 2); path 0 s trans(5.5, 0, 0), 60 s trans(5.5, 0, 0), 65 s trans(5.5, 0, 3); }"
        machine = 'robot other "long.robot" { start x 5.5; } task work { by other; takes 60 s; } task leave { by other; go x 16; after work; }'
        people = "crew gang; task pave { by gang; takes 60 s; zone box(5, -2, 0, 6, 2, 2); }"
        plan = 'plan p { robot m "disc.robot" { start x 0, y 0; } support off; %s %s guide way %s; task cross { by m; go x 12, y 0; guide way; priority -1; } }'
        for kind, things in (("bug2", gate), ("bug2", machine), ("tangent", people), ("visibility", gate), ("visibility", machine)):
            _, tasks = self.run_plan(plan % (walls, things, kind))
            self.assertEqual(tasks["cross"]["result"], "done", (kind, things, tasks["cross"].get("reason")))
            self.assertGreater(tasks["cross"]["duration"], 60, (kind, things))
        self.assertIn("other was in the way", rubicon("why", self.out, "cross").stdout)
        closed = "component shut { shape box(5, -2, 0, 6, 2, 2); }"
        _, tasks = self.run_plan(plan % (walls, closed + machine.replace("start x 5.5", "start x 30"), "bug2"), 1)
        self.assertIn("as far as it was seen the goal cannot be reached", tasks["cross"]["reason"])

    CART = """robot cart {
  sensor 10;
  body cart { param x range(-100, 100) step(0.5) speed(1 m/s); param y %s step(0.5) speed(1 m/s); frame trans(x, y, 0); %s }
  tool cart;
  behaviour { chain { follow } }
}
"""
    SQUARE = "shape box(-0.4, -0.4, 0.1, 0.4, 0.4, 1);"

    def cart(self, things, expected=0, shape=SQUARE, y="range(-100, 100)"):
        """One motion of a cart, as a short plan; how it ended."""
        self.write("cart.robot", self.CART % (y, shape))
        _, tasks = self.run_plan('plan p { robot "cart.robot"; %s }' % things, expected)
        return next(iter(tasks.values()))

    def test_who_begins_or_ends_near_or_in_contact_leaves_straight(self):
        disc = "shape cylinder(0.5, 0.1, 1);"
        block = "component a { shape box(0.5, -5, 0, 4, 5, 2); } start x %s, y 0; goal x %s, y 0.3; guide k %s; guide k;"
        for kind in ("bug1", "bug2", "visbug21", "tangent", "ace", "visibility"):
            self.assertEqual(self.cart(block % ("0", "4.5", kind), shape=disc)["result"], "done", kind)
        for start in ("-0.001", "-0.02"):
            self.assertEqual(self.cart(block % (start, "8", "bug2"), shape=disc)["result"], "done", start)
        # Nearer than its corners are to its place, and in a corner.
        self.assertEqual(self.cart("component a { shape box(0.4, -5, 0, 4, 5, 2); shape box(-5, -2, 0, 0.4, -0.5, 2); }"
                                   " start x -0.15, y 0; goal x 8, y 0; guide k visibility; guide k;")["result"], "done")
        # A narrow garage that it can only leave ahead, and another one.
        garage = "component bay_%d { shape box(-1, -0.6, 0, 2, -0.5, 2); shape box(-1, 0.5, 0, 2, 0.6, 2); shape box(-1.1, -0.6, 0, -1, 0.6, 2); at trans(%s, 0, 0); }"
        for kind in ("bug2", "visibility"):
            _, tasks = self.drive(kind + ";", garage % (1, "0") + garage % (2, "10"), start="x 0, y 0, theta 0", goal="x 10, y 0, theta 180")
            self.assertEqual(tasks["over"]["result"], "done", kind)

    def test_what_refused_the_steps_of_a_way_is_named(self):
        """The boom comes out on the last leg, and the disc is that of where the machine stands."""
        boom = self.SQUARE + " } body arm on cart { param z range(0, 5) step(0.5) speed(1 m/s); frame trans(0, z, 1.2); shape box(-0.1, -0.1, 0, 0.1, 0.1, 0.1);"
        ended = self.cart("component post { shape box(3.5, 1.5, 0, 5, 5, 2); } start x 0, y 0; goal x 8, y 0, z 4; guide k visibility; guide k;", 1, shape=boom)
        self.assertRegex(ended["reason"], r"step by step; most often \S*arm meets post")
        # So is what bars the only legs that there are.
        block = "component post { shape box(3, -1, 0, 4, 1, 2); } start x 0, y 0; goal x 8; lock y; guide k visibility; guide k;"
        self.assertRegex(self.cart(block, 1)["reason"], r"any other would change y; most often \S*cart meets post")
        ring = "component ring { shape box(-1, 0.4, 0, 1, 1, 2); shape box(-1, -1, 0, 1, -0.4, 2); shape box(0.4, -1, 0, 1, 1, 2); shape box(-1, -1, 0, -0.4, 1, 2); }"
        self.assertRegex(self.cart(ring + " start x 0, y 0; goal x 8, y 0; guide k bug2; guide k;", 1)["reason"],
                         r"no straight way leads away; most often \S*cart meets ring")

    def test_ranges_and_what_is_kept_bound_the_way(self):
        wall = "component a { shape box(4, -5, 0, 5, %s, 2); } start x 0, y 0; goal x 8, y 0; guide k %s guide k;"
        for kind in ("visibility;", "bug1;", "bug2 { hand left; }", "visbug21;", "tangent;"):
            self.assertEqual(self.cart(wall % (10, kind), y="range(-4, 100)")["result"], "done", kind)
        self.assertEqual(self.cart(wall % (4, "visibility { keep (y >= -2); }"))["result"], "done")
        self.assertEqual(self.cart(wall % (4, "bug2 { keep (y - 0.5 * x >= -5); hand left; }"))["result"], "done")
        for kind, y, named in (("visibility;", "range(-4, 9)", "leaves the range of y"), ("bug2;", "range(-4, 9)", "the range of y"),
                               ("visibility { keep (abs(y) <= 3); }", "range(-100, 100)", "leaves what the guide keeps")):
            self.assertIn(named, self.cart(wall % (10, kind), 1, y=y)["reason"])

    def test_only_machines_that_travel(self):
        self.write("arm.robot", "robot arm { body b { param theta cyclic step(5) speed(5 deg/s); frame rotz(theta); shape box(0, 0, 0, 2, 0.1, 1); } tool b;"
                                " behaviour { chain { follow } } }")
        plan = self.write("arm.plan", 'plan p { robot arm "arm.robot"; guide way bug2; task t { by arm; go theta 30; guide way; } }')
        told = rubicon("check", plan)
        self.assertEqual(told.returncode, 2)
        self.assertIn("bug2 is for machines that travel, and no body of 'arm' has parameters x and y", told.stderr)

    def around_a_wall(self, *options):
        """The ACE paper's Figure 3: the slab in whose way one of two walls begins to move at 70 s."""
        self.write("car.robot", (CAR % "").replace("2 m/s", "1 m/s"))
        plan = self.write("site.plan", """plan figure_3 {
  robot car "car.robot" { start x 0, y -40; }
  support off;
  component s { shape box(-20, 0, 0, 20, 4, 3); }
  component m2 { shape box(19, -20, 0, 26, 2, 3); }
  moving m1 { shape box(-26, -20, 0, -19, 2, 3); path 0 s trans(0, 0, 0), 70 s trans(0, 0, 0), 1070 s trans(-1000, 0, 0); }
  task over { by car; go x 0, y 60; }
}
""")
        told = rubicon("guides", plan, "--exact", *options)
        self.assertEqual(told.returncode, 0, told.stderr)
        return told.stdout

    def test_what_moves_keeps_its_timetable(self):
        for slices in ("0.125", "1", "5"):
            told = json.loads(self.around_a_wall("--format", "json", "--dt", slices))
            methods = {each["method"]: each for each in told["methods"]}
            self.assertEqual(sorted(methods), ["ace", "bug2", "pledge", "simple", "tangent"])
            self.assertEqual([methods[name]["verdict"] for name in ("bug2", "tangent", "ace")], ["limit", "limit", "reached"])
            self.assertAlmostEqual(methods["ace"]["length"], 148.9, delta=0.1 + float(slices))
            self.assertEqual([event["kind"] for event in methods["ace"]["events"]],
                             ["hit", "track", "tracked moves", "hit", "clear", "reached"])
        table = self.around_a_wall()
        self.assertIn("obstacles as they stand at the beginning: 3, of which 1 keep a timetable", table)
        self.assertIn("bug1      for standing obstacles only", table)
        self.assertIn("more: --format csv has all", table)
        self.assertNotIn("who knows the map", table)

    def test_a_time_slice_is_for_exact_ways(self):
        told = rubicon("guides", "x.plan", "--dt", "1")
        self.assertEqual(told.returncode, 2)
        self.assertIn("--exact", told.stderr)


if __name__ == "__main__":
    unittest.main()
