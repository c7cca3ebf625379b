"""The shipped plans with several machines and with people: each runs through, machines really meet, and at no moment is one
in another or in a zone of people, as an independent calculation from the trace says."""

import json
import math
import os
import re
import tempfile
import unittest

import replay
import scene_support as scene

PLANS = os.path.join(scene.ROOT, "taskplans")

PLACED = 2e-6
"""m: a tow motor is at its goal when its way and its heading each are to a millionth of a step."""


def read(path):
    with open(path, "rb") as file:
        return file.read()


def promised_times():
    """Process time (s) of each plan as taskplans/README.md gives it."""
    rows = re.findall(r"^\| `(\w+)\.plan` \|.*\| *([\d ]+) s *\|", read(os.path.join(PLANS, "README.md")).decode(), re.M)
    return {name: int(seconds.replace(" ", "")) for name, seconds in rows}


class Shipped(unittest.TestCase):
    """What is asked of every plan; each plan below is a class of its own."""

    plan = None
    is_upright = True
    """Whether it is made of shapes that the replay knows."""

    meetings = ()
    """Who must be refused a step by whom: robot, beginning of what it met."""

    @classmethod
    def setUpClass(cls):
        if cls.plan is None:
            raise unittest.SkipTest("not a plan")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(PLANS, cls.plan + ".plan")
            cls.run_1 = scene.Run(path, folder)
            trace_1 = read(os.path.join(folder, "trace.jsonl"))
            cls.run_2 = scene.Run(path, folder)
            cls.same_trace = trace_1 == read(os.path.join(folder, "trace.jsonl"))
        cls.replay = replay.Replay(cls.run_1) if cls.is_upright else None

    def test_no_task_is_refused(self):
        self.assertEqual(self.run_1.exit_code, 0, self.run_1.stderr)
        self.assertEqual(self.run_1.results("done"), list(self.run_1.tasks))

    def test_nothing_is_said_against_it(self):
        self.assertEqual(self.run_1.stderr, "")

    def test_its_process_time_is_the_one_in_the_readme(self):
        self.assertEqual(round(self.run_1.process_time), promised_times()[self.plan])

    def test_it_gives_the_same_bytes_twice(self):
        self.assertTrue(self.same_trace)
        self.assertEqual(self.run_1.tasks, self.run_2.tasks)

    def test_machines_and_people_really_meet(self):
        hits = {(r["robot"], r["hit"][1]) for r in self.run_1.of_type("try") if "hit" in r}
        for robot, met in self.meetings:
            self.assertTrue(any(r == robot and m.startswith(met) for r, m in hits), (robot, met))

    def test_no_machine_is_ever_in_another(self):
        machines = list(self.replay.machines)
        for name in machines:
            others = [other for other in machines if other != name]
            self.assertEqual(next(self.replay.overlaps(name, others), None), None)

    def test_no_machine_is_ever_in_a_zone(self):
        self.assertEqual(next(self.replay.intrusions(), None), None)

    def test_no_load_is_ever_above_people(self):
        self.assertEqual(next(self.replay.loads_over_people(), None), None)

    def test_every_component_ends_where_its_last_task_puts_it(self):
        wanted = {task["move"]: task for task in self.run_1.header["tasks"] if task.get("move")}
        poses = self.run_1.final_poses()
        for component, task in wanted.items():
            self.assertLess(scene.position_error(poses[component], task["to"]), PLACED, component)


class ThreeTowMotors(Shipped):
    plan = "three_tow_motors"
    meetings = [
        (f"{one}_motor", f"{other}_motor.")
        for one in ("brick", "tile", "mortar")
        for other in ("brick", "tile", "mortar")
        if one != other
    ]


class PalletYard(unittest.TestCase):
    """Twenty machines are too many for the replay above; verify has its own geometry."""

    def run_with(self, motors):
        with tempfile.TemporaryDirectory() as folder:
            run = scene.rubicon("run", os.path.join(PLANS, "pallet_yard.plan"), "--set", f"motors={motors}", "--out", folder, "--format", "json")
            self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
            verified = scene.rubicon("verify", folder)
            self.assertEqual(verified.returncode, 0, verified.stdout + verified.stderr)
        return round(json.loads(run.stdout)["process_time"])

    def test_more_motors_take_less_time(self):
        self.assertEqual(self.run_with(20), promised_times()["pallet_yard"])
        for motors, seconds in {1: 12192, 2: 6409, 4: 3356, 8: 2187}.items():
            self.assertEqual(self.run_with(motors), seconds)


