"""rubicon why: what it tells of rejected, late and unknown tasks, from a plan and from a result."""

import json
import os
import re
import subprocess
import tempfile
import unittest

RUBICON = os.environ["RUBICON"]

ROBOT = """robot gantry {
  body bridge { param x range(-50, 50) step(1) speed(1); frame trans(x, 0, 0); }
  body hoist on bridge {
    param z range(0, 10) step(1) speed(1) start(5);
    frame trans(0, 0, z);
    shape box(-0.5, -0.5, 0, 0.5, 0.5, 1);
  }
  tool hoist;
  behaviour "g.motion";
}
"""
SCRIPT = """chain {
  move_to(x, goal(x)),
  move_dir(z, 1)
};
chain { move_to(z, goal(z)) };
"""
PLAN = """plan yard {
  start_at "2026-03-02 07:00";
  calendar site { mon-fri 07:00-12:00, 12:30-16:00; }
  site box(5, -5, 0, 6, 5, 30);
  robot g "g.robot" { calendar site; }
  crew c { calendar site; }
  task east { by g; go x 10; }
  task after_east { by c; takes 1 min; after east; }
  task west { by g; go x -10; priority 1; }
  task joints { by c; takes 2 h; after west; }
  task paint { by c; takes 1 h; after west; }
}
"""


# A wall is set, then somebody wants to go through it and a pillar behind it; the hoist reaches over the wall only.
ROW = """plan row {
  start_at "2026-03-02 07:00";
  robot g "g.robot";
  component wall { shape box(-0.2, -2, 0, 0.2, 2, 8); at trans(-10, 0, 0); grip trans(0, 0, 8); }
  component pillar { shape box(-0.5, -0.5, 0, 0.5, 0.5, 30); at trans(11, 0, 0); grip trans(0, 0, 12); }
  task set_wall { by g; move wall to trans(8, 0, 0); }
  task low { by g; go x 0, z 2; after set_wall; }
  task east { by g; go x 20; after low; }
}
"""


# One hoist would have to pass the other to get to its park position; the other's script places by z alone.
RAIL = """plan rail {
  robot left "rail.robot" { start x 2; park x 28; }
  robot right "rail.robot" { start x 20; park x 25; }
  component crate { shape box(-0.5, -0.5, 0, 0.5, 0.5, 1); at trans(15, 0, 0); grip trans(0, 0, 1); }
  task bring { by right; move crate to trans(1, 0, 0); }
}
"""


RAIL_SCRIPT = """which {
  place: chain { move_to(z, goal(z)) };
  default: chain { move_to(z, 5) }; chain { move_to(x, goal(x)) };
    which { when (dist(x, goal(x)) < 0.001): chain { move_to(z, goal(z)) }; default: ; };
};
"""


# The gantry stands in the zone of those who grout the joints, on each of two floors.
FLOORS = """plan floors {
  robot g "g.robot" { start x 0; park x -20; }
  crew c;
  task set_1 { by g; go x 10; }
  task joints_1 { by c; takes 1 h; after set_1; zone box(8, -2, 0, 12, 2, 9); }
  task set_2 { by g; go x 10; after joints_1; }
  task joints_2 { by c; takes 1 h; after set_2; zone box(8, -2, 0, 12, 2, 9); }
}
"""


# A wall with a post higher than the hoist can go is set, then somebody wants to get past it.
TALL = """plan tall {
  robot g "g.robot";
  component wall {
    shape box(-0.2, -2, 0, 0.2, 2, 10);
    shape box(-1.4, -0.4, 0, -1, 0.4, 12);
    at trans(-10, 0, 0);
    grip trans(0, 0, 10);
  }
  task set_wall { by g; move wall to trans(8, 0, 0); }
  task west { by g; go x -5; after set_wall; }
}
"""


def rubicon(*arguments):
    return subprocess.run([RUBICON, *arguments], capture_output=True, text=True, timeout=60)


