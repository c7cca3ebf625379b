"""A robot that digs with its own body: volumes, trucks, what is in the way, and whether verify follows each bucket."""

import csv
import json
import os
import unittest

from result_case import ResultCase, rubicon

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# A bucket on a turntable, an arm that goes out, a mast: each joint by itself, so that times can be worked out.
DIGGER = """robot digger {
  time_step 1;
  body post { shape box(-0.5, -0.5, 0, 0.5, 0.5, 1); }
  body arm on post { param theta cyclic step(90) speed(30 deg/s); frame rotz(theta); shape box(-0.2, -0.2, 4.6, 0.2, 0.2, 5); }
  body slide on arm { param x range(1.5, 7) step(10) speed(1 m/s) start(3); frame trans(x, 0, 0); shape box(-0.1, -0.1, 4.6, 0.1, 0.1, 5); }
  body mast on slide { param z range(-3, 3) step(10) speed(0.5 m/s) start(2); frame trans(0, 0, z); shape box(-0.1, -0.1, 0.8, 0.1, 0.1, 4.4); }
  body bucket on mast { frame trans(0, 0, 0); shape box(-0.25, -0.4, 0, 0.25, 0.4, 0.8); }
  tool bucket;
  behaviour "digger.motion";
}
"""
MOTION = """which {
  digging: chain { line };
  empty: chain { move_to(theta, goal(theta)), move_to(x, goal(x)), move_to(z, goal(z)) };
  default: chain { move_to(z, goal(z)), move_to(theta, goal(theta)), move_to(x, goal(x)) };
};
"""
EARTH = "earth ground { grid 60, 40; cell 0.2 m; at trans(-4, -4, 0); height 0 m; stands %g deg; swell 0.25; density 1.8 t per m3; }"
TRUCKS = "load trucks; bed 2 m3; haul takes 90 s; tip takes 20 s by dozer; return takes 60 s;"


def plan(pit="box(3, -0.6, -0.8, 5, 0.6, 1)", clauses="", trucks=TRUCKS, count=2, stands=90, more=""):
    return """plan p {
      %s
      robot digger "digger.robot" { cost 90 per h; }
      crew trucks { size %d; cost 60 per h; } crew dozer; crew hand;
      %s
      task dig { by digger; dig ground to %s { bucket 0.5 m3; layer 0.4 m; cut roty(0); dump at trans(0, 4, 1.5);
        fill takes 2 s; dump takes 1 s; %s %s } } }""" % (EARTH % stands, count, more, pit, trucks, clauses)


