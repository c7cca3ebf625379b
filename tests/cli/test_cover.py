"""Floors that a machine works over: the way, its pace, what verify makes of it, mistakes."""

import json
import os
import random
import unittest

from result_case import ResultCase, rubicon

RANDOM_PLANS = int(os.environ.get("RUBICON_RANDOM_PLANS", "12"))
GANTRY = """robot gantry {
  body bridge { param x range(-1, 41) step(0.5) speed(0.5 m/s); frame trans(x, 0, 0); shape box(-0.1, -1, 2, 0.1, 31, 2.2); }
  body beam on bridge { param y range(0, 30) step(0.5) speed(0.5 m/s) start(0.5); frame trans(0, y, 0.1);
                        shape box(-0.1, -0.1, 0, 0.1, 0.1, 2); }
  tool beam;
  behaviour { which { working: chain { line }; default: chain { move_to(y, goal(y)), move_to(x, goal(x)) };
                      } }
}
"""
DECK = "area deck { outline (0, 0), (8, 0), (8, 6), (0, 6); shaft (5, 2), (6, 2), (6, 3), (5, 3); column (2.5, 4), 0.3 m; }"
COVER = "cover deck { width 1 m; clearance 0.2 m; above 0.1 m; thickness 0.06 m; rate 30 m3 per h; }"


