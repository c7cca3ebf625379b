"""The pictures and the tables of docs/travel.md are what taskplans/draw_ways.py, draw_figures.py and cross_yard.py make of the results of
this program."""

import importlib
import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "..", "..")
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(ROOT, "taskplans"))
draw = importlib.import_module("draw_ways")
figures = importlib.import_module("draw_figures")
yard = importlib.import_module("cross_yard")


def read(*path):
    with open(os.path.join(ROOT, *path), encoding="utf-8") as file:
        return file.read()


class Ways(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rubicon = os.environ["RUBICON"]
        cls.data = draw.exact(cls.rubicon)

    def test_the_picture_is_drawn_from_these_results(self):
        self.assertEqual(draw.draw(self.data), read("docs", "pictures", "ways.svg"))

    def test_the_table_holds_these_results(self):
        text = read("docs", "travel.md")
        for line in draw.table(self.data, self.rubicon):
            self.assertIn(line + "\n", text)

    def test_a_way_is_as_long_as_it_says_and_goes_through_nothing(self):
        for method in self.data["methods"]:
            way = method["way"]
            length = sum(((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2) ** 0.5 for a, b in zip(way, way[1:]))
            self.assertAlmostEqual(length, method["length"], delta=1e-6 * method["length"], msg=method["method"])
            for name, (x0, y0, x1, y1) in draw.boxes():
                inside = [p for p in way if x0 < p[0] < x1 and y0 < p[1] < y1]
                self.assertEqual(inside, [], f"{method['method']} in {name}")

    def test_stretches_are_the_way(self):
        for method in self.data["methods"]:
            if method["verdict"] == "limit":
                continue
            joined = []
            for _, points in draw.stretches(method):
                joined += points if not joined else points[1:]
            self.assertEqual([tuple(p) for p in method["way"]], joined, method["method"])


class Figures(unittest.TestCase):
    def test_the_picture_is_drawn_from_these_results(self):
        self.assertEqual(figures.draw(os.environ["RUBICON"]), read("docs", "pictures", "ace_figures.svg"))


class BusyYard(unittest.TestCase):
    def test_the_table_holds_these_results(self):
        text = read("docs", "travel.md")
        for line in yard.table(os.environ["RUBICON"]):
            self.assertIn(line + "\n", text)

    def test_what_each_guide_leads_is_verified(self):
        for way, guide in enumerate(yard.GUIDES, 1):
            with self.subTest(guide), tempfile.TemporaryDirectory() as out:
                told = subprocess.run([os.environ["RUBICON"], "run", yard.PLAN, "--set", f"way={way}", "--out", out], capture_output=True, text=True, check=False)
                self.assertIn(told.returncode, (0, 1), told.stderr)
                verdict = subprocess.run([os.environ["RUBICON"], "verify", out], capture_output=True, text=True, check=False)
                self.assertEqual(verdict.returncode, 0, verdict.stdout)


if __name__ == "__main__":
    unittest.main()
