"""Dates of tasks: not_before, due, baselines and floats in the run, its table and files; and verify, which finds what is wrong."""

import csv
import os
import re
import unittest

from result_case import ResultCase, rubicon

HOUR = 3600

# Steel comes at 10:00; dig could have been an hour later, the fence all day.
CREWS = """
plan crews {
  start_at "2026-03-02 07:00";
  calendar day { mon-fri 07:00-16:00; }
  crew diggers { calendar day; } crew fixers { calendar day; } crew fencers { calendar day; }
  task dig { by diggers; takes 4 h; }
  task steel { by fixers; takes 2 h; not_before "2026-03-02 10:00"; due "2026-03-02 14:00";
    baseline "2026-03-02 08:00" to "2026-03-02 10:00"; }
  task pour { by fixers; takes 3 h; after dig, steel; due "2026-03-02 14:30"; baseline 3 h to 7 h; }
  task fence { by fencers; takes 1 h; due 2 h; }
  task done { after pour, fence; due 7 h; }
}
"""

# A machine that has to wait for a delivery, and a crew that could begin at any time before it is needed.
SITE = """
plan site {
  robot cart "ROBOTS/cart.robot" { start x -20, y -12; }
  crew masons { size 3; }
  task go { by cart; go x -12, y -12; within x 0.5, y 0.5; not_before 10 min; }
  task a { takes 10 min; needs 2 masons; }
  task b { by cart; go x -20, y -12; within x 0.5, y 0.5; after go, a; }
}
"""

# Of two masons one is wanted again at 10 h: who built the walls. Who has not worked yet takes the stairs.
MASONS = """
plan masons {
  crew masons { size SIZE; }
  task walls { takes 1 h; needs 1 masons; }
  task stairs { takes 8 h; needs 1 masons; not_before 2 h; }
  task roof { takes 2 h; needs 1 masons; not_before 10 h; }
}
"""


# A schedule of others: pour has a baseline of its own, dig only its dates.
SCHEDULE = """<?xml version="1.0" encoding="UTF-8"?>
<Project xmlns="http://schemas.microsoft.com/project"><Name>hall</Name><StartDate>2026-03-02T07:00:00</StartDate><Tasks>
<Task><UID>1</UID><ID>1</ID><Name>dig</Name><Start>2026-03-02T07:00:00</Start><Finish>2026-03-02T11:00:00</Finish>
<Duration>PT5H0M0S</Duration><Deadline>2026-03-02T11:30:00</Deadline></Task>
<Task><UID>2</UID><ID>2</ID><Name>pour</Name><Start>2026-03-02T12:00:00</Start><Finish>2026-03-02T14:00:00</Finish>
<Duration>PT2H0M0S</Duration><PredecessorLink><PredecessorUID>1</PredecessorUID><Type>1</Type></PredecessorLink>
<Baseline><Number>1</Number><Start>2026-02-02T09:00:00</Start><Finish>2026-02-02T11:00:00</Finish></Baseline>
<Baseline><Number>0</Number><Start>2026-03-02T11:00:00</Start><Finish>2026-03-02T13:00:00</Finish></Baseline></Task>
</Tasks></Project>
"""


