"""The three representations of the planar arm reach what geometry says they reach (1995 paper, Figure 5)."""

import importlib.util
import math
import os
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
SCRIPT = os.path.join(HERE, "..", "..", "robots", "planar_arm", "draw_workspaces.py")
spec = importlib.util.spec_from_file_location("draw_workspaces", SCRIPT)
draw = importlib.util.module_from_spec(spec)
spec.loader.exec_module(draw)


class Workspaces(unittest.TestCase):
    def reached(self, kind):
        return draw.reached(os.environ["RUBICON"], kind)

    def test_the_arm_reaches_a_ring(self):
        self.assertEqual(self.reached("exact"), {p for p in draw.GRID if 1 - 1e-6 <= math.hypot(*p) <= 5 + 1e-6})

    def test_the_rectangle(self):
        self.assertEqual(self.reached("rectangular"), {p for p in draw.GRID if max(map(abs, p)) <= 4.431})

    def test_polar_coordinates_reach_a_disc(self):
        self.assertEqual(self.reached("polar"), {p for p in draw.GRID if math.hypot(*p) <= 5 + 1e-6})


if __name__ == "__main__":
    unittest.main()