class Store(unittest.TestCase):
    """A hundred jobs with bodies among each other; verify has its own geometry."""

    def test_all_jobs_are_done(self):
        with tempfile.TemporaryDirectory() as folder:
            run = scene.rubicon("run", os.path.join(PLANS, "store.plan"), "--out", folder, "--format", "json")
            self.assertEqual(run.returncode, 0, run.stderr)
            schedule = json.loads(run.stdout)
            self.assertEqual(round(schedule["process_time"]), promised_times()["store"])
            self.assertEqual({task["result"] for task in schedule["tasks"]}, {"done"})
            self.assertEqual(len(schedule["tasks"]), 100)
            verified = scene.rubicon("verify", folder)
        self.assertIn("100 tasks (100 done)", verified.stdout)
        self.assertIn("no fault", verified.stdout)


class Yard(unittest.TestCase):
    """Three kinds of machines in one yard: verify has its own geometry."""

    def run_with(self, motors):
        with tempfile.TemporaryDirectory() as folder:
            run = scene.rubicon("run", os.path.join(PLANS, "yard.plan"), "--set", f"motors={motors}", "--out", folder, "--format", "json")
            self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
            verified = scene.rubicon("verify", folder)
            self.assertEqual(verified.returncode, 0, verified.stdout + verified.stderr)
            with open(os.path.join(folder, "trace.jsonl"), encoding="utf-8") as file:
                waits = {record.get("for") for record in map(json.loads, file) if record["type"] == "pause"}
        return json.loads(run.stdout), waits

    def test_two_motors_feed_the_crane(self):
        found = {motors: self.run_with(motors) for motors in (1, 2, 4)}
        times = {motors: round(schedule["process_time"]) for motors, (schedule, _) in found.items()}
        self.assertEqual(times, {1: 14616, 2: promised_times()["yard"], 4: 9286})
        # Just in time: a pallet of bricks begins its way when its place is free, and is lifted in its turn.
        tasks = {task["task"]: task for task in found[2][0]["tasks"]}
        for i in range(5, 25):
            before = tasks[f"lift_{i - 4}"]
            self.assertGreaterEqual(tasks[f"bring_{i}"]["start"], before["start"] + before["duration"] - 1e-6)


class TwoCranes(Shipped):
    plan = "two_cranes"
    meetings = [("low", "high."), ("high", "low.")]

    def test_the_higher_crane_lifts_its_load_over_the_lower_jib(self):
        tops = [r["q"]["hook.z"] for r in self.run_1.of_type("try") if r["robot"] == "high"]
        self.assertGreater(max(tops), 36)


class CraneAndTrucks(Shipped):
    plan = "crane_and_trucks"
    meetings = [
        ("truck_east", "truck_west."),
        ("truck_west", "truck_east."),
        ("truck_east", "the zone of unload_west"),
        ("truck_west", "the zone of unload_east"),
        ("tow_motor", "the zone of unload_"),
    ]

    def test_each_frame_goes_by_truck_and_then_by_crane(self):
        ways = {}
        for record in self.run_1.of_type("attach"):
            ways.setdefault(record["component"], []).append(record["robot"])
        for side in ("west", "east"):
            for number in (1, 2, 3):
                self.assertEqual(ways[f"{side}_{number}"], [f"truck_{side}", "crane"])


class PeopleBelow(Shipped):
    plan = "people_below"
    meetings = [("crane", "the zone of chimney"), ("crane", "the air above the zone of drains")]

    def test_the_crane_goes_round_and_waits(self):
        tasks = self.run_1.tasks
        work_ends = {r["task"]: r["t"] for r in self.run_1.of_type("task_end")}
        # Round: done long before the masons come down. Waits: set down where they worked, after that.
        self.assertLess(work_ends["bring_drum_4"], work_ends["chimney"])
        self.assertGreater(work_ends["bring_drum_5"], work_ends["chimney"])
        self.assertGreater(work_ends["bring_drum_1"], work_ends["drains"])
        self.assertEqual(tasks["bring_drum_5"]["result"], "done")


class BusyYard(Shipped):
    plan = "busy_yard"
    is_upright = False
    test_no_machine_is_ever_in_another = None
    test_no_machine_is_ever_in_a_zone = None
    test_no_load_is_ever_above_people = None
    test_every_component_ends_where_its_last_task_puts_it = None
    meetings = [("motor", "walker_6")]

    def test_people_stop_for_the_motor(self):
        self.assertTrue(any(r["name"].startswith("walker_") and r["by"] == "motor.truck" for r in self.run_1.of_type("moving")))


