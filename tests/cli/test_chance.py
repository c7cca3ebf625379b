"""What chance has a part in: times that were measured, days that the weather takes, machines that break down."""

import datetime
import json
import os
import re
import subprocess
import unittest

from result_case import RUBICON, ResultCase, rubicon

HOIST = """robot hoist { body hook { param z range(0, 40) step(1) speed(0.5 m/s) start(5); frame trans(0, 0, z); shape box(-0.1, -0.1, 0, 0.1, 0.1, 0.5); }
  tool hook; behaviour { chain { move_to(z, goal(z)) } } }"""
BLOCK = "component c { shape box(-0.5, -0.5, 0, 0.5, 0.5, 1); at trans(0, 0, 0); grip trans(0, 0, 1); }"


class Chance(ResultCase):
    def setUp(self):
        super().setUp()
        self.write("hoist.robot", HOIST)

    def mistake(self, text):
        path = self.write("p.plan", text)
        result = rubicon("check", path)
        self.assertEqual(result.returncode, 2, result.stdout)
        return (result.stdout + result.stderr).replace(self.folder + "/", "")

    def study(self, items, plan, *arguments, expected=0):
        self.write("p.plan", plan)
        path = self.write("s.study", 'study s { plan "p.plan"; %s }' % items)
        self.result = rubicon("study", path, *arguments)
        self.assertEqual(self.result.returncode, expected, self.result.stdout + self.result.stderr)
        return self.result.stdout

    def variants(self, items, plan):
        study = json.loads(self.study(items, plan, "--format", "json"))
        names = [question["text"] if isinstance(question, dict) else question for question in study["questions"]]
        return [dict(zip(names, variant["answers"])) for variant in study["variants"]]


