"""Trucks with bodies that haul what robots dig: queues, loads, heaps, workspaces, and whether verify follows them."""

import csv
import json
import os
import re
import unittest

from result_case import ResultCase, rubicon
from test_dig_by_motion import DIGGER, MOTION, ROOT

# A cart that goes along x and along y, so that times can be worked out.
CART = """robot cart {
  time_step 1;
  body cart {
    param x step(1) speed(2 m/s) loaded(1 m/s);
    param y step(1) speed(2 m/s);
    frame trans(x, y, 0);
    shape box(-0.5, -0.4, 0.1, 0.5, 0.4, 0.5);
  }
  body bed on cart { param z range(0, 0.2) step(0.1) speed(0.1 m/s); frame trans(0, 0, z); shape box(-0.5, -0.4, 0.55, 0.5, 0.4, 0.6); }
  touching cart bed;
  tool cart;
  behaviour "cart.motion";
}
"""
CART_MOTION = "which { dumping: chain { move_to(z, goal(z)) }; default: chain { move_to(y, goal(y)), move_to(x, goal(x)) }; };\n"
EARTHS = """earth ground { grid 60, 40; cell 0.2 m; at trans(-4, -4, 0); height 0 m; stands 90 deg; swell 0.25; density 1.8 t per m3; }
  earth yard { grid 40, 40; cell 0.25 m; at trans(14, -1, 0); height 0 m; stands 60 deg; repose 35 deg; }"""


def dig(name, robot, pit, y, more=""):
    return """task %s { by %s; dig ground to %s { bucket 0.5 m3; layer 0.4 m; cut roty(0); dump at trans(0, %g, 1.5); fill takes 2 s; dump takes 1 s;
      load at trans(0, %g, 0); queue at trans(-3, %g, 0), trans(-6, %g, 0); %s } }""" % (name, robot, pit, y, y, y, y, more)


def plan(carts=1, tip="tip at trans(16, 4, 0);", heap="heap yard at trans(2, 0, 0);", digs="dig", more="", clauses="", bed="bed 1 m3;"):
    text = "plan p {\n %s\n robot digger \"digger.robot\";\n %s\n" % (EARTHS, more)
    text += dig("dig", "digger", "box(3, -0.6, -0.8, 5, 0.6, 1)", 4)
    for i in range(1, carts + 1):
        text += " robot cart_%d \"cart.robot\" { start x %d, y 4; park x %d, y 9; }\n" % (i, -6 - 3 * i, -6 - 3 * i)
        text += " task haul_%d { by cart_%d; haul %s { %s out at trans(10, 4, 0); %s tip takes 5 s; raise z 0.2; %s back at trans(16, 7, 0), trans(-9, 7, 0); %s } }\n" % (
            i, i, digs, bed, tip, heap, clauses)
    return text + "}\n"