class Trench(Shipped):
    plan = "trench"
    # One machine and no zone; the replay knows frames that stay upright only.
    test_no_machine_is_ever_in_another = None
    test_no_machine_is_ever_in_a_zone = None
    test_no_load_is_ever_above_people = None

    def test_the_full_bucket_stays_level(self):
        steps = [r["q"] for r in self.run_1.of_type("try") if r["task"].startswith("to_truck")]
        self.assertGreater(len(steps), 50)
        for q in steps:
            self.assertAlmostEqual(q["boom.phi"] + q["stick.phi"] + q["bucket.phi"], 265, delta=2 + 1e-5)

    def test_nothing_is_refused_on_a_way_that_was_found(self):
        self.assertTrue(all(r["ok"] for r in self.run_1.of_type("try")))


class Pour(Shipped):
    plan = "pour"
    is_upright = False
    test_every_component_ends_where_its_last_task_puts_it = None
    test_no_machine_is_ever_in_another = None
    test_no_machine_is_ever_in_a_zone = None
    test_no_load_is_ever_above_people = None

    def test_it_takes_as_long_as_the_concrete_comes(self):
        pour = self.run_1.tasks["pour"]
        cover = pour["cover"]
        self.assertAlmostEqual(cover["covered"], 1, 6)
        # 28.8 x 12 m less the stair, 4 x 2.4 m, and six columns of 0.4 m; 0.3 m of it; 45 m3 an hour.
        self.assertAlmostEqual(cover["covered_area"], 28.8 * 12 - 4 * 2.4 - 6 * 0.16, 2)
        self.assertGreater(pour["duration"], cover["volume"] / 45 * 3600)
        self.assertLess(pour["duration"], cover["length"] * 0.3 / 45 * 3600)


class Facade(Shipped):
    plan = "facade"
    is_upright = False
    test_every_component_ends_where_its_last_task_puts_it = None
    test_no_machine_is_ever_in_another = None
    test_no_machine_is_ever_in_a_zone = None
    test_no_load_is_ever_above_people = None

    def test_the_wall_is_painted_up_to_the_windows(self):
        for name in ("paint_1", "paint_2"):
            coat = self.run_1.tasks[name]
            # 24 x 18 m less thirty windows of 1.4 x 1.5 m with their sills.
            self.assertAlmostEqual(coat["cover"]["covered_area"], 24 * 18 - 30 * 1.4 * 1.56, delta=0.5)
            self.assertGreater(coat["cover"]["covered"], 0.999)
            self.assertGreater(coat["motion"], coat["cover"]["covered_area"] / 120 * 3600)
        # Where it works the gun, 0.2 m wide to each side of its point, is over no window.
        works = {task["name"]: task["cover"]["working"] for task in self.run_1.header["tasks"] if "cover" in task}
        goals, looked = {}, 0
        for record in self.run_1.records:
            if record["type"] == "goal":
                goals[record["task"]] = record["k"] - 1
            if record["type"] != "try" or not works[record["task"]][goals[record["task"]]]:
                continue
            x, z = record["q"]["base.x"] + record["q"]["effector.x"], 20 + record["q"]["z"]
            looked += 1
            for i in range(1, 7):
                for k in range(1, 6):
                    low = 3.6 * k - 1.66
                    self.assertFalse(abs(x - (4 * i - 2)) < 0.899 and low - 0.199 < z < low + 1.759, (x, z))
        self.assertGreater(looked, 2000)


class FoundationPit(Shipped):
    plan = "foundation_pit"
    is_upright = False
    test_no_machine_is_ever_in_another = None
    test_no_machine_is_ever_in_a_zone = None
    test_no_load_is_ever_above_people = None

    def test_the_volume_is_that_of_the_pit_with_its_slopes(self):
        heights = [[float(each) for each in line.split(",")]
                   for line in read(os.path.join(PLANS, "foundation_pit.csv")).decode().splitlines() if not line.startswith("#")]
        volume = 0
        for row, line in enumerate(reversed(heights)):
            for column, height in enumerate(line):
                x, y = -8 + 0.5 * (column + 0.5), -6 + 0.5 * (row + 0.5)
                off = math.hypot(max(12 - x, x - 36, 0), max(4 - y, y - 18, 0))
                volume += 0.25 * max(height - (-1.4 + off * math.tan(math.radians(60))), 0)
        dig = self.run_1.tasks["dig_pit"]["dig"]
        self.assertAlmostEqual(dig["volume"], volume, delta=0.1)  # heights are whole mm
        self.assertEqual(dig["tipped"], dig["volume"])
        self.assertEqual(dig["loads"], math.ceil(dig["volume"] / 10))

    def test_no_footing_goes_before_the_soil(self):
        dug = self.run_1.tasks["dig_pit"]["start"] + self.run_1.tasks["dig_pit"]["duration"]
        for name, task in self.run_1.tasks.items():
            if name.startswith("set_"):
                self.assertGreaterEqual(task["start"], dug, name)


