"""Networks that are explored without a map, by the rules of Tarry and Fraenkel; verify has to find what is changed."""

import json
import os
import unittest

from result_case import ResultCase, rubicon

PLAN = """plan p {{
  network yard {{
    policy {policy};
    class road {{ speed 2 m/s; }}
    node a at trans(0, 0, 0); node b at trans(10, 0, 0); node c at trans(10, 10, 0); node d at trans(0, 10, 0);
    node island at trans(99, 0, 0);
    lane a to b; lane b to c both; lane c to d; lane d to a; lane a to c length 20 m;
    {parts}
  }}
}}
"""


class ExploreTest(ResultCase):
    def plan(self, policy, parts="explore r from a; explore slow from c { speed 1 m/s; }"):
        return self.write("p.plan", PLAN.format(policy=policy, parts=parts))

    def walks(self, policy):
        done = rubicon("run", self.plan(policy), "--format", "json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_each_way_once_in_each_direction(self):
        result = self.walks("tarry")
        for robot in result["robots"]:
            used = []
            at = robot["from"]
            for step in robot["steps"]:
                used.append((at, step["to"]))
                at = step["to"]
            self.assertEqual(at, robot["from"])
            self.assertEqual(len(used), 10)
            self.assertEqual(sorted(used), sorted({(b, a) for a, b in used}))
            self.assertEqual(robot["unseen"], [4])
            self.assertEqual(robot["length"], 120)
        # 120 m at 2 m/s, and at 1 m/s.
        self.assertEqual([robot["steps"][-1]["arrival_ns"] for robot in result["robots"]], [60e9, 120e9])

    def test_no_way_more_than_twice(self):
        result = self.walks("fraenkel")
        for robot in result["robots"]:
            times = [0] * 5
            for step in robot["steps"]:
                times[step["way"]] += 1
            self.assertTrue(all(1 <= count <= 2 for count in times), times)
            self.assertEqual(robot["steps"][-1]["to"], robot["from"])
            self.assertLess(len(robot["steps"]), 10)

    def test_table_and_folder(self):
        plan = self.plan("tarry", "explore r from a;")
        out = os.path.join(self.folder, "out")
        done = rubicon("run", plan, "--out", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("5 nodes, 5 ways between them; explored without a map by the rule of Tarry", done.stdout)
        self.assertIn("a b c d a", done.stdout)
        self.assertIn("island", done.stdout)
        self.assertEqual(sorted(os.listdir(out)), ["walk.csv", "walk.json"])
        self.assertIn("verified: 1 robots, 10 steps", rubicon("verify", out).stdout)
        with open(os.path.join(out, "walk.csv")) as file:
            self.assertEqual(file.read().splitlines()[:2], ["robot,step,from,to,way,arrival_s", "r,1,a,b,0,5"])

    def test_verify_finds_what_was_changed(self):
        good = json.dumps(self.walks("tarry"))
        path = os.path.join(self.folder, "walk.json")

        def jump(result):
            del result["robots"][0]["steps"][4]

        def ends_elsewhere(result):
            result["robots"][0]["steps"].pop()

        def again(result):
            steps = result["robots"][0]["steps"]
            end = steps[-1]
            for to in (1, 0):
                steps.append({"way": 0, "to": to, "arrival_ns": end["arrival_ns"] + 5_000_000_000 * (2 - to)})

        def early(result):
            result["robots"][1]["steps"][3]["arrival_ns"] -= 1_000

        def shorter(result):
            result["robots"][1]["length"] = 100

        def another_way(result):
            result["lanes"].append({"from": 3, "to": 1, "length": 5, "speed": 1})

        def seen(result):
            result["robots"][0]["unseen"] = []

        for change, message in [
            (jump, "by a way that does not lead there"),
            (ends_elsewhere, "does not come back to a"),
            (again, "not once in each direction"),
            (early, "is not at"),
            (shorter, "the sums of slow"),
            (another_way, "the ways are not those that lanes make"),
            (seen, "the sums of r"),
        ]:
            result = json.loads(good)
            change(result)
            self.write("walk.json", json.dumps(result))
            done = rubicon("verify", path)
            self.assertEqual(done.returncode, 1, change.__name__ + done.stdout + done.stderr)
            self.assertIn(message, done.stdout, change.__name__)
        self.write("walk.json", good[:200])
        self.assertEqual(rubicon("verify", path).returncode, 2)

    def test_wrong_plans(self):
        for policy, parts, message in [
            ("tarry", "explore r from gaet; node gate at trans(5, 5, 0);", "unknown node 'gaet' of network 'yard'; did you mean gate?"),
            ("tarry", "explore r from a; explore r from b;", "explore 'r' is declared twice"),
            ("tarry", "explore r from a { priority 3; }", "has a speed only, found 'priority'"),
            ("tarry", "explore r from a { speed 3 s; }", "needs a speed"),
            ("tarry", "errand r from a to b at 0 s;", "errand goes with policy charts"),
            ("charts", "explore r from a;", "explore goes with policy tarry or fraenkel"),
            ("order", "explore r from a;", "explore goes with policy tarry or fraenkel"),
            ("tary", "", "unknown policy 'tary'"),
            ("tarry { seed 3; }", "", "policy tarry has no numbers, found 'seed'"),
        ]:
            text = self.plan(policy, parts)
            if policy.endswith("}"):
                with open(text) as file:
                    self.write("p.plan", file.read().replace("};", "}"))
            done = rubicon("check", text)
            self.assertEqual(done.returncode, 2, message + done.stdout)
            self.assertIn(message, done.stderr)
        done = rubicon("run", self.plan("fraenkel", ""))
        self.assertEqual(done.returncode, 0)
        self.assertIn("nobody explores network 'yard'", done.stderr)
        self.assertIn("has no tasks", rubicon("flow", self.plan("tarry")).stderr)


if __name__ == "__main__":
    unittest.main()
