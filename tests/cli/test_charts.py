"""Networks with policy charts: the worked example of the Blackmon paper as it is printed, what is said of reports, and
verify, which has to find whatever is changed in a result."""

import json
import os
import re
import unittest

from result_case import ResultCase, rubicon

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
WAREHOUSE = os.path.join(ROOT, "taskplans", "warehouse.plan")

# The charts of the paper, with its misprints mended: places and arrivals in s.
CHART_1 = {
    "ROB1": "B3 30 B3B5 70 B5 90 B5B7 130 B7 150",
    "ROB2": "B6 0 B6B8 40 B8 60 B8B10 100 B10 120",
    "ROB3": "C6C8 20 C8 40 B3B5 60 B8 80 B8B10 120 B10 140",
}
CHART_2 = {
    "ROB1": "Cur-Pos 35 B8 70 B3B5 90 B5 110 B5B7 150 B7 170",
    "ROB2": "Cur-Pos 35 B6B8 40 B8 60 B8B10 100 B10 120",
    "ROB3": "Cur-Pos 35 C8 40 B3B5 60 B8 80 B8B10 120 B10 140",
}
CHART_3 = {**CHART_2, "ROB1": "Cur-Pos 105 B8 140 B3B5 160 B5 180 B5B7 220 B7 240"}
CHART_4 = {**CHART_3, "ROB3": "Cur-Pos 35 C8 40 B3B5 145 B8 165 B8B10 205 B10 225"}
CHART_5 = {**CHART_3, "ROB3": "Cur-Pos 35 C8 40 B3B5 165 B8 185 B8B10 225 B10 245"}

# a - b - c - d in a row, 10 m each, and from b round by e to c.
YARD = """plan p {{
  network yard {{
    policy charts {{ {policy} }}
    class road {{ speed 1 m/s; width 4 m; cost 2 per m; }}
    class path {{ speed 0.5 m/s; width 4 m; cost 0.1 per m; }}
    node a at trans(0, 0, 0); node b at trans(10, 0, 0); node c at trans(20, 0, 0); node d at trans(30, 0, 0);
    node e at trans(15, 5, 0);
    lane a to b road both; lane b to c road; lane c to b road beside b to c; lane c to d road both;
    lane b to e path both; lane e to c path both;
    {parts}
  }}
}}
"""


def charts_of(text):
    """The charts that a table shows, as the paper has them: robot to places and arrivals."""
    charts = []
    for block in re.split(r"(?m)^chart \d+[,:].*\n", text)[1:]:
        lines = block.split("\n\n")[0].rstrip("\n").split("\n")
        starts = [match.start() for match in re.finditer(r"\S+ \(priority", lines[0])]
        chart = {}
        for start, end in zip(starts, starts[1:] + [None]):
            cells = [line[start:end].split() for line in lines]
            chart[cells[0][0]] = " ".join(word for cell in cells[1:] for word in cell)
        charts.append(chart)
    return charts


