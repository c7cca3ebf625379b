"""What must stand: what is put down, what others stand on, what stands at the beginning; and what the answers say of it."""

import json
import os
import subprocess
import tempfile
import unittest

RUBICON = os.environ["RUBICON"]

ROBOT = """robot gantry {
  body bridge { param x range(-50, 50) step(1) speed(1); frame trans(x, 0, 0); }
  body hoist on bridge {
    param z range(0, 10) step(0.1) speed(1) start(5);
    frame trans(0, 0, z);
    shape box(-0.2, -0.2, 0, 0.2, 0.2, 1);
  }
  tool hoist;
  behaviour "g.motion";
}
"""
SCRIPT = """which {
  place: chain { move_to(x, goal(x)) }; chain { move_to(z, goal(z)) };
  transport: chain { move_to(z, 8) }; chain { move_to(x, goal(x)) };
  default: chain { move_to(z, 8) }; chain { move_to(x, goal(x)) }; chain { move_to(z, goal(z)) };
};
"""
HEAD = """  robot crane "g.robot" { start x 0, z 8; }
  site box(-50, -10, -1, 50, 10, 0);
"""


def box(name, x, z=0, width=1, height=2, more=""):
    return (f"  component {name} {{ shape box({-width / 2}, -0.5, 0, {width / 2}, 0.5, {height}); at trans({x}, 0, {z}); "
            f"grip trans(0, 0, {height}); {more} }}\n")


def move(task, component, x, z, more=""):
    return f"  task {task} {{ by crane; move {component} to trans({x}, 0, {z}); {more} }}\n"