class Measured(Chance):
    PLAN = 'plan p { crew gang; task t { by gang; takes measured("times.csv", min, column "hook"); } task u { by gang; takes measured("times.csv", min, column 3); } }'
    TIMES = "lift,hook,release\n1,2.5,1\n2,3.5,2\n3,9,\n4,1,6\n"

    def test_means_and_draws(self):
        self.write("times.csv", self.TIMES)
        schedule, tasks = self.run_plan(self.PLAN)
        self.assertEqual([tasks["t"]["duration"], tasks["u"]["duration"]], [240, 180])
        self.assertIn("2 durations are not certain, and stand for their means", self.run_result.stdout)
        drawn = set()
        for run in range(12):
            _, tasks = self.run_plan(self.PLAN, options=("--sample", "1:%d" % run))
            drawn.add(tasks["t"]["duration"])
        self.assertEqual(drawn, {150, 210, 540, 60})

        def between(result):
            result.header["tasks"][0]["takes"][0]["duration"] = 180

        self.assertIn("takes takes 180 s, which measured does not allow", self.faults_of(between))

        def other_file(result):
            next(file for file in result.header["files"] if file["path"].endswith("times.csv"))["text"] += "5,4,4\n"

        self.assertIn("is not the one of its checksum", self.faults_of(other_file))

    def test_studies_know_the_file(self):
        self.write("times.csv", self.TIMES)
        out = os.path.join(self.folder, "out")
        items = "runs 400; seed 3; ask makespan;"
        answers = self.variants(items, self.PLAN)[0]["makespan"]
        # 4 min and 3 min on average; deviations 2.98 and 2.16 min.
        self.assertLess(abs(answers["mean"] - 420), 4 * 60 * (2.98**2 + 2.16**2) ** 0.5 / 20)
        self.assertGreaterEqual(answers["least"], 120)
        # What is left of a study that was stopped is of this file, and of no other.
        items = "runs 20000; seed 3; ask makespan;"
        self.write("s.study", 'study s { plan "p.plan"; %s }' % items)
        progress = os.path.join(out, "study.progress")
        process = subprocess.Popen([RUBICON, "study", os.path.join(self.folder, "s.study"), "--out", out, "--jobs", "1"], stdout=subprocess.DEVNULL)
        while process.poll() is None and not (os.path.exists(progress) and os.path.getsize(progress) > 1000):
            pass
        process.kill()
        process.wait()
        self.assertTrue(os.path.exists(progress))
        self.write("times.csv", self.TIMES + "5,4,4\n")
        self.study(items, self.PLAN, "--out", out, "--resume", expected=2)
        self.assertIn("the plan or one of its files has changed", self.result.stderr)
        self.write("times.csv", self.TIMES)
        self.study(items, self.PLAN, "--out", out, "--resume")

    def test_what_is_wrong_is_said_at_its_line(self):
        plan = 'plan p { task t { takes measured("times.csv", min%s); } }'
        for text, column, message in (
                ("min\n2\nn/a\n", "", "times.csv:3:1: error: expected a time, found 'n/a'"), ("2\n-1\n", "", "times.csv:2:1: error: a time is not below 0, found -1"),
                ("2\nnan\n", "", "times.csv:2:1: error: expected a time, found 'nan'"), ("", "", "times.csv:1:1: error: there is no time in this file"),
                ("2,5\n", "", "times.csv:1:1: error: this line has 2 fields; expected one time"),
                ("hook\n2,9\n3,9\n", ', column "hook"', "times.csv:2:1: error: this line has 2 fields, the first line has 1"),
                ("lift;hook\n1;2,5\n", ', column "hook"', "times.csv:2:3: error: expected a time, found '2,5'"),
                ("lift,hook\n1,2\n", ', column "hok"', "there is no column 'hok'; the first line has: lift, hook; did you mean hook?"),
                ("1,2\n", ", column 3", "there is no column 3; the first line has 2"), ("1\n" * 1000001, "", "times.csv:1000001:1: error: there are more than 1000000 times")):
            self.write("times.csv", text)
            found = self.mistake(plan % column)
            self.assertIn(message, found)
            self.assertRegex(found, r"see p\.plan:1:\d+: read for this duration")
        self.assertRegex(self.mistake('plan p { task t { takes measured("tims.csv", min); } }'), r'p\.plan:1:\d+: error: measured times .tims\.csv.: there is no such file; did you mean "times\.csv"\?')
        self.assertIn("measured does not say the unit of the times in the file", self.mistake('plan p { task t { takes measured("times.csv"); } }'))
        self.assertIn("unknown unit 'd' of measured times; expected s, min or h", self.mistake('plan p { task t { takes measured("times.csv", d); } }'))
        self.assertIn("the unit of the times is given twice", self.mistake('plan p { task t { takes measured("times.csv", h, s); } }'))
        self.assertIn("expected the number of a column from 1 to 10000, found 0", self.mistake('plan p { task t { takes measured("times.csv", h, column 0); } }'))
        self.assertIn("expected the name of a file of measured times in quotes", self.mistake("plan p { task t { takes measured(times, h); } }"))

    def test_in_a_plan_that_is_imported_and_in_a_dig(self):
        os.makedirs(os.path.join(self.folder, "part"))
        self.write("part/times.csv", "3\n5\n")
        self.write("part/part.plan", 'plan part { crew gang; task t { by gang; takes measured("times.csv", h); } }')
        _, tasks = self.run_plan('plan p { import "part/part.plan" as part; }')
        self.assertEqual(tasks["part.t"]["duration"], 4 * 3600)
        plan = """plan p { crew digger; crew trucks { size 2; }
          task pit { by digger; dig 40 m3 { load trucks takes measured("part/times.csv", min); bed 10 m3; haul takes 4 min; tip takes 1 min; } } }"""
        self.assertEqual(self.run_plan(plan)[1]["pit"]["duration"], 22 * 60)
        self.run_plan(plan, options=("--sample", "3"))