class Why(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = self.temporary.name
        for name, text in (("g.robot", ROBOT), ("g.motion", SCRIPT), ("yard.plan", PLAN), ("row.plan", ROW), ("tall.plan", TALL)):
            with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        self.plan = os.path.join(self.folder, "yard.plan")
        self.out = os.path.join(self.folder, "out")
        self.assertEqual(rubicon("run", self.plan, "--out", self.out).returncode, 1)

    def tearDown(self):
        self.temporary.cleanup()

    def test_a_rejected_task_names_what_blocked_it_first_and_what_was_tried(self):
        told = rubicon("why", self.out, "east")
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertIn("east is rejected: blocked by site at step", told.stdout)
        self.assertRegex(told.stdout, r"first blocked at step 15: move_to\(x\) in .*g\.motion, line 2: "
                                      r"g\.hoist meets site\n +there x 4, z 5")
        self.assertIn("move_dir(z)", told.stdout)
        self.assertIn("is at the limit of z", told.stdout)

    def test_json_carries_the_pose_and_the_pair(self):
        story = json.loads(rubicon("why", self.out, "east", "--format", "json").stdout)
        self.assertEqual(story["result"], "rejected")
        first = story["motions"][0]["first_hit"]
        self.assertEqual(first["hit"], ["g.hoist", "site"])
        self.assertEqual(first["q"], {"x": 4, "z": 5})
        self.assertEqual(first["line"], 2)
        tried = [(each["command"], each["reason"]) for each in story["motions"][0]["last"]]
        self.assertIn(("move_dir", "limit z"), tried)

    def test_a_refused_step_says_where_and_how_deep(self):
        told = rubicon("why", self.out, "east").stdout
        # From x = 4 to x = 5 the hoist, 0.5 m to each side, comes to the wall at x = 5 half way.
        self.assertRegex(told, r"free for 50\.\d % of the step; then they meet at \(5\.0\d\d, ")
        self.assertIn("at its end g.hoist would be 0.500 m deep in site (contact tolerance 1 mm)", told)
        self.assertIn("site is part of the site", told)
        story = json.loads(rubicon("why", self.out, "east", "--format", "json").stdout)
        self.assertEqual(story["contact_tolerance"], 0.001)
        contact = story["motions"][0]["first_hit"]["contact"]
        self.assertAlmostEqual(contact["free_to"], 0.501, delta=2e-4)
        self.assertAlmostEqual(contact["depth_at_end"], 0.5, delta=2e-6)
        self.assertAlmostEqual(contact["point"][0], 5, delta=2e-3)
        self.assertTrue(all("contact" in each for each in story["motions"][0]["last"] if "hit" in each))

    def test_an_obstacle_names_the_task_that_put_it_there_and_what_stands_behind_it(self):
        row = os.path.join(self.folder, "row.plan")
        story = json.loads(rubicon("why", row, "east", "--format", "json").stdout)
        first = story["motions"][0]["first_hit"]
        self.assertEqual(first["hit"], ["g.hoist", "wall"])
        self.assertEqual(first["obstacle"]["kind"], "component")
        self.assertEqual(first["obstacle"]["task"], "set_wall")
        way = story["motions"][0]["first_hit"] and story["motions"][0]["way_to_goal"]
        self.assertEqual([each["hit"][1] for each in way], ["wall", "pillar"])
        self.assertLess(way[0]["from"], way[1]["from"])
        self.assertEqual(way[1]["obstacle"], {"kind": "component"})
        told = rubicon("why", row, "east").stdout
        self.assertRegex(told, r"wall stands there since set_wall set it down at 2026-03-02 07:00:\d\d\n")
        self.assertIn("on the way to the goal it would meet:", told)
        self.assertIn("g.hoist meets pillar; pillar stands there from the beginning", told)

    def test_a_task_that_was_done_tells_its_nearest_miss(self):
        row = os.path.join(self.folder, "row.plan")
        nearest = json.loads(rubicon("why", row, "set_wall", "--format", "json").stdout)["nearest_miss"]
        self.assertEqual(nearest["pair"], ["g.hoist", "pillar"])
        self.assertAlmostEqual(nearest["at_most"], 2, delta=2e-3)
        self.assertLessEqual(nearest["at_least"], 2 + 1e-9)
        self.assertGreaterEqual(nearest["at_least"], 2 - 2e-3)
        self.assertEqual(nearest["touched"], ["wall"])
        told = rubicon("why", row, "low").stdout
        self.assertRegex(told, r"nearest miss: g\.hoist passed pillar at 2\.00\d m in step 1, at 2026-03-02 .*; proved: nothing came "
                               r"nearer than (2\.000|1\.99\d) m \(what it touched .*: wall\)")
        self.assertRegex(rubicon("why", self.out, "west").stdout, r"g\.hoist passed site at 4\.50\d m in step 1, ")

    def test_a_trace_of_an_older_version_tells_what_it_can(self):
        with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
            text = file.read()
        old = os.path.join(self.folder, "old.jsonl")
        with open(old, "w", encoding="utf-8") as file:
            file.write(re.sub(r',"step":\[[^]]*\]', "", text))
        told = rubicon("why", old, "east")
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertIn("first blocked at step 15", told.stdout)
        self.assertNotIn("deep in site", told.stdout)

    def test_what_depends_on_it_names_it(self):
        told = rubicon("why", self.out, "after_east").stdout
        self.assertEqual(told, "after_east is not reached: it comes after east, which is rejected\n")

    def test_a_late_task_tells_its_chain_of_waits(self):
        told = rubicon("why", self.out, "paint").stdout
        self.assertIn("paint is done", told)
        chain = told.split("why it began when it did:\n")[1].splitlines()
        self.assertEqual([line.split()[2] for line in chain], ["west", "joints", "paint"])
        self.assertIn("starts with the plan", chain[0])
        self.assertIn("starts after west (FS)", chain[1])
        self.assertIn("starts when 'c' is free, which joints had", chain[2])

    def test_a_plan_is_run_and_tells_the_same(self):
        for task in ("east", "after_east", "paint"):
            self.assertEqual(rubicon("why", self.plan, task).stdout, rubicon("why", self.out, task).stdout)

    def test_the_mast_of_a_machine_does_not_leave(self):
        crane = ROBOT.replace("robot gantry {", "robot post { body mast { shape box(3, -1, 0, 4, 1, 12); } body arm on mast { param x range(-50, 50) "
                              "step(1) speed(1); frame trans(x, 20, 0); shape box(-1, -1, 0, 1, 1, 1); } tool arm; behaviour { chain { move_to(x, goal(x)) } } }\n"
                              "robot gantry {", 1)
        post, gantry = crane.split("robot gantry", 1)
        plan = """plan masts {
          robot g "rail.robot" { start x 0; }
          robot post "post.robot" { park x 9; }
          crew c;
          task hold { by post, c; go x 2; takes 1 h; }
          task cross { by g; go x 8; }
        }"""
        for name, text in (("rail.robot", ROBOT), ("post.robot", post), ("masts.plan", plan)):
            with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        run = rubicon("run", os.path.join(self.folder, "masts.plan"), "--format", "json")
        self.assertEqual(run.returncode, 1, run.stderr)
        cross = next(task for task in json.loads(run.stdout)["tasks"] if task["task"] == "cross")
        self.assertRegex(cross["reason"], r"^blocked by post\.mast at step \d+ .*: g\.hoist meets post\.mast; ")
        self.assertEqual(cross["start"], 0)

    def test_a_load_that_is_put_down_short_says_who_barred_the_way(self):
        for name, text in (("rail.robot", ROBOT.replace("g.motion", "rail.motion").replace("gantry", "rail")),
                           ("rail.motion", RAIL_SCRIPT), ("rail.plan", RAIL)):
            with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        run = rubicon("run", os.path.join(self.folder, "rail.plan"), "--format", "json")
        self.assertEqual(run.returncode, 1, run.stderr)
        reasons = {task["task"]: task["reason"] for task in json.loads(run.stdout)["tasks"]}
        self.assertEqual(reasons["bring"],
                         "short of the goal: x is 2 m above the goal, while placing crate; "
                         "before that right (bring) waits for left: right.hoist meets left.hoist")

    def test_a_machine_that_parks_twice_is_followed_to_the_right_time(self):
        plan, out = os.path.join(self.folder, "floors.plan"), os.path.join(self.folder, "floors")
        with open(plan, "w", encoding="utf-8") as file:
            file.write(FLOORS)
        self.assertEqual(rubicon("run", plan, "--out", out).returncode, 0)
        self.assertEqual(rubicon("verify", out).returncode, 0)
        with open(os.path.join(out, "schedule.json"), encoding="utf-8") as file:
            schedule = json.load(file)
        waited = "'g', which park g had, to be out of the way"
        self.assertEqual([each["text"] for each in schedule["critical"]],
                         ["set_1 starts with the plan", "joints_1 could start after set_1 (FS); its own work does not count",
                          "park g starts because joints_1 asks for it", "joints_1 starts after it waited for " + waited, "set_2 starts after joints_1 (FS)",
                          "joints_2 could start after set_2 (FS); its own work does not count", "park g starts because joints_2 asks for it",
                          "joints_2 starts after it waited for " + waited])
        # The machine always has to leave first: what comes before has no float.
        self.assertEqual([task["float"]["total"] for task in schedule["tasks"] if task["task"] in ("set_1", "set_2")], [0, 0])
        times = [each["start"] for each in json.loads(rubicon("why", out, "joints_1", "--format", "json").stdout)["waits"]]
        self.assertEqual(times, sorted(times))
        self.assertEqual(times[-1], next(task["start"] for task in schedule["tasks"] if task["task"] == "joints_1"))

    def test_an_unknown_task_gets_a_suggestion(self):
        told = rubicon("why", self.out, "jonts")
        self.assertEqual(told.returncode, 2)
        self.assertIn("there is no task 'jonts'", told.stderr)
        self.assertIn("did you mean joints?", told.stderr)

    def test_what_is_no_trace_is_refused_with_its_place(self):
        bad = os.path.join(self.folder, "bad.jsonl")
        for text in ("", "no json\n", '{"type":"header","format":"other"}\n', '{"type":"try"}\n', "[]\n",
                     '{"type":"header","format":"rubicon-trace"}\n', "\x00\xff" * 100):
            with open(bad, "w", encoding="utf-8") as file:
                file.write(text)
            told = rubicon("why", bad, "east")
            self.assertEqual(told.returncode, 2, text)
            self.assertIn("bad.jsonl", told.stderr)
        self.assertEqual(rubicon("why", os.path.join(self.folder, "none.jsonl"), "x").returncode, 2)

    def test_a_trace_without_steps_says_so(self):
        trace = os.path.join(self.folder, "t.jsonl")
        rubicon("run", self.plan, "--trace", trace, "--trace-detail", "tasks")
        self.assertIn("no single steps", rubicon("why", trace, "east").stdout)

    def test_advice_tries_other_orders_and_says_what_was_not_tried(self):
        plan = os.path.join(self.folder, "tall.plan")
        told = rubicon("why", plan, "west", "--advise")
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertIn("west is rejected", told.stdout)
        advice = told.stdout[told.stdout.index("\nadvice, from "):]
        self.assertIn("this helps\n  west before set_wall, its link 'after set_wall' left out: west is done after ", advice)

    def test_advice_as_json(self):
        plan = os.path.join(self.folder, "tall.plan")
        story = json.loads(rubicon("why", plan, "west", "--advise", "--format", "json").stdout)
        self.assertEqual(story["task"], "west")
        advice = story["advice"]
        self.assertEqual(advice["before"]["result"], "rejected")
        helping = [each for each in advice["tried"] if each["helps"]]
        self.assertEqual(helping[0]["change"], "west before set_wall, its link 'after set_wall' left out")
        self.assertEqual(helping[0]["result"], "done")
        self.assertGreater(helping[0]["done"], advice["before"]["done"])
        # The changed plan, written by hand, gives the same.
        with open(plan, encoding="utf-8") as file:
            text = file.read()
        other = os.path.join(self.folder, "other.plan")
        with open(other, "w", encoding="utf-8") as file:
            file.write(text.replace("go x -5; after set_wall;", "go x -5;")
                           .replace("move wall to trans(8, 0, 0);", "move wall to trans(8, 0, 0); after west;"))
        run = json.loads(rubicon("run", other, "--format", "json").stdout)
        self.assertAlmostEqual(run["process_time"], helping[0]["process_time"])
        west = next(task for task in run["tasks"] if task["task"] == "west")
        self.assertAlmostEqual(west["start"] + west["duration"], helping[0]["end"])

    def test_a_task_that_is_not_reached_points_at_the_rejected_one(self):
        plan = os.path.join(self.folder, "later.plan")
        with open(os.path.join(self.folder, "tall.plan"), encoding="utf-8") as file:
            text = file.read()
        with open(plan, "w", encoding="utf-8") as file:
            file.write(text.replace("  task west", "  task look { takes 1 min; after west; }\n  task last { takes 1 min; after look; }\n  task west"))
        told = rubicon("why", plan, "last", "--advise")
        self.assertEqual((told.returncode, told.stderr), (0, ""))
        self.assertIn("\nno advice for last, which waits for west: what helps that one is told by why PLAN west --advise\n", told.stdout)
        advice = json.loads(rubicon("why", plan, "last", "--advise", "--format", "json").stdout)["advice"]
        self.assertEqual((advice["waits_for"], advice["tried"], advice["not_tried"]), ("west", [], []))

    def test_advice_tries_who_had_the_crew(self):
        plan = os.path.join(self.folder, "queue.plan")
        with open(plan, "w", encoding="utf-8") as file:
            file.write("""plan queue {
              robot g "g.robot";
              crew riggers;
              task tidy { by riggers; takes 5 h; }
              component wall { shape box(-0.2, -2, 0, 0.2, 2, 8); at trans(-10, 0, 0); grip trans(0, 0, 8); }
              task set { by g; move wall to trans(8, 0, 0); hook 10 min by riggers; }
              task roof { takes 5 h; after set; }
            }""")
        # What comes before a task is looked at too.
        for task in ("set", "roof"):
            advice = json.loads(rubicon("why", plan, task, "--advise", "--format", "json").stdout)["advice"]
            self.assertEqual([(each["change"], each["helps"]) for each in advice["tried"]], [("set before tidy", True)])
            self.assertLess(advice["tried"][0]["end"], advice["before"]["end"] - 4 * 3600)
            self.assertLess(advice["tried"][0]["process_time"], advice["before"]["process_time"] - 4 * 3600)
        told = rubicon("why", plan, "tidy", "--advise").stdout
        self.assertIn("no change was found to try. Looked for: ", told)
        self.assertNotIn("helps", told)

    def test_advice_needs_a_plan_with_tasks(self):
        told = rubicon("why", self.out, "east", "--advise")
        self.assertEqual(told.returncode, 2)
        self.assertIn("--advise runs changed plans, so it goes with a plan: rubicon why PLAN east --advise", told.stderr)

    def test_advice_over_links_of_others_is_not_tried(self):
        plan = os.path.join(self.folder, "tall.plan")
        with open(plan, encoding="utf-8") as file:
            text = file.read()
        with open(plan, "w", encoding="utf-8") as file:
            file.write(text.replace("go x -5; after set_wall;", "go x -5; after look;")
                           .replace("  task west", "  task look { takes 1 min; after set_wall; }\n  task west"))
        advice = json.loads(rubicon("why", plan, "west", "--advise", "--format", "json").stdout)["advice"]
        self.assertIn({"change": "west before set_wall", "why": "west comes after set_wall by links over other tasks"},
                      advice["not_tried"])


if __name__ == "__main__":
    unittest.main()
