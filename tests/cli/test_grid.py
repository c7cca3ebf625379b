"""Networks of cells: maps and scenarios become plans, their ways are judged by verify and by the walk here, which knows
the file format only; what is wrong in strangers' files is said with its place."""

import json
import os
import subprocess
import unittest

from result_case import RUBICON, ResultCase, rubicon

MAP = "type octile\nheight 3\nwidth 7\nmap\n@@@.@@@\n.......\n@@@.@@@\n"
SCEN = (
    "version 1\n"
    "0\tlane.map\t7\t3\t0\t1\t6\t1\t6\n"
    "0\tlane.map\t7\t3\t6\t1\t0\t1\t6\n"
)
PLAN = """plan p {
  network floor {
    policy grid { expansions %s; }
    map "lane.map";
    %s
  }
}
"""


class GridTest(ResultCase):
    def setUp(self):
        super().setUp()
        self.write("lane.map", MAP)
        self.write("lane.scen", SCEN)

    def path(self, name):
        return os.path.join(self.folder, name)

    def plan(self, parts, expansions="20000"):
        return self.write("p.plan", PLAN % (expansions, parts))

    def said(self, *arguments):
        """What the command says of wrong input."""
        done = rubicon(*arguments)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        return done.stderr

    def walk(self, result):
        """Where each agent is at each tick; nobody meets anybody."""
        steps = {"r": (1, 0), "l": (-1, 0), "d": (0, 1), "u": (0, -1), "w": (0, 0)}
        rows = result["map"]["rows"]
        places = [tuple(agent["from"]) for agent in result["agents"]]
        for tick in range(max(len(agent["way"]) for agent in result["agents"])):
            before = list(places)
            for i, agent in enumerate(result["agents"]):
                if tick < len(agent["way"]):
                    dx, dy = steps[agent["way"][tick]]
                    places[i] = (places[i][0] + dx, places[i][1] + dy)
                self.assertEqual(rows[places[i][1]][places[i][0]], ".")
            self.assertEqual(len(set(places)), len(places))
            moved = {(a, b) for a, b in zip(before, places) if a != b}
            self.assertFalse([move for move in moved if (move[1], move[0]) in moved])
        self.assertEqual(places, [tuple(agent["to"]) for agent in result["agents"]])

    def test_imported_runs_and_is_verified(self):
        plan = self.path("lane.plan")
        done = rubicon("import", self.path("lane.map"), self.path("lane.scen"), "--out", plan)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(plan) as file:
            text = file.read()
        self.assertIn('map "lane.map";', text)
        self.assertIn('scenario "lane.scen";', text)
        self.write("lane.plan", text.replace("10000000", "20000"))
        self.assertEqual(rubicon("check", plan).returncode, 0)
        self.assertEqual(rubicon("fmt", "--check", plan).returncode, 0)
        out = self.path("out")
        done = rubicon("run", plan, "--out", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("2 agents on 7 x 3 cells", done.stdout)
        # One of them steps aside, waits a tick, and steps back.
        self.assertIn("cost       15 ticks, summed over the agents; at least 12; ratio 1.2500", done.stdout)
        done = rubicon("verify", out)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("verified: 2 agents", done.stdout)
        with open(os.path.join(out, "ways.json")) as file:
            result = json.load(file)
        self.walk(result)
        self.assertEqual(result["cost"], 15)

    def test_same_bytes(self):
        plan = self.plan('scenario "lane.scen";')
        first = rubicon("run", plan, "--format", "json").stdout
        self.assertEqual(first, rubicon("run", plan, "--format", "json").stdout)
        self.assertTrue(first.startswith("{"))

    def test_agents_in_the_plan(self):
        plan = self.plan('scenario "lane.scen"; agents 1; agent b from (6, 1) to (5, 1);')
        result = json.loads(rubicon("run", plan, "--format", "json").stdout)
        self.assertEqual([agent["name"] for agent in result["agents"]], ["a1", "b"])
        self.walk(result)
        csv = rubicon("run", plan, "--format", "csv").stdout.splitlines()
        self.assertEqual(csv[0], "agent,from_x,from_y,to_x,to_y,shortest,cost")
        self.assertEqual(len(csv), 3)

    def test_no_solution_is_said(self):
        self.write("lane.map", "type octile\nheight 1\nwidth 4\nmap\n....\n")
        plan = self.plan("agent a from (0, 0) to (3, 0); agent b from (3, 0) to (0, 0);")
        done = rubicon("run", plan)
        self.assertEqual(done.returncode, 1)
        self.assertIn("no solution", done.stdout)
        self.assertIn("not at their goals where most were nearest to theirs: a", done.stdout)

    def test_verify_finds_what_was_changed(self):
        plan = self.plan('scenario "lane.scen";')
        good = rubicon("run", plan, "--format", "json").stdout
        changed = json.loads(good)
        path = self.path("ways.json")

        def faults(result):
            self.write("ways.json", json.dumps(result))
            done = rubicon("verify", path)
            self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
            return done.stdout

        changed["agents"][0]["way"] = "rrrrrr"
        changed["agents"][1]["way"] = "llllll"
        self.assertIn("are both in (3, 1)", faults(changed))
        changed["agents"][0]["way"] = "wrrrrrr"
        self.assertIn("pass through each other", faults(changed))
        changed["agents"][0]["way"] = "u"
        self.assertIn("into a wall", faults(changed))
        changed["agents"][0]["way"] = "x"
        self.assertIn("unknown move", faults(changed))
        changed["agents"][0]["way"] = "r"
        self.assertIn("not at its goal", faults(changed))
        changed = json.loads(good)
        changed["cost"] = 13
        self.assertIn("cost is said to be 13, and is 15", faults(changed))
        changed = json.loads(good)
        changed["agents"][0]["shortest"] = 5
        self.assertIn("is said to have 5 ticks, and has 6", faults(changed))
        changed = json.loads(good)
        changed["outcome"] = "no_solution"
        self.assertIn("has a way, though nothing was solved", faults(changed))
        for text in (good.replace('"solved"', '"perhaps"'), '{"format": "rubicon-grid"}', good[: len(good) // 2]):
            self.write("ways.json", text)
            self.assertEqual(rubicon("verify", path).returncode, 2)

    def test_wrong_files_are_told_with_their_place(self):
        plan = self.plan('scenario "lane.scen";')
        self.write("lane.map", MAP[:-10])
        self.assertIn("lane.map:6:", self.said("run", plan))
        self.write("lane.map", MAP.replace("width 7", "width 1000000000"))
        self.assertIn("lane.map:3:1: error: the width of a map is a whole number", self.said("run", plan))
        self.write("lane.map", MAP)
        self.write("lane.scen", SCEN.replace("\t0\t1\t6\t1\t6", "\t0\t0\t6\t1\t6"))
        self.assertIn("lane.scen:2:1: error: the start (0, 0) of agent 'a1' is on a wall", self.said("run", plan))
        self.write("lane.scen", SCEN.replace("\t6\t1\t0\t1\t6", "\t6\t1\t6\t1\t6"))
        self.assertIn("agents 'a1' and 'a2' have the same goal (6, 1)", self.said("check", plan))
        self.write("lane.scen", "version 1\n0 m")
        self.assertIn("lane.scen:2:1: error: expected the width of the map", self.said("run", plan))
        self.assertIn("there is no such file", self.said("run", self.plan('scenario "none.scen";')))

    def test_wrong_plans(self):
        for parts, message in [
            ("agents 5;", "agents says how many of a scenario, and there is none"),
            ('scenario "lane.scen"; agents 3;', "has 2 agents; expected 3 at least"),
            ("node n at trans(0, 0, 0);", "do not go with policy grid"),
            ("policy order;", "is given twice"),
            ("agent a from (0, 1) to (1, 1); agent a from (2, 1) to (3, 1);", "agent 'a' is declared twice"),
            ("agent a from (0.5, 1) to (1, 1);", "the column of a cell is a whole number"),
            ("for i from 1 to 2 { agent a from (0, 1) to (1, 1); }", "stands outside of for and when"),
        ]:
            self.assertIn(message, self.said("check", self.plan(parts)))
        self.assertIn("is a whole number of 1 to", self.said("check", self.plan("", "1e30")))
        mixed = self.plan('scenario "lane.scen";').replace("p.plan", "q.plan")
        with open(self.path("p.plan")) as file:
            text = file.read()
        self.write("q.plan", text.rstrip().rstrip("}") + "  crew c;\n}\n")
        self.assertIn("has this network and nothing else", self.said("run", mixed))
        self.write("q.plan", 'plan p { network n { class c { speed 1 m/s; } node a at trans(0, 0, 0); map "lane.map"; } }')
        self.assertIn("map goes with policy grid", self.said("check", mixed))
        self.assertIn("has no tasks", self.said("flow", self.plan('scenario "lane.scen";')))
        self.assertIn("go with tasks", self.said("run", self.plan(""), "--trace", self.path("t.jsonl")))

    def test_files_are_named_from_the_folder_of_the_plan(self):
        os.mkdir(self.path("plans"))
        for out, name in (("here.plan", "lane.map"), (os.path.join("plans", "there.plan"), "../lane.map")):
            done = subprocess.run([RUBICON, "import", "lane.map", "lane.scen", "--out", out], capture_output=True, text=True, cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(self.path(out)) as file:
                self.assertIn(f'map "{name}";', file.read())
            self.assertEqual(rubicon("run", self.path(out)).returncode, 0)

    def test_wrong_imports(self):
        lane = self.path("lane.map")
        self.assertIn("goes with its map", self.said("import", self.path("lane.scen")))
        self.assertIn("one map", self.said("import", lane, lane))
        self.assertIn("a map takes --out only", self.said("import", lane, "--level"))
        self.write("lane.map", MAP[:40])
        self.assertIn("the map ends", self.said("import", lane, "--out", self.path("x.plan")))
        self.assertFalse(os.path.exists(self.path("x.plan")))


JOBS = """plan p {
  network floor {
    policy grid { %s }
    map "floor.map";
    agent a from (0, 0) to (0, 0);
    agent b from (6, 2) to (6, 2);
    %s
  }
}
"""


class JobsTest(ResultCase):
    def setUp(self):
        super().setUp()
        self.write("floor.map", "type octile\nheight 3\nwidth 7\nmap\n.......\n.@.@.@.\n.......\n")

    def path(self, name):
        return os.path.join(self.folder, name)

    def plan(self, parts, policy="seed 3;"):
        return self.write("p.plan", JOBS % (policy, parts))

    def said(self, parts, policy="seed 3;"):
        done = rubicon("check", self.plan(parts, policy))
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        return done.stderr

    def test_jobs_are_done_and_verified(self):
        plan = self.plan("jobs 20; job rush from (6, 0) to (0, 2) at 5;", "seed 3; tick 2 s; interval 1.5; late 0.2; late_ticks 4; window 12;")
        self.assertEqual(rubicon("fmt", plan).returncode, 0)
        self.assertEqual(rubicon("fmt", "--check", plan).returncode, 0)
        out = self.path("out")
        done = rubicon("run", plan, "--out", out)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("delivered  21 jobs in", done.stdout)
        self.assertIn("ticks of 2 s", done.stdout)
        verified = rubicon("verify", out)
        self.assertEqual(verified.returncode, 0, verified.stdout)
        self.assertIn("21 of 21 jobs delivered", verified.stdout)
        with open(os.path.join(out, "jobs.csv")) as file:
            self.assertEqual(len(file.readlines()), 22)
        with open(os.path.join(out, "agents.csv")) as file:
            rows = file.read().splitlines()
        self.assertEqual(rows[0], "agent,jobs,ticks,with_job,use,moves,late_ticks")
        self.assertEqual(sum(int(row.split(",")[1]) for row in rows[1:]), 21)
        self.assertEqual(rubicon("run", plan, "--format", "json").stdout, rubicon("run", plan, "--format", "json").stdout)

    def test_verify_finds_what_was_changed_of_jobs(self):
        good = rubicon("run", self.plan("jobs 6;", "seed 3; late 0.2; late_ticks 4;"), "--format", "json").stdout
        path = self.path("jobs.json")

        def faults(change):
            result = json.loads(good)
            change(result)
            self.write("jobs.json", json.dumps(result))
            done = rubicon("verify", path)
            self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
            return done.stdout

        def swap_takers(result):
            names = {"a": "b", "b": "a"}
            result["jobs"][0]["agent"] = names[result["jobs"][0]["agent"]]

        def together(result):
            result["agents"][1]["from"] = [0, 2]
            result["agents"][1]["way"] = "uu" + "w" * (result["ticks"] - 2)

        self.assertIn("is nearer to it", faults(swap_takers))
        self.assertIn("are both in", faults(together))
        self.assertIn("moves is said to be", faults(lambda r: r.update(moves=r["moves"] + 1)))
        self.assertIn("jobs_per_hour is said to be", faults(lambda r: r.update(jobs_per_hour=1)))
        self.assertIn("is picked up by agent", faults(lambda r: r["jobs"][0].update(picked=r["jobs"][0]["picked"] + 1)))
        self.assertIn("can be taken, and is said to be taken at tick", faults(lambda r: r["jobs"][0].update(taken=2)))
        self.assertIn("is the most", faults(lambda r: r["late_moves"][0].update(ticks=5)))
        self.assertIn("into a wall", faults(lambda r: r["agents"][0].update(way="u" * r["ticks"])))
        self.write("jobs.json", good.replace('"done"', '"perhaps"'))
        self.assertEqual(rubicon("verify", path).returncode, 2)

    def test_a_standstill_is_told(self):
        self.write("floor.map", "type octile\nheight 3\nwidth 7\nmap\n.......\n@@@@@@.\n@@@@@@.\n")
        done = rubicon("run", self.plan("job x from (0, 0) to (6, 2); job y from (6, 2) to (0, 0);"))
        self.assertEqual(done.returncode, 1)
        self.assertIn("standstill: for a long time no job has got on; agents with a job: a, b", done.stdout)

    def test_what_is_wrong_with_jobs_is_told(self):
        for parts, policy, message in [
            ("", "window 9;", "window goes with jobs, and there are none"),
            ("jobs 5;", "window 1;", "the window is a whole number of 2 to 200"),
            ("jobs 5;", "late 0.1;", "late is given, and late_ticks is not"),
            ("jobs 5;", "late 2; late_ticks 3;", "the share of moves that end late is 0 to 1"),
            ("jobs 5;", "tick 1 m;", "p.plan:3:"),
            ("jobs 1e9;", "seed 1;", "the number of jobs is a whole number of 1 to"),
            ("jobs 5; jobs 6;", "seed 1;", "is given twice"),
            ("job x from (1, 1) to (2, 0);", "seed 1;", "job 'x' begins at (1, 1), which is on a wall"),
            ("job x from (9, 1) to (2, 0);", "seed 1;", "outside of the map of 7 x 3"),
            ("job x from (0, 0) to (2, 0) at 0.5;", "seed 1;", "the tick at which a job arrives is a whole number"),
            ("jobs 2; job j2 from (0, 0) to (2, 0);", "seed 1;", "job 'j2' is declared twice"),
            ("jobs 2;", "speed 1;", "expected expansions, seed, window, interval, tick, late or late_ticks"),
        ]:
            self.assertIn(message, self.said(parts, policy))


if __name__ == "__main__":
    unittest.main()