class Support(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = self.temporary.name
        for name, text in (("g.robot", ROBOT), ("g.motion", SCRIPT)):
            self.write(name, text)

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def rubicon(self, *arguments):
        return subprocess.run([RUBICON, *arguments], capture_output=True, text=True, timeout=120, cwd=self.folder)

    def run_plan(self, *items, exit_code=0, warns=""):
        """The rows of the tasks by name, after verify found no fault."""
        self.write("site.plan", "plan site {\n" + HEAD + "".join(items) + "}\n")
        run = self.rubicon("run", "site.plan", "--out", "out")
        self.assertEqual(run.returncode, exit_code, run.stdout + run.stderr)
        self.assertIn(warns, run.stderr)
        if not warns:
            self.assertNotIn("does not stand", run.stderr)
        verdict = self.rubicon("verify", "out")
        self.assertEqual(verdict.returncode, 0, verdict.stdout + verdict.stderr)
        self.table = run.stdout
        with open(os.path.join(self.folder, "out", "schedule.json"), encoding="utf-8") as file:
            return {row["task"]: row for row in json.load(file)["tasks"]}

    def test_what_is_put_down_must_stand(self):
        slab = box("slab", 10, width=4, height=1)
        for x, z, reason in ((10, 1, ""), (10, 1.1, "b does not stand: the nearest below is slab, 100 mm lower"),
                             (12.3, 1, "b does not stand: its centre of mass is 300 mm outside of what carries it, slab")):
            rows = self.run_plan(slab, box("b", 0), move("set", "b", x, z), exit_code=1 if reason else 0)
            self.assertEqual(rows["set"]["reason"], reason)
            self.assertEqual(rows["set"]["result"], "rejected" if reason else "done")
        why = self.rubicon("why", "out", "set")
        self.assertIn("b does not stand: its centre of mass is 300 mm outside", why.stdout)
        for z, told in ((1.0104, "10.4 mm"), (1.01004, "10.04 mm")):  # 10 mm carry
            rows = self.run_plan(slab, box("b", 0), move("set", "b", 10, z), exit_code=1)
            self.assertEqual(rows["set"]["reason"], f"b does not stand: the nearest below is slab, {told} lower")

    def test_exactly_one_millimetre_inside_stands_wherever_it_is(self):
        for x in (0, 1, 2, 7):
            rows = self.run_plan(box("base", x, height=1), box("slab", -20), move("set", "slab", f"({x} + 0.499)", 1))
            self.assertEqual(rows["set"]["result"], "done", x)
        rows = self.run_plan(box("base", 1, height=1), box("slab", -20), move("set", "slab", 1.4995, 1), exit_code=1)
        self.assertIn("its centre of mass is only 0.5 mm inside of what carries it, base", rows["set"]["reason"])

    def verdict_if_strict(self, *items):
        """What verify says of what a plan only warned of."""
        self.run_plan("  support warn;\n", *items)
        trace = os.path.join(self.folder, "out", "trace.jsonl")
        with open(trace, encoding="utf-8") as file:
            text = file.read()
        with open(trace, "w", encoding="utf-8") as file:
            file.write(text.replace('"mode":"warn"', '"mode":"on"', 1))
        os.remove(os.path.join(self.folder, "out", "report.html"))  # of the other trace
        return self.rubicon("verify", "out").stdout

    def test_verify_asks_for_one_millimetre_too(self):
        items = [box("base", 10, height=1, more="mass 1 t;"), box("slab", 0, more="mass 1 t;")]
        for inside, fault in ((0.0015, ""), (0.0005, "slab does not stand: its centre of mass is not 1 mm inside of what carries it")):
            self.assertIn(fault or "no fault", self.verdict_if_strict(*items, move("set", "slab", 10.5 - inside, 1)))
        for inside, fault in ((0.0015, ""), (0.0005, "their weights cannot be balanced")):
            self.assertIn(fault or "no fault", self.verdict_if_strict(self.EQUILIBRIUM, *items, move("set", "slab", 10.5 - inside, 1)))

    def test_the_plan_says_how_strict_it_is(self):
        floating = box("b", 0) + move("set", "b", 10, 1)
        reason = "b does not stand: the nearest below is site, 1000 mm lower"
        self.assertEqual(self.run_plan(floating, "  support on;\n", exit_code=1)["set"]["reason"], reason)
        rows = self.run_plan(floating, "  support warn;\n")
        self.assertEqual(rows["set"]["support"], [reason])
        self.assertIn(f"set: {reason}", self.table)
        self.assertNotIn("support", self.run_plan(floating, "  support off;\n")["set"])
        low = box("c", 0) + move("set", "c", 10, 0.1)
        self.assertEqual(self.run_plan(low, exit_code=1)["set"]["result"], "rejected")
        self.assertEqual(self.run_plan(low, "  support gap 10 cm;\n")["set"]["result"], "done")

    def test_what_others_stand_on_stays(self):
        pillars = box("left", 8, width=2, height=1) + box("right", 11, height=1) + box("slab", 10, z=1, width=3, height=1)
        rows = self.run_plan(pillars, move("take", "left", 20, 0), exit_code=1)
        self.assertEqual(rows["take"]["reason"], "left cannot be taken away: without it slab does not stand")
        rows = self.run_plan(pillars, "  crew c;\n  task strike { by c; remove right; takes 1 min; }\n", exit_code=1)
        self.assertEqual(rows["strike"]["reason"], "right cannot be taken away: without it slab does not stand")
        rows = self.run_plan(pillars, move("one", "slab", 20, 0), move("two", "left", 30, 0, "after one;"))
        self.assertEqual([row["result"] for row in rows.values()], ["done", "done"])

    def test_parts_that_hold_only_each_other(self):
        men = "  crew men;\n"
        post = box("post", 0, width=2, height=3)
        pair = box("left", -0.5, z=3, more="fixed to right;") + box("right", 0.5, z=3, more="fixed to left;")
        strike = "  task strike { by men; remove post; takes 1 min; }\n"
        rows = self.run_plan(men, post, pair, strike, exit_code=1)
        self.assertEqual(rows["strike"]["reason"], "post cannot be taken away: without it left, right do not stand")
        # The second opinion finds it in a result that let it be done: right was fixed to a wall.
        pair = pair.replace("fixed to left", "fixed to wall")
        self.run_plan(men, post, pair, box("wall", 1.5, height=5, more="fixed to site;"), strike)
        trace = os.path.join(self.folder, "out", "trace.jsonl")
        with open(trace, encoding="utf-8") as file:
            text = file.read()
        with open(trace, "w", encoding="utf-8") as file:
            file.write(text.replace('"wall"]', '"left"]'))
        verdict = self.rubicon("verify", "out")
        self.assertEqual(verdict.returncode, 1, verdict.stdout)
        self.assertIn("left, right hold only each other", verdict.stdout)

    def test_what_is_fixed_or_braced(self):
        # A shelf on the side of a wall; a sheet that leans over is held by a prop until that is taken away.
        shelf = box("wall", 10, height=4) + box("shelf", 0, height=1, more="fixed to wall;")
        self.assertEqual(self.run_plan(shelf, move("set", "shelf", 11, 2))["set"]["result"], "done")
        rows = self.run_plan(shelf, move("set", "shelf", 13, 2), exit_code=1)
        self.assertIn("the nearest below is site", rows["set"]["reason"])
        leaning = (box("block", 10, height=1) + box("plate", 0, height=1, more="braced by prop;")
                   + box("prop", 11.2, width=0.2, height=2.1))
        rows = self.run_plan(leaning, move("set", "plate", 10.6, 1), move("strike", "prop", 30, 0, "after set;"),
                             exit_code=1)
        self.assertEqual(rows["set"]["result"], "done")
        self.assertEqual(rows["strike"]["reason"], "prop cannot be taken away: without it plate does not stand")

    def test_what_is_fixed_only_after_a_task(self):
        # A plate that leans over is held by a prop until it is bolted to the block.
        leaning = ("  crew bolters;\n" + box("block", 10, height=1)
                   + box("plate", 0, height=1, more="fixed to block after bolt; braced by prop;")
                   + box("prop", 11.2, width=0.2, height=2.1) + move("set", "plate", 10.6, 1)
                   + "  task bolt { by bolters; takes 10 min; after set; }\n")
        rows = self.run_plan(leaning, move("strike", "prop", 30, 0, "after set;"), exit_code=1)
        self.assertEqual([rows[name]["result"] for name in ("set", "bolt", "strike")], ["done", "done", "rejected"])
        self.assertEqual(rows["strike"]["reason"], "prop cannot be taken away: without it plate does not stand; "
                                                   "it is fixed to block only after bolt")
        rows = self.run_plan(leaning, move("strike", "prop", 30, 0, "after bolt;"))
        self.assertEqual({row["result"] for row in rows.values()}, {"done"})
        self.assertEqual(self.faults_with(lambda header: header["components"][1].update(fixed_after=["strike"])), 1)
        # Forces: a bracket on a post turns until it is fixed.
        bracket = ("  support equilibrium;\n  crew welders;\n" + box("post", 10, height=2, more="mass 1 t; fixed to site;")
                   + box("bracket", 10.9, z=2, width=2, height=0.2, more="mass 0.1 t; fixed to post after weld;")
                   + box("stand", 11.7, width=0.2, height=2, more="mass 50 kg;")
                   + "  task weld { by welders; takes 30 min; }\n")
        strike = "  task strike {{ by welders; remove stand; takes 1 min; {} }}\n"
        self.assertEqual(self.run_plan(bracket, strike.format("after weld;"))["strike"]["result"], "done")
        rows = self.run_plan(bracket.replace("{ by welders; takes 30 min; }", "{ by welders; takes 30 min; after strike; }"),
                             strike.format(""), exit_code=1)
        self.assertIn("without it bracket would turn on post", rows["strike"]["reason"])
        self.assertEqual(rows["weld"]["result"], "not reached")

    def faults_with(self, change):
        """The exit code of verify after a change of the header."""
        path = os.path.join(self.folder, "out", "trace.jsonl")
        with open(path, encoding="utf-8") as file:
            first, rest = file.readline(), file.read()
        header = json.loads(first)
        change(header)
        with open(path, "w", encoding="utf-8") as file:
            file.write(json.dumps(header, separators=(",", ":")) + "\n" + rest)
        verdict = self.rubicon("verify", "out")
        self.assertIn("plate does not stand", verdict.stdout)
        return verdict.returncode

    def test_what_floats_stands_once_a_task_has_fixed_it(self):
        """And what rests on it; a run that goes back to before knows it no more."""
        site = (box("wall", 20, height=4) + box("bracket", 21, z=3, height=1, more="fixed to wall after weld;")
                + box("lamp", 21, z=4, height=0.5) + box("load", 0)
                + "  crew welders;\n  task weld { by welders; takes 1 h; }\n")
        strike = "  task strike { by welders; remove wall; takes 5 min; %s }\n"
        rows = self.run_plan(site, strike % "after weld;", exit_code=1, warns="bracket does not stand")
        self.assertEqual(rows["strike"]["reason"], "wall cannot be taken away: without it bracket does not stand")
        self.run_plan(site, strike % "priority 1;", warns="lamp does not stand")
        put = "  task shift { by crane; move lamp to trans(10, 0, 0); %s }\n" + move("put", "load", 21, 4, "after shift;")
        rows = self.run_plan(site, put % "after weld;", warns="bracket does not stand")
        self.assertEqual(rows["put"]["result"], "done")
        rows = self.run_plan(site, put % "", exit_code=1, warns="bracket does not stand")
        self.assertIn("lamp does not stand where it is taken up", rows["shift"]["reason"])
        # A task that began before the weld is done and is rejected after it: the run goes back, and the bracket floats.
        rows = self.run_plan(site.replace(box("lamp", 21, z=4, height=0.5), box("other", -5)),
                             move("hang", "other", -10, 3, "hook 2 h; priority 1;"), move("put", "load", 21, 4), exit_code=1,
                             warns="bracket does not stand")
        self.assertIn("other does not stand", rows["hang"]["reason"])
        self.assertEqual(rows["put"]["reason"], "load does not stand: it rests on bracket, which does not stand")

    def test_the_hint_for_what_waits_to_be_fixed(self):
        self.write("site.plan", "plan site {\n" + HEAD + box("wall", 20, height=4)
                   + box("bracket", 21, z=3, height=1, more="fixed to wall after weld;")
                   + "  crew welders;\n  task weld { by welders; takes 1 h; }\n}\n")
        check = self.rubicon("check", "site.plan").stderr
        self.assertIn("it is fixed to wall only after weld", check)
        self.assertIn("hint: say what holds it until then", check)

    def test_the_beginning(self):
        lid = box("lid", 10, z=2, height=1)
        rows = self.run_plan(lid, box("b", 0), move("on_lid", "b", 10, 3), move("take", "lid", 20, 0), exit_code=1,
                             warns="warning: at the beginning lid does not stand: the nearest below is site, 2000 mm lower")
        self.assertEqual(rows["on_lid"]["reason"], "b does not stand: it rests on lid, which does not stand")
        self.assertEqual(rows["take"]["reason"],
                         "lid does not stand where it is taken up: the nearest below is site, 2000 mm lower")
        check = self.rubicon("check", "site.plan")
        self.assertEqual(check.returncode, 0)
        self.assertIn("P45", self.rubicon("check", "--format", "json", "site.plan").stdout)

    EQUILIBRIUM = "  support equilibrium;\n  crew c;\n"

    def test_a_load_turns_what_it_is_put_on(self):
        # A plank on a block; the middle of the load is over the plank, but not over the block.
        plank = box("block", 10, width=2, height=1, more="mass 5 t;") + box("plank", 10.5, z=1, width=3, height=0.2, more="mass 0.2 t;")
        load = box("load", 0, width=0.6, height=0.5, more="mass 2 t;") + move("set", "load", 11.6, 1.2)
        self.assertEqual(self.run_plan(plank, load)["set"]["result"], "done")
        rows = self.run_plan(plank, load, self.EQUILIBRIUM, exit_code=1)
        self.assertEqual(rows["set"]["reason"], "load cannot be let go: plank would turn on block, and load with it")
        rows = self.run_plan(plank, load, self.EQUILIBRIUM, "  support warn;\n")
        self.assertEqual(rows["set"]["support"], ["load cannot be let go: plank would turn on block, and load with it"])
        counter = box("counter", -5, width=0.6, height=0.5, more="mass 4 t;") + move("first_counter", "counter", 9.5, 1.2)
        rows = self.run_plan(plank, counter, load.replace("move load", "after first_counter; move load"), self.EQUILIBRIUM)
        self.assertEqual(rows["set"]["result"], "done")

    def test_what_is_taken_away_turns_what_it_held(self):
        # A cantilever with a counterweight, and one on a prop.
        held = (box("wall", 10, height=1, more="mass 3 t;") + box("beam", 11.2, z=1, width=3, height=0.2, more="mass 1 t;")
                + box("weight", 9.9, z=1.2, width=0.2, height=1, more="mass 4 t;"))
        rows = self.run_plan(held, "  task look { by crane; go x 20; }\n", warns="at the beginning beam does not stand")
        self.assertIn("beam does not stand: its centre of mass is 700 mm outside", self.rubicon("check", "site.plan").stderr)
        rows = self.run_plan(held, self.EQUILIBRIUM, move("take", "weight", 30, 0), exit_code=1)
        self.assertEqual(rows["take"]["reason"], "weight cannot be taken away: without it beam would turn on wall")
        propped = (box("wall", 10, height=1, more="mass 3 t;") + box("lintel", 11.2, z=1, width=3, height=0.2, more="mass 1 t;")
                   + box("prop", 12.5, width=0.1, height=1, more="mass 20 kg;"))
        rows = self.run_plan(propped, self.EQUILIBRIUM, "  task strike { by c; remove prop; takes 1 min; }\n", exit_code=1)
        self.assertEqual(rows["strike"]["reason"], "prop cannot be taken away: without it lintel would turn on wall")

    def test_what_cannot_balance_at_the_beginning(self):
        tower = (box("foot", 10, height=1, more="mass 1 t;") + box("middle", 10.4, z=1, height=1, more="mass 1 t;")
                 + box("top", 10.8, z=2, height=1, more="mass 1 t;"))
        look = "  task look { by c; takes 1 min; }\n"
        self.run_plan(tower, look.replace("by c; ", ""))
        rows = self.run_plan(tower, look, self.EQUILIBRIUM, box("b", 0, more="mass 1 t;"), move("on_top", "b", 10.8, 3), exit_code=1,
                             warns="at the beginning middle does not stand: middle would turn on foot, and top with it")
        self.assertEqual(rows["on_top"]["reason"], "b does not stand: it rests on top, which does not stand")

    def test_what_did_not_stand_at_the_beginning_is_judged_where_it_is_put(self):
        walls = box("wall", 10, height=1, more="mass 3 t;") + box("pier", 20, height=1, more="mass 3 t;")
        beam = box("beam", 11.2, z=1, width=3, height=0.2, more="mass 1 t;")
        warns = "at the beginning beam does not stand: beam would turn on wall"
        rows = self.run_plan(walls, beam, self.EQUILIBRIUM, move("again", "beam", 21.2, 1), exit_code=1, warns=warns)
        self.assertEqual(rows["again"]["reason"], "beam cannot be let go: beam would turn on pier")
        rows = self.run_plan(walls, beam, self.EQUILIBRIUM, move("flat", "beam", 20, 1), box("b", 0, more="mass 1 t;"),
                             move("on_top", "b", 20, 1.2, "after flat;"), warns=warns)
        self.assertEqual([rows["flat"]["result"], rows["on_top"]["result"]], ["done", "done"])

    def test_what_only_rests_on_what_turns_comes_with_it(self):
        # The motion with the fewest parts leaves `right` in the air: its own question, without any contact, crashed the library.
        pier = "  component {0} {{ shape box({1}); at trans({2}); mass {3} t; }}\n".format
        things = (pier("pier", "-0.3, -0.4, 0, 0.3, 0.4, 0.3", "18, 0, 0", 1) + pier("beam", "-1.5, -0.3, 0, 1.5, 0.3, 0.3", "19.3, 0, 0.3", 2)
                  + pier("left", "-0.5, -0.3, 0, 0.5, 0.3, 0.3", "18.7, 0.3, 0.6", 0.5)
                  + pier("right", "-0.5, -0.5, 0, 0.5, 0.5, 0.3", "20, 0, 0.6", 0.5))
        turns = "beam would turn on pier, and left, right with it"
        self.run_plan(things, self.EQUILIBRIUM, "  task look { by c; takes 1 min; }\n", warns=f"beam does not stand: {turns}")
        self.assertIn(f"right does not stand: {turns}", self.rubicon("check", "site.plan").stderr)
        # It rests on two beams, and each turns by itself.
        two = (pier("a", "-0.3, -0.3, 0, 0.3, 0.3, 3", "10, 0, 0", 5) + pier("beam_a", "-0.5, -0.3, 0, 2.5, 0.3, 0.3", "10, 0, 3", 1)
               + pier("b", "-0.3, -0.3, 0, 0.3, 0.3, 3", "16, 0, 0", 5) + pier("beam_b", "-2.5, -0.3, 0, 0.5, 0.3, 0.3", "16, 0, 3", 1)
               + pier("top", "-1.5, -0.3, 0, 1.5, 0.3, 0.3", "13, 0, 3.3", 0.1))
        self.run_plan(two, self.EQUILIBRIUM, "  task look { by c; takes 1 min; }\n", warns="beam_a does not stand: beam_a would turn on a")
        self.assertIn("top does not stand: beam_a would turn on a, and top with it", self.rubicon("check", "site.plan").stderr)

    def test_what_has_no_weight_is_judged_by_its_middle(self):
        panel = box("stack", 10, height=1, more="mass 3 t;") + box("panel", 0, width=3, height=0.2, more="fixed to site;")
        rows = self.run_plan(panel, self.EQUILIBRIUM, move("store", "panel", 11.9, 1), exit_code=1)
        self.assertIn("its centre of mass is", rows["store"]["reason"])

    def test_friction_and_the_second_opinion(self):
        # The coefficient is 0.5.
        for slope, words in ((0.45, ""), (0.6, "at the beginning sheet does not stand: sheet would slide on ramp")):
            ramp = (f"  component ramp {{ shape prism(-0.5, 0.5, 0, 0, 4, 0, 4, {4 * slope}) at rotx(90); at trans(10, 0, 0); "
                    f"mass 8 t; }}\n  component sheet {{ shape prism(-0.4, 0.4, 0, 0, 1, {slope}, 1, {slope + 0.2}, 0, 0.2) "
                    f"at rotx(90); at trans(11, 0, {slope + 0.001}); mass 1 t; }}\n")
            self.run_plan(ramp, self.EQUILIBRIUM, "  task look { by c; takes 1 min; }\n", warns=words)
        # What verify is told to be heavier than it was.
        self.run_plan(box("wall", 10, height=1, more="mass 3 t;") + box("beam", 10.4, z=1, width=3, height=0.2, more="mass 1 t;"),
                      box("load", 0, width=0.4, height=0.5, more="mass 60 kg;") + move("set", "load", 11.5, 1.2), self.EQUILIBRIUM)
        trace = os.path.join(self.folder, "out", "trace.jsonl")
        with open(trace, encoding="utf-8") as file:
            text = file.read()
        with open(trace, "w", encoding="utf-8") as file:
            header, rest = text.split("\n", 1)
            header = json.loads(header)
            next(each for each in header["components"] if each["name"] == "load")["mass"] = 5000
            file.write(json.dumps(header) + "\n" + rest)
        verdict = self.rubicon("verify", "out")
        self.assertEqual(verdict.returncode, 1)
        self.assertIn("do not stand: their weights cannot be balanced", verdict.stdout)

    def test_mistakes(self):
        for text, words in (("  support maybe;\n", "support is on, warn, off or equilibrium, found 'maybe'"),
                            ("  support on;\n  support off;\n", "support is given twice"),
                            ("  support off;\n  support equilibrium;\n",
                             "support off and support equilibrium contradict each other"),
                            ("  support equilibrium;\n" + box("b", 0),
                             "component 'b' has no mass, which support equilibrium needs"),
                            ("  support gap 2 m;\n", "support gap must be between 0 and 0.5, found 2"),
                            (box("b", 0, more="fixed to walls;"), "unknown component 'walls'"),
                            (box("b", 0, more="fixed to site after T;"), "unknown task 'T'"),
                            (box("b", 0, more="fixed to site after;"), "expected the name of a task after 'after'"),
                            (box("b", 0, more="fixed to c;"), "a component is fixed to a component or to site; 'c' is a crew"),
                            (box("b", 0, more="braced by b;"), "component 'b' is braced by itself")):
            self.write("site.plan", "plan site {\n" + HEAD + "  crew c;\n  task t { by c; takes 1 s; }\n" + text + "}\n")
            check = self.rubicon("check", "site.plan")
            self.assertEqual(check.returncode, 2, text)
            self.assertIn(words, check.stdout + check.stderr)


if __name__ == "__main__":
    unittest.main()