class HaulByMotion(ResultCase):
    def setUp(self):
        super().setUp()
        for name, text in (("digger.robot", DIGGER), ("digger.motion", MOTION), ("cart.robot", CART), ("cart.motion", CART_MOTION)):
            self.write(name, text)

    def records(self):
        with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
            return [json.loads(line) for line in file]

    def mistakes(self, text):
        run = rubicon("check", self.write("p.plan", text))
        self.assertEqual(run.returncode, 2, run.stdout + run.stderr)
        return run.stderr + run.stdout

    def test_one_cart_and_its_heap(self):
        _, tasks = self.run_plan(plan())
        haul = tasks["haul_1"]["haul"]
        dug = tasks["dig"]["motion_dig"]
        # 1.92 m3 in the ground; a cart takes 0.8 m3 of it
        self.assertAlmostEqual(haul["hauled"], 1.92, 9)
        self.assertAlmostEqual(dug["dug"], 1.92, 9)
        self.assertEqual(dug["loads"], len(haul["loads"]))
        self.assertTrue(all(load["volume"] <= 0.8 + 1e-12 for load in haul["loads"]))
        # 16 m loaded at 1 m/s; up 2 s, 5 s and down, of which only going up is before it is empty
        for load in haul["loads"]:
            self.assertAlmostEqual(load["at_tip"] - load["loaded"], 16, 6)
            self.assertAlmostEqual(load["tipped"] - load["at_tip"], 7, 6)
        # back: down 2 s, 3 m up, 25 m along, 3 m down, 3 m along: 34 m at 2 m/s; from the end of the queue 6 m
        for before, after in zip(haul["loads"], haul["loads"][1:]):
            self.assertAlmostEqual(after["arrived"] - before["tipped"], 19, 6)
            self.assertAlmostEqual(after["began"] - after["arrived"], 3, 6)
        # the heap holds it all, loose, but for less than a mm of a cell
        area = 250 * 250
        heights = {}
        for record in self.records():
            if record["type"] == "soil" and record["component"] == "yard.heap":
                self.assertLess(record["volume"], 0)
                heights.update(zip(record["cells"], record["heights"]))
        loose = 1_920_000_000 * 1.25
        self.assertLessEqual(sum(heights.values()) * area, loose)
        self.assertGreater((sum(heights.values()) + 1) * area, loose - len(haul["loads"]))
        self.assertIn("hauls", self.run_result.stdout)
        with open(os.path.join(self.out, "loads.csv"), encoding="utf-8", newline="") as file:
            loads = list(csv.DictReader(file))
        self.assertEqual([load["by"] for load in loads], ["dig"] * len(haul["loads"]))

    def test_a_queue(self):
        _, one = self.run_plan(plan())
        _, three = self.run_plan(plan(carts=3))
        self.assertLess(three["dig"]["motion_dig"]["waited"], one["dig"]["motion_dig"]["waited"])
        loads = sorted((load for i in (1, 2, 3) for load in three["haul_%d" % i]["haul"]["loads"]), key=lambda load: load["began"])
        self.assertAlmostEqual(sum(load["volume"] for load in loads), 1.92, 9)
        arrived = [load["arrived"] for load in loads]
        self.assertEqual(arrived, sorted(arrived))
        for first, second in zip(loads, loads[1:]):
            self.assertGreaterEqual(second["began"], first["loaded"])

    def test_the_shortest_queue(self):
        text = plan(carts=2, digs="dig, dig_too", more="").replace("robot digger", "robot other \"digger.robot\" at trans(0, 8, 0) { start theta 90; } robot digger", 1)
        text = text.replace("task haul_1", dig("dig_too", "other", "box(-0.5, 10, -0.4, 0.5, 11.4, 1)", 5.6).replace("ground to", "far to") + " task haul_1", 1)
        text = text.replace("earth yard", "earth far { grid 40, 40; cell 0.2 m; at trans(-4, 7, 0); height 0 m; stands 90 deg; swell 0.25; } earth yard", 1)
        text = text.replace("trans(16, 7, 0), trans(-9, 7, 0)", "trans(16, 2.6, 0), trans(-9, 2.6, 0)")
        _, tasks = self.run_plan(text)
        first = {name: tasks[name]["haul"]["loads"][0]["dig"] for name in ("haul_1", "haul_2")}
        # the first takes the nearest, the second the one where nobody is
        self.assertEqual(set(first.values()), {"dig", "dig_too"})

    def test_no_room_to_tip(self):
        _, tasks = self.run_plan(plan(tip="tip at trans(16, 4, 0), trans(16, 1.5, 0);", heap="heap yard at trans(0.8, 0, 0);"), None)
        self.assertEqual(tasks["haul_1"]["result"], "rejected")
        self.assertIn("no room left to tip", tasks["haul_1"]["reason"])
        self.assertIn("no truck is left", tasks["dig"]["reason"])
        _, tasks = self.run_plan(plan(heap="heap yard at trans(-8, 0, 0);"), 1)
        self.assertIn("beside earth 'yard'", tasks["haul_1"]["reason"])

    def test_a_row_of_heaps(self):
        # Where the heap has come too near, the cart stands farther away: each load falls in another cell, 0.25 m or more from the last.
        _, tasks = self.run_plan(plan(heap="heap yard at trans(1.6, 0, 0);"))
        self.assertEqual(tasks["haul_1"]["result"], "done")
        # a cart goes straight from x = 10 to where it tips
        stands = [record["q"]["x"] for record in self.records() if record["type"] == "end" and record["task"] == "haul_1" and record["q"]["z"] == 0.2]
        places = sorted(set(stands))
        self.assertGreater(len(places), 1)
        self.assertEqual(places[-1], 16)
        self.assertTrue(all(abs((16 - x) / 0.25 - round((16 - x) / 0.25)) < 1e-9 for x in places), places)
        # what it tips elsewhere than in that row is seen
        self.assertIn("does not stand at one of its places", self.faults_of(lambda result: result.task("haul_1")["haul"].update(
            tips=[[1, 0, 0, 15, 0, 1, 0, 4, 0, 0, 1, 0]])))

    def test_an_empty_cart_leaves_the_tip(self):
        # All is dug when the first has tipped, and the second can tip nowhere else.
        text = plan(carts=2, bed="bed 0.7 m3;")
        for text in (text, re.sub(r" park x -\d+, y 9;", "", text)):
            _, tasks = self.run_plan(text)
            self.assertEqual({task["result"] for task in tasks.values()}, {"done"}, tasks)
        # Without a way back it goes to its park position, and without that nobody can make it.
        text = re.sub(r"back at [^;]*;", "", plan(carts=2, bed="bed 0.7 m3;")).replace("out at trans(10, 4, 0)", "out at trans(10, 2, 0)")
        _, tasks = self.run_plan(text)
        self.assertEqual({task["result"] for task in tasks.values()}, {"done"}, tasks)
        _, tasks = self.run_plan(re.sub(r" park x -\d+, y 9;", "", text), 1)
        self.assertIn("never leaves the place where it is to tip; give cart_", tasks["haul_2"]["reason"])

    def test_nobody_drives_through_a_pit(self):
        _, _, second = plan(carts=2).rpartition("task haul_2")
        over = second.replace("back at trans(16, 7, 0), trans(-9, 7, 0);", "back at trans(16, -3, 0), trans(4, -3, 0), trans(4, 7, 0), trans(-9, 7, 0);")
        _, tasks = self.run_plan(plan(carts=2).replace(second, over), 1)
        self.assertEqual([task["result"] for task in tasks.values()], ["done", "done", "rejected"])
        self.assertIn("the pit of dig", tasks["haul_2"]["reason"])
        # what would drive over it is seen
        self.assertIn("it drives over the pit of dig", self.faults_of(lambda result: result.robot("cart_1").update(
            pose=[1, 0, 0, 0, 0, 1, 0, -4, 0, 0, 1, 0])))

    def test_nobody_drives_over_the_pit_of_crews(self):
        pit = "crew hands; crew barrows; task trench { by hands; dig ground to box(6, 3, %s, 6.8, 3.8, 1) { load barrows takes 10 min; bed 1 m3; tip takes 1 s; } %s }"
        _, tasks = self.run_plan(plan(more=pit % (-0.5, "after haul_1;")))
        self.assertEqual(tasks["trench"]["result"], "done")
        begins = tasks["trench"]["start"]
        self.assertIn("it drives over the pit of trench", self.faults_of(lambda result: [
            record.update(t=5) for record in result.records if record.get("task") == "trench" and "t" in record]))
        # From its beginning on, while it is dug and after that; before that the ground is whole.
        for start, load in ((0, 1), (100, 2), (int(begins) - 1, 0)):
            _, tasks = self.run_plan(plan(more=pit % (-0.5, "not_before %g s;" % start)), None)
            self.assertEqual(tasks["trench"]["start"], start)
            self.assertEqual(tasks["haul_1"]["result"], "rejected" if load else "done")
            if load:
                self.assertIn(f"load {load}, ", tasks["haul_1"]["reason"])
                self.assertIn("cart_1.cart meets the pit of trench", tasks["haul_1"]["reason"])
        # It drives over what is 0.15 m deep.
        _, tasks = self.run_plan(plan(more=pit % (-0.1, "")))
        self.assertEqual(tasks["haul_1"]["result"], "done")

    def test_nobody_drives_over_a_pit_on_another_errand(self):
        text = "plan p { " + EARTHS + """ robot cart "cart.robot" { start x -9, y 2; } crew hands; crew barrows;
          task trench { by hands; dig ground to box(2, 1, %s, 3, 3, 1) { load barrows takes 10 min; bed 1 m3; tip takes 1 s; } }
          task drive { by cart; go x 7; after trench; } }"""
        _, tasks = self.run_plan(text % -0.5, 1)
        self.assertIn("cart.cart meets the pit of trench", tasks["drive"]["reason"])
        # a trolley on rails 6 m above it is no vehicle there
        self.run_plan((text % -0.5).replace('"cart.robot"', '"cart.robot" at trans(0, 0, 6)'))
        # what is 0.15 m deep is driven over
        _, tasks = self.run_plan(text % -0.15)
        self.assertEqual(tasks["drive"]["result"], "done")
        self.assertIn("it drives over the pit of trench", self.faults_of(lambda result: [
            result.task("trench")["dig"]["pit"].update(after=[-500 for _ in result.task("trench")["dig"]["pit"]["after"]])]))

    def test_a_dig_keeps_its_reason_without_its_truck(self):
        # The bucket cannot get past the cab. The truck has nobody to haul for then, which says nothing new of the dig.
        with open(os.path.join(ROOT, "taskplans", "trench_hauled.plan"), encoding="utf-8") as file:
            text = file.read().replace('"../robots', '"' + os.path.join(ROOT, "robots")).replace("trans(2, 6.2, 2.9)", "trans(4.9, 6.2, 2.9)")
        _, tasks = self.run_plan(text, 1, ("--set", "trucks=1"))
        self.assertIn("excavator.bucket meets lorry_1.truck", tasks["dig_trench"]["reason"])
        self.assertIn("none of the tasks that it hauls for digs", tasks["haul_1"]["reason"])

    def test_verify_sees_what_is_changed(self):
        self.run_plan(plan())

        def soils(result, sign):
            return [at for at in result.places("soil") if result.records[at]["task"] == "haul_1" and sign * result.records[at]["volume"] > 0]

        def loaded(**changes):
            return lambda result: result.records[soils(result, 1)[0]].update(
                {name: value(result.records[soils(result, 1)[0]][name]) for name, value in changes.items()})

        def tipped(**changes):
            return lambda result: result.records[soils(result, -1)[1]].update(
                {name: value(result.records[soils(result, -1)[1]][name]) for name, value in changes.items()})

        def header(**changes):
            return lambda result: result.task("haul_1")["haul"].update(changes)

        for change, text in (
                (loaded(volume=lambda volume: volume + 1), "were emptied on it"),
                (loaded(**{"from": lambda time: time - 8}), "does not stand where it is loaded"),
                (tipped(volume=lambda volume: volume + 1), "it tips"),
                (tipped(heights=lambda heights: [heights[0] + 1] + heights[1:]), "a heap grows by"),
                (tipped(cells=lambda cells: [0] + cells[1:]), "steeper than"),
                (header(loads=[700_000_000]), "has room for"),
                (header(tips=[[1, 0, 0, 15, 0, 1, 0, 4, 0, 0, 1, 0]]), "does not stand at one of its places"),
                (header(falls_at=[1, 0, 0]), "does not lie where it fell")):
            self.assertIn(text, self.faults_of(change))

    def test_verify_sees_changed_figures(self):
        schedule, tasks = self.run_plan(plan())

        def changed(of, name, by=1e-3):
            def change(result):
                row = of(result.schedule)
                row[name] = not row[name] if isinstance(row[name], bool) else row[name] + ("x" if isinstance(row[name], str) else by)
            return change

        def row(task, key):
            return lambda schedule: next(each for each in schedule["tasks"] if each["task"] == task)[key]

        dig, haul = row("dig", "motion_dig"), row("haul_1", "haul")
        cases = [(dig, name) for name in tasks["dig"]["motion_dig"] if name not in ("earth", "mean")]
        cases += [(lambda schedule: dig(schedule)["mean"], name) for name in tasks["dig"]["motion_dig"]["mean"]]
        cases += [(haul, name) for name in ("hauled", "working")]
        cases += [(lambda schedule: haul(schedule)["mean"], name) for name in tasks["haul_1"]["haul"]["mean"]]
        cases += [(lambda schedule: haul(schedule)["loads"][1], name) for name in tasks["haul_1"]["haul"]["loads"][1]]
        cases += [(lambda schedule: schedule["hauling"], name) for name in schedule["hauling"]]
        for of, name in cases:
            by = 10_000 if name in ("buckets", "waited") else 1 if name in ("trucks", "loads") else 1e-3
            self.assertIn("earthwork: ", self.faults_of(changed(of, name, by)), name)
        self.assertIn("what it dug or hauled is not told", self.faults_of(
            lambda result: next(each for each in result.schedule["tasks"] if each["task"] == "haul_1").pop("haul")))

    def test_workspaces(self):
        # two carts that meet where their ways cross: the second must not come near
        cross = """plan p { robot a "cart.robot" { start x -10, y 0; } robot b "cart.robot" { start x 0.5, y -9; }
          %s task go_a { by a; go x 10; } task go_b { by b; go y 10; not_before 0.25 s; } }"""
        keep = "workspaces { of a, b; reaction 1 s; braking 2 m/s2; }"
        _, tasks = self.run_plan(cross % "")
        free = tasks["go_b"]["waited"]["machine"]
        _, tasks = self.run_plan(cross % keep)
        self.assertGreater(tasks["go_b"]["waited"]["machine"], free)
        self.assertEqual(tasks["go_a"]["waited"]["machine"], 0)
        _, tasks = self.run_plan(cross % keep.replace("a, b", "b, a"))
        self.assertGreater(tasks["go_a"]["waited"]["machine"], 0)
        self.assertEqual(tasks["go_b"]["waited"]["machine"], 0)
        # what was too near without workspaces is seen where they are said to be kept
        self.run_plan(cross % "")
        self.assertIn("overlaps that of", self.faults_of(lambda result: result.header.update(
            {"workspaces": {"of": ["a", "b"], "reaction": 1, "braking": 2, "turn_braking": 30}})))
        people = keep + " moving worker { shape box(-0.3, -0.3, 0, 0.3, 0.3, 1.8); path 0 s trans(2, -3, 0), 3 s trans(2, 0, 0), 12 s trans(2, 0, 0), 15 s trans(2, 5, 0); people; }"
        _, tasks = self.run_plan(cross % people)
        self.assertGreater(tasks["go_a"]["waited"]["machine"], 0)

    def test_what_no_truck_can_do(self):
        # the bucket would have to go into the cart; a wall before the tip; deeper than the tool reaches
        _, tasks = self.run_plan(plan().replace("dump at trans(0, 4, 1.5)", "dump at trans(0, 4, 0.3)"), 1)
        self.assertIn("bucket 1: digger cannot empty it over cart_1, which is in its way", tasks["dig"]["reason"])
        _, tasks = self.run_plan(plan(more="component wall { shape box(12, -30, 0, 12.2, 40, 3); } support off;"), 1)
        self.assertIn("load 1, on its way to tip: blocked by wall", tasks["haul_1"]["reason"])
        _, tasks = self.run_plan(plan().replace("-0.8, 5", "-60, 5").replace("layer 0.4", "layer 5"), 1)
        self.assertIn("bucket 1: digger cannot reach (4.90, -0.50, -5.00) to dig there", tasks["dig"]["reason"])

    def test_a_payload_is_of_the_density_of_the_dig(self):
        heavy = "density 5 t per m3;"
        for text in (plan(bed="bed 1 m3; payload 3 t;").replace("queue at", heavy + " queue at"),
                     plan(bed="bed 1 m3; payload 3 t;").replace("density 1.8 t per m3;", heavy),
                     plan(bed="bed 1 m3; payload 3 t;").replace("density 1.8 t per m3;", "").replace("queue at", heavy + " queue at")):
            _, tasks = self.run_plan(text)
            loads = [load["volume"] for load in tasks["haul_1"]["haul"]["loads"]]
            # 3 t are 0.6 m3 of it: one bucket of 0.4 m3, not two
            self.assertEqual(max(loads), 0.4)

    def test_mistakes(self):
        for text, expected in (
                (plan(tip=""), "does not say where the truck tips"),
                (plan(bed=""), "does not say how much the truck takes"),
                (plan(bed="bed 0.4 m3;"), "less than a bucket"),
                (plan(bed="payload 3 t;", digs="dig").replace("density 1.8 t per m3;", ""), "needs the density"),
                (plan(digs="dug"), "did you mean dig?"),
                (plan().replace("load at trans(0, 4, 0)", "load at trans(0, 9, 0)"), "empties its bucket 4.6 m beside the truck of 'haul_1'"),
                (plan().replace("swell 0.25", "swell -0.25"), "the swell of earth 'ground' cannot be negative"),
                (plan(bed="bed 1e9 m3;"), "expected a volume from 0.001 to 1e+06 m3 as bed"),
                (plan().replace("tip takes 5 s", "tip takes -5 s"), "tip cannot be negative"),
                (plan(digs="dig, dig"), "is named twice"),
                (plan(carts=0), "nobody hauls what 'dig' loads"),
                (plan(more="crew driver;").replace("by digger;", "by digger, driver;").replace("by cart_1;", "by cart_1, driver;"),
                 "'haul_1' and 'dig', which loads it, need 2 people of crew 'driver' at once, and it has 1"),
                (plan().replace("repose 35 deg;", ""), "how steep loose soil lies"),
                (plan(clauses="raise x 3;").replace("raise z 0.2;", ""), "it is not raised"),
                (plan(clauses="bed 2 m3;"), "bed is given twice"),
                (plan(clauses="sides 2 m3;"), "unknown item 'sides' in this haul"),
                (plan().replace("by cart_1;", "by digger;"), "does not drive"),
                (plan().replace("by cart_1; haul", "by cart_1; takes 3 s; haul"), "no takes"),
                (plan().replace("by cart_1; haul", "by cart_1; go x 3; haul"), "does nothing else"),
                (plan().replace("load at trans(0, 4, 0);", ""), "trucks queue for a place"),
                (plan().replace("load at trans(0, 4, 0);", "load at trans(0, 4, 0), trans(1, 4, 0);"), "one truck is loaded at a time"),
                (plan().replace("load at trans(0, 4, 0);", "load at trans(0, 4, 0); bed 2 m3;"), "bed is of the tasks that haul"),
                (plan(more="workspaces { of digger; }"), "workspaces are of several machines"),
                (plan(more="workspaces { of digger, kart_1; }"), "did you mean cart_1?"),
                (plan(more="workspaces { of digger, cart_1; braking 0 m/s2; }"), "braking")):
            self.assertIn(expected, self.mistakes(text), text)


if __name__ == "__main__":
    unittest.main()
