"""rubicon why: what it tells of rejected, late and unknown tasks, from a plan and from a result."""

import json
import os
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


def rubicon(*arguments):
    return subprocess.run([RUBICON, *arguments], capture_output=True, text=True, timeout=60)


class Why(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = self.temporary.name
        for name, text in (("g.robot", ROBOT), ("g.motion", SCRIPT), ("yard.plan", PLAN)):
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


if __name__ == "__main__":
    unittest.main()