class Dates(ResultCase):
    def test_a_task_waits_for_its_date_and_says_so(self):
        schedule, tasks = self.run_plan(CREWS)
        self.assertEqual(tasks["steel"]["start"], 3 * HOUR)
        self.assertEqual(tasks["steel"]["waited"]["predecessor"], 3 * HOUR)
        self.assertEqual(schedule["critical"][0]["text"],
                         "steel starts at its not_before, 3 h after the beginning of the plan")
        self.assertEqual([step["task"] for step in schedule["critical"]], ["steel", "pour"])

    def test_dates_come_back_over_a_schedule_of_the_plan(self):
        _, tasks = self.run_plan(CREWS)
        plan, schedule_file, again = (os.path.join(self.folder, name) for name in ("p.plan", "crews.xml", "again.plan"))
        exported = rubicon("export", plan, "--mspdi", schedule_file)
        self.assertEqual((exported.returncode, exported.stderr), (0, ""))
        self.assertEqual(rubicon("import", schedule_file, "--out", again).returncode, 0)
        with open(again, encoding="utf-8") as file:
            _, back = self.run_plan(file.read())
        self.assertEqual({name: back[name]["start"] for name in tasks}, {name: task["start"] for name, task in tasks.items()})

    def test_dates_without_quotes_are_the_same_dates(self):
        bare = re.sub(r'"(2026-[^"]*)"', r"\1", CREWS)
        self.assertNotEqual(bare, CREWS)
        self.assertEqual(self.run_plan(bare)[1], self.run_plan(CREWS)[1])
        plan = os.path.join(self.folder, "bare.plan")
        with open(plan, "w", encoding="utf-8") as file:
            file.write(bare)
        self.assertEqual(rubicon("fmt", plan).returncode, 0)
        with open(plan, encoding="utf-8") as file:
            self.assertIn("not_before 2026-03-02 10:00;", file.read())

    def test_late_tasks_and_baselines_are_listed(self):
        _, tasks = self.run_plan(CREWS)
        late = {name: task.get("late") for name, task in tasks.items()}
        self.assertEqual(late, {"dig": None, "steel": 0, "pour": HOUR / 2, "fence": 0, "done": HOUR})
        self.assertEqual(tasks["steel"]["baseline"],
                         {"start": HOUR, "finish": 3 * HOUR, "begins": "2026-03-02 08:00", "ends": "2026-03-02 10:00"})
        lines = [line.split() for line in self.run_result.stdout.splitlines()]
        self.assertIn(["pour", "2026-03-02", "14:30", "2026-03-02", "15:00", "0:30:00"], lines)
        self.assertIn(["fence", "2026-03-02", "09:00", "2026-03-02", "08:00", "in", "time"], lines)
        self.assertIn(["steel", "2026-03-02", "10:00", "2026-03-02", "12:00", "2:00:00", "later"], lines)
        self.assertIn("2 of 2 tasks with a baseline finish later than planned", self.run_result.stdout)

    def test_tasks_that_are_not_done_stay_in_the_baseline(self):
        self.run_plan("""plan p { crew c; component a { shape box(0, 0, 0, 1, 1, 1); }
          task x { by c; remove a; takes 1 h; }
          task y { by c; remove a; takes 1 h; baseline 1 h to 2 h; after x; }
        }""", expected=1)
        self.assertIn(["y", "2:00:00", "rejected"], [line.split() for line in self.run_result.stdout.splitlines()])
        self.assertIn("0 of 1 tasks with a baseline finish later than planned, 1 are not done\n", self.run_result.stdout)

    def test_floats(self):
        _, tasks = self.run_plan(CREWS)
        floats = {name: (task["float"]["total"] / HOUR, task["float"]["free"] / HOUR) for name, task in tasks.items()}
        self.assertEqual(floats, {"dig": (1, 1), "steel": (0, 0), "pour": (0, 0), "fence": (7, 7), "done": (0, 0)})
        self.assertEqual(tasks["fence"]["float"]["latest_start"], 7 * HOUR)
        with open(os.path.join(self.out, "schedule.csv"), encoding="utf-8", newline="") as file:
            rows = {row["task"]: row for row in csv.DictReader(file)}
        self.assertEqual((rows["fence"]["total_float"], rows["pour"]["late"]), ("25200", "1800"))

    def test_floats_of_people_who_have_not_worked_yet(self):
        for size, walls in ((1, 1), (2, 9), (3, 11), (20, 11)):
            with self.subTest(size=size):
                _, tasks = self.run_plan(MASONS.replace("SIZE", str(size)))
                floats = {name: (task["float"]["total"] / HOUR, task["float"]["free"] / HOUR) for name, task in tasks.items()}
                stairs = 2 if size > 1 else 0
                self.assertEqual(floats, {"walls": (walls, walls), "stairs": (stairs, stairs), "roof": (0, 0)})
                self.assertEqual(rubicon("verify", self.out).returncode, 0)

    def test_floats_of_people_follow_the_order_in_which_tasks_got_them(self):
        # slab has the first choice, and so who has not worked yet
        _, tasks = self.run_plan("""plan p { crew c { size 2; } task walls { takes 1 h; needs 1 c; }
          task stairs { takes 1 h; needs 1 c; not_before 2 h; } task slab { takes 5 h; needs 1 c; not_before 2 h; priority 1; } }""")
        floats = {name: task["float"]["total"] / HOUR for name, task in tasks.items()}
        self.assertEqual(floats, {"walls": 5, "stairs": 4, "slab": 0})

    def test_a_schedule_of_others_is_the_baseline(self):
        schedule, plan, back = (os.path.join(self.folder, name) for name in ("hall.xml", "hall.plan", "back.xml"))
        with open(schedule, "w", encoding="utf-8") as file:
            file.write(SCHEDULE)
        plain = rubicon("import", schedule)
        self.assertNotIn("baseline", plain.stdout)
        imported = rubicon("import", schedule, "--baseline", "--out", plan)
        self.assertEqual(imported.returncode, 0, imported.stderr)
        with open(plan, encoding="utf-8") as file:
            _, tasks = self.run_plan(file.read())
        self.assertEqual((tasks["dig"]["late"], tasks["dig"]["baseline"]["finish"]), (HOUR / 2, 4 * HOUR))
        self.assertEqual(tasks["pour"]["baseline"]["begins"], "2026-03-02 11:00")
        self.assertIn("last finish  2026-03-02 13:00  2026-03-02 14:00  1:00:00 later", self.run_result.stdout)
        exported = rubicon("export", self.out, "--mspdi", back)
        self.assertEqual(exported.returncode, 0, exported.stderr)
        with open(back, encoding="utf-8") as file:
            text = "".join(file.read().split())
        self.assertIn("<Baseline><Number>0</Number><Start>2026-03-02T11:00:00</Start>"
                      "<Finish>2026-03-02T13:00:00</Finish></Baseline>", text)
        self.assertIn("<Deadline>2026-03-02T11:30:00</Deadline>", text)
        self.assertEqual(rubicon("import", back, "--baseline").returncode, 0)

    def test_a_machine_waits_for_its_date(self):
        schedule, tasks = self.run_plan(SITE)
        self.assertEqual(tasks["go"]["start"], 600)
        self.assertEqual(tasks["go"]["float"]["total"], 0)
        # the crew is done when the cart begins, and has the time that the cart takes
        self.assertAlmostEqual(tasks["a"]["float"]["total"], tasks["go"]["duration"], places=6)
        self.assertAlmostEqual(tasks["b"]["start"] + tasks["b"]["duration"], schedule["process_time"], places=6)

    def test_who_holds_what_the_task_before_needs_waits_for_its_finish(self):
        texts = {"x": "task x { by d; takes 3 h; }", "a": "task a { by cart; takes 2 h; after x; }", "b": "task b { by cart; takes 1 h; after a FF; }"}
        for order in ("bax", "xab"):
            _, tasks = self.run_plan('plan p { robot cart "ROBOTS/cart.robot" { start x -20, y -12; } crew d; %s }' % " ".join(texts[name] for name in order))
            self.assertEqual((tasks["a"]["start"], tasks["b"]["start"], tasks["b"]["waited"]["predecessor"]), (3 * HOUR, 5 * HOUR, 5 * HOUR))

    def test_verify_finds_dates_that_are_wrong(self):
        self.run_plan(CREWS)

        def task(result, name):
            return next(each for each in result.schedule["tasks"] if each["task"] == name)

        def cell(result, name, column, text):
            place = result.table[0].index(column)
            next(row for row in result.table if row[0] == name)[place] = text

        def float_of(name, **change):
            return lambda result: task(result, name)["float"].update(change)

        self.assertIn("late by 0:00:00, by the trace by 0:30:00",
                      self.faults_of(lambda result: task(result, "pour").update(late=0)))
        self.assertIn("due at another time", self.faults_of(lambda result: task(result, "pour").update(due=8 * HOUR)))
        self.assertIn("its baseline is another",
                      self.faults_of(lambda result: task(result, "steel")["baseline"].update(finish=5 * HOUR)))
        self.assertIn("it works for", self.faults_of(float_of("dig", total=2 * HOUR)))
        self.assertIn("holds up pour",
                      self.faults_of(float_of("dig", total=2 * HOUR, latest_start=2 * HOUR, latest_finish=6 * HOUR)))
        self.assertIn("above its total float", self.faults_of(float_of("dig", free=2 * HOUR)))
        self.assertIn("before its not_before", self.faults_of(
            lambda result: next(each for each in result.header["tasks"] if each["name"] == "steel").update(not_before=4 * HOUR)))
        self.assertIn("late by", self.faults_of(lambda result: cell(result, "pour", "late", "60")))
        self.assertIn("above its total float", self.faults_of(lambda result: cell(result, "dig", "total_float", "60")))

    def test_what_looks_ahead_to_a_motion_starts_after_it(self):
        # Nobody knows when the drive ends: neither the lead nor the finish-to-finish link is float of it.
        text = """plan lead { parameter begins = 0 s; robot truck "ROBOTS/cart.robot" { start x -30, y 20; } crew masons; crew others;
          task drive { by truck; go x -20; not_before begins; } task other { by others; takes 2 h; } task wall { by masons; takes 4 h; after drive %s, other FS; } }"""
        for link in ("FS - 48 min", "FF + 3 min"):
            schedule, tasks = self.run_plan(text % link)
            latest = tasks["drive"]["float"]["latest_finish"]
            self.assertAlmostEqual(latest, 2 * HOUR, 6, link)
            later, _ = self.run_plan(text % link, options=("--set", "begins=%d s" % (tasks["drive"]["float"]["latest_start"] // 1)))
            self.assertEqual(later["process_time"], schedule["process_time"], link)

    def test_verify_finds_a_wrong_latest_start(self):
        _, tasks = self.run_plan("""plan late { start_at "2026-03-02 07:00"; calendar day { mon-fri 07:00-16:00; }
          crew a { calendar day; } crew b { calendar day; } crew c;
          task long { by a; takes 16 h; } task short { by b; takes 2 h; } task night { by c; takes 2 h; } task end { after long, short; } }""")
        latest = {name: tasks[name]["float"]["latest_start"] / HOUR for name in tasks}
        self.assertEqual(latest, {"long": 0, "short": 29, "night": 29, "end": 31})

        def moved(name, to):
            def change(result):
                next(each for each in result.schedule["tasks"] if each["task"] == name)["float"]["latest_start"] = to
            return change

        # The second day begins after 24 h; the last is in the night before it.
        for name, to in (("long", 2), ("end", 31 * HOUR - 1), ("night", 29 * HOUR + 1), ("short", 29 * HOUR + 2), ("short", 29 * HOUR - 2),
                         ("short", 20 * HOUR)):
            self.assertIn("its latest start is", self.faults_of(moved(name, to)), (name, to))


if __name__ == "__main__":
    unittest.main()
