"""The shipped residential building: forty units from one module, each element on what was built before it."""

import collections
import os
import tempfile
import time
import unittest

import replay
import scene_support as scene
import test_shipped_plans as shipped
import upright

PLAN = os.path.join(scene.ROOT, "taskplans", "residential.plan")

WIDTH = 0.02
"""m: what rests on another does so over more than this in every direction: no element hangs on an edge."""

GIVEN_SECONDS = 60
"""What a run may take, by the issue, on the machine of the project."""


class Residential(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            begin = time.monotonic()
            cls.outcome = scene.Run(PLAN, folder)
            cls.seconds = time.monotonic() - begin
        cls.contact = cls.outcome.header["contact"]
        cls.solids = {
            component["name"]: [upright.Solid(shape) for shape in component["shapes"]]
            for component in cls.outcome.header["components"]
        }
        cls.ground = [upright.Solid(shape).at(upright.trans(0, 0, 0)) for shape in cls.outcome.header["site"]]
        cls.first = {component["name"]: component["pose"] for component in cls.outcome.header["components"]}
        cls.last = cls.outcome.final_poses()

    def placed(self, poses):
        """The solids of each component in the world."""
        return {
            name: [solid.at(upright.frame_of(poses[name])) for solid in solids] for name, solids in self.solids.items()
        }

    def floating(self, poses):
        """Components that rest on nothing."""
        tops = collections.defaultdict(list)  # by height in cm
        placed = self.placed(poses)
        for name, solids in [("site", self.ground), *placed.items()]:
            for solid in solids:
                tops[round(solid.z1 * 100)].append((name, solid))
        result = []
        for name, solids in placed.items():
            lowest = min(solid.z0 for solid in solids)
            feet = [solid for solid in solids if solid.z0 <= lowest + self.contact]
            if not any(self.rests(name, foot, tops) for foot in feet):
                result.append(name)
        return result

    def rests(self, name, foot, tops):
        level = round(foot.z0 * 100)
        near = tops[level - 1] + tops[level] + tops[level + 1]
        return any(upright.stands_on(foot, top, self.contact, WIDTH) for other, top in near if other != name)

    def overlapping(self, poses):
        """Pairs of components that are in each other."""
        placed = sorted(
            ((solid.frame.x - solid.reach, name, solid) for name, solids in self.placed(poses).items() for solid in solids),
            key=lambda each: each[0],
        )
        result, open_solids = set(), []
        for left, name, solid in placed:
            open_solids = [each for each in open_solids if each[1].frame.x + each[1].reach > left]
            for other, met in open_solids:
                if other != name and upright.overlap(solid, met, self.contact):
                    result.add((other, name))
            open_solids.append((name, solid))
        return result

    def test_no_task_is_refused(self):
        self.assertEqual(self.outcome.exit_code, 0, self.outcome.stderr)
        self.assertEqual(self.outcome.results("done"), list(self.outcome.tasks))
        self.assertEqual(self.outcome.stderr, "")

    def test_it_has_five_storeys_of_eight_units(self):
        places = {name.split(".")[0] for name in self.solids if name.startswith("u_")}
        self.assertEqual(places, {f"u_{storey}_{unit}" for storey in range(1, 6) for unit in range(1, 9)})
        parts = collections.Counter(name.split(".")[1] for name in self.solids if name.startswith("u_"))
        self.assertEqual(set(parts.values()), {40})
        for storey in range(1, 6):
            heights = {round(self.last[f"u_{storey}_{unit}.south_1"][11], 6) for unit in range(1, 9)}
            self.assertEqual(heights, {round(2.8 * (storey - 1), 6)})

    def test_every_element_ends_where_its_task_puts_it(self):
        wanted = {task["move"]: task["to"] for task in self.outcome.header["tasks"] if task.get("move")}
        self.assertEqual(sorted(wanted), sorted(self.solids))
        lifts = {task["move"]: task["to"] for task in self.outcome.header["tasks"] if task["name"].startswith("lift_")}
        for component, pose in {**wanted, **lifts}.items():
            self.assertLess(scene.position_error(self.last[component], pose), 1e-6, component)
            self.assertLess(scene.turn_error(self.last[component], pose), 1e-6, component)

    def test_every_element_rests_on_something_in_the_yard_and_in_the_building(self):
        self.assertEqual(self.floating(self.first), [])
        self.assertEqual(self.floating(self.last), [])

    def test_one_that_floats_or_is_in_another_is_found(self):
        slab = "u_5_1.slab_1"  # nothing stands on it
        for lift, floats, overlaps in ((0.002, True, False), (-0.002, True, True), (0, False, False)):
            poses = dict(self.last)
            poses[slab] = scene.multiply(scene.translation(0, 0, lift), poses[slab])
            self.assertEqual(slab in self.floating(poses), floats, lift)
            self.assertEqual(any(slab in pair for pair in self.overlapping(poses)), overlaps, lift)

    def test_each_upper_storey_rests_on_the_one_below(self):
        """Every wall stands on slabs of the unit below it or of its neighbour, not on anything else."""
        placed = self.placed(self.last)
        for storey in range(2, 6):
            below = [
                solid
                for name, solids in placed.items()
                if name.startswith((f"u_{storey - 1}_", f"g_{storey - 1}."))
                for solid in solids
            ]
            for unit in range(1, 9):
                for part in ("south_1", "north_2", "middle_1", "party_1", "party_2", "stair"):
                    feet = placed[f"u_{storey}_{unit}.{part}"]
                    stands = any(upright.stands_on(foot, top, self.contact, WIDTH) for foot in feet for top in below)
                    self.assertTrue(stands, f"u_{storey}_{unit}.{part}")

    def test_no_element_is_in_another(self):
        self.assertEqual(self.overlapping(self.first), set())
        self.assertEqual(self.overlapping(self.last), set())

    def test_pallets_come_by_tow_motor_and_then_by_crane(self):
        ways = collections.defaultdict(list)
        for record in self.outcome.of_type("attach"):
            ways[record["component"]].append(record["robot"])
        pallets = [name for name in self.solids if name.endswith(".pallet")]
        self.assertEqual(len(pallets), 40)
        for name in pallets:
            self.assertEqual(ways[name], ["tow_motor", "crane"])

    def test_the_crane_is_never_in_the_tow_motor(self):
        machines = replay.Replay(self.outcome)
        self.assertEqual(next(machines.overlaps("tow_motor", ["crane"]), None), None)

    def test_its_process_time_is_the_one_in_the_readme(self):
        self.assertEqual(round(self.outcome.process_time), shipped.promised_times()["residential"])

    def test_it_runs_in_the_time_given(self):
        print(f"\nresidential.plan with its whole trace: {self.seconds:.1f} s")
        self.assertLess(self.seconds, GIVEN_SECONDS)


if __name__ == "__main__":
    unittest.main(verbosity=2)
