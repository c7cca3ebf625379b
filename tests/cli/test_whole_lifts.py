"""Lifts that are held whole: nothing hangs on a hook out of working time, and the answers say why a lift waits."""

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
    shape box(-0.2, -0.2, 0, 0.2, 0.2, 1);
  }
  tool hoist;
  behaviour "g.motion";
}
"""
SCRIPT = """which {
  place: chain { move_to(x, goal(x)) }; chain { move_to(z, goal(z)) };
  transport: chain { move_to(z, 8) }; chain { move_to(x, goal(x)) };
  default: chain { move_to(x, goal(x)) }; chain { move_to(z, goal(z)) };
};
"""
SITE = "calendar site { mon-fri 07:00-12:00, 12:30-16:00; }\n"
DAY = "2026-03-02"  # a Monday
FRIDAY = "2026-03-06"


def rubicon(*arguments):
    return subprocess.run([RUBICON, *arguments], capture_output=True, text=True, timeout=120)


def crate(name, x, y=0):
    return (f"component {name} {{ shape box(-0.5, -0.5, 0, 0.5, 0.5, 2); at trans({x}, {y}, 0); grip trans(0, 0, 2); "
            "mass 1 t; }\n")


def seconds(clock, day=0):
    hours, minutes = clock.split(":")
    return day * 86400 + int(hours) * 3600 + int(minutes) * 60


class WholeLifts(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = self.temporary.name
        for name, text in (("g.robot", ROBOT), ("g.motion", SCRIPT)):
            self.write(name, text)

    def tearDown(self):
        self.temporary.cleanup()

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def run_plan(self, body, begin=f"{DAY} 07:00", expect=0, calendars=SITE):
        """Runs a plan, has its result verified; its output, tasks of its schedule by name, trace."""
        plan = self.write("p.plan", f'plan p {{ start_at "{begin}";\n{calendars}{body}}}\n')
        self.out = os.path.join(self.folder, "out")
        run = rubicon("run", plan, "--out", self.out)
        self.assertEqual(run.returncode, expect, run.stdout + run.stderr)
        verdict = rubicon("verify", self.out)
        self.assertEqual(verdict.returncode, 0, verdict.stdout + verdict.stderr)
        with open(os.path.join(self.out, "schedule.json"), encoding="utf-8") as file:
            schedule = json.load(file)
        with open(os.path.join(self.out, "trace.jsonl"), encoding="utf-8") as file:
            records = [json.loads(line) for line in file]
        return run, {task["task"]: task for task in schedule["tasks"]}, records

    def hanging(self, records, task):
        """From when to when something hangs on the hook of a task."""
        return tuple(next(r["t"] for r in records if r["type"] == kind and r["task"] == task)
                     for kind in ("attach", "detach"))

    def one_lift(self, items, **others):
        return self.run_plan('robot g "g.robot" { calendar site; }\ncrew c { calendar site; }\n' + crate("a", 10)
                             + f"task lift {{ by g; move a to trans(20, 0, 0); {items} }}\n", **others)

    def test_a_lift_that_does_not_fit_before_lunch_waits(self):
        run, tasks, records = self.one_lift("hook 4 min by c; release 8 min by c;", begin=f"{DAY} 11:50")
        why = "starts 12:30: 12 min 22 s do not fit before 12:00"
        self.assertEqual(tasks["lift"]["lift"]["why"], why)
        self.assertEqual(tasks["lift"]["lift"]["from"], 40 * 60)
        self.assertEqual(tasks["lift"]["lift"]["overtime"], 0)
        self.assertIn(why, run.stdout)
        begin, end = self.hanging(records, "lift")
        self.assertTrue(44 * 60 <= begin < end <= 53 * 60, (begin, end))
        pause = next(r for r in records if r["type"] == "pause")
        self.assertEqual((pause["why"], pause["for"]), ("lift", "12 min 22 s do not fit before 12:00"))
        told = rubicon("why", self.out, "lift")
        self.assertIn("starts 2026-03-02 12:30:00: 12 min 22 s do not fit before 12:00", told.stdout)
        with open(os.path.join(self.out, "report.html"), encoding="utf-8") as file:
            self.assertIn("rubicon-schedule", file.read())

    def test_nothing_hangs_over_a_weekend(self):
        run, tasks, records = self.one_lift("hook 2 min; adjust 20 min by c;", begin=f"{FRIDAY} 15:53")
        self.assertIn("starts Mon 07:00: 22 min 22 s do not fit before Fri 16:00", run.stdout)
        monday = seconds("07:00", 3) - seconds("15:53")
        self.assertEqual(tasks["lift"]["lift"]["from"], monday)
        self.assertGreater(self.hanging(records, "lift")[0], monday)

    def test_a_lift_without_hook_work_waits_before_it_is_picked_up(self):
        _, tasks, records = self.one_lift("adjust 20 min by c;", begin=f"{DAY} 11:50")
        self.assertEqual(self.hanging(records, "lift")[0], 40 * 60)
        self.assertEqual(tasks["lift"]["waited"]["shift"], 40 * 60 - 13)

    def test_what_ends_with_the_shift_does_not_wait(self):
        # 10 m to the crate, 3 m down; 6 m up, 10 m over, 8 m down (2 m above the ground at its grip)
        _, tasks, records = self.one_lift("hook 1 min by c;", begin=f"{DAY} 11:00")
        end = self.hanging(records, "lift")[1]
        rest = int(seconds("12:00") - seconds("11:00") - end)
        self.assertEqual(end, int(end))
        _, tasks, records = self.one_lift(f"hook {60 + rest} s by c;", begin=f"{DAY} 11:00")
        self.assertEqual(self.hanging(records, "lift")[1], 3600)
        self.assertNotIn("lift", tasks["lift"])
        _, tasks, records = self.one_lift(f"hook {61 + rest} s by c;", begin=f"{DAY} 11:00")
        self.assertEqual(tasks["lift"]["lift"]["from"], 90 * 60)

    def test_a_lift_that_would_begin_with_the_end_of_a_shift_waits(self):
        """The tool is at the grip when the shift ends: nothing begins any more."""
        _, tasks, records = self.run_plan(
            'robot g "g.robot" { start x 10, z 2; calendar site; }\n' + crate("a", 10)
            + "task rest { by g; takes 1 h; }\ntask lift { by g; move a to trans(20, 0, 0); after rest; }\n",
            begin=f"{DAY} 11:00")
        self.assertEqual(self.hanging(records, "lift")[0], 90 * 60)
        self.assertNotIn("lift", tasks["lift"])

    def test_what_fits_into_no_shift_is_rejected(self):
        run, tasks, _ = self.one_lift("hook 3 h by c; release 3 h by c;", expect=1)
        self.assertIn("its lift fits into no shift: it takes 6 h 22 s (motion 22 s, crew work 6 h), and the longest shift "
                      "of all that it needs, Mon 07:00-12:00, has 5 h", tasks["lift"]["reason"])
        self.assertIn("fits into no shift", run.stdout)

    def test_a_longer_shift_later_is_waited_for(self):
        _, tasks, _ = self.one_lift("hook 2 h by c; release 2 h by c;", begin=f"{DAY} 12:00")
        self.assertEqual(tasks["lift"]["lift"]["from"], 19 * 3600)
        self.assertEqual(tasks["lift"]["lift"]["why"], "starts 07:00: 4 h 22 s do not fit before 16:00")

    def test_whole_off_and_carry_over_let_it_hang(self):
        for items, calendars, warned in (("whole off;", SITE, False),
                                         ("", SITE.replace("16:00;", "16:00; carry_over;"), True)):
            with self.subTest(items=items):
                run, tasks, records = self.one_lift("hook 4 min by c; release 8 min by c; " + items,
                                                    begin=f"{DAY} 11:50", calendars=calendars)
                begin, end = self.hanging(records, "lift")
                self.assertLess(begin, 10 * 60)
                self.assertGreater(end, 40 * 60)
                self.assertNotIn("lift", tasks["lift"])
                self.assertEqual("P36 warning" in run.stderr or "carry_over" in run.stderr, warned, run.stderr)
        plan = 'whole off;\nrobot g "g.robot" { calendar site; }\ncrew c { calendar site; }\n' + crate("a", 10)
        lift = "task lift {{ by g; move a to trans(20, 0, 0); hook 4 min by c; release 8 min by c; {} }}\n"
        _, tasks, _ = self.run_plan(plan + lift.format(""), begin=f"{DAY} 11:50")
        self.assertNotIn("lift", tasks["lift"])
        _, tasks, _ = self.run_plan(plan + lift.format("whole on;"), begin=f"{DAY} 11:50")
        self.assertIn("lift", tasks["lift"])

    def critical_path(self):
        with open(os.path.join(self.out, "schedule.json"), encoding="utf-8") as file:
            return [step["text"] for step in json.load(file)["critical"]]

    def test_the_critical_path_names_the_shift_and_what_it_takes_to_catch_the_one_before(self):
        def end_of(lay):
            _, tasks, _ = self.run_plan(
                'robot g "g.robot" { calendar site; }\ncrew c { calendar site; }\n' + crate("a", 10)
                + f"task lay {{ by c; takes {lay} s; }}\n"
                + "task lift { by g; move a to trans(20, 0, 0); hook 80 min by c; after lay; }\n", begin=f"{DAY} 07:00")
            return tasks["lift"]["start"] + tasks["lift"]["duration"]

        lay = 4 * 3600
        end = end_of(lay)
        path = self.critical_path()
        self.assertEqual(path[0], "lay starts with the plan")
        found = re.fullmatch(r"lift starts after lay \(FS\), then waits (\d+) h (\d+) min (\d+) s for the next shift "
                             r"\(less than (\d+) min (\d+) s sooner gains nothing\)", path[1])
        self.assertTrue(found, path[1])
        hours, minutes, rest, gain, gain_rest = map(int, found.groups())
        # The hoist is there 13 s after the crew is done; 12:30 is 5 h 30 min after the beginning.
        self.assertEqual(hours * 3600 + minutes * 60 + rest, 90 * 60 - 13)
        gain = gain * 60 + gain_rest
        self.assertEqual(end_of(lay - gain + 2), end)
        self.assertLess(end_of(lay - gain - 2), end - 80 * 60)

    def test_the_critical_path_leads_to_who_made_a_lift_miss_its_shift(self):
        def end_of(busy, hook=240, begin="07:00"):
            run, tasks, _ = self.run_plan(
                'robot g "g.robot" { calendar site; }\ncrew c { calendar site; }\ncrew d;\n' + crate("a", 10)
                + f"task busy {{ by d; takes {busy} s; }}\n"
                + f"task lift {{ by g; move a to trans(20, 0, 0); hook {hook} min by c; release 10 min by d; }}\n",
                begin=f"{DAY} {begin}")
            self.said = run.stdout
            return tasks["lift"]["start"] + tasks["lift"]["duration"]

        busy = 4 * 3600 + 52 * 60
        late = end_of(busy)
        path = self.critical_path()
        self.assertEqual(path[0], "busy starts with the plan")
        found = re.fullmatch(r"lift misses a shift waiting for 'd', which busy had, then waits .* for the next shift "
                             r"\(less than (\d+) min sooner gains nothing\)", path[1])
        self.assertTrue(found, path)
        self.assertIn("waiting for others (last for 'd', which busy had), do not fit before 12:00", self.said)
        self.assertEqual(end_of(busy - int(found[1]) * 60 + 1), late)
        self.assertLess(end_of(busy - int(found[1]) * 60), late - 4 * 3600)
        # Another crew, or another time, is a fault.
        end_of(busy)
        file = os.path.join(self.out, "schedule.json")
        with open(file, encoding="utf-8") as json_file:
            text = json_file.read()
        for said in ("waiting for 'c', which busy", "waiting for 'd', which lift"):
            with open(file, "w", encoding="utf-8") as json_file:
                json_file.write(text.replace("shift waiting for 'd', which busy", "shift " + said))
            self.assertEqual(rubicon("verify", self.out).returncode, 1)
        # One that is too long for the rest of the morning misses it by itself.
        end_of(busy - 3600, hook=235, begin="08:00")
        self.assertNotIn("misses", self.critical_path()[-1])

    def test_less_sooner_goes_back_to_a_shift_into_which_the_lift_fits(self):
        def run(lay, hook, begin="07:00"):
            _, tasks, _ = self.run_plan(
                'robot g "g.robot" { calendar site; }\ncrew c { calendar site; }\ncrew d;\n' + crate("a", 10)
                + f"task lay {{ by d; takes {lay} s; }}\n"
                + f"task lift {{ by g; move a to trans(20, 0, 0); hook {hook} min by c; after lay; }}\n", begin=f"{FRIDAY} {begin}",
                calendars="calendar site { mon-fri 07:00-12:00, 12:30-15:00; }\n")
            return tasks["lift"]["start"] + tasks["lift"]["duration"]

        # The afternoon is too short for 160 min. At 11:59:55 the hoist sets out, and comes after the end of the shift.
        for lay, hook in ((seconds("5:41"), 160), (seconds("5:00") - 5, 160), (seconds("5:00") - 5, 20)):
            end = run(lay, hook)
            found = re.search(r"less than (?:(\d+) h )?(\d+) min (\d+) s sooner gains nothing", self.critical_path()[1])
            self.assertTrue(found, self.critical_path())
            hours, minutes, rest = (int(each or 0) for each in found.groups())
            gain = hours * 3600 + minutes * 60 + rest
            self.assertEqual(run(lay - gain + 2, hook), end)
            self.assertLess(run(lay - gain - 2, hook), end - 20 * 60)
        # What cannot be soon enough in this plan says nothing of it.
        run(60 * 60, 290, begin="08:00")
        self.assertIn("for the next shift", self.critical_path()[1])
        self.assertNotIn("sooner", self.critical_path()[1])

    def test_floats_keep_the_hours_of_riggers(self):
        # A gantry that works day and night and riggers by day; others work for 20 h, to Tuesday 03:00.
        for whole in ("", "whole off; "):
            def run(later):
                _, tasks, _ = self.run_plan(
                    'robot g "g.robot" { }\ncrew c { calendar site; }\ncrew d;\n' + crate("a", 10) + "task others { by d; takes 20 h; }\n"
                    + f"task lift {{ by g; move a to trans(20, 0, 0); {whole}hook 30 min by c; release 20 min by c; not_before {later} s; }}\n")
                return tasks["lift"], max(each["start"] + each["duration"] for each in tasks.values())

            lift, end = run(0)
            self.assertEqual((lift["float"]["latest_finish"], end), (9 * 3600, 20 * 3600))
            latest = lift["float"]["latest_start"]
            self.assertEqual((run(latest)[1], run(latest + 1)[1] > 24 * 3600), (20 * 3600, True))
            # In the night before it waits for the riggers, and is as early as it can be.
            lift, end = run(20 * 3600)
            self.assertEqual((lift["float"]["total"], lift["float"]["latest_start"]), (0, 20 * 3600))

    def test_what_is_at_its_goal_needs_no_shift(self):
        self.write("g.motion", "chain { move_to(x, goal(x)) }; chain { move_to(z, goal(z)) };")
        _, tasks, records = self.one_lift("whole off; hook 3585 s;", begin=f"{FRIDAY} 15:00")
        # The carrying motion ends after the shift, and there is nothing left to place.
        self.assertEqual(self.hanging(records, "lift"), (3598, 3608))
        self.assertEqual(tasks["lift"]["duration"], 3608)

    def test_the_lunch_of_a_crew_counts_from_hook_to_release(self):
        """The crew that releases eats at 11:00, the robot and who hooks at 12:00."""
        calendars = SITE + "calendar early { mon-fri 07:00-11:00, 11:30-16:00; }\n"
        plan = ('robot g "g.robot" { calendar site; }\ncrew c { calendar site; }\ncrew e { calendar early; }\n'
                + crate("a", 10) + "task lift { by g; move a to trans(20, 0, 0); hook 5 min by c; release 5 min by e; }\n")
        _, tasks, records = self.run_plan(plan, begin=f"{DAY} 10:53", calendars=calendars)
        self.assertEqual(tasks["lift"]["lift"]["from"], 37 * 60)
        self.assertEqual(tasks["lift"]["lift"]["why"], "starts 11:30: 10 min 22 s do not fit before 11:00")
        _, tasks, records = self.run_plan(plan, begin=f"{DAY} 11:10", calendars=calendars)
        self.assertEqual(tasks["lift"]["waited"]["shift"], 20 * 60 - 13)

    def test_a_day_off_is_no_shift(self):
        calendars = "calendar site { mon-fri 07:00-12:00, 12:30-16:00; off 2026-03-09; }\n"
        run, tasks, _ = self.one_lift("adjust 20 min by c;", begin=f"{FRIDAY} 15:53", calendars=calendars)
        self.assertEqual(tasks["lift"]["lift"]["from"], seconds("07:00", 4) - seconds("15:53"))
        self.assertIn("starts Tue 07:00", run.stdout)

    def test_a_lift_held_up_by_others_ends_in_overtime_but_not_over_night(self):
        plan = ('robot g "g.robot" { start x 10, z 2; calendar site; cost 60 per h; }\ncrew c { cost 60 per h; }\n'
                + crate("a", 10) + "task other { by c; takes %s; }\n"
                "task lift { by g; move a to trans(20, 0, 0); hook 10 min; release 5 min by c; }\n")
        run, tasks, records = self.run_plan(plan % "15 min", begin=f"{DAY} 11:30")
        self.assertNotIn("lift", tasks["lift"])
        calendars = "calendar site { mon-fri 07:00-12:00; }\n"
        run, tasks, records = self.run_plan(plan % "320 min", calendars=calendars)
        lift = tasks["lift"]["lift"]
        self.assertEqual((lift["from"], lift["overtime"]), (0, 25 * 60))
        self.assertIn("25 min of overtime after 12:00: its load waited 5 h 9 min 38 s for others", run.stdout)
        self.assertEqual(tasks["lift"]["cost"], 60 * (5 + 25 / 60) + 5)
        told = rubicon("why", self.out, "lift")
        self.assertIn("overtime", told.stdout)
        run, tasks, records = self.run_plan(plan % "26 h", calendars=calendars)
        self.assertEqual(tasks["lift"]["lift"]["from"], seconds("07:00", 1) - seconds("07:00"))
        self.assertEqual(tasks["lift"]["lift"]["overtime"], 0)

    def test_two_cranes_share_riggers(self):
        body = ('robot l "g.robot" at trans(0, -20, 0) { calendar site; }\nrobot r "g.robot" at trans(0, 20, 0) '
                "{ calendar site; }\ncrew c { calendar site; }\n")
        for i in range(6):
            for name, y in (("l", -20), ("r", 20)):
                body += crate(f"{name}{i}", i * 3, y)
                body += (f"task {name}_{i} {{ by {name}; move {name}{i} to trans({40 - i * 3}, {y}, 0); hook 7 min by c; "
                         f"release 6 min by c; {f'after {name}_{i - 1};' if i else ''} }}\n")
        _, tasks, records = self.run_plan(body, begin=f"{DAY} 10:00")
        for name, task in tasks.items():
            begin, end = self.hanging(records, name)
            noon, one = 2 * 3600, 2.5 * 3600
            self.assertTrue(end <= noon or begin >= one, (name, begin, end))
        self.assertTrue(any("lift" in task for task in tasks.values()))

    def test_a_rejected_lift_leaves_no_mark(self):
        """What was delayed for a lift that is rejected in the end goes on as without it."""
        body = ('robot g "g.robot" { calendar site; }\ncrew c { calendar site; }\n' + crate("a", 10)
                + crate("b", 30) + crate("wall", 20)
                + "task lift { by g; move a to trans(20, 0, 0); hook 6 min by c; release 6 min by c; priority 1; }\n"
                + "task next { by g; move b to trans(40, 0, 0); hook 1 min by c; }\n")
        _, tasks, _ = self.run_plan(body, begin=f"{DAY} 11:50", expect=1)
        self.assertEqual(tasks["lift"]["result"], "rejected")
        self.assertEqual((tasks["next"]["start"], tasks["next"]["result"]), (0, "done"))
        self.assertNotIn("lift", tasks["next"])

    def test_the_same_plan_gives_the_same_bytes(self):
        bodies = []
        for _ in range(2):
            self.one_lift("hook 4 min by c; release 8 min by c;", begin=f"{DAY} 11:50")
            with open(os.path.join(self.out, "trace.jsonl"), "rb") as file:
                bodies.append(file.read())
        self.assertEqual(bodies[0], bodies[1])

    def test_mistakes(self):
        for items, message in (("whole maybe;", "whole is on or off, found 'maybe'"), ("whole; whole off;", "whole is given twice")):
            plan = self.write("m.plan", 'plan p { robot g "g.robot"; ' + crate("a", 10)
                              + f"task lift {{ by g; move a to trans(20, 0, 0); {items} }} }}\n")
            self.assertIn(message, rubicon("check", plan).stderr)
        plan = self.write("m.plan", 'plan p { robot g "g.robot"; task t { by g; go x 10; whole; } }\n')
        self.assertIn("whole is about a lift; task 't' has no move", rubicon("check", plan).stderr)


if __name__ == "__main__":
    unittest.main()