class DigByMotion(ResultCase):
    def setUp(self):
        super().setUp()
        self.write("digger.robot", DIGGER)
        self.write("digger.motion", MOTION)

    def rejected(self, text):
        """The reason why the dig is not done."""
        _, tasks = self.run_plan(text, 1)
        self.assertEqual(tasks["dig"]["result"], "rejected", tasks["dig"])
        return tasks["dig"]["reason"]

    def mistakes(self, text):
        run = rubicon("check", self.write("p.plan", text))
        self.assertEqual(run.returncode, 2, run.stdout + run.stderr)
        return run.stderr + run.stdout

    def soils(self):
        with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
            return [record for record in map(json.loads, file) if record["type"] == "soil"]

    def test_a_trench_and_its_trucks(self):
        schedule, tasks = self.run_plan(plan())
        dig = tasks["dig"]["motion_dig"]
        # 2 m x 1.2 m x 0.8 m, whole mm3
        self.assertEqual(sum(soil["volume"] for soil in self.soils()), 2000 * 1200 * 800)
        self.assertAlmostEqual(dig["dug"], 1.92, 12)
        self.assertAlmostEqual(dig["bucket"], 0.4, 12)
        self.assertGreaterEqual(dig["buckets"], 5)
        self.assertLessEqual(dig["buckets"], 8)
        self.assertTrue(all(soil["volume"] <= 400_000_000 for soil in self.soils()))
        # a truck takes 1.6 m3 as it lies: it leaves when no whole bucket of 0.4 m3 goes in any more
        with open(os.path.join(self.out, "loads.csv"), encoding="utf-8", newline="") as file:
            loads = list(csv.DictReader(file))
        self.assertEqual(len(loads), dig["loads"])
        self.assertAlmostEqual(sum(float(load["volume"]) for load in loads), 1.92, 6)
        self.assertTrue(all(float(load["volume"]) <= 1.6 for load in loads))
        self.assertEqual({load["by"] for load in loads}, {"digger"})
        for load in loads:
            self.assertAlmostEqual(float(load["tipped"]) - float(load["loaded"]), 110, 3)
        # the task ends with the last tip, and all its time is told
        self.assertAlmostEqual(tasks["dig"]["duration"], max(float(load["tipped"]) for load in loads), 3)
        mean = dig["mean"]
        self.assertAlmostEqual(mean["cycle"], mean["to_the_cut"] + mean["cut"] + mean["swing"] + mean["dump"], 6)
        self.assertIn("m3 a bucket", self.run_result.stdout)

    def with_mast_beyond_bucket(self, beyond):
        """A pit of 1.2 m whose far wall the mast meets where the bucket keeps 20 mm from it."""
        self.write("digger.robot", DIGGER.replace("shape box(-0.1, -0.1, 0.8, 0.1,", "shape box(-0.1, -0.1, 0.8, %g," % (0.25 + beyond)))
        return plan(pit="box(3, -0.6, -1.2, 5, 0.6, 1)", trucks="")

    def test_a_cut_that_is_blocked_begins_nearer(self):
        self.run_plan(self.with_mast_beyond_bucket(0.08))
        self.assertEqual(sum(soil["volume"] for soil in self.soils()), 2000 * 1200 * 1200)
        with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
            ends = [record for record in map(json.loads, file) if record["type"] == "end"]
        blocked = [end for end in ends if not end["reached"]]
        self.assertTrue(blocked)
        self.assertTrue(all(end["rejected"]["hit"] == 1 for end in blocked))

        def hit_nothing(result):
            end = next(record for record in result.records if record["type"] == "end" and not record["reached"])
            end["rejected"].update({"hit": 0, "no direction": 1})

        self.assertIn("the digging goes on and its motion ended with 'done'", self.faults_of(hit_nothing))

    def test_a_pit_in_which_every_cut_is_blocked(self):
        reason = self.rejected(self.with_mast_beyond_bucket(0.5))
        self.assertIn("digger.mast meets ground", reason)

    def test_waits_for_its_only_truck(self):
        one, _ = self.run_plan(plan(count=1)), None
        waited = one[1]["dig"]["motion_dig"]["waited"]
        # from when the first truck left until it is back, 170 s; meanwhile nothing is dug
        self.assertAlmostEqual(waited, 170, 3)
        alone = self.run_plan(plan(trucks=""))[1]["dig"]
        self.assertNotIn("waited", alone["motion_dig"])
        self.assertAlmostEqual(one[1]["dig"]["duration"], alone["duration"] + 170 + 110, 3)

    def test_fuel(self):
        """At work while it moves, fills and empties, idling while it waits for its truck; a truck is at work while it drives and tips."""
        text = plan(count=1).replace("cost 90 per h;", "cost 90 per h; fuel 18 l per h idling 6 l per h price 2 per l;").replace(
            "cost 60 per h;", "cost 60 per h; fuel 12 l per h idling 3 l per h;").replace("crew dozer;", "crew dozer { fuel 30 l per h; }")
        schedule, tasks = self.run_plan(text)
        dig = tasks["dig"]
        use = {each["name"]: each for each in schedule["resources"]}
        use_of = {each["name"]: i for i, each in enumerate(schedule["resources"])}
        working = dig["motion"] + dig["work"]
        self.assertGreater(dig["duration"] - working, 60)
        digger = (18 * working + 6 * (dig["duration"] - working)) / 3600
        self.assertAlmostEqual(use["digger"]["fuel"], digger, delta=6e-4)
        self.assertAlmostEqual(use["digger"]["cost"], 90 * dig["duration"] / 3600 + 2 * digger, delta=0.011)
        self.assertAlmostEqual(schedule["cost_by_kind"]["fuel"], 2 * digger, delta=0.011)
        self.assertNotIn("fuel", use["hand"])
        # Each load 90 s and 20 s, and 60 s back but after the last.
        loads = dig["motion_dig"]["loads"]
        driving = 110 * loads + 60 * (loads - 1)
        self.assertGreater(loads, 1)
        self.assertAlmostEqual(use["trucks"]["fuel"], (12 * driving + 3 * (dig["duration"] - driving)) / 3600, delta=6e-4)
        self.assertAlmostEqual(use["dozer"]["fuel"], 30 * 20 * loads / 3600, delta=6e-4)
        # Busy: what a machine fills and empties is its own work, and trucks and dozer have their rounds.
        busy = {name: each["busy"] for name, each in use.items()}
        self.assertGreater(dig["work"], 0)
        self.assertAlmostEqual(busy["digger"], working, 6)
        self.assertEqual((busy["hand"], busy["trucks"], busy["dozer"]), (0, driving, 20 * loads))
        self.assertAlmostEqual(dig["fuel"], sum(use[name]["fuel"] for name in ("digger", "trucks", "dozer")), delta=2e-3)
        self.assertAlmostEqual(schedule["fuel"], dig["fuel"], delta=1e-6)
        self.assertAlmostEqual(dig["motion_dig"]["fuel_per_m3"], dig["fuel"] / dig["motion_dig"]["dug"], places=9)
        self.assertIn(" l per m3 ", self.run_result.stdout)

        def end(result):
            return next(record for record in result.records if record["type"] == "task_end" and record["task"] == "dig")

        for change, words in (
                (lambda result: result.schedule["resources"][0].update(fuel=use["digger"]["fuel"] + 0.01), "digger burnt "),
                (lambda result: result.schedule["resources"][0].pop("fuel"), "what digger burnt is missing"),
                (lambda result: result.schedule["resources"][0].update(busy=dig["motion"]), "digger: the time busy is "),
                (lambda result: result.schedule["resources"][use_of["trucks"]].update(busy=dig["work"]), "trucks: the time busy is "),
                (lambda result: result.schedule["tasks"][0].update(fuel=dig["fuel"] - 0.01), "dig burnt "),
                (lambda result: result.schedule.update(fuel=0), "the whole burnt 0"),
                (lambda result: result.header["robots"][0]["fuel"].update(price=2.2), "fuel costs "),
                (lambda result: result.header["robots"][0]["fuel"].update(idling=7), "digger burnt "),
                (lambda result: end(result).update(driving=driving + 1), f"its trucks drive for {driving + 1} s, by when they left {driving} s"),
                (lambda result: end(result).update(serving=[1]), "its trucks are not served as long"),
                (lambda result: end(result).pop("driving"), "trucks burnt ")):
            self.assertIn(words, self.faults_of(change))
        # Who sits beside the digger does not do what it fills and empties.
        schedule, _ = self.run_plan(text.replace("by digger;", "by digger, hand;"))
        hand = next(each for each in schedule["resources"] if each["name"] == "hand")
        self.assertEqual((hand["held"], hand["busy"]), (dig["duration"], 0))
        # Two trucks that queue for the dozer.
        self.run_plan(text.replace("size 1", "size 3").replace("tip takes 20 s", "tip takes sequence(150 s, 130 s)"))
        # Nothing of it where nobody says so.
        schedule, tasks = self.run_plan(plan())
        self.assertNotIn("fuel", json.dumps(schedule))
        self.assertNotIn("l per m3", self.run_result.stdout)

    def test_slopes_and_corners(self):
        _, tasks = self.run_plan(plan("box(3, -1.4, -0.8, 4.6, 0.2, 1)", stands=60, trucks=""))
        self.assertEqual(sum(soil["volume"] for soil in self.soils()), round(tasks["dig"]["motion_dig"]["volume"] * 1e9))

    def test_a_cut_that_takes_nothing_is_not_made_again(self):
        # A tilted bucket that comes near the cells of a slope and not over them.
        excavator = os.path.join(ROOT, "robots", "excavator", "excavator_digging.robot")
        for tilt, depth in ((110, 0.8), (100, 0.5), (70, 0.8)):
            with self.subTest(tilt=tilt):
                reason = self.rejected("""plan p {
                  earth ground { grid 48, 28; cell 0.5 m; at trans(-6, -7, 0); height 0 m; stands 60 deg; swell 0; density 2.2 t per m3; }
                  robot ex "%s";
                  task dig { by ex; dig ground to box(4, -0.35, -%g, 5.3, 0.35, 1) { bucket 1.4 m3; fill_factor 0.95; layer 0.8 m; cut roty(%d); open roty(40);
                    dump at trans(2, 6.2, 2.9); fill takes 2 s; dump takes 2 s; } } }""" % (excavator, depth, tilt))
                self.assertRegex(reason, "does not (get down|fit in)")

    def test_what_is_in_the_way_is_named(self):
        reason = self.rejected(plan(more="component pipe { shape box(3.9, -2, -0.5, 4.1, 2, -0.3); fixed to site; } touching pipe site;"))
        self.assertIn("blocked by pipe", reason)
        self.assertIn("bucket 1", reason)
        reason = self.rejected(plan("box(3, -0.6, -3.6, 5, 0.6, 1)", "tolerance 0.05 m;", trucks=""))
        self.assertIn("digger cannot reach", reason)
        reason = self.rejected(plan("box(6.4, -0.6, -0.4, 7.8, 0.6, 1)", trucks=""))
        self.assertIn("digger cannot reach", reason)
        reason = self.rejected(plan("box(3, -0.2, -0.8, 5, 0.2, 1)", trucks=""))
        self.assertIn("does not fit in at", reason)
        shed = "component shed { shape box(-0.3, -0.3, 0, 0.3, 0.3, 0.5); at trans(4, 0, 0); mass 1 t; } support on;"
        self.assertIn("without it shed does not stand", self.rejected(plan(more=shed)))

    def test_two_wait_for_each_other(self):
        second = """robot other "digger.robot" at trans(9, 0, 0) { start theta 180; park theta 180, x 3, z 2; }
          task dig_too { by other; dig ground to box(5.2, -0.6, -0.4, 6.4, 0.6, 1) { bucket 0.5 m3; layer 0.4 m; cut roty(0); dump at trans(4.5, 3, 1.5); } }"""
        _, tasks = self.run_plan(plan("box(2.4, -0.6, -0.4, 5, 0.6, 1)", trucks="", more=second).replace("trans(0, 4, 1.5)", "trans(4.5, 3, 1.5)"))
        self.assertEqual({task["result"] for task in tasks.values()}, {"done"})
        self.assertGreater(sum(task["waited"]["machine"] for task in tasks.values()), 0)

    def test_pits_side_by_side_in_any_order_of_the_file(self):
        # Soil stands until the links say that it is gone: beside the pit that is dug, as any ground that stays.
        def dig(name, by, pit, dump, after=""):
            return """task %s { by %s; dig ground to %s { bucket 0.5 m3; layer 0.4 m; cut roty(0); dump at trans(%g, 4, 1.5); fill takes 2 s; dump takes 1 s; } %s }
              """ % (name, by, pit, dump, after)

        head = "plan p { %s robot digger \"digger.robot\"; " % (EARTH % 90)
        second = "robot other \"digger.robot\" at trans(9, 0, 0) { start theta 180; } "
        near, far = "box(3, -0.6, -0.8, 4.4, 0.6, 1)", "box(4.4, -0.6, -0.8, 6, 0.6, 1)"
        for digs in ((("near", "digger", near, 0, ""), ("far", "digger", far, 0, "after near;")),
                     (("near", "digger", near, 0, "after far;"), ("far", "digger", far, 0, "")),
                     (("near", "digger", near, 0, ""), ("far", "other", far, 9, ""))):
            ends = []
            for order in (digs, digs[::-1]):
                text = "".join(dig(*each) for each in order)
                _, tasks = self.run_plan(head + (second if "other" in text else "") + text + "}")
                self.assertEqual({task["result"] for task in tasks.values()}, {"done"}, tasks)
                ends.append([task["duration"] for _, task in sorted(tasks.items())])
            self.assertEqual(ends[0], ends[1])

    def test_fine_cells(self):
        # Cuts beside a wall are tried whatever the cells are, and the corners come away with one that passes them.
        for cell, pit in ((0.05, "box(3, -0.6, -0.4, 4, 0.6, 1)"), (0.1, "box(3, 0.3, -0.4, 4.4, 1.9, 1)"), (0.05, "box(3, 0.3, -0.4, 4.4, 1.9, 1)")):
            text = plan(pit, trucks="").replace("grid 60, 40; cell 0.2 m", "grid %d, %d; cell %g m" % (12 / cell, 8 / cell, cell))
            _, tasks = self.run_plan(text)
            self.assertEqual(tasks["dig"]["result"], "done")

    def test_verify_sees_what_is_changed(self):
        self.run_plan(plan(count=1))

        def soil(number, **changes):
            def change(result):
                at = result.places("soil")[number]
                result.records[at].update({name: value(result.records[at][name]) for name, value in changes.items()})
            return change

        def header(**changes):
            def change(result):
                result.task("dig")["motion_dig"].update(changes)
            return change

        def drop(result):
            del result.records[result.places("soil")[1]]

        def no_pause(result):
            for record in result.records:
                if record["type"] == "pause" and record["why"] == "truck":
                    record["for"] = "nobody"

        lower = [lambda heights: [heights[0] - 10] + heights[1:]][0]
        for change, text in (
                (soil(1, volume=lambda volume: volume + 40000), "its cells lose"),
                (soil(1, heights=lower), "its cells lose"),
                (soil(0, cells=lambda cells: [0] + cells[1:]), "is not of the pit"),
                (soil(2, **{"from": lambda time: time + 1.5}), "meets dig.soil"),
                (soil(2, **{"from": lambda time: time - 30}), "before the one before it is out of it"),
                (header(bucket=300_000_000), "a bucket of 300000000 mm3 takes"),
                (header(place=[0, 4.5, 1.5]), "was not emptied"),
                (header(volume=1), "are not the"),
                (drop, "soil: "),
                (no_pause, "loads none")):
            self.assertIn(text, self.faults_of(change))

    def test_mistakes(self):
        for text, expected in (
                (plan(trucks="").replace("layer 0.4 m; ", ""), "does not say how deep a layer is"),
                (plan(trucks="").replace("cut roty(0);", "cut trans(1, 0, 0);"), "no place: only rotations"),
                (plan(trucks="").replace("1.5)", "1.5) * rotz(3)"), "dump at is a place"),
                (plan(trucks="load trucks takes 3 min; bed 2 m3; tip takes 1 min;"), "no takes"),
                (plan(trucks="load trucks; bed 2 m3;"), "the trucks never tip"),
                (plan().replace("by digger;", "by digger, dozer;"), "crew 'dozer' does something else in this task already"),
                (plan(trucks="load trucks; bed 0.3 m3; tip takes 1 min;"), "less than a bucket"),
                (plan(trucks="haul takes 1 min;"), "is a stage of trucks"),
                (plan(clauses="limit 3 h;"), "limit is of a dig by durations"),
                (plan(clauses="layer 1 m;"), "layer is given twice"),
                (plan(clauses="tolerance 0.001 m;"), "the tolerance"),
                (plan(clauses="layers 1 m;"), "did you mean layer?"),
                (plan().replace("by digger;", "by hand;"), "is of a dig by a robot"),
                (plan().replace("ground to box(3, -0.6, -0.8, 5, 0.6, 1)", "10 m3"), "a volume has no place"),
                (plan().replace("by digger;", "by digger; takes 2 h;"), "no takes beside dig")):
            self.assertIn(expected, self.mistakes(text), text)


if __name__ == "__main__":
    unittest.main()