class TrenchDug(Shipped):
    plan = "trench_dug"
    test_no_machine_is_ever_in_another = None
    test_no_machine_is_ever_in_a_zone = None
    test_no_load_is_ever_above_people = None

    def test_all_of_the_trench_is_in_its_buckets(self):
        dig = self.run_1.tasks["dig_trench"]["motion_dig"]
        soils = self.run_1.of_type("soil")
        # 3.8 x 1.2 x 2 m in the ground, in whole mm3
        self.assertEqual(sum(soil["volume"] for soil in soils), 3800 * 1200 * 2000)
        self.assertAlmostEqual(dig["dug"], 9.12, 9)
        self.assertLess(dig["buckets"], 9.12 / 0.76 + 8)

    def test_each_cell_ends_at_the_bottom(self):
        heights = {}
        for soil in self.run_1.of_type("soil"):
            for cell, height in zip(soil["cells"], soil["heights"]):
                self.assertLess(height, heights.get(cell, 0))
                heights[cell] = height
        self.assertEqual(len(heights), 19 * 6)
        self.assertEqual(set(heights.values()), {-2000})


class Hauled(Shipped):
    """Trucks with bodies: what is dug is tipped, and lies in heaps."""

    test_no_machine_is_ever_in_another = None
    test_no_machine_is_ever_in_a_zone = None
    test_no_load_is_ever_above_people = None

    def test_all_that_is_dug_is_tipped(self):
        soils = self.run_1.of_type("soil")
        hauls = {name for name, task in self.run_1.tasks.items() if "haul" in task}
        dug = sum(soil["volume"] for soil in soils if soil["task"] not in hauls)
        self.assertGreater(dug, 0)
        self.assertEqual(sum(soil["volume"] for soil in soils if soil["task"] in hauls and soil["volume"] > 0), dug)
        self.assertEqual(sum(soil["volume"] for soil in soils if soil["task"] in hauls and soil["volume"] < 0), -dug)

    def test_the_heap_holds_the_loose_soil(self):
        heights = {}
        for soil in self.run_1.of_type("soil"):
            if soil["component"] == "tip.heap":
                heights.update(zip(soil["cells"], soil["heights"]))
        dug = sum(soil["volume"] for soil in self.run_1.of_type("soil") if soil["volume"] > 0 and "haul" not in self.run_1.tasks[soil["task"]])
        self.assertAlmostEqual(sum(heights.values()) * 500 * 500 / (1.25 * dug), 1, 4)


class TrenchHauled(Hauled):
    plan = "trench_hauled"


class Pit(Hauled):
    plan = "pit"


class Dew(Shipped):
    plan = "dew"
    test_no_machine_is_ever_in_another = None
    test_no_machine_is_ever_in_a_zone = None
    test_no_load_is_ever_above_people = None

    def test_the_empty_truck_stops_and_both_go_on(self):
        tries = [r for r in self.run_1.of_type("try") if not r["ok"] and r["reason"] == "hit"]
        stopped = [r for r in tries if r["task"] == "back"]
        self.assertEqual({tuple(r["hit"]) for r in stopped}, {("the workspace of lorry_2", "the workspace of lorry_1")})
        self.assertGreater(self.run_1.tasks["back"]["duration"], 25)
        # the loaded one stops for the surveyor only
        self.assertEqual({tuple(r["hit"]) for r in tries if r["task"] == "out"}, {("the workspace of lorry_1", "surveyor")})


class LoadingSettings(Shipped):
    plan = "loading_settings"
    test_no_machine_is_ever_in_another = None
    test_no_machine_is_ever_in_a_zone = None
    test_no_load_is_ever_above_people = None

    def test_the_truck_below_has_the_shortest_cycle(self):
        cycle = {name: task["motion_dig"]["mean"]["cycle"] for name, task in self.run_1.tasks.items()}
        self.assertLess(cycle["below"], cycle["deep"])
        self.assertLess(cycle["below"], cycle["behind"])


class Ceiling(Shipped):
    plan = "ceiling"
    is_upright = False
    test_every_component_ends_where_its_last_task_puts_it = None
    test_no_machine_is_ever_in_another = None
    test_no_machine_is_ever_in_a_zone = None
    test_no_load_is_ever_above_people = None

    def test_the_crawler_stands_while_it_drills(self):
        for number in (1, 2, 3, 4):
            steps = [r["q"] for r in self.run_1.of_type("try") if r["task"] in (f"drill_{number}", f"out_of_{number}")]
            self.assertGreater(len(steps), 4)
            self.assertEqual({q["x"] for q in steps}, {1.2 * number - 0.9})

    def test_nothing_is_refused(self):
        self.assertTrue(all(r["ok"] for r in self.run_1.of_type("try")))


if __name__ == "__main__":
    unittest.main(verbosity=2)