class ChartsTest(ResultCase):
    def path(self, name):
        return os.path.join(self.folder, name)

    def yard(self, parts, policy="tolerance 5 s; delay 5 s;"):
        return self.write("yard.plan", YARD.format(parts=parts, policy=policy))

    def ran(self, plan, *arguments, code=0):
        done = rubicon("run", plan, *arguments)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout

    def said(self, parts, policy="tolerance 5 s; delay 5 s;"):
        """What the command says of wrong input."""
        done = rubicon("check", self.yard(parts, policy))
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        return done.stderr

    def ways(self, plan, code=0):
        result = json.loads(self.ran(plan, "--format", "json", code=code))
        return {
            way["robot"]: " ".join(f"{visit['node']} {visit['arrival_ns'] / 1e9:g}" for visit in way["visits"])
            for way in result["ways"]
        }

    def test_the_worked_example_is_as_printed(self):
        text = self.ran(WAREHOUSE)
        self.assertEqual(charts_of(text), [CHART_1, CHART_2, CHART_3, CHART_4, CHART_5])
        told = [
            "35 s  ROB1 reports: an obstacle lies in B3 to B3B5, 2.25 m along",
            "B3 to B3B5 is closed to all",
            "ROB1 takes the lane beside, B8 to B8B10, against its direction",
            "ROB1 yields to ROB2 at B8: Cur-Pos at 105 s, not 35 s (lane)",
            "ROB3 yields to ROB1 at B8: B3B5 at 145 s, not 60 s (lane)",
            "ROB3 yields to ROB1 at B8: B3B5 at 165 s, not 145 s (across)",
        ]
        places = [text.find(line) for line in told]
        self.assertNotIn(-1, places)
        self.assertEqual(places, sorted(places))
        self.assertEqual(
            self.ways(WAREHOUSE)["ROB1"], "B3 30 None 35 B8 140 B3B5 160 B5 180 B5B7 220 B7 240"
        )
        self.assertEqual(rubicon("fmt", "--check", WAREHOUSE).returncode, 0)

    def test_a_folder_is_verified(self):
        out = self.path("out")
        self.ran(WAREHOUSE, "--out", out)
        self.assertEqual(sorted(os.listdir(out)), ["charts.csv", "charts.json", "charts.svg", "report.html"])
        done = rubicon("verify", out)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("verified: 3 robots, 2 plans", done.stdout)
        with open(os.path.join(out, "charts.csv")) as file:
            rows = file.read().splitlines()
        self.assertEqual(rows[0], "robot,place,arrival_s,departure_s,wait_s,lane,leg")
        self.assertIn("ROB3,C8,40,145,105,C6C8 to C8,along", rows)
        self.assertIn("ROB1,,35,105,70,B3 to B3B5,along", rows)
        with open(os.path.join(out, "charts.svg")) as file:
            picture = file.read()
        for word in ("B3B5", "ROB3 waits from 40 s to 145 s", "report, 35 s", "Closed lanes"):
            self.assertIn(word, picture)
        # ROB1 stands in a lane, drives back on the one beside, and against a third.
        with open(os.path.join(out, "charts.json")) as file:
            text = file.read()
        for visit in (1, 2, 3):
            changed = json.loads(text)
            changed["ways"][0]["visits"][visit]["lane"] = 50
            done = rubicon("verify", self.write("charts.json", json.dumps(changed)))
            self.assertIn("the way of ROB1 comes to", done.stdout + done.stderr, visit)
        # It is the one that docs/fleets.md shows.
        with open(os.path.join(ROOT, "docs", "pictures", "charts.svg")) as file:
            self.assertEqual(file.read(), picture)
        # The same bytes again.
        first = self.ran(WAREHOUSE, "--format", "json")
        self.assertEqual(first, self.ran(WAREHOUSE, "--format", "json"))

    def test_reports_are_answered(self):
        two = "errand r1 from a to d at 0 s { priority 2; width 2 m; } errand r2 from a to d at 20 s { width 2 m; }"
        self.assertEqual(
            self.ways(self.yard(two)), {"r1": "a 0 b 10 c 20 d 30", "r2": "a 20 b 30 c 40 d 50"}
        )
        # Round by e: 2 x 7.07 m at 0.5 m/s. r2 is told before it starts, takes the lane when it is free, and comes to c
        # less than 5 s after r1: so 5 s later.
        ways = self.ways(
            self.yard(two + " report lane b to c reopened at 30 s by r2; report lane b to c blocked at 10 s by r1;")
        )
        self.assertEqual(ways["r1"], "a 0 b 10 e 24.1421 c 38.2843 d 48.2843")
        self.assertEqual(ways["r2"], "a 20 b 30 c 45 d 55")
        # No room in the lane, none beside it: back.
        ways = self.ways(self.yard(two + " report lane b to c obstacle 0 m to 8 m at 14 s by r1;"))
        self.assertEqual(ways["r1"], "a 0 b 10 None 14 b 18 e 32.1421 c 46.2843 d 56.2843")
        ways = self.ways(self.yard(two + " report lane b to c obstacle 1 m to 3 m at 14 s by r1;"))
        self.assertEqual(ways["r1"], "a 0 b 10 None 14 c 20 d 30")
        # Without a way to d it returns: exit code 1.
        blocked = two + " report lane b to c blocked at 10 s by r1; report lane b to e blocked at 10 s by r1;"
        text = self.ran(self.yard(blocked), code=1)
        self.assertIn("r1 finds no way from b to its goal and returns to its start", text)
        self.assertRegex(text, r"r1 .* back at its start: no way to its goal")

    def test_robots_find_barriers(self):
        two = "errand r1 from a to d at 0 s { priority 2; } errand r2 from a to d at 20 s;"
        plan = self.yard(two + " barrier lane b to c from 5 s to 25 s;")
        text = self.ran(plan)
        told = [
            "10 s  r1 reports: b to c is blocked",
            "b to c is closed to all",
            "r1 has a new way from b",
            "r2 has a new way from a",
            "30 s  r2 reports: b to c is free again",
            "b to c is open again",
            "r2 has a new way from b",
        ]
        places = [text.find(line) for line in told]
        self.assertNotIn(-1, places)
        self.assertEqual(places, sorted(places))
        self.assertEqual(self.ways(plan)["r1"], "a 0 b 10 e 24.1421 c 38.2843 d 48.2843")
        # Who would enter it while it is there is found by verify.
        result = json.loads(self.ran(plan, "--format", "json"))
        result["barriers"][0]["until_ns"] = 36_000_000_000
        done = rubicon("verify", self.write("charts.json", json.dumps(result)))
        self.assertEqual(done.returncode, 1)
        self.assertIn("r2 enters b to c at 35 s, where a barrier stands", done.stdout)
        # For good.
        ways = self.ways(self.yard(two + " barrier lane b to c from 5 s;"))
        self.assertEqual(ways["r2"], "a 20 b 30 e 44.1421 c 58.2843 d 68.2843")
        for barrier, message in [
            ("barrier lane b to c from 5 s to 4 s;", "the barrier goes at 4 s, and comes at 5 s"),
            ("barrier lane b to d from 5 s;", "there is no lane from b to d"),
            ("barrier lane b to c at 5 s;", "'from' and when the barrier comes"),
        ]:
            self.assertIn(message, self.said(two + barrier))

    def test_the_examples_of_the_reference_run(self):
        with open(os.path.join(ROOT, "docs", "language.md"), encoding="utf-8") as file:
            blocks = re.findall(r"^```text\n(plan .*?)^```$", file.read(), re.M | re.S)
        blocks = [block for block in blocks if "policy charts" in block or "policy tarry" in block]
        self.assertEqual(len(blocks), 2)
        for block in blocks:
            plan = self.write("example.plan", block)
            self.assertEqual(rubicon("fmt", "--check", plan).returncode, 0)
            done = rubicon("run", plan, "--out", self.out)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual(rubicon("verify", self.out).returncode, 0)

    def test_least_of_what(self):
        one = "errand r from b to c at 0 s;"
        self.assertEqual(self.ways(self.yard(one, "minimise time;")), {"r": "b 0 c 10"})
        self.assertEqual(self.ways(self.yard(one, "minimise distance;")), {"r": "b 0 c 10"})
        self.assertEqual(self.ways(self.yard(one, "minimise cost;")), {"r": "b 0 e 14.1421 c 28.2843"})

    def test_names_are_counted(self):
        plan = self.write(
            "row.plan",
            """plan p {
  parameter robots = 3;
  network row {
    policy charts { tolerance 5 s; delay 5 s; }
    class road { speed 1 m/s; }
    for i from 0 to 4 { node n[i] at trans(10 * i, 0, 0); }
    for i from 0 to 3 { lane n[i] to n[i + 1]; }
    for i from 1 to robots { errand r[i] from n[0] to n[4] at (i * 2 s); }
  }
}
""",
        )
        self.assertEqual(self.ways(plan)["r_3"], "n_0 6 n_1 26 n_2 36 n_3 46 n_4 56")
        self.assertIn("4 robots", self.ran(plan, "--set", "robots=4"))

    def test_a_warehouse_of_modules(self):
        plan = os.path.join(ROOT, "taskplans", "warehouse_modules.plan")
        text = self.ran(plan, "--out", self.out)
        told = [
            "70 s  robot_3_1 reports: back_3_1 to ahead_end_2_1 is blocked",
            "robot_4_1 has a new way from back_4_1",
            "110 s  robot_2_1 reports: back_3_1 to ahead_end_2_1 is free again",
            "robot_3_1 has a new way from back_end_3_1",
        ]
        places = [text.find(line) for line in told]
        self.assertNotIn(-1, places)
        self.assertEqual(places, sorted(places))
        self.assertIn("verified: 20 robots, 3 plans", rubicon("verify", self.out).stdout)
        # 400 robots, 1,640 nodes.
        self.ran(plan, "--set", "corridors=20", "--set", "rows=20", "--out", self.out)
        self.assertIn("verified: 400 robots", rubicon("verify", self.out).stdout)
        with open(os.path.join(self.out, "charts.svg")) as file:
            self.assertIn("and 370 more, not drawn", file.read())

    def test_the_sensing_range_of_each_speed(self):
        # 1 m/s: 0.7 m until it brakes, 1^2 / (2 * 2) = 0.25 m braked; 0.5 m/s: 0.35 m and 0.0625 m; 0.5 m are left before it.
        errand = "errand r1 from a to d at 0 s;"
        stops = "braking 2 m/s2; scan 0.2 s; reaction 0.5 s; standoff 0.5 m;"
        text = self.ran(self.yard(errand, stops))
        self.assertIn("sensing range: a scan every 0.2 s, reaction 0.5 s, braking 2 m/s2, standoff 0.5 m", text)
        lines = [re.split(r"\s{2,}", line) for line in text[text.index("sensing range"):].split("\n")[1:4]]
        self.assertEqual(lines[0], ["class", "speed", "until it brakes", "brakes", "range needed", "for two scans", "oncoming"])
        self.assertEqual(lines[1], ["road", "1 m/s", "0.70 m", "0.25 m", "1.45 m", "1.65 m", "2.40 m"])
        self.assertEqual(lines[2][:6], ["path", "0.5 m/s", "0.35 m", "0.06 m", "0.91 m", "1.01 m"])
        # The quickest robot counts where all are slower than the lanes.
        needs = json.loads(self.ran(self.yard("errand r1 from a to d at 0 s { speed 0.8 m/s; }", stops), "--format", "json"))["sensing"]["needs"]
        self.assertEqual([need["speed"] for need in needs], [0.8, 0.5])
        self.assertAlmostEqual(needs[0]["to_stop"], 0.5 + 0.8 * 0.7 + 0.16, 12)
        # What a range is good for: 0.7 v + v^2 / 4 = 0.62 m at 0.7071 m/s.
        plan = self.yard(errand, stops + " sensing 1.12 m;")
        done = rubicon("run", plan, "--out", self.path("seen"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("robots cannot stop before what they see in class 'road': at 1 m/s that takes 1.45 m, and they see 1.12 m", done.stderr)
        self.assertNotIn("class 'path'", done.stderr)
        self.assertIn("with 1.12 m they can stop from 0.7071 m/s", done.stdout)
        self.assertIn("0.33 m short", done.stdout)
        with open(os.path.join(self.path("seen"), "report.html"), encoding="utf-8") as file:
            page = file.read()
        self.assertIn("0.33 m short", page)
        self.assertEqual(page.count("<svg "), 2)
        self.assertEqual(page.count("b to c, road, 10 m"), 1)
        self.assertEqual(rubicon("verify", self.path("seen")).returncode, 0)
        good = json.loads(self.ran(plan, "--format", "json"))
        for key in ("speed", "until_brakes", "braked", "to_stop", "two_scans", "oncoming"):
            wrong = json.loads(json.dumps(good))
            wrong["sensing"]["needs"][1][key] += 0.001
            self.assertEqual(rubicon("verify", self.write("charts.json", json.dumps(wrong))).returncode, 1, key)
        good["sensing"]["greatest_speed"] += 0.001
        self.assertIn("is not the most for its range", rubicon("verify", self.write("charts.json", json.dumps(good))).stdout)
        for policy, message in [
            ("scan 0.2 s;", "scan needs braking, how hard robots brake"),
            ("braking 0 m/s2;", "the braking of policy charts must be between"),
            ("braking 1 m;", "needs an acceleration"),
            ("braking 1 m/s2; scan 5;", "the scan has no unit, found 5"),
            ("braking 1 m/s2; standoff -1 m;", "the standoff of policy charts cannot be negative"),
            ("braking 1 m/s2; sensing 0 m;", "the sensing of policy charts must be between"),
            ("braking 1 m/s2; braking 2 m/s2;", "braking of policy charts is given twice"),
            ("breaking 1 m/s2;", "did you mean braking?"),
        ]:
            self.assertIn(message, self.said(errand, policy), policy)

    def test_verify_finds_what_was_changed(self):
        """Each fault is put in alone, and has to be found by name."""
        good = self.ran(WAREHOUSE, "--format", "json")
        path = self.path("charts.json")

        def stops(result, step, robot):
            return result["steps"][step]["charts"][robot]["stops"]

        def earlier(result):
            stops(result, 0, 1)[2]["arrival_ns"] -= 10_000_000_000

        def same_node(result):
            for stop in stops(result, 1, 2)[2:]:
                stop["arrival_ns"] -= 3_000_000_000
            result["steps"][1]["records"][-1]["after_ns"] -= 3_000_000_000

        def head_on(result):
            for stop in stops(result, 1, 0):
                stop["arrival_ns"] -= 70_000_000_000
            result["steps"][1]["records"] = [r for r in result["steps"][1]["records"] if r["kind"] != "yields"]

        def quicker_lane(result):
            result["classes"][2]["speed"] = 0.5

        def short_cut(result):
            names = [node["name"] for node in result["nodes"]]
            self.assertIn("B3", names)
            result["lanes"].append({"from": "B3", "to": "B7", "class": 0, "beside": None, "length": 3})

        def jump(result):
            del stops(result, 0, 0)[2]

        def closed(result):
            result["steps"][1]["closed"] = []

        def enters_closed(result):
            result["steps"][1]["closed"].append(
                next(i for i, lane in enumerate(result["lanes"]) if (lane["from"], lane["to"]) == ("B5", "B5B7"))
            )

        def elsewhere(result):
            result["steps"][1]["charts"][1]["stops"][0]["lane"] = 0

        def waits(result):
            result["ways"][2]["waiting_ns"] += 1

        def way(result):
            result["ways"][1]["visits"][2]["node"] = "B5"

        def outcome(result):
            result["outcome"] = "not_all_at_goals"

        def goal(result):
            stops(result, 0, 1).pop()

        def yields(result):
            result["ways"][2]["yields"] = 7

        def waits_for_nobody(result):
            for stop in stops(result, 0, 0)[3:]:
                stop["arrival_ns"] += 20_000_000_000

        def alone(result):
            result["ways"][0]["alone_ns"] += 5

        def another_chart(result):
            for stop in stops(result, 1, 1)[2:]:
                stop["arrival_ns"] += 60_000_000_000

        def thinner(result):
            result["steps"][1]["report"]["obstacle_to"] = 1

        def other_lane(result):
            result["ways"][1]["visits"][2]["lane"] = 0

        for change, message in [
            (other_lane, "the way of ROB2 comes to B8 by A1 to A1A3"),
            (thinner, "is said to go left_lane past the obstacle, and has room for left_in_lane"),
            (earlier, "before it can be there"),
            (same_node, "are both at B3B5 about 160 s"),
            (head_on, "head-on in B8 to B8B10"),
            (quicker_lane, "takes 36 s for"),
            (short_cut, "and the best one 1"),
            (jump, "by no lane"),
            (closed, "closed lanes are not those that were reported"),
            (enters_closed, "enters B5 to B5B7, which is closed"),
            (elsewhere, "does not begin where ROB2 is"),
            (waits, "do not add up"),
            (way, "the way of ROB2 is not that of its charts"),
            (outcome, "the outcome is said to be"),
            (goal, "not at its goal B10"),
            (yields, "is said to yield 7 times"),
            (waits_for_nobody, "yields to nobody"),
            (alone, "is said to take"),
            (another_chart, "without a cause"),
        ]:
            result = json.loads(good)
            change(result)
            self.write("charts.json", json.dumps(result))
            done = rubicon("verify", path)
            self.assertEqual(done.returncode, 1, change.__name__ + ": " + done.stdout + done.stderr)
            self.assertIn(message, done.stdout, change.__name__)
        # What is told of the step at 35 s: each of these fields follows from the charts.
        def put(value, *keys):
            def change(result):
                at = result["steps"][1]
                for key in keys[:-1]:
                    at = at[key]
                at[keys[-1]] = value

            return change

        for change, message in [
            (put("ROB2", "report", "robot"), "ROB2 reports an obstacle in B3 to B3B5, and is not there"),
            (put(3.25, "report", "travelled"), "3.25 m along its lane, and is 2.25 m along"),
            (put(6.0, "report", "gap"), "past the obstacle are 5 m, and it is said to be 6 m"),
            (put(4.0, "report", "obstacle_to"), "past the obstacle are 4 m"),
            (put(0.5, "report", "obstacle_from"), "the report tells"),
            (put("it is behind", "report", "doubt"), "ROB1 can see B3 to B3B5, and that is doubted"),
            (put("ROB2", "records", 0, "robot"), "do not begin with what the report says"),
            (put("reportedx", "records", 1, "kind"), "of the unknown kind 'reportedx'"),
            (put("nothing is closed", "records", 1, "told"), "a record tells 'nothing is closed'"),
            (put("B5", "records", 2, "node"), "do not begin with what the report says"),
            (put("ROB1", "records", 3, "to"), "there and then they do not meet so"),
            (put("B5", "records", 4, "node"), "there and then they do not meet so"),
            (put(112_000_000_000, "records", 4, "time_ns"), "there and then they do not meet so"),
            (put(40_000_000_000, "records", 2, "time_ns"), "is told of 40 s"),
            (lambda result: result["steps"][0].update(time_ns=1), "the first plan is made at 0 s"),
        ]:
            result = json.loads(good)
            change(result)
            self.write("charts.json", json.dumps(result))
            done = rubicon("verify", path)
            self.assertEqual(done.returncode, 1, message + ": " + done.stdout + done.stderr)
            self.assertIn(message, done.stdout)
        for text in ('{"format": "rubicon-charts"}', good[: len(good) // 2], good.replace('"B8"', '"B9999"', 1)):
            self.write("charts.json", text)
            self.assertEqual(rubicon("verify", path).returncode, 2)

    def test_wrong_plans(self):
        errand = "errand r1 from a to d at 0 s;"
        for parts, message in [
            (
                "node gate at trans(9, 9, 0); errand r1 from a to gaet at 0 s;",
                "unknown node 'gaet' of network 'yard'; did you mean gate?",
            ),
            ("node far at trans(99, 0, 0); errand r1 from a to far at 0 s;", "no lanes lead r1 from a to far"),
            ("errand r1 from a to d at 0 s { width 5 m; }", "no lanes lead r1 from a to d that are 5 m wide"),
            (errand + errand, "errand 'r1' is declared twice"),
            ("errand r1 from a to a at 0 s;", "errand 'r1' ends where it begins"),
            ("errand r1 from a to d at 20;", "the start of errand 'r1' has no unit, found 20"),
            ("errand r1 from a to d at 20 m;", "needs a time"),
            ("errand r1 from a to d at -1 s;", "cannot be negative"),
            ("errand r1 from a to d;", "expected 'at' and when it starts"),
            ("errand r1 from a to d at 0 s { priority 1.5; }", "is a whole number, found 1.5"),
            ("errand r1 from a to d at 0 s { prioritiy 1; }", "did you mean priority?"),
            ("errand r1 from a to d at 0 s { speed 0 m/s; }", "must be between"),
            (errand + "report lane a to c blocked at 5 s by r1;", "there is no lane from a to c"),
            (errand + "report lane a to b blocked at 5 s by r2;", "unknown robot 'r2'; did you mean r1?"),
            (errand + "report lane a to b blockt at 5 s by r1;", "did you mean blocked?"),
            (errand + "report lane a to b blocked at 5 by r1;", "the time of a report has no unit"),
            (errand + "report lane a to b blocked at 5 s by r1;", "what it finds there is an obstacle"),
            (errand + "report lane b to c reopened at 5 s by r1;", "nobody reported that it is blocked"),
            (errand + "report lane a to b obstacle 0 m to 1 m at 5 s by r1;", "how wide r1 is decides"),
            (
                "errand r1 from a to d at 0 s { width 1 m; } report lane b to c obstacle 0 m to 1 m at 5 s by r1;",
                "r1 is not in the lane b to c at 5 s: it is on its way from a to b",
            ),
            (
                "errand r1 from a to d at 0 s { width 1 m; } report lane a to b obstacle 2 m to 1 m at 5 s by r1;",
                "the obstacle ends at 1 m, before it begins at 2 m",
            ),
            ("errand r1 from a to d at 9 s; report lane a to b blocked at 5 s by r1;", "at 5 s it sees nothing"),
            ("agents 4;", "agents goes with policy grid"),
            (
                "for i from 1 to 5000 { node m[i] at trans(i, 50, 0); errand q[i] from a to b at 0 s; }",
                "5000 errands on 5005 nodes: the product is at most 20000000",
            ),
            (
                "class snail { speed 0.000001 m/s; } node far at trans(99999, 0, 0); lane d to far snail; "
                "errand r1 from a to far at 0 s;",
                "the way of r1 takes",
            ),
        ]:
            self.assertIn(message, self.said(parts), parts)
        for policy, message in [
            ("tolerance -1 s;", "the tolerance cannot be negative"),
            ("tolerance 5;", "the tolerance has no unit, found 5"),
            ("delay 0 s;", "the delay must be between"),
            ("tolerance 100000000 s;", "the tolerance must be between"),
            ("tolerence 5 s;", "did you mean tolerance?"),
            ("minimise speed;", "expected time, distance or cost, found 'speed'"),
            ("delay 5 s; delay 6 s;", "is given twice"),
        ]:
            self.assertIn(message, self.said(errand, policy), policy)
        text = YARD.format(parts=errand, policy="minimise cost;").replace("cost 0.1 per m;", "")
        self.write("yard.plan", text)
        self.assertIn("class 'path' has no cost", rubicon("run", self.path("yard.plan")).stderr)
        for more, message in [
            ("crew c;", "has this network and nothing else"),
            ("task t { takes 5 s; }", "has this network and nothing else"),
        ]:
            self.write("q.plan", YARD.format(parts=errand, policy="").rstrip().rstrip("}") + more + " }\n")
            done = rubicon("run", self.path("q.plan"))
            self.assertEqual(done.returncode, 2)
            self.assertIn(message, done.stderr)
        text = YARD.format(parts=errand, policy="").replace("policy charts {  }", "policy order;")
        self.write("q.plan", text)
        said = rubicon("check", self.path("q.plan")).stderr
        self.assertIn("errand goes with policy charts", said)
        self.assertIn("the cost of a metre goes with policy charts", said)
        plan = self.yard(errand)
        self.assertIn("a network with policy charts has no tasks", rubicon("flow", plan).stderr)
        self.assertIn("go with tasks", rubicon("run", plan, "--trace", self.path("t.jsonl")).stderr)

    def test_doubts_are_warnings(self):
        done = rubicon(
            "run",
            self.yard(
                "errand r1 from a to d at 0 s; errand r2 from a to d at 0 s; report lane b to c blocked at 5 s by r1;"
            ),
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("r1 and r2 begin at node a at the same time: one of them will start later", done.stderr)
        self.assertIn("r1 can hardly see the lane b to c at 5 s: it is on its way from a to b", done.stderr)
        done = rubicon("run", self.yard(""))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("has no errands: nothing will be done", done.stderr)


if __name__ == "__main__":
    unittest.main()