class Weather(Chance):
    PLAN = """plan p { start_at "2026-03-02 07:00"; parameter share = 0.2; parameter more = 0;
      calendar site { mon-fri 07:00-12:00, 13:00-16:00; off 2026-04-03; lost share; }
      calendar crane_days { mon-fri 07:00-12:00, 13:00-16:00; lost 2 * share; }
      crew gang { calendar site; } crew smiths { calendar site; } crew riggers { calendar crane_days; }
      task wall { by gang; takes 160 h; } task bars { by smiths; takes 200 h; } task props { by riggers; takes 100 h; }
      for i from 1 to more { task other[i] { by smiths; takes exponential(3 h); priority 5; } } }"""

    def days(self, schedule, calendar="site"):
        return next(each for each in schedule["lost_days"] if each["calendar"] == calendar)

    def test_a_lost_day_is_a_day_off(self):
        dry, tasks = self.run_plan(self.PLAN)
        self.assertEqual(dry["lost_days"], [])
        self.assertIn("no day is lost to the weather; --sample SEED draws them\n", self.run_result.stdout)
        wet, drawn = self.run_plan(self.PLAN, options=("--sample", "4"))
        lost = self.days(wet)
        self.assertGreater(lost["lost"], 2)
        self.assertEqual(lost["lost"], len(lost["dates"]))
        self.assertRegex(self.run_result.stdout, r"\nsite +%d +%d  %s\n" % (lost["lost"], lost["working_days"], ", ".join(lost["dates"])))
        # The same plan with these dates as days off, and no weather.
        off = self.PLAN.replace("off 2026-04-03; lost share;", "off 2026-04-03, %s;" % ", ".join(lost["dates"]))
        off = off.replace("lost 2 * share;", "off %s;" % ", ".join(self.days(wet, "crane_days")["dates"]))
        _, expected = self.run_plan(off)
        for name in tasks:
            self.assertEqual(drawn[name]["duration"], expected[name]["duration"])
        days = int(wet["process_time"] // 86400) + 1
        working = [day for day in (datetime.date(2026, 3, 2) + datetime.timedelta(n) for n in range(days)) if day.weekday() < 5 and str(day) != "2026-04-03"]
        self.assertEqual(lost["working_days"], len(working))
        self.assertTrue(set(lost["dates"]) <= {str(day) for day in working})

    def test_verify_draws_the_weather_again(self):
        self.run_plan(self.PLAN, options=("--sample", "4"))

        def dry(result):
            record = next(each for each in result.records if each["type"] == "lost_days")
            record["days"] = record["days"][1:]
            result.schedule["lost_days"][0]["dates"] = record["days"]
            result.schedule["lost_days"][0]["lost"] -= 1

        self.assertRegex(self.faults_of(dry), r"calendar site lost \d+ of \d+ days, by the weather \d+ of \d+")

        def another(result):
            result.header["sample"]["run"] = 1

        self.assertIn("shifts for it", self.faults_of(another))

        def untold(result):
            result.records = [each for each in result.records if each["type"] != "lost_days"]

        self.assertIn("it does not tell what calendar site lost", self.faults_of(untold))

    def test_all_variants_and_all_tasks_have_the_same_weather(self):
        first, _ = self.run_plan(self.PLAN, options=("--sample", "2:9"))
        second, _ = self.run_plan(self.PLAN, options=("--sample", "2:9", "--set", "more=3"))
        more, _ = self.run_plan(self.PLAN, options=("--sample", "2:9", "--set", "share=0.3"))
        until = self.days(first)["dates"][-1]
        self.assertEqual(self.days(first)["dates"], [day for day in self.days(second)["dates"] if day <= until])
        self.assertLess(set(self.days(first)["dates"]), set(self.days(more)["dates"]))
        self.assertLess(set(self.days(first)["dates"]), set(self.days(first, "crane_days")["dates"]) | {until})
        other, _ = self.run_plan(self.PLAN, options=("--sample", "2:8"))
        self.assertNotEqual(self.days(first)["dates"], self.days(other)["dates"])

    def test_the_wait_for_the_weather_has_its_mean(self):
        # Work of n days: the days that are lost before the last of them are negative binomial, mean n p / (1 - p).
        plan = """plan p { start_at "2026-03-02 00:00"; calendar all { mon-sun 00:00-24:00; lost 0.2; } crew gang { calendar all; } task t { by gang; takes 960 h; } }"""
        mean = self.variants("runs 400; ask makespan;", plan)[0]["makespan"]["mean"]
        deviation = (40 * 0.2) ** 0.5 / 0.8
        self.assertLess(abs(mean / 86400 - 40 / 0.8), 4 * deviation / 20)

    def test_lifts_are_whole_and_months_differ(self):
        text = """plan p { support off; start_at "2026-10-30 07:00"; calendar site { mon-sun 07:00-12:00; lost 0; lost nov-jan 0.5; }
          robot h "hoist.robot" { calendar site; } %s
          for i from 1 to 40 { task go[i] { by h; go z 1 + 3 * mod(i, 2); takes 4 h; when (i > 1) { after go[i - 1]; } } }
          task lift { by h; move c to trans(0, 0, 4); hook 2 h; release 2 h; after go[40]; } }""" % BLOCK
        schedule, tasks = self.run_plan(text, options=("--sample", "5"))
        self.assertEqual(tasks["lift"]["result"], "done")
        lost = schedule["lost_days"][0]["dates"]
        self.assertGreater(len(lost), 15)
        self.assertTrue(all(day >= "2026-11-01" for day in lost))

    def test_what_is_wrong_is_said(self):
        plan = "plan p { calendar c { mon-fri 07:00-16:00; %s } crew g { calendar c; } task t { by g; takes 1 h; } }"
        for clause, message in (("lost 1;", "0.95"), ("lost -0.1;", "the share of lost days cannot be negative, found -0.1"), ("lost 0.1; lost 0.2;", "the share of lost days is given twice"), ("lost nov-feb 0.1; lost dec 0.2;", "the share of lost days of a month is given twice"),
                                ("lost 3 h;", "needs"), ("lost;", "expected the share of days that are lost, such as 0.1"), ("lost nov-fri 0.1;", "expected a month such as feb")):
            self.assertIn(message, self.mistake(plan % clause), clause)
        self.write("p.plan", plan % "lost   nov-feb 0.2;lost   dec -dec 0.1;")
        self.assertEqual(rubicon("fmt", os.path.join(self.folder, "p.plan")).returncode, 0)
        with open(os.path.join(self.folder, "p.plan"), encoding="utf-8") as file:
            self.assertIn("lost nov-feb 0.2; lost dec-dec 0.1;", re.sub(r"\s+", " ", file.read()))


class Breakdowns(Chance):
    def test_known_breakdowns(self):
        # 4 m in steps of 1 m at 0.5 m/s; good for 100 s of work, a repair takes 10 min.
        text = """plan p { support off; robot h "hoist.robot" { fuel 36 l per h idling 18 l per h; breakdown every 100 s takes 10 min; } %s
          task lift { by h; move c to trans(0, 0, 11); hook 2 min; release 1 min; }
          task drill { by h; go z 31; takes 4 min; after lift; } }""" % BLOCK
        _, tasks = self.run_plan(text)
        self.assertIn("no machine breaks down; --sample SEED draws when they do\n", self.run_result.stdout)
        self.assertEqual((tasks["lift"]["duration"], tasks["drill"]["duration"]), (8 + 120 + 22 + 60, 38 + 240))
        schedule, tasks = self.run_plan(text, options=("--sample", "1"))
        # The load is set down first; the machine stands until it is repaired, then it is good for another 100 s of the 278 s.
        self.assertEqual([(each["during"], each["worked"], each["from"], each["to"]) for each in schedule["breakdowns"]],
                         [("lift", 210, 210, 810), ("drill", 100, 910, 1510), ("drill", 100, 1610, 2210)])
        self.assertEqual(tasks["lift"]["duration"], 210)
        self.assertEqual((tasks["drill"]["start"], tasks["drill"]["waited"]["resource"], tasks["drill"]["waited"]["repair"]), (810, 600, 1200))
        self.assertEqual(tasks["drill"]["duration"], 278 + 1200)
        # Under repair its engine is off.
        self.assertEqual([tasks["lift"]["fuel"], tasks["drill"]["fuel"], schedule["fuel"]], [2.1, 2.78, 4.88])
        self.assertIn("h       lift", self.run_result.stdout)

        def earlier(result):
            next(each for each in result.records if each["type"] == "breakdown")["until"] = 800

        self.assertIn("h: its repair takes 0:10:00 and there are 0:09:50 of its hours for it", self.faults_of(earlier))

        def sooner(result):
            record = [each for each in result.records if each["type"] == "breakdown"][1]
            record["every"], record["worked"] = 90, 90

        found = self.faults_of(sooner)
        self.assertIn("h: it is good for 0:01:30 of work, which sequence does not allow", found)
        self.assertIn("h: its work is not interrupted where it breaks down", found)

        def never(result):
            result.records = [each for each in result.records if each["type"] != "breakdown"]
            result.schedule["breakdowns"] = []

        self.assertIn("its machine is repaired, and did not break down", self.faults_of(never))

        def at_work(result):
            record = [each for each in result.records if each["type"] == "breakdown"][1]
            record["t"], record["until"], record["worked"] = 900, 1500, 90

        self.assertRegex(self.faults_of(at_work), r"h: it works at 0:14:08, and is under repair until 0:25:00")

    def test_a_motion_stops_between_two_steps(self):
        text = 'plan p { robot h "hoist.robot" { breakdown every 61 s takes uniform(1 h, 2 h); } task go { by h; go z 39; } task back { by h; go z 5; after go; } }'
        schedule, tasks = self.run_plan(text, options=("--sample", "7"))
        self.assertEqual([each["worked"] for each in schedule["breakdowns"]], [62, 62])
        self.assertEqual(schedule["breakdowns"][0]["from"], 62)
        self.assertEqual(tasks["go"]["motion"], 68)
        # One that gains and loses its speed comes to rest first.
        self.write("slow.robot", HOIST.replace("start(5)", "accel(0.1 m/s2) start(5)"))
        slow, _ = self.run_plan(text.replace("hoist.robot", "slow.robot"), options=("--sample", "7"))
        self.assertEqual([each["during"] for each in slow["breakdowns"]], ["go", "back"])
        self.assertTrue(all(61 < each["worked"] < 70 for each in slow["breakdowns"]))
        # What breaks down in a task that is undone has not broken down: it comes in the next as it would have.
        undone = text.replace("task back", 'task never { by h; go z 38; takes 1 min; remove c; after go; priority 9; } component c { shape box(9, 0, 0, 10, 1, 1); at trans(0, 0, 0); } task gone { remove c; } task back')
        again, tasks = self.run_plan(undone, expected=1, options=("--sample", "7"))
        self.assertEqual(tasks["never"]["result"], "rejected")
        self.assertEqual(again["breakdowns"], schedule["breakdowns"])

    def test_availability(self):
        # MTBF / (MTBF + MTTR) = 0.8; the repairs of 2000 h of work have the mean 500 h and the deviation 50 h.
        text = """plan p { robot h "hoist.robot" { breakdown every exponential(10 h) takes exponential(2.5 h); }
          for i from 1 to 20 { task t[i] { by h; takes 100 h; when (i > 1) { after t[i - 1]; } } } }"""
        answers = self.variants("runs 200; ask makespan, waiting(repair);", text)[0]
        self.assertLess(abs(answers["makespan"]["mean"] / 3600 - 2500), 4 * 50 / 200**0.5)
        self.run_plan(text, options=("--sample", "3"))

    def test_repairs_are_made_in_the_hours_of_the_machine(self):
        text = """plan p { start_at "2026-03-02 07:00"; calendar day { mon-fri 07:00-12:00; } robot h "hoist.robot" { calendar day; breakdown every 4 h takes 3 h; }
          task t { by h; takes 6 h; } }"""
        schedule, tasks = self.run_plan(text, options=("--sample", "3"))
        self.assertEqual([(each["from"], each["to"], each["repair"]) for each in schedule["breakdowns"]], [(14400, 86400 + 7200, 10800)])
        self.assertEqual(tasks["t"]["duration"], 86400 + 4 * 3600)
        self.assertEqual(tasks["t"]["waited"]["repair"], 86400 + 7200 - 14400)

    def test_a_repair_between_two_tasks_is_no_float(self):
        # h works 3 h, is repaired for 2 h, mornings only, and works 1 h; others make the plan 52 h long: until Wednesday 11:00.
        text = """plan p { parameter later = 0; start_at "2026-03-02 07:00"; calendar day { mon-fri 07:00-12:00; } crew c;
          robot h "hoist.robot" { calendar day; breakdown every 3 h takes 2 h; }
          task a { by h; takes 3 h; not_before later * 1 h; } task b { by h; takes 1 h; after a; } task others { by c; takes 52 h; } }"""
        for later, (start, total, end) in {"0": (0, 8, 52), "24": (24, 3, 52), "49": (49, 0, 74)}.items():
            schedule, tasks = self.run_plan(text, options=("--sample", "1", "--set", "later=" + later))
            self.assertEqual((tasks["a"]["start"], tasks["a"]["float"]["total"], schedule["process_time"]), (start * 3600, total * 3600, end * 3600))
        self.assertEqual([step["text"] for step in schedule["critical"]][1:], ["b starts when 'h' is repaired, which a had"])
        self.run_plan(text, options=("--sample", "1"))

        def at_the_end(result):
            task = next(each for each in result.schedule["tasks"] if each["task"] == "a")
            task["float"].update(total=9 * 3600, latest_start=24 * 3600 + 4 * 3600, latest_finish=48 * 3600 + 2 * 3600)

        self.assertIn("at its latest h is not repaired when b needs it", self.faults_of(at_the_end))

    def test_others_wait_or_take_another(self):
        pool = """plan p { support off; robot a "hoist.robot" { breakdown every 100 s takes 10 h; } robot b "hoist.robot" at trans(20, 0, 0); pool ab { of a, b; choose first; }
          %s task one { by ab; move c to trans(0, 0, 4); hook 2 min; release 1 min; } task two { by ab; go z 9; after one; } task three { by a; go z 8; after one; } }""" % BLOCK
        schedule, tasks = self.run_plan(pool, options=("--sample", "1"))
        self.assertEqual([tasks["one"]["robot"], tasks["two"]["robot"]], ["a", "b"])
        self.assertEqual(tasks["two"]["start"], tasks["one"]["duration"])
        self.assertEqual(tasks["three"]["start"], tasks["one"]["duration"] + 36000)

    def test_a_machine_that_stands_in_the_way_goes_when_it_is_repaired(self):
        self.write("car.robot", """robot car { body car { param x range(-20, 20) step(1) speed(1 m/s) start(0); frame trans(x, 0, 0); shape box(-1, -1, 0, 1, 1, 2); }
          tool car; behaviour { chain { move_to(x, goal(x)) } } }""")
        text = """plan p { robot left "car.robot" { start x -10; } robot right "car.robot" { start x 10; park x 20; breakdown every 70 s takes 1 h; }
          task dig { by right; go x 0; takes 1 min; } task through { by left; go x 3; after dig; } }"""
        schedule, tasks = self.run_plan(text, options=("--sample", "1"))
        self.assertEqual(tasks["through"]["result"], "done")
        self.assertEqual([(each["during"], each["from"]) for each in schedule["breakdowns"]], [("dig", 70)])
        self.assertGreater(tasks["through"]["waited"]["machine"], 3500)

    def test_what_is_wrong_is_said(self):
        plan = 'plan p { robot h "hoist.robot" { %s } task t { by h; go z 3; } }'
        for clause, message in (("breakdown every 10 s takes 1 h;", "robot 'h' breaks down every 10 s of work on average; expected a minute or more"),
                                ("breakdown every exponential(0 h) takes 1 h;", "the mean is 0"), ("breakdown 4 h takes 1 h;", "expected every and the hours of work between two breakdowns"),
                                ("breakdown every 4 h;", "expected takes and how long a repair takes"), ("breakdown every 4 h takes 1 h; breakdown every 4 h takes 1 h;", "is given twice"),
                                ("breakdwn every 4 h takes 1 h;", "breakdown")):
            self.assertIn(message, self.mistake(plan % clause), clause)


if __name__ == "__main__":
    unittest.main()
