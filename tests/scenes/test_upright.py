"""The independent look at machines must itself find what it looks for."""

import types
import unittest

import replay
import upright

HERE = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]


def box(x0, y0, z0, x1, y1, z1):
    return upright.Solid({"type": "box", "lower": [x0, y0, z0], "upper": [x1, y1, z1], "pose": HERE})


def cylinder(radius, z0, z1):
    return upright.Solid({"type": "cylinder", "radius": radius, "z0": z0, "z1": z1, "pose": HERE})


class Overlap(unittest.TestCase):
    def both_ways(self, a, b):
        one, other = upright.overlap(a, b, 0.001), upright.overlap(b, a, 0.001)
        self.assertEqual(one, other)
        return one

    def test_boxes_side_by_side(self):
        cube = box(-1, -1, 0, 1, 1, 2)
        still = cube.at(upright.trans(0, 0, 0))
        self.assertFalse(self.both_ways(still, cube.at(upright.trans(2, 0, 0))))
        self.assertTrue(self.both_ways(still, cube.at(upright.trans(1.99, 0, 0))))
        self.assertFalse(self.both_ways(still, cube.at(upright.trans(0, 0, 2))))
        self.assertTrue(self.both_ways(still, cube.at(upright.trans(0, 0, 1.99))))

    def test_a_turned_box_reaches_farther(self):
        cube = box(-1, -1, 0, 1, 1, 2)
        still = cube.at(upright.trans(0, 0, 0))
        turned = upright.trans(2.2, 0, 0) * upright.rotz(45)
        self.assertTrue(self.both_ways(still, cube.at(turned)))
        self.assertFalse(self.both_ways(still, cube.at(upright.trans(2.42, 0, 0) * upright.rotz(45))))
        # corner against corner: the boxes around them overlap, they do not
        self.assertFalse(self.both_ways(cube.at(upright.rotz(45)), cube.at(upright.trans(1.5, 1.5, 0) * upright.rotz(45))))

    def test_a_cylinder_before_a_corner(self):
        corner = box(-1, -1, 0, 1, 1, 2).at(upright.trans(0, 0, 0))
        self.assertFalse(self.both_ways(corner, cylinder(1, 0, 2).at(upright.trans(1.71, 1.71, 0))))
        self.assertTrue(self.both_ways(corner, cylinder(1, 0, 2).at(upright.trans(1.70, 1.70, 0))))
        self.assertFalse(self.both_ways(cylinder(1, 0, 2).at(upright.trans(0, 0, 0)), cylinder(1, 0, 2).at(upright.trans(1.5, 1.33, 0))))

    def test_what_stands_on_what(self):
        slab, post = box(-2, -2, -0.2, 2, 2, 0), box(-0.1, -0.1, 0, 0.1, 0.1, 3)
        top = slab.at(upright.trans(0, 0, 0))
        self.assertTrue(upright.stands_on(post.at(upright.trans(1, 1, 0)), top, 0.001, 0.02))
        self.assertFalse(upright.stands_on(post.at(upright.trans(1, 1, 0.002)), top, 0.001, 0.02))
        self.assertFalse(upright.stands_on(post.at(upright.trans(2.09, 0, 0)), top, 0.001, 0.02))

    def test_leaning_poses_are_refused(self):
        with self.assertRaises(ValueError):
            upright.frame_of([1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0])


class Meeting(unittest.TestCase):
    """Two cars on crossing rails, as a trace would tell of them."""

    def run_of(self, second_begins, zone_until):
        body = {"name": "car", "parent": None, "shapes": [{"type": "box", "lower": [-1, -1, 0], "upper": [1, 1, 1], "pose": HERE}]}
        robots = [
            {
                "name": name,
                "pose": HERE,
                "start": {"car.x": -10},
                "tool": {"body": "car", "frame": "trans(0, 0, 0)"},
                "parameters": [{"name": "car.x", "cyclic": False}],
                "bodies": [{**body, "frame": frame}],
            }
            for name, frame in (("a", "trans(car.x, 0, 0)"), ("b", "rotz(90) * trans(car.x, 0, 0)"))
        ]
        zone = {"type": "box", "lower": [4, -1, 0], "upper": [6, 1, 1], "pose": HERE}
        tasks = [{"name": "people", "robot": None, "zones": [zone], "zones_overhead": [zone]}]
        records = [{"type": "task_start", "task": "people", "robot": "", "t": 0}]
        for robot, begin in (("a", 0), ("b", second_begins)):
            records.append({"type": "task_start", "task": robot, "robot": robot, "t": begin})
            records.append({"type": "try", "task": robot, "robot": robot, "ok": True, "t": begin + 20, "q": {"car.x": 10}})
        records.append({"type": "task_end", "task": "people", "robot": "", "t": zone_until})
        header = {"contact": 0.001, "components": [], "robots": robots, "tasks": tasks}
        return replay.Replay(types.SimpleNamespace(header=header, records=records))

    def test_cars_at_the_crossing_at_one_time_are_found(self):
        self.assertIsNotNone(next(self.run_of(0, 0).overlaps("a", ["b"]), None))
        self.assertIsNone(next(self.run_of(4, 0).overlaps("a", ["b"]), None))

    def test_a_car_among_people_is_found(self):
        self.assertIsNotNone(next(self.run_of(4, 15).intrusions(), None))
        self.assertIsNone(next(self.run_of(4, 12).intrusions(), None))


if __name__ == "__main__":
    unittest.main(verbosity=2)