class Cover(ResultCase):
    def plan(self, cover=COVER, area=DECK, more=""):
        self.write("gantry.robot", GANTRY)
        return "plan p { robot g \"gantry.robot\"; %s task lay { by g; %s } %s }" % (area, cover, more)

    def of(self, schedule, name):
        return [task for task in schedule["tasks"] if task["task"] == name][0]

    def test_the_rate_sets_the_time_where_it_works(self):
        schedule, _ = self.run_plan(self.plan())
        lay = self.of(schedule, "lay")
        cover = lay["cover"]
        # 8 x 6 m less the shaft and the column, 6 cm of it.
        self.assertAlmostEqual(cover["covered"], 1, 9)
        self.assertAlmostEqual(cover["covered_area"], 48 - 1 - 0.09, 6)
        self.assertAlmostEqual(cover["volume"], (48 - 1 - 0.09) * 0.06, 6)
        self.assertGreaterEqual(cover["length"], cover["covered_area"])
        # Working at 30 / 3600 / 0.06 m/s, the rest at 0.5 m/s for each axis: between these.
        pace = 30 / 3600 / 0.06
        self.assertGreaterEqual(lay["duration"], cover["covered_area"] / 1 / pace)
        self.assertLessEqual(lay["duration"], cover["length"] / pace + 60)
        faster, _ = self.run_plan(self.plan(COVER.replace("30 m3", "60 m3")))
        self.assertLess(self.of(faster, "lay")["duration"], 0.6 * lay["duration"])
        fastest, _ = self.run_plan(self.plan("cover deck { width 1 m; clearance 0.2 m; above 0.1 m; }"))
        self.assertLess(self.of(fastest, "lay")["duration"], 0.45 * lay["duration"])
        self.assertNotIn("volume", self.of(fastest, "lay")["cover"])
        self.assertIn("lay     deck  46.9", self.run_result.stdout)

    def test_behaviours_know_where_they_work(self):
        _, _ = self.run_plan(self.plan())
        works = []
        with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
            header = json.loads(next(file))
            flags = header["tasks"][0]["cover"]["working"]
            for line in file:
                record = json.loads(line)
                if record["type"] == "goal":
                    works.append([flags[record["k"] - 1], set()])
                elif record["type"] == "try" and record["ok"]:
                    works[-1][1].add(record["command"])
        self.assertEqual(len(works), len(flags))
        self.assertFalse(flags[0], "on the way to its beginning it does not work")
        for working, commands in works:
            self.assertTrue(commands <= ({"line"} if working else {"move_to"}), commands)

    def test_verify_finds_a_pace_that_is_not_kept(self):
        self.run_plan(self.plan())
        path = os.path.join(self.out, "trace.jsonl")
        with open(path, encoding="utf-8") as file:
            lines = file.read().splitlines()
        header = json.loads(lines[0])
        for change in ("pace", "working"):
            changed = json.loads(lines[0])
            cover = changed["tasks"][0]["cover"]
            if change == "pace":
                cover["pace"] *= 0.9
            else:
                first = cover["working"].index(True)
                cover["working"][first] = False
            with open(path, "w", encoding="utf-8") as file:
                file.write("\n".join([json.dumps(changed), *lines[1:]]) + "\n")
            verified = rubicon("verify", self.out)
            self.assertEqual(verified.returncode, 1, change)
            self.assertIn("the step lasts", verified.stdout)
        # A waypoint that the tool has not been at.
        missed = json.loads(lines[0])
        missed["tasks"][0]["via"][3]["pose"][3] += 0.05
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join([json.dumps(missed), *lines[1:]]) + "\n")
        verified = rubicon("verify", self.out)
        self.assertEqual(verified.returncode, 1)
        self.assertIn("goes on with the tool 50.0 mm", verified.stdout)
        del header["tasks"][0]["cover"]["working"][0]
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join([json.dumps(header), *lines[1:]]) + "\n")
        self.assertEqual(rubicon("verify", self.out).returncode, 2)

    def test_what_is_in_the_way_is_named(self):
        # A stack of stones that the area knows nothing of.
        more = "component stones { shape box(-0.4, -0.4, 0, 0.4, 0.4, 0.6); at trans(4, 4.4, 0); }"
        schedule, _ = self.run_plan(self.plan(more=more), expected=1)
        reason = self.of(schedule, "lay")["reason"]
        self.assertRegex(reason, "^blocked by stones at step .*: g.beam meets stones; waypoint [0-9]+ of [0-9]+ over the floor is not reached: ")
        self.assertNotIn("covers", self.run_result.stdout)

    def test_a_tool_that_leaves_its_strip_has_not_covered_it(self):
        # One axis after the other is no strip where the strips are at a slant.
        area = "area deck { outline (1, 1), (9, 5), (7, 9), (-1, 5); }"
        cover = "cover deck { width 1 m; above 0.1 m; thickness 0.06 m; rate 30 m3 per h; }"
        gantry = GANTRY.replace("range(-1, 41)", "range(-5, 41)")
        self.plan()
        self.write("gantry.robot", gantry.replace("move_to(y, goal(y)), move_to(x, goal(x))", "line"))
        text = "plan p { robot g \"gantry.robot\"; %s task lay { by g; %s } }" % (area, cover)
        self.run_plan(text)
        path = os.path.join(self.out, "trace.jsonl")
        with open(path, encoding="utf-8") as file:
            lines = file.read().splitlines()
        self.write("gantry.robot", gantry.replace("working: chain { line }", "working: chain { move_to(x, goal(x)), move_to(y, goal(y)) }"))
        schedule, _ = self.run_plan(text, expected=1)
        self.assertRegex(self.of(schedule, "lay")["reason"], "the tool went [0-9]+ mm beside its strip on the way to waypoint .*; take line where it is working")
        # verify looks by itself: a strip that its trace does not follow.
        header = json.loads(lines[0])
        task = header["tasks"][0]
        first = task["cover"]["working"].index(True)
        records = [json.loads(line) for line in lines]
        steps = [i for i, record in enumerate(records) if record["type"] == "try" and record["ok"] and record["command"] == "line"]
        middle = records[steps[len(steps) // 2]]
        middle["q"]["bridge.x" if "bridge.x" in middle["q"] else "x"] += 0.05
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(json.dumps(record) for record in records) + "\n")
        self.assertIn("beside its strip", rubicon("verify", self.out).stdout)
        self.assertGreaterEqual(first, 1)

    def test_random_floors_are_covered_and_verified(self):
        chance = random.Random(17)
        for trial in range(RANDOM_PLANS):
            wide, deep = chance.randrange(6, 15), chance.randrange(5, 12)
            area = "area deck { outline (0, 0), (%d, 0), (%d, %d), (0, %d);" % (wide, wide, deep, deep)
            stones = ""
            if chance.random() < 0.5:
                x, y = chance.randrange(2, wide - 3), chance.randrange(2, deep - 2)
                area += " shaft (%d, %d), (%d, %d), (%d, %d), (%d, %d);" % (x, y, x + 1, y, x + 1, y + 1, x, y + 1)
            else:
                x, y = chance.uniform(2, wide - 2), chance.uniform(2, deep - 2)
                area += " %s (%.3f, %.3f), 0.4 m;" % (chance.choice(("column", "round_column")), x, y)
                stones = "component bars { shape box(-0.2, -0.2, 0, 0.2, 0.2, 0.8); at trans(%.3f, %.3f, 0); }" % (x, y)
            cover = "cover deck { width %.2f m; clearance 0.25 m; above 0.1 m; thickness 0.2 m; rate %d m3 per h; order %s; cold_joint after %d min; }" % (
                chance.uniform(0.8, 1.5), chance.randrange(20, 80), chance.choice(("cells", "shortest")), chance.randrange(2, 60))
            text = self.plan(cover, area + " }", stones)
            # Past the column in straight lines, not one axis after the other.
            self.write("gantry.robot", GANTRY.replace("move_to(y, goal(y)), move_to(x, goal(x))", "line"))
            schedule, _ = self.run_plan(text)
            self.assertGreater(self.of(schedule, "lay")["cover"]["covered"], 0.99, text)

    def test_mistakes_are_told_at_their_places(self):
        for area, cover, message in (
                ("area deck { height 1 m; }", COVER, "has no outline"),
                ("area deck { outline (0, 0), (8, 0), (0, 6), (8, 6); }", COVER, "crosses"),
                (DECK.replace("(2.5, 4)", "(12, 4)"), COVER, "column 1"),
                (DECK, "cover dek { width 1 m; }", "did you mean deck?"),
                (DECK, "cover deck { clearance 1 m; }", "does not say how wide"),
                (DECK, "cover deck { width 0 m; }", "width must be between"),
                (DECK, "cover deck { width 1 m; rate 30 m3 per h; }", "needs the thickness"),
                (DECK, "cover deck { width 1 m; thickness 0.1 m; rate 30; }", "30; }"),
                (DECK, "cover deck { width 1 m; thickness 0 m; rate 30 m3 per h; }", "thickness must be between"),
                (DECK, "cover deck { width 1 m; inlet (5.5, 2.5); }", "inlet"),
                (DECK, "cover deck { width 1 m; partition rooms; }", "partition is beams or min"),
                (DECK, COVER + " go x 1;", "neither moves nor goes"),
                (DECK, COVER + " via x 1;", "has its waypoints from that"),
                (DECK, COVER + COVER, "cover is given twice"),
                (DECK + DECK, COVER, "declared twice")):
            path = self.write("p.plan", self.plan(cover, area))
            checked = rubicon("check", path)
            self.assertEqual(checked.returncode, 2, area + cover)
            self.assertIn(message, checked.stderr)

    def test_of_two_links_from_a_task_the_one_that_held_is_told(self):
        schedule, _ = self.run_plan(self.plan(more="crew men; task finish { by men; takes 10 min; after lay SS + 2 min, lay FF + 1 min; }"))
        self.assertIn("lay (FF + 1 min)", schedule["critical_chain"][-1]["text"] if "critical_chain" in schedule else json.dumps(schedule))


if __name__ == "__main__":
    unittest.main()
