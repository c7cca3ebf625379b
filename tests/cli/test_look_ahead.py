"""Machines that look at what others are foreseen to sweep and plan round it, or stop, or are only watched."""

import os
import unittest

from result_case import ResultCase, rubicon

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCENE = os.path.join(ROOT, "taskplans", "laew.plan")
CARTS = """plan p { robot a "cart.robot"; robot b "cart.robot" { start x 9; } workspaces { of a, b; %s } task go_a { by a; go x 1; } }"""
CART = """robot cart { time_step 1; body cart { param x step(1) speed(2 m/s); frame trans(x, 0, 0); shape box(-0.5, -0.4, 0.1, 0.5, 0.4, 0.5); }
  tool cart; behaviour "cart.motion"; }
"""


class LookAhead(ResultCase):
    def scene(self, *settings):
        with open(SCENE, encoding="utf-8") as file:
            text = file.read().replace("../robots", os.path.join(ROOT, "robots"))
        options = [option for setting in settings for option in ("--set", setting)]
        _, tasks = self.run_plan(text, 0, options)
        return [tasks[name]["workspaces"] for name in ("dig_1", "dig_2")]

    def test_who_comes_second_goes_round(self):
        first, second = self.scene()
        self.assertEqual((first["foreseen"], first["stops"], second["stops"]), (0, 0, 0))
        self.assertGreaterEqual(second["rounds"], 3)
        self.assertIn("went round", self.run_result.stdout)
        for change, text in (
                (lambda result: self.first(result).update(points=[x + 0.1 for x in self.first(result)["points"]]), "that are foreseen"),
                (lambda result: self.first(result).update(seconds=2), "is foreseen for 2 s instead of 2.3 s"),
                (lambda result: self.first(result).update(machine="excavator_2"), "does not go first"),
                (lambda result: result.header["workspaces"].update(of=["excavator_2", "excavator_1"]), "does not go first"),
                (lambda result: self.straight(result), "the way round of excavator_2 meets what is foreseen"),
                (lambda result: result.schedule["tasks"][1]["workspaces"].update(rounds=1), "went round 1 times")):
            self.assertIn(text, self.faults_of(change))

    @staticmethod
    def first(result):
        return result.records[result.places("foreseen")[0]]

    @staticmethod
    def straight(result):
        """The ways that were planned round it go straight to their goals."""
        size = len(result.records[result.places("try")[0]]["q"])
        for at in result.places("foreseen"):
            way = next(record for record in result.records[at:] if record["type"] == "guide")["way"]
            count = len(way) // size - 1
            ends = list(zip(way[:size], way[-size:]))
            way[size:-size] = [a + (b - a) * k / count for k in range(1, count) for a, b in ends]

    def test_the_other_way_round(self):
        first, second = self.scene("leader=2")
        self.assertEqual(second["foreseen"], 0)
        self.assertGreaterEqual(first["rounds"], 3)

    def test_without(self):
        first, second = self.scene("guard=1")
        self.assertGreaterEqual(first["stops"] + second["stops"], 2)
        self.assertNotIn("foreseen", first)
        first, second = self.scene("guard=0")
        self.assertGreaterEqual(first["overlaps"] + second["overlaps"], 4)

    def test_mistakes(self):
        self.write("cart.robot", CART)
        self.write("cart.motion", "chain { move_to(x, goal(x)) };\n")
        for clauses, expected in (
                ("risk 0.5;", "risk is of what is foreseen, and nothing is"),
                ("watch; watch;", "watch is given twice"),
                ("look_ahead 2 s; look_ahead 2 s;", "look_ahead is given twice"),
                ("look_ahead 0 s;", "look_ahead"),
                ("look_ahead 1e9 s;", "look_ahead"),
                ("look_ahead 2 s; risk 0;", "risk"),
                ("look_ahead 2 s; risk 1e9;", "risk"),
                ("watch 3;", "expected"),
                ("lookahead 2 s;", "unknown item 'lookahead' in this workspaces")):
            run = rubicon("check", self.write("p.plan", CARTS % clauses))
            self.assertEqual(run.returncode, 2, clauses + run.stdout + run.stderr)
            self.assertIn(expected, run.stderr + run.stdout, clauses)
        self.run_plan(CARTS % "look_ahead 60 s; risk 0.01;")


if __name__ == "__main__":
    unittest.main()
